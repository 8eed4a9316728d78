#include "core/scene/scene_file.h"

#include <algorithm>

#include "core/scene/check.h"
#include "core/scene/paths.h"
#include "core/scene/toml_reader.h"

namespace braitenlab {

namespace {

// The scene that the tree describes; the file's error tells of every mistake.
Scene decode(TomlFile& file) {
    Scene scene;
    const std::string stem = std::filesystem::path(file.name).stem().string();
    scene.name = name_fault(stem) ? "scene" : stem;
    check_format(file);
    TomlTable top(file, file.root, "");
    top.find("format");
    TomlReader<Scene> reader(top, scene);
    describe(reader, Of<Scene>{});
    top.done();
    if (file.error) return scene;
    if (const auto fault = find_fault(scene)) file.error = file.fault_at(fault->path, fault->what);
    return scene;
}

std::optional<Error> apply(const Setting& setting, TomlFile& file, const std::vector<std::string>& known) {
    const bool exists = std::find(known.begin(), known.end(), setting.path) != known.end();
    if (exists && put(file.root, setting)) {
        file.settings.push_back(setting);
        return std::nullopt;
    }
    const std::vector<std::string_view> candidates(known.begin(), known.end());
    return Error{"no such value " + in_quotes(setting.path) + "; the nearest is " +
                     in_quotes(nearest_word(setting.path, candidates)),
                 setting.file, setting.line};
}

}  // namespace

Result<Setting> parse_setting(std::string_view text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        return Error{in_quotes(text) + " is no setting; write PATH=VALUE, like kind.prey.brain.LL=0.5", "--set"};
    const auto trim = [](std::string_view part) {
        const std::size_t first = part.find_first_not_of(" \t"), last = part.find_last_not_of(" \t");
        return first == std::string_view::npos ? std::string() : std::string(part.substr(first, last - first + 1));
    };
    return Setting{trim(text.substr(0, equals)), trim(text.substr(equals + 1))};
}

Result<Scene> parse_scene(std::string_view toml, std::string file_name, const std::vector<Setting>& settings) {
    auto file = parse_toml(toml, std::move(file_name));
    if (!file) return file.error();
    Scene scene = decode(*file);
    if (file->error) return *file->error;
    if (settings.empty()) return scene;

    const std::vector<std::string> known = setting_paths(scene);
    for (const Setting& setting : settings)
        if (auto error = apply(setting, *file, known)) return *error;
    scene = decode(*file);
    if (file->error) return *file->error;
    return scene;
}

Result<Scene> load_scene(const std::filesystem::path& path, const std::vector<Setting>& settings) {
    const auto text = read_text(path);
    if (!text) return text.error();
    return parse_scene(*text, path.string(), settings);
}

Result<BrainGraph> parse_brain(std::string_view toml, std::string file_name) {
    auto file = parse_toml(toml, std::move(file_name));
    if (!file) return file.error();
    check_format(*file);
    BrainFile content;
    TomlTable top(*file, file->root, "");
    if (!top.has("brain") && top.has("kind"))
        return Error{"this is a whole scene; a brain alone has one [brain] table, as saving a brain writes it",
                     file->name};
    top.find("format");
    TomlReader<BrainFile> reader(top, content);
    describe(reader, Of<BrainFile>{});
    top.done();
    if (!top.has("brain") && !file->error)
        file->error = Error{"there is no [brain] table; see the brain of any kind in a scene", file->name};
    if (file->error) return *file->error;
    if (const auto fault = find_fault(content.brain)) return file->fault_at("brain", fault->what);
    return content.brain;
}

Result<BrainGraph> load_brain(const std::filesystem::path& path) {
    const auto text = read_text(path);
    if (!text) return text.error();
    return parse_brain(*text, path.string());
}

}  // namespace braitenlab
