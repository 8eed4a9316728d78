// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/result.h"

namespace braitenlab {

// Writes a picture; `rgb` holds three bytes per pixel, rows from the top. Fails as FileWriter does.
std::optional<Error> write_png(const std::filesystem::path&, int width, int height,
                               const std::vector<unsigned char>& rgb);

}  // namespace braitenlab
