// Targets of exports, and the robots that each of them is for. Pins, parts and limits are in the source of the target.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "core/enum_table.h"

namespace braitenlab::robots {

enum class Target { c, arduino, thymio, micropython, opamp };

struct TargetTraits {
    Target value;
    std::string_view word;   // on the command line
    std::string_view robot;  // name of the robot that is taken when none is given
};

inline constexpr auto target_table = std::to_array<TargetTraits>({
    {Target::c, "c", "any"},
    {Target::arduino, "arduino", "tt2wd-ldr"},
    {Target::thymio, "thymio", "thymio2"},
    {Target::micropython, "micropython", "microbit"},
    {Target::opamp, "opamp", "lm324"},
});
constexpr const auto& table_of(Target) { return target_table; }
static_assert(is_complete_table<target_table>());

struct Robot {
    std::string_view name;  // "tt2wd-ldr"
    Target target;
    int rate_hz;             // calls of the brain per second
    bool is_thymio = false;  // its sensors and motors are built in: the program is for them, without pins and parts

    // Of keys of strings, ids of widgets and names of folders: the word of the target, or the robot's name where the
    // target takes another robot by default.
    constexpr std::string_view word() const { return row_of(target).robot == name ? row_of(target).word : name; }
};

// In the order of docs/robots.md. The first one is any robot that runs C.
std::span<const Robot> robots();

// The robot of this name, or null.
const Robot* find_robot(std::string_view name);

}  // namespace braitenlab::robots
