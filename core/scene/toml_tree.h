// A TOML text as a tree, and the place in it that an error is about. For the readers of core's own files only.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "core/result.h"
#include "core/scene/file_kind.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

// One file being read: where its values came from and the first mistake found in it.
struct TomlFile {
    std::string name;  // for messages
    toml::table root;
    std::vector<Setting> settings;  // those already put into the tree: they answer for their values
    std::optional<Error> error;

    // Keeps the first error only: later ones are often its echoes.
    void fail(const std::string& path, const toml::node* node, std::string what);

    // The line of the value at a dotted path ("kind.prey.body.wheel.2.load"), or of the last table on the way to it.
    Error fault_at(const std::string& path, std::string what) const;
};

// Fails on bad syntax, on more than limits::file_bytes, and on keys nested deeper than any file of ours.
Result<TomlFile> parse_toml(std::string_view text, std::string file_name);

// Puts a value into the tree, making the tables on the way: what reads as TOML is taken as that, anything else as a
// string. False when the path runs through something that is not a table.
bool put(toml::table& root, const Setting&);

// The line where a node or anything in it first appears; 0 for one that no file holds.
struct Place {
    unsigned line = 0, column = 0;
};
Place first_place(const toml::node&);

// "a whole number", "a table" …
std::string_view type_in_words(const toml::node&);

// 'format = 1' must stand at the top of every file; the error says so when it does not.
void check_format(TomlFile&);

// The parts of "a.b.c".
std::vector<std::string> split_path(std::string_view path);

}  // namespace braitenlab
