// Scenes as TOML: read, write, and set one value by its path. The format: docs/scene-format.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/scene/scene.h"

namespace braitenlab {

// "kind.prey.brain.LL=0.5": one value of a scene, by the path that its TOML shows. The value is read as TOML, or taken
// as text where it is none.
struct Setting {
    std::string path, value;
    std::string file = "--set";  // and line: where it stands, for messages
    int line = 0;
};

// Splits at the first '='. Fails without one, naming the form it should have.
Result<Setting> parse_setting(std::string_view text);

// Reads a scene and applies the settings to it in order. The scene must be sound without them too. Every mistake
// (syntax, unknown key, wrong type, out of range, a name that nothing bears) is an Error with file and line that names
// the nearest known word.
Result<Scene> parse_scene(std::string_view toml, std::string file_name, const std::vector<Setting>& = {});
Result<Scene> load_scene(const std::filesystem::path&, const std::vector<Setting>& = {});

// parse_scene(write_scene(s)) == s for a scene that check_scene accepts. Values at their defaults are left out; a
// four-neuron brain is written in its short form, which forgets the order (never the ids) of its nodes and wires.
std::string write_scene(const Scene&);

// A brain alone, for swapping and checking: a file with format = 1 and a [brain] table as in a kind.
Result<BrainGraph> parse_brain(std::string_view toml, std::string file_name);
Result<BrainGraph> load_brain(const std::filesystem::path&);
std::string write_brain(const BrainGraph&);

// What is wrong with a scene as a whole: a value out of its range, a start of an unknown kind, two kinds of one name, a
// brain that does not compile. The message begins with the value's path.
std::optional<Error> check_scene(const Scene&);

}  // namespace braitenlab
