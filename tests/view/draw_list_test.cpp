#include "render/view/draw_list.h"

#include <gtest/gtest.h>

#include "tests/view/drawn.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::draw_list_test {
namespace {

using namespace render;

TEST(DrawList, SortsHullsByRole) {
    Snapshot now = hand_made::empty(hand_made::scene());
    for (const int kind : {0, 1, 1, 2, 2, 2}) hand_made::add(now, kind, 0, 0, 0);
    const DrawList list = drawn(now);
    EXPECT_EQ(list.hulls[0].size(), 1U);
    EXPECT_EQ(list.hulls[1].size(), 2U);
    EXPECT_EQ(list.hulls[2].size(), 3U);
    EXPECT_EQ(list.wheels.size(), 24U);
    EXPECT_EQ(list.eyes.size(), 12U);
}

TEST(DrawList, PutsTheLeftEyeOnTheLeft) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 2, 3, maths::pi / 2);  // faces +y, so its left is −x
    const DrawList list = drawn(now);
    EXPECT_NEAR(list.eyeballs[0].place.x, 2 - 0.24f, 1e-5);
    EXPECT_NEAR(list.eyeballs[0].place.y, 3 + 0.30f, 1e-5);
    EXPECT_LT(list.eyeballs[0].place.z, 0);  // and points outwards
}

TEST(DrawList, ShowsABiteAsARingAroundBothVehiclesThatGrowsUnlessMotionIsReduced) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, 2, 3, 0), hand_made::add(now, 2, 2.5f, 3, 0), hand_made::add(now, 2, 9, 9, 0);
    EXPECT_TRUE(drawn(now).rings.empty());
    const auto rings_at = [&](float age, bool reduce_motion) {
        now.bites = {{0, 1, age}};
        Picture picture;
        picture.reduce_motion = reduce_motion;
        return drawn(now, picture).rings;
    };
    const auto early = rings_at(0.05f, false), late = rings_at(0.4f, false);
    ASSERT_EQ(early.size(), 2U);
    EXPECT_EQ(early[0].place.x, 2);
    EXPECT_EQ(early[1].place.x, 2.5f);
    EXPECT_LT(early[0].shape.x, late[0].shape.x);
    EXPECT_GT(early[0].colour.w, late[0].colour.w) << "it fades";
    EXPECT_EQ(rings_at(0.05f, true)[0].shape.x, rings_at(0.4f, true)[0].shape.x);
    EXPECT_EQ(rings_at(0.4f, true)[0].colour.w, 1);
    EXPECT_TRUE(rings_at(0.9f, false).empty());
    EXPECT_TRUE(rings_at(0.9f, true).empty());
    now.vehicles.pop_back(), now.vehicles.pop_back();
    EXPECT_EQ(rings_at(0.1f, false).size(), 1U) << "the other one has died";
}

TEST(DrawList, ShowsAStrikeAsARingAroundThePointOfContactThatGrowsUnlessMotionIsReduced) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, 2, 3, 0);
    const auto rings_at = [&](float age, bool reduce_motion) {
        now.strikes = {{0, 2.4f, 3, age}};
        Picture picture;
        picture.reduce_motion = reduce_motion;
        return drawn(now, picture).rings;
    };
    const auto early = rings_at(0.05f, false), late = rings_at(0.4f, false);
    ASSERT_EQ(early.size(), 1U);
    EXPECT_EQ(early[0].place.x, 2.4f);
    EXPECT_LT(early[0].shape.x, late[0].shape.x);
    EXPECT_GT(early[0].colour.w, late[0].colour.w) << "it fades";
    EXPECT_EQ(rings_at(0.05f, true)[0].shape.x, rings_at(0.4f, true)[0].shape.x);
    EXPECT_TRUE(rings_at(0.9f, true).empty());
}

