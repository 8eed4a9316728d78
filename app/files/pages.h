// Pages of the manual that texts of exercises name.
#pragma once

#include <string>

#include "app/lab.h"

namespace braitenlab {

// Opens the page ("docs/robots.md") with the system's program for its type. Without the file or such a program, and in
// a browser, copies its path into Lab::to_copy. A notice tells which. Any other text than docs/NAME.md does nothing.
void open_page(Lab&, const std::string& page);

}  // namespace braitenlab
