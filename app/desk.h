// What lies on the person's desk: the open lab, the files round it, and what is remembered of them.
#pragma once

#include "app/lab.h"
#include "app/settings.h"
#include "ui/files.h"

namespace braitenlab {

// The file is the last one opened, and unless it came with the lab, its folder is where to look for more.
void remember_file(Remembered&, const std::filesystem::path&);

// Does what has been asked for with files since the last frame: opens, saves, lists folders. What was done is said in
// the lab's notice, what could not be done there and in the view.
void do_files(Lab&, FilesView&, Remembered&);

// Whether the scene has edits that no file has. An exercise has none that count: its brains are tries.
bool has_unsaved_edits(const Lab&);

// Whether the lab can be left as it is; where it cannot, the person is asked (FilesView::leaving).
bool may_leave(const Lab&, FilesView&);

// Call now and then. Takes the open file as another program has written it since; a broken one leaves what runs alone
// and is told, and so is one that would cost unsaved edits.
void follow_file(Lab&, FilesView&);

// What the panels see of the lab's own file, made anew after each of these.
void refresh(FilesView&, const Lab&);

}  // namespace braitenlab
