#include "core/scene/scene_file.h"

#include <algorithm>
#include <span>

#include "core/brain/four_neurons.h"
#include "core/scene/check.h"
#include "core/scene/format_table.h"
#include "core/scene/schema.h"
#include "core/scene/sealed.h"
#include "core/scene/toml_reader.h"
#include "core/text_parts.h"
#include "core/utf8.h"

namespace braitenlab {

namespace {

// The visitor of core/scene/schema.h that collects paths.
template <class T>
class PathList {
public:
    PathList(const T& object, std::string prefix, std::vector<std::string>& paths)
        : object_(object), prefix_(std::move(prefix)), paths_(paths) {}

    void number(const char* key, auto T::*, const char*, Range, const char*) { paths_.push_back(prefix_ + key); }
    void angle(const char* key, float T::*, Range, const char*) { paths_.push_back(prefix_ + key); }
    void flag(const char* key, bool T::*, const char*) { paths_.push_back(prefix_ + key); }
    void word(const char* key, auto T::*, const char*) { paths_.push_back(prefix_ + key); }
    void text(const char* key, std::string T::*, std::size_t, const char*) { paths_.push_back(prefix_ + key); }
    void colour(const char* key, std::string T::*, const char*) { paths_.push_back(prefix_ + key); }
    void table(const char* key, auto T::*member, const char*) { walk(object_.*member, prefix_ + key + "."); }
    template <class Element>
    void named(const char* key, std::vector<Element> T::*member, std::size_t, const char*) {
        for (const Element& element : object_.*member) walk(element, prefix_ + key + "." + element.name + ".");
    }
    template <class Element>
    void named(const char* key, std::optional<std::vector<Element>> T::*member, std::size_t, const char*) {
        if (!(object_.*member)) return;
        for (const Element& element : *(object_.*member)) walk(element, prefix_ + key + "." + element.name + ".");
    }
    void list(const char*, auto T::*, std::size_t, const char*) {}
    void brain(const char* key, BrainGraph T::*, const char*) { walk(FourNeurons{}, prefix_ + key + "."); }
    void brain(const char* key, std::optional<BrainGraph> T::*member, const char*) {
        if (object_.*member) walk(FourNeurons{}, prefix_ + key + ".");
    }

private:
    template <class Inner>
    void walk(const Inner& inner, const std::string& prefix) {
        PathList<Inner> list(inner, prefix, paths_);
        describe(list, Of<Inner>{});
    }

