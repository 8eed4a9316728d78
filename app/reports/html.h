// What the pages of reports share: elements and the frame of a self-contained page.
#pragma once

#include <string>
#include <string_view>

#include "core/xml_text.h"

namespace braitenlab::html {

// xml_text(), with <br/> at line ends.
std::string with_breaks(std::string_view text);

// <tag>escaped text</tag>, with a class where one is given.
std::string element(std::string_view tag, std::string_view text, std::string_view css_class = {});

// A whole page, well-formed also as XML. `title` is text; `style`, `script` and `body` are markup. It loads nothing.
std::string page(std::string_view language, std::string_view title, std::string_view style, std::string_view body,
                 std::string_view script = {});

}  // namespace braitenlab::html
