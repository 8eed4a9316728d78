#include "app/files/screenshot.h"

#include <fmt/format.h>
#include <stb_image_write.h>

#include "app/files/safe_file.h"
#include "core/messages.h"

namespace braitenlab {

std::optional<Error> write_png(const std::filesystem::path& path, int width, int height,
                               const std::vector<unsigned char>& rgb) {
    FileWriter writer(path);
    const auto add = [](void* to, void* data, int size) {
        static_cast<FileWriter*>(to)->write({static_cast<const char*>(data), static_cast<std::size_t>(size)});
    };
    if (stbi_write_png_to_func(add, &writer, width, height, 3, rgb.data(), width * 3) == 0)
        return error_of(message_of("no_picture"), path.string());
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
