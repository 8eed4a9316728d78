// What the window's file browser remembers between frames.
#pragma once

#include <optional>
#include <string>

#include "ui/files.h"
#include "ui/widgets/sheet.h"
#include "ui/widgets/text_field.h"

namespace braitenlab {

enum class FilesPlace { shipped, recent, folder };

struct FilesState {
    SheetState sheet;
    bool saving = false;
    FilesPlace place = FilesPlace::shipped;  // when opening
    std::optional<FileKind> only;            // when opening from a folder; none: every kind
    FileKind kind = FileKind::scene;         // when saving
    TextField typed;                         // a path, or the name to save under
    TextField title;                         // of the scene that is saved
    std::string listed;                      // what is listed, a folder or a place; another one starts at its top
    bool begun = false;                      // drawn once since it was opened
    bool asked = false;                      // something was asked of the lab: `done` tells when it has happened
    int done = 0;                            // FilesView::done when it was asked
    std::string replacing;                   // a name that exists, until the person has said what to do
};

// Opens the browser for opening, or for saving as `kind`; PanelState::sheet must be Sheet::files as well.
void begin_files(FilesState&, bool saving, FileKind kind = FileKind::scene);

}  // namespace braitenlab
