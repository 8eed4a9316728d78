// Hashes of the shipped scenes and exercises after a run. They are the same on every platform and with every compiler;
// tests/golden/hashes.json has them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/result.h"

namespace braitenlab {

// By the stem of the file: sixteen hexadecimal digits, World::hash() after the run.
using Hashes = std::map<std::string, std::string>;

// Runs every scene of `exercises`/scenes with seed 1 and, with its own seed and the brain as shipped, every exercise of
// `exercises`/guided for `seconds` of simulated time. An error if a file cannot be opened.
Result<Hashes> hashes_of_shipped(const std::filesystem::path& exercises, double seconds);

// A JSON object of names and hashes. Errors carry the file.
Result<Hashes> read_hashes(const std::filesystem::path&);
std::string write_hashes(const Hashes&);

// A line for each name whose hash differs or that only one of them has.
std::vector<std::string> differences(const Hashes& computed, const Hashes& expected);

}  // namespace braitenlab
