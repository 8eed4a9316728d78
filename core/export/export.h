// Exports a brain as a program for a robot: texts, without writing files.
#pragma once

#include <string>
#include <vector>

#include "core/export/plan.h"
#include "core/export/robot.h"

namespace braitenlab::robots {

struct ExportedFile {
    std::string name;  // below the folder of the export: "brain.h"
    std::string text;
};

// The files of an export. The brain is computed at the robot's rate; on an Arduino at a lower one where a step would
// not end in time, which its README says. Fails as make_plan() does, when the robot is not one of this target, and for
// a part that the target cannot hold: the message names the part and says what to do.
Result<std::vector<ExportedFile>> export_brain(const BrainToExport&, Target, const Robot&);

// What is exported, and yet does not work on the robot as in the lab, with what to do. Precondition: export_brain()
// exports it.
std::vector<Error> export_warnings(const BrainToExport&, const Robot&);

// How sigmoids and humps are computed: by expf(), or looked up between the values of a table in program memory, which
// is four times as fast on a processor without floating point and differs by at most 0.00003.
enum class Curves { computed, looked_up };

// One target's file or files. Precondition: the plan is made for the robot's rate.
std::string c_header(const Plan&, Curves = Curves::computed);
std::string c_readme(const Plan&);

}  // namespace braitenlab::robots
