// Every colour of the lab, in one place: the window's and the scene's, for the desk (dark) and the projector (light).
//
// The colours of meaning are from M. Okabe and K. Ito, "Color Universal Design" (2008), and stay apart for colour-blind
// eyes. One colour has one meaning, and a shape, a sign or a word says it too.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/scene/scene.h"

namespace braitenlab {

// sRGB, each 0..1.
struct Colour {
    float r = 0, g = 0, b = 0, a = 1;
    constexpr Colour with_alpha(float alpha) const { return {r, g, b, alpha}; }
    friend constexpr bool operator==(const Colour&, const Colour&) = default;
};

// 0xRRGGBB, as colours are written everywhere.
constexpr Colour rgb(std::uint32_t hex) {
    const auto channel = [hex](int shift) { return static_cast<float>((hex >> shift) & 255U) / 255.0f; };
    return {channel(16), channel(8), channel(0), 1};
}

constexpr Colour mix(Colour a, Colour b, float t) {
    return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t, a.a + (b.a - a.a) * t};
}

enum class Theme { dark, light };
inline constexpr std::array<std::string_view, 2> theme_words{"dark", "light"};
constexpr std::string_view word(Theme theme) { return theme_words[static_cast<std::size_t>(theme)]; }

struct Palette {
    // the window
    Colour ground, panel, raised, line, text, second_text, accent, on_accent, warning, success;
    // the scene
    Colour sky, floor, grid, wall, shadow, chassis, wheel, lamp;
    // meaning
    Colour excites, inhibits, predator, prey, neutral, selected, memory;
    // what can be sensed; white light has the lamp's colour
    Colour red_light, green_light, blue_light, heat, smell, oxygen, obstacle;
    // what can be pushed, and pieces of floor
    Colour crate, ice, carpet, sand, tape, recharge;
};

constexpr Palette palette(Theme theme) {
    Palette p{};
    p.excites = rgb(0xE69F00);
    p.inhibits = rgb(0x56B4E9);
    p.predator = rgb(0xD55E00);
    p.prey = rgb(0x009E73);
    p.selected = rgb(0xF0E442);
    p.memory = rgb(0xCC79A7);
    if (theme == Theme::dark) {
        p.ground = rgb(0x14171C), p.panel = rgb(0x1C2128), p.raised = rgb(0x262D36), p.line = rgb(0x343D48);
        p.text = rgb(0xE6EAF0), p.second_text = rgb(0xA9B4C0);
        p.accent = rgb(0x4C8DFF), p.on_accent = rgb(0x0B1220), p.warning = rgb(0xFF8A70), p.success = rgb(0x6FCF97);
        p.sky = rgb(0x14171C), p.floor = rgb(0x20262E), p.grid = rgb(0x2C343E), p.wall = rgb(0x3A4552);
        p.shadow = Colour{0, 0, 0, 0.55f}, p.chassis = rgb(0x8C98A6), p.wheel = rgb(0x0E1115),
        p.neutral = rgb(0xA4BAD4);
        // Channels differ in lightness where colour-blind eyes see one hue: red and heat, blue and smell, green and
        // oxygen.
        p.red_light = rgb(0xF0405C), p.green_light = rgb(0x84EC58), p.blue_light = rgb(0x3D84FF);
        p.heat = rgb(0xEFA06C), p.smell = rgb(0xC296F2);
        p.lamp = rgb(0xFFE3A0), p.oxygen = rgb(0x8CF5EA), p.obstacle = rgb(0x727F90);
        p.crate = rgb(0xB49A78), p.ice = rgb(0x4E6C84), p.carpet = rgb(0x463D49), p.sand = rgb(0x5C5341);
        p.tape = rgb(0x06080A), p.recharge = rgb(0xB6E36B);
    } else {
        p.ground = rgb(0xFFFFFF), p.panel = rgb(0xF6F7F9), p.raised = rgb(0xFFFFFF), p.line = rgb(0xCBD2DB);
        p.text = rgb(0x14171C), p.second_text = rgb(0x4A5562);
        p.accent = rgb(0x1F5FD0), p.on_accent = rgb(0xFFFFFF), p.warning = rgb(0xB3261E), p.success = rgb(0x1B7A43);
        p.sky = rgb(0xFFFFFF), p.floor = rgb(0xF2F4F7), p.grid = rgb(0xD5DBE3), p.wall = rgb(0xB4BEC9);
        p.shadow = Colour{0, 0, 0, 0.22f}, p.chassis = rgb(0x6C7885), p.wheel = rgb(0x2A3038),
        p.neutral = rgb(0x465873);
        // Pale yellow drowns in a projector's white: the lamp is amber there.
        p.red_light = rgb(0xA8203A), p.green_light = rgb(0x2EA035), p.blue_light = rgb(0x2A46D6);
        p.heat = rgb(0xE09660), p.smell = rgb(0x7D6CCB);
        p.lamp = rgb(0xD9A200), p.oxygen = rgb(0x35ADA8), p.obstacle = rgb(0x8595AA);
        p.crate = rgb(0xA88A60), p.ice = rgb(0xC3DCEE), p.carpet = rgb(0xC9BCCB), p.sand = rgb(0xE3D6B8);
        p.tape = rgb(0x20252C), p.recharge = rgb(0x5E8C14);
    }
    return p;
}

// The colour that stands for a role, and for what a channel carries.
constexpr Colour colour_of(const Palette& p, Role role) {
    return role == Role::predator ? p.predator : role == Role::prey ? p.prey : p.neutral;
}
constexpr Colour colour_of(const Palette& p, Channel channel) {
    switch (channel) {
        case Channel::light:
            return p.lamp;
        case Channel::red:
            return p.red_light;
        case Channel::green:
            return p.green_light;
        case Channel::blue:
            return p.blue_light;
        case Channel::heat:
            return p.heat;
        case Channel::memory:
            return p.memory;
        case Channel::touch:
        case Channel::floor:
        case Channel::energy:
            return p.neutral;
        case Channel::smell:
            return p.smell;
        case Channel::oxygen:
            return p.oxygen;
        case Channel::obstacle:
            return p.obstacle;
        case Channel::predator:
            return p.predator;
        case Channel::prey:
            return p.prey;
        case Channel::vehicle:
            return p.neutral;
    }
    return p.neutral;
}

}  // namespace braitenlab
