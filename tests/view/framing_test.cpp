#include "render/view/framing.h"

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "render/view/label_space.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::framing_test {
namespace {

using maths::vec2;

const Rect window{0, 0, 1280, 800}, free_area{336, 84, 576, 610};

FramingInput input(VehicleId selected = 0) {
    FramingInput in;
    in.selected = selected, in.window = window, in.free_area = free_area;
    return in;
}

bool holds(const FloorBox& box, vec2 p) {
    return p.x > box.low.x && p.x < box.high.x && p.y > box.low.y && p.y < box.high.y;
}

TEST(Framing, FramesVehiclesSourcesAndTheObstaclesNearThem) {
    auto scene = hand_made::scene();
    scene->obstacles.push_back({.name = "near", .x = -2, .y = -1.5f, .length = 1, .width = 1});
    scene->obstacles.push_back({.name = "far", .x = 8, .y = -8, .length = 1, .width = 1});
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, -4, 0, 0);
    hand_made::add_source(now, Channel::light, 3, 2);
    const FloorBox box = action_of(now);
    for (const vec2 p : {vec2{-4.8f, 0}, {3.9f, 2.9f}, {-2.4f, -1.9f}}) EXPECT_TRUE(holds(box, p)) << p;
    EXPECT_FALSE(holds(box, {8, -8}));
    now.vehicles[0].x = -9.9f;
    EXPECT_GE(action_of(now).low.x, -10.3f) << "no further than the walls";
    now.vehicles.clear(), now.sources.clear();
    EXPECT_EQ(action_of(now), (FloorBox{{-10, -10}, {10, 10}})) << "an empty arena is shown whole";
    hand_made::add(now, 0, -4, 0, 0);
    EXPECT_EQ(action_of(now), (FloorBox{{-10, -10}, {10, 10}})) << "without sources the floor is the aim";
}

TEST(Framing, FramesACloseUpInPlaceOfTheActionAndReturns) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -4, 0, 0);
    Framing framing;
    const FloorBox action = framing.follow(now, input());
    FramingInput close = input();
    close.close_up = FloorBox{{-5, -1}, {-1, 2}};
    const FloorBox shown = framing.follow(now, close);
    EXPECT_TRUE(holds(shown, {-4.9f, -0.9f}));
    EXPECT_TRUE(holds(shown, {-1.1f, 1.9f}));
    EXPECT_LT(shown.high.x - shown.low.x, 0.6f * (action.high.x - action.low.x));
    EXPECT_EQ(framing.follow(now, input()), action);
}

// The share of the free area's width and height that the box's picture takes.
vec2 share_of(const FloorBox& box, const Arena& arena, const FramingInput& in) {
    const CameraView seen = look(in.camera, arena, nullptr, in.window, in.free_area, &box);
    vec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
    for (const vec2 corner : {box.low, box.high, vec2{box.low.x, box.high.y}, vec2{box.high.x, box.low.y}}) {
        const auto at = project(seen, corner);
        EXPECT_TRUE(at);
        EXPECT_TRUE(in.free_area.contains(at->x, at->y)) << *at;
        low = {std::min(low.x, at->x), std::min(low.y, at->y)};
        high = {std::max(high.x, at->x), std::max(high.y, at->y)};
    }
    return {(high.x - low.x) / in.free_area.w, (high.y - low.y) / in.free_area.h};
}

TEST(Framing, FillsTheFreeAreaWithATableAsWithALargeArena) {
    for (const float side : {1.0f, 2.0f, 20.0f}) {
        auto scene = hand_made::scene();
        scene->arena.width = scene->arena.height = side;
        scene->kinds[0].body = resized(scene->kinds[0].body, side / 20, side / 30);
        Snapshot now = hand_made::empty(scene);
        hand_made::add(now, 0, 0, 0, 0);
        Framing framing;
        const vec2 share = share_of(framing.follow(now, input()), scene->arena, input());
        EXPECT_GT(std::max(share.x, share.y), 0.6f) << side;
    }
}

