#include "render/view/palette.h"

#include <cmath>

#include <gtest/gtest.h>

namespace braitenlab {
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
    }
}

TEST(Palette, TellsEveryChannelFromTheFloor) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        const Palette p = palette(theme);
        for (int i = 0; i < channel_count; ++i)
            EXPECT_GE(contrast(colour_of(p, static_cast<Channel>(i)), p.floor), 1.6f) << i;
    }
}

TEST(Palette, GivesOneColourOneMeaning) {
    const Palette p = palette(Theme::dark);
    EXPECT_EQ(colour_of(p, Channel::predator), p.predator);
    EXPECT_EQ(colour_of(p, Channel::prey), colour_of(p, Role::prey));
}

}  // namespace
}  // namespace braitenlab
