// Theme, scale and fonts as applied to Dear ImGui, and the characters of the scene's labels: from a font of the system,
// else from the font of the window.
#pragma once

#include <string>

#include <imgui.h>

#include "render/text/lettering.h"
#include "render/view/palette.h"
#include "ui/widgets/theme.h"

namespace braitenlab {

class AppliedTheme {
public:
    // Applies theme and scale; does nothing where both are applied already. Returns true if the fonts have been loaded
    // again: the window must then upload the font atlas again. Call between frames.
    bool apply(Theme, float scale);

    const ui::Fonts& fonts() const { return loaded_.fonts; }
    const std::string& warning() const { return loaded_.warning; }  // about fonts; empty: none
    float scale() const { return scale_; }

private:
    ui::LoadedFonts loaded_;
    Theme theme_ = Theme::dark;
    float scale_ = 0;  // nothing applied yet
};

struct LabelFont {
    render::Lettering lettering;
    std::string warning;  // why the system's fonts are not used; empty: they are
};

// The file of the font for labels with this character (0: any): shipped with the program, else of the system.
std::string find_label_font(char32_t);

// Characters of `pixels` height from a font that `find` knows; from the fallback if there is none, whose atlas must
// have been built.
LabelFont label_font(const render::FindFont& find, int pixels, ImFont& fallback);

}  // namespace braitenlab
