#include "render/view/trails.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <gtest/gtest.h>

#include "render/view/draw_list.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::trails_test {
namespace {

using namespace render;

Snapshot one_vehicle() {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    return now;
}

void drive(Snapshot& now, Trails& trails, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        ++now.tick;
        now.vehicles[0].x += 0.02f;
        trails.record(now);
    }
}

TEST(Trails, KeepTheWholePathOfARunAtAConstantWidth) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 60);
    const std::size_t after_a_second = trails.of(0)->count();
    EXPECT_GE(after_a_second, 9U);
    drive(now, trails, 2000);
    EXPECT_GT(trails.of(0)->count(), 30 * after_a_second);
    EXPECT_LT(trails.of(0)->at(trails.of(0)->count() - 1).x, 0.1f) << "the start of the run";
    DrawList list;
    fill(list, now, {}, trails);
    float first = 1e9f;
    for (const TrailInstance& piece : list.trails) {
        first = std::min(first, piece.ends.z);
        EXPECT_EQ(piece.colour.w, list.trails[0].colour.w);
        EXPECT_GT(piece.opacity.y, 0.1f);
    }
    EXPECT_LT(first, 0.1f) << "is drawn";
    EXPECT_NEAR(trails.of(0)->at(0).x, now.vehicles[0].x, 0.13f);
    EXPECT_GT(trails.of(0)->at(0).x, trails.of(0)->at(1).x);
}

TEST(Trails, AreDarkerThanTheBodyInTheLightThemeOnly) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 60);
    for (const Theme theme : {Theme::dark, Theme::light}) {
        Picture picture;
        picture.theme = theme;
        DrawList list;
        fill(list, now, picture, trails);
        ASSERT_FALSE(list.trails.empty());
        const float share = theme == Theme::light ? 0.8f : 1.0f;
        EXPECT_NEAR(list.trails[0].colour.x, share * palette(theme).neutral.r, 1e-5f) << word(theme);
    }
}

TEST(Trails, EndAtTheVehicleAfterARewindAndContinueFromThere) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 1200);
    const Snapshot later = now;
    now.tick = 600, now.vehicles[0].x = 12;
    trails.record(now);
    EXPECT_GT(trails.of(0)->count(), 40U) << "ten seconds back there is also an earlier path";
    EXPECT_NEAR(trails.of(0)->at(0).x, 12, 0.13f);
    EXPECT_LT(trails.of(0)->at(1).x, trails.of(0)->at(0).x);
    trails.record(later);
    EXPECT_NEAR(trails.of(0)->at(0).x, later.vehicles[0].x, 0.13f) << "later points are kept";
    now.tick = 0, now.vehicles[0].x = 0;
    trails.record(now);
    EXPECT_LE(trails.of(0)->count(), 1U);
}

TEST(Trails, AreBoundedForManyVehicles) {
    const auto pieces = [](int vehicles) {
        Snapshot now = hand_made::empty(hand_made::scene());
        for (int i = 0; i < vehicles; ++i) hand_made::add(now, 0, 0, 0, 0);
        Trails trails;
        for (int i = 0; i < 1800; ++i) {
            ++now.tick;
            for (VehicleView& v : now.vehicles) v.x += 0.02f;
            trails.record(now);
        }
        DrawList list;
        fill(list, now, {}, trails);
        return list.trails.size();
    };
    EXPECT_GT(pieces(1), 150U);
    EXPECT_LE(pieces(40), 3200U);
    EXPECT_LE(pieces(200), 3200U);
}

TEST(Trails, OfFewVehiclesAreAllShownHoweverSmallTheseAre) {
    const auto shown = [](int vehicles) {
        Snapshot now = hand_made::empty(hand_made::scene());
        for (int i = 0; i < vehicles; ++i) hand_made::add(now, 0, 0, 0, 0);
        Trails trails;
        drive(now, trails, 600);
        Camera camera;
        camera.zoom = 0.3f;
        const Rect window{0, 0, 160, 100};
        Picture tiny;
        tiny.camera_view = look(camera, Arena{}, nullptr, window, window);
        DrawList list;
        fill(list, now, tiny, trails);
        return !list.trails.empty();
    };
    EXPECT_TRUE(shown(24));
    EXPECT_FALSE(shown(200));
}

