// Run files: store a run and continue it later, identical to the uninterrupted run.
//
// The file is JSON with the extension `.run`. It contains the scene without edits, the last keyframe, and the commands
// and the number of ticks since. Where the brain of a kind is hidden, all of it is sealed (core/scene/sealed.h).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/world/world.h"

namespace braitenlab::io {

inline constexpr std::string_view run_ending = ".run";
inline constexpr std::uintmax_t most_run_bytes = std::uintmax_t{256} << 20U;  // of a run or an autosave

// always: sealed also where no kind is hidden, as for an exercise that hides a brain.
enum class Seals { hidden_kinds, always };
std::string write_run(const SavedRun&, Seals = Seals::hidden_kinds);

// Hides the brains of the kinds of these names, so that a file of the scene or the run is sealed and hides them when it
// is opened.
void hide_brains(Scene&, const std::vector<std::string>& kinds);
void hide_brains(SavedRun&, const std::vector<std::string>& kinds);

// Returns an error with the reason for a file that write_run() cannot have written. A missing value is an error.
Result<SavedRun> read_run(std::string_view text, std::string file_name);
Result<SavedRun> load_run(const std::filesystem::path&);  // fails as read_text() and read_run()

}  // namespace braitenlab::io