TEST(DrawList, FlashesWhereTwoVehiclesTouchUnlessTheyBiteOrMotionIsReduced) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, 2, 3, 0);
    hand_made::add(now, 1, 3, 3, 0);
    now.strikes = {{0, 2.5f, 3, 0.05f, 1}};
    Picture picture;
    const auto flash = drawn(now, picture).rings;
    ASSERT_EQ(flash.size(), 1U);
    EXPECT_EQ(flash[0].place.x, 2.5f);
    now.strikes[0].age = 0.2f;
    EXPECT_LT(drawn(now, picture).rings.at(0).colour.w, flash[0].colour.w) << "it fades";
    picture.reduce_motion = true;
    EXPECT_TRUE(drawn(now, picture).rings.empty());
    picture.reduce_motion = false;
    now.strikes[0].age = 0.4f;
    EXPECT_TRUE(drawn(now, picture).rings.empty()) << "it is short";
    now.strikes[0].age = 0.05f;
    now.bites = {{0, 1, 0.05f}};
    EXPECT_EQ(drawn(now, picture).rings.size(), 2U) << "the rings of the bite only";
}

TEST(DrawList, DrawsNoWireOfWeightZero) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);  // two crossed wires, two of weight 0
    EXPECT_EQ(wires_of(drawn(now)).size(), 2U);
}

TEST(DrawList, CrossesCrossedWiresAndKeepsStraightOnesOnTheirSide) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    for (const WireInstance& wire : drawn(now).wires) EXPECT_LT(wire.ends.y * wire.ends.w, 0);
    now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 2, 0, 0, 0);
    for (const WireInstance& wire : drawn(now).wires) EXPECT_GT(wire.ends.y * wire.ends.w, 0);
}

TEST(DrawList, DistinguishesExcitingFromInhibitingWiresAndShowsTheirSignals) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, 0, 0, 0, 0.5f, 0);
    const auto wires = wires_of(drawn(now));
    ASSERT_EQ(wires.size(), 4U);
    int exciting = 0;
    for (const WireInstance& wire : wires) exciting += wire.colour.w > 0;
    EXPECT_EQ(exciting, 2);
    EXPECT_NEAR(wires[0].signal.x, 0.2f, 1e-5);   // reading 0.5 on the left, weight −0.4
    EXPECT_NEAR(wires[2].signal.x, 0.75f, 1e-5);  // weight 1.5
    EXPECT_EQ(wires[1].signal.x, 0);
    EXPECT_GT(wires[2].shape.w, wires[0].shape.w);
}

Picture seen_at_zoom(float zoom, Quality quality = Picture{}.quality) {
    Camera camera;
    camera.zoom = zoom;
    const Rect window{0, 0, 1280, 800};
    Picture picture;
    picture.camera_view = look(camera, Arena{}, nullptr, window, window);
    picture.quality = quality;
    return picture;
}

TEST(DrawList, ShowsASmallVehicleAsItsHullAndADotASide) {
    auto scene = hand_made::scene();
    auto& sensors = scene->kinds[0].sensors;
    sensors.push_back(sensors[0]);
    sensors[2].channel = Channel::heat;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 0, 0, 0, 0.1f, 0.2f);
    now.sensed.push_back(0.64f);
    hand_made::add_others(now);
    const DrawList far = drawn(now, seen_at_zoom(0.8f)), near = drawn(now, seen_at_zoom(4));
    EXPECT_EQ(far.hulls[0][0].look.x, 0);
    EXPECT_EQ(far.wheels.size(), 2U);
    EXPECT_TRUE(far.wires.empty());
    ASSERT_EQ(far.eyes.size(), 2U);
    EXPECT_NEAR(far.eyes[0].size.z, 0.8f, 1e-5);  // of the eye with the highest reading
    EXPECT_EQ(far.eyes[0].colour.x, colour_of(palette(Theme::dark), Channel::heat).r);
    EXPECT_EQ(near.hulls[0][0].look.x, 1);
    EXPECT_EQ(near.wheels.size(), 4U);
    EXPECT_EQ(near.wires.size(), 2U);
    EXPECT_EQ(near.eyes.size(), 3U);
}