TEST(Framing, ShowsAllOfATableOnWhichTheRobotIsLargeEnough) {
    auto scene = hand_made::scene();
    scene->arena.width = scene->arena.height = 2;
    const auto box_for = [&](float length) {
        scene->kinds[0].body = resized(scene->kinds[0].body, length, length);
        Snapshot now = hand_made::empty(scene);
        hand_made::add(now, 0, -0.5f, 0, 0);
        Framing framing;
        return framing.follow(now, input());
    };
    const FloorBox large = box_for(0.09f), small = box_for(0.04f);
    EXPECT_LE(large.low.x, -1);
    EXPECT_LE(large.low.y, -1);
    EXPECT_GE(large.high.x, 1);
    EXPECT_GE(large.high.y, 1);
    EXPECT_LT(small.high.x - small.low.x, 1.9f) << "a smaller robot is shown larger than the table allows";
}

TEST(Framing, RidesASmallRobotFromAsFarAsItIsLong) {
    auto scene = hand_made::scene();
    scene->kinds[0].body = resized(scene->kinds[0].body, 0.1f, 0.07f);
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 0, 0, 0);
    EXPECT_EQ(ride_scale(now, now.vehicles.data()), 1) << "in a large arena";
    scene->arena.width = scene->arena.height = 1;
    EXPECT_FLOAT_EQ(ride_scale(now, now.vehicles.data()), 0.1f);
    EXPECT_EQ(ride_scale(now, nullptr), 1);
    Camera camera;
    camera.mode = CameraMode::follow;
    const auto eye = [&](float scale) {
        return look(camera, scene->arena, now.vehicles.data(), window, free_area, nullptr, scale).eye;
    };
    EXPECT_NEAR(maths::length(eye(0.1f)), 0.1f * maths::length(eye(1)), 1e-5f);
}

TEST(Framing, UsesThreeQuartersOfTheFreeArea) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -4, 1, 0);
    hand_made::add_source(now, Channel::light, 3, 2);
    for (const Rect area : {free_area, Rect{20, 100, 1240, 540}, Rect{300, 60, 420, 640}})
        for (const CameraMode mode : {CameraMode::overview, CameraMode::birds_eye}) {
            FramingInput in = input(no_vehicle);
            in.free_area = area, in.camera.mode = mode;
            const vec2 share = share_of(Framing{}.follow(now, in), now.scene->arena, in);
            EXPECT_GE(share.x * share.y, 0.75f) << area.w << " x " << area.h << ", mode " << static_cast<int>(mode);
        }
}

TEST(Framing, ShowsTheSelectedVehicleAtItsLeastSizeInScenesOfFewVehicles) {
    for (const float least : {0.05f, 0.08f})
        for (const vec2 place : {vec2{-19, -19}, {0, 0}, {19, 3}}) {
            auto scene = hand_made::scene();
            scene->arena.width = scene->arena.height = 40;
            Snapshot now = hand_made::empty(scene);
            hand_made::add(now, 0, place.x, place.y, 0);
            for (const float x : {-19.0f, 19.0f})
                hand_made::add_source(now, Channel::light, x, -x), hand_made::add_source(now, Channel::light, x, x);
            FramingInput in = input();
            in.least_share = least;
            Framing framing;
            const FloorBox box = framing.follow(now, in);
            const CameraView seen = look(framing.raised({}), now.scene->arena, nullptr, window, free_area, &box);
            // The nearest source, if the vehicle has half of its size with it, stays in the picture.
            const bool with_lamp = std::any_of(now.sources.begin(), now.sources.end(), [&](const SourceView& s) {
                const auto lamp = project(seen, {s.x, s.y});
                return free_area.contains(lamp->x, lamp->y);
            });
            EXPECT_GE(pixels_per_metre(seen, place), (with_lamp ? 0.5f : 0.98f) * least * free_area.w) << place;
            EXPECT_TRUE(with_lamp || place == vec2{}) << place;
            const auto at = project(seen, place);
            EXPECT_TRUE(free_area.contains(at->x, at->y)) << place;
            for (int i = 0; i < 5; ++i) hand_made::add(now, 0, place.x, place.y, 0);
            EXPECT_LT(pixels_per_metre(look({}, now.scene->arena, nullptr, window, free_area,
                                            std::make_unique<FloorBox>(Framing{}.follow(now, in)).get()),
                                       place),
                      least * free_area.w)
                << "six vehicles are all shown";
        }
}

