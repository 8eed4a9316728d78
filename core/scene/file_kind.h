// What a file contains, and its text.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"

namespace braitenlab {

template <std::size_t values>
class MessageId;  // core/messages.h

enum class FileKind { scene, exercise, brain, run, lecture, study, breeding };
inline constexpr int file_kinds = 7;

// The kind of a file, by its extension (.run) or by the tables in its text: [[step]] makes an exercise, [[page]] a
// lecture, [[value]] a study, [[breed]] a breeding; [kind.…], [arena] or [source.…] a scene; a [brain] without these a
// brain. nullopt for any other text. The text may be malformed: parsing it as this kind reports the error.
std::optional<FileKind> find_kind(const std::filesystem::path&, std::string_view text);

// The same; any other text counts as a scene.
inline FileKind detect_kind(const std::filesystem::path& path, std::string_view text) {
    return find_kind(path, text).value_or(FileKind::scene);
}

// The format of a file of other programs by its first bytes, "ZIP", "PDF" or "PNG"; "JSON" for a saved run, too. A
// text that begins with a tag is HTML, SVG or XML. A mark of UTF-8 may stand before it. Empty for any other text.
std::string_view foreign_format(std::string_view content);

// "UTF-16" or "UTF-32" for such a text, also without a mark, if most of its letters are those of Latin; else empty.
std::string_view wide_encoding(std::string_view text);

// True for a file of no text: it begins with control characters beside bytes that are no UTF-8.
bool is_binary(std::string_view content);

// The content of a file. Fails if it is absent, no regular file (opening a pipe can block, a device can have no end),
// unreadable, or larger than limits::file_bytes or `most`; then with the message `too_large`, whose value is `most` in
// MB.
Result<std::string> read_text(const std::filesystem::path&);
Result<std::string> read_text(const std::filesystem::path&, std::uintmax_t most, const MessageId<1>& too_large);

}  // namespace braitenlab
