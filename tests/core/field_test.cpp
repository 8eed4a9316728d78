#include "core/world/field.h"

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "tests/core/chance.h"

namespace braitenlab::tests::field_test {
namespace {

using maths::vec2;
using tests::Chance;

// The image of a place across the seams that is nearest to `from`, found by trying them all.
vec2 nearest_image(const Arena& arena, vec2 from, vec2 place) {
    vec2 nearest = place;
    if (arena.edge != Edge::torus) return nearest;
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

Case make_case(Chance& chance, Edge edge) {
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

void agrees_with_all_pairs(Edge edge, std::uint64_t seed) {
    Chance chance(seed);
    int seen = 0;
    for (int i = 0; i < 3000; ++i) {
        const Case c = make_case(chance, edge);
        const Eye eye(c.sensor);
        Gaze gaze = carry(eye, {c.pose.x, c.pose.y}, maths::direction(c.pose.heading));
        gaze.from = Seam(c.arena).inside(gaze.from);
        const std::int32_t self = chance.below(20);
        double expected = 0;
        for (const Stimulus& s : c.stimuli)
            if (s.owner != self) expected += answer(eye, gaze, nearest_image(c.arena, gaze.from, s.place), s.strength);
        Field field;
        field.lay_out(c.arena, eye.range + chance.number(0, 5));
        field.fill(c.stimuli);
        ASSERT_NEAR(field.total(eye, gaze, self), expected, 1e-4 * (1 + expected)) << i;
        ASSERT_NEAR(field.total_in_sight(eye, gaze, self, [](vec2, vec2) { return false; }), expected,
                    1e-4 * (1 + expected))
            << i;
        seen += expected > 0;
    }
    EXPECT_GT(seen, 1000);
}

TEST(Field, AddsUpWhatAllPairsAddUpToWithinWalls) { agrees_with_all_pairs(Edge::wall, 1); }
TEST(Field, AddsUpWhatAllPairsAddUpToAcrossASeam) { agrees_with_all_pairs(Edge::torus, 2); }

TEST(Field, KeepsWhatStandsOutsideTheArena) {
    Arena arena;
    arena.edge = Edge::open;
    const Eye eye({.x = 0, .range = 5});
    Field field;
    field.lay_out(arena, 5);
    field.fill({{{14, 0}, 1, -1}});
    EXPECT_GT(field.total(eye, carry(eye, {12, 0}, {1, 0}), -2), 0);
}

TEST(Field, LeavesOutWhatIsHidden) {
    const Eye eye({.response = SensorResponse::boolean, .x = 0});
    Field field;
    field.lay_out({}, 12);
    field.fill({{{3, 0}, 0.25f, -1}, {{4, 1}, 0.5f, -1}});
    const Gaze gaze = carry(eye, {0, 0}, {1, 0});
    EXPECT_EQ(field.total_in_sight(eye, gaze, -2, [](vec2, vec2 to) { return to.y > 0; }), 0.25f);
}

}  // namespace
}  // namespace braitenlab::tests::field_test
