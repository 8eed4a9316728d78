// ZIP archives for tests, also such as no program writes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <zlib.h>

namespace braitenlab::tests {

struct Zipped {
    std::string name;  // a folder ends with '/'
    std::string content{};
    bool deflated = false;
    std::uint32_t wrong_crc = 0;      // added to the checksum
    std::uint16_t flags = 1u << 11u;  // names are UTF-8
};

// The format: PKWARE, "APPNOTE.TXT".
inline std::string zip_of(const std::vector<Zipped>& files) {
    const auto number = [](std::uint64_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFFu);
        return text;
    };
    std::string all, directory;
    for (const Zipped& file : files) {
        std::string packed = file.content;
        if (file.deflated) {
            z_stream stream{};
            deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY);
            packed.assign(deflateBound(&stream, file.content.size()), '\0');
            stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(file.content.data()));
            stream.avail_in = static_cast<uInt>(file.content.size());
            stream.next_out = reinterpret_cast<Bytef*>(packed.data());
            stream.avail_out = static_cast<uInt>(packed.size());
            deflate(&stream, Z_FINISH);
            packed.resize(stream.total_out);
            deflateEnd(&stream);
        }
        const auto crc =
            crc32(0, reinterpret_cast<const Bytef*>(file.content.data()), static_cast<uInt>(file.content.size()));
        const std::string common = number(20, 2) + number(file.flags, 2) + number(file.deflated ? 8 : 0, 2) +
                                   number(0, 4) + number(crc + file.wrong_crc, 4) + number(packed.size(), 4) +
                                   number(file.content.size(), 4) + number(file.name.size(), 2) + number(0, 2);
        directory += "PK\x01\x02" + number(20, 2) + common + number(0, 2) + number(0, 2) + number(0, 2) + number(0, 4) +
                     number(all.size(), 4) + file.name;
        all += "PK\x03\x04" + common + file.name + packed;
    }
    return all + directory + "PK\x05\x06" + number(0, 4) + number(files.size(), 2) + number(files.size(), 2) +
           number(directory.size(), 4) + number(all.size(), 4) + number(0, 2);
}

}  // namespace braitenlab::tests
