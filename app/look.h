// Theme, scale and fonts as Dear ImGui wears them now.
#pragma once

#include <string>

#include "render/view/palette.h"
#include "ui/theme.h"

namespace braitenlab {

class Look {
public:
    // Puts theme and scale on; does nothing where it wears them already. True when the fonts were made anew: the
    // window must then forget the old ones. Call between frames.
    bool wear(Theme, float scale);

    const Fonts& fonts() const { return loaded_.fonts; }
    const std::string& warning() const { return loaded_.warning; }  // about fonts; empty when all is well
    float scale() const { return scale_; }

private:
    LoadedFonts loaded_;
    Theme theme_ = Theme::dark;
    float scale_ = 0;  // none yet
};

}  // namespace braitenlab
