// Files of studies: the study with its scene, and the table of its runs, which can be interrupted and continued.
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/platform/platform.h"
#include "core/insight/study.h"
#include "core/io/csv.h"
#include "core/result.h"

namespace braitenlab {

// The studies that ship with the program; a broken file is left out.
std::vector<insight::Study> shipped_study_list();

// The study and its scene: a path relative to the study's file, or the name of a shipped scene.
Result<std::shared_ptr<const insight::StudyBase>> load_study(const std::filesystem::path&);

// Every independent error of the study and of its scene, for a study that cannot be loaded.
std::vector<Error> errors_of_study(const std::filesystem::path&);

// A locked file, which is removed with the lock if it is empty: a file of this name that is not a lock's stays.
struct HeldLock {
    std::filesystem::path path;
    std::optional<FileLock> lock;

    HeldLock(std::filesystem::path of, FileLock held) : path(std::move(of)), lock(std::move(held)) {}
    HeldLock(const HeldLock&) = delete;
    HeldLock& operator=(const HeldLock&) = delete;
    ~HeldLock();
};

// What begin() does with runs of another study in the unfinished table.
enum class OtherRuns { stay, make_room };

// The table of a study. While runs are missing, those that are complete are in PATH.part, which begins with a line that
// names the study. The next begin() for the same study and path continues with them.
class StudyTable {
public:
    // An empty path: the table is in memory only.
    StudyTable(std::shared_ptr<const insight::StudyBase>, const std::string& path, OtherRuns = OtherRuns::stay);

    // Takes over the runs of the unfinished table, or of a complete one that is newer than the files of the study.
    // Writes nothing.
    void read(const std::vector<std::filesystem::path>& files_of_study);

    // Reads the unfinished table. Fails if the file cannot be written, while another program, or another table in this
    // one, writes it, if it is no unfinished table, and, with OtherRuns::stay, if it has runs of another study.
    std::optional<Error> begin();

    // The next runs in order. They are in the file when it returns.
    std::optional<Error> add(const std::vector<insight::StudyRow>&);

    // Precondition: all runs are there. Writes the table in the style to the path and removes the unfinished one.
    std::optional<Error> finish(const io::CsvStyle& = {});

    bool is_begun() const { return file_.is_open(); }
    const std::filesystem::path& path() const { return path_; }
    const std::vector<insight::StudyRow>& rows() const { return rows_; }  // complete runs, in order
    std::string text() const;                                             // header and these rows
    std::filesystem::path unfinished() const;                             // empty for a table in memory

private:
    std::string name_line() const;
    std::string take_lines(const std::filesystem::path&, const std::string& first);
    std::optional<Error> unfinished_fault() const;

    std::shared_ptr<const insight::StudyBase> base_;
    std::filesystem::path path_;
    OtherRuns other_runs_;
    std::ofstream file_;              // the unfinished table
    std::unique_ptr<HeldLock> lock_;  // from begin() to finish(), on a file beside it
    std::vector<insight::StudyRow> rows_;
};

// Writes a study and its scene into a folder under free names: ID.toml and ID-scene.toml, ID-2.toml … Files with the
// same content are used as they are. Returns the path of the study's file.
Result<std::filesystem::path> write_study_files(const insight::Study&, const std::string& scene_text,
                                                const std::filesystem::path& folder);

// The path of the table beside the file of a study: NAME.csv, or NAME-2.csv … where a file has that name and is no
// table of this study.
std::filesystem::path table_of_study(const std::filesystem::path& study_file, const insight::Study&);

}  // namespace braitenlab
