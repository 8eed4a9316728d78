// Folders for the file browser, and saving of the open document.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/files/data.h"
#include "app/workspace.h"
#include "core/result.h"
#include "ui/files.h"

namespace braitenlab {

// The subfolders and files of a folder that the program can open, at most 2000. Files that cannot be read, malformed
// TOML included, are marked as broken. Hidden files and TOML files of other programs are left out.
FolderListing list_folder(const std::filesystem::path&);

// The error if an exercise, a lecture, a study or a breeding names a file outside its own folder that does not ship
// with the program. For a file that is dropped on the window.
std::optional<Error> fault_of_dropped(const FileText&);

// A path as the user has typed it, made absolute: "~" is the home folder, a relative path starts at `folder`.
std::filesystem::path resolved(const std::string& typed, const std::filesystem::path& folder,
                               const std::filesystem::path& home);

// Appends the extension of the kind (.run or .toml) if the path has another one.
std::filesystem::path with_extension(std::filesystem::path, FileKind);

// The scene's own file, which Ctrl+S overwrites. Empty if there is none, or if it ships with the program.
std::filesystem::path own_file(const Document&);

// Writes the scene, the run at its current tick, or the brain of the selected vehicle. A scene keeps the comments of
// the file that it was opened from, see core/scene/comments.h. Returns content_of() the file.
Result<std::uint64_t> save_as(const Workspace&, const std::filesystem::path&, FileKind);

// Gives the brain in the file to the selected vehicle, or to its whole kind. One step of undo.
std::optional<Error> take_brain(Workspace&, const FileText&);

}  // namespace braitenlab
