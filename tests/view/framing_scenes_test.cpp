// How large the framed action of each shipped scene and exercise is, at its start and in a run, and what of it is in
// the picture.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "render/view/framing.h"
#include "render/view/label_space.h"

namespace braitenlab::tests::framing_scenes_test {
namespace {

namespace fs = std::filesystem;
using maths::vec2;

// The part of a window that cards and bars leave free, and the share of its width that the selected vehicle should
// have.
struct Place {
    const char* name;
    Rect window, free_area;
    float least_share;
    bool all_sources = false;  // must be in the picture
};
constexpr Place two_cards{"two open cards", {0, 0, 1280, 800}, {336, 84, 576, 610}, 0.05f};
constexpr Place lectures[]{{"a lecture", {0, 0, 1280, 800}, {16, 95, 1248, 499}, 0.08f},
                           {"a small lecture", {0, 0, 1024, 768}, {16, 95, 992, 467}, 0.08f},
                           {"a question of a lecture", {0, 0, 1280, 800}, {592, 156, 672, 628}, 0.08f}};
// Between the caption of a page and the values below it.
constexpr Place page_with_values{"a page with values", {0, 0, 1280, 800}, {17, 213, 1246, 380}, 0.08f, true};

// In a run the picture rests while the vehicles are in it, also where one drives away from the camera, and then shows
// what they have driven: of the wanted length and of the free area.
constexpr float enough_in_run = 0.65f, enough_cover_in_run = 0.5f;

// The shares of the free area's width and height that the box takes.
vec2 shares_of(const FloorBox& box, const CameraView& seen, Rect area) {
    vec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    for (const vec2 corner : {box.low, box.high, vec2{box.low.x, box.high.y}, vec2{box.high.x, box.low.y}}) {
        const vec2 at = *project(seen, corner);
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    return {(high.x - low.x) / area.w, (high.y - low.y) / area.h};
}

FramingInput input(const Place& place, VehicleId selected) {
    FramingInput in;
    in.selected = selected, in.window = place.window, in.free_area = place.free_area;
    in.least_share = place.least_share;
    return in;
}

void expect_framed(const Scene& scene, const std::string& name, const Place& place, float cover, float share) {
    SCOPED_TRACE(std::string(place.name) + ", " + name);
    const auto world = World::create(scene, 1);
    ASSERT_TRUE(world);
    Snapshot now;
    world->capture(now);
    ASSERT_FALSE(now.vehicles.empty());
    const VehicleView& vehicle = now.vehicles.front();
    const FramingInput in = input(place, vehicle.id);
    Framing framing;
    const FloorBox box = framing.follow(now, in);
    const CameraView seen = look(framing.raised(in.camera), now.scene->arena, nullptr, in.window, in.free_area, &box);
    const vec2 shares = shares_of(box, seen, place.free_area);
    EXPECT_GE(std::max(shares.x, shares.y), 0.87f) << "room is wasted in width and in height";
    EXPECT_GE(floor_cover(seen, now.scene->arena, in.free_area), cover);
    const auto in_picture = [&](float x, float y, float height) {
        const auto at = project(seen, {x, y}, height);
        return at && place.free_area.contains(at->x, at->y);
    };
    for (const VehicleView& each : now.vehicles) EXPECT_TRUE(in_picture(each.x, each.y, 0)) << each.id;
    // What makes the vehicle turn: all sources, or the nearest one where the vehicle would be smaller with all of them.
    const auto distance = [&](const SourceView& s) { return std::hypot(s.x - vehicle.x, s.y - vehicle.y); };
    const auto nearest = std::min_element(now.sources.begin(), now.sources.end(),
                                          [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    const auto seen_source = [&](const SourceView& s) { return in_picture(s.x, s.y, 0.4f); };
    const bool all_seen = std::all_of(now.sources.begin(), now.sources.end(), seen_source);
    if (!now.sources.empty()) {
        EXPECT_TRUE(seen_source(*nearest));
    }
    EXPECT_TRUE(all_seen || !place.all_sources);
    if (now.vehicles.size() <= few_vehicles) {
        const float length = kind_of(now, vehicle).body.length * pixels_per_metre(seen, {vehicle.x, vehicle.y});
        EXPECT_GE(length, 0.98f * share * place.free_area.w) << length / place.free_area.w;
    }
}

// A run of 20 s, looked at after 10 and at the end. A vehicle that is gone by then has no size.
void expect_framed_in_run(const Scene& scene, const std::string& name, const Place& place) {
    SCOPED_TRACE(std::string(place.name) + ", " + name);
    auto world = World::create(scene, 1);
    ASSERT_TRUE(world);
    Snapshot now;
    world->capture(now);
    const FramingInput in = input(place, now.vehicles.front().id);
    Framing framing;
    framing.follow(now, in);
    for (int tick = 1; tick <= 1200; ++tick) {
        world->step();
        world->capture(now);
        const FloorBox box = framing.follow(now, in);
        if (tick % 600 != 0) continue;
        const CameraView seen =
            look(framing.raised(in.camera), now.scene->arena, nullptr, in.window, in.free_area, &box);
        EXPECT_GE(floor_cover(seen, now.scene->arena, in.free_area), enough_cover_in_run) << tick;
        for (const VehicleView& each : now.vehicles) {
            const auto at = project(seen, {each.x, each.y});
            EXPECT_TRUE(at && place.free_area.contains(at->x, at->y)) << each.id << ", " << tick;
        }
        const VehicleView* vehicle = find_vehicle(now, in.selected);
        if (!vehicle || now.vehicles.size() > few_vehicles) continue;
        const float length = kind_of(now, *vehicle).body.length * pixels_per_metre(seen, {vehicle->x, vehicle->y});
        EXPECT_GE(length, enough_in_run * place.least_share * place.free_area.w) << tick;
    }
}

template <class Expect>
void each_shipped(Expect expect) {
    const fs::path shipped = fs::path(BRAITENLAB_SOURCE) / "exercises";
    int scenes = 0;
    for (const auto& file : fs::directory_iterator(shipped / "scenes")) {
        const auto scene = load_scene(file.path());
        ASSERT_TRUE(scene) << file.path();
        expect(*scene, file.path().stem().string()), ++scenes;
    }
    for (const auto& file : fs::directory_iterator(shipped / "guided")) {
        const auto lesson = load_exercise(file.path());
        ASSERT_TRUE(lesson) << file.path();
        expect(lesson->scene, file.path().stem().string()), ++scenes;
    }
    EXPECT_GT(scenes, 40);
}

}  // namespace

TEST(Framing, CoversTheFreeAreaBesideCardsWithTheFloorOfEachShippedScene) {
    each_shipped([](const Scene& scene, const std::string& name) {
        expect_framed(scene, name, two_cards, wanted_cover, two_cards.least_share);
    });
}

TEST(Framing, ShowsTheVehicleOfEachShippedSceneLargeInALecture) {
    for (const Place& place : lectures)
        each_shipped([&](const Scene& scene, const std::string& name) {
            expect_framed(scene, name, place, wanted_cover, place.least_share);
        });
}

TEST(Framing, KeepsTheVehiclesOfEachShippedSceneInThePictureAndLegibleDuringARun) {
    each_shipped([](const Scene& scene, const std::string& name) {
        for (const Place& place : {two_cards, lectures[0]}) expect_framed_in_run(scene, name, place);
    });
}

// After 10 s of a run, in the area below the tools, in windows of 800 x 600 and of 1024 x 768 pixels.
TEST(Framing, ShowsAllThatAnExerciseIsAboutBetweenTheCardsOfASmallWindow) {
    constexpr Place small_windows[]{{"800 x 600", {0, 0, 800, 600}, {256, 122, 276, 380}, 0.05f},
                                    {"1024 x 768", {0, 0, 1024, 768}, {288, 124, 408, 494}, 0.05f}};
    for (const auto& file : fs::directory_iterator(fs::path(BRAITENLAB_SOURCE) / "exercises" / "guided")) {
        const auto lesson = load_exercise(file.path());
        ASSERT_TRUE(lesson);
        for (const Place& place : small_windows) {
            SCOPED_TRACE(file.path().stem().string() + ", " + place.name);
            auto world = World::create(lesson->scene, lesson->seed);
            Snapshot now;
            world->capture(now);
            const FramingInput in = input(place, now.vehicles.front().id);
            Framing framing;
            FloorBox box = framing.follow(now, in);
            for (int tick = 0; tick < 600; ++tick) {
                world->step();
                world->capture(now);
                box = framing.follow(now, in);
            }
            const CameraView seen =
                look(framing.raised(in.camera), now.scene->arena, nullptr, in.window, in.free_area, &box);
            const auto is_seen = [&](float x, float y) {
                const auto at = project(seen, {x, y});
                return at && place.free_area.contains(at->x, at->y);
            };
            for (const VehicleView& each : now.vehicles) EXPECT_TRUE(is_seen(each.x, each.y)) << "vehicle " << each.id;
            for (const SourceView& each : now.sources) EXPECT_TRUE(is_seen(each.x, each.y)) << "source";
            for (const Zone& each : now.scene->zones) {
                EXPECT_TRUE(each.surface != Surface::tape || is_seen(each.x, each.y)) << "a piece of a ring";
            }
            for (const Step& step : lesson->steps) {
                const auto* gate = std::get_if<goals::DrivesThrough>(&step.check.goal);
                for (const Obstacle& post : now.scene->obstacles) {
                    const bool is_of_gate = gate && (post.name == gate->left || post.name == gate->right);
                    EXPECT_TRUE(!is_of_gate || is_seen(post.x, post.y)) << post.name;
                }
            }
        }
    }
}

namespace {

// Between a caption of two lines and the lower edge, beside a question or a diagram.
constexpr Place page_with_question{"a small page with a question", {0, 0, 1024, 768}, {462, 200, 552, 558}, 0.08f};
constexpr Place page_with_diagram{"a small page with a diagram", {0, 0, 1024, 768}, {17, 200, 470, 558}, 0.08f};

bool is_inside(const Rect& a, const Rect& b) {
    return a.x >= b.x && a.y >= b.y && a.x + a.w <= b.x + b.w && a.y + a.h <= b.y + b.h;
}

}  // namespace

TEST(Framing, AVehicleThatEntersATorusAtItsOtherEdgeIsWholeInThePicture) {
    const auto lesson = load_exercise(fs::path(BRAITENLAB_SOURCE) / "exercises" / "guided" / "04-coward.toml");
    ASSERT_TRUE(lesson);
    for (const Place& place : {page_with_question, page_with_diagram}) {
        SCOPED_TRACE(place.name);
        auto world = World::create(lesson->scene, 1);
        ASSERT_TRUE(world);
        Snapshot now;
        world->capture(now);
        FramingInput in = input(place, now.vehicles.front().id);
        in.seconds = 1.0f / 60;
        Framing framing;
        framing.follow(now, in);
        int crossings = 0, outside = 0;
        for (int tick = 1; tick <= 15 * 60; ++tick) {
            const float before = now.vehicles.front().y;
            world->step();
            world->capture(now);
            const FloorBox box = framing.follow(now, in);
            const CameraView seen =
                look(framing.raised(in.camera), now.scene->arena, nullptr, in.window, in.free_area, &box);
            crossings += std::fabs(now.vehicles.front().y - before) > lesson->scene.arena.height / 2;
            outside += !is_inside(picture_of(now, seen, now.vehicles.front()), place.free_area);
        }
        EXPECT_GT(crossings, 0);
        EXPECT_EQ(outside, 0) << "ticks";
    }
}

TEST(Framing, ShowsEachSourceOfTheScenesOfLecturesBetweenCaptionAndValues) {
    for (const char* name : {"2a-coward", "2b-aggressor", "3a-love", "3b-explorer", "tortoise"}) {
        const auto scene =
            load_scene(fs::path(BRAITENLAB_SOURCE) / "exercises" / "scenes" / (name + std::string(".toml")));
        ASSERT_TRUE(scene) << name;
        expect_framed(*scene, name, page_with_values, wanted_cover, page_with_values.least_share);
    }
}

}  // namespace braitenlab::tests::framing_scenes_test