TEST(Framing, KeepsLampsInThePictureWhereTheVehicleStaysLargeEnough) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -3, 0, 0);
    hand_made::add_source(now, Channel::light, 2, 3);
    FramingInput in = input();
    in.free_area = {16, 250, 1248, 300};  // as between the caption and the notes of a lecture
    in.least_share = 0.08f;
    const FloorBox box = Framing{}.follow(now, in);
    const CameraView seen = look({}, now.scene->arena, nullptr, window, in.free_area, &box);
    const auto lamp = project(seen, {2, 3}, 0.5f), vehicle = project(seen, {-3, 0});
    EXPECT_TRUE(in.free_area.contains(lamp->x, lamp->y)) << lamp->x << ", " << lamp->y;
    EXPECT_TRUE(in.free_area.contains(vehicle->x, vehicle->y));
    EXPECT_GE(pixels_per_metre(seen, {-3, 0}), 0.6f * in.least_share * in.free_area.w);
}

TEST(Framing, LowersTheCameraOverADeepActionAndRaisesItOverAWideOne) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, -6, 0);
    hand_made::add_source(now, Channel::light, 0, 6);
    FramingInput in = input();
    in.least_share = 0.08f;
    const auto elevation = [&](Rect area, Camera camera = {}) {
        in.free_area = area, in.camera = camera;
        Framing framing;
        framing.follow(now, in);
        return framing.raised(camera).elevation;
    };
    const Rect wide{16, 95, 1248, 499};
    EXPECT_LT(elevation(wide), 0.8f * Camera{}.elevation);
    EXPECT_GE(elevation(wide), 0.5f);
    EXPECT_FLOAT_EQ(elevation(wide, {.elevation = 1.3f}), 1.3f) << "the user's own stays";
    auto scene = hand_made::scene();
    scene->arena.height = 6;
    now = hand_made::empty(scene);
    hand_made::add(now, 0, -8, 0, 0);
    hand_made::add_source(now, Channel::light, 8, 0);
    EXPECT_GT(elevation(free_area), Camera{}.elevation);
    EXPECT_LE(elevation(free_area), 1.25f);
}

TEST(Framing, LeavesOutFartherLampsInFavourOfTheVehicleButKeepsTheNearest) {
    auto scene = hand_made::scene();
    scene->arena.width = scene->arena.height = 40;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 0, 0, 0);
    hand_made::add_source(now, Channel::light, 4, 1);
    hand_made::add_source(now, Channel::light, -18, 15);
    now.sources[1].source = 1;
    FramingInput in = input();
    in.least_share = 0.08f;
    Framing framing;
    FloorBox box = framing.follow(now, in);
    EXPECT_TRUE(holds(box, {4, 1}));
    EXPECT_FALSE(holds(box, {-18, 15}));
    now.vehicles[0].x = -15, now.vehicles[0].y = 12;
    box = framing.follow(now, in);
    EXPECT_TRUE(holds(box, {-18, 15})) << "it is now the nearest one";
    in.least_share = 0.01f;
    box = framing.follow(now, in);
    EXPECT_TRUE(holds(box, {4, 1}) && holds(box, {-18, 15})) << "a small vehicle leaves room for all";
}

TEST(Framing, KeepsTheNearestLampUntilAnotherOneIsClearlyNearer) {
    auto scene = hand_made::scene();
    scene->arena.width = scene->arena.height = 40;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, -0.5f, 0, 0);
    for (const float x : {-9.0f, 9.0f}) hand_made::add_source(now, Channel::light, x, 0);
    now.sources[1].source = 1;
    FramingInput in = input();
    in.least_share = 0.08f;
    Framing framing;
    EXPECT_TRUE(holds(framing.follow(now, in), {-9, 0}));
    now.vehicles[0].x = 0.5f;
    EXPECT_TRUE(holds(framing.follow(now, in), {-9, 0})) << "the other one is only a little nearer";
    now.vehicles[0].x = 4;
    EXPECT_TRUE(holds(framing.follow(now, in), {9, 0}));
}

TEST(Framing, RestsWhileEverythingIsInSight) {
    auto scene = hand_made::scene();
    scene->arena.width = 24, scene->arena.height = 9;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, -10, 0, 0);
    hand_made::add_source(now, Channel::light, 9, 1);
    const FramingInput in = input();
    Framing framing;
    const FloorBox first = framing.follow(now, in);
    for (int i = 1; i < 1800; ++i) {
        now.tick = static_cast<std::uint64_t>(i),
        now.vehicles[0].x = std::min(8.0f, -10 + 0.02f * static_cast<float>(i));
        ASSERT_EQ(framing.follow(now, in), first) << i << ": the floor covers little, but all is in the picture";
    }
}

