// Pages of the manual that texts of exercises name, and the folder of an export.
#pragma once

#include <string>

#include "app/lab.h"

namespace braitenlab {

// Opens the page ("docs/robots.md") with the system's program for its type. Without the file or such a program, and in
// a browser, copies its path into Lab::to_copy. A notice tells which. Any other text than docs/NAME.md does nothing.
void open_page(Lab&, const std::string& page);

// Opens the folder with the system's program; without such a program copies its path into Lab::to_copy. A notice tells
// which. What is not a folder is not opened.
void open_folder(Lab&, const std::string& folder);

}  // namespace braitenlab
