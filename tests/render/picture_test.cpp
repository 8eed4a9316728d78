// Contours, labels and overlapping sectors.
#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/sensing/intensity.h"
#include "render/gl/renderer.h"
#include "tests/render/rendered.h"
#include "tests/response_law.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::picture_test {
namespace {

using namespace render;

class PictureTest : public Rendered {
protected:
    void SetUp() override {
        Rendered::SetUp();
        if (HasFatalFailure()) return;
        Camera above;
        above.mode = CameraMode::birds_eye;
        look_from(above);
        picture.settings.overlays.labels = false;
    }

    Colour seen(const Snapshot& now, float x, float y, float up = 0) {
        renderer->draw(now, picture);
        return stage.pixel(*project(picture.camera_view, {x, y}, up));
    }
};

TEST_F(PictureTest, DrawsTheIntensityOfAChannelOnlyWhereItIsAboveZero) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add_source(now, Channel::heat, -6, 0);
    const float near = brightness(seen(now, -4.7f, 1.3f)), far = brightness(seen(now, 8.3f, 8.4f));
    picture.settings.overlays.field = Channel::heat;
    EXPECT_GT(brightness(seen(now, -4.7f, 1.3f)), near + 0.05f);
    EXPECT_NEAR(brightness(seen(now, 8.3f, 8.4f)), far, 0.01f);  // beyond the range
    picture.settings.overlays.field = Channel::smell;
    EXPECT_NEAR(brightness(seen(now, -4.7f, 1.3f)), near, 0.01f);
}

TEST_F(PictureTest, DrawsContoursWhereTheFieldCrossesTenths) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add_source(now, Channel::smell, 0, 0);
    picture.settings.overlays.field = Channel::smell;
    renderer->draw(now, picture);
    // Along a ray from the source: the line at one half is brighter than the bands beside it.
    float half = 0;
    while (reading_at(half) > 0.5) half += 0.01f;
    float peak = 0;
    for (float d = half - 0.06f; d <= half + 0.06f; d += 0.01f)
        peak = std::max(peak, brightness(stage.pixel(*project(picture.camera_view, {0.33f * d, 0.944f * d}))));
    const float beside =
        brightness(stage.pixel(*project(picture.camera_view, {0.33f * (half + 0.18f), 0.944f * (half + 0.18f)})));
    EXPECT_GT(peak, beside + 0.08f);
}

TEST_F(PictureTest, DrawsLabelsInTheColourOfTheThemeOverEverything) {
    auto scene = hand_made::scene();
    scene->zones.push_back({.name = "HHHH", .length = 4, .width = 4});
    scene->obstacles.push_back({.name = "box", .length = 6, .width = 6});
    const Snapshot now = hand_made::empty(scene);
    picture.settings.overlays.labels = true;
    const auto extremes = [&](Theme theme) {
        picture.theme = theme;
        renderer->draw(now, picture);
        const maths::vec2 middle = *project(picture.camera_view, {0, 0});
        float darkest = 1, brightest = 0;
        for (float y = -8; y <= 8; ++y)
            for (float x = -20; x <= 20; ++x) {
                const float b = brightness(stage.pixel({middle.x + x, middle.y + y}));
                darkest = std::min(darkest, b), brightest = std::max(brightest, b);
            }
        return std::pair{darkest, brightest};
    };
    const auto without = extremes(Theme::dark);
    renderer->use_lettering(std::move(*Lettering::from_fonts(find_font, 16)));
    EXPECT_GT(extremes(Theme::dark).second, without.second + 0.15f);
    EXPECT_LT(extremes(Theme::light).first, 0.25f);
    EXPECT_EQ(stage.complaints(), "");
}

// An eye that points along +x and answers nearly alike over several metres.
void look_east(Scene& scene, int kind, Channel channel) {
    Sensor eye = scene.kinds[static_cast<std::size_t>(kind)].sensors[0];
    eye.x = eye.y = eye.angle = 0, eye.range = 12, eye.half_distance = 50, eye.channel = channel;
    scene.kinds[static_cast<std::size_t>(kind)].sensors = {eye};
}

TEST_F(PictureTest, AddsSectorsOnADarkFloorAndBlendsThemInOrderOnALightOne) {
    auto scene = hand_made::scene();
    look_east(*scene, 0, Channel::heat), look_east(*scene, 1, Channel::smell);
    const auto crossing = [&](bool first, bool second, bool swapped) {
        Snapshot now = hand_made::empty(scene);
        for (const int kind : {swapped ? 1 : 0, swapped ? 0 : 1})
            if (kind == 0 ? first : second) hand_made::add(now, kind, kind == 0 ? -3.0f : -2.5f, 0, 0, 0.8f);
        for (float& value : now.sensed) value = 0.8f;
        return seen(now, 0.4f, 0.3f);
    };
    const Colour ground = crossing(false, false, false), one = crossing(true, false, false),
                 other = crossing(false, true, false), both = crossing(true, true, false);
    EXPECT_GT(brightness(one), brightness(ground) + 0.02f);
    EXPECT_GT(both.r, std::max(one.r, other.r) - 0.02f);
    EXPECT_GT(brightness(both), std::max(brightness(one), brightness(other)));
    picture.theme = Theme::light;
    const Colour heat_below = crossing(true, true, false), heat_above = crossing(true, true, true);
    EXPECT_GT(heat_above.r - heat_above.b, heat_below.r - heat_below.b + 0.004f);
}

