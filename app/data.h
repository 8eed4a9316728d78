// Where the lab's own files lie: exercises, shaders, strings, and the fonts of the system.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

namespace braitenlab {

// The program's version, as in "0.1.0".
const char* version_text();

// The folder that holds exercises/, shaders/ and ui/: $BRAITENLAB_DATA, the checkout this was built from, or where it
// is installed. An error says where it looked.
Result<std::filesystem::path> data_folder();

// A path as it is, or the bare name of a shipped scene ("2a-coward") or exercise ("05-aggressor").
// An error names the nearest shipped one.
Result<std::filesystem::path> find_shipped(const std::string& path_or_name);

// The shipped exercises and scenes, each in their order.
std::vector<std::filesystem::path> shipped_exercises();
std::vector<std::filesystem::path> shipped_scenes();

// True for a file that lies in an exercise folder or says it has steps: an exercise rather than a scene.
bool is_exercise(const std::filesystem::path&);

// The first of the candidates that exists; empty when none does.
std::filesystem::path first_existing(const std::vector<std::filesystem::path>& candidates);

}  // namespace braitenlab
