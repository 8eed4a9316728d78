// Maps of behaviour: kinds of known brains, axes, levels, seeds.
#include "core/insight/map.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <thread>

#include <gtest/gtest.h>

#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::map_test {
namespace {

using insight::Behaviour;
using insight::MapBase;
using insight::MapCell;
using insight::MapPlace;
using insight::MapQuestion;
using insight::Outcome;

std::shared_ptr<const MapBase> base_of(const MapQuestion& question) {
    auto base = MapBase::create(question);
    EXPECT_TRUE(base) << base.error().text();
    return *base;
}

// The axes hold the weights of the vehicle at (0, 0) and others at the other corners.
MapQuestion at_corner(const Scene& scene, float straight, float crossed, int size = 2) {
    MapQuestion question{.scene = scene, .vehicle = 0, .target = {no_vehicle, 0}, .size = size};
    question.x.from = straight, question.y.from = crossed;
    question.x.to = straight > 0 ? -1.0f : 1.0f, question.y.to = crossed > 0 ? -1.0f : 1.0f;
    return question;
}

Outcome run_at_corner(const Scene& scene, float straight, float crossed) {
    return insight::run_cell(base_of(at_corner(scene, straight, crossed)), {0, 0}).outcome;
}

// A vehicle at (0, 0) that heads along x, and a lamp.
Scene with_a_lamp(float bias) {
    Scene scene = alone({.LM = bias, .RM = bias});
    scene.arena.width = scene.arena.height = 60;
    scene.sources = {{.name = "lamp", .x = 4, .y = 1}};
    return scene;
}

TEST(MapBehaviour, OfAnAggressorIsThatItTouches) {
    const Outcome outcome = run_at_corner(shipped_scene("2b-aggressor"), 0, 1.5f);
    EXPECT_EQ(outcome.behaviour, Behaviour::touches);
    EXPECT_GT(outcome.time_to_touch, 1);
    EXPECT_LT(outcome.time_to_touch, 20);
    EXPECT_LT(outcome.closest, 0.8f);
}

TEST(MapBehaviour, OfALoverIsThatItRestsNear) {
    const Outcome outcome = run_at_corner(shipped_scene("3a-love"), -1, 0);
    EXPECT_EQ(outcome.behaviour, Behaviour::rests_near);
    EXPECT_NEAR(outcome.final_distance, 2.6f, 0.5f);  // a reading of 0.5 stops it: at 3 m, nearer seen aside
    EXPECT_TRUE(std::isinf(outcome.time_to_touch));
}

TEST(MapBehaviour, OfACowardIsThatItFlees) {
    EXPECT_EQ(run_at_corner(shipped_scene("2a-coward"), 1.5f, 0).behaviour, Behaviour::flees);
}

TEST(MapBehaviour, WithoutWiresAndBiasIsThatItStands) {
    EXPECT_EQ(run_at_corner(with_a_lamp(0), 0, 0).behaviour, Behaviour::stands);
}

TEST(MapBehaviour, StraightPastALampIsThatItPassesAndFurtherThatItLeaves) {
    Scene scene = with_a_lamp(0.2f);  // 12 m in 20 s
    scene.sources[0].y = 2;
    EXPECT_EQ(run_at_corner(scene, 0, 0).behaviour, Behaviour::passes);
    scene = with_a_lamp(0.5f);  // 30 m, and its eyes reach 12 m
    scene.sources[0].y = 2;
    EXPECT_EQ(run_at_corner(scene, 0, 0).behaviour, Behaviour::leaves);
}

TEST(MapBehaviour, SlowlyTowardsALampIsThatItApproaches) {
    Scene scene = with_a_lamp(0.05f);
    scene.sources[0].y = 0, scene.sources[0].x = 9;
    EXPECT_EQ(run_at_corner(scene, 0, 0).behaviour, Behaviour::approaches);
}

TEST(MapBehaviour, OverAnOpenEdgeIsThatItLeaves) {
    Scene scene = with_a_lamp(0.5f);
    scene.arena.edge = Boundary::open;
    scene.arena.width = scene.arena.height = 12;
    scene.sources[0].y = 3;
    const Outcome outcome = run_at_corner(scene, 0, 0);
    EXPECT_EQ(outcome.behaviour, Behaviour::leaves);
    EXPECT_LT(outcome.survival, 15);
}

TEST(MapBehaviour, RoundALampIsThatItCircles) {
    Scene scene = with_a_lamp(0.3f);
    scene.kinds[0].brain = make_graph({.LM = 0.48f, .RM = 0.6f});
    scene.sources[0].x = 0, scene.sources[0].y = 2.7f;
    EXPECT_EQ(run_at_corner(scene, 0, 0).behaviour, Behaviour::circles);
}

TEST(MapBehaviour, StuckAtAWallIsNoRest) {
    Scene scene = with_a_lamp(0.5f);
    scene.arena.width = scene.arena.height = 12;
    scene.sources[0].x = 3, scene.sources[0].y = 2;
    EXPECT_EQ(run_at_corner(scene, 0, 0).behaviour, Behaviour::passes);
}

TEST(MapBehaviour, WithoutSourcesIsAboutTheNearestVehicle) {
    Scene scene = with_a_lamp(0.2f);
    scene.sources.clear();
    scene.starts.push_back(scene.starts[0]);
    scene.starts[1].name = "two", scene.starts[1].x = 4, scene.starts[1].driver = Driver::manual;
    EXPECT_EQ(run_at_corner(scene, 0, 0).behaviour, Behaviour::touches);
    scene.starts.pop_back();
    EXPECT_TRUE(std::isnan(run_at_corner(scene, 0, 0).closest));
}

TEST(Map, HasTheRunThatTheSceneItselfHasWithTheseValues) {
    const auto base = base_of(at_corner(shipped_scene("2b-aggressor"), 0.25f, 1.25f));
    insight::MapRun run(base, {0, 0}, 0);
    while (!run.advance(100)) {
    }
    Scene scene = shipped_scene("2b-aggressor");
    FourNeurons dials = read_dials(scene.kinds[0].brain);
    dials.LL = dials.RR = 0.25f, dials.LR = dials.RL = 1.25f;
    scene.kinds[0].brain = make_graph(dials);
    World world = make(scene);
    const VehicleView last = after(world, 20).vehicles[0];
    ASSERT_EQ(run.path().size(), 1201U);
    EXPECT_EQ(run.path().back(), (Pose{last.x, last.y, last.heading}));
}

TEST(Map, OfAPathIsThatOfItsDials) {
    MapQuestion question = at_corner(shipped_scene("2b-aggressor"), 0, 1.5f, 4);
    const auto dials = base_of(question);
    question.x = *insight::parse_axis("kind.aggressor.brain.LL=RR=0:1", "--x");
    question.y = *insight::parse_axis("kind.aggressor.brain.LR=RL=1.5:-1", "--y");
    const auto paths = base_of(question);
    for (const MapPlace place : {MapPlace{0, 0}, MapPlace{3, 0}, MapPlace{1, 2}}) {
        const Outcome a = insight::run_cell(dials, place).outcome, b = insight::run_cell(paths, place).outcome;
        EXPECT_EQ(a.behaviour, b.behaviour);
        EXPECT_EQ(a.closest, b.closest);
        EXPECT_EQ(a.final_distance, b.final_distance);
    }
}

TEST(Map, IsTheSameForAnyNumberOfThreads) {
    const auto base = base_of(at_corner(shipped_scene("3a-love"), -1, 0, 6));
    const auto cell = [&](int index) { return insight::run_cell(base, {index % 6, index / 6}).outcome; };
    std::vector<Outcome> one, two(36);
    for (int i = 0; i < 36; ++i) one.push_back(cell(i));
    std::thread other([&] {
        for (int i = 35; i >= 18; --i) two[static_cast<std::size_t>(i)] = cell(i);
    });
    for (int i = 0; i < 18; ++i) two[static_cast<std::size_t>(i)] = cell(i);
    other.join();
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].behaviour, two[i].behaviour);
        EXPECT_EQ(one[i].final_distance, two[i].final_distance);
    }
}

