// Run files: a run can be stored and continued later exactly as it would have gone on.
//
// The file is JSON: the scene as it was opened, the last keyframe, and the commands and ticks since. Its extension is
// `.run`.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"
#include "core/world/world.h"

namespace braitenlab::io {

inline constexpr std::string_view run_ending = ".run";

std::string write_run(const SavedRun&);

// Fails with the reason unless write_run() could have written the file. Values that older versions did not write get
// their defaults.
Result<SavedRun> read_run(std::string_view text, std::string file_name);
Result<SavedRun> load_run(const std::filesystem::path&);

}  // namespace braitenlab::io
