// What to do about a syntax error of a TOML file, found from the text of its line.
#pragma once

#include <optional>
#include <string_view>

#include "core/messages.h"

namespace braitenlab {

// "; write 0.6, with a point", or empty where the cause is not known. `line`: of the error, from 1.
Message toml_advice(std::string_view text, int line);

// Where a text of several lines begins that has no end: the parser finds that at the end of the file.
struct OpenText {
    int line = 0;
    std::string_view quotes{};  // three of them
};
std::optional<OpenText> open_text(std::string_view text);

// The line of a list that is not closed although the next key or heading, at `line`, begins: there the parser finds the
// error. 0: there is none.
int line_of_open_list(std::string_view text, int line);

}  // namespace braitenlab
