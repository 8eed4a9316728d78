// Every colour of the lab, in one place: the window's and the scene's, for the desk (dark) and the projector (light).
//
// The colours of meaning are from M. Okabe and K. Ito, "Color Universal Design" (2008), and stay apart for colour-blind
// eyes; some are darker on the light floor. One colour has one meaning, and a shape, a sign or a word says it too.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/enum_table.h"
#include "core/scene/scene.h"
#include "core/world/snapshot.h"

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

// The colour of "#rrggbb"; nullopt for other text.
inline std::optional<Colour> colour_of(std::string_view text) {
    std::uint32_t hex = 0;
    if (!is_colour(text)) return std::nullopt;
    std::from_chars(text.data() + 1, text.data() + text.size(), hex, 16);
    return rgb(hex);
}

constexpr Colour mix(Colour a, Colour b, float t) {
    return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t, a.a + (b.a - a.a) * t};
}

enum class Theme { dark, light };
inline constexpr std::array<std::string_view, 2> theme_words{"dark", "light"};
static_assert(has_enumerators<Theme, theme_words.size()>());
constexpr std::string_view word(Theme theme) { return theme_words[static_cast<std::size_t>(theme)]; }

// The colours of a channel, 0xRRGGBB. Channels differ in lightness where colour-blind eyes see one hue: red and heat,
// blue and smell, green and oxygen. In the light theme white light is amber: pale yellow is invisible on a projector's
// white.
struct ChannelColours {
    Channel channel;
    std::uint32_t dark, light;  // by theme
};
inline constexpr auto channel_colours = std::to_array<ChannelColours>({
    {Channel::light, 0xFFDB8C, 0xC28400},
    {Channel::red, 0xF0405C, 0xA8203A},
    {Channel::green, 0x84EC58, 0x1D8C2C},
    {Channel::blue, 0x3D84FF, 0x2A46D6},
    {Channel::heat, 0xEFA06C, 0xC5805C},
    {Channel::smell, 0xC296F2, 0x7D6CCB},
    {Channel::oxygen, 0x8CF5EA, 0x309F9A},
    {Channel::obstacle, 0x727F90, 0x7F8FA4},
    {Channel::predator, 0xD55E00, 0xD55E00},
    {Channel::prey, 0x009E73, 0x009E73},
    {Channel::vehicle, 0xA4BAD4, 0x465873},
    {Channel::memory, 0xCC79A7, 0xC673A1},
    {Channel::touch, 0xA4BAD4, 0x465873},
    {Channel::floor, 0xA4BAD4, 0x465873},
    {Channel::energy, 0xA4BAD4, 0x465873},
    {Channel::random, 0xA4BAD4, 0x465873},
});
static_assert(channel_colours.size() == channel_table.size() &&
                  std::equal(channel_colours.begin(), channel_colours.end(), channel_table.begin(),
                             [](auto& colours, auto& row) { return colours.channel == row.value; }),
              "channel_colours needs one row per channel, in the order of Channel");

struct Palette {
    // the window
    Colour ground, panel, raised, line, text, second_text, accent, on_accent, warning, success;
    // the scene; rim: the walls of the arena; wall: a faded body; solid: an obstacle
    Colour sky, floor, grid, wall, rim, shadow, chassis, wheel, solid;
    // meaning
    Colour excites, inhibits, selected;
    // the runs of the brains in slots A and B
    Colour slot_a, slot_b;
    // what can be pushed, and pieces of floor
    Colour crate, ice, carpet, sand, tape, recharge;
    // what a channel carries; index: Channel
    std::array<Colour, channel_count> channels;
    // the same colours under the names of the things that have them
    Colour lamp, predator, prey, neutral, memory, obstacle;
};

constexpr Colour colour_of(const Palette& p, Channel channel) { return p.channels[static_cast<std::size_t>(channel)]; }

