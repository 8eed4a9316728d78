// A run in a file: it can be closed, and gone on with another day exactly as it would have gone on.
//
// The file is JSON, written and read by programs: the scene as it was opened, the last keyframe, and the commands and
// ticks since. Its name ends in `.run`.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"
#include "core/world/save.h"

namespace braitenlab {

inline constexpr std::string_view run_ending = ".run";

std::string write_run(const SavedRun&);

// Never trusts the file: fails, with what is wrong, unless everything in it could have come from write_run().
Result<SavedRun> read_run(std::string_view text, std::string file_name);
Result<SavedRun> load_run(const std::filesystem::path&);

}  // namespace braitenlab
