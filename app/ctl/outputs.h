// What every command of braitenctl promises about its outputs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace CLI {
class App;
}

namespace braitenlab {

// The error when an output of the command, standard output included, is a file
// that it reads, also one that a file names or a folder holds, or an output
// that it has already, also by another name of the same file; when it would
// replace a file of the lab or an archive, except a run by --save and a scene or
// a brain by --out; and when it cannot be replaced at all, as a device. Call it
// after the arguments have been read, before anything is written.
std::optional<Error> output_fault(const CLI::App& command);

// The same for the files that an export writes, whose names are known late. `read`: the file of the brain.
std::optional<Error> output_fault(const std::string& read, const std::vector<std::filesystem::path>& written);

// Writes what standard output still holds. Returns the exit code of the
// command; exit_code::bad_input, with a message, unless it was interrupted,
// when not all of its output could be written.
int end_with(int code);

}  // namespace braitenlab
