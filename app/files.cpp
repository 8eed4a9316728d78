#include "app/files.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>

#include <toml++/toml.h>

#include "app/data.h"
#include "app/platform.h"
#include "app/safe_file.h"
#include "core/io/run_file.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_entries = 2000;
constexpr std::uintmax_t largest = 8u << 20;                                 // bytes; no scene is longer
constexpr std::uintmax_t worth_reading = 1u << 20, reads_in_all = 4u << 20;  // bytes, to see whether a file is broken

// The lines of a file that could be ours; none for anything else, pipes and devices above all.
std::vector<std::string> lines_of(const fs::path& path) {
    std::error_code problem;
    std::vector<std::string> lines;
    if (!fs::is_regular_file(path, problem) || fs::file_size(path, problem) > largest || problem) return lines;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) lines.push_back(std::move(line));
    return lines;
}

// Whether the lab can open it, asked by opening it.
bool is_broken(const fs::path& path, FileKind kind) {
    switch (kind) {
        case FileKind::brain:
            return !load_brain(path);
        case FileKind::exercise:
            return !load_exercise(path);
        case FileKind::run:
            return !io::load_run(path);
        default:
            return !load_scene(path);
    }
}

// Of another program's, perhaps: well-formed all the same.
bool is_toml(const fs::path& path) {
    try {
        static_cast<void>(toml::parse_file(path.string()));
        return true;
    } catch (const toml::parse_error&) {
        return false;
    }
}

bool any_begins(const std::vector<std::string>& lines, std::string_view with) {
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) { return line.starts_with(with); });
}

std::optional<FileKind> kind_of(const fs::path& path, const std::vector<std::string>& lines) {
    if (path.extension() == ".run") return FileKind::run;
    if (path.extension() != ".toml" || !any_begins(lines, "format")) return std::nullopt;
    if (any_begins(lines, "[[step]]")) return FileKind::exercise;
    if (any_begins(lines, "[kind.") || any_begins(lines, "[arena]") || any_begins(lines, "[source."))
        return FileKind::scene;
    return any_begins(lines, "[brain") ? FileKind::brain : FileKind::scene;
}

bool holds_comments(const std::vector<std::string>& lines) {
    return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
        const auto first = line.find_first_not_of(" \t");
        return first != line.npos && line[first] == '#';
    });
}

// `budget`: bytes that may still be read to see what is broken; beyond, a file is taken to be whole until it is opened.
std::optional<FileEntry> entry_of(const fs::directory_entry& found, std::uintmax_t& budget) {
    FileEntry entry{found.path().filename().string()};
    if (entry.name.empty() || entry.name[0] == '.') return std::nullopt;
    std::error_code problem;
    entry.is_folder = found.is_directory(problem);
    if (entry.is_folder) return entry;
    const auto ending = found.path().extension();
    if ((ending != ".toml" && ending != io::run_ending) || !found.is_regular_file(problem)) return std::nullopt;
    const auto lines = ending == ".toml" ? lines_of(found.path()) : std::vector<std::string>{};
    const auto kind = kind_of(found.path(), lines);
    const std::uintmax_t size = found.file_size(problem);
    if (problem) return std::nullopt;
    const bool read = size <= std::min(worth_reading, budget);
    if (!kind && (!read || is_toml(found.path()))) return std::nullopt;
    entry.broken = !kind || (read && is_broken(found.path(), *kind));
    if (read) budget -= size;
    entry.kind = kind.value_or(FileKind::scene);
    entry.comments = holds_comments(lines);
    return entry;
}

}  // namespace

std::optional<FileKind> kind_of_file(const fs::path& path) { return kind_of(path, lines_of(path)); }

FolderListing list_folder(const fs::path& wanted) {
    FolderListing listing;
    std::error_code problem;
    fs::path folder = fs::absolute(wanted, problem).lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();  // "/home/" as "/home"
    listing.folder = folder.string();
    fs::directory_iterator entries(folder, fs::directory_options::skip_permission_denied, problem);
    if (problem) {
        listing.problem = problem.message();
        return listing;
    }
    std::uintmax_t budget = reads_in_all;
    for (; entries != fs::directory_iterator() && listing.entries.size() < most_entries; entries.increment(problem)) {
        if (problem) break;
        if (auto entry = entry_of(*entries, budget)) listing.entries.push_back(std::move(*entry));
    }
    std::sort(listing.entries.begin(), listing.entries.end(), [](const FileEntry& a, const FileEntry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
    return listing;
}

bool ships(const fs::path& path) {
    const auto data = data_folder();
    if (!data) return false;
    std::error_code problem;
    const fs::path inside = fs::relative(path, *data / "exercises", problem);
    return !problem && !inside.empty() && *inside.begin() != "..";
}

fs::path resolved(const std::string& typed, const fs::path& folder) {
    if (typed == "~" || typed.starts_with("~/"))
        return (home_folder() / typed.substr(typed.size() > 1 ? 2 : 1)).lexically_normal();
    return (folder / typed).lexically_normal();
}

fs::path with_ending(fs::path path, FileKind kind) {
    const char* ending = kind == FileKind::run ? ".run" : ".toml";
    if (path.extension() != ending) path += ending;
    return path;
}

fs::path own_file(const Lab& lab) {
    if (lab.document.path.empty() || lab.document.lesson || ships(lab.document.path)) return {};
    const auto lines = lines_of(lab.document.path);
    return kind_of(lab.document.path, lines) == FileKind::scene && !holds_comments(lines) ? lab.document.path
                                                                                          : fs::path{};
}

std::optional<Error> save_as(const Lab& lab, const fs::path& path, FileKind kind) {
    if (kind == FileKind::scene) return write_whole(path, write_scene(lab.document.session.edited_scene()));
    if (kind == FileKind::run) return write_whole(path, io::write_run(lab.document.session.save()));
    if (kind != FileKind::brain) return Error{"can be saved as a scene, a run or a brain only", path.string()};
    const Snapshot& now = lab.document.session.snapshot();
    const VehicleView* vehicle = find_vehicle(now, lab.view.selection.vehicle);
    if (!vehicle) return Error{"no vehicle is selected; click the one whose brain is meant"};
    return write_whole(path, write_brain(*now.brains[static_cast<std::size_t>(vehicle->brain)]));
}

std::optional<Error> take_brain(Lab& lab, const fs::path& path) {
    const VehicleView* vehicle = find_vehicle(lab.document.session.snapshot(), lab.view.selection.vehicle);
    if (!vehicle) return Error{"no vehicle is selected; click the one that is to have this brain", path.string()};
    auto brain = load_brain(path);
    if (!brain) return brain.error();
    const Target target =
        lab.view.selection.whole_kind ? Target{.kind = vehicle->kind} : Target{.vehicle = vehicle->id};
    const auto error = lab.document.session.apply(SetBrain{target, std::move(*brain)});
    if (!error) ++lab.document.edits;
    return error;
}

}  // namespace braitenlab
