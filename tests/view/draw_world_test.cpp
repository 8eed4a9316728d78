// Objects and zones of the arena in the draw list.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "render/view/draw_list.h"
#include "tests/view/drawn.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::draw_world_test {
namespace {

using namespace render;

std::shared_ptr<Scene> bare() {
    auto scene = hand_made::scene();
    scene->arena.edge = Boundary::open;
    return scene;
}

int count(const DrawList& list, Pattern pattern) {
    return static_cast<int>(std::count_if(list.zones.begin(), list.zones.end(), [&](const ZoneInstance& zone) {
        return zone.shape.w == static_cast<float>(pattern);
    }));
}

TEST(DrawWorld, DrawsAnObstacleWhereItWasPushedTo) {
    auto scene = bare();
    scene->obstacles.push_back({.name = "crate", .x = 1, .y = 2, .mass = 5});
    Snapshot now = hand_made::empty(scene);
    now.obstacles = {{3, 4, maths::pi / 2}};
    const BlockInstance block = drawn(now).blocks.at(0);
    EXPECT_EQ(block.place.x, 3);
    EXPECT_EQ(block.place.y, 4);
    EXPECT_NEAR(block.place.w, 1, 1e-5);
    EXPECT_EQ(block.colour.w, 1);  // can be pushed
}

TEST(DrawWorld, UsesTheCornersOfAnObstacle) {
    auto scene = bare();
    scene->obstacles.push_back({.name = "box", .length = 4, .width = 2});
    scene->obstacles.push_back({.name = "wedge", .corners = {{-1, -1}, {1.5f, 0}, {-1, 1}}});
    const DrawList list = drawn(hand_made::empty(scene));
    ASSERT_EQ(list.blocks.size(), 2U);
    // Each corner is cut: its two points are on the edges beside it, near it.
    const auto is_cut = [&](std::size_t block, std::size_t corner, maths::vec2 sharp) {
        const maths::vec4 two = list.blocks[block].corners.at(corner);
        for (const maths::vec2 point : {maths::vec2{two.x, two.y}, maths::vec2{two.z, two.w}}) {
            EXPECT_GT(maths::distance(point, sharp), 0.01f);
            EXPECT_LT(maths::distance(point, sharp), 0.2f);
        }
    };
    EXPECT_EQ(list.blocks[0].size.z, 8);
    is_cut(0, 0, {-2, -1});
    is_cut(0, 1, {2, -1});  // ahead, on the right
    EXPECT_EQ(list.blocks[1].size.z, 6);
    is_cut(1, 1, {1.5f, 0});
    is_cut(1, 2, {-1, 1});
    EXPECT_EQ(list.blocks[0].colour.w, 0);
}

TEST(DrawWorld, DrawsTheWallOfARoundArenaAlongItsEdge) {
    auto scene = bare();
    scene->arena.round = true;
    EXPECT_TRUE(drawn(hand_made::empty(scene)).blocks.empty());
    scene->arena.edge = Boundary::wall;
    const DrawList list = drawn(hand_made::empty(scene));
    EXPECT_GE(list.blocks.size(), 64U);
    for (const BlockInstance& block : list.blocks) {
        const float x = 2 * block.place.x / scene->arena.width, y = 2 * block.place.y / scene->arena.height;
        EXPECT_GT(std::hypot(x, y), 1) << "outside the edge";
        EXPECT_LT(std::hypot(x, y), 1.05f);
        EXPECT_EQ(block.size.w, 1) << "a wall of the arena";
    }
}

TEST(DrawWorld, WallsAndObstaclesOfASmallArenaDoNotHideASmallRobot) {
    auto scene = bare();
    scene->arena.edge = Boundary::wall;
    scene->obstacles.push_back({});
    const auto highest = [&](float size) {
        scene->arena.width = scene->arena.height = size;
        float high = 0;
        for (const BlockInstance& block : drawn(hand_made::empty(scene)).blocks) high = std::max(high, block.size.x);
        return high;
    };
    EXPECT_NEAR(highest(1), 0.084f, 1e-5f) << "little more than an e-puck";
    EXPECT_NEAR(highest(5), 0.42f, 1e-5f);
    EXPECT_NEAR(highest(20), 0.42f, 1e-5f);
}

TEST(DrawWorld, DrawsASolidSourceOnAPost) {
    auto scene = bare();
    scene->sources.push_back({.name = "ghost", .x = 0});
    scene->sources.push_back({.name = "post", .x = 5, .solid = true});
    Snapshot now = hand_made::empty(scene);
    hand_made::add_source(now, Channel::light, 0, 0);
    hand_made::add_source(now, Channel::light, 6, 0);  // dragged
    const DrawList list = drawn(now);
    ASSERT_EQ(list.blocks.size(), 1U);
    EXPECT_EQ(list.blocks[0].place.x, 6);
    const maths::vec4 first = list.blocks[0].corners[0];
    EXPECT_NEAR(std::hypot(first.x, first.y), solid_source_radius, 1e-5);
    EXPECT_EQ(list.sources[0].size(), 2U);
}

TEST(DrawWorld, DrawsSourcesOnATableToItsScale) {
    auto large = bare(), table = bare();
    table->arena.width = table->arena.height = 1;
    for (const auto& scene : {large, table}) scene->sources.push_back({.name = "post", .solid = true});
    const auto drawn_in = [](const std::shared_ptr<Scene>& scene) {
        Snapshot now = hand_made::empty(scene);
        hand_made::add_source(now, Channel::light, 0, 0);
        return drawn(now);
    };
    const DrawList full = drawn_in(large), small = drawn_in(table);
    const auto lamp = [](const DrawList& list) { return list.sources[0].at(0).place.z; };
    EXPECT_NEAR(lamp(small), 0.2f * lamp(full), 1e-5);
    const maths::vec4 corner = small.blocks.at(0).corners[0];
    EXPECT_NEAR(std::hypot(corner.x, corner.y), source_radius(table->arena), 1e-5) << "as it collides";
    EXPECT_NEAR(small.halos.at(0).place.w, 0.2f * full.halos.at(0).place.w, 1e-5);
}

TEST(DrawWorld, LightsTheFloorAsFarAsALampInCandelaGivesHalfAPhotocell) {
    auto scene = bare();
    scene->sources.push_back({.name = "torch", .candela = 67});
    for (Kind& kind : scene->kinds)
        for (Sensor& sensor : kind.sensors) sensor.response = SensorResponse::photocell, sensor.half_lux = 268;
    EXPECT_NEAR(light_law(*scene).half_distance, 0.5f, 1e-5);
}

TEST(DrawWorld, DrawsASourceThatIsOffInGreyAndWithoutLight) {
    Snapshot lit = hand_made::empty(bare()), unlit = lit;
    hand_made::add_source(lit, Channel::red, 0, 0, 1);
    hand_made::add_source(unlit, Channel::red, 0, 0, 0);
    const DrawList on = drawn(lit), off = drawn(unlit);
    EXPECT_EQ(on.halos.size(), 1U);
    EXPECT_EQ(on.lamps.size(), 1U);
    EXPECT_TRUE(off.halos.empty());
    EXPECT_TRUE(off.lamps.empty());
    const auto spread = [](const DrawList& list) {
        const maths::vec4 c = list.sources[static_cast<std::size_t>(source_shape_of(Channel::red))].at(0).colour;
        return std::max({c.x, c.y, c.z}) - std::min({c.x, c.y, c.z});
    };
    EXPECT_LT(spread(off), 0.5f * spread(on)) << "no colour of a lit lamp";
}

TEST(DrawWorld, PutsCarriedLampsOnTheirVehicle) {
    auto scene = bare();
    scene->kinds[0].lamps.push_back(
        {.name = "torch", .channel = Channel::heat, .x = -0.2f, .y = 0.1f, .strength = 0.5f});
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 1, 2, maths::pi / 2);
    const DrawList list = drawn(now);
    ASSERT_EQ(list.sources[1].size(), 1U);
    EXPECT_NEAR(list.sources[1][0].place.x, 0.9f, 1e-5);
    EXPECT_NEAR(list.sources[1][0].place.y, 1.8f, 1e-5);
    EXPECT_GT(list.sources[1][0].colour.w, 0.2f);  // on the deck
    EXPECT_EQ(list.halos.size(), 1U);
    EXPECT_EQ(list.lamps.size(), 1U);
}

