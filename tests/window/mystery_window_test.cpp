// A brain is hidden, another one is built in the same body, and both are compared.
#include "lab_window.h"

namespace braitenlab::tests::mystery_window_test {

TEST(MysteryWindow, ABrainIsHiddenAndAnEmptyOneInTheSameBodyScoresLess) {
    LabWindow lab({"2b-aggressor"});
    lab.choose("simulation", "mystery");
    lab.click("mystery.hide");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["mystery"]["hidden"] == true; }));
    EXPECT_TRUE(lab.eventually([&] { return !lab.anchors().contains("slider.LL"); })) << "no sliders tell the brain";
    lab.click("mystery.rebuild");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["population"] == 2; }));
    EXPECT_TRUE(lab.eventually([&] { return lab.anchors().contains("slider.LL"); })) << "those of the empty brain";
    lab.choose("simulation", "mystery");
    lab.click("mystery.compare");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["mystery"]["score"].is_number(); }, 30));
    EXPECT_LT(lab.state()["mystery"]["score"].get<int>(), 100);
    EXPECT_TRUE(lab.eventually([&] { return lab.anchors().contains("mystery.start.10"); }));
}

TEST(MysteryWindow, TheRunBeforeTheResetComesBackAndUndoGoesToTheNewerOne) {
    LabWindow lab({"2b-aggressor", "--play"});
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["tick"].get<int>() > 60; }));
    lab.key("r");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["tick"] == 0; }));
    lab.key("shift+l");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["tick"].get<int>() > 60; }));
    EXPECT_GT(lab.state()["latest"].get<int>(), 60);
    EXPECT_EQ(lab.state()["mode"], "paused");
    lab.key("ctrl+z");
    EXPECT_TRUE(lab.eventually([&] { return lab.state()["tick"] == 0; }));
}

}  // namespace braitenlab::tests::mystery_window_test
