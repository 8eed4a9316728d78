// A TOML text as a tree of plain values, each with its line. Every TOML file of both programs is read by parse_toml():
// toml++ is included in toml_tree.cpp alone, and a test refuses it elsewhere.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/settings.h"

namespace braitenlab {

// A position in a file, 1-based; 0 for a value that is in no file.
struct TomlPlace {
    unsigned line = 0, column = 0;
    friend bool operator<(const TomlPlace& a, const TomlPlace& b) {
        return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    }
};

struct TomlMember;

// A value of any type. Each as_…() returns null when the value is of another type.
struct TomlNode {
    using Table = std::vector<TomlMember>;  // sorted by key
    using List = std::vector<TomlNode>;
    struct Date {};  // a date, a time or both: no file of the lab has one

    std::variant<Table, List, std::string, std::int64_t, double, bool, Date> content;
    TomlPlace place{};  // of the value; of the first value in it for a table or list that has no place itself

    const Table* as_table() const { return std::get_if<Table>(&content); }
    const List* as_list() const { return std::get_if<List>(&content); }
    const std::string* as_text() const { return std::get_if<std::string>(&content); }
    const std::int64_t* as_whole() const { return std::get_if<std::int64_t>(&content); }
    const bool* as_flag() const { return std::get_if<bool>(&content); }
    std::optional<double> as_number() const;  // of a whole number, too; 0 for −0

    // The member of this name; null when there is none or this is no table.
    const TomlNode* get(std::string_view key) const;
    bool contains(std::string_view key) const { return get(key) != nullptr; }

    // The message of its type: "a_whole_number", "a_table" …
    MessageId<0> type() const;
};

struct TomlMember {
    std::string key;
    TomlPlace key_place;
    TomlNode value;
};

// An error and the dotted path of the value that is wrong.
struct TomlFault {
    std::string path;
    Error error;
};

// A file that is being read: its tree and the errors found in it.
struct TomlFile {
    std::string name;                 // for messages
    TomlNode root;                    // a table
    std::vector<Setting> settings{};  // those already put into the tree; an error in such a value names the setting
    std::vector<TomlFault> faults{};  // in the order of finding

    // Adds an error unless there is one at this path: a second one follows from the first. After 200 errors no more are
    // added.
    void fail(const std::string& path, const TomlNode* node, Message what);
    void add(const std::string& path, Error);

    bool failed() const { return !faults.empty(); }
    // True if no further error is added: then none needs to be looked for.
    bool is_full() const;
    // True if there is an error at the path or in what is below it.
    bool failed_at(std::string_view path) const;
    // The error that was found first. Precondition: failed().
    const Error& error() const { return faults.front().error; }
    // All errors as in_order() has them.
    std::vector<Error> errors() const;

    // An error at the value with a dotted path ("kind.prey.body.wheel.2.load", list entries from 1), or at the last
    // table on the way to it.
    Error fault_at(const std::string& path, Message what) const;
};

// Errors of several files as a person mends them: those of `file` by line, then those of the others. Each once.
std::vector<Error> in_order(std::vector<Error>, std::string_view file);

// Errors: syntax; more than limits::file_bytes; keys of more parts than any format of the lab has; lines that end with
// a carriage return alone; a file of another format, which is named. The time grows with the size of the text, the
// stack with neither its size nor its depth.
Result<TomlFile> parse_toml(std::string_view text, std::string file_name);

// All syntax errors that can be told at once: each line with a wrong value is read as if it were empty. Only the first
// error of a large file, and where another line may be wrong because of it: after a heading, and in a value of several
// lines. Empty for a file that parse_toml() reads.
std::vector<Error> syntax_errors(std::string_view text, const std::string& file_name);

// What a file says; meaningful only without errors.
template <class T>
struct ReadFile {
    T object{};
    std::vector<Error> errors{};
};

// Sets a value in the tree and makes the tables on the way. In a list the path goes on in the table whose name or
// FROM-TO is the next part of the path. The text is read as a TOML value, else taken as a string. False when the path
// runs through another value, or through a list without such a table.
bool put(TomlNode& root, const Setting&);

// Adds an error unless `format = 1` is in the file.
void check_format(TomlFile&);

}  // namespace braitenlab
