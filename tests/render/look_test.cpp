// The picture at medium and high quality: light of lamps, shadows, rounded vehicles.
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "render/gl/renderer.h"
#include "render/view/trails.h"
#include "tests/render/rendered.h"
#include "tests/response_law.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::look_test {
namespace {

using namespace render;

using maths::vec2;

class LookTest : public Rendered {
protected:
    void SetUp() override {
        Rendered::SetUp();
        if (HasFatalFailure()) return;
        picture.quality = Quality::medium;
        picture.settings.overlays.labels = false;
        picture.settings.sensors = false;
    }
    void look_down(float zoom) {
        Camera above;
        above.mode = CameraMode::birds_eye, above.zoom = zoom;
        look_from(above);
    }
    Colour seen(const Snapshot& now, vec2 place, float up = 0) {
        renderer->draw(now, picture);
        return patch(*project(picture.camera_view, place, up));
    }
};

float linear(Colour c) { return c.r * c.r + c.g * c.g + c.b * c.b; }

TEST_F(LookTest, LightsTheFloorByTheSensorsLawOfDistance) {
    look_down(1);
    const Snapshot bare = hand_made::empty(hand_made::scene());
    Snapshot now = bare;
    hand_made::add_source(now, Channel::light, -4.5f, 0.5f);
    // Along a row of squares of the grid, away from its lines, relative to the light at 3 m.
    const auto added = [&](float d) {
        const vec2 place{-4.5f + d, 0.5f};
        return linear(seen(now, place)) - linear(seen(bare, place));
    };
    const float at_3 = added(3);
    for (const float d : {4.0f, 6.0f, 8.0f})
        EXPECT_NEAR(added(d) / at_3, reading_at(d) / reading_at(3), 0.06) << d << " m";
}

TEST_F(LookTest, GivesTheTilesOfTheFloorSlightlyDifferentTones) {
    look_down(2);
    picture.theme = Theme::light;
    const Snapshot now = hand_made::empty(hand_made::scene());
    std::vector<float> tones;
    for (const float x : {-1.5f, -0.5f, 0.5f, 1.5f})
        for (const float y : {-1.5f, -0.5f, 0.5f, 1.5f}) tones.push_back(brightness(seen(now, {x, y})));
    const auto [least, most] = std::minmax_element(tones.begin(), tones.end());
    EXPECT_GT(*most - *least, 0.01f);
    EXPECT_LT(*most - *least, 0.04f) << "no tile looks like another material";
}

TEST_F(LookTest, TheFloorIsBrighterTowardsTheSun) {
    look_down(1);
    const Snapshot now = hand_made::empty(hand_made::scene());
    for (const Theme theme : {Theme::dark, Theme::light}) {
        picture.theme = theme;
        const float left_back = brightness(seen(now, {-6.5f, 4.5f})),
                    right_front = brightness(seen(now, {6.5f, -4.5f}));
        const auto [least, most] = theme == Theme::dark ? std::pair{1.2f, 1.6f} : std::pair{1.05f, 1.2f};
        EXPECT_GT(left_back, least * right_front) << word(theme);
        EXPECT_LT(left_back, most * right_front) << word(theme);
    }
}

TEST_F(LookTest, ObstaclesAreBrighterTowardsTheSun) {
    look_down(1);
    const Snapshot bare = hand_made::empty(hand_made::scene());
    Snapshot now = bare;
    auto scene = std::make_shared<Scene>(*bare.scene);
    for (const float side : {-1.0f, 1.0f})
        scene->obstacles.push_back({.name = "box", .x = side * 6.5f, .y = side * -4.5f, .length = 1, .width = 1});
    now.scene = scene;
    const float height = obstacle_height(scene->arena);
    EXPECT_GT(brightness(seen(now, {-6.5f, 4.5f}, height)), 1.2f * brightness(seen(now, {6.5f, -4.5f}, height)));
}

TEST_F(LookTest, TheUpperEdgeOfAnObstacleIsRound) {
    look_down(8);
    const Snapshot bare = hand_made::empty(hand_made::scene());
    Snapshot now = bare;
    auto scene = std::make_shared<Scene>(*bare.scene);
    scene->obstacles.push_back({.name = "box", .length = 1.6f, .width = 1.6f});
    now.scene = scene;
    // On the side away from the sun, where its light falls less and less steeply onto the edge.
    const float height = obstacle_height(scene->arena), radius = 0.26f * height;
    const auto tone = [&](float inset) { return brightness(seen(now, {0.8f - inset * radius, 0}, height)); };
    EXPECT_LT(tone(0.6f), 0.99f * tone(2));
    EXPECT_LT(tone(0.3f), 0.97f * tone(0.6f));
}

TEST_F(LookTest, DrawsTheTrailOfARoundedVehicleAsACurveThroughItsPoints) {
    look_down(4);
    const Snapshot bare = hand_made::empty(hand_made::scene());
    // On a circle, so fast that the points are far apart.
    constexpr float radius = 1.5f, step = maths::pi / 4;
    Snapshot now = bare;
    hand_made::add(now, 0, 0, 0, 0);
    for (int i = 0; i < 6; ++i, now.tick += Trail::ticks_between) {
        const vec2 at = maths::direction(step * static_cast<float>(i)) * radius;
        now.vehicles[0].x = at.x, now.vehicles[0].y = at.y;
        renderer->remember(now);
    }
    const auto change = [&](float distance) {
        const vec2 between = maths::direction(2.5f * step) * distance;
        return std::fabs(brightness(seen(now, between)) - brightness(seen(bare, between)));
    };
    EXPECT_GT(change(radius), 0.1f);
    EXPECT_LT(change(radius * std::cos(step / 2)), 0.03f) << "the chord";
}

TEST_F(LookTest, VehiclesAndObstaclesCastASoftShadowAwayFromTheSun) {
    look_down(4);
    picture.theme = Theme::light;
    const Snapshot bare = hand_made::empty(hand_made::scene());
    Snapshot vehicle = bare, obstacle = bare;
    hand_made::add(vehicle, 0, 0, 0, 0);
    auto scene = std::make_shared<Scene>(*bare.scene);
    scene->obstacles.push_back({.name = "box", .length = 1, .width = 1});
    obstacle.scene = scene;
    const auto share = [&](const Snapshot& now, vec2 place) {
        return brightness(seen(now, place)) / brightness(seen(bare, place));
    };
    for (const float far : {0.60f, 0.65f}) {
        EXPECT_LT(share(vehicle, {far, -0.15f}), 0.97f) << far;
        EXPECT_GT(share(vehicle, {-far, 0.15f}), 0.99f) << far;
        EXPECT_LT(share(obstacle, {far, -0.15f}), share(obstacle, {-far, 0.15f}) - 0.03f) << far;
    }
}

TEST_F(LookTest, ALampMakesALightFloorWarmRatherThanWhite) {
    look_down(2);
    picture.theme = Theme::light;
    const Snapshot bare = hand_made::empty(hand_made::scene());
    Snapshot now = bare;
    hand_made::add_source(now, Channel::light, 0, 0);
    const vec2 beside{1.5f, 0.5f};
    const Colour lit = seen(now, beside), plain = seen(bare, beside);
    EXPECT_GT(lit.r - lit.b, plain.r - plain.b + 0.15f);
    EXPECT_LT(brightness(lit), brightness(plain) + 0.035f);
}

TEST_F(LookTest, KeepsTheHueOfTheFloorBesideALamp) {
    look_down(2);
    Snapshot now = hand_made::empty(hand_made::scene());
    for (const float x : {-0.2f, 0.2f}) hand_made::add_source(now, Channel::light, x, 0);
    for (const Theme theme : {Theme::dark, Theme::light}) {
        picture.theme = theme;
        const Colour beside = seen(now, {0, 0.75f});
        EXPECT_LT(brightness(beside), 0.95f);
        EXPECT_GT(beside.r, beside.b + 0.1f) << "warm, not white";
    }
}

TEST_F(LookTest, MakesADarkFloorWarmNotGreyBetweenLightAndDark) {
    look_down(1);
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add_source(now, Channel::light, -4.5f, 0.5f);
    const Colour between = seen(now, {0.5f, 0.5f});  // 5 m from the lamp
    EXPECT_GT(between.r, between.b + 0.03f);
    EXPECT_GT(between.r, between.g + 0.03f);
}

TEST_F(LookTest, ShowsALampAsTheBrightestThingInBothThemes) {
    look_down(4);
    const Snapshot bare = hand_made::empty(hand_made::scene());
    Snapshot now = bare;
    hand_made::add_source(now, Channel::light, 0, 0);
    for (const Theme theme : {Theme::dark, Theme::light}) {
        picture.theme = theme;
        const Colour bulb = seen(now, {0, 0}, 0.5f), floor = seen(now, {2.5f, 0.5f});
        EXPECT_GT(brightness(bulb), brightness(floor) + 0.01f) << word(theme);
    }
}

TEST_F(LookTest, DarkensABulbTowardsItsOutlineOnTheLightFloor) {
    look_down(8);
    picture.theme = Theme::light;
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add_source(now, Channel::light, 0, 0);
    renderer->draw(now, picture);
    const vec2 middle = *project(picture.camera_view, {0, 0}, 0.5f);
    // To the outline, which lies where the dark foot begins.
    const float bulb = stage.pixel(middle).b;
    float least = bulb;
    int darker = 0;
    for (float x = 0; x < 60; ++x) {
        const Colour c = stage.pixel({middle.x + x, middle.y});
        if (c.r < 0.7f) break;
        least = std::min(least, c.b), darker += c.b < bulb - 0.05f && c.b < least + 0.01f;
    }
    EXPECT_LT(least, bulb - 0.2f);
    EXPECT_GE(darker, 4) << "a gradient, not a line";
}

TEST_F(LookTest, BrightensAtDuskTheVehiclesOfASceneWithoutEyesForLight) {
    look_down(4);
    auto dark = hand_made::scene();
    dark->kinds.erase(dark->kinds.begin());  // plain, the kind that senses light
    auto lit = std::make_shared<Scene>(*dark);
    lit->kinds[0].sensors[0].channel = Channel::light;
    const auto body = [&](const std::shared_ptr<Scene>& scene) {
        Snapshot now = hand_made::empty(scene);
        hand_made::add(now, 0, 0, 0, 0);
        return brightness(seen(now, {-0.35f, 0.2f}, 0.25f));
    };
    EXPECT_GT(body(dark), 1.1f * body(lit));
}

TEST_F(LookTest, ShowsAStimulatedFieldOnALightFloorBesideALamp) {
    look_down(2);
    picture.theme = Theme::light, picture.settings.selection.vehicle = 0;
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 0, 0, 0, 0.5f, 0.5f);
    hand_made::add_source(now, Channel::light, 2.5f, 2.5f);
    const vec2 ahead_left{1.5f, 1.5f};  // in the field of the left sensor, away from lines of the grid
    const Colour bare = seen(now, ahead_left);
    picture.settings.sensors = true;
    EXPECT_LT(brightness(seen(now, ahead_left)), brightness(bare) - 0.10f);
}

