// Trails coloured by wheels, speed and readings.
#include "render/view/trail_colour.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/view/draw_list.h"
#include "render/view/trails.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::trail_colour_test {
namespace {

using namespace render;

// Drives east; in the second half the right wheel is faster, the vehicle slower, and the left eye bright.
struct TrailColours : ::testing::Test {
    Snapshot now = hand_made::empty(hand_made::scene());
    Trails trails;
    Picture picture;

    TrailColours() {
        hand_made::add(now, 0, 0, 0, 0);
        now.sensed.assign(2, 0.0f);
        now.vehicles[0].first_sensed = 0;
        for (int i = 0; i < 240; ++i) {
            const bool late = i >= 120;
            VehicleView& vehicle = now.vehicles[0];
            ++now.tick, vehicle.x += 0.02f;
            vehicle.motor = late ? std::array{0.0f, 1.0f} : std::array{1.0f, 0.0f};
            vehicle.speed = late ? -3.0f : 0.0f;
            now.sensed[0] = late ? 1.0f : 0.0f;
            trails.record(now);
        }
    }
    std::vector<TrailInstance> drawn(const TrailColour& colour) {
        picture.settings.overlays.trail_colour = colour;
        DrawList list;
        fill(list, now, picture, trails);
        return list.trails;
    }
    void expect_ends(const TrailColour& colour) {
        const std::vector<TrailInstance> pieces = drawn(colour);
        ASSERT_GT(pieces.size(), 20u);
        const auto is = [](const maths::vec4& piece, Colour wanted) {
            return std::fabs(piece.x - wanted.r) + std::fabs(piece.y - wanted.g) + std::fabs(piece.z - wanted.b) <
                   0.01f;
        };
        EXPECT_TRUE(is(pieces.front().colour, colour_of_share(colour.value, 1, picture.theme))) << "newest";
        EXPECT_TRUE(is(pieces.back().colour, colour_of_share(colour.value, 0, picture.theme))) << "oldest";
        for (const TrailInstance& piece : pieces) EXPECT_EQ(piece.colour.w, pieces[0].colour.w);
    }
};

// CIE lightness, 0..100.
float lightness(Colour c) {
    const auto linear = [](float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); };
    return 116 * std::cbrt(0.2126f * linear(c.r) + 0.7152f * linear(c.g) + 0.0722f * linear(c.b)) - 16;
}

TEST_F(TrailColours, FollowTheFasterWheel) { expect_ends({TrailValue::wheels}); }

TEST_F(TrailColours, FollowTheSpeedBackwardsToo) { expect_ends({TrailValue::speed}); }

TEST_F(TrailColours, FollowTheReadingOfOneSensor) {
    expect_ends({TrailValue::reading, "SL"});
    const std::vector<TrailInstance> other = drawn({TrailValue::reading, "SR"});
    EXPECT_EQ(other.front().colour.x, other.back().colour.x) << "always 0";
}

TEST_F(TrailColours, ArePlainWithoutTheSensor) {
    const std::vector<TrailInstance> plain = drawn({}), unknown = drawn({TrailValue::reading, "antenna"});
    ASSERT_EQ(plain.size(), unknown.size());
    for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(plain[i].colour.x, unknown[i].colour.x);
}

TEST_F(TrailColours, ForgetReadingsWhenTheSensorsChange) {
    auto changed = std::make_shared<Scene>(*now.scene);
    std::swap(changed->kinds[0].sensors[0], changed->kinds[0].sensors[1]);
    now.scene = changed;
    for (int i = 0; i < 12; ++i) {
        ++now.tick, now.vehicles[0].x += 0.02f;
        trails.record(now);
    }
    const Trail& trail = *trails.of(0);
    EXPECT_NE(trail.moment(0).readings[0], TrailMoment::unknown);
    EXPECT_EQ(trail.moment(trail.count() - 1).readings[0], TrailMoment::unknown);
    EXPECT_EQ(trail.moment(trail.count() - 1).motor[0], 1) << "the wheels are still known";
}

TEST(TrailColour, HasAScaleThatIsReadWithoutHue) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const float floor = lightness(palette(theme).floor), towards = theme == Theme::dark ? 1.0f : -1.0f;
        for (int i = 0; i < 10; ++i) {
            const auto at = [&](int step) {
                return lightness(colour_of_share(TrailValue::speed, static_cast<float>(step) / 10, theme));
            };
            EXPECT_GT(towards * (at(i + 1) - at(i)), 1) << word(theme) << i;
            EXPECT_GT(towards * (at(i) - floor), 20) << "apart from the floor";
        }
        const Colour left = colour_of_share(TrailValue::wheels, 0, theme);
        const Colour right = colour_of_share(TrailValue::wheels, 1, theme);
        EXPECT_GT(left.b - left.r, 0.3f) << "blue";
        EXPECT_GT(right.r - right.b, 0.3f) << "orange";
    }
}

TEST(TrailColour, OfASensorEndsWithTheScene) {
    ViewSettings settings;
    settings.overlays.trail_colour = {TrailValue::speed};
    EXPECT_EQ(for_another_scene(settings).overlays.trail_colour.value, TrailValue::speed);
    settings.overlays.trail_colour = {TrailValue::reading, "SL"};
    EXPECT_EQ(for_another_scene(settings).overlays.trail_colour.value, TrailValue::plain);
}

}  // namespace
}  // namespace braitenlab::tests::trail_colour_test