TEST(Framing, KeepsTheVehicleOfTheOtherRunInThePicture) {
    auto scene = hand_made::scene();
    scene->arena.width = scene->arena.height = 40;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, -3, 0, 0);
    hand_made::add_source(now, Channel::light, 2, 3);
    FramingInput in = input();
    in.least_share = 0.08f;
    EXPECT_FALSE(holds(Framing{}.follow(now, in), {15, -12}));
    in.beside = FloorBox{{14, -13}, {16, -11}};
    const FloorBox box = Framing{}.follow(now, in);
    EXPECT_TRUE(holds(box, {15, -12}));
    EXPECT_TRUE(holds(box, {-3, 0}));
}

TEST(Framing, FramesTheLineThatAVehicleFollows) {
    auto scene = hand_made::scene();
    scene->zones.push_back({.name = "line", .x = 6, .y = 5, .length = 2, .width = 0.2f, .surface = Surface::tape});
    scene->zones.push_back({.name = "ice", .x = -8, .y = 5, .length = 2, .width = 2, .surface = Surface::ice});
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, 0, 0, 0);
    EXPECT_TRUE(holds(action_of(now), {6, 5}));
    EXPECT_FALSE(holds(action_of(now), {-8, 5}));
    scene->zones[0] = {.name = "table", .length = 8, .width = 4, .surface = Surface::tape};
    EXPECT_TRUE(holds(action_of(now), {3.9f, 0})) << "a table is shown whole";
}

TEST(Framing, ShowsAllOfFewVehiclesAlsoWhereTheSelectedOneIsSmall) {
    auto scene = hand_made::scene();
    scene->arena.width = scene->arena.height = 40;
    Snapshot now = hand_made::empty(scene);
    hand_made::add(now, 0, -19, -19, 0), hand_made::add(now, 0, 19, 19, 0);
    hand_made::add_source(now, Channel::light, 0, 0);
    FramingInput in = input();
    in.least_share = 0.08f;
    const FloorBox box = Framing{}.follow(now, in);
    for (const vec2 place : {vec2{-19, -19}, {19, 19}}) EXPECT_TRUE(holds(box, place)) << place;
}

TEST(Framing, GlidesWhenTheActionGrowsAndDoesNotShrink) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -2, 0, 0), hand_made::add_source(now, Channel::light, 2, 0);
    Framing framing;
    FramingInput in = input(no_vehicle);
    const FloorBox first = framing.follow(now, in);
    in.seconds = 1.0f / 60;
    EXPECT_EQ(framing.follow(now, in), first) << "nothing has moved";
    now.vehicles[0].x = -8;
    const FloorBox second = framing.follow(now, in);
    EXPECT_LT(second.low.x, first.low.x);
    EXPECT_GT(second.low.x, -6) << "not at once";
    for (int i = 0; i < 240; ++i) framing.follow(now, in);
    const FloorBox last = framing.follow(now, in);
    EXPECT_TRUE(holds(last, {-8, 0}));
    now.vehicles[0].x = 0;
    EXPECT_EQ(framing.follow(now, in), last) << "the path is still shown";
    framing.start_over();
    EXPECT_EQ(framing.follow(now, in), Framing{}.follow(now, in));
    EXPECT_GT(framing.follow(now, in).low.x, last.low.x);
}

TEST(Framing, ShowsThePictureOfTheStartAgainAfterAReset) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -2, 0, 0), hand_made::add_source(now, Channel::light, 2, 0);
    Framing framing;
    FramingInput in = input();
    const FloorBox first = framing.follow(now, in);
    const float elevation = framing.raised({}).elevation;
    in.seconds = 1.0f / 60;
    for (int i = 1; i <= 240; ++i) {
        now.tick = static_cast<std::uint64_t>(i);
        now.vehicles[0].y = 0.035f * static_cast<float>(i);
        framing.follow(now, in);
    }
    EXPECT_FALSE(framing.follow(now, in) == first);
    now.tick = 0, now.vehicles[0].y = 0;
    const FloorBox next = framing.follow(now, in);
    EXPECT_FALSE(next == first) << "the camera glides";
    for (int i = 0; i < 300; ++i) framing.follow(now, in);
    EXPECT_EQ(framing.follow(now, in), first);
    EXPECT_EQ(framing.raised({}).elevation, elevation);
}