// The largest difference of two channels of the colour: 0 for grey.
float colourfulness(Colour c) { return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}); }

float distance(Colour a, Colour b) { return std::hypot(a.r - b.r, a.g - b.g, a.b - b.b); }

TEST_F(LookTest, ShowsALampOfAColourOrOfLittleStrengthAsALightInTheLightTheme) {
    look_down(4);
    picture.theme = Theme::light;
    struct {
        Channel channel;
        float strength;
    } const lamps[]{{Channel::red, 1},    {Channel::green, 1},    {Channel::blue, 1},    {Channel::heat, 1},
                    {Channel::red, 0.3f}, {Channel::green, 0.3f}, {Channel::blue, 0.3f}, {Channel::light, 0.3f}};
    for (const auto& lamp : lamps) {
        Snapshot now = hand_made::empty(hand_made::scene());
        const Colour bare = seen(now, {0.5f, 0.5f});
        hand_made::add_source(now, lamp.channel, 0, 0);
        now.sources[0].strength = lamp.strength;
        const float size = 0.8f + 0.35f * lamp.strength;
        const Colour bulb = seen(now, {0, 0}, 0.5f * size), rim = seen(now, {0.11f * size, 0}, 0.44f * size);
        const Colour beside = seen(now, {0.5f, 0.5f});
        SCOPED_TRACE("channel " + std::to_string(static_cast<int>(lamp.channel)) + ", strength " +
                     std::to_string(lamp.strength));
        EXPECT_GT(distance(bulb, bare), 0.30f);
        EXPECT_GT(colourfulness(rim), colourfulness(bare) + 0.25f);
        EXPECT_GT(std::max({bulb.r, bulb.g, bulb.b}), 0.93f) << "it shines";
        EXPECT_GT(distance(beside, bare), 0.02f) << "it lights the floor";
    }
}

