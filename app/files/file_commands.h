// Opening, saving and leaving the document, as the window's file browser requests it.
#pragma once

#include "app/files/settings.h"
#include "app/lab.h"
#include "app/platform/platform.h"
#include "ui/files.h"

namespace braitenlab {

// Tells where a new file is, whose name the user has not chosen: `key` with its path, on a page among the downloads.
void say_saved(Lab&, std::string_view key, const std::filesystem::path&);

// Writes a new file, named free_name(), and tells where it is by say_saved().
std::optional<Error> write_new(Lab&, const std::filesystem::path& folder, const std::string& stem,
                               std::string_view extension, std::string_view text, std::string_view key);

// Makes the file of the document the last one opened. Its folder becomes the browser's folder, unless the file ships
// with the lab.
void add_recent_file(StoredState&, const std::filesystem::path&, const Document&);

// Executes the requests in Lab::files: opens, saves, exports, lists folders. Success is shown as a notice, failure as a
// notice and in the view. Scene files written are added to Lab::saved.
void execute_file_requests(Lab&, FilesView&, StoredState&, const UserFolders&);

// True if the scene has edits that are in no file; of an exercise, if its submission has and the
// student's progress does not keep it. Never on a page of a lecture.
bool has_unsaved_edits(const Lab&);

// True if the document can be closed without losing edits. If not, sets FilesView::leaving, which opens a sheet.
bool may_leave(const Lab&, FilesView&);

// Call a few times per second. Reloads the open file if another program has written it with another content. If the new
// file is broken or gone or there are unsaved edits, shows a notice and keeps the document. Does nothing on a page of a
// lecture.
void follow_file(Lab&, FilesView&);

// Updates FilesView for the file of the document. Call after the document has changed.
void refresh(FilesView&, const Lab&);

}  // namespace braitenlab
