#include "core/scene/file_kind.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "core/messages.h"
#include "core/scene/schema.h"

namespace braitenlab {

std::optional<FileKind> find_kind(const std::filesystem::path& path, std::string_view text) {
    if (path.extension() == ".run") return FileKind::run;
    bool is_scene = false, is_brain = false;
    while (!text.empty()) {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        // A scene has none of these. With one bracket they are mistakes, which the reader of this kind explains.
        if (line.starts_with("[[step]]") || line.starts_with("[step]")) return FileKind::exercise;
        if (line.starts_with("[[page]]") || line.starts_with("[page]")) return FileKind::lecture;
        if (line.starts_with("[[value]]") || line.starts_with("[value]")) return FileKind::study;
        if (line.starts_with("[[breed]]") || line.starts_with("[breed]")) return FileKind::breeding;
        is_scene |= line.starts_with("[kind.") || line.starts_with("[arena]") || line.starts_with("[source.");
        is_brain |= line.starts_with("[brain");
    }
    if (is_scene) return FileKind::scene;
    return is_brain ? std::optional(FileKind::brain) : std::nullopt;
}

std::string_view foreign_format(std::string_view content) {
    content.remove_prefix(std::min(content.find_first_not_of(" \t\r\n"), content.size()));
    struct Signature {
        std::string_view bytes, format;
    };
    // A .docx, .ods or .sb3 is a ZIP, too.
    static constexpr std::array signatures{Signature{"PK\x03\x04", "ZIP"},
                                           Signature{"PK\x05\x06", "ZIP"},
                                           Signature{"%PDF-", "PDF"},
                                           Signature{"\x89PNG", "PNG"},
                                           Signature{"GIF8", "GIF"},
                                           Signature{"\xFF\xD8\xFF", "JPEG"},
                                           Signature{"\x1F\x8B", "gzip"},
                                           Signature{"7z\xBC\xAF", "7z"},
                                           Signature{"\xFD"
                                                     "7zXZ",
                                                     "xz"},
                                           Signature{"BZh", "bzip2"},
                                           Signature{"Rar!", "RAR"},
                                           Signature{"RIFF", "RIFF"},
                                           Signature{"\xD0\xCF\x11\xE0", "Office"},
                                           Signature{"\x7F"
                                                     "ELF",
                                                     "ELF"},
                                           Signature{"{\\rtf", "RTF"},
                                           Signature{"{", "JSON"},
                                           Signature{"<!DOCTYPE html", "HTML"},
                                           Signature{"<!doctype html", "HTML"},
                                           Signature{"<html", "HTML"},
                                           Signature{"<?xml", "XML"}};
    const auto found = std::find_if(signatures.begin(), signatures.end(), [content](const Signature& signature) {
        return content.starts_with(signature.bytes);
    });
    return found == signatures.end() ? std::string_view() : found->format;
}

Result<std::string> read_text(const std::filesystem::path& path) {
    return read_text(path, limits::file_bytes, "too_large");
}

Result<std::string> read_text(const std::filesystem::path& path, std::uintmax_t most, const MessageId<1>& too_large) {
    std::error_code problem;
    const auto status = std::filesystem::status(path, problem);
    if (!std::filesystem::exists(status)) return error_of(message_of("no_file"), path.string());
    if (!std::filesystem::is_regular_file(status)) return error_of(message_of("not_a_file"), path.string());
    if (std::filesystem::file_size(path, problem) > most)
        return error_of(message_of(too_large, most >> 20u), path.string());
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) return error_of(message_of("unreadable"), path.string());
    return std::move(text).str();
}

}  // namespace braitenlab
