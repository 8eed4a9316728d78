// The files of the students' progress: one JSON file a student in the folder `students` of the state folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/progress.h"
#include "core/result.h"

namespace braitenlab {

// Read at the start, written when something has changed. The name of a file is made of the student's name when he is
// added and stays the same; the name in the file counts.
class StudentFiles {
public:
    // With an empty folder nothing is read or written.
    explicit StudentFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Reads every student. `current`: the file of the student who worked last, without folder and extension. A file
    // that cannot be read is renamed to <name>.broken and reported.
    std::vector<Error> read(StudentBook&, const std::string& current);

    // Writes the students that differ from their files. An error is returned at the first failed attempt; later
    // attempts are silent until one succeeds.
    std::optional<Error> write(const StudentBook&);

    // The file of the student who works now, without folder and extension; empty for the first one.
    std::string current_file(const StudentBook&) const;

private:
    std::string free_stem(const std::string& name) const;

    struct OnDisk {
        std::string stem;
        StudentProgress written{};  // as the file has it; StudentProgress{}: no file yet
        bool failed = false;        // the last attempt to write, which is repeated
    };
    std::filesystem::path folder_;
    std::vector<OnDisk> files_;  // as StudentBook::all
};

}  // namespace braitenlab
