// Files as the window's browser shows them; app/files.h looks at the disk.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/file_kind.h"

namespace braitenlab {

struct FileEntry {
    std::string name;  // without its folder
    bool is_folder = false;
    FileKind kind = FileKind::scene;  // of a file
    bool comments = false;            // it holds some, which writing it anew would lose
    bool broken = false;              // the lab cannot read it; opening it says why
};

struct FolderListing {
    std::string folder;              // absolute
    std::vector<FileEntry> entries;  // folders first, each by name; files that could be the lab's
    std::string problem;             // why it could not be listed; empty when it could
};

// What a lab has left that crashed or was told to end, offered at the next start.
struct RecoveryOffer {
    std::string name;    // of what was open
    std::string when;    // it was kept, as "2026-03-01 10:42:05"
    bool ended = false;  // it was told to end, and did so properly
};

// Edits that are in no file yet are about to be left: the person is asked first.
struct Leaving {
    std::string name;    // of what they were made to
    std::string next{};  // the file to be opened instead; empty: the lab is to be left
};

// What the panels see of files.
struct FilesView {
    FolderListing listing;
    std::string suggested;  // a name, without ending, for what is saved for the first time
    std::string save_to;    // where Ctrl+S writes the scene without asking; empty: it has to ask
    int done = 0;           // files opened and saved since the start: a sheet that asked for one may close
    std::string refused;    // why the last one was neither; empty when it was
    std::optional<Leaving> leaving;
};

}  // namespace braitenlab
