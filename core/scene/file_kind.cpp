#include "core/scene/file_kind.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "core/messages.h"
#include "core/plain_letters.h"
#include "core/scene/schema.h"
#include "core/utf8.h"

namespace braitenlab {

namespace {

std::string_view without_blanks_before(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    return text;
}

// The language of a text in tags, by its first element.
std::string_view markup_format(std::string_view text) {
    bool is_xml = false;
    while (text.starts_with("<?") || text.starts_with("<!--")) {
        const std::string_view end = text[1] == '?' ? "?>" : "-->";
        const std::size_t at = text.find(end);
        text = at == text.npos ? std::string_view() : without_blanks_before(text.substr(at + end.size()));
        is_xml = true;
    }
    const std::string begin = lower_case(std::string(text.substr(0, 20)));
    for (const std::string element : {"html", "head", "body", "svg"})
        if (begin.starts_with("<" + element) || begin.starts_with("<!doctype " + element))
            return element == "svg" ? "SVG" : "HTML";
    const bool is_tag =
        begin.size() > 1 && begin[0] == '<' && (begin[1] == '!' || (begin[1] >= 'a' && begin[1] <= 'z'));
    return is_xml || is_tag ? "XML" : std::string_view();
}

// The name of the first file, zeros up to 100 bytes, numbers, and the name of the format.
bool is_tar(std::string_view content) {
    constexpr std::size_t name = 100, format = 257;
    return content.size() > format && content.substr(format).starts_with("ustar") &&
           content.substr(0, name).find('\0') != content.npos;
}

}  // namespace

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
    if (is_tar(content)) return "tar";
    if (constexpr std::string_view mark = "\uFEFF"; content.starts_with(mark)) content.remove_prefix(mark.size());
    content = without_blanks_before(content);
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
                                           Signature{"\x28\xB5\x2F\xFD", "zstd"},
                                           Signature{"SQLite format 3", "SQLite"},
                                           Signature{"%!PS", "PostScript"},
                                           Signature{"Rar!", "RAR"},
                                           Signature{"RIFF", "RIFF"},
                                           Signature{"\xD0\xCF\x11\xE0", "Office"},
                                           Signature{"\x7F"
                                                     "ELF",
                                                     "ELF"},
                                           Signature{"{\\rtf", "RTF"},
                                           Signature{"{", "JSON"}};
    const auto found = std::find_if(signatures.begin(), signatures.end(), [content](const Signature& signature) {
        return content.starts_with(signature.bytes);
    });
    return found == signatures.end() ? markup_format(content) : found->format;
}

std::string_view wide_encoding(std::string_view text) {
    using namespace std::string_view_literals;
    if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
    if (text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv)) return "UTF-16";
    const std::size_t looked_at = std::min<std::size_t>(text.size(), 400) & ~std::size_t{3}, fours = looked_at / 4;
    std::array<std::size_t, 4> filled{};  // bytes that are no zeros, by their place in each four
    for (std::size_t i = 0; i < looked_at; ++i) filled[i % 4] += text[i] != '\0';
    const auto has = [&](std::size_t place) { return filled[place] == fours && fours > 0; };
    const auto lacks = [&](std::size_t place) { return 4 * filled[place] < fours; };
    if ((has(0) && lacks(1) && has(2) && lacks(3)) || (lacks(0) && has(1) && lacks(2) && has(3))) return "UTF-16";
    const bool is_wide = lacks(1) && lacks(2) && ((has(0) && lacks(3)) || (lacks(0) && has(3)));
    return is_wide ? "UTF-32" : std::string_view();
}

bool is_binary(std::string_view content) {
    std::string_view begin = content.substr(0, 1024);
    while (!begin.empty() && (begin.back() & 0x80)) begin.remove_suffix(1);  // a character may be cut there
    const auto is_odd = [](unsigned char c) { return c < 0x20 && c != '\f' && is_control(c); };
    return std::any_of(begin.begin(), begin.end(), is_odd) && !is_utf8(begin);
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
