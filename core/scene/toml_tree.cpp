#include "core/scene/toml_tree.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <toml++/toml.h>

#include "core/scene/schema.h"
#include "core/scene/toml_advice.h"
#include "core/text_parts.h"
#include "core/utf8.h"

namespace braitenlab {

namespace {

constexpr int deepest_key = 8;            // dots in one key; ours need four
constexpr std::size_t most_faults = 200;  // of one file; a person reads less, and each is compared with all before it

// The parser quotes names of the file whole and cuts its sentence after 1024 characters without a sign.
std::string cut_sentence(std::string sentence) {
    constexpr std::size_t most = 240;
    return sentence.size() <= most ? sentence : utf8_cut(std::move(sentence), most) + "…";
}

// True for a quote after an odd number of backslashes in text[from, at).
bool is_escaped(std::string_view text, std::size_t from, std::size_t at) {
    std::size_t first = at;
    while (first > from && text[first - 1] == '\\') --first;
    return (at - first) % 2 == 1;
}

// The position after the quoted text that begins at `at`; the end of the text when the quote is not closed.
std::size_t skip_quoted(std::string_view text, std::size_t at) {
    const char quote = text[at];
    const auto are_quotes = [&](std::size_t from, std::size_t count) {
        return from + count <= text.size() && text.substr(from, count).find_first_not_of(quote) == text.npos;
    };
    const bool is_long = are_quotes(at, 3);
    for (at += is_long ? 3 : 1;;) {
        const std::size_t end = text.find(quote, at);
        const std::size_t line_end = is_long ? text.npos : text.substr(at, std::min(end, text.size()) - at).find('\n');
        if (line_end != text.npos) return at + line_end;  // a syntax error; the parser reports it
        if (end == text.npos) return text.size();
        const bool closes = (quote == '\'' || !is_escaped(text, at, end)) && (!is_long || are_quotes(end, 3));
        at = end + 1;
        if (!closes) continue;
        if (!is_long) return at;
        at += 2;
        // Up to two quotes before the closing three belong to the text.
        for (int more = 0; more < 2 && at < text.size() && text[at] == quote; ++more) ++at;
        return at;
    }
}

// True when a line has more than deepest_key dots, as the line of a too deep key has.
bool has_line_of_many_dots(std::string_view text) {
    int dots = 0;
    std::size_t line_end = 0;
    for (std::size_t dot = text.find('.'); dot != text.npos; dot = text.find('.', dot + 1)) {
        if (dot >= line_end) dots = 0, line_end = std::min(text.find('\n', dot), text.size());
        if (++dots > deepest_key) return true;
    }
    return false;
}

// The line of the first key with more than deepest_key dots, or 0. toml++ 3.3 limits the nesting of values but not of
// dotted keys, and frees its tables recursively: a key of a million dots overflows the stack.
int line_of_too_deep_key(std::string_view text) {
    if (!has_line_of_many_dots(text)) return 0;
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

// The line of the first carriage return that no line feed follows, or 0. TOML forbids it; toml++ reads a comment over
// it, up to the end of the file.
int line_of_bare_return(std::string_view text) {
    std::size_t at = text.find('\r');
    while (at != text.npos && at + 1 < text.size() && text[at + 1] == '\n') at = text.find('\r', at + 1);
    if (at == text.npos) return 0;
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

// The list entry or member that a part of a path names, or null.
const TomlNode* child(const TomlNode& node, const std::string& part) {
    if (node.as_table()) return node.get(part);
    const TomlNode::List* list = node.as_list();
    if (!list || part.empty() || part.size() > 6) return nullptr;
    if (!std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; })) return nullptr;
    const int index = std::stoi(part);
    return index >= 1 && index <= static_cast<int>(list->size()) ? &(*list)[static_cast<std::size_t>(index - 1)]
                                                                 : nullptr;
}

TomlPlace place_of(const toml::source_region& region) { return {region.begin.line, region.begin.column}; }

void take_earliest(TomlPlace& first, TomlPlace inner) {
    if (inner.line == 0) return;
    if (first.line == 0 || inner < first) first = inner;
}

// Takes the texts out of the node.
TomlNode node_from(toml::node& node) {
    TomlNode made{TomlNode::Date{}, place_of(node.source())};
    if (toml::table* table = node.as_table()) {
        auto& members = made.content.emplace<TomlNode::Table>();
        members.reserve(table->size());
        for (auto&& [key, value] : *table) {  // in the order of the keys
            members.push_back({std::string(key.str()), place_of(key.source()), node_from(value)});
            take_earliest(made.place, members.back().value.place);
        }
    } else if (toml::array* array = node.as_array()) {
        auto& elements = made.content.emplace<TomlNode::List>();
        elements.reserve(array->size());
        for (toml::node& value : *array) {
            elements.push_back(node_from(value));
            take_earliest(made.place, elements.back().place);
        }
    } else if (auto* text = node.as_string()) {
        made.content = std::move(text->get());
    } else if (const auto* whole = node.as_integer()) {
        made.content = whole->get();
    } else if (const auto* number = node.as_floating_point()) {
        made.content = number->get();
    } else if (const auto* flag = node.as_boolean()) {
        made.content = flag->get();
    }
    return made;
}

void forget_places(TomlNode& node) {
    node.place = {};
    if (auto* members = std::get_if<TomlNode::Table>(&node.content))
        for (TomlMember& member : *members) member.key_place = {}, forget_places(member.value);
    if (auto* elements = std::get_if<TomlNode::List>(&node.content))
        for (TomlNode& element : *elements) forget_places(element);
}

// A setting's text read as one TOML value; as a string where it is none.
TomlNode value_of(const std::string& text) {
    const bool one_line = text.find('\n') == std::string::npos && line_of_too_deep_key(text) == 0;
    if (one_line) {
        try {
            toml::table holder = toml::parse("value = " + text);
            TomlNode value = node_from(*holder.get("value"));
            forget_places(value);  // they are not lines of the file
            return value;
        } catch (const toml::parse_error&) {
            // taken as a string
        }
    }
    return {text};
}

// Empties a line, from 1, that gives a key a value of one line. False for another line.
bool empty_line(std::string& text, int line) {
    std::size_t from = 0;
    for (; line > 1; --line) {
        from = text.find('\n', from);
        if (from == text.npos) return false;
        ++from;
    }
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view content = std::string_view(text).substr(from, end - from);
    const std::size_t first = content.find_first_not_of(" \t");
    const bool gives_value = first != content.npos && content[first] != '[' && content.find('=') != content.npos;
    for (const std::string_view opens : {"[", "{", "\"\"\"", "'''"})
        if (!gives_value || content.find(opens) != content.npos) return false;
    text.erase(from, end - from);
    return true;
}

TomlNode::Table::const_iterator position(const TomlNode::Table& members, std::string_view key) {
    return std::lower_bound(members.begin(), members.end(), key,
                            [](const TomlMember& member, std::string_view wanted) { return member.key < wanted; });
}

// The member of a table, made where it is absent.
TomlNode& member_of(TomlNode::Table& members, const std::string& key) {
    auto at = members.begin() + (position(members, key) - members.cbegin());
    if (at == members.end() || at->key != key) at = members.insert(at, TomlMember{key, {}, {TomlNode::Table{}}});
    return at->value;
}

// The table of a list that has this name, or goes FROM-TO; null if there is none, or several: names may have a '-',
// too.
TomlNode* list_element(TomlNode::List& list, std::string_view part) {
    const auto text_of = [](const TomlNode& element, std::string_view key) {
        const TomlNode* value = element.get(key);
        return value && value->as_text() ? *value->as_text() : std::string();
    };
    const auto is_meant = [&](const TomlNode& element) {
        return element.as_table() &&
               (text_of(element, "name") == part || text_of(element, "from") + "-" + text_of(element, "to") == part);
    };
    const auto found = std::find_if(list.begin(), list.end(), is_meant);
    if (found == list.end() || std::any_of(found + 1, list.end(), is_meant)) return nullptr;
    return &*found;
}

}  // namespace

std::optional<double> TomlNode::as_number() const {
    if (const std::int64_t* whole = as_whole()) return static_cast<double>(*whole);
    const double* number = std::get_if<double>(&content);
    return number ? std::optional(*number + 0.0) : std::nullopt;  // −0 + 0 is 0: both give the same run and hash
}

const TomlNode* TomlNode::get(std::string_view key) const {
    const Table* members = as_table();
    if (!members) return nullptr;
    const auto at = position(*members, key);
    return at != members->end() && at->key == key ? &at->value : nullptr;
}

MessageId<0> TomlNode::type() const {
    static constexpr std::array<MessageId<0>, std::variant_size_v<decltype(content)>> types{
        "a_table", "a_list", "a_text", "a_whole_number", "a_number", "true_or_false", "a_date"};
    return types[content.index()];
}

void TomlFile::fail(const std::string& path, const TomlNode* node, Message what) {
    for (auto setting = settings.rbegin(); setting != settings.rend(); ++setting)
        if (setting->path == path) return add(path, error_of(std::move(what), setting->file, setting->line));
    add(path, error_of(std::move(what), name, node ? static_cast<int>(node->place.line) : 0));
}

bool TomlFile::is_full() const { return faults.size() >= most_faults; }

void TomlFile::add(const std::string& path, Error error) {
    if (is_full()) return;
    const auto is_here = [&](const TomlFault& fault) { return fault.path == path; };
    if (std::none_of(faults.begin(), faults.end(), is_here)) faults.push_back({path, std::move(error)});
}

bool TomlFile::failed_at(std::string_view path) const {
    return std::any_of(faults.begin(), faults.end(), [path](const TomlFault& fault) {
        return fault.path.starts_with(path) && (fault.path.size() == path.size() || fault.path[path.size()] == '.');
    });
}

Error TomlFile::fault_at(const std::string& path, Message what) const {
    const TomlNode* node = &root;
    for (const std::string& part : parts_of(path, '.')) {
        const TomlNode* next = child(*node, part);
        if (!next) break;
        node = next;
    }
    TomlFile judged{name, {}, settings};
    judged.fail(path, node == &root ? nullptr : node, std::move(what));
    return judged.error();
}

std::vector<Error> TomlFile::errors() const {
    std::vector<Error> all;
    for (const TomlFault& fault : faults) all.push_back(fault.error);
    return in_order(std::move(all), name);
}

std::vector<Error> in_order(std::vector<Error> errors, std::string_view file) {
    std::vector<Error> ordered;
    for (Error& each : errors)
        if (std::find(ordered.begin(), ordered.end(), each) == ordered.end()) ordered.push_back(std::move(each));
    const auto place = [file](const Error& error) { return std::pair(error.file != file, error.line); };
    std::stable_sort(ordered.begin(), ordered.end(),
                     [&](const Error& a, const Error& b) { return place(a) < place(b); });
    return ordered;
}

Result<TomlFile> parse_toml(std::string_view text, std::string file_name) {
    if (text.size() > limits::file_bytes)
        return error_of(message_of("too_large", limits::file_bytes >> 20u), std::move(file_name));
    if (const std::string_view format = foreign_format(text); !format.empty()) {
        const bool is_run = text.substr(0, 200).find("\"braitenlab_run\"") != text.npos;
        return error_of(is_run ? message_of("run_as_toml") : message_of("other_file", format), std::move(file_name));
    }
    if (const std::string_view encoding = wide_encoding(text); !encoding.empty())
        return error_of(message_of("in_encoding", encoding) + message_of("advice_utf8"), std::move(file_name));
    if (!text.empty() && text.find_first_not_of('\0') == text.npos)
        return error_of(message_of("only_zeros"), std::move(file_name));
    if (is_binary(text)) return error_of(message_of("not_text"), std::move(file_name));
    if (const int line = line_of_bare_return(text))
        return error_of(message_of("bare_returns"), std::move(file_name), line);
    if (const int line = line_of_too_deep_key(text))
        return error_of(message_of("too_deep_key"), std::move(file_name), line);
    try {
        toml::table tree = toml::parse(text, std::string_view(file_name));
        return TomlFile{file_name, node_from(tree)};
    } catch (const toml::parse_error& mistake) {
        const int line = static_cast<int>(mistake.source().begin.line);
        const std::string what = cut_sentence(std::string(mistake.description()));
        if (const auto open = open_text(text); open && open->line <= line)
            return error_of(message_of("not_toml", what) + message_of("advice_open_text", open->quotes),
                            std::move(file_name), open->line);
        if (const int open = line_of_open_list(text, line))
            return error_of(message_of("not_toml", what) + message_of("advice_closing_bracket"), std::move(file_name),
                            open);
        return error_of(message_of("not_toml", what) + toml_advice(text, line), std::move(file_name), line);
    }
}

std::vector<Error> syntax_errors(std::string_view text, const std::string& file_name) {
    constexpr std::size_t most = 20, largest = std::size_t{1} << 18u;  // errors; bytes: for each the text is read again
    std::string rest(text);
    std::vector<Error> errors;
    while (errors.size() < most) {
        const auto file = parse_toml(rest, file_name);
        if (file) break;
        Error error = file.error();
        if (!errors.empty() && error.line <= errors.back().line) break;
        const int line = error.line;
        errors.push_back(std::move(error));
        if (line <= 0 || rest.size() > largest || !empty_line(rest, line)) break;
    }
    return errors;
}

bool put(TomlNode& root, const Setting& setting) {
    TomlNode* node = &root;
    for (const std::string& part : parts_of(setting.path, '.')) {
        if (auto* list = std::get_if<TomlNode::List>(&node->content)) {
            node = list_element(*list, part);
            if (!node) return false;
            continue;
        }
        auto* members = std::get_if<TomlNode::Table>(&node->content);
        if (!members) return false;
        node = &member_of(*members, part);
    }
    *node = value_of(setting.value);
    return true;
}

void check_format(TomlFile& file) {
    const TomlNode* format = file.root.get("format");
    if (!format) {
        file.add("format", error_of(message_of("no_format"), file.name, 1));
    } else if (!format->as_whole() || *format->as_whole() < 1) {
        file.fail("format", format, message_of("format_whole"));
    } else if (*format->as_whole() != 1) {
        file.fail("format", format, message_of("other_format"));
    }
}

}  // namespace braitenlab
