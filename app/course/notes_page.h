// The lecturer's notes as a page for a browser: for a screen that the audience does not see.
#pragma once

#include <filesystem>
#include <string>

#include "app/platform/platform.h"
#include "ui/lab_view.h"
#include "ui/words/strings.h"

namespace braitenlab {

struct Lab;

// The page of the present moment: time, caption, notes, and the caption of the next page. It loads itself anew each
// second.
std::string notes_page(const LectureView&, const Strings&, const std::string& language, Theme);

// Call once per turn. After Lab::opens_notes: writes the page into the folder and opens it with the system's browser;
// the notes then leave the window.
// Shows a notice with its path, in a browser with the reason of a failure (see open_with_system()). From then on writes
// it whenever it has changed; after the lecture it says so, and a later lecture goes on with it. Without a folder it
// does nothing.
void follow_notes_page(Lab&, const Strings&, const std::string& language, const std::filesystem::path& folder,
                       bool (*open)(const std::filesystem::path&) = open_with_system);

}  // namespace braitenlab
