#include "app/files/screenshot.h"

#include "app/files/png.h"
#include "app/files/safe_file.h"

namespace braitenlab {

std::optional<Error> write_png(const std::filesystem::path& path, int width, int height,
                               const std::vector<unsigned char>& rgb) {
    FileWriter writer(path);
    writer.write(png(width, height, rgb));
    return writer.commit();
}

}  // namespace braitenlab
