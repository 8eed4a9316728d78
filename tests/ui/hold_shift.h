// Shift for frames with synthetic input.
#pragma once

#include <imgui.h>

#include "ui/key_queue.h"

namespace braitenlab::tests {

// Holds or releases Shift for the next frames, as the window does: Dear ImGui overwrites io.KeyShift from 1.87 on.
inline void hold_shift(bool down) { ui::hand_over(ui::KeysOfAFrame{}, {.shift = down}, ImGui::GetIO()); }

}  // namespace braitenlab::tests