TEST_F(LookTest, DarkensTheFloorBehindAVehicleButNotBeforeIt) {
    look_down(2);
    Snapshot bare = hand_made::empty(hand_made::scene());
    hand_made::add_source(bare, Channel::light, -2.5f, 0.5f);
    Snapshot now = bare;
    hand_made::add(now, 0, 0.5f, 0.5f, 0);
    const auto change = [&](vec2 place) { return brightness(seen(now, place)) / brightness(seen(bare, place)); };
    EXPECT_LT(change({1.4f, 0.5f}), 0.9f);
    EXPECT_NEAR(change({-0.6f, 0.5f}), 1, 0.02f);
    EXPECT_NEAR(change({1.4f, 2.5f}), 1, 0.02f);
    EXPECT_GT(change({4.5f, 0.5f}), change({1.4f, 0.5f}) + 0.05f) << "the shadow ends";
}

TEST_F(LookTest, CastsTheShadowsOfObstaclesAwayFromTheLamp) {
    look_down(2);
    auto scene = hand_made::scene();
    Snapshot bare = hand_made::empty(scene);
    hand_made::add_source(bare, Channel::light, 0, 3.5f);
    scene = std::make_shared<Scene>(*scene);
    scene->obstacles.push_back({.name = "box", .length = 2, .width = 1});
    Snapshot now = bare;
    now.scene = scene;
    const auto change = [&](vec2 place) { return brightness(seen(now, place)) / brightness(seen(bare, place)); };
    EXPECT_LT(change({0.3f, -1.1f}), 0.92f);
    for (const float y : {0.9f, 1.4f}) EXPECT_NEAR(change({0.3f, y}), 1, 0.02f) << "towards the lamp";
}