TEST(DrawList, ShowsATinyVehicleAsASignWithRoleAndReadings) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 2, 1, 2, maths::pi / 2, 0.25f, 0.81f);
    const DrawList list = drawn(now, seen_at_zoom(0.3f));
    EXPECT_TRUE(list.hulls[2].empty() && list.wheels.empty() && list.eyes.empty() && list.wires.empty());
    ASSERT_EQ(list.signs[2].size(), 1U);
    const SignInstance& sign = list.signs[2][0];
    EXPECT_EQ(sign.place.x, 1);
    EXPECT_EQ(sign.place.y, 2);
    EXPECT_NEAR(sign.place.w, 1, 1e-5);  // ahead is +y
    EXPECT_NEAR(sign.seen.x, 0.5f, 1e-5);
    EXPECT_NEAR(sign.seen.y, 0.9f, 1e-5);
    EXPECT_LT(sign.size.w, 18);
    EXPECT_TRUE(drawn(now, seen_at_zoom(2)).signs[2].empty());
}

TEST(DrawList, OmitsVehiclesOutsideThePicture) {
    Snapshot now = hand_made::empty(hand_made::scene());
    for (const float x : {0.0f, 9.5f}) hand_made::add(now, 0, x, 0, 0);
    hand_made::add_others(now);
    EXPECT_EQ(drawn(now, seen_at_zoom(1)).hulls[0].size(), 2U);
    EXPECT_EQ(drawn(now, seen_at_zoom(6)).hulls[0].size(), 1U);
    EXPECT_EQ(drawn(now, seen_at_zoom(6)).wheels.size(), 4U);
}

TEST(DrawList, GrowsSmallPartsWithTheVehiclesSizeOnTheScreen) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    hand_made::add_others(now);
    float detail = 0, width = 0, largest_step = 0;
    for (float zoom = 0.8f; zoom < 4; zoom *= 1.01f) {
        const DrawList list = drawn(now, seen_at_zoom(zoom));
        const float next = list.hulls[0][0].look.x, wide = list.wires.empty() ? 0 : list.wires[0].shape.w;
        EXPECT_GE(next, detail);
        EXPECT_GE(wide, width);
        largest_step = std::max(largest_step, next - detail);
        detail = next, width = wide;
    }
    EXPECT_EQ(detail, 1);
    EXPECT_LT(largest_step, 0.08f);
}

TEST(DrawList, CablesThatAreWholeCastAShadowOnTheDeckWhereTheyAreLarge) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    const auto shadows = [&](float zoom) {
        const DrawList list = drawn(now, seen_at_zoom(zoom, Quality::high));
        EXPECT_FALSE(list.bodies[0].empty());
        return std::count_if(list.wires.begin(), list.wires.end(),
                             [](const WireInstance& wire) { return wire.colour.w == 0 && wire.signal.z == 0; });
    };
    EXPECT_EQ(shadows(6), 2);
    EXPECT_EQ(shadows(1), 0);
    auto brain = std::make_shared<BrainGraph>(*now.brains[0]);
    for (Wire& wire : brain->wires) wire.cut = true;
    now.brains[0] = brain;
    EXPECT_EQ(shadows(6), 0) << "the ends of a cut cable are pale";
}

TEST(DrawList, EyesShadeTheDeckInsideTheBodyWhereTheyAreLarge) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    const auto shades = [&](float zoom) { return drawn(now, seen_at_zoom(zoom, Quality::high)).deck_shades; };
    EXPECT_TRUE(shades(1).empty());
    const auto large = shades(6);
    ASSERT_EQ(large.size(), 2U);
    const Body& body = now.scene->kinds[0].body;
    for (const DeckShadeInstance& shade : large) {
        EXPECT_LT(std::fabs(shade.place.y) + deck_shade_core * shade.place.w, 0.38f * body.width);
        EXPECT_LT(shade.place.x + deck_shade_core * shade.place.w, 0.5f * body.length);
        EXPECT_GT(shade.colour.w, 0.2f);
    }
    EXPECT_GT(large[0].place.y, 0.05f) << "each below its eye";
    EXPECT_LT(large[1].place.y, -0.05f);
}

