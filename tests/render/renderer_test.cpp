#include "render/gl/renderer.h"

#include <cmath>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "tests/render/rendered.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::renderer_test {
namespace {

using namespace render;

class RendererTest : public Rendered {
protected:
    // The deck is dark and has wires on it; the colour of the hull is visible behind the deck.
    Colour hull_colour(const VehicleView& v) const {
        const auto place = maths::vec2{v.x, v.y} + maths::rotate({-0.275f, 0}, maths::direction(v.heading));
        return stage.pixel(*project(picture.camera_view, place, 0.25f));
    }
};

TEST_F(RendererTest, ShowsAVehicleInItsColourWhereItIs) {
    Camera camera;
    camera.zoom = 4;
    picture.camera_view = look(camera, Arena{}, nullptr, window, window);
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, -1.5f, 0.5f, 0.3f);
    hand_made::add(now, 2, 1.5f, -0.5f, -2);
    hand_made::add_others(now);
    picture.settings.sensors = false;
    renderer->draw(now, picture);
    const Colour predator = hull_colour(now.vehicles[0]), prey = hull_colour(now.vehicles[1]);
    EXPECT_GT(predator.r, 1.5f * predator.g);
    EXPECT_GT(predator.g, predator.b);
    EXPECT_GT(prey.g, 1.3f * prey.b);
    EXPECT_GT(prey.g, 2 * prey.r);
}

TEST_F(RendererTest, ShowsASmallVehiclesDeckInItsColour) {
    Camera camera;
    camera.zoom = 0.9f;
    picture.camera_view = look(camera, Arena{}, nullptr, window, window);
    picture.settings.sensors = false;
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, 0, 0, 0);
    renderer->draw(now, picture);
    const Colour deck = stage.pixel(*project(picture.camera_view, {0, 0.12f}, 0.27f));
    EXPECT_GT(deck.r, 0.55f);
    EXPECT_GT(deck.r, 1.5f * deck.g);
}

TEST_F(RendererTest, DrawsALightRimOnADarkFloorAndADarkOneOnALightFloor) {
    picture.settings.sensors = false;
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 2, 0, 0, 0);
    for (const Theme theme : {Theme::dark, Theme::light}) {
        picture.theme = theme;
        renderer->draw(now, picture);
        const maths::vec2 tail = *project(picture.camera_view, {-0.5f, 0}, 0.16f);
        float brightest = 0, darkest = 1;
        for (float x = -4; x <= 1; ++x) {
            const float b = brightness(stage.pixel({tail.x + x, tail.y}));
            brightest = std::max(brightest, b), darkest = std::min(darkest, b);
        }
        if (theme == Theme::dark)
            EXPECT_GT(brightest, 0.5f);
        else
            EXPECT_LT(darkest, 0.35f);
    }
}

TEST_F(RendererTest, HidesFartherVehiclesBehindNearerOnes) {
    Snapshot now = hand_made::empty(hand_made::scene());
    Camera camera;
    camera.elevation = 0.15f, camera.zoom = 6;
    picture.camera_view = look(camera, Arena{}, nullptr, window, window);
    picture.settings.sensors = false;
    // Seen from −y at a low angle, the tail of the prey is directly behind the side of the predator; in both orders.
    for (const bool near_first : {true, false}) {
        now.vehicles.clear();
        now.sensed.clear();
        hand_made::add(now, near_first ? 1 : 2, 0, near_first ? -0.6f : 0.6f, 0);
        hand_made::add(now, near_first ? 2 : 1, 0, near_first ? 0.6f : -0.6f, 0);
        renderer->draw(now, picture);
        const Colour seen = stage.pixel(*project(picture.camera_view, {-0.35f, -0.6f - 0.33f}, 0.15f));
        EXPECT_GT(seen.r, seen.g) << near_first;
    }
}