TEST_F(LookTest, TheFloorReflectsTheLightOfALampOntoTheSideAwayFromIt) {
    Camera low;
    low.elevation = 0.5f;
    look_from(low);
    Snapshot bare = hand_made::empty(hand_made::scene());
    auto scene = std::make_shared<Scene>(*bare.scene);
    scene->obstacles.push_back({.name = "box", .length = 2, .width = 1});
    bare.scene = scene;
    Snapshot now = bare;
    hand_made::add_source(now, Channel::light, 0, 3);
    const vec2 side{0.4f, -0.5f};
    EXPECT_GT(linear(seen(now, side, 0.2f)), 1.05f * linear(seen(bare, side, 0.2f)));
}

class RoundedTest : public LookTest {
protected:
    void SetUp() override {
        LookTest::SetUp();
        if (HasFatalFailure()) return;
        look_down(10);  // 200 pixels per vehicle
        hand_made::add(now, 0, 0, 0, 0);
    }

    // The point of the left eye's ball at these angles (rad) above the gaze and to its left, as seen from above.
    Colour on_left_eye(float above, float beside) {
        DrawList list;
        render::fill(list, now, picture, Trails{});
        const EyeballInstance& eye = list.eyeballs.at(0);
        const vec2 gaze{eye.place.z, eye.place.w}, left{-gaze.y, gaze.x};
        constexpr float pitch = 0.663f;  // as in shaders/eyeball.vert
        const float flat = std::cos(pitch + above) * std::cos(beside);
        const vec2 at = vec2{eye.place.x, eye.place.y} + (gaze * flat + left * std::sin(beside)) * eye.size.x;
        renderer->draw(now, picture);
        return stage.pixel(*project(picture.camera_view, at, 0.4f));
    }

