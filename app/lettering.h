// The characters of the scene's labels, from a font of the system, else from the font of the window.
#pragma once

#include <string>

#include <imgui.h>

#include "render/text/lettering.h"

namespace braitenlab {

// Copies the glyphs of an ImGui font. Precondition: its atlas has been built.
render::Lettering lettering_of(ImFont&);

struct LabelFont {
    render::Lettering lettering;
    std::string warning;  // why the system's fonts are not used; empty: they are
};

// Characters of `pixels` height from a font that `find` knows; from the fallback if there is none.
LabelFont label_font(const render::FindFont& find, int pixels, ImFont& fallback);

}  // namespace braitenlab
