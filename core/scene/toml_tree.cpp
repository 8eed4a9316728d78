#include "core/scene/toml_tree.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <tuple>

#include <fmt/format.h>

#include "core/scene/nearest.h"
#include "core/scene/schema.h"

namespace braitenlab {

namespace {

constexpr int deepest_key = 8;  // dots in one key; ours need four

// The end of the quoted text that begins at `at`; the text's end when it never closes.
std::size_t skip_quoted(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const std::string closing(text.substr(at, 3) == std::string(3, quote) ? 3 : 1, quote);
    at += closing.size();
    while (at < text.size() && text.substr(at, closing.size()) != closing) {
        if (closing.size() == 1 && text[at] == '\n') return at;  // a syntax error, which the parser will tell
        at += quote == '"' && text[at] == '\\' ? 2 : 1;
    }
    return std::min(at + closing.size(), text.size());
}

// The line of a key of too many parts, or 0. toml++ 3.3 bounds the nesting of values but not of dotted keys, and frees
// its tables recursively: a key of a million dots would overflow the stack.
int line_of_too_deep_key(std::string_view text) {
    int line = 1, dots = 0;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            const std::size_t end = skip_quoted(text, at);
            line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(at),
                                                text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
            at = end;
            continue;
        }
        if (c == '#') {
            at = std::min(text.find('\n', at), text.size());
            continue;
        }
        if (c == '\n' || c == '=' || c == ',') dots = 0;
        if (c == '\n') ++line;
        if (c == '.' && ++dots > deepest_key) return line;
        ++at;
    }
    return 0;
}

const toml::node* child(const toml::node& node, const std::string& part) {
    if (const toml::table* table = node.as_table()) return table->get(part);
    const toml::array* array = node.as_array();
    if (!array || part.empty() || part.size() > 6) return nullptr;
    if (!std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) return nullptr;
    const int index = std::stoi(part);  // people count from 1
    return index >= 1 ? array->get(static_cast<std::size_t>(index - 1)) : nullptr;
}

// The one value of "text" read as TOML; a string where it is none.
toml::table value_of(const std::string& text) {
    toml::table holder;
    const bool one_line = text.find('\n') == std::string::npos && line_of_too_deep_key(text) == 0;
    if (one_line) {
        try {
            holder = toml::parse("value = " + text);
        } catch (const toml::parse_error&) {
            holder.clear();
        }
    }
    if (holder.empty()) holder.insert("value", text);
    return holder;
}

}  // namespace

void TomlFile::fail(const std::string& path, const toml::node* node, std::string what) {
    if (error) return;
    for (auto setting = settings.rbegin(); setting != settings.rend(); ++setting) {
        if (setting->path != path) continue;
        error = Error{std::move(what), setting->file, setting->line};
        return;
    }
    error = Error{std::move(what), name, node ? static_cast<int>(first_place(*node).line) : 0};
}

Error TomlFile::fault_at(const std::string& path, std::string what) const {
    const toml::node* node = &root;
    for (const std::string& part : split_path(path)) {
        const toml::node* next = child(*node, part);
        if (!next) break;
        node = next;
    }
    TomlFile judged{name, {}, settings, {}};
    judged.fail(path, node == &root ? nullptr : node, std::move(what));
    return *judged.error;
}

Result<TomlFile> parse_toml(std::string_view text, std::string file_name) {
    if (text.size() > limits::file_bytes)
        return Error{fmt::format("larger than {} MB; split it", limits::file_bytes >> 20u), std::move(file_name)};
    if (const int line = line_of_too_deep_key(text))
        return Error{"a key has too many dots; the longest is like kind.NAME.body.wheel", std::move(file_name), line};
    try {
        return TomlFile{file_name, toml::parse(text, std::string_view(file_name)), {}, {}};
    } catch (const toml::parse_error& mistake) {
        return Error{"not TOML: " + std::string(mistake.description()), std::move(file_name),
                     static_cast<int>(mistake.source().begin.line)};
    }
}

bool put(toml::table& root, const Setting& setting) {
    std::vector<std::string> parts = split_path(setting.path);
    const std::string key = parts.back();
    parts.pop_back();
    toml::table* table = &root;
    for (const std::string& part : parts) {
        if (!table->contains(part)) table->insert(part, toml::table{});
        table = (*table)[part].as_table();
        if (!table) return false;
    }
    const toml::table holder = value_of(setting.value);
    table->insert_or_assign(key, *holder.get("value"));  // a copy, since that drops the line it had in the setting
    return true;
}

Place first_place(const toml::node& node) {
    Place first{node.source().begin.line, node.source().begin.column};
    const auto consider = [&first](const toml::node& inner) {
        const Place place = first_place(inner);
        if (place.line == 0) return;
        if (first.line == 0 || std::tie(place.line, place.column) < std::tie(first.line, first.column)) first = place;
    };
    if (const toml::table* table = node.as_table()) {
        for (const auto& [key, inner] : *table) consider(inner);
    } else if (const toml::array* array = node.as_array()) {
        for (const toml::node& inner : *array) consider(inner);
    }
    return first;
}

std::string_view type_in_words(const toml::node& node) {
    if (node.is_table()) return "a table";
    if (node.is_array()) return "a list";
    if (node.is_string()) return "text";
    if (node.is_integer()) return "a whole number";
    if (node.is_floating_point()) return "a number";
    if (node.is_boolean()) return "true or false";
    return "a date or time";
}

void check_format(TomlFile& file) {
    const toml::node* format = file.root.get("format");
    if (!format) {
        if (!file.error) file.error = Error{"'format' is missing; begin the file with format = 1", file.name, 1};
    } else if (!format->is_integer() || format->ref<std::int64_t>() != 1) {
        file.fail("format", format, "this program reads format = 1 only; the file may be from a newer one");
    }
}

std::vector<std::string> split_path(std::string_view path) {
    std::vector<std::string> parts;
    for (std::size_t from = 0; from <= path.size();) {
        const std::size_t dot = std::min(path.find('.', from), path.size());
        parts.emplace_back(path.substr(from, dot - from));
        from = dot + 1;
    }
    return parts;
}

}  // namespace braitenlab
