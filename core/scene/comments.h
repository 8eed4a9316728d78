// Comments of a TOML file in a file that is written anew.
#pragma once

#include <string>
#include <string_view>

namespace braitenlab {

// The text `written` with the comments of `old`: each above the same table or key, or behind its value. A comment whose
// key is not written any more, as of a value at its default, stands below the heading of the nearest table around it
// and begins with the key. Comments within lists and within texts of several lines are not taken.
std::string with_comments(std::string_view written, std::string_view old);

}  // namespace braitenlab
