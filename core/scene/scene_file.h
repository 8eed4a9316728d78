// Scenes and brains as TOML: read, write, set one value by its path. Format: docs/scene-format.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/scene/scene.h"
#include "core/scene/settings.h"

namespace braitenlab {

// Reads a scene and applies the settings in order. The scene must be valid without the settings, too. Errors carry file
// and line: syntax, unknown key (with the nearest known one), wrong type, value out of range, unknown name, and every
// fault that check_scene finds.
Result<Scene> parse_scene(std::string_view toml, std::string file_name, const std::vector<Setting>& = {});
Result<Scene> load_scene(const std::filesystem::path&, const std::vector<Setting>& = {});

// The scene in one table of a file that holds more, e.g. "scene" of an exercise, or in the whole file if `table` is
// empty. Paths of settings are relative to the scene. Precondition: the file has this table.
struct TomlFile;  // core/scene/toml_tree.h
Result<Scene> read_scene(TomlFile, const std::string& table, const std::vector<Setting>&);

// As read_scene(), with every independent error, in the order of finding. The scene is meaningful only without errors.
struct ReadScene {
    Scene scene;
    std::vector<Error> errors{};
};
ReadScene read_scene_fully(TomlFile, const std::string& table, const std::vector<Setting>&);

// The scene as TOML, without values at their defaults. parse_scene(write_scene(s)) == s for a scene that check_scene
// accepts, except that a four-neuron brain loses the order (not the ids) of its nodes and wires.
std::string write_scene(const Scene&);

// A brain file: format = 1 and a [brain] table as in a kind.
Result<BrainGraph> parse_brain(std::string_view toml, std::string file_name);
std::string write_brain(const BrainGraph&);

// The first fault of a scene (value out of range, unknown kind of a start, two kinds of one name, brain that does not
// compile …), or nullopt. The message begins with the value's path.
std::optional<Error> check_scene(const Scene&);
std::optional<Error> check_look(const Look&);

// The tables of docs/scene-format.md, in Markdown.
std::string describe_scene_format();

}  // namespace braitenlab
