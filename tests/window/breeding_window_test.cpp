// Predators and prey are bred in the window, a match is watched, and its champions are taken into a scene.
#include "lab_window.h"

namespace braitenlab::tests::breeding_window_test {

TEST(BreedingWindow, BreedsWatchesAMatchAndTakesItsChampions) {
    LabWindow lab({"2a-coward"});
    lab.choose("simulation", "breeding");
    ASSERT_TRUE(lab.eventually([&] { return lab.anchors().contains("breeding.open.flee"); }));
    lab.click("breeding.open.flee");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["breeding"]["generation"] == -1; }));
    lab.click("breeding.start");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["breeding"]["generation"].get<int>() >= 1; }, 60));
    EXPECT_EQ(lab.state()["breeding"]["running"], true);
    EXPECT_FALSE(lab.state()["breeding"]["cell"].is_null()) << "champions drive while it runs";
    lab.click("breeding.stop");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["breeding"]["running"] == false; }));
    lab.click("breeding.cell.1.0");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["breeding"]["cell"] == nlohmann::json{1, 0}; }));
    EXPECT_TRUE(lab.eventually([&] { return lab.anchors().contains("breeding.duel.1"); }));
    lab.click("breeding.take");
    ASSERT_TRUE(lab.eventually([&] { return lab.state()["prey"] == 1; })) << "the scene had no prey: the match opens";
    EXPECT_EQ(lab.state()["predators"], 1);
    EXPECT_FALSE(lab.anchors().contains("breeding.take"));
}

}  // namespace braitenlab::tests::breeding_window_test
