#include "app/files/plain_png.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace braitenlab {

namespace {

void add_number(std::string& text, std::uint32_t number) {  // the highest byte first
    for (const unsigned shift : {24U, 16U, 8U, 0U}) text += static_cast<char>(number >> shift & 255U);
}

std::uint32_t cyclic_check(std::string_view bytes) {
    std::uint32_t check = 0xffffffffU;
    for (const char byte : bytes) {
        check ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) check = check >> 1U ^ ((check & 1U) != 0 ? 0xedb88320U : 0U);
    }
    return ~check;
}

std::uint32_t adler_check(std::string_view bytes) {
    std::uint32_t sum = 1, of_sums = 0;
    for (const char byte : bytes) {
        sum = (sum + static_cast<unsigned char>(byte)) % 65521;
        of_sums = (of_sums + sum) % 65521;
    }
    return of_sums << 16U | sum;
}

void add_chunk(std::string& png, std::string_view type, std::string_view data) {
    add_number(png, static_cast<std::uint32_t>(data.size()));
    const std::string checked = std::string(type) + std::string(data);
    png += checked;
    add_number(png, cyclic_check(checked));
}

std::string stored(std::string_view bytes) {
    constexpr std::size_t most = 65535;  // bytes of a block
    std::string stream = "\x78\x01";
    for (std::size_t from = 0; from < bytes.size(); from += most) {
        const std::string_view block = bytes.substr(from, most);
        stream += from + most >= bytes.size() ? '\1' : '\0';
        for (const std::size_t length : {block.size(), ~block.size()})
            stream += static_cast<char>(length & 255U), stream += static_cast<char>(length >> 8U & 255U);
        stream += block;
    }
    add_number(stream, adler_check(bytes));
    return stream;
}

}  // namespace

std::string plain_png(int width, int height, const std::vector<unsigned char>& rgb) {
    std::string header;
    add_number(header, static_cast<std::uint32_t>(width));
    add_number(header, static_cast<std::uint32_t>(height));
    constexpr std::array<char, 5> eight_bit_colour{8, 2, 0, 0, 0};
    header.append(eight_bit_colour.data(), eight_bit_colour.size());
    const std::size_t row = static_cast<std::size_t>(width) * 3;
    std::string rows;
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        rows += '\0';  // no filter
        rows.append(reinterpret_cast<const char*>(rgb.data()) + y * row, row);
    }
    std::string png = "\x89PNG\r\n\x1a\n";
    add_chunk(png, "IHDR", header);
    add_chunk(png, "IDAT", stored(rows));
    add_chunk(png, "IEND", "");
    return png;
}

}  // namespace braitenlab
