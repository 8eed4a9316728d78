#include "core/sensing/stimulus_grid.h"

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "tests/core/chance.h"

namespace braitenlab::tests::stimulus_grid_test {
namespace {

using namespace sensing;
using maths::vec2;
using tests::Chance;

// The image of a position across the seams that is nearest to `from`, by a search of all images.
vec2 nearest_image(const Arena& arena, vec2 from, vec2 place) {
    vec2 nearest = place;
    if (arena.edge != Boundary::torus) return nearest;
    for (int row = -1; row <= 1; ++row)
        for (int column = -1; column <= 1; ++column) {
            const vec2 image =
                place + vec2{static_cast<float>(column) * arena.width, static_cast<float>(row) * arena.height};
            if (maths::distance(image, from) < maths::distance(nearest, from)) nearest = image;
        }
    return nearest;
}

struct Case {
    Arena arena;
    std::vector<Stimulus> stimuli;
    Sensor sensor;
    Pose pose;
};

Case make_case(Chance& chance, Boundary edge) {
    Case c;
    c.arena.edge = edge;
    c.arena.width = chance.number(4, 40), c.arena.height = chance.number(4, 40);
    for (int i = chance.below(200); i > 0; --i)
        c.stimuli.push_back({{chance.number(-0.5f, 0.5f) * c.arena.width, chance.number(-0.5f, 0.5f) * c.arena.height},
                             chance.number(0, 1),
                             chance.below(20) - 1});
    c.sensor = chance.sensor();
    c.pose = {chance.number(-0.5f, 0.5f) * c.arena.width, chance.number(-0.5f, 0.5f) * c.arena.height,
              chance.number(-4, 4)};
    return c;
}

void agrees_with_all_pairs(Boundary edge, std::uint64_t seed) {
    Chance chance(seed);
    int seen = 0;
    for (int i = 0; i < 3000; ++i) {
        const Case c = make_case(chance, edge);
        const CompiledSensor compiled(c.sensor);
        SensorPose placed = sensor_pose(compiled, {c.pose.x, c.pose.y}, maths::direction(c.pose.heading));
        placed.position = Seam(c.arena).inside(placed.position);
        const std::int32_t self = chance.below(20);
        double expected = 0;
        for (const Stimulus& s : c.stimuli)
            if (s.owner != self)
                expected +=
                    response_to(compiled, placed, nearest_image(c.arena, placed.position, s.position), s.strength);
        StimulusGrid grid;
        grid.lay_out(c.arena, compiled.range + chance.number(0, 5));
        grid.fill(c.stimuli);
        ASSERT_NEAR(grid.total(compiled, placed, self), expected, 1e-4 * (1 + expected)) << i;
        ASSERT_NEAR(grid.total_in_sight(compiled, placed, self, [](vec2, vec2) { return false; }), expected,
                    1e-4 * (1 + expected))
            << i;
        seen += expected > 0;
    }
    EXPECT_GT(seen, 1000);
}

// Stimuli of strength 0 add nothing, but with them the two others are sorted into cells and summed in lanes.
void reads_few_like_many(Boundary edge) {
    Chance chance(11);
    int seen = 0;
    for (int i = 0; i < 20000; ++i) {
        Case c = make_case(chance, edge);
        c.stimuli.resize(static_cast<std::size_t>(chance.below(3)));
        const std::int32_t self = chance.below(3) - 1;
        for (Stimulus& stimulus : c.stimuli) stimulus.owner = chance.below(3) - 1;
        const CompiledSensor compiled(c.sensor);
        SensorPose placed = sensor_pose(compiled, {c.pose.x, c.pose.y}, maths::direction(c.pose.heading));
        placed.position = Seam(c.arena).inside(placed.position);
        StimulusGrid few, many;
        few.lay_out(c.arena, compiled.range), many.lay_out(c.arena, compiled.range);
        few.fill(c.stimuli);
        while (c.stimuli.size() < 40)
            c.stimuli.push_back(
                {vec2{chance.number(-0.5f, 0.5f) * c.arena.width, chance.number(-0.5f, 0.5f) * c.arena.height}, 0});
        many.fill(c.stimuli);
        const float expected = many.total(compiled, placed, self);
        EXPECT_EQ(few.total(compiled, placed, self), expected);
        seen += expected > 0 ? 1 : 0;
    }
    EXPECT_GT(seen, 1000);
}

TEST(StimulusGrid, AgreesWithTheSumOfAllPairsWithinWalls) { agrees_with_all_pairs(Boundary::wall, 1); }
TEST(StimulusGrid, AgreesWithTheSumOfAllPairsAcrossASeam) { agrees_with_all_pairs(Boundary::torus, 2); }

TEST(StimulusGrid, AddsTheStimuliOfEveryResponse) {
    for (const auto& row : sensor_response_table) {
        Sensor sensor{.response = row.value, .x = 0, .range = 6};
        if (row.value == SensorResponse::table) sensor.points = {{0, 1}, {6, 0.5f}};
        const CompiledSensor compiled(sensor);
        StimulusGrid grid;
        grid.lay_out({}, 6);
        grid.fill({{{3, 0}, 0.5f, -1}, {{4, 1}, 0.5f, -1}, {{7, 0}, 1, -1}});
        const SensorPose placed = sensor_pose(compiled, {0, 0}, {1, 0});
        const float expected =
            response_to(compiled, placed, {3, 0}, 0.5f) + response_to(compiled, placed, {4, 1}, 0.5f);
        EXPECT_GT(expected, 0.05f) << row.word;
        EXPECT_NEAR(grid.total(compiled, placed, -2), expected, 1e-6f) << row.word;
    }
}

TEST(StimulusGrid, IncludesStimuliOutsideTheArena) {
    Arena arena;
    arena.edge = Boundary::open;
    const CompiledSensor compiled({.x = 0, .range = 5});
    StimulusGrid grid;
    grid.lay_out(arena, 5);
    grid.fill({{{14, 0}, 1, -1}});
    EXPECT_GT(grid.total(compiled, sensor_pose(compiled, {12, 0}, {1, 0}), -2), 0);
}

TEST(StimulusGrid, OmitsHiddenStimuli) {
    const CompiledSensor compiled({.response = SensorResponse::boolean, .x = 0});
    StimulusGrid grid;
    grid.lay_out({}, 12);
    grid.fill({{{3, 0}, 0.25f, -1}, {{4, 1}, 0.5f, -1}});
    const SensorPose placed = sensor_pose(compiled, {0, 0}, {1, 0});
    EXPECT_EQ(grid.total_in_sight(compiled, placed, -2, [](vec2, vec2 to) { return to.y > 0; }), 0.25f);
}

TEST(StimulusGrid, ReadsOneOrTwoStimuliWithTheSameBitsAsAmongMany) {
    reads_few_like_many(Boundary::wall);
    reads_few_like_many(Boundary::torus);
}

}  // namespace
}  // namespace braitenlab::tests::stimulus_grid_test