TEST(DrawList, EyesOfASmallRobotShadeTheMiddleOfItsDeck) {
    auto scene = hand_made::scene();
    Kind& robot = scene->kinds[0];
    robot.body.length = robot.body.width = 0.071f;  // m; the eyes are as wide as the body
    for (Sensor& sensor : robot.sensors) sensor.x = 0.03f, sensor.y *= 0.12f;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 0, 0, 0);
    Picture picture;
    picture.quality = Quality::high;
    const DrawList list = drawn(now, picture);
    ASSERT_EQ(list.deck_shades.size(), 2U);
    EXPECT_GE(list.deck_shades[0].place.y, 0) << "on the side of its eye";
    EXPECT_LE(list.deck_shades[1].place.y, 0);
    for (const DeckShadeInstance& shade : list.deck_shades) EXPECT_LT(std::fabs(shade.place.y), 0.0355f);
}

TEST(DrawList, DrawsRoundedVehiclesWhereTheyAreLargeUnlessTheQualityIsLow) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0, 0.25f, 0);
    const auto rounded = [&](Quality quality, float zoom, VehicleId selected = no_vehicle) {
        Picture picture = seen_at_zoom(zoom);
        picture.quality = quality, picture.settings.selection.vehicle = selected;
        const DrawList list = drawn(now, picture);
        EXPECT_EQ(list.bodies[0].size() + list.hulls[0].size() + list.signs[0].size(), 1U);
        EXPECT_EQ(list.eyeballs.size(), 2 * list.bodies[0].size());
        EXPECT_EQ(list.tyres.size(), 4 * list.bodies[0].size());
        if (!list.bodies[0].empty()) {
            const auto cables = std::count_if(list.wires.begin(), list.wires.end(),
                                              [](const WireInstance& wire) { return wire.colour.w != 0; });
            EXPECT_EQ(cables, 2) << "a rounded vehicle has its wires";
            EXPECT_TRUE(list.eyes.empty() && list.wheels.empty());
            EXPECT_NEAR(list.eyeballs[0].size.z, 0.5f, 1e-5);
        }
        return !list.bodies[0].empty();
    };
    EXPECT_TRUE(rounded(Quality::low, 4)) << "of few vehicles all look alike";
    EXPECT_FALSE(rounded(Quality::low, 0.7f));
    hand_made::add_others(now);
    EXPECT_FALSE(rounded(Quality::low, 4));
    EXPECT_TRUE(rounded(Quality::low, 4, 0)) << "the selected vehicle keeps its eyes";
    EXPECT_TRUE(rounded(Quality::medium, 4));
    EXPECT_FALSE(rounded(Quality::medium, 0.7f));
    EXPECT_TRUE(rounded(Quality::high, 0.7f));
    EXPECT_FALSE(rounded(Quality::medium, 0.7f, 0)) << "a small one has the pale rim of the others";
    EXPECT_FALSE(rounded(Quality::low, 0.7f, 0));
}

TEST(DrawList, NeedsFullMeshesOnlyWhereAPlainVehicleIsLarge) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    hand_made::add_others(now);
    EXPECT_TRUE(drawn(now, seen_at_zoom(1)).coarse);
    EXPECT_FALSE(drawn(now, seen_at_zoom(4)).coarse);
    Picture dense = seen_at_zoom(4);
    dense.pixel_scale = 4;
    EXPECT_FALSE(drawn(now, dense).coarse) << "display pixels count";
    Picture rounded = seen_at_zoom(4);
    rounded.settings.selection.vehicle = 0;
    EXPECT_TRUE(drawn(now, rounded).coarse) << "rounded meshes do not count";
    EXPECT_EQ(drawn(now, seen_at_zoom(1)).wheels.size(), 2U) << "castors are hidden below the hull";
}

