#include "app/ctl/class_files.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "core/scene/file_kind.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

enum class Place { graded, left_out, folder, unmentioned };

// `file`: relative to the argument.
Place place_of(const fs::path& file, bool is_folder) {
    constexpr std::array<std::string_view, 3> of_systems{"__MACOSX", "Thumbs.db", "desktop.ini"};
    for (const fs::path& part : file) {
        const std::string name = part.string();
        const bool is_hidden = name.starts_with(".") && name != ".." && name != ".";
        if (is_hidden || std::find(of_systems.begin(), of_systems.end(), name) != of_systems.end())
            return Place::unmentioned;
    }
    if (is_folder) return Place::folder;
    const fs::path ending = file.extension();
    return ending == ".csv" || ending == ".html" ? Place::left_out : Place::graded;
}

struct FoundFile {
    ClassFile file;
    Place place;
};

std::vector<FoundFile> in_folder(const fs::path& folder) {
    std::vector<FoundFile> found;
    std::error_code problem;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, problem);
    for (; !problem && entry != fs::recursive_directory_iterator(); entry.increment(problem)) {
        const fs::path relative = entry->path().lexically_relative(folder);
        std::error_code none;
        const bool is_folder = entry->is_directory(none);
        Place place = place_of(relative, is_folder);
        const bool is_neither = place == Place::graded && !entry->is_regular_file(none);
        const bool is_linked_folder = place == Place::folder && entry->is_symlink(none);  // it may lead back here
        if (is_neither || is_linked_folder) place = Place::left_out;
        found.push_back({{.file = relative.generic_string(), .path = entry->path()}, place});
    }
    return found;
}

Result<std::vector<FoundFile>> in_archive(const fs::path& path) {
    auto opened = Archive::open(path);
    if (!opened) return opened.error();
    const auto archive = std::make_shared<Archive>(std::move(*opened));
    std::vector<FoundFile> found;
    for (std::size_t i = 0; i < archive->entries().size(); ++i) {
        const Archive::Entry& entry = archive->entries()[i];
        found.push_back({{.file = entry.path, .archive = archive, .entry = i}, place_of(entry.path, entry.is_folder)});
    }
    return found;
}

// The files, and the folders without one.
std::vector<std::string> paths_of(const std::vector<FoundFile>& found) {
    std::vector<std::string> paths;
    std::set<std::string> parents;
    for (const FoundFile& each : found) {
        if (each.place != Place::graded && each.place != Place::left_out) continue;
        paths.push_back(each.file.file);
        for (fs::path parent = fs::path(each.file.file).parent_path(); parent.has_relative_path();
             parent = parent.parent_path())
            parents.insert(parent.generic_string());
    }
    for (const FoundFile& each : found)
        if (each.place == Place::folder && !parents.contains(each.file.file)) paths.push_back(each.file.file + "/");
    return paths;
}

// A person, or the folder of unknown people.
std::pair<std::string, std::string> owner_of(const Submitter& submitter) {
    return {submitter.person.empty() ? submitter.folder : std::string(), submitter.person};
}

// The folders of people whose only files are those of systems; an archive may have no entries of folders.
void add_folders_around_unmentioned(std::vector<FoundFile>& found) {
    std::set<std::string> folders;
    for (const FoundFile& each : found) {
        if (each.place != Place::unmentioned) continue;
        fs::path folder = fs::path(each.file.file).parent_path();
        while (folder.has_relative_path() && place_of(folder, true) == Place::unmentioned)
            folder = folder.parent_path();
        if (folder.has_relative_path()) folders.insert(folder.generic_string());
    }
    for (const FoundFile& each : found)
        if (each.place == Place::folder) folders.erase(each.file.file);
    for (const std::string& folder : folders) found.push_back({{.file = folder}, Place::folder});
}

// Adds the files of one argument to `all`. `prefix`: what distinguishes it from other arguments.
void add_files(std::vector<FoundFile> found, const std::string& prefix, ClassFiles& all) {
    add_folders_around_unmentioned(found);
    std::sort(found.begin(), found.end(),
              [](const FoundFile& a, const FoundFile& b) { return a.file.file < b.file.file; });
    const std::size_t around = folders_around(paths_of(found));
    const auto of_argument = owner_of({.folder = prefix});
    std::set<std::pair<std::string, std::string>> with_files{of_argument};
    std::vector<ClassFile> others;  // folders, and what is left out in one
    for (FoundFile& each : found) {
        ClassFile& file = each.file;
        if (each.place == Place::unmentioned) continue;
        const std::string path = file.file + (each.place == Place::folder ? "/" : "");
        file.submitter = submitter_of(path.size() > around ? path.substr(around) : std::string());
        if (!prefix.empty()) {
            file.file = prefix + "/" + file.file;
            file.submitter.folder = prefix + (file.submitter.folder.empty() ? "" : "/") + file.submitter.folder;
        }
        if (each.place == Place::left_out) all.left_out.push_back(file.file);
        if (each.place != Place::graded) {
            others.push_back(std::move(file));
            continue;
        }
        with_files.insert(owner_of(file.submitter));
        all.files.push_back(std::move(file));
    }
    for (ClassFile& other : others)
        if (with_files.insert(owner_of(other.submitter)).second) all.empty.push_back(std::move(other));
}

}  // namespace

Result<ClassFiles> class_files(const std::vector<std::string>& arguments) {
    std::error_code none;
    const auto is_container = [&](const std::string& argument) {
        return fs::is_directory(argument, none) || is_zip_file(argument);
    };
    const bool is_one = std::count_if(arguments.begin(), arguments.end(), is_container) < 2;
    ClassFiles all;
    std::vector<FoundFile> single;
    for (const std::string& argument : arguments) {
        const fs::path path(argument);
        if (!is_container(argument)) {
            single.push_back({{.file = path.generic_string(), .path = path}, Place::graded});
            continue;
        }
        auto found = fs::is_directory(path, none) ? in_folder(path) : in_archive(path);
        if (!found) return found.error();
        const fs::path name = path.has_filename() ? path.filename() : path.parent_path().filename();
        add_files(std::move(*found), is_one ? std::string() : name.string(), all);
    }
    add_files(std::move(single), "", all);
    return all;
}

Result<std::string> text_of(const ClassFile& file) {
    return file.archive ? file.archive->read(file.entry) : read_text(file.path);
}

}  // namespace braitenlab