// The colour of a surface; of the plain floor for `none`.
constexpr Colour colour_of(const Palette& p, Surface surface) {
    switch (surface) {
        case Surface::ice:
            return p.ice;
        case Surface::carpet:
            return p.carpet;
        case Surface::sand:
            return p.sand;
        case Surface::tape:
            return p.tape;
        case Surface::none:
            break;
    }
    return p.floor;
}

constexpr Colour colour_of(const Palette& p, Role role) {
    return role == Role::predator ? p.predator : role == Role::prey ? p.prey : p.neutral;
}

// The vehicle's own colour, else that of its kind, else that of its role.
inline Colour colour_of(const Palette& p, const Snapshot& now, const VehicleView& vehicle) {
    if (const auto own = colour_of(look_of(now, vehicle).colour)) return *own;
    return colour_of(kind_of(now, vehicle).colour).value_or(colour_of(p, vehicle.role));
}

constexpr Palette palette(Theme theme) {
    Palette p{};
    p.excites = rgb(0xE69F00);
    p.inhibits = rgb(0x56B4E9);
    p.selected = rgb(0xF0E442);
    for (const ChannelColours& row : channel_colours)
        p.channels[static_cast<std::size_t>(row.channel)] = rgb(theme == Theme::dark ? row.dark : row.light);
    p.lamp = colour_of(p, Channel::light), p.neutral = rgb(theme == Theme::dark ? 0x9DB8E8 : 0x6F8FC4);
    p.predator = colour_of(p, Channel::predator), p.prey = colour_of(p, Channel::prey);
    p.memory = colour_of(p, Channel::memory), p.obstacle = colour_of(p, Channel::obstacle);
    if (theme == Theme::dark) {
        p.ground = rgb(0x14171C), p.panel = rgb(0x1C2128), p.raised = rgb(0x262D36), p.line = rgb(0x343D48);
        p.text = rgb(0xE6EAF0), p.second_text = rgb(0xA9B4C0);
        p.accent = rgb(0x4C8DFF), p.on_accent = rgb(0x0B1220), p.warning = rgb(0xFF8A70), p.success = rgb(0x6FCF97);
        p.sky = rgb(0x0B0F1C), p.floor = rgb(0x202B4B), p.grid = rgb(0x35426A), p.wall = rgb(0x3A4552);
        p.rim = rgb(0x7A5A40), p.solid = rgb(0x98A4CC);
        p.shadow = Colour{0, 0, 0, 0.68f}, p.chassis = rgb(0x8C98A6), p.wheel = rgb(0x0E1115);
        p.crate = rgb(0xB49A78), p.ice = rgb(0x4E6C84), p.carpet = rgb(0x463D49), p.sand = rgb(0x5C5341);
        p.slot_a = rgb(0x63B3FF), p.slot_b = rgb(0xFF9BD2);
        p.tape = rgb(0x06080A), p.recharge = rgb(0xB6E36B);
    } else {
        p.ground = rgb(0xFFFFFF), p.panel = rgb(0xF6F7F9), p.raised = rgb(0xFFFFFF), p.line = rgb(0xCBD2DB);
        p.text = rgb(0x14171C), p.second_text = rgb(0x4A5562);
        p.accent = rgb(0x1F5FD0), p.on_accent = rgb(0xFFFFFF), p.warning = rgb(0xB3261E), p.success = rgb(0x1B7A43);
        p.sky = rgb(0xDAD6D0), p.floor = rgb(0xD4CFC7), p.grid = rgb(0xC6C0B7), p.wall = rgb(0xB4BEC9);
        p.rim = rgb(0xD8B88B), p.solid = rgb(0xCED2D6);
        p.shadow = Colour{0, 0, 0, 0.32f}, p.chassis = rgb(0x6C7885), p.wheel = rgb(0x2A3038);
        p.crate = rgb(0xA88A60), p.ice = rgb(0xC3DCEE), p.carpet = rgb(0xC9BCCB), p.sand = rgb(0xE3D6B8);
        p.slot_a = rgb(0x1456C8), p.slot_b = rgb(0xB01E78);
        p.tape = rgb(0x20252C), p.recharge = rgb(0x5E8C14);
    }
    return p;
}

}  // namespace braitenlab
