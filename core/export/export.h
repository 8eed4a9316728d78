// Exports a brain as a program for a robot: texts, without writing files.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/export/plan.h"
#include "core/export/robot.h"

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

struct ExportedFile {
    std::string name;  // below the folder of the export: "brain.h"
    std::string text;
};

// The files of an export. The brain is computed at the robot's rate. Fails as make_plan() does, when the robot is not
// one of this target, and for a part that the target cannot hold: the message names the part and says what to do.
Result<std::vector<ExportedFile>> export_brain(const BrainToExport&, Target, const Robot&);

// One target's file or files. Precondition: the plan is made for the robot's rate.
std::string c_header(const Plan&);

}  // namespace braitenlab::robots
