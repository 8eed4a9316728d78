// The card of the arena and the kinds, and the seed, in the real window.
#include "tests/window/lab_window.h"

namespace braitenlab::tests::values_window_test {
namespace {

bool wait_for(const std::function<bool()>& holds) { return LabWindow::eventually(holds, 8); }

TEST(ValuesWindow, RestartsWithAnotherSeedAndChangesAKindWithUndo) {
    LabWindow lab({"predator-prey", "--size", "1280x1000"});
    ASSERT_EQ(lab.state()["seed"], 1);
    lab.click("button.another_start");
    EXPECT_TRUE(wait_for([&] { return lab.state()["seed"] == 2; }));
    lab.key("shift+r");
    EXPECT_TRUE(wait_for([&] { return lab.state()["seed"] == 3; }));
    const Json hash = lab.state()["hash"];
    const int population = lab.state()["population"];
    lab.key("d");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("arena.width"); }));
    lab.click("values.part.2");
    ASSERT_TRUE(wait_for([&] { return lab.anchors().contains("kind.count"); }));
    lab.click("kind.driver.5");
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 1; }));
    lab.click("kind.add");
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 2; }));
    for (int i = 0; i < 2; ++i) lab.key("ctrl+z");
    EXPECT_TRUE(wait_for([&] { return lab.state()["undo_depth"] == 0; }));
    EXPECT_EQ(lab.state()["hash"], hash);
    EXPECT_EQ(lab.state()["population"], population);
    EXPECT_EQ(lab.state()["graphics_errors"], 0);
}

}  // namespace
}  // namespace braitenlab::tests::values_window_test
