// Files as the file browser shows them; app/files/disk.h reads the disk.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/scene/file_kind.h"

namespace braitenlab {

struct FileEntry {
    std::string name;  // without its folder
    bool is_folder = false;
    FileKind kind = FileKind::scene;  // of a file
    bool comments = false;            // contains comments, which saving would remove
    bool broken = false;              // cannot be read; opening the file shows the error
};

// A file that was opened or saved.
struct RecentFile {
    std::string path;
    std::string title{};  // of the scene or exercise in it; empty: unknown
    friend bool operator==(const RecentFile&, const RecentFile&) = default;
};

struct FolderListing {
    std::string folder;              // absolute
    std::vector<FileEntry> entries;  // folders first, each by name; only files of the kinds above
    std::string problem;             // why it could not be listed; empty: no error
};

// Unsaved work of the last session, offered at the next start after a crash or a signal.
struct RecoveryOffer {
    std::string title;     // of the scene or exercise
    std::string file;      // path; empty: it has no file
    std::string when;      // time of the autosave, "2026-03-01 10:42:05"
    bool ended = false;    // ended by a signal, not by a crash
    bool has_work = true;  // changes of a person, or a population with a history; else nothing is asked
};

// A question about unsaved edits, before another file is opened or the program ends.
struct Leaving {
    std::string title{};       // of the edited scene or exercise
    std::string next{};        // the file or link to open next; empty: the program ends
    std::string next_title{};  // of the scene or exercise in it
    bool resume = false;       // of OpenRequest, as is `seed`
    bool passed = false;       // an exercise that the student has passed: its progress is kept
    std::uint64_t seed = 1;
};

// State of file operations, for the panels.
struct FilesView {
    FolderListing listing;
    std::string suggested;  // name without extension for a first save
    std::string save_to;    // file that Ctrl+S writes; empty: a name is needed
    bool ships = false;     // the document is a shipped scene or an exercise, whose story a copy does not take over
    int done = 0;  // number of files opened and saved since the start; a waiting sheet closes when it increases
    std::optional<Error> refused;  // of the last request
    std::string new_folder;        // the last save was refused because this folder does not exist; empty: it was not
    std::optional<Leaving> leaving;
    std::string exported_to;  // folder of the last WriteFilesRequest that was carried out; empty: none
};

}  // namespace braitenlab