TEST_F(RendererTest, NeedsNoMoreDrawCallsForFiveHundredVehiclesThanForTen) {
    picture.settings.outlines = true, picture.settings.selection.vehicle = 0, picture.hovered = 1;
    // Ten poses, each with this many vehicles: the same roles and levels of detail for any number.
    const auto calls_for = [&](int copies, float half) {
        constexpr int poses = 10;
        Snapshot now = hand_made::empty(hand_made::scene());
        for (int i = 0; i < copies * poses; ++i) {
            const auto pose = static_cast<float>(i % poses);
            const float x = std::fmod(pose * 0.618034f, 1.0f), y = (pose + 0.5f) / poses;
            hand_made::add(now, i % poses % 3, half * (2 * x - 1), half * (2 * y - 1), 0);
        }
        hand_made::add_source(now, Channel::light, 0, 0);
        // From the third equal frame on the ground comes from the backdrop.
        for (int frame = 0; frame < 3; ++frame) renderer->draw(now, picture);
        return renderer->draw_calls();
    };
    glEnable(GL_RASTERIZER_DISCARD);  // the calls are counted; no pixel is looked at
    // All as hulls, all as signs, and a mixture.
    for (const auto& [zoom, elevation] : {std::pair{0.4f, 1.1f}, {0.9f, 0.3f}, {1.0f, 1.1f}, {2.5f, 1.1f}}) {
        Camera camera;
        camera.zoom = zoom, camera.elevation = elevation;
        picture.camera_view = look(camera, Arena{}, nullptr, window, window);
        const float half = std::min(9.0f, 7 / zoom);
        const int few = calls_for(1, half), many = calls_for(50, half);
        EXPECT_EQ(many, few) << zoom;
        EXPECT_GT(few, 5) << zoom;
        EXPECT_LE(many, 24) << zoom;
    }
    glDisable(GL_RASTERIZER_DISCARD);
}

TEST_F(RendererTest, CausesNoGlError) {
    Snapshot now = hand_made::empty(hand_made::scene());
    for (int i = 0; i < 30; ++i)
        hand_made::add(now, i % 3, static_cast<float>(i % 6), static_cast<float>(i / 6), 1, 0.5f);
    for (const Channel c : {Channel::light, Channel::heat, Channel::smell, Channel::oxygen})
        hand_made::add_source(now, c, -3, -3);
    picture.settings.outlines = true, picture.settings.selection.vehicle = 3, picture.hovered = 4;
    for (int frame = 0; frame < 20; ++frame) {
        now.tick += 6;
        for (VehicleView& v : now.vehicles) v.x += 0.1f;
        renderer->draw(now, picture);
        ASSERT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    }
}

TEST_F(RendererTest, DrawsAnEmptyWorld) {
    renderer->draw(Snapshot{}, picture);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(renderer->draw_calls(), 1);  // the floor
}

TEST_F(RendererTest, ShowsTheFloorAndTheSkyInTheThemesColours) {
    const Snapshot now = hand_made::empty(hand_made::scene());
    Camera camera;
    camera.mode = CameraMode::birds_eye, camera.zoom = 0.25f;
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const Palette colours = palette(theme);
        picture.theme = theme;
        picture.camera_view = look({}, Arena{}, nullptr, window, window);
        renderer->draw(now, picture);
        // In the middle of a square of the grid, at middle distance from the sun. The centre of the arena is a little
        // brighter in the dark theme.
        EXPECT_NEAR(brightness(patch(*project(picture.camera_view, {-4.5f, -8.5f}))), brightness(colours.floor), 0.02f);
        picture.camera_view = look(camera, Arena{}, nullptr, window, window);
        renderer->draw(now, picture);
        EXPECT_NEAR(brightness(patch({3, 3})), brightness(colours.sky), 0.004f);
    }
}

TEST_F(RendererTest, LightsTheFloorUnderALamp) {
    Snapshot now = hand_made::empty(hand_made::scene());
    const auto beside = *project(picture.camera_view, {4.5f, 3.4f});
    renderer->draw(now, picture);
    const float before = brightness(patch(beside));
    hand_made::add_source(now, Channel::light, 4.5f, 4.5f);
    renderer->draw(now, picture);
    EXPECT_GT(brightness(patch(beside)), before + 0.05f);
}

TEST_F(RendererTest, ShowsAStimulatedFieldBrighterAndNoFieldBehindAWall) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 0, 8.4f, 0.5f, 0);
    const auto ahead = *project(picture.camera_view, {9.4f, 1.5f}),
               outside = *project(picture.camera_view, {10.6f, 1.5f});
    picture.settings.overlays.trails = false;
    renderer->draw(now, picture);
    const float idle = brightness(patch(ahead)), beyond = brightness(patch(outside));
    now.sensed = {0.8f, 0.8f};
    renderer->draw(now, picture);
    EXPECT_GT(brightness(patch(ahead)), idle + 0.04f);
    EXPECT_NEAR(brightness(patch(outside)), beyond, 0.004f);
}

