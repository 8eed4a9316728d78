#include "app/files/data.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "app/files/paths.h"
#include "app/platform/platform.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/lecture.h"
#include "core/messages.h"
#include "core/scene/folder_entries.h"
#include "core/scene/nearest.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_tree.h"
#include "ui/lab_view.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

bool file_exists(const fs::path& path) {
    std::error_code none;
    return fs::exists(path, none);
}

std::vector<fs::path> candidate_folders() {
    std::vector<fs::path> folders;
    std::error_code none;
    if (const char* own = std::getenv("BRAITENLAB_DATA"); own && *own) return {fs::absolute(own, none)};
    if (const fs::path program = program_file(); !program.empty())
        for (const fs::path& beside : {program.parent_path().parent_path(), program.parent_path()})
            folders.push_back(beside / "share" / "braitenlab");
    std::istringstream list{data_folders};
    for (std::string folder; std::getline(list, folder, ';');) folders.emplace_back(folder);
    return folders;
}

std::vector<fs::path> toml_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for_each_entry(folder, [&](const fs::directory_entry& entry) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    });
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<fs::path> shipped_in(const char* folder) {
    const auto data = data_folder();
    return data ? toml_files(*data / "exercises" / folder) : std::vector<fs::path>{};
}

// Of each Shipped: the folder of these files, empty for all, and the message where none has the name.
struct ShippedKind {
    Shipped value;
    std::string_view folder;
    MessageId<1> none;
};
constexpr ShippedKind shipped_kinds[]{{Shipped::any, "", "no_shipped"},
                                      {Shipped::exercise, "guided", "no_shipped_exercise"},
                                      {Shipped::study, "studies", "no_shipped_study"},
                                      {Shipped::breeding, "breeding", "no_shipped_breeding"}};

}  // namespace

const char* version_text() { return version; }

Result<fs::path> data_folder() {
    std::string looked;
    for (const fs::path& folder : candidate_folders()) {
        if (file_exists(folder / "exercises" / "scenes")) return folder;
        looked += (looked.empty() ? "" : ", ") + folder.string();
    }
    return error_of(message_of("no_data", looked));
}

Result<fs::path> find_shipped(const std::string& path_or_name, Shipped wanted) {
    if (file_exists(path_or_name)) return fs::path(path_or_name);
    const auto data = data_folder();
    if (!data) return data.error();
    const auto* kind = std::find_if(std::begin(shipped_kinds), std::end(shipped_kinds),
                                    [&](const ShippedKind& each) { return each.value == wanted; });
    std::vector<std::string> names;
    for (const char* folder : {"scenes", "robots", "guided", "lectures", "studies", "breeding"})
        for (const fs::path& file : toml_files(*data / "exercises" / folder)) {
            if (file.stem() == path_or_name) return file;
            if (kind->folder.empty() || folder == kind->folder) names.push_back(file.stem().string());
        }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    const fs::path given(path_or_name);
    const std::string stem = given.extension() == ".toml" ? given.stem().string() : path_or_name;
    // A list of a hundred names would end before most kinds of files.
    const Message known = kind->folder.empty() && !candidates.empty()
                              ? message_of("nearest", in_quotes(nearest_word(stem, candidates)))
                              : nearest_of(stem, candidates);
    return error_of(message_of(kind->none, path_or_name) + known);
}

Result<fs::path> scene_beside(const fs::path& file, const std::string& scene) {
    const fs::path beside = file.parent_path() / scene;
    std::error_code none;
    return fs::is_regular_file(beside, none) ? beside : find_shipped(scene);
}

Result<fs::path> scene_at_key(const fs::path& file, std::string_view toml, const std::string& scene) {
    auto found = scene_beside(file, scene);
    if (found) return found;
    Error error = found.error();
    const auto parsed = parse_toml(toml, file.string());
    const TomlNode* key = parsed ? parsed->root.get("scene") : nullptr;
    if (error.file.empty() && key) error.file = file.string(), error.line = static_cast<int>(key->place.line);
    return error;
}

std::vector<const TomlNode*> named_files(const TomlNode& root) {
    std::vector<const TomlNode*> tables{&root}, named;
    if (const TomlNode* pages = root.get("page"); pages && pages->as_list())
        for (const TomlNode& page : *pages->as_list()) tables.push_back(&page);
    for (const TomlNode* table : tables)
        for (const char* key : {"scene", "exercise"})
            if (const TomlNode* value = table->get(key); value && value->as_text()) named.push_back(value);
    return named;
}

std::vector<fs::path> shipped_exercises() { return shipped_in("guided"); }
std::vector<fs::path> shipped_scenes() { return shipped_in("scenes"); }
std::vector<fs::path> shipped_robots() { return shipped_in("robots"); }
std::vector<fs::path> shipped_lectures() { return shipped_in("lectures"); }
std::vector<fs::path> shipped_studies() { return shipped_in("studies"); }
std::vector<fs::path> shipped_breedings() { return shipped_in("breeding"); }

bool ships(const fs::path& path) {
    const auto data = data_folder();
    if (!data) return false;
    std::error_code problem;
    const fs::path inside = fs::relative(path, *data / "exercises", problem);
    return !problem && !inside.empty() && *inside.begin() != "..";
}

Result<Lecture> read_lecture(const fs::path& path) {
    const auto data = data_folder();
    if (!data) return data.error();
    return load_lecture(path, *data / "exercises");
}

std::vector<CatalogueEntry> read_lecture_catalogue() {
    std::vector<CatalogueEntry> catalogue;
    for (const fs::path& path : shipped_lectures())
        if (const auto lecture = read_lecture(path))
            catalogue.push_back({path.stem().string(), path.string(), lecture->title, ""});
    return catalogue;
}

std::vector<CatalogueEntry> read_catalogue() {
    std::vector<CatalogueEntry> catalogue;
    for (const fs::path& path : shipped_exercises())
        if (const auto exercise = load_exercise(path))
            catalogue.push_back({path.stem().string(), path.string(), exercise->title, "", exercise->number,
                                 exercise->chapter, std::make_shared<const Exercise>(*exercise)});
    for (const std::vector<fs::path>& scenes : {shipped_scenes(), shipped_robots()})
        for (const fs::path& path : scenes)
            if (const auto scene = load_scene(path))
                catalogue.push_back({path.stem().string(), path.string(), scene->title, scene->story});
    return catalogue;
}

fs::path first_existing(const std::vector<fs::path>& candidates) {
    const auto found = std::find_if(candidates.begin(), candidates.end(), file_exists);
    return found == candidates.end() ? fs::path{} : *found;
}

std::vector<std::string> files_by_turns(const std::vector<CatalogueEntry>& catalogue) {
    std::vector<std::string> exercises, scenes, all;
    for (const CatalogueEntry& entry : catalogue) (entry.number > 0 ? exercises : scenes).push_back(entry.path);
    for (std::size_t i = 0; i < std::max(exercises.size(), scenes.size()); ++i)
        for (const auto* list : {&exercises, &scenes})
            if (i < list->size()) all.push_back((*list)[i]);
    return all;
}

}  // namespace braitenlab
