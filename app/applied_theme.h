// Theme, scale and fonts as applied to Dear ImGui.
#pragma once

#include <string>

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

}  // namespace braitenlab