TEST_F(RendererTest, ShowsTheOutlineOfAnObstacle) {
    auto scene = hand_made::scene();
    scene->obstacles.push_back({.name = "wedge", .corners = {{-3, -3}, {3, -3}, {-3, 3}}});
    Snapshot now = hand_made::empty(hand_made::scene());
    const auto at = [&](float x, float y) {
        renderer->draw(now, picture);
        return brightness(patch(*project(picture.camera_view, {x, y}, 0.42f)));
    };
    const float floor_inside = at(-1, -1), floor_outside = at(2, 2);
    now = hand_made::empty(scene);
    EXPECT_GT(at(-1, -1), floor_inside + 0.1f);
    EXPECT_NEAR(at(2, 2), floor_outside, 0.02f);  // a box of its length and width would cover this
}

TEST_F(RendererTest, DrawsNothingOfAnObstacleBeyondItsOutline) {
    const Snapshot empty = hand_made::empty(hand_made::scene());
    const auto around = [&](const Snapshot& now) {
        renderer->draw(now, picture);
        std::vector<float> seen;
        for (float x = -8; x <= 8; x += 0.5f)
            for (float y = -8; y <= 8; y += 0.5f)
                if (std::hypot(x, y) > 3) seen.push_back(brightness(patch(*project(picture.camera_view, {x, y}))));
        return seen;
    };
    const std::vector<float> bare = around(empty);
    for (int count = 3; count <= 8; ++count) {
        auto scene = hand_made::scene();
        Obstacle prism{.name = "prism"};
        for (int i = 0; i < count; ++i) {
            const maths::vec2 at = maths::direction(2 * maths::pi * static_cast<float>(i) / static_cast<float>(count));
            prism.corners.push_back({at.x, at.y});
        }
        scene->obstacles.push_back(prism);
        const std::vector<float> seen = around(hand_made::empty(scene));
        for (std::size_t i = 0; i < bare.size(); ++i) ASSERT_NEAR(seen[i], bare[i], 0.02f) << count << " corners";
    }
}

TEST_F(RendererTest, DrawsZonesOnlyWithinTheirArea) {
    Snapshot plain = hand_made::empty(hand_made::scene());
    auto scene = hand_made::scene();
    scene->zones.push_back({.name = "ice", .length = 4, .width = 4, .round = true, .surface = Surface::ice});
    scene->zones.push_back({.name = "line", .x = 5, .length = 0.5f, .width = 6, .surface = Surface::tape});
    const Snapshot now = hand_made::empty(scene);
    const auto at = [&](const Snapshot& moment, float x, float y) {
        renderer->draw(moment, picture);
        return patch(*project(picture.camera_view, {x, y}));
    };
    EXPECT_GT(at(now, 0.3f, 0.6f).b, at(plain, 0.3f, 0.6f).b + 0.1f);
    EXPECT_NEAR(at(now, 1.8f, 1.8f).b, at(plain, 1.8f, 1.8f).b, 0.01f);  // round: not the corner of its box
    EXPECT_LT(brightness(at(now, 5.05f, 1.3f)), 0.06f);
}

TEST_F(RendererTest, DrawsAYellowRingAroundTheSelectedVehicle) {
    Snapshot now = hand_made::empty(hand_made::scene());
    picture.settings.selection.vehicle = hand_made::add(now, 0, 0, 0, 0);
    picture.settings.sensors = false;
    renderer->draw(now, picture);
    const float radius = 0.5f * std::hypot(1.0f, 0.7f) + 0.12f;
    const Colour ring = stage.pixel(*project(picture.camera_view, {radius, 0}));
    EXPECT_GT(ring.r, 0.7f);
    EXPECT_GT(ring.g, 0.7f);
    EXPECT_LT(ring.b, 0.5f);
}

TEST_F(RendererTest, DrawsTheRingOfTheSelectedVehicleWithADarkOutlineByDay) {
    Snapshot now = hand_made::empty(hand_made::scene());
    picture.settings.selection.vehicle = hand_made::add(now, 0, 0, 0, 0);
    picture.settings.sensors = false, picture.theme = Theme::light;
    renderer->draw(now, picture);
    const maths::vec2 ring = *project(picture.camera_view, {0.5f * std::hypot(1.0f, 0.7f) + 0.12f, 0});
    int yellow = 0, dark = 0;
    for (float x = -8; x <= 8; ++x) {
        const Colour c = stage.pixel({ring.x + x, ring.y});
        yellow += c.b < 0.45f && c.r > 0.8f, dark += brightness(c) < 0.35f;
    }
    EXPECT_GE(yellow, 2);
    EXPECT_GE(dark, 2);
}

}  // namespace
}  // namespace braitenlab::tests::renderer_test