TEST(Trails, DropLaterPointsWhenThePathChanges) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 600);
    now.tick = 300, now.vehicles[0].x = 6;
    trails.record(now);
    for (int i = 0; i < 60; ++i) {
        ++now.tick;
        now.vehicles[0].y += 0.02f;
        trails.record(now);
    }
    EXPECT_NEAR(trails.of(0)->at(0).y, now.vehicles[0].y, 0.13f);
    Snapshot ahead = now;
    ahead.tick = 600;
    trails.record(ahead);
    for (std::size_t i = 0; i < trails.of(0)->count(); ++i) EXPECT_LT(trails.of(0)->at(i).x, 6.2f);
}

TEST(Trails, DoNotGrowWhileAVehicleIsAtRest) {
    Snapshot now = one_vehicle();
    Trails trails;
    for (int i = 0; i < 600; ++i) {
        ++now.tick;
        trails.record(now);
    }
    EXPECT_EQ(trails.of(0)->count(), 1U);
}

TEST(Trails, BreakAtAJump) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 60);
    now.vehicles[0].x += 8;
    drive(now, trails, 7);
    EXPECT_LE(trails.of(0)->count(), 2U);
}

// A vehicle of another brain leaves the recorded path slowly at first.
TEST(Trails, FollowTheVehicleOfAnotherBrainAfterAReset) {
    Snapshot now = one_vehicle();
    Trails trails;
    const auto curve = [&](float rate) {
        now.tick = 0, now.vehicles[0].x = 0, now.vehicles[0].y = 0;
        trails.record(now);
        for (int i = 1; i <= 240; ++i) {
            now.tick = static_cast<std::uint64_t>(i);
            const float angle = rate * static_cast<float>(i);
            now.vehicles[0].x = 2 * std::sin(angle), now.vehicles[0].y = 2 * (1 - std::cos(angle));
            trails.record(now);
        }
    };
    curve(0.006f);
    curve(0.004f);
    const Trail& trail = *trails.of(0);
    for (std::size_t i = 0; i < trail.count(); ++i) {
        const float angle = 0.004f * 240 * (1 - static_cast<float>(i) / static_cast<float>(trail.count() - 1));
        EXPECT_NEAR(std::hypot(trail.at(i).x, trail.at(i).y - 2), 2, 0.03f);
        EXPECT_NEAR(std::atan2(trail.at(i).x, 2 - trail.at(i).y), angle, 0.06f) << "point " << i;
    }
}

TEST(Trails, KeepThePathOfARunThatIsRepeated) {
    Snapshot now = one_vehicle();
    Trails trails;
    const auto place = [&](int tick) {
        now.tick = static_cast<std::uint64_t>(tick);
        const float angle = 0.25f * static_cast<float>(tick);  // fast, on a small circle
        now.vehicles[0].x = 0.2f * std::cos(angle), now.vehicles[0].y = 0.2f * std::sin(angle);
        trails.record(now);
    };
    for (int tick = 1; tick <= 300; ++tick) place(tick);
    const std::size_t recorded = trails.of(0)->count();
    for (int tick = 1; tick <= 100; ++tick) place(tick);
    place(300);
    EXPECT_EQ(trails.of(0)->count(), recorded);
}

TEST(Trails, StartWhereTheVehicleIsPlacedBeforeARun) {
    Snapshot now = one_vehicle();
    Trails trails;
    trails.record(now);
    for (int i = 0; i < 10; ++i) {
        now.vehicles[0].y += 0.1f;  // dragged while the run rests
        trails.record(now);
    }
    const float start = now.vehicles[0].y;
    drive(now, trails, 60);
    for (std::size_t i = 0; i < trails.of(0)->count(); ++i) EXPECT_EQ(trails.of(0)->at(i).y, start);
}