TEST(DrawList, GivesVehiclesOfSimilarSizeTheSameMeshes) {
    Snapshot now = hand_made::empty(hand_made::scene());
    for (const float y : {-9.0f, 9.0f}) hand_made::add(now, 0, 0, y, 0);  // the near one is larger
    int plain = 0, rounded = 0;
    for (float zoom = 0.6f; zoom < 1.45f; zoom += 0.02f) {
        Picture picture = seen_at_zoom(zoom);
        picture.quality = Quality::medium;
        const DrawList list = drawn(now, picture);
        EXPECT_NE(list.bodies[0].size(), 1U) << zoom;
        (list.bodies[0].empty() ? plain : rounded) += 1;
    }
    EXPECT_GT(plain, 3);
    EXPECT_GT(rounded, 3);
}

TEST(DrawList, DrawsSignsOfAllVehiclesOfSimilarSizeOrOfNone) {
    auto scene = hand_made::scene();
    scene->kinds[0].body = resized(scene->kinds[0].body, 0.9f, 0.6f);
    Snapshot now = hand_made::empty(scene);
    for (const float y : {-9.0f, 9.0f}) hand_made::add(now, 0, 0, y, 0);  // the near one is larger
    for (const Quality quality : {Quality::medium, Quality::high}) {
        int signs = 0, solid = 0;
        for (float zoom = 0.2f; zoom < 1.0f; zoom *= 1.03f) {
            Picture picture = seen_at_zoom(zoom);
            picture.quality = quality;
            const std::size_t count = drawn(now, picture).signs[0].size();
            EXPECT_NE(count, 1U) << zoom;
            (count == 0 ? solid : signs) += 1;
        }
        EXPECT_GT(signs, 3);
        EXPECT_GT(solid, 3);
    }
}

TEST(DrawList, GivesASmallRoundedVehicleOneLargeEyeASideUnlessItIsSelected) {
    auto scene = hand_made::scene();
    const std::size_t pair = scene->kinds[0].sensors.size();
    ASSERT_EQ(pair, 2U);
    for (std::size_t i = 0; i < pair; ++i) {
        Sensor beside = scene->kinds[0].sensors[i];
        beside.name += "2", beside.channel = Channel::heat, beside.x -= 0.1f;
        scene->kinds[0].sensors.push_back(beside);
    }
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 0, 0, 0);
    now.sensed = {0, 0, 0.64f, 0};
    const auto eyes = [&](float zoom, VehicleId selected = no_vehicle) {
        Picture picture = seen_at_zoom(zoom);
        picture.quality = Quality::high, picture.settings.selection.vehicle = selected;
        return drawn(now, picture).eyeballs;
    };
    const auto small = eyes(0.8f), large = eyes(4), selected = eyes(0.8f, 0);
    ASSERT_EQ(small.size(), 2U);
    EXPECT_EQ(large.size(), 4U);
    EXPECT_EQ(selected.size(), 4U);
    EXPECT_GT(small[0].size.x, 1.5f * large[0].size.x);
    EXPECT_NEAR(small[0].size.z, 0.8f, 1e-5) << "the strongest reading of the side";
    EXPECT_EQ(small[0].colour.x, colour_of(palette(Theme::dark), Channel::heat).r);
}

