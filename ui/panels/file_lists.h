// What the window's browser lists: what ships, what was open lately, and what is in a folder.
#pragma once

#include <string_view>

#include "ui/lab_view.h"
#include "ui/panels/files_state.h"
#include "ui/request.h"
#include "ui/widgets/ui.h"

namespace braitenlab {

// The string that names a kind of file.
std::string_view kind_key(FileKind);

// Asks the lab for something that FilesView::done and ::refused will tell of.
void ask(const LabView&, FilesState&, Ui&, Request);

// Each from the cursor down to `bottom`, a y within the window that is drawn. A row that is pressed is asked for; while
// saving it gives its name.
void list_shipped(const LabView&, FilesState&, Ui&, float bottom);
void list_recent(const LabView&, FilesState&, Ui&, float bottom);
void list_folder(const LabView&, FilesState&, Ui&, float bottom);

}  // namespace braitenlab