TEST(Trails, HaveAGapWhereAVehicleIsMovedByHand) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 60);
    for (int i = 0; i < 60; ++i) ++now.tick, trails.record(now);  // at rest
    const std::size_t before = trails.of(0)->count();
    for (int i = 0; i < 5; ++i) now.vehicles[0].y += 0.2f, trails.record(now);
    EXPECT_EQ(trails.of(0)->count(), before + 1) << "the path before stays";
    EXPECT_FALSE(trails.of(0)->is_joined(0));
    drive(now, trails, 60);
    DrawList list;
    fill(list, now, {}, trails);
    EXPECT_GT(list.trails.size(), before);
    for (const TrailInstance& piece : list.trails) EXPECT_EQ(piece.ends.y, piece.ends.w) << "no line across the gap";
}

TEST(Trails, HaveRoundEndsAtTheStartAndAtGapsButNotAtTheVehicle) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 60);
    DrawList list;
    const auto round_ends = [&] {
        std::vector<TrailInstance> all;
        fill(list, now, {}, trails);
        std::copy_if(list.trails.begin(), list.trails.end(), std::back_inserter(all),
                     [](const TrailInstance& piece) { return piece.opacity.z == 1; });
        return all;
    };
    ASSERT_EQ(round_ends().size(), 1u);
    EXPECT_NEAR(round_ends()[0].ends.x, 0, 0.13f);
    EXPECT_LT(round_ends()[0].sides.y, -0.99f) << "its right is the direction back";

    for (int i = 0; i < 5; ++i) now.vehicles[0].y += 0.2f, trails.record(now);  // moved by hand: a gap
    drive(now, trails, 60);
    ASSERT_EQ(round_ends().size(), 3u);
    const TrailInstance after_gap = round_ends()[0], before_gap = round_ends()[1];
    EXPECT_EQ(after_gap.ends.y, now.vehicles[0].y);
    EXPECT_LT(before_gap.ends.y, now.vehicles[0].y - 0.5f);
    EXPECT_LT(after_gap.sides.y, -0.99f);
    EXPECT_GT(before_gap.sides.y, 0.99f) << "turned towards the gap";

    for (int i = 0; i < 70; ++i) hand_made::add(now, 0, 0, 0, 0);
    EXPECT_EQ(round_ends().size(), 2u) << "a trail among many vehicles fades out at its start";
}

TEST(Trails, HaveTheColourOfTheirVehicle) {
    Snapshot now = one_vehicle();
    Scene scene = *now.scene;
    scene.kinds[0].colour = "#ff0000";
    now.scene = std::make_shared<Scene>(scene);
    Trails trails;
    drive(now, trails, 60);
    DrawList list;
    fill(list, now, {}, trails);
    ASSERT_FALSE(list.trails.empty());
    EXPECT_GT(list.trails[0].colour.x, 0.9f);
    EXPECT_LT(list.trails[0].colour.z, 0.2f);
}

TEST(Trails, ContinueOverTheEdgeOfATorus) {
    auto scene = hand_made::scene();
    scene->arena.edge = Boundary::torus;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 9.5f, 0, 0);
    Trails trails;
    drive(now, trails, 30);
    const std::size_t before = trails.of(0)->count();
    now.vehicles[0].x -= 20;
    drive(now, trails, 30);
    EXPECT_GT(trails.of(0)->count(), before);
    DrawList list;
    fill(list, now, {}, trails);
    EXPECT_GT(list.trails.size(), 4U);
    for (const TrailInstance& piece : list.trails) EXPECT_LT(std::fabs(piece.ends.x - piece.ends.z), 1);
}

TEST(Trails, AreKeptThroughAnEditOfTheScene) {
    Snapshot now = one_vehicle();
    Trails trails;
    drive(now, trails, 60);
    const std::size_t before = trails.of(0)->count();
    now.scene = std::make_shared<Scene>(*now.scene);
    drive(now, trails, 1);
    EXPECT_GE(trails.of(0)->count(), before);
}

TEST(Trails, DropRemovedVehicles) {
    Snapshot now = one_vehicle();
    hand_made::add(now, 0, 5, 5, 0);
    Trails trails;
    drive(now, trails, 10);
    ASSERT_NE(trails.of(1), nullptr);
    now.vehicles.pop_back();
    drive(now, trails, 1);
    EXPECT_EQ(trails.of(1), nullptr);
}

}  // namespace
}  // namespace braitenlab::tests::trails_test