TEST(DrawList, CastsShadowsAwayFromLampsInRange) {
    auto scene = hand_made::scene();
    scene->obstacles.push_back({.name = "box", .x = 3, .length = 2, .width = 1});
    for (Kind& kind : scene->kinds)
        for (Sensor& eye : kind.sensors) eye.range = 6, eye.half_distance = 2, eye.channel = Channel::light;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 1, 0, 0);
    hand_made::add_source(now, Channel::light, 0, 2);
    hand_made::add_source(now, Channel::light, -9, 9);  // beyond the sensors' range
    Picture picture;
    EXPECT_TRUE(drawn(now, picture).casts.empty()) << "low quality: contact shadows only";
    EXPECT_EQ(drawn(now, picture).floor_lamps, 2) << "the colour of the floor is that of the other levels";
    picture.quality = Quality::medium;
    const DrawList list = drawn(now, picture);
    EXPECT_EQ(list.law.range, 6);
    EXPECT_EQ(list.law.half_distance, 2);
    EXPECT_EQ(list.floor_lamps, 2);
    ASSERT_EQ(list.casts.size(), 2U) << "the box and the vehicle, from the near lamp";
    for (const CastInstance& cast : list.casts) EXPECT_EQ(cast.lamp.y, 2);
    EXPECT_EQ(list.casts[0].shape.x, 1) << "half the length of the box";
    for (const MarkInstance& mark : list.marks)
        EXPECT_EQ(mark.shape.w, static_cast<float>(MarkKind::shadow)) << "the floor's shader draws the light";
}

TEST(DrawList, DarkensBodiesBehindBoxes) {
    auto scene = hand_made::scene();
    scene->obstacles.push_back({.name = "box", .x = 3, .length = 0.5f, .width = 3});
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 1.5f, 0, 0);   // between the first lamp and the box
    hand_made::add(now, 0, 4.2f, 0, 0);   // behind the box for the first lamp, in front of it for the second one
    hand_made::add(now, 0, 4.2f, -5, 0);  // beside the shadow
    hand_made::add_source(now, Channel::light, 0, 0);
    hand_made::add_source(now, Channel::light, 6.5f, 0);
    Picture picture;
    picture.quality = Quality::high;
    const DrawList list = drawn(now, picture);
    ASSERT_EQ(list.bodies[0].size(), 3U);
    EXPECT_EQ(list.bodies[0][0].look.z, 56) << "all light of the second lamp is taken: 7 · 8; none of the first";
    EXPECT_EQ(list.bodies[0][1].look.z, 7) << "all light of the first lamp";
    EXPECT_EQ(list.bodies[0][2].look.z, 0);
    for (const EyeballInstance& eye : list.eyeballs) EXPECT_EQ(eye.size.w, 0) << "it is higher than the box's shadow";
}

TEST(DrawList, AVehicleDarkensTheFloorBesideItAndNoOtherVehicle) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 2, 0, 0);
    hand_made::add(now, 0, 3.2f, 0, 0);  // behind the first one
    hand_made::add_source(now, Channel::light, 0, 0);
    Picture picture;
    picture.quality = Quality::high;
    const DrawList list = drawn(now, picture);
    ASSERT_EQ(list.casts.size(), 2U);
    for (const CastInstance& cast : list.casts) EXPECT_LT(cast.shape.z, 0.15f * cast.lamp.z);
    for (const HullInstance& body : list.bodies[0]) EXPECT_EQ(body.look.z, 0);
    for (const EyeballInstance& eye : list.eyeballs) EXPECT_EQ(eye.size.w, 0);
}

TEST(DrawList, DrawsPoolsOfLightForManyLampsAtLowQuality) {
    Snapshot now = hand_made::empty(hand_made::scene());
    for (int i = 0; i < 4; ++i) hand_made::add_source(now, Channel::light, static_cast<float>(i), 0);
    const auto pools = [](const DrawList& list) {
        return std::count_if(list.marks.begin(), list.marks.end(), [](const MarkInstance& mark) {
            return mark.shape.w == static_cast<float>(MarkKind::pool);
        });
    };
    Picture picture;
    EXPECT_EQ(pools(drawn(now, picture)), 4);
    EXPECT_EQ(drawn(now, picture).floor_lamps, 0);
    picture.quality = Quality::medium;
    EXPECT_EQ(pools(drawn(now, picture)), 0);
}

