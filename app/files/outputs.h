// What a file that is written must not replace.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace braitenlab {

// What an output holds decides what it may replace: a run replaces a run, a scene a scene or a brain, a report (of
// --state and --anchors) a report.
enum class Written { table, page, run, scene, report };

struct Output {
    std::string option;
    std::filesystem::path path;
    Written what = Written::page;
    bool may_be_device = false;
};

// Standard output by a name of the file system, where it has one.
inline constexpr const char* standard_output_file = "/dev/stdout";

// True if both names are of one regular file, or of no file and lead to the same place.
bool is_same_file(const std::filesystem::path&, const std::filesystem::path&);

// True if replacing the file would lose a scene or another file of the lab, a run or an archive, whatever its name is.
bool loses_work(const std::filesystem::path&, Written);

// The shipped or given file, and the files that it names: those of a study, a breeding, an exercise or a lecture.
void add_with_named_files(const std::string& path_or_name, std::vector<std::filesystem::path>&);

// The error when an output is a file in `read`, standard output or an earlier output, also by another name of the same
// file; when it would lose work; and when it cannot be replaced at all, as a device. A table may go to "-", standard
// output.
std::optional<Error> output_fault(const std::vector<std::filesystem::path>& read, const std::vector<Output>&);

}  // namespace braitenlab