    const T& object_;
    std::string prefix_;
    std::vector<std::string>& paths_;
};

// The paths of all values outside lists ("kind.prey.brain.LL", "source.lamp.x"); of a brain the dials only, see
// is_in_brain_list().
std::vector<std::string> setting_paths(const Scene& scene) {
    std::vector<std::string> paths;
    PathList<Scene> list(scene, "", paths);
    describe(list, Of<Scene>{});
    return paths;
}

// True for a path into the further wires or nodes of a brain that has such: "kind.prey.brain.wire.OL-ML.weight".
// Whether it has this one is judged by put().
bool is_in_brain_list(const TomlNode& root, std::string_view path) {
    for (const std::string_view list : {".brain.wire.", ".brain.node."}) {
        const std::size_t at = path.find(list);
        if (at == path.npos) continue;
        const TomlNode* node = &root;
        for (const std::string& part : parts_of(path.substr(0, at + list.size() - 1), '.'))
            if (node) node = node->get(part);
        return node && node->as_list();
    }
    return false;
}

std::string joined(const std::string& table, const std::string& path) {
    return table.empty() ? path : table + "." + path;
}

// The brains of the kinds that a file names under `sealed`.
void read_sealed(TomlTable& top, Scene& scene) {
    const TomlNode* sealed = top.table("sealed");
    const TomlNode::Table* brains = sealed ? sealed->as_table() : nullptr;
    if (!brains) return;
    for (const TomlMember& member : *brains) {
        const int kind = find_kind(scene, member.key);
        const std::string* text = member.value.as_text();
        auto brain = text ? unseal(*text) : std::nullopt;
        const std::string path = "sealed." + member.key;
        if (kind < 0)
            return top.file().fail(top.path(path), &member.value,
                                   message_of("no_kind_of_scene", in_quotes(member.key)));
        if (!brain) return top.file().fail(top.path(path), &member.value, message_of("sealed_damaged"));
        Kind& of_scene = scene.kinds[static_cast<std::size_t>(kind)];
        of_scene.brain = std::move(*brain), of_scene.hidden = true;
    }
}

// The scene in a table of the tree, or in the whole tree; the errors are in file.faults.
Scene decode(TomlFile& file, const std::string& table) {
    Scene scene;
    const std::string stem = std::filesystem::path(file.name).stem().string();
    scene.name = name_fault(stem) ? "scene" : stem;
    TomlTable top(file, table.empty() ? file.root : *file.root.get(table), table);
    if (table.empty()) check_format(file), top.find("format");
    TomlReader<Scene> reader(top, scene);
    describe(reader, Of<Scene>{});
    read_sealed(top, scene);
    top.done();
    if (file.failed()) return scene;
    if (const auto fault = find_fault(scene)) {
        const std::string path = joined(table, fault->path);
        file.add(path, file.fault_at(path, fault->what));
    }
    return scene;
}

// The path of a value that is given in short: "LR" alone is the dial of the first vehicle's kind, or of the vehicle if
// it has a brain of its own.
std::string whole_path(const std::string& path, const Scene& scene) {
    if (!dial_named(path) || scene.starts.empty()) return path;
    const Start& first = scene.starts.front();
    return (first.brain ? "vehicle." + first.name : "kind." + first.kind) + ".brain." + path;
}

// The known path for a message: one that ends like the given one goes before those of a smaller distance.
std::string_view nearest_path(const std::string& path, std::span<const std::string_view> known) {
    const std::string end = "." + path.substr(path.rfind('.') + 1);
    std::vector<std::string_view> alike;
    for (const std::string_view each : known)
        if (each.ends_with(end)) alike.push_back(each);
    return nearest_word(path, alike.empty() ? known : std::span<const std::string_view>(alike));
}

std::optional<Error> apply(const Setting& setting, const std::string& table, TomlFile& file,
                           const std::vector<std::string>& known) {
    Setting in_file = setting;
    in_file.path = joined(table, setting.path);
    const bool exists =
        std::find(known.begin(), known.end(), setting.path) != known.end() || is_in_brain_list(file.root, in_file.path);
    if (exists && put(file.root, in_file)) {
        file.settings.push_back(in_file);
        return std::nullopt;
    }
    const std::vector<std::string_view> candidates(known.begin(), known.end());
    return error_of(message_of("no_such_value", in_quotes(setting.path)) +
                        message_of("nearest", in_quotes(nearest_path(setting.path, candidates))),
                    setting.file, setting.line);
}

}  // namespace

ReadScene read_scene_fully(TomlFile file, const std::string& table, const std::vector<Setting>& settings) {
    const auto read = [&](Scene scene) {
        ReadScene made{std::move(scene)};
        for (TomlFault& fault : file.faults) made.errors.push_back(std::move(fault.error));
        return made;
    };
    Scene scene = decode(file, table);
    if (file.failed() || settings.empty()) return read(std::move(scene));

    const std::vector<std::string> known = setting_paths(scene);
    for (Setting setting : settings) {
        setting.path = whole_path(setting.path, scene);
        if (auto error = apply(setting, table, file, known)) file.add("setting " + setting.path, std::move(*error));
    }
    if (file.failed()) return read(std::move(scene));
    return read(decode(file, table));
}

Result<Scene> read_scene(TomlFile file, const std::string& table, const std::vector<Setting>& settings) {
    ReadScene read = read_scene_fully(std::move(file), table, settings);
    if (!read.errors.empty()) return read.errors.front();
    return std::move(read.scene);
}

Result<Scene> parse_scene(std::string_view toml, std::string file_name, const std::vector<Setting>& settings) {
    auto file = parse_toml(toml, std::move(file_name));
    if (!file) return file.error();
    return read_scene(std::move(*file), "", settings);
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
    if (!top.has("brain") && top.has("kind")) return error_of(message_of("scene_not_brain"), file->name);
    top.find("format");
    TomlReader<BrainFile> reader(top, content);
    describe(reader, Of<BrainFile>{});
    top.done();
    if (!top.has("brain") && !file->failed()) return error_of(message_of("no_brain_table"), file->name);
    if (file->failed()) return file->error();
    if (const auto fault = find_fault(content.brain)) return file->fault_at("brain", fault->what);
    return content.brain;
}

std::string describe_scene_format() { return describe_top<Scene>(); }

std::optional<Error> check_scene(const Scene& scene) {
    const auto fault = find_fault(scene);
    if (!fault) return std::nullopt;
    return error_of(fault->path.empty() ? fault->what : Message(fault->path + ": ") + fault->what);
}

std::optional<Error> check_look(const Look& look) {
    if (count_characters(look.label) > limits::name_length)
        return error_of(message_of("longer_than", "label", limits::name_length));
    if (!look.colour.empty() && !is_colour(look.colour)) return error_of(message_of("a_colour", "colour"));
    return std::nullopt;
}

}  // namespace braitenlab
