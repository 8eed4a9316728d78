#include "core/scene/toml_reader.h"

#include <fmt/format.h>

namespace braitenlab {

namespace {

// True if the next number of a list begins right after the comma behind this one, in "0,5".
bool stands_at_comma(const TomlNode& number, const TomlNode& next) {
    const TomlPlace a = number.place, b = next.place;
    return a.line > 0 && a.line == b.line && b.column == a.column + fmt::formatted_size("{}", *number.as_whole()) + 1;
}

// "; write 0.5, with a point" for [0,5, 1,5], where commas with a digit behind them stand between such with a blank.
std::optional<Message> advice_on_commas(const TomlNode::List& list) {
    std::string first;
    bool before = false, is_spaced = false;  // the pair before touches; some pair does not
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::int64_t* whole = list[i].as_whole();
        if (!whole) return std::nullopt;
        if (i == 0) continue;
        const bool touch = *whole >= 0 && stands_at_comma(list[i - 1], list[i]);
        if (touch && before) return std::nullopt;
        if (touch && first.empty()) first = fmt::format("{}.{}", *list[i - 1].as_whole(), *whole);
        is_spaced |= !touch, before = touch;
    }
    if (first.empty() || !is_spaced) return std::nullopt;
    return message_of("advice_decimal_point", first);
}

}  // namespace

void TomlTable::wrong_type(std::string_view key, const TomlNode& found, const Message& wanted) {
    fail(key, message_of("type_wanted", key) + wanted + message_of("type_found") + message_of(found.type()));
}

const TomlNode* TomlTable::find(std::string_view key) {
    known_.emplace_back(key);
    return table_.get(key);
}

void TomlTable::gather_settings(const TomlNode& table, const std::string& path, const std::string& prefix,
                                std::vector<Setting>& out) {
    for (const auto& [key, key_place, node] : *table.as_table()) {
        const std::string inner = prefix + key;
        Setting setting{inner, "", file_.name, static_cast<int>(node.place.line)};
        if (node.as_table()) {
            gather_settings(node, path, fmt::format("{}.", inner), out);
            continue;
        } else if (const std::int64_t* whole = node.as_whole()) {
            setting.value = fmt::format("{}", *whole);
        } else if (const auto number = node.as_number()) {
            setting.value = fmt::format("{}", *number);
        } else if (const std::string* text = node.as_text()) {
            setting.value = *text;
        } else if (const bool* flag = node.as_flag()) {
            setting.value = *flag ? "true" : "false";
        } else {
            return file_.fail(fmt::format("{}.{}", path, inner), &node, message_of("a_plain_value", in_quotes(inner)));
        }
        out.push_back(std::move(setting));
    }
}

std::optional<double> TomlTable::number(std::string_view key, Range range) {
    const TomlNode* node = find(key);
    if (!node) return std::nullopt;
    const auto value = node->as_number();
    if (!value) return wrong_type(key, *node, message_of("a_number")), std::nullopt;
    if (!range.holds(*value)) return fail(key, outside(key, *value, range)), std::nullopt;
    return value;
}

std::optional<maths::vec2> TomlTable::pair(std::string_view key, Range range) {
    const TomlNode* node = find(key);
    if (!node) return std::nullopt;
    const TomlNode::List* both = node->as_list();
    const bool is_pair = both && both->size() == 2 && (*both)[0].as_number() && (*both)[1].as_number();
    if (!is_pair) {
        const Message advice = (both ? advice_on_commas(*both) : std::nullopt).value_or(Message());
        return fail(key, message_of("type_wanted", key) + message_of("two_numbers") + advice), std::nullopt;
    }
    for (const TomlNode& one : *both)
        if (!range.holds(*one.as_number())) return fail(key, outside(key, *one.as_number(), range)), std::nullopt;
    return maths::vec2{static_cast<float>(*(*both)[0].as_number()), static_cast<float>(*(*both)[1].as_number())};
}

std::optional<std::int64_t> TomlTable::whole(std::string_view key, Range range) {
    const TomlNode* node = find(key);
    if (!node) return std::nullopt;
    if (!node->as_whole()) return wrong_type(key, *node, message_of("a_whole_number")), std::nullopt;
    const std::int64_t value = *node->as_whole();
    if (!range.holds(static_cast<double>(value)))
        return fail(key, outside(key, static_cast<double>(value), range)), std::nullopt;
    return value;
}

std::optional<std::vector<double>> TomlTable::numbers(std::string_view key, std::size_t most, Range range) {
    const TomlNode::List* values = list(key, most);
    if (!values) return std::nullopt;
    std::vector<double> all;
    for (const TomlNode& value : *values) {
        const auto number = value.as_number();
        if (!number) return fail(key, message_of("list_of_numbers", key)), std::nullopt;
        if (!range.holds(*number)) return fail(key, outside(key, *number, range)), std::nullopt;
        all.push_back(*number);
    }
    // Whole numbers that are meant as such and written in pairs ascend or descend.
    if (!std::is_sorted(all.begin(), all.end()) && !std::is_sorted(all.rbegin(), all.rend()))
        if (const auto advice = advice_on_commas(*values))
            return fail(key, message_of("decimal_commas", key) + *advice), std::nullopt;
    return all;
}

std::optional<bool> TomlTable::flag(std::string_view key) {
    const TomlNode* node = find(key);
    if (!node) return std::nullopt;
    if (!node->as_flag()) return wrong_type(key, *node, message_of("true_or_false")), std::nullopt;
    return *node->as_flag();
}

