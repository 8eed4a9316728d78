#include "render/view/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "hand_made.h"

namespace braitenlab::tests::palette_test {
namespace {

// Relative luminance and contrast after WCAG 2.1.
float luminance(Colour c) {
    const auto linear = [](float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); };
    return 0.2126f * linear(c.r) + 0.7152f * linear(c.g) + 0.0722f * linear(c.b);
}
float contrast(Colour a, Colour b) {
    const float x = luminance(a), y = luminance(b);
    return (std::max(x, y) + 0.05f) / (std::min(x, y) + 0.05f);
}

TEST(Palette, KeepsTextReadable) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const Palette p = palette(theme);
        for (const Colour ground : {p.ground, p.panel, p.raised})
            for (const Colour text : {p.text, p.second_text}) EXPECT_GE(contrast(text, ground), 4.5f);
        EXPECT_GE(contrast(p.on_accent, p.accent), 4.5f);
        EXPECT_GE(contrast(p.warning, p.panel), 4.5f);
        EXPECT_GE(contrast(p.success, p.panel), 4.5f);
    }
}

using Linear = std::array<float, 3>;

Linear linear(Colour c) {
    const auto one = [](float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); };
    return {one(c.r), one(c.g), one(c.b)};
}

// Simulated vision without long-wave (protan) or middle-wave cones (deutan); F. Viénot, H. Brettel and J. Mollon,
// "Digital video colourmaps for checking the legibility of displays by dichromats" (1999).
enum class Eyes { all_cones, protan, deutan };
Linear seen_by(Eyes eyes, Linear c) {
    if (eyes == Eyes::all_cones) return c;
    const bool protan = eyes == Eyes::protan;
    const float yellow = protan ? 0.11238f * c[0] + 0.88762f * c[1] : 0.29275f * c[0] + 0.70725f * c[1];
    const float blue = protan ? 0.00401f * (c[0] - c[1]) + c[2] : -0.02234f * (c[0] - c[1]) + c[2];
    return {yellow, yellow, std::clamp(blue, 0.0f, 1.0f)};
}

// Distance in CIE 1976 L*a*b*: about 2 is the smallest visible difference side by side.
float difference(Linear a, Linear b) {
    const auto lab = [](Linear c) {
        const auto f = [](float t) { return t > 0.008856f ? std::cbrt(t) : 7.787f * t + 16.0f / 116; };
        const float x = f((0.4124f * c[0] + 0.3576f * c[1] + 0.1805f * c[2]) / 0.9505f),
                    y = f(0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]),
                    z = f((0.0193f * c[0] + 0.1192f * c[1] + 0.9505f * c[2]) / 1.089f);
        return Linear{116 * y - 16, 500 * (x - y), 200 * (y - z)};
    };
    const Linear p = lab(a), q = lab(b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

TEST(Palette, HasSourceColoursThatColourBlindPeopleDistinguish) {
    constexpr auto& sources = channels_with<&ChannelTraits::is_source>;
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const Palette p = palette(theme);
        for (const Eyes eyes : {Eyes::all_cones, Eyes::protan, Eyes::deutan})
            for (std::size_t i = 0; i < sources.size(); ++i)
                for (std::size_t k = 0; k < i; ++k)
                    EXPECT_GE(difference(seen_by(eyes, linear(colour_of(p, sources[i]))),
                                         seen_by(eyes, linear(colour_of(p, sources[k])))),
                              13)
                        << i << " and " << k << ", theme " << static_cast<int>(theme) << ", eyes "
                        << static_cast<int>(eyes);
        EXPECT_GE(difference(linear(colour_of(p, Channel::obstacle)), linear(colour_of(p, Channel::vehicle))), 15);
    }
}

TEST(Palette, HasChannelColoursThatContrastWithTheFloor) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const Palette p = palette(theme);
        for (const ChannelTraits& row : channel_table)
            EXPECT_GE(contrast(colour_of(p, row.value), p.floor), 2.0f) << row.word;
    }
}

TEST(Palette, UsesTheColourOfARoleForItsChannel) {
    const Palette p = palette(Theme::dark);
    EXPECT_EQ(colour_of(p, Channel::predator), p.predator);
    EXPECT_EQ(colour_of(p, Channel::prey), colour_of(p, Role::prey));
    EXPECT_EQ(colour_of(p, Channel::memory), p.memory);
}

TEST(Palette, AVehicleHasItsOwnColourElseThatOfItsKindElseThatOfItsRole) {
    const Palette p = palette(Theme::dark);
    const auto scene = hand_made::scene();
    Snapshot now = hand_made::empty(scene);
    VehicleView vehicle;
    vehicle.kind = 1, vehicle.role = Role::predator;
    EXPECT_EQ(colour_of(p, now, vehicle), p.predator);
    scene->kinds[1].colour = "#102030";
    EXPECT_EQ(colour_of(p, now, vehicle), rgb(0x102030));
    scene->starts.push_back({});
    scene->starts[0].colour = "#c02020";
    vehicle.start = 0;
    EXPECT_EQ(colour_of(p, now, vehicle), rgb(0xc02020));
}

}  // namespace
}  // namespace braitenlab::tests::palette_test
