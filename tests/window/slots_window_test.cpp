// Slots A and B in the window: stored by a key, compared from the same start, put by a click, undone.
#include "lab_window.h"

namespace braitenlab::tests::slots_window_test {

TEST(SlotsWindow, TwoBrainsRunFromTheSameStartWithTheirNumbersBesideEachOther) {
    LabWindow lab({"2b-aggressor"});
    lab.key("q");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["slots"]["a"].is_object(); }));
    lab.click("button.cross");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["character"] == "coward"; }));
    lab.key("q");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["slots"]["b"].is_object(); }));
    EXPECT_EQ(lab.state()["slots"]["a"]["character"], "aggressor");
    EXPECT_EQ(lab.state()["slots"]["b"]["character"], "coward");
    lab.click("button.compare");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["slots"]["b"].contains("numbers"); }));
    EXPECT_EQ(lab.state()["mode"], "playing");
    EXPECT_EQ(lab.state()["character"], "aggressor") << "the vehicle drives as A";
    EXPECT_TRUE(lab.eventually([&] { return lab.anchors().contains("stage.slot_b"); })) << "B is beside it";
    const auto number = [&](const char* slot) {
        return lab.state()["slots"][slot]["numbers"]["closest"].get<double>();
    };
    EXPECT_LT(number("a"), number("b"));
    lab.click("slot.b");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["slots"]["b"]["in_vehicle"] == true; }));
    lab.key("ctrl+z");
    EXPECT_TRUE(lab.eventually([&] { return lab.state()["slots"]["a"]["in_vehicle"] == true; }));
}

}  // namespace braitenlab::tests::slots_window_test