TEST(DrawList, ShakesAVehicleThatStrikesAndLightsThePointUnlessMotionIsReduced) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, 2, 3, 0);
    hand_made::add(now, 1, 8, 3, 0);
    now.strikes = {{0, 2.4f, 3, 0.01f}};
    Picture picture;
    picture.quality = Quality::medium;
    const auto places = [&] {
        const DrawList list = drawn(now, picture);
        std::vector<float> x;
        for (const MarkInstance& mark : list.marks) x.push_back(mark.place.x);
        return std::pair{x, list.halos.size()};
    };
    const auto [struck, lit] = places();
    now.strikes[0].age = 0.3f;
    const auto [calm, dark] = places();
    ASSERT_EQ(struck.size(), calm.size());
    EXPECT_LT(struck[0], calm[0] - 0.02f) << "it is thrown back";
    EXPECT_GT(struck[0], calm[0] - 0.08f);
    EXPECT_EQ(struck.back(), calm.back()) << "the other vehicle stays";
    EXPECT_EQ(lit, dark + 1);
    now.strikes[0].age = 0.01f, picture.reduce_motion = true;
    EXPECT_EQ(places(), std::pair(calm, dark));
}

TEST(DrawList, JudgesSizeInLayoutPixels) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    hand_made::add_others(now);
    Picture picture = seen_at_zoom(1.3f);
    const float before = drawn(now, picture).hulls[0][0].look.x;
    picture.pixel_scale = 2;
    EXPECT_GT(before, 0);
    EXPECT_EQ(drawn(now, picture).hulls[0][0].look.x, 0);
}

TEST(DrawList, ShowsAStimulatedFieldStronger) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0, 0.6f, 0);
    const DrawList list = drawn(now);
    ASSERT_EQ(list.fields.size(), 2U);
    EXPECT_GT(list.fields[0].colour.w, 2 * list.fields[1].colour.w);
}

TEST(DrawList, DrawsFieldsAndOutlinesOnlyIfTheyAreSwitchedOn) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    Picture picture;
    picture.settings.sensors = false;
    EXPECT_TRUE(drawn(now, picture).fields.empty());
    picture.settings.outlines = true;
    const DrawList outlined = drawn(now, picture);
    ASSERT_EQ(outlined.fields.size(), 2U);
    EXPECT_EQ(outlined.fields[0].colour.w, 0);
    EXPECT_GT(outlined.fields[0].line.x, 0);
    EXPECT_GE(outlined.fields[0].shape.x, 12);  // the whole range
}

TEST(DrawList, OmitsThePartsOfTheVehicleInDriverMode) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const VehicleId driver = hand_made::add(now, 0, 0, 0, 0);
    hand_made::add(now, 0, 5, 0, 0);
    Picture picture;
    picture.settings.sensors = picture.settings.outlines = false, picture.driver = driver;
    const DrawList list = drawn(now, picture);
    ASSERT_EQ(list.fields.size(), 2U);
    for (const FieldInstance& field : list.fields) EXPECT_GT(field.line.x, 0);
    // Only the eyes of the other vehicle: those of the driver would cover the picture.
    EXPECT_EQ(list.eyeballs.size(), 2U);
    picture.driver = no_vehicle;
    EXPECT_EQ(2 * list.wires.size(), drawn(now, picture).wires.size());
    EXPECT_FALSE(list.wires.empty());
}

TEST(DrawList, ShrinksSensorsThatAreCloseTogether) {
    auto scene = hand_made::scene();
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 0, 0, 0);
    const float alone = drawn(now).eyeballs[0].size.x;
    scene->kinds[0].sensors.push_back(scene->kinds[0].sensors[0]);
    scene->kinds[0].sensors[2].y += 0.1f;
    EXPECT_LT(drawn(now).eyeballs[0].size.x, alone);
    EXPECT_EQ(drawn(now).eyeballs[1].size.x, alone);
}

