// Links to the open document, and documents from links (core/io/link.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/lab.h"
#include "core/result.h"

namespace braitenlab {

// Puts a link to the open document into Lab::to_copy and shows its length as a notice: of a shipped exercise its name
// while its vehicle is as given, of anything else the scene with all edits.
void copy_link(Lab&);

// The document of a link's scene, its run with this seed: without a file, named like its title.
Result<Document> linked_document(Scene, std::uint64_t seed = 1);

// The file of the shipped exercise of a link.
Result<std::filesystem::path> linked_exercise(const std::string& name);

}  // namespace braitenlab
