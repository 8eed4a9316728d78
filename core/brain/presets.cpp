#include "core/brain/presets.h"

#include <array>

namespace braitenlab {

std::span<const Preset> presets() {
    static constexpr std::array<Preset, 6> list{{
        {"1-alive", {.LL = 0.5f, .LR = 0.5f, .RL = 0.5f, .RR = 0.5f}},
        {"2a-coward", {.LL = 1.5f, .RR = 1.5f, .LM = 0.1f, .RM = 0.1f}},
        {"2b-aggressor", {.LR = 1.5f, .RL = 1.5f, .LM = 0.1f, .RM = 0.1f}},
        {"2c", {.LL = 0.75f, .LR = 0.75f, .RL = 0.75f, .RR = 0.75f, .LM = 0.1f, .RM = 0.1f}},
        {"3a-love", {.LL = -1.0f, .RR = -1.0f, .LM = 0.5f, .RM = 0.5f}},
        {"3b-explorer", {.LR = -1.0f, .RL = -1.0f, .LM = 0.6f, .RM = 0.6f}},
    }};
    return list;
}

}  // namespace braitenlab
