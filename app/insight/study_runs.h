// The study on its sheet: its runs are computed in the background while it runs, and it can be stopped and continued.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/study_files.h"
#include "app/jobs/jobs.h"
#include "core/insight/study.h"
#include "core/result.h"

namespace braitenlab {

struct Lab;
struct StudyRequest;
struct StudyView;

struct StudyRuns {
    std::shared_ptr<const insight::StudyBase> base{};  // null: none is open
    std::optional<Error> error{};                      // why the last one could not be opened
    std::vector<insight::StudyRow> rows{};             // complete runs, in order
    bool runs = false;
    int shown = 0;                                           // increases with each file that is opened and shown
    std::filesystem::path file{};                            // of the study; empty: shipped, or built and not saved
    std::string scene_text{};                                // of a study that is built and not saved
    std::optional<StudyTable> table{};                       // nullopt: in memory only
    std::size_t begun = 0;                                   // runs
    std::deque<Job<std::vector<insight::StudyRow>>> jobs{};  // in the order of the runs
};

// Executes a request. StudyEdit::save is put into Lab::files.
void handle_study(Lab&, const StudyRequest&);

// Writes a built study and its scene into the folder, and the table of a study with a file beside it; what is already
// written stays. From then on each complete run is added to the table. Returns the path of the table.
// Precondition: a study is open and does not ship with the lab.
Result<std::filesystem::path> save_study(StudyRuns&, const std::filesystem::path& folder);

// Opens the study of a file and shows its sheet.
void show_study(StudyRuns&, const std::string& path);

// Call once per turn, after Jobs::deliver.
void update_study(StudyRuns&, Jobs&);

StudyView study_of(const StudyRuns&);

}  // namespace braitenlab
