// The lab without its window: an open document, its playback and how it is shown. Panels and keys send a Request, which
// app/lab_requests.h executes. No graphics and no clock: tests call it directly.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/document.h"
#include "app/playback.h"
#include "render/view/view_settings.h"
#include "ui/lab_view.h"
#include "ui/request.h"

namespace braitenlab {

// The values that lecture mode changes, as they were before it.
struct SettingsBeforeLecture {
    Theme theme = Theme::dark;
    float type_size = 1;
    ViewSettings view;  // leaving restores all of it but the selection, which belongs to the run
};

struct Lab {
    Document document;
    Playback playback{};
    ViewSettings view{};
    std::string object_name{};  // of view.selection.object: its index changes when others come or go
    Steer steered{};            // last command given by the arrow keys
    Preferences preferences{};  // as shown now
    std::optional<SettingsBeforeLecture> before_lecture{};  // set in lecture mode
    Notice notice{};
    double notice_until = 0;  // wall seconds
    double wall_seconds = 0;

    // Requests to the window, which executes and clears them.
    bool exit = false, screenshot = false, full_screen = false;
    std::vector<Request> files{};  // to open, to save, to export, to list a folder
};

// A lab that shows this document, paused.
Lab make_lab(Document);

// open_document() and make_lab().
Result<Lab> open_lab(const std::filesystem::path&, std::optional<std::uint64_t> seed,
                     const std::vector<Setting>& settings);

// Replaces the open document. Playback starts anew; preferences and what does not depend on the scene in the view
// settings stay.
void replace_document(Lab&, Document);

// The preferences without the changes that lecture mode makes.
Preferences own_preferences(const Lab&);

// Shows a notice at the bottom of the window, for as long as reading it takes; failures stay longest.
void say(Lab&, Notice);

// What panels see. Points into the lab: valid until the lab changes.
LabView view_of(const Lab&);

}  // namespace braitenlab
