// The theme of the window: applies palette, fonts and the 8 px grid to Dear ImGui.
#pragma once

#include <string>
#include <vector>

#include <imgui.h>

#include "render/view/palette.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// A palette's colour for Dear ImGui's draw list.
ImU32 paint(Colour);

// Contrast ratio of two opaque colours, 1..21, by the Web Content Accessibility Guidelines 2; 4.5 is readable.
float contrast(Colour, Colour);

// `wanted`, mixed with the least share of `text` that makes it readable on `ground` (contrast 4.5).
Colour legible(Colour wanted, Colour ground, Colour text);

// Ascent plus descent of Noto Sans, in em. Dear ImGui calls it the size of a font.
inline constexpr float line_height_em = 1.362f;

// The spacing grid, layout pixels: paddings and gaps of cards, bars and sheets are one of these.
namespace spacing {
inline constexpr float hair = 2, tight = 4, small = 8, medium = 12, large = 16, wide = 24;
}

// The one corner radius of all boxes, layout pixels: of cards, buttons, fields, sheets, and of rows and pictures inside
// them. A bar that shows a value is a mark: a larger radius would hide its end.
namespace radius {
inline constexpr float box = 6, bar = 2;
}

// Sets Dear ImGui's style. Call again when the theme or the scale changes, between frames.
void apply_theme(Theme, float scale);

struct FontPaths {
    std::string text, title;           // a regular and a bold face
    std::string icons;                 // Fork Awesome
    std::vector<std::string> symbols;  // faces with arrows and signs that the text face lacks, in order of preference
};

struct LoadedFonts {
    Fonts fonts;
    std::string warning;  // the file that could not be read and the effect; empty: no problem
};

// Adds the fonts at this scale (window pixels per layout pixel) to an empty atlas. Does not fail: a missing file is
// replaced by Dear ImGui's own font, and icons are left out.
LoadedFonts load_fonts(ImFontAtlas&, float scale, const FontPaths&);

}  // namespace braitenlab::ui