TEST(Map, HasEachCellInOneLevelFromCoarseToFine) {
    for (const int size : {2, 4, 9, 20, 32}) {
        std::set<std::pair<int, int>> seen;
        std::size_t count = 0;
        for (const auto& level : insight::map_levels(size)) {
            count += level.size();
            for (const MapPlace place : level) seen.insert({place.x, place.y});
        }
        EXPECT_EQ(count, static_cast<std::size_t>(size * size));
        EXPECT_EQ(seen.size(), count);
    }
    const auto levels = insight::map_levels(32);
    ASSERT_EQ(levels.size(), 4U);
    EXPECT_EQ(levels[0].size(), 16U);
    EXPECT_EQ(levels[1].size(), 64U);
    EXPECT_EQ(levels[2].size(), 256U);
}

TEST(Map, ShowsTheMiddleOfABlockUntilTheCellIsKnown) {
    insight::MapCells cells(32);
    EXPECT_EQ(cells.shown({3, 3}), nullptr);
    const auto levels = insight::map_levels(32);
    for (const MapPlace place : levels[0]) cells.at(place) = MapCell{{.closest = static_cast<float>(place.x)}};
    for (int x = 0; x < 32; ++x)
        for (int y = 0; y < 32; ++y) ASSERT_EQ(cells.shown({x, y})->outcome.closest, static_cast<float>(x / 8 * 8 + 4));
    cells.at({3, 3}) = MapCell{{.closest = 99}};
    EXPECT_EQ(cells.shown({3, 3})->outcome.closest, 99);
    EXPECT_EQ(cells.shown({2, 2})->outcome.closest, 99);  // the middle of the block of 2 × 2
    EXPECT_EQ(cells.shown({1, 3})->outcome.closest, 4);
}

