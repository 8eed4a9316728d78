// What every command of braitenctl promises about its outputs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"

namespace CLI {
class App;
}

namespace braitenlab {

// The text without what a terminal acts upon: control characters other than tab
// and line feed, and marks that change the direction of writing, are U+FFFD.
std::string terminal_text(std::string_view);

// While it exists, terminal_text() applies to all that is written to std::cout
// and std::cerr: titles, names and keys of files come from strangers.
class InertOutput {
public:
    InertOutput();
    ~InertOutput();
    InertOutput(const InertOutput&) = delete;
    InertOutput& operator=(const InertOutput&) = delete;

private:
    struct Filter;
    std::unique_ptr<Filter> out_, errors_;
};

// The error when a file that the command writes is one that it reads or writes
// already, also by another name of the same file, and when a table or drawing
// would replace a scene, a run or an archive. Call it after the arguments have
// been read.
std::optional<Error> output_over_input(const CLI::App& command);

// Writes what standard output still holds. Returns the exit code of the
// command; exit_code::bad_input in place of exit_code::done, with a message,
// when not all of its output could be written.
int end_with(int code);

}  // namespace braitenlab
