// How calm the camera is in runs of a minute of shipped scenes.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "render/view/framing.h"

namespace braitenlab::tests::framing_calm_test {
namespace {

namespace fs = std::filesystem;

constexpr int frames = 3600;
constexpr float frame_seconds = 1.0f / 60;

// The part of a window that two open cards, also of a small window, or the bars of a lecture leave free.
constexpr struct {
    const char* name;
    Rect free_area;
    float least_share;
} places[]{{"two open cards", {336, 84, 576, 610}, 0.05f},
           {"two open cards of a small window", {256, 122, 276, 380}, 0.05f},
           {"a lecture", {16, 95, 1248, 499}, 0.08f}};

std::optional<Scene> shipped(const std::string& name) {
    const fs::path folder = fs::path(BRAITENLAB_SOURCE) / "exercises";
    if (auto scene = load_scene(folder / "scenes" / (name + ".toml"))) return *scene;
    if (auto lesson = load_exercise(folder / "guided" / (name + ".toml"))) return lesson->scene;
    return std::nullopt;
}

// The vehicle that a person watches: a predator, else the first one.
VehicleId watched(const Snapshot& now) {
    const auto is_predator = [&](const VehicleView& v) { return kind_of(now, v).role == Role::predator; };
    const auto found = std::find_if(now.vehicles.begin(), now.vehicles.end(), is_predator);
    return found == now.vehicles.end() ? now.vehicles.front().id : found->id;
}

float distance(const FloorBox& a, const FloorBox& b) {
    return std::max(maths::distance(a.low, b.low), maths::distance(a.high, b.high));
}

struct Movement {
    int choices = 0;           // jumps of the box to which the camera glides
    int elevations = 0;        // changes of the elevation to which it glides
    int returns = 0;           // of these, back to the elevation before
    float step = 0, jerk = 0;  // m: largest change of the shown box in a frame, and of that change from frame to frame
};

Movement movement_in(World& world, const Rect& free_area, float least_share) {
    Snapshot now;
    world.capture(now);
    FramingInput in;
    in.selected = watched(now), in.window = {0, 0, 1280, 800}, in.free_area = free_area, in.least_share = least_share;
    Framing shown, aimed;  // with and without a glide
    FloorBox box = shown.follow(now, in), goal = aimed.follow(now, in);
    float elevation = aimed.raised({}).elevation, before = elevation, step = 0;
    Movement sum;
    for (int i = 0; i < frames; ++i) {
        world.step();
        world.capture(now);
        in.seconds = 0;
        const FloorBox next_goal = aimed.follow(now, in);
        in.seconds = frame_seconds;
        const FloorBox next = shown.follow(now, in);
        if (distance(goal, next_goal) > 0.3f) ++sum.choices;
        if (const float wanted = aimed.raised({}).elevation; wanted != elevation) {
            ++sum.elevations;
            if (wanted == before) ++sum.returns;
            before = elevation, elevation = wanted;
        }
        const float moved = distance(box, next);
        sum.step = std::max(sum.step, moved), sum.jerk = std::max(sum.jerk, std::fabs(moved - step));
        step = moved, box = next, goal = next_goal;
    }
    return sum;
}

}  // namespace

TEST(Framing, MovesSeldomAndSmoothlyInAMinuteOfEachOfTheseScenes) {
    for (const char* name :
         {"2a-coward",  "2b-aggressor",    "3b-explorer",  "4a-orbit",  "dance",    "predator-prey", "14-logic",
          "convoy",     "moth-and-hunter", "3a-love",      "1-alive",   "2c",       "3c-values",     "4b-decision",
          "5-logic",    "pushing",         "drivers",      "01-drive",  "03-alive", "05-aggressor",  "06-love",
          "07-further", "08-overrun",      "11-threshold", "12-values", "13-orbit", "16-pavlov",     "21-reality"})
        for (const auto& place : places) {
            SCOPED_TRACE(std::string(name) + ", " + place.name);
            const auto scene = shipped(name);
            ASSERT_TRUE(scene);
            auto world = World::create(*scene, 1);
            ASSERT_TRUE(world);
            const Movement sum = movement_in(*world, place.free_area, place.least_share);
            EXPECT_LE(sum.choices, 7);
            EXPECT_LE(sum.elevations, 2);
            EXPECT_EQ(sum.returns, 0) << "it alternates between two elevations";
            EXPECT_LE(sum.step, 0.1f) << "a box of 10 m moves by a hundredth";
            EXPECT_LE(sum.jerk, 0.015f) << "the glide begins or ends with a jerk";
        }
}

}  // namespace braitenlab::tests::framing_calm_test
