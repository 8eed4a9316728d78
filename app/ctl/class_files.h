// The files that a class has handed in: of folders with their subfolders, of ZIP archives, and single ones.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/files/archive.h"
#include "core/lesson/submitter.h"
#include "core/result.h"

namespace braitenlab {

struct ClassFile {
    std::string file;  // relative to the argument that it is in; of a single file the argument
    Submitter submitter;
    std::filesystem::path path;        // on the disk; empty in an archive
    std::shared_ptr<Archive> archive;  // null on the disk
    std::size_t entry = 0;             // in the archive
};

struct ClassFiles {
    std::vector<ClassFile> files;  // sorted by path within each argument
    std::vector<ClassFile> empty;  // for each folder or person without such a file, one that is left out, or the folder
    std::vector<std::string> left_out;  // pages and tables (.html, .csv), and what is no file
};

// Hidden files and those that systems add (__MACOSX, Thumbs.db, desktop.ini) are not mentioned. Archives in folders and
// in archives stay closed: they are files. Fails for an archive that cannot be opened.
Result<ClassFiles> class_files(const std::vector<std::string>& arguments);

// The content. Fails as read_text() and Archive::read().
Result<std::string> text_of(const ClassFile&);

}  // namespace braitenlab
