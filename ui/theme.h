// The look of the window: how the palette, the fonts and the 8 px grid reach Dear ImGui. Nothing is coloured elsewhere.
#pragma once

#include <string>
#include <vector>

#include <imgui.h>

#include "render/view/palette.h"
#include "ui/widgets/ui.h"

namespace braitenlab {

// A palette's colour as Dear ImGui's draw list wants it.
ImU32 paint(Colour);

// How far two opaque colours stand apart, 1..21, by the Web Content Accessibility Guidelines 2: 4.5 is readable.
float contrast(Colour, Colour);

// `wanted`, moved towards `text` just as far as it takes to be readable on `ground` (contrast of 4.5).
Colour legible(Colour wanted, Colour ground, Colour text);

// Sets Dear ImGui's style. Call again when the theme or the scale changes, between frames.
void apply_theme(Theme, float scale);

struct FontPaths {
    std::string text, title;           // a regular and a bold face
    std::string icons;                 // Fork Awesome
    std::vector<std::string> symbols;  // faces asked in turn for arrows and signs that the text face lacks
};

struct LoadedFonts {
    Fonts fonts;
    std::string warning;  // which file could not be read and what happens instead; empty when all is well
};

// Adds the lab's fonts at this scale (window pixels per layout pixel) to an atlas without fonts. Never fails: where a
// file is missing, Dear ImGui's own font stands in, and icons are left out.
LoadedFonts load_fonts(ImFontAtlas&, float scale, const FontPaths&);

}  // namespace braitenlab
