// A brain as MicroPython for a BBC micro:bit with a motor driver.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/export/plan.h"
#include "core/result.h"

namespace braitenlab::robots::micropython {

inline constexpr int analog_inputs = 3;     // P0 to P2; other analog pins drive the display
inline constexpr int largest_brain = 2500;  // bytes of brain.py; tests run one of this size on 16 KB of memory

// What a micro:bit of version 1 gives to parts outside it when USB supplies it (tech.microbit.org); one of version 2
// gives 190 mA.
inline constexpr double version_1_milliamperes = 90;

// The first part that the robot cannot hold, with its name: a sensor without a part or without a pin, a brain too
// large.
std::optional<Error> refusal(const Plan&);

// The refusal of a program of this many bytes: it names the neuron or motor with the longest part of it.
Error too_large(const Plan&, std::size_t bytes, std::string_view robot, int largest);

// True when think_py() needs exp() of the module math.
bool needs_exp(const Plan&);

// The constant RATE_HZ, kept values, curves and the function think(). Its parameters are Input::id, in order.
std::string think_py(const Plan&);

// brain.py: the function think(), also valid in CPython 3. Needs the module math only, for sigmoids and humps.
std::string brain_py(const Plan&);

// main.py: pins and the loop. calibrate.py, which it imports at the first start: the calibration by the buttons.
std::string main_py(const Plan&);
std::string calibrate_py(const Plan&);

std::string readme(const Plan&);
std::string parts_csv(const Plan&);
std::string wiring_svg(const Plan&);

}  // namespace braitenlab::robots::micropython
