// What the pages of reports share: escaping and the frame of a self-contained page.
#pragma once

#include <string>
#include <string_view>

namespace braitenlab::html {

// The text with &, <, >, " and ' as references. Control characters, which XML does not allow, become spaces; bytes that
// are no UTF-8 become U+FFFD.
std::string escaped(std::string_view text);

// escaped(), with <br/> at line ends.
std::string with_breaks(std::string_view text);

// <tag>escaped text</tag>, with a class where one is given.
std::string element(std::string_view tag, std::string_view text, std::string_view css_class = {});

// A whole page, well-formed also as XML. `title` is text; `style`, `script` and `body` are markup. It loads nothing.
std::string page(std::string_view language, std::string_view title, std::string_view style, std::string_view body,
                 std::string_view script = {});

}  // namespace braitenlab::html