TEST(DrawList, ShortensFieldsOfManyVehicles) {
    Snapshot few = hand_made::empty(hand_made::scene()), many = few;
    hand_made::add(few, 0, 0, 0, 0);
    for (int i = 0; i < 300; ++i) hand_made::add(many, 0, 0, 0, 0);
    EXPECT_LT(drawn(many).fields[0].shape.x, drawn(few).fields[0].shape.x / 2);
}

TEST(DrawList, FadesIdleFieldsOfManyVehiclesExceptTheSelectedOne) {
    Snapshot few = hand_made::empty(hand_made::scene()), many = few;
    hand_made::add(few, 0, 0, 0, 0);
    for (int i = 0; i < 30; ++i) hand_made::add(many, 0, 0, 0, 0);
    EXPECT_LT(drawn(many).fields[0].colour.w, drawn(few).fields[0].colour.w / 2);
    Picture picture;
    picture.settings.selection.vehicle = picture.hovered = 0;
    EXPECT_EQ(drawn(many, picture).fields[0].colour.w, drawn(few, picture).fields[0].colour.w);
    picture.settings.selection.vehicle = no_vehicle;
    EXPECT_EQ(drawn(many, picture).fields[0].colour.w, drawn(few, picture).fields[0].colour.w);
}

TEST(DrawList, DrawsARingOnlyAroundTheSelectedVehicle) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0);
    const VehicleId chosen = hand_made::add(now, 0, 4, 5, 0);
    EXPECT_TRUE(drawn(now).rings.empty());
    Picture picture;
    picture.settings.selection.vehicle = chosen;
    const DrawList list = drawn(now, picture);
    ASSERT_EQ(list.rings.size(), 1U);
    EXPECT_EQ(list.rings[0].place.x, 4);
}

TEST(DrawList, DrawsAThinRingWhenAnObjectIsSelectedToo) {
    Snapshot now = hand_made::empty(hand_made::scene());
    Picture picture;
    picture.settings.selection.vehicle = hand_made::add(now, 0, 4, 5, 0);
    const auto alone = drawn(now, picture).rings;
    picture.settings.selection.object = {SceneObjectKind::source, 0};
    const auto beside = drawn(now, picture).rings;
    ASSERT_EQ(alone.size(), 1U);
    ASSERT_EQ(beside.size(), 1U) << "its brain is still the one that is shown";
    EXPECT_LT(beside[0].shape.z, alone[0].shape.z);
    EXPECT_NE(beside[0].colour.x, alone[0].colour.x);
}

TEST(DrawList, BuildsWallsOnlyWhereTheArenaHasThem) {
    auto open = hand_made::scene();
    open->arena.edge = Boundary::open;
    EXPECT_EQ(drawn(hand_made::empty(hand_made::scene())).blocks.size(), 4U);
    EXPECT_TRUE(drawn(hand_made::empty(open)).blocks.empty());
}

TEST(DrawList, LightsTheSceneWithAtMostEightLamps) {
    Snapshot now = hand_made::empty(hand_made::scene());
    for (int i = 0; i < 12; ++i) hand_made::add_source(now, Channel::light, static_cast<float>(i), 0);
    const DrawList list = drawn(now);
    EXPECT_EQ(list.lamps.size(), most_lamps);
    EXPECT_EQ(list.sources[0].size(), 12U);
}

TEST(DrawList, GivesEveryChannelAUniqueShape) {
    Snapshot now = hand_made::empty(hand_made::scene());
    for (const Channel c : {Channel::light, Channel::heat, Channel::smell, Channel::oxygen})
        hand_made::add_source(now, c, 0, 0);
    for (const auto& sources : drawn(now).sources) EXPECT_EQ(sources.size(), 1U);
}

TEST(DrawList, ReplacesItsContentWithEveryFill) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, 0, 0, 0);
    DrawList list;
    fill(list, now, {}, Trails{});
    fill(list, now, {}, Trails{});
    EXPECT_EQ(list.bodies[1].size(), 1U);
    EXPECT_EQ(list.fields.size(), 2U);
}

}  // namespace
}  // namespace braitenlab::tests::draw_list_test
