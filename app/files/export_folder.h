// The folder of an export to a robot.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/export/export.h"
#include "core/result.h"

namespace braitenlab {

// The error if the folder holds files, and none of them is of an earlier export.
std::optional<Error> export_folder_fault(const std::filesystem::path& folder);

// The names of files that an export of these would replace or remove, and that differ from what an export has written
// there: a person has edited them. A comment at the end of the README has the hashes of an export's files; without it,
// all of them count as edited.
std::vector<std::string> edited_files(const std::filesystem::path& folder, const std::vector<robots::ExportedFile>&);

// Writes the files, or none of them; creates the folder. Fails if one of them, or the folder of a sketch, is a link:
// a folder may be a link, but its export stays in it. Where it holds an earlier export, removes those of its files
// that this one does not have, such as the second sheet of a larger circuit. A text of the user stays, whatever its
// name; lists of parts, nets and drawings are known by their names alone.
std::optional<Error> write_export(const std::filesystem::path& folder, const std::vector<robots::ExportedFile>&);

}  // namespace braitenlab
