// Files that are never half-written: whatever happens, there is the old text or the new one.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "core/result.h"

namespace braitenlab {

// Writes beside the file, flushes that to the disk, and renames it over the file; folders on the way are made. A link
// is followed, and the file keeps its permissions. On failure the old file stands as it was and nothing is left
// beside it; the error says what is in the way: no room, no permission, no such folder.
std::optional<Error> write_whole(const std::filesystem::path&, std::string_view text);

}  // namespace braitenlab
