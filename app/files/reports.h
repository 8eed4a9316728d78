// Files that a person makes of the open exercise and of a study: the hand-in, the lab record, the figure of a study.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "app/lab.h"
#include "core/lesson/hand_in.h"
#include "ui/words/strings.h"

namespace braitenlab {

using WrittenAt = std::chrono::system_clock::time_point;

// What the student hands in now. Precondition: an exercise is open.
HandIn hand_in_of(const Lab&, const std::string& student, WrittenAt);

// The folder of hand-ins, lab records and tables of progress: "Braitenlab" in the user's folder of documents.
std::filesystem::path reports_folder(const std::filesystem::path& documents);

// Executes and clears Lab::reports. Call once a turn. Files are written to reports_folder(), which is created. A
// hand-in replaces the earlier one of the same student for the exercise, never another student's. Where it changes what
// the exercise does not offer, and where the earlier one has passed more starts and the request only asks, nothing is
// written: Attempt::Work::refused says why until the reason has gone. A figure is a new file. Success is shown as a
// notice with the path, in a browser with the name among the downloads, failure as a notice with the reason. Without an
// exercise, or without a study whose runs are complete, that request writes nothing.
void write_report_files(Lab&, const Strings&, const std::filesystem::path& documents, WrittenAt);

}  // namespace braitenlab
