// What a person has chosen for every scene: changed in the settings card, remembered between starts.
#pragma once

#include <string>

#include "render/view/palette.h"

namespace braitenlab {

struct Preferences {
    Theme theme = Theme::dark;
    std::string language = "en";  // by the code of its file
    float type_size = 1;          // 1..2, times what the display asks for
    bool reduce_motion = false;   // no easing, no pulsing
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

inline constexpr float least_type_size = 1, largest_type_size = 2;

}  // namespace braitenlab
