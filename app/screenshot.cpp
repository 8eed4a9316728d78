#include "app/screenshot.h"

#include <fmt/format.h>
#include <stb_image_write.h>

namespace braitenlab {

std::optional<Error> write_png(const std::filesystem::path& path, int width, int height,
                               const std::vector<unsigned char>& rgb) {
    if (stbi_write_png(path.string().c_str(), width, height, 3, rgb.data(), width * 3) != 0) return std::nullopt;
    return Error{"the picture could not be written; check that the folder exists, may be written to and has room",
                 path.string()};
}

std::filesystem::path next_screenshot_name(const std::filesystem::path& folder) {
    std::error_code none;
    for (int i = 1;; ++i) {
        const auto path = folder / fmt::format("braitenlab-{:03}.png", i);
        if (!std::filesystem::exists(path, none)) return path;
    }
}

}  // namespace braitenlab
