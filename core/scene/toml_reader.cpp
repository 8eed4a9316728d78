#include "core/scene/toml_reader.h"

#include <tuple>

#include <fmt/format.h>

namespace braitenlab {

void TomlTable::wrong_type(std::string_view key, const toml::node& found, std::string_view wanted) {
    fail(key, fmt::format("'{}' should be {}, not {}", key, wanted, type_in_words(found)));
}

const toml::node* TomlTable::find(std::string_view key) {
    known_.emplace_back(key);
    return table_.get(key);
}

namespace {

bool is_number(const toml::node& node) { return node.is_integer() || node.is_floating_point(); }
double as_number(const toml::node& node) {
    return node.is_integer() ? static_cast<double>(node.ref<std::int64_t>()) : node.ref<double>();
}

}  // namespace

std::optional<double> TomlTable::number(std::string_view key, Range range) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!is_number(*node)) return wrong_type(key, *node, "a number"), std::nullopt;
    const double value = as_number(*node);
    if (!range.holds(value)) return fail(key, outside(key, value, range)), std::nullopt;
    return value;
}

std::optional<maths::vec2> TomlTable::pair(std::string_view key, Range range) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    const toml::array* both = node->as_array();
    if (!both || both->size() != 2 || !is_number(*both->get(0)) || !is_number(*both->get(1)))
        return fail(key, fmt::format("'{}' should be two numbers, [x, y]", key)), std::nullopt;
    for (const toml::node& one : *both)
        if (!range.holds(as_number(one))) return fail(key, outside(key, as_number(one), range)), std::nullopt;
    return maths::vec2{static_cast<float>(as_number(*both->get(0))), static_cast<float>(as_number(*both->get(1)))};
}

std::optional<std::int64_t> TomlTable::whole(std::string_view key, Range range) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_integer()) return wrong_type(key, *node, "a whole number"), std::nullopt;
    const std::int64_t value = node->ref<std::int64_t>();
    if (!range.holds(static_cast<double>(value)))
        return fail(key, outside(key, static_cast<double>(value), range)), std::nullopt;
    return value;
}

std::optional<bool> TomlTable::flag(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_boolean()) return wrong_type(key, *node, "true or false"), std::nullopt;
    return node->ref<bool>();
}

std::optional<std::string> TomlTable::text(std::string_view key, std::size_t longest) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_string()) return wrong_type(key, *node, "text in quotes"), std::nullopt;
    const std::string& value = node->ref<std::string>();
    if (value.size() <= longest) return value;
    fail(key, fmt::format("'{}' has {} bytes, the most is {}; shorten it", key, value.size(), longest));
    return std::nullopt;
}

std::optional<std::size_t> TomlTable::one_of(std::string_view key, const std::vector<std::string_view>& words) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_string()) return wrong_type(key, *node, "a word in quotes"), std::nullopt;
    const std::string& value = node->ref<std::string>();
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == value) return i;
    fail(key, fmt::format("'{}' cannot be {}{}", key, in_quotes(value), name_nearest(value, words)));
    return std::nullopt;
}

const toml::table* TomlTable::table(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return nullptr;
    if (!node->is_table()) return wrong_type(key, *node, fmt::format("a table, [{}]", path(key))), nullptr;
    return node->as_table();
}

const toml::array* TomlTable::list(std::string_view key, std::size_t most) {
    const toml::node* node = find(key);
    if (!node) return nullptr;
    if (!node->is_array()) return wrong_type(key, *node, "a list"), nullptr;
    const toml::array* array = node->as_array();
    if (array->size() <= most) return array;
    fail(key, fmt::format("'{}' has {} entries, the most is {}", key, array->size(), most));
    return nullptr;
}

const toml::array* TomlTable::list_of_tables(std::string_view key, std::size_t most) {
    const toml::array* array = list(key, most);
    if (!array) return nullptr;
    for (const toml::node& node : *array) {
        if (node.is_table()) continue;
        file_.fail(path(key), &node, fmt::format("'{}' should be a list of tables, [[{}]]", key, path(key)));
        return nullptr;
    }
    return array;
}

std::vector<std::pair<std::string, const toml::table*>> TomlTable::named(std::string_view key, std::size_t most) {
    struct Entry {
        Place place;
        std::string name;
        const toml::table* table;
    };
    std::vector<Entry> entries;
    const toml::table* tables = table(key);
    if (!tables) return {};
    if (tables->size() > most) {
        fail(key, fmt::format("{} tables [{}.…], the most is {}", tables->size(), path(key), most));
        return {};
    }
    for (const auto& [name, node] : *tables) {
        const std::string where = path(key) + "." + std::string(name.str());
        std::optional<std::string> fault = name_fault(name.str());
        if (!node.is_table())
            fault = fmt::format("[{0}] holds named tables like [{0}.one], and {1} is {2}", path(key),
                                in_quotes(name.str()), type_in_words(node));
        if (fault) {
            file_.fail(where, &node, *fault);
            return {};
        }
        entries.push_back({first_place(node), std::string(name.str()), node.as_table()});
    }
    // toml++ keeps tables by name; people mean the order in which they wrote them.
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    std::vector<std::pair<std::string, const toml::table*>> sorted;
    for (const Entry& entry : entries) sorted.emplace_back(entry.name, entry.table);
    return sorted;
}

void TomlTable::done() {
    const toml::key* first = nullptr;
    for (const auto& [key, node] : table_) {
        if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
        if (!first || key.source().begin < first->source().begin) first = &key;
    }
    if (!first) return;
    const std::vector<std::string_view> candidates(known_.begin(), known_.end());
    const std::string where = path_.empty() ? "at the top of the file" : "in [" + path_ + "]";
    fail(first->str(),
         fmt::format("no key {} {}{}", in_quotes(first->str()), where, name_nearest(first->str(), candidates)));
}

}  // namespace braitenlab
