// State of the sheet that exports a brain to a robot.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/export/export.h"
#include "ui/lab_view.h"
#include "ui/widgets/text_field.h"

namespace braitenlab::ui {

struct RobotState {
    const robots::Robot* robot = robots::find_robot("tt2wd-ldr");  // stays for the next time
    TextField folder;                                              // empty: suggested_folder()
    // Of the brain and the robot; null until the sheet is drawn.
    std::shared_ptr<const Result<std::vector<robots::ExportedFile>>> made;
    std::vector<Error> warnings;                   // of `made`
    bool begun = false;                            // drawn at least once since it was opened
    bool asked = false;                            // a request is in progress, or was refused
    int done = 0;                                  // FilesView::done at the request; larger: it is written
    std::string replacing;                         // folder with existing files, until the user confirms
    std::shared_ptr<const BrainGraph> brain;       // that `made` is about
    const robots::Robot* robot_of_made = nullptr;  // that `made` is about
};

// Prepares the sheet for the selected vehicle.
void begin_robot(RobotState&);

// The brain of the selected vehicle with its sensors; its title says "changed" where the file has no such brain.
// Precondition: the vehicle is in the snapshot.
robots::BrainToExport brain_to_export(const LabView&, const VehicleView&);

// "2a-coward-arduino": the folder taken without a name.
std::string suggested_folder(const LabView&, const robots::Robot&);

}  // namespace braitenlab::ui
