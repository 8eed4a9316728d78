#include "app/data.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "app/paths.h"
#include "app/platform.h"
#include "core/scene/nearest.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

bool is_there(const fs::path& path) {
    std::error_code none;
    return fs::exists(path, none);
}

std::vector<fs::path> candidate_folders() {
    std::vector<fs::path> folders;
    if (const char* own = std::getenv("BRAITENLAB_DATA")) return {fs::path(own)};
    if (const fs::path program = program_file(); !program.empty())
        folders.push_back(program.parent_path().parent_path() / "share" / "braitenlab");
    std::istringstream list{data_folders};
    for (std::string folder; std::getline(list, folder, ';');) folders.emplace_back(folder);
    return folders;
}

std::vector<fs::path> toml_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none))
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

const char* version_text() { return version; }

Result<fs::path> data_folder() {
    std::string looked;
    for (const fs::path& folder : candidate_folders()) {
        if (is_there(folder / "exercises" / "scenes")) return folder;
        looked += (looked.empty() ? "" : ", ") + folder.string();
    }
    return Error{
        fmt::format("the lab's exercises and shaders are not in {}; set BRAITENLAB_DATA to the folder that holds "
                    "them",
                    looked)};
}

Result<fs::path> find_shipped(const std::string& path_or_name) {
    if (is_there(path_or_name)) return fs::path(path_or_name);
    const auto data = data_folder();
    if (!data) return data.error();
    std::vector<std::string> names;
    for (const char* folder : {"scenes", "guided"})
        for (const fs::path& file : toml_files(*data / "exercises" / folder)) {
            if (file.stem() == path_or_name) return file;
            names.push_back(file.stem().string());
        }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    return Error{fmt::format("there is no file and no shipped scene called '{}'{}", path_or_name,
                             name_nearest(path_or_name, candidates))};
}

std::vector<fs::path> shipped_exercises() {
    const auto data = data_folder();
    return data ? toml_files(*data / "exercises" / "guided") : std::vector<fs::path>{};
}

std::vector<fs::path> shipped_scenes() {
    const auto data = data_folder();
    return data ? toml_files(*data / "exercises" / "scenes") : std::vector<fs::path>{};
}

bool is_exercise(const fs::path& path) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("[[step]]")) return true;
    return false;
}

fs::path first_existing(const std::vector<fs::path>& candidates) {
    const auto found = std::find_if(candidates.begin(), candidates.end(), is_there);
    return found == candidates.end() ? fs::path{} : *found;
}

}  // namespace braitenlab