std::optional<std::string> TomlTable::text(std::string_view key, std::size_t longest) {
    const TomlNode* node = find(key);
    if (!node) return std::nullopt;
    if (!node->as_text()) return wrong_type(key, *node, message_of("text_in_quotes")), std::nullopt;
    const std::string& value = *node->as_text();
    const std::size_t characters = count_characters(value);
    if (characters <= longest) return value;
    fail(key, message_of("too_long", key, characters, longest));
    return std::nullopt;
}

std::optional<std::size_t> TomlTable::one_of(std::string_view key, const std::vector<std::string_view>& words) {
    const TomlNode* node = find(key);
    if (!node) return std::nullopt;
    if (!node->as_text()) return wrong_type(key, *node, message_of("a_word_in_quotes")), std::nullopt;
    const std::string& value = *node->as_text();
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == value) return i;
    fail(key, message_of("not_one_of", key, in_quotes(value)) + nearest_of(value, words));
    return std::nullopt;
}

const TomlNode* TomlTable::table(std::string_view key) {
    const TomlNode* node = find(key);
    if (!node) return nullptr;
    if (!node->as_table()) return wrong_type(key, *node, message_of("a_table_like", path(key))), nullptr;
    return node;
}

const TomlNode::List* TomlTable::list(std::string_view key, std::size_t most) {
    const TomlNode* node = find(key);
    if (!node) return nullptr;
    const TomlNode::List* list = node->as_list();
    if (!list) return wrong_type(key, *node, message_of("a_list")), nullptr;
    if (list->size() <= most) return list;
    fail(key, message_of("too_many_entries", key, list->size(), most));
    return nullptr;
}

const TomlNode::List* TomlTable::list_of_tables(std::string_view key, std::size_t most) {
    if (const TomlNode* node = table_.get(key); node && node->as_table()) {
        find(key);
        file_.fail(path(key), node, message_of("single_table", path(key), path(key)));
        return nullptr;
    }
    const TomlNode::List* tables = list(key, most);
    if (!tables) return nullptr;
    for (const TomlNode& node : *tables) {
        if (node.as_table()) continue;
        file_.fail(path(key), &node, message_of("type_wanted", key) + message_of("tables_like", path(key)));
        return nullptr;
    }
    return tables;
}

std::vector<const TomlMember*> TomlTable::named(std::string_view key, std::size_t most) {
    const TomlNode* tables = table(key);
    if (!tables) return {};
    const TomlNode::Table& members = *tables->as_table();
    if (members.size() > most) {
        fail(key, message_of("too_many_tables", members.size(), path(key), most));
        return {};
    }
    std::vector<const TomlMember*> sorted;
    for (const TomlMember& member : members) {
        std::optional<Message> fault = name_fault(member.key);
        if (!member.value.as_table())
            fault = message_of("named_tables", path(key), path(key), in_quotes(member.key)) +
                    message_of(member.value.type());
        if (fault) {
            file_.fail(path(key) + "." + member.key, &member.value, *fault);
            return {};
        }
        sorted.push_back(&member);
    }
    std::stable_sort(sorted.begin(), sorted.end(), [](auto* a, auto* b) { return a->value.place < b->value.place; });
    return sorted;
}

std::vector<const TomlMember*> TomlTable::named_in_order(std::string_view key, std::size_t most) {
    std::vector<std::pair<std::int64_t, const TomlMember*>> numbered;
    for (const TomlMember* member : named(key, most)) {
        TomlTable inner(file_, member->value, path(key) + "." + member->key);
        numbered.emplace_back(inner.whole(order_key, {-1e6, 1e6}).value_or(0), member);
    }
    std::stable_sort(numbered.begin(), numbered.end(), [](auto& a, auto& b) { return a.first < b.first; });
    std::vector<const TomlMember*> sorted;
    for (const auto& [number, member] : numbered) sorted.push_back(member);
    return sorted;
}

void TomlTable::done() {
    std::vector<const TomlMember*> unknown;
    for (const TomlMember& member : *table_.as_table())
        if (std::find(known_.begin(), known_.end(), member.key) == known_.end()) unknown.push_back(&member);
    std::sort(unknown.begin(), unknown.end(), [](auto* a, auto* b) { return a->key_place < b->key_place; });
    const std::vector<std::string_view> candidates(known_.begin(), known_.end());
    for (const TomlMember* member : unknown) {
        if (file_.is_full()) return;
        fail_unknown(*member, candidates);
    }
}

void TomlTable::fail_unknown(const TomlMember& member, const std::vector<std::string_view>& candidates) {
    const Message where = path_.empty() ? message_of("at_the_top") : message_of("in_table", path_);
    fail(member.key, message_of("unknown_key", in_quotes(member.key)) + where + nearest_of(member.key, candidates));
}

bool TomlTable::fail_if_misspelt(std::string_view needed, const std::vector<std::string_view>& own,
                                 const std::vector<std::string_view>& foreign) {
    std::vector<std::string_view> candidates(known_.begin(), known_.end());
    candidates.insert(candidates.end(), own.begin(), own.end());
    const auto is_in = [](const std::vector<std::string_view>& keys, const std::string& key) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    int looked_at = 0;
    constexpr int most_looked_at = 1000;  // more unknown keys are no file that a person misspelt
    for (const TomlMember& member : *table_.as_table()) {
        if (is_in(candidates, member.key) || is_in(foreign, member.key)) continue;
        if (++looked_at > most_looked_at) return false;
        if (nearest_word(member.key, candidates) != needed) continue;
        fail_unknown(member, candidates);
        return true;
    }
    return false;
}

}  // namespace braitenlab
