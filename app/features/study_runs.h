// The study on its sheet: its runs are computed in the background while it runs, and it can be stopped and continued,
// also by the next start of the lab.
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

struct Workspace;
struct StudyRequest;
struct StudyView;

struct StudyRuns {
    std::shared_ptr<const insight::StudyBase> base{};  // null: none is open
    std::optional<Error> error{};                      // why the last one could not be opened
    std::vector<insight::StudyRow> rows{};             // complete runs, in order
    bool runs = false;
    int shown = 0;                      // increases with each file that is opened and shown
    std::string last{};                 // name or path of the study opened or built last; empty: none
    std::filesystem::path kept_in{};    // folder for studies without a file or a table; empty: none
    std::filesystem::path file{};       // of the study; empty: shipped, or built and not saved
    std::string scene_text{};           // of a study that is built and not saved
    std::optional<StudyTable> table{};  // beside the study's file; nullopt: not saved
    std::optional<StudyTable> kept{};   // without `table`, in `kept_in`; nullopt: in memory only
    std::size_t begun = 0;              // runs
    std::deque<Job<std::vector<insight::StudyRow>>> jobs{};  // in the order of the runs
};

// Sets the folder, and what an earlier start of the lab had as `last`. A study that is gone is forgotten.
void begin_studies(StudyRuns&, std::filesystem::path kept_in, const std::string& last);

// Executes a request, except StudyEdit::save and figure, which need files.
void handle_study(StudyRuns&, const Workspace&, const StudyRequest&);

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
