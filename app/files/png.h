// Pictures as PNG: W3C Recommendation Portable Network Graphics, second edition.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace braitenlab {

// The content of a file; `rgb` holds three bytes per pixel, rows from the top.
std::string png(int width, int height, const std::vector<unsigned char>& rgb);

// Writes a picture. Fails as FileWriter does.
std::optional<Error> write_png(const std::filesystem::path&, int width, int height,
                               const std::vector<unsigned char>& rgb);

}  // namespace braitenlab
