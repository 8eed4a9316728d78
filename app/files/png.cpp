#include "app/files/png.h"

#include <cassert>
#include <cstdlib>
#include <string_view>

#include <zlib.h>

#include "app/files/safe_file.h"

namespace braitenlab {

namespace {

constexpr std::size_t bytes_per_pixel = 3;

const Bytef* bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

void add_number(std::string& text, std::size_t number) {  // the highest byte first
    for (const unsigned shift : {24U, 16U, 8U, 0U}) text += static_cast<char>(number >> shift & 255U);
}

void add_chunk(std::string& file, std::string_view type, std::string_view data) {
    add_number(file, data.size());
    const std::string checked = std::string(type) + std::string(data);
    file += checked;
    add_number(file, crc32(0, bytes_of(checked), static_cast<uInt>(checked.size())));
}

// The filters 1 and 2: the difference of each byte to that of the pixel before, or of the pixel above.
std::string filtered(char filter, const unsigned char* row, const unsigned char* above, std::size_t size) {
    std::string line(1, filter);
    for (std::size_t i = 0; i < size; ++i) {
        const int left = i < bytes_per_pixel ? 0 : row[i - bytes_per_pixel], up = above ? above[i] : 0;
        line += static_cast<char>(row[i] - (filter == 1 ? left : up));
    }
    return line;
}

// The smaller the differences of a row, the better it is compressed.
long size_of_differences(std::string_view line) {
    long sum = 0;
    for (const char difference : line.substr(1)) sum += std::abs(static_cast<signed char>(difference));
    return sum;
}

std::string compressed(std::string_view bytes) {
    auto size = compressBound(static_cast<uLong>(bytes.size()));
    std::string stream(size, '\0');
    [[maybe_unused]] const int result =
        compress(reinterpret_cast<Bytef*>(stream.data()), &size, bytes_of(bytes), static_cast<uLong>(bytes.size()));
    assert(result == Z_OK);
    stream.resize(size);
    return stream;
}

}  // namespace

std::string png(int width, int height, const std::vector<unsigned char>& rgb) {
    std::string header;
    add_number(header, static_cast<std::size_t>(width));
    add_number(header, static_cast<std::size_t>(height));
    header += {8, 2, 0, 0, 0};  // eight bits a channel, colour
    const std::size_t size = static_cast<std::size_t>(width) * bytes_per_pixel;
    std::string rows;
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        const unsigned char *row = rgb.data() + y * size, *above = y > 0 ? row - size : nullptr;
        const std::string by_left = filtered(1, row, above, size), by_above = filtered(2, row, above, size);
        rows += size_of_differences(by_left) < size_of_differences(by_above) ? by_left : by_above;
    }
    std::string file = "\x89PNG\r\n\x1a\n";
    add_chunk(file, "IHDR", header);
    add_chunk(file, "IDAT", compressed(rows));
    add_chunk(file, "IEND", "");
    return file;
}

std::optional<Error> write_png(const std::filesystem::path& path, int width, int height,
                               const std::vector<unsigned char>& rgb) {
    FileWriter writer(path);
    writer.write(png(width, height, rgb));
    return writer.commit();
}

}  // namespace braitenlab
