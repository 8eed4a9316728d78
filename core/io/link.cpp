#include "core/io/link.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include <fmt/format.h>
#include <zlib.h>

#include "core/messages.h"
#include "core/scene/scene_file.h"
#include "core/scene/schema.h"
#include "core/text_parts.h"

namespace braitenlab::io {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr std::string_view link_file = "link";  // in place of a file's name in messages about the scene's text
constexpr int link_version = 1;

std::string base64url(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() * 4 + 2) / 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : bytes) {
        bits = bits << 8u | static_cast<unsigned char>(c);
        for (count += 8; count >= 6; count -= 6) text += alphabet[bits >> static_cast<unsigned>(count - 6) & 63u];
    }
    if (count > 0) text += alphabet[bits << static_cast<unsigned>(6 - count) & 63u];
    return text;
}

// nullopt if a character is not of the alphabet.
std::optional<std::string> from_base64url(std::string_view text) {
    std::string bytes;
    bytes.reserve(text.size() * 3 / 4);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t value = alphabet.find(c);
        if (value == std::string_view::npos) return std::nullopt;
        bits = bits << 6u | static_cast<std::uint32_t>(value);
        if ((count += 6) < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> static_cast<unsigned>(count) & 255u);
    }
    return bytes;
}

std::string deflated(std::string_view text) {
    uLongf size = compressBound(static_cast<uLong>(text.size()));
    std::string bytes(size, '\0');
    // It fails without memory only: the buffer has the size of the worst case.
    const int result =
        compress2(reinterpret_cast<Bytef*>(bytes.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                  static_cast<uLong>(text.size()), Z_BEST_COMPRESSION);
    bytes.resize(result == Z_OK ? size : 0);
    return bytes;
}

// At most limits::file_bytes, whatever the compressed bytes ask for.
Result<std::string> inflated(const std::string& bytes) {
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) return error_of(message_of("link_damaged"));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib does not write to it
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string text;
    std::array<char, 16384> part{};
    int state = Z_OK;
    while (state == Z_OK && text.size() <= limits::file_bytes) {
        stream.next_out = reinterpret_cast<Bytef*>(part.data());
        stream.avail_out = static_cast<uInt>(part.size());
        state = inflate(&stream, Z_NO_FLUSH);
        text.append(part.data(), part.size() - stream.avail_out);
    }
    inflateEnd(&stream);
    if (text.size() > limits::file_bytes) return error_of(message_of("link_too_large", limits::file_bytes >> 20u));
    if (state == Z_BUF_ERROR) return error_of(message_of("link_incomplete"));
    if (state != Z_STREAM_END) return error_of(message_of("link_damaged"));
    return text;
}

// What follows the address, from '#' on; empty if the text before '#' is no address.
std::string_view from_hash(std::string_view text) {
    text = trimmed(text, " \t\r\n");
    const std::size_t hash = text.find('#');
    const bool has_address = hash == 0 || text.substr(0, hash).find("://") != std::string_view::npos;
    return hash == std::string_view::npos || !has_address ? std::string_view{} : text.substr(hash);
}

// A link from '#' on, split: "b", "1" and the rest.
struct LinkParts {
    char type = 0;
    std::string_view version, content;
};

std::optional<LinkParts> split_link(std::string_view text) {
    text = from_hash(text);
    if (text.empty()) return std::nullopt;
    text.remove_prefix(1);
    const std::size_t dot = text.find('.');
    if (dot == std::string_view::npos || dot < 2 || dot > 4 || (text[0] != 'b' && text[0] != 'e')) return std::nullopt;
    const LinkParts parts{text[0], text.substr(1, dot - 1), text.substr(dot + 1)};
    const bool is_number =
        std::all_of(parts.version.begin(), parts.version.end(), [](char c) { return c >= '0' && c <= '9'; });
    return is_number ? std::optional(parts) : std::nullopt;
}

}  // namespace

bool is_link(std::string_view text) { return split_link(text).has_value(); }

bool begins_like_link(std::string_view text) { return text.starts_with("#b") || text.starts_with("#e"); }

std::string encode_link(const Scene& scene) {
    return fmt::format("#b{}.{}", link_version, base64url(deflated(write_scene(scene))));
}

std::string encode_exercise_link(std::string_view name) { return fmt::format("#e{}.{}", link_version, name); }

Result<Linked> decode_link(std::string_view text) {
    const auto parts = split_link(text);
    if (!parts) return error_of(begins_like_link(from_hash(text)) ? message_of("link_damaged") : message_of("no_link"));
    if (parts->version != std::to_string(link_version))
        return error_of(message_of("link_version", std::string(parts->version), link_version));
    // No scene that fits needs more characters.
    if (parts->content.size() > 2 * limits::file_bytes)
        return error_of(message_of("link_too_large", limits::file_bytes >> 20u));
    if (parts->content.find_first_not_of(alphabet) != std::string_view::npos)
        return error_of(message_of("link_characters"));
    if (parts->content.empty()) return error_of(message_of("link_incomplete"));
    if (parts->type == 'e') return Linked{std::string(parts->content.substr(0, limits::name_length))};
    const auto bytes = from_base64url(parts->content);
    if (!bytes) return error_of(message_of("link_characters"));
    const auto toml = inflated(*bytes);
    if (!toml) return toml.error();
    auto scene = parse_scene(*toml, std::string(link_file));
    if (!scene) return scene.error();
    return Linked{{}, std::move(*scene)};
}

}  // namespace braitenlab::io
