#include "app/files/screenshot.h"

#include <fmt/format.h>

#include "app/files/png.h"
#include "app/files/safe_file.h"

namespace braitenlab {

std::optional<Error> write_png(const std::filesystem::path& path, int width, int height,
                               const std::vector<unsigned char>& rgb) {
    FileWriter writer(path);
    writer.write(png(width, height, rgb));
    return writer.commit();
}

std::filesystem::path next_screenshot_name(const std::filesystem::path& folder, std::string_view extension) {
    std::error_code none;
    for (int i = 1;; ++i) {
        auto path = folder / fmt::format("braitenlab-{:03}{}", i, extension);
        if (!std::filesystem::exists(path, none)) return path;
    }
}

}  // namespace braitenlab
