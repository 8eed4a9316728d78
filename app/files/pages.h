// What the system's programs open: pages of the manual that texts of exercises name, folders and reports.
#pragma once

#include <filesystem>
#include <string>

#include "app/lab.h"

namespace braitenlab {

// Opens what is at the path with the system's program for it. Where nothing is there, without such a program and in a
// browser, copies a text into Lab::to_copy. A notice has the name or the text.
struct Opened {
    std::string name, copied;
};
void open_or_copy(Lab&, bool is_there, const std::filesystem::path&, const Opened&);

// The same for a page ("docs/robots.md"), of which the path is copied. Any other text than docs/NAME.md does nothing.
void open_page(Lab&, const std::string& page);

// The same for a folder. What is not a folder is not opened.
void open_folder(Lab&, const std::string& folder);

}  // namespace braitenlab
