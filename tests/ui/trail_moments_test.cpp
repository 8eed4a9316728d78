// Moments of the selected vehicle's path, picked on its trail.
#include "ui/scene_input/trail_moments.h"

#include "scene_on_desk.h"

namespace braitenlab::tests::trail_moments_test {

using namespace ui;
namespace {

// The first vehicle came from the north in 2 s: at tick t it was 6 m − t · 5 cm north of its place.
struct TrailMoments : SceneOnDesk {
    std::vector<Pose> path;
    TrailMoments() {
        const VehicleView& vehicle = desk.now.vehicles[0];
        for (int i = 0; i <= 120; ++i) path.push_back({vehicle.x, vehicle.y + 6 - 0.05f * static_cast<float>(i)});
        desk.now.tick = 120;
        desk.view.settings.selection.vehicle = vehicle.id;
        desk.view.features.path = &path;
    }
    maths::vec2 at(std::size_t tick) const { return {path[tick].x, path[tick].y}; }
};

TEST_F(TrailMoments, AClickOnTheTrailAsksForTheCauseAtThatMoment) {
    click(at(30));
    ASSERT_EQ(requests<WhyRequest>().size(), 1u);
    EXPECT_NEAR(static_cast<double>(requests<WhyRequest>()[0].tick), 30, 6);
    EXPECT_TRUE(requests<SelectRequest>().empty()) << "the vehicle stays selected";
    EXPECT_TRUE(requests<TakeRequest>().empty());
}

TEST_F(TrailMoments, ThePointerOverTheTrailShowsTheTimeAndAHand) {
    point(at(30));
    EXPECT_EQ(ImGui::GetMouseCursor(), ImGuiMouseCursor_Hand);
    EXPECT_TRUE(desk.says("0.5 s: why?"));
    rest_pointer();
    EXPECT_NE(ImGui::GetMouseCursor(), ImGuiMouseCursor_Hand);
    EXPECT_FALSE(desk.says("why?"));
}

TEST_F(TrailMoments, ALectureShowsNoNoteAtThePointer) {
    desk.view.lecture = true;
    point(at(30));
    EXPECT_FALSE(desk.says("why?"));
    click(at(30));
    EXPECT_EQ(requests<WhyRequest>().size(), 1u) << "a click still asks";
}

TEST_F(TrailMoments, ADragThatBeginsOnTheTrailMovesTheCamera) {
    hold(at(30), at(30) + maths::vec2{3, 0});
    EXPECT_EQ(scene_input().drag.phase, SceneInputPhase::orbit);
    release();
    EXPECT_TRUE(requests<WhyRequest>().empty());
}

TEST_F(TrailMoments, OnlyTheShownPartOfTheTrailIsAsked) {
    desk.now.tick = 20;  // the rest is later than the displayed moment
    click(at(60));
    EXPECT_TRUE(requests<WhyRequest>().empty());
    desk.now.tick = 120;
    desk.view.settings.overlays.trails = false;
    click(at(30));
    EXPECT_TRUE(requests<WhyRequest>().empty()) << "no trails are shown";
    desk.view.settings.overlays.trails = true;
    desk.view.settings.revealed.brain = false;
    click(at(30));
    EXPECT_TRUE(requests<WhyRequest>().empty()) << "the brain is hidden";
    desk.view.settings.revealed.brain = true;
    click(at(30));
    EXPECT_EQ(requests<WhyRequest>().size(), 1u);
}

TEST_F(TrailMoments, TheVehicleItselfIsTakenNotItsTrail) {
    point(at(120));
    EXPECT_EQ(scene_input().hovered.object, vehicle_object(0));
    EXPECT_FALSE(scene_input().trail_moment);
}

}  // namespace
}  // namespace braitenlab::tests::trail_moments_test