TEST(DrawWorld, ShowsEachOfAZonesEffects) {
    auto scene = bare();
    scene->zones.push_back({.name = "a", .surface = Surface::ice, .recharge = 0.1f});
    scene->zones.push_back({.name = "b", .surface = Surface::sand, .wind_x = 2, .slope = 0.1f, .pull = -3});
    scene->zones.push_back({.name = "c"});  // a zone without effects
    const DrawList list = drawn(hand_made::empty(scene));
    EXPECT_EQ(list.zones.size(), 6U);
    for (const Pattern p :
         {Pattern::ice, Pattern::recharge, Pattern::sand, Pattern::wind, Pattern::slope, Pattern::push})
        EXPECT_EQ(count(list, p), 1) << static_cast<int>(p);
    Picture picture;
    picture.settings.overlays.surfaces = false;
    EXPECT_TRUE(drawn(hand_made::empty(scene), picture).zones.empty());
}

TEST(DrawWorld, DrawsAPolygonWithinARectangleThatContainsItsCorners) {
    auto scene = bare();
    scene->zones.push_back({.name = "a", .surface = Surface::ice, .corners = {{-1, -2}, {3, 0}, {0, 1}}});
    scene->zones.push_back({.name = "b", .length = 2, .round = true, .surface = Surface::ice});
    const DrawList list = drawn(hand_made::empty(scene));
    const ZoneInstance& polygon = list.zones.at(0);
    EXPECT_EQ(polygon.shape.x, 3);
    EXPECT_EQ(polygon.shape.y, 2);
    EXPECT_EQ(polygon.shape.z, 3) << "the number of corners";
    EXPECT_EQ(polygon.corners[0], (maths::vec4{-1, -2, 3, 0}));
    EXPECT_EQ(polygon.corners[1].y, 1);
    EXPECT_EQ(list.zones.at(1).shape.z, 1) << "an ellipse";
}