TEST_F(PictureTest, DrawsFieldsBelowVehiclesAndObstacles) {
    auto scene = hand_made::scene();
    look_east(*scene, 0, Channel::heat);
    scene->obstacles.push_back({.name = "box", .x = 0, .length = 2, .width = 2});
    Snapshot now = hand_made::empty(scene);
    const Colour bare = seen(now, 0.2f, 0.3f, 0.42f);
    hand_made::add(now, 0, -3, 0, 0, 0.9f);
    const Colour lit = seen(now, 0.2f, 0.3f, 0.42f);
    EXPECT_NEAR(lit.r, bare.r, 0.01f);
    EXPECT_NEAR(lit.b, bare.b, 0.01f);
}

TEST_F(PictureTest, EndsAnArenaWithoutWallsWithALineAndAnOpenOneWithADrop) {
    // The brightest near the left edge at this height, and the ground a metre and a half beyond it.
    const auto at_edge = [&](Boundary edge) {
        auto scene = hand_made::scene();
        scene->arena.edge = edge;
        renderer->draw(hand_made::empty(scene), picture);
        int bright = 0, dim = 0;
        for (float y = -8.2f; y < 8.2f; y += 0.1f) {
            float most = 0;
            for (float x = -10.1f; x <= -9.9f; x += 0.02f)
                most = std::max(most, brightness(stage.pixel(*project(picture.camera_view, {x, y}))));
            (most > 0.4f ? bright : dim) += 1;
        }
        return std::pair{static_cast<float>(bright) / static_cast<float>(bright + dim),
                         stage.pixel(*project(picture.camera_view, {-11.5f, 0.5f}))};
    };
    EXPECT_GT(at_edge(Boundary::open).first, 0.95f) << "solid line";
    EXPECT_NEAR(at_edge(Boundary::torus).first, 0.5f, 0.2f) << "dashed line";
    const Colour sky = palette(picture.theme).sky, nothing = at_edge(Boundary::open).second,
                 ground = at_edge(Boundary::torus).second;
    EXPECT_NEAR(nothing.b, sky.b, 0.01f);
    EXPECT_GT(ground.b, sky.b + 0.02f) << "the ground continues beyond the edge of a torus";
}

TEST_F(PictureTest, DrawsARingWithADifferentPatternForEachColouredSource) {
    Camera near;
    near.mode = CameraMode::birds_eye, near.zoom = 12;
    picture.camera_view = look(near, Arena{}, nullptr, window, window);
    // The number of dashes of the ring, and the covered fraction of the circle.
    const auto ring = [&](Channel channel) {
        Snapshot now = hand_made::empty(hand_made::scene());
        hand_made::add_source(now, channel, 0, 0);
        renderer->draw(now, picture);
        const auto lit = [&](float turn, float radius) {
            return brightness(stage.pixel(*project(picture.camera_view, maths::direction(turn) * radius)));
        };
        int begins = 0, covered = 0;
        bool before = true;
        constexpr int steps = 720;
        for (int i = 0; i < steps; ++i) {
            const float turn = 2 * maths::pi * static_cast<float>(i) / steps, radius = 0.34f * 1.15f;
            const bool on = lit(turn, radius) > 0.5f * (lit(turn, radius - 0.06f) + lit(turn, radius + 0.06f)) + 0.04f;
            begins += on && !before, covered += on, before = on;
        }
        return std::pair{begins, static_cast<float>(covered) / steps};
    };
    EXPECT_LT(ring(Channel::light).second, 0.05f);
    EXPECT_GT(ring(Channel::red).second, 0.9f);
    EXPECT_NEAR(ring(Channel::green).first, 4, 1);
    EXPECT_NEAR(ring(Channel::blue).first, 12, 1);
}

TEST_F(PictureTest, UsesThePalettesColoursInBothThemes) {
    const Snapshot now = hand_made::empty(hand_made::scene());
    for (const Theme theme : {Theme::dark, Theme::light}) {
        picture.theme = theme;
        const Palette p = palette(theme);
        // In the middle of squares of the grid, at middle depth, towards the sun and away from it.
        const Colour left = seen(now, -7.52f, 0.47f), right = seen(now, 7.52f, -0.47f);
        EXPECT_NEAR((left.r + right.r) / 2, p.floor.r, 0.03f);
        EXPECT_NEAR((left.b + right.b) / 2, p.floor.b, 0.03f);
        Camera far;
        far.zoom = 0.3f;
        look_from(far);
        renderer->draw(now, picture);
        const Colour sky = stage.pixel({2, 2});
        EXPECT_NEAR(sky.g, p.sky.g, 0.02f);  // the ground has nearly the colour of the sky here
        look_from(Camera{});
    }
}

}  // namespace
}  // namespace braitenlab::tests::picture_test