TEST(Map, OfSeveralSeedsIsTheMostFrequentKindWithItsShareAndTheMedian) {
    const MapCell cell = insight::cell_of({{.behaviour = Behaviour::flees, .closest = 5},
                                           {.behaviour = Behaviour::touches, .closest = 1},
                                           {.behaviour = Behaviour::flees, .closest = 3},
                                           {.behaviour = Behaviour::flees, .closest = 4}});
    EXPECT_EQ(cell.outcome.behaviour, Behaviour::flees);
    EXPECT_EQ(cell.agree, 0.75f);
    EXPECT_EQ(cell.outcome.closest, 3);
}

TEST(Map, SeedsVaryTheStart) {
    MapQuestion question = at_corner(shipped_scene("2b-aggressor"), 0, 1.5f);
    question.seeds = 2;
    const auto base = base_of(question);
    const insight::MapRun first(base, {0, 0}, 0), second(base, {0, 0}, 1);
    EXPECT_NE(first.path().front(), second.path().front());
}

TEST(MapAxis, ReadsDialsPathsAndKeysThatShareAValue) {
    const auto dials = insight::parse_axis("LL=RR=-1:0.5", "--x");
    ASSERT_TRUE(dials);
    EXPECT_EQ(dials->dials, (std::vector{Dial::LL, Dial::RR}));
    EXPECT_EQ(dials->from, -1);
    EXPECT_EQ(insight::value_at(*dials, 0, 4), -1);
    EXPECT_EQ(insight::value_at(*dials, 1, 4), -0.5f);
    EXPECT_EQ(insight::value_at(*dials, 3, 4), 0.5f);
    const auto paths = insight::parse_axis("kind.prey.brain.LM=RM=0:1", "--x");
    ASSERT_TRUE(paths);
    EXPECT_EQ(paths->values, (std::vector<std::string>{"kind.prey.brain.LM", "kind.prey.brain.RM"}));
}

TEST(MapAxis, RefusesWhatIsNoAxis) {
    for (const char* wrong : {"LL=RR", "LL", "=0:1", "LL=0:1:2", "LL=0:x", "LL=1:1", "LX=0:1", "LL=LM=0:1", "LL==0:1"})
        EXPECT_FALSE(insight::parse_axis(wrong, "--x")) << wrong;
    EXPECT_EQ(insight::parse_axis("LL=0:x", "--x").error().text(), "--x LL=0:x: 'x' is not a number");
}

TEST(MapBase, RefusesValuesThatTheSceneDoesNotHave) {
    const auto refused = [](const char* x, int vehicle = 0) {
        MapQuestion question = at_corner(shipped_scene("2b-aggressor"), 0, 1);
        question.x = *insight::parse_axis(x, "--x");
        question.vehicle = vehicle;
        const auto base = MapBase::create(question);
        return base ? std::string() : base.error().text();
    };
    EXPECT_EQ(refused("LL=0:3"), "LL: LL is from -2 to 2");
    EXPECT_NE(refused("LR=0:1").find("both axes"), std::string::npos);
    EXPECT_NE(refused("arena.gripp=0:1").find("the nearest is 'arena.grip'"), std::string::npos);
    EXPECT_NE(refused("arena.grip=0:9").find("outside"), std::string::npos);
    EXPECT_NE(refused("LL=0:1", 7).find("no vehicle"), std::string::npos);
    EXPECT_EQ(refused("arena.grip=0.1:1"), "");
}

}  // namespace
}  // namespace braitenlab::tests::map_test
