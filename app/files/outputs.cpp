#include "app/files/outputs.h"

#include <algorithm>
#include <fstream>
#include <string_view>

#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "core/io/run_file.h"
#include "core/lesson/hand_in.h"
#include "core/scene/file_kind.h"
#include "core/scene/schema.h"
#include "core/scene/toml_tree.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

void add_named_files(const fs::path& file, std::vector<fs::path>& files) {
    const auto text = read_text(file);
    if (!text || find_kind(file, *text).value_or(FileKind::run) == FileKind::run) return;
    const auto toml = parse_toml(*text, file.string());
    if (!toml) return;
    for (const TomlNode* named : named_files(toml->root)) files.push_back(file.parent_path() / *named->as_text());
}

// A run and the state of a breeding name their format, a report does not.
bool may_replace_json(Written what, std::string_view text, const fs::path& ending) {
    if (what == Written::run) return ending == io::run_ending;
    return what == Written::report && ending != io::run_ending && text.find("\"format\"") == text.npos;
}

}  // namespace

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code none;
    if (fs::exists(a, none)) return fs::is_regular_file(a, none) && fs::equivalent(a, b, none);
    return behind_links(a) == behind_links(b);
}

bool loses_work(const fs::path& file, Written what) {
    std::error_code none;
    if (!fs::is_regular_file(file, none) || fs::file_size(file, none) == 0) return false;
    std::string text(limits::file_bytes, '\0');  // no file of the lab is larger, but for runs and states of breedings
    std::ifstream in(file, std::ios::binary);
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    const std::string_view format = foreign_format(text);
    const fs::path ending = file.extension();
    if (format == "ZIP" || ending == ".zip") return true;
    if (format == "JSON") return !may_replace_json(what, text, ending);
    if (format.empty()) {
        if (holds_hand_in(file.filename().string(), text)) return true;
        const auto kind = find_kind(fs::path(), text);
        const bool is_scene = kind == FileKind::scene || kind == FileKind::brain;
        if (kind) return !(is_scene && what == Written::scene);
    }
    return ending == ".toml" || ending == io::run_ending;
}

void add_with_named_files(const std::string& path_or_name, std::vector<fs::path>& files) {
    const auto file = find_shipped(path_or_name);
    if (!file) return;
    files.push_back(*file);
    add_named_files(*file, files);
}

std::optional<Error> output_fault(const std::vector<fs::path>& read, const std::vector<Output>& outputs) {
    const auto is_in = [](const fs::path& path, const std::vector<fs::path>& files) {
        return std::any_of(files.begin(), files.end(), [&](const fs::path& file) { return is_same_file(path, file); });
    };
    std::vector<fs::path> written{standard_output_file};
    for (const Output& output : outputs) {
        const auto refused = [&](const std::string& why) { return Error{output.option + why, output.path.string()}; };
        if (is_in(output.path, read)) return refused(" names a file that this command reads; give another one");
        if (is_in(output.path, written)) return refused(" names a file that another option writes; give another one");
        written.push_back(output.path);
        if (output.what == Written::table && output.path == "-") continue;
        const fs::path target = behind_links(output.path);
        if (loses_work(target, output.what))
            return refused(" would write over a scene, another file of the lab, or an archive; give another one");
        std::error_code none;
        const bool is_device =
            fs::exists(target, none) && !fs::is_regular_file(target, none) && !fs::is_directory(target, none);
        if (auto fault = replacement_fault(output.path); fault && !(output.may_be_device && is_device)) return fault;
    }
    return std::nullopt;
}

}  // namespace braitenlab