    Snapshot now = hand_made::empty(hand_made::scene());
};

TEST_F(RoundedTest, ShowsAnEyeWhoseIrisBrightensWithItsReading) {
    const Colour pupil = on_left_eye(0.05f, 0), dim = on_left_eye(0.05f, 0.52f), white = on_left_eye(-0.15f, 1.0f);
    EXPECT_LT(brightness(pupil), 0.2f);
    EXPECT_GT(dim.r - dim.b, white.r - white.b + 0.1f) << "the ball around it is white";
    now.sensed = {0.9f, 0};
    const Colour bright = on_left_eye(0.05f, 0.52f);
    EXPECT_GT(brightness(bright), brightness(dim) + 0.15f);
    EXPECT_GT(bright.r, bright.b) << "in the colour of its channel";
    EXPECT_LT(brightness(on_left_eye(0.05f, 0)), 0.2f) << "the pupil stays dark";
}

TEST_F(RoundedTest, DarkensTheDeckBesideAnEye) {
    renderer->draw(now, picture);
    const float x = now.scene->kinds[0].sensors[0].x;
    const auto deck = [&](vec2 at) { return brightness(stage.pixel(*project(picture.camera_view, at, 0.26f))); };
    for (const float side : {-1.0f, 1.0f}) EXPECT_LT(deck({x, 0.09f * side}), 0.85f * deck({-0.33f, 0.22f * side}));
}

TEST_F(RoundedTest, DarkensTheSidesOfABody) {
    // The lid of an eye: its right side and its top.
    EXPECT_LT(brightness(on_left_eye(1.57f, -1.0f)), 0.62f * brightness(on_left_eye(1.0f, 0)));
}

TEST_F(RoundedTest, ShinesTheFilledPartOfTheEnergyGaugeAtDusk) {
    now.vehicles[0].energy = 1;
    renderer->draw(now, picture);
    const auto at = [&](float x) { return stage.pixel(*project(picture.camera_view, {x, 0}, 0.24f)); };
    Colour gauge;
    for (float x = -0.49f; x < -0.30f; x += 0.005f)
        if (at(x).g - at(x).b > gauge.g - gauge.b) gauge = at(x);
    EXPECT_GT(gauge.g, 0.72f);
}

TEST_F(RoundedTest, ClosesTheLidOfASilencedSensorAndCrossesIt) {
    now.sensed = {0.9f, 0.9f};
    const Colour open = on_left_eye(0.05f, 0.52f);
    BrainGraph brain = *now.brains[0];
    find_node(brain, std::string("SL"))->silenced = true;
    now.brains[0] = std::make_shared<BrainGraph>(brain);
    EXPECT_GT(brightness(on_left_eye(0, 0)), 0.8f) << "the arms of the cross meet in the middle";
    EXPECT_LT(brightness(on_left_eye(0.05f, 0.52f)), brightness(open) - 0.3f) << "the iris is hidden";
}

