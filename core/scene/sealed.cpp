#include "core/scene/sealed.h"

#include <cstdint>

#include "core/maths/fnv.h"
#include "core/maths/random.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

namespace {

constexpr std::size_t checksum_bytes = 4;

// Mixes or restores.
void mix(std::string& bytes) {
    maths::Random stream{0x627261696e, 0x7365616c};
    for (char& each : bytes) each = static_cast<char>(static_cast<unsigned char>(each) ^ (stream.next() >> 24U));
}

std::string checksum(std::string_view text) {
    const std::uint64_t hash = maths::fnv(text);
    std::string bytes;
    for (std::size_t i = 0; i < checksum_bytes; ++i) bytes += static_cast<char>(hash >> (8 * i) & 255U);
    return bytes;
}

}  // namespace

std::string seal_text(std::string_view text) {
    std::string bytes = checksum(text) + std::string(text);
    mix(bytes);
    std::string letters;
    letters.reserve(2 * bytes.size());
    for (const char each : bytes) {
        const auto byte = static_cast<unsigned char>(each);
        letters += static_cast<char>('a' + (byte >> 4U));
        letters += static_cast<char>('a' + (byte & 15U));
    }
    return letters;
}

std::optional<std::string> unseal_text(std::string_view letters) {
    std::string bytes;
    bytes.reserve(letters.size() / 2);
    for (std::size_t i = 0; i + 1 < letters.size(); i += 2) {
        const char high = letters[i], low = letters[i + 1];
        if (high < 'a' || high > 'p' || low < 'a' || low > 'p') return std::nullopt;
        bytes += static_cast<char>((high - 'a') * 16 + (low - 'a'));
    }
    if (letters.size() % 2 != 0 || bytes.size() < checksum_bytes) return std::nullopt;
    mix(bytes);
    std::string text = bytes.substr(checksum_bytes);
    if (checksum(text) != bytes.substr(0, checksum_bytes)) return std::nullopt;
    return text;
}

std::string seal(const BrainGraph& brain) { return seal_text(write_brain(brain)); }

std::optional<BrainGraph> unseal(std::string_view letters) {
    const auto text = unseal_text(letters);
    if (!text) return std::nullopt;
    auto brain = parse_brain(*text, "");
    return brain ? std::optional(std::move(*brain)) : std::nullopt;
}

}  // namespace braitenlab
