// The characters of the scene's labels: from the system's fonts, else from the window's own.
#pragma once

#include <string>

#include <imgui.h>

#include "render/text/lettering.h"

namespace braitenlab {

// A copy of what an ImGui font has drawn into its atlas. Its atlas must have been built.
Lettering lettering_of(ImFont&);

struct LabelFont {
    Lettering lettering;
    std::string warning;  // why the system's fonts were not used; empty when they were
};

// Characters `pixels` high from a font that `find` knows; without one, the window's own.
LabelFont label_font(const FindFont& find, int pixels, ImFont& fallback);

}  // namespace braitenlab
