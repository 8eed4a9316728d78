// What lies on the person's desk: the open lab, the files round it, and what is remembered of them.
#pragma once

#include "app/lab.h"
#include "app/settings.h"
#include "ui/files.h"
#include "ui/strings.h"

namespace braitenlab {

// Puts another lab in the place of this one. What is a way of looking (preferences, fields, outlines) stays.
void replace_lab(Lab&, Lab next);

// The file is the last one opened, and unless it came with the lab, its folder is where to look for more.
void remember_file(Remembered&, const std::filesystem::path&);

// Does what has been asked for with files since the last frame: opens, saves, lists folders. What was done is said in
// the lab's notice, what could not be done there and in the view.
void do_files(Lab&, FilesView&, Remembered&, const Strings&);

// What the panels see of the lab's own file, made anew after each of these.
void refresh(FilesView&, const Lab&);

}  // namespace braitenlab