TEST(Framing, LeavesTheElevationOfACameraThatTheUserHasTurned) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, -6, 0), hand_made::add_source(now, Channel::light, 0, 6);
    Framing framing;
    FramingInput in = input();
    in.least_share = 0.08f, in.free_area = {16, 95, 1248, 500};
    framing.follow(now, in);
    ASSERT_NE(framing.raised({}).elevation, Camera{}.elevation);
    orbit(in.camera, 0.5f, 0);
    ASSERT_EQ(in.camera.elevation, Camera{}.elevation);
    framing.follow(now, in);
    EXPECT_EQ(framing.raised(in.camera), in.camera);
}

TEST(Framing, RestsMostOfTheTimeWhileAVehicleLeavesTheBox) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -2, 0, 0), hand_made::add_source(now, Channel::light, 2, 0);
    Framing framing;
    FramingInput in = input(no_vehicle);
    FloorBox shown = framing.follow(now, in);
    in.seconds = 1.0f / 60;
    int glides = 0;
    float goal = shown.low.x;
    for (int i = 0; i < 600; ++i) {  // 6 m at 0.6 m/s
        now.vehicles[0].x -= 0.01f;
        Framing at_once = framing;
        FramingInput last = in;
        last.seconds = 0;
        const float wanted = at_once.follow(now, last).low.x;
        if (wanted < goal - 1e-3f) ++glides, goal = wanted;
        shown = framing.follow(now, in);
    }
    EXPECT_LE(glides, 5) << "steps of more than a metre";
    EXPECT_GE(glides, 2);
    const CameraView seen = look(framing.raised({}), now.scene->arena, nullptr, window, free_area, &shown);
    const Rect vehicle = picture_of(now, seen, now.vehicles[0]);
    EXPECT_TRUE(free_area.contains(vehicle.x, vehicle.y));
}

TEST(Framing, StaysWhileTheUserHoldsSomethingOrHasMovedTheCamera) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -2, 0, 0);
    hand_made::add_source(now, Channel::light, 2, 0);
    for (const int way : {0, 1, 2}) {
        Framing framing;
        FramingInput in = input();
        now.vehicles[0].x = -2;
        const FloorBox first = framing.follow(now, in);
        now.vehicles[0].x = 7;
        if (way == 0) in.held = true;
        if (way == 1) in.camera.zoom = 1.4f;
        if (way == 2) in.camera.pan = {0.5f, 0};
        EXPECT_EQ(framing.follow(now, in), first) << way;
        in = input();
        EXPECT_FALSE(framing.follow(now, in) == first) << way;
    }
}

TEST(Framing, RestsInAPauseUnlessAVehicleIsOutsideOrAnotherPictureIsWanted) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -2, 0, 0);
    hand_made::add_source(now, Channel::light, 2, 0);
    Framing framing;
    FramingInput in = input();
    framing.follow(now, in);
    in.seconds = 1.0f / 60;
    const auto follow_for = [&](int frames) {
        FloorBox box;
        for (int i = 0; i < frames; ++i) box = framing.follow(now, in);
        return box;
    };
    now.vehicles[0].x = -6, now.tick = 1;
    const FloorBox gliding = follow_for(90);  // the vehicle is in the picture, the glide has not ended
    in.paused = true;
    EXPECT_EQ(follow_for(300), gliding);
    in.free_area.w *= 0.8f;
    const FloorBox narrower = follow_for(300);
    EXPECT_FALSE(narrower == gliding);
    EXPECT_EQ(follow_for(1), narrower);
    now.vehicles[0].x = 8;
    EXPECT_TRUE(holds(follow_for(300), {8, 0}));
}

TEST(Framing, BeginsAgainWithAnotherRunOrScene) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, -8, 0, 0);
    Framing framing;
    framing.follow(now, input());
    now.vehicles[0].x = 4, now.generation += 1;
    EXPECT_EQ(framing.follow(now, input()), Framing{}.follow(now, input()));
}

}  // namespace
}  // namespace braitenlab::tests::framing_test
