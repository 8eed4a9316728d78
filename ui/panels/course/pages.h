// Pages of the manual that a text names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace braitenlab::ui {

// The pages docs/NAME.md in a text, each once, in their order. NAME has small letters, digits and '-' only, so that a
// text of an exercise from elsewhere names no other file.
std::vector<std::string> pages_in(std::string_view text);

}  // namespace braitenlab::ui
