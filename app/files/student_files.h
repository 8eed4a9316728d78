// The files of the students' progress: one JSON file a student in the folder `students` of the state folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/platform/platform.h"
#include "core/lesson/progress.h"
#include "core/result.h"

namespace braitenlab {

// Read at the start, written when something has changed. The name of a file is made of the student's name when the
// student is added and stays the same; the name in the file counts. Several windows may have the same students: what
// another one has written since is merged before writing, and also where nothing is to be written.
class StudentFiles {
public:
    // With an empty folder nothing is read or written.
    explicit StudentFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Reads every student. `current`: the file of the student who worked last, without folder and extension. A file
    // that cannot be read is renamed to <name>.broken and reported. A file that is not used, because another one has
    // the same student, stays as it is and is reported.
    std::vector<Error> read(StudentBook&, const std::string& current);

    struct Written {
        std::optional<Error> failed{};  // of the first failed attempt; later ones are silent until one succeeds
        bool merged = false;            // the book has taken over changes of another window
    };
    // Writes the students that differ from their files, and takes over what another window has written since. While
    // the student has no name, a student whom another window has added since read() becomes the current one.
    Written write(StudentBook&);

    // The file of the student who works now, without folder and extension; empty for the first one.
    std::string current_file(const StudentBook&) const;

private:
    struct OnDisk {
        std::string stem;
        StudentProgress written{};  // as it was read or written last; StudentProgress{}: not yet
        std::string text{};         // of the file then
        std::pair<std::filesystem::file_time_type, std::uintmax_t> stamp{};  // its time and size then
        bool failed = false;  // the last attempt to write, which is repeated
    };
    std::filesystem::path path_of(const OnDisk& file) const { return folder_ / (file.stem + ".json"); }
    std::pair<std::filesystem::file_time_type, std::uintmax_t> stamp_of(const OnDisk&) const;
    bool follow_name(StudentBook&);
    std::string free_stem(const std::string& name) const;
    std::string stem_for(const std::string& name) const;
    std::optional<Error> unused(const std::filesystem::path&, const StudentProgress&, const StudentBook&) const;
    std::optional<FileLock> locked() const;
    std::optional<Error> merge(OnDisk&, StudentProgress&, Written&) const;
    std::optional<Error> write(OnDisk&, StudentProgress&, Written&) const;
    std::filesystem::path folder_;
    std::vector<OnDisk> files_;        // as StudentBook::all
    std::vector<std::string> unused_;  // stems of files that were there when they were read, or were tried since
};

}  // namespace braitenlab
