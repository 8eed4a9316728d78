// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace braitenlab {

// Writes a picture; `rgb` holds three bytes per pixel, rows from the top. Fails as FileWriter does.
std::optional<Error> write_png(const std::filesystem::path&, int width, int height,
                               const std::vector<unsigned char>& rgb);

// The next free name of the form braitenlab-001.png in the folder. `extension`: with its dot.
std::filesystem::path next_screenshot_name(const std::filesystem::path& folder, std::string_view extension = ".png");

}  // namespace braitenlab
