// Files on the disk: what is in a folder, what kind each is, and saving what is open.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/lab.h"
#include "core/result.h"
#include "ui/files.h"

namespace braitenlab {

// What a file is by its ending and by the tables in it; none where the lab has no use for it.
std::optional<FileKind> kind_of_file(const std::filesystem::path&);

// Folders and the lab's files, those that it cannot read marked as broken: also what is no TOML in spite of its ending.
// Hidden ones are left out, and all beyond the first two thousand.
FolderListing list_folder(const std::filesystem::path&);

// Whether it came with the lab.
bool ships(const std::filesystem::path&);

// What a person typed, as an absolute path: "~" is their home, anything relative is below the folder.
std::filesystem::path resolved(const std::string& typed, const std::filesystem::path& folder);

// The same with the ending that its kind has, where it has none.
std::filesystem::path with_ending(std::filesystem::path, FileKind);

// Where Ctrl+S writes without asking: the scene's own file, unless it ships with the lab or holds comments that would
// be lost; empty for none.
std::filesystem::path own_file(const Lab&);

// Writes the scene, the run as it is now, or the selected vehicle's brain. Fails where there is nothing to write or no
// way to.
std::optional<Error> save_as(const Lab&, const std::filesystem::path&, FileKind);

// Gives the selected vehicle, or its whole kind, the brain of a file: an edit, which undo takes back.
std::optional<Error> take_brain(Lab&, const std::filesystem::path&);

}  // namespace braitenlab
