// Arrows on keys. The text face has none, and those that stand in for them are small: the icons' are as large as other
// keys.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "ui/widgets/paint.h"
#include "ui/widgets/ui.h"

namespace braitenlab {

inline std::string with_large_arrows(const Ui& ui, std::string text) {
    if (!has_icons(ui)) return text;
    constexpr std::array<std::array<std::string_view, 2>, 4> arrows{
        {{"←", "\uf060"}, {"→", "\uf061"}, {"↑", "\uf062"}, {"↓", "\uf063"}}};
    for (const auto& [small, large] : arrows)
        for (std::size_t at = text.find(small); at != text.npos; at = text.find(small))
            text.replace(at, small.size(), large);
    return text;
}

}  // namespace braitenlab