TEST_F(RoundedTest, TurnsTheTreadWithTheWheel) {
    const auto rows = [&](float angle) {
        now.vehicles[0].wheel_angle[0] = angle;
        renderer->draw(now, picture);
        std::vector<float> along;
        for (float x = -0.14f; x < 0.14f; x += 0.006f)
            along.push_back(brightness(stage.pixel(*project(picture.camera_view, {x, 0.30f}, 0.3f))));
        return along;
    };
    const auto difference = [](const std::vector<float>& a, const std::vector<float>& b) {
        float most = 0;
        for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::fabs(a[i] - b[i]));
        return most;
    };
    constexpr float block = 2 * maths::pi / 20;
    const auto still = rows(0);
    EXPECT_GT(*std::max_element(still.begin(), still.end()), *std::min_element(still.begin(), still.end()) + 0.03f);
    EXPECT_GT(difference(still, rows(0.5f * block)), 0.03f);
    EXPECT_LT(difference(still, rows(2 * block)), 0.03f) << "every second block is alike";
}

TEST_F(RoundedTest, SmoothsEdgesAtHighQuality) {
    look_down(3);
    now.vehicles[0].heading = 0.3f;
    // Number of large steps between neighbours: pixels on edges have mixtures.
    const auto steps = [&](Quality quality) {
        picture.quality = quality;
        renderer->draw(now, picture);
        const auto all = stage.pixels();
        int jumps = 0;
        for (int y = 180; y < 300; ++y)
            for (int x = 260; x < 380; ++x) {
                const auto at = [&](int px) {
                    return static_cast<int>(all[static_cast<std::size_t>((y * window_width + px) * 3 + 2)]);
                };
                jumps += std::abs(at(x + 1) - at(x)) > 90;
            }
        return jumps;
    };
    EXPECT_LT(steps(Quality::high), 0.8f * static_cast<float>(steps(Quality::medium)));
    EXPECT_EQ(stage.complaints(), "");
}

TEST_F(RoundedTest, HalfTheResolutionKeepsColoursAndPlaces) {
    look_down(3);
    now.vehicles[0].heading = 0.3f;
    const auto drawn_at = [&](float resolution) {
        picture.resolution = resolution;
        renderer->draw(now, picture);
        return stage.pixels();
    };
    const auto whole = drawn_at(1), half = drawn_at(0.5f), again = drawn_at(1);
    EXPECT_EQ(whole, again);
    int differ = 0;
    double sum = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const int difference = std::abs(whole[i] - half[i]);
        differ += difference > 40, sum += difference;
    }
    EXPECT_GT(differ, 100) << "edges are softer";
    EXPECT_LT(sum / static_cast<double>(whole.size()), 3) << "of 255";
    EXPECT_EQ(stage.complaints(), "");
}

TEST_F(RoundedTest, HalfTheResolutionIsEnlargedInItsPartOfTheFramebuffer) {
    renderer->draw(now, picture);
    const auto before = stage.pixels();
    const Rect part{160, 120, 320, 240};
    picture.camera_view = look(picture.settings.camera, Arena{}, nullptr, part, part);
    picture.resolution = 0.5f;
    renderer->draw(now, picture);
    const auto after = stage.pixels();
    int changed_outside = 0, between = 0;
    for (int y = 0; y < window_height; ++y)
        for (int x = 0; x < window_width; ++x) {
            const auto i = static_cast<std::size_t>((y * window_width + x) * 3);
            const bool inside = x >= 160 && x < 480 && y >= 120 && y < 360;
            if (!inside)
                changed_outside += before[i] != after[i];
            else if (x % 2 == 0)
                between += after[i] != after[i + 3];  // of one pixel of the coarse picture
        }
    EXPECT_EQ(changed_outside, 0);
    EXPECT_GT(between, 300) << "interpolated";
    EXPECT_EQ(stage.complaints(), "");
}

}  // namespace
}  // namespace braitenlab::tests::look_test
