// How large the framed action of each shipped scene and exercise is, at its start.
#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/lesson/exercise.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "render/view/framing.h"

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
};
constexpr Place places[]{{"two open cards", {0, 0, 1280, 800}, {336, 84, 576, 610}, 0.05f},
                         {"a lecture", {0, 0, 1280, 800}, {16, 95, 1248, 499}, 0.08f},
                         {"a small lecture", {0, 0, 1024, 768}, {16, 95, 992, 467}, 0.08f}};

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

void expect_large(const Scene& scene) {
    const auto world = World::create(scene, 1);
    ASSERT_TRUE(world);
    Snapshot now;
    world->capture(now);
    ASSERT_FALSE(now.vehicles.empty());
    const VehicleView& vehicle = now.vehicles.front();
    for (const Place& place : places) {
        SCOPED_TRACE(place.name);
        FramingInput in;
        in.selected = vehicle.id, in.window = place.window, in.free_area = place.free_area;
        in.least_share = place.least_share;
        const FloorBox box = Framing{}.follow(now, in);
        const CameraView seen = look(in.camera, now.scene->arena, nullptr, in.window, in.free_area, &box);
        const vec2 shares = shares_of(box, seen, place.free_area);
        EXPECT_GE(std::max(shares.x, shares.y), 0.87f) << "room is wasted in width and in height";
        const float length = kind_of(now, vehicle).body.length * pixels_per_metre(seen, {vehicle.x, vehicle.y});
        // A single vehicle is smaller than it should be only for the sake of all lamps, by the share in framing.cpp.
        if (now.vehicles.size() == 1) {
            EXPECT_GE(length, 0.59f * place.least_share * place.free_area.w);
        }
    }
}

}  // namespace

TEST(Framing, FillsWidthOrHeightWithTheActionOfEachShippedScene) {
    const fs::path shipped = fs::path(BRAITENLAB_SOURCE) / "exercises";
    int scenes = 0;
    for (const auto& file : fs::directory_iterator(shipped / "scenes")) {
        SCOPED_TRACE(file.path().filename());
        const auto scene = load_scene(file.path());
        ASSERT_TRUE(scene);
        expect_large(*scene), ++scenes;
    }
    for (const auto& file : fs::directory_iterator(shipped / "guided")) {
        SCOPED_TRACE(file.path().filename());
        const auto exercise = load_exercise(file.path());
        ASSERT_TRUE(exercise);
        expect_large(exercise->scene), ++scenes;
    }
    EXPECT_GT(scenes, 40);
}

}  // namespace braitenlab::tests::framing_scenes_test
