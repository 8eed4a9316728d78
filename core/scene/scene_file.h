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

// "kind.prey.brain.LL=0.5": one value of a scene, by the path that its TOML shows.
struct Setting {
    std::string path, value;
};

// Splits at the first '='. Fails without one, naming the form it should have.
Result<Setting> parse_setting(std::string_view text);

// Reads a scene and then applies the settings in order. Every mistake (syntax, unknown key, wrong type, out of range, a
// name that nothing bears) is an Error with file and line that names the nearest known word.
Result<Scene> parse_scene(std::string_view toml, std::string file_name, const std::vector<Setting>& = {});
Result<Scene> load_scene(const std::filesystem::path&, const std::vector<Setting>& = {});

// parse_scene(write_scene(s)) == s. Values at their defaults are left out; a four-neuron brain is written in its short
// form.
std::string write_scene(const Scene&);

// What is wrong with a scene as a whole: a start of an unknown kind, two kinds of one name, a brain that does not compile.
std::optional<Error> check_scene(const Scene&);

}  // namespace braitenlab
