// What every command of braitenctl promises about its outputs.
#pragma once

#include <optional>

#include "core/result.h"

namespace CLI {
class App;
}

namespace braitenlab {

// The error when a file that the command writes is one that it reads, also by another name of the same file. Call it
// after the arguments have been read.
std::optional<Error> output_over_input(const CLI::App& command);

// Writes what standard output still holds. Returns the exit code of the command; exit_code::bad_input in place of
// exit_code::done, with a message, when not all of its output could be written.
int end_with(int code);

}  // namespace braitenlab
