// A brain as one MicroPython program for a Thymio 3.
#pragma once

#include <optional>
#include <string>

#include "core/export/plan.h"
#include "core/result.h"

namespace braitenlab::robots::thymio3 {

// Bytes of a program that the robot takes: PYTHON_SCRIPT_LIMIT in src/thymio/on-robot-ann.js of
// github.com/FrancescoMondada/Thymio3-ANN-Edu; "2 KB limit" in src/python.ts of github.com/Mobsya/thymio3-ts-api. Newer
// firmware takes 51,200 (MAX_MP_SCRIPT_LEN of github.com/Mobsya/thymio3-firmware-esp32).
inline constexpr int largest_program = 2000;

// The first part that the robot cannot hold, with its name: a sensor that a Thymio does not have, two sensors for the
// same place, a program too large.
std::optional<Error> refusal(const Plan&);

// brain.py: the brain, calibration values and the loop; without comments where it is too large with them. Precondition:
// each sensor has a place on the robot.
std::string program(const Plan&);

std::string readme(const Plan&);

}  // namespace braitenlab::robots::thymio3