TEST(DrawWorld, DrawsWindInWorldDirectionForARotatedZone) {
    auto scene = bare();
    scene->zones.push_back({.name = "a", .heading = maths::pi / 2, .wind_x = 2});
    const ZoneInstance zone = drawn(hand_made::empty(scene)).zones.at(0);
    EXPECT_NEAR(zone.flow.x, 0, 1e-5);  // in the frame of the zone
    EXPECT_NEAR(zone.flow.y, -1, 1e-5);
}

TEST(DrawWorld, ShowsTheMemoryOfTheSelectedVehicleStrongerAndCanHideIt) {
    Snapshot now = hand_made::empty(bare());
    now.marks = {{0, 1, 1, 0.6f}, {1, 2, 2, 0.6f}};
    Picture picture;
    picture.settings.selection.vehicle = 1;
    const DrawList list = drawn(now, picture);
    ASSERT_EQ(list.rings.size(), 2U);
    EXPECT_GT(list.rings[1].colour.w, 2 * list.rings[0].colour.w);
    EXPECT_EQ(list.rings[0].shape.w, static_cast<float>(MarkKind::memory));
    picture.settings.overlays.memory = false;
    EXPECT_TRUE(drawn(now, picture).rings.empty());
}

TEST(DrawWorld, FadesMemoryWithItsStrength) {
    Snapshot now = hand_made::empty(bare());
    now.marks = {{0, 1, 1, 0.7f}, {0, 2, 2, 0.1f}};
    const DrawList list = drawn(now);
    EXPECT_GT(list.rings[0].colour.w, list.rings[1].colour.w);
}

TEST(DrawWorld, RepeatsZonesAtTheOppositeEdgeOfATorus) {
    auto scene = bare();
    scene->zones = {{.name = "ice", .x = 9, .length = 4, .width = 4, .surface = Surface::ice}};
    EXPECT_EQ(count(drawn(hand_made::empty(scene)), Pattern::ice), 1);
    scene->arena.edge = Boundary::torus;
    const DrawList list = drawn(hand_made::empty(scene));
    ASSERT_EQ(count(list, Pattern::ice), 2);
    EXPECT_EQ(list.zones[1].place.x, -11);
    scene->zones[0].x = 5;
    EXPECT_EQ(count(drawn(hand_made::empty(scene)), Pattern::ice), 1) << "it is inside";
}

TEST(DrawWorld, RepeatsObjectsAtTheOppositeEdgeOfATorus) {
    auto scene = bare();
    scene->arena.edge = Boundary::torus;
    for (Sensor& eye : scene->kinds[0].sensors) eye.range = 3;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 9.8f, 0, 0);
    DrawList list = drawn(now);
    ASSERT_EQ(list.bodies[0].size(), 2U);
    EXPECT_NEAR(list.bodies[0][1].place.x, -10.2f, 1e-4);
    EXPECT_EQ(list.fields.size(), 4U);
    now.vehicles[0].x = 8;  // the body is inside, but its fields cross the edge
    list = drawn(now);
    EXPECT_EQ(list.bodies[0].size(), 1U);
    EXPECT_EQ(list.fields.size(), 4U);
    now.vehicles[0].x = 0;
    EXPECT_EQ(drawn(now).fields.size(), 2U);
    scene->arena.edge = Boundary::wall;
    now.vehicles[0].x = 9.8f;
    EXPECT_EQ(drawn(now).bodies[0].size(), 1U);
}

TEST(DrawWorld, HasOneRingAroundAVehicleThatReachesOverTheEdgeOfATorus) {
    auto scene = bare();
    scene->arena.edge = Boundary::torus;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 9.8f, 0, 0);
    Picture picture;
    picture.settings.selection.vehicle = now.vehicles[0].id;
    const DrawList list = drawn(now, picture);
    ASSERT_EQ(list.rings.size(), 1U);
    EXPECT_NEAR(list.rings[0].place.x, 9.8f, 1e-4);
}

TEST(DrawWorld, AnObstacleHasTheSameShapeAtEveryQuality) {
    auto scene = bare();
    scene->obstacles.push_back({.name = "post", .length = 0.2f, .width = 0.2f});
    const Snapshot now = hand_made::empty(scene);
    Picture low, high;
    low.quality = Quality::low, high.quality = Quality::high;
    const BlockInstance plain = drawn(now, low).blocks.at(0), fine = drawn(now, high).blocks.at(0);
    EXPECT_EQ(plain.size.y, fine.size.y);
    EXPECT_EQ(plain.size.z, fine.size.z);
    EXPECT_EQ(plain.corners[0].x, fine.corners[0].x);
}

}  // namespace
}  // namespace braitenlab::tests::draw_world_test
