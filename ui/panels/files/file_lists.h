// Lists of the file browser: shipped files, recently opened files, and a folder.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/files.h"
#include "ui/lab_view.h"
#include "ui/request.h"
#include "ui/shortcuts.h"
#include "ui/widgets/text_field.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

enum class FilesPlace { shipped, recent, folder };

struct FilesState {
    bool saving = false;
    FilesPlace place = FilesPlace::shipped;  // when opening
    std::optional<FileKind> only;            // when opening from a folder; none: every kind
    FileKind kind = FileKind::scene;         // when saving
    std::string search;                      // typed while what ships is listed: only entries with these words; a path
                                             // moves to FilesPlace::folder
    std::string searched;                    // `search` in the last frame
    bool search_selected = false;            // the next letter replaces it
    TextField typed;                         // a path, or the name to save under
    TextField title, story;                  // of the scene to be saved
    std::string listed;                      // the folder or place listed; a new one is scrolled to its top
    bool begun = false;                      // drawn at least once since it was opened
    bool asked = false;     // a request is in progress; it has succeeded when FilesView::done exceeds `done`
    int done = 0;           // FilesView::done at that request
    std::string replacing;  // name of an existing file, until the user confirms
    std::string creating;   // name of the last save; if its folder does not exist, a second save creates it
};

// Opens the browser for opening, or for saving as `kind`. The caller sets PanelState::sheet to Sheet::files.
void begin_files(FilesState&, bool saving, FileKind kind = FileKind::scene);

// True if the search finds something that ships.
bool finds_shipped(const LabView&, const Ui&, const std::string& search);

// The title of a recent file in the language of the strings, or its name without a title, cut to `width` window pixels.
// If another recent file has the same title, its name follows, with its folder if the names are alike, too; then the
// title is cut. No name while a lecture asks first: then "File 4", its place in the list.
std::string recent_words(const LabView&, const Ui&, const std::vector<RecentFile>&, const RecentFile&, float width);

// The string key of a file kind's name.
std::string_view kind_key(FileKind);

// A key typed while the browser lists what ships: letters, digits, Space and Backspace edit FilesState::search, Esc
// empties it, Ctrl+A selects it. False for other keys.
bool search_by_typing(FilesState&, KeyPress);

// Sends a request. FilesView::done or FilesView::refused reports its result.
void request_file(const LabView&, FilesState&, Ui&, Request);

// Each list extends from the cursor down to `bottom`, a y within the window being drawn. A press on a row opens the
// file; while saving, it sets the name to that of the file.
void list_shipped(const LabView&, FilesState&, Ui&, float bottom);
void list_recent(const LabView&, FilesState&, Ui&, float bottom);
void list_folder(const LabView&, FilesState&, Ui&, float bottom);

// Draws the rendered picture of the file into a rectangle with the ratio picture_share. False if there is none.
bool put_scene_picture(const LabView&, const Ui&, const std::string& path, Rect place);
inline constexpr float picture_share = 0.58f;  // height by width

// The shipped exercises as cards by chapter, `gallery.ID` each; gallery.cpp. `beside`: the anchor to the right of the
// cards; empty: none.
void exercise_gallery(const LabView&, const std::vector<CatalogueEntry>& listed, const std::string& beside, FilesState&,
                      Ui&);

// "1 · Two wheels, two eyes"
std::string chapter_title(const Ui&, int chapter);

}  // namespace braitenlab::ui
