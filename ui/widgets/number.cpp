#include "ui/widgets/number.h"

#include <cmath>
#include <cstdlib>

namespace braitenlab::ui {

std::optional<float> typed_number(std::string_view typed) {
    std::string plain;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        if (typed.substr(i, 3) == "−") {
            plain += '-';
            i += 2;
        } else if (typed[i] != ' ') {
            plain += typed[i] == ',' ? '.' : typed[i];
        }
    }
    // strtof, because libc++ has no from_chars for floating point. The program uses the C locale only.
    char* end = nullptr;
    const float value = std::strtof(plain.c_str(), &end);
    if (plain.empty() || end != plain.c_str() + plain.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace braitenlab::ui
