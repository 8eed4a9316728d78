#include "app/pictures/gif.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace braitenlab {

namespace {

constexpr std::uint8_t unchanged = 255;  // the number of the transparent colour
constexpr int number_bits = 8;
constexpr int least_tolerance = 3, largest_tolerance = 8;  // levels of a channel
constexpr int refreshed = 8, refresh_period = 24;  // px, side of a block; pictures after which it is exact again
constexpr double allowed = 0.053;                  // bytes per pixel of a picture, on average
constexpr double allowed_first = 6;                // pictures: the first one is larger

void add_short(std::string& bytes, int number) {
    bytes += static_cast<char>(number & 255);
    bytes += static_cast<char>(number >> 8 & 255);
}

// Collects codes of different lengths, the lowest bit first, and cuts them into blocks.
class Codes {
public:
    void add(unsigned code, int bits) {
        pending_ |= code << used_;
        used_ += bits;
        for (; used_ >= 8; used_ -= 8, pending_ >>= 8U) add_byte(pending_);
    }
    std::string finish() {
        if (used_ > 0) add_byte(pending_);
        if (!block_.empty()) flush();
        return std::move(blocks_) + '\0';
    }

private:
    void add_byte(unsigned byte) {
        block_ += static_cast<char>(byte & 255U);
        if (block_.size() == 255) flush();
    }
    void flush() {
        blocks_ += static_cast<char>(block_.size());
        blocks_ += block_;
        block_.clear();
    }
    unsigned pending_ = 0;
    int used_ = 0;
    std::string block_, blocks_;
};

// The code of each known sequence: of a known sequence and one number after it. Open addressing; an entry of an earlier
// table is free.
class Sequences {
public:
    Sequences() : entries_(std::size_t{1} << 14U) {}
    void clear() { ++table_; }
    // The code, or −1.
    int find(unsigned before, unsigned number) const {
        const Entry& entry = entries_[place_of(before << 8U | number)];
        return entry.table == table_ ? static_cast<int>(entry.code) : -1;
    }
    void add(unsigned before, unsigned number, unsigned code) {
        const unsigned key = before << 8U | number;
        entries_[place_of(key)] = {table_, key, code};
    }

private:
    std::size_t place_of(unsigned key) const {
        std::size_t at = (key * 2654435761U >> 18U) & (entries_.size() - 1);
        while (entries_[at].table == table_ && entries_[at].key != key) at = (at + 1) & (entries_.size() - 1);
        return at;
    }
    struct Entry {
        unsigned table = 0, key = 0, code = 0;
    };
    std::vector<Entry> entries_;
    unsigned table_ = 1;
};

}  // namespace

std::string gif_compressed(const std::vector<std::uint8_t>& numbers) {
    constexpr unsigned clear = 1U << number_bits, end = clear + 1, most = 4096;
    Codes codes;
    Sequences known;
    unsigned next = end + 1;
    int bits = number_bits + 1;
    codes.add(clear, bits);
    int sequence = -1;
    for (const std::uint8_t number : numbers) {
        if (sequence < 0) {
            sequence = number;
            continue;
        }
        const auto before = static_cast<unsigned>(sequence);
        if (const int longer = known.find(before, number); longer >= 0) {
            sequence = longer;
            continue;
        }
        codes.add(before, bits);
        known.add(before, number, next);
        sequence = number;
        if (next == most - 1) {
            codes.add(clear, bits);
            known.clear();
            next = end + 1, bits = number_bits + 1;
            continue;
        }
        if (next++ == 1U << static_cast<unsigned>(bits)) ++bits;
    }
    if (sequence >= 0) codes.add(static_cast<unsigned>(sequence), bits);
    codes.add(end, bits);
    return static_cast<char>(number_bits) + codes.finish();
}

GifWriter::GifWriter(int width, int height, std::vector<Rgb> colours, int hundredths)
    : width_(width), height_(height), hundredths_(std::max(2, hundredths)), table_(std::move(colours)) {}

std::string GifWriter::begin() const {
    std::string bytes = "GIF89a";
    add_short(bytes, width_), add_short(bytes, height_);
    bytes += "\xf7";  // a table of 256 colours for all pictures
    bytes.append(2, '\0');
    for (std::size_t i = 0; i < 256; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            bytes += i < table_.colours().size() ? static_cast<char>(table_.colours()[i][c]) : '\0';
    bytes += "\x21\xff\x0bNETSCAPE2.0\x03\x01";  // repeats without end
    bytes.append(3, '\0');
    return bytes;
}

std::string GifWriter::block_of(int left, int top, int right, int bottom,
                                const std::vector<std::uint8_t>& numbers) const {
    std::string bytes = "\x21\xf9\x04\x05";  // the next picture is drawn over this one; one colour is transparent
    add_short(bytes, hundredths_);
    bytes += static_cast<char>(unchanged);
    bytes += '\0';
    bytes += ',';
    for (const int number : {left, top, right - left, bottom - top}) add_short(bytes, number);
    bytes += '\0';
    std::vector<std::uint8_t> part;
    part.reserve(static_cast<std::size_t>(right - left) * static_cast<std::size_t>(bottom - top));
    for (int y = top; y < bottom; ++y) {
        const auto row = numbers.begin() + static_cast<std::ptrdiff_t>(y) * width_;
        part.insert(part.end(), row + left, row + right);
    }
    return bytes + gif_compressed(part);
}

int GifWriter::tolerance() const {
    const double due = allowed * width_ * height_ * (static_cast<double>(pictures_) + allowed_first);
    const double share = std::clamp((static_cast<double>(bytes_) / due - 0.6) / 0.4, 0.0, 1.0);
    return least_tolerance + static_cast<int>(share * (largest_tolerance - least_tolerance));
}

std::string GifWriter::picture(const std::vector<unsigned char>& rgb) {
    const bool is_first = shown_.empty();
    const int tolerated = tolerance(), turn = static_cast<int>(drawn_ % refresh_period);
    const bool is_left_out = tolerated == largest_tolerance && pictures_ % 2 == 1;
    if (is_first) shown_ = rgb;
    const auto width = static_cast<std::size_t>(width_);
    std::vector<std::uint8_t> numbers(width * static_cast<std::size_t>(height_), unchanged);
    int left = width_, top = height_, right = 0, bottom = 0;
    for (int y = 0; y < height_ && !is_left_out; ++y)
        for (int x = 0; x < width_; ++x) {
            const std::size_t pixel = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
            const unsigned char *now = &rgb[pixel * 3], *before = &shown_[pixel * 3];
            const bool is_exact = (x / refreshed * 7 + y / refreshed * 11 + turn) % refresh_period == 0;
            const int limit = is_exact ? least_tolerance : tolerated;
            const auto same = [&](int c) { return std::abs(int{now[c]} - int{before[c]}) <= limit; };
            if (!is_first && same(0) && same(1) && same(2)) continue;
            std::copy_n(now, 3, &shown_[pixel * 3]);
            numbers[pixel] = table_.nearest({now[0], now[1], now[2]}, x, y);
            left = std::min(left, x), right = std::max(right, x + 1);
            top = std::min(top, y), bottom = std::max(bottom, y + 1);
        }
    if (right == 0) left = top = 0, right = bottom = 1;  // nothing has changed: its time passes all the same
    std::string block = block_of(left, top, right, bottom, numbers);
    ++pictures_, drawn_ += is_left_out ? 0 : 1, bytes_ += block.size();
    return block;
}

}  // namespace braitenlab
