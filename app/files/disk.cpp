#include "app/files/disk.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/files/safe_file.h"
#include "app/platform/platform.h"
#include "core/evolve/breeding_file.h"
#include "core/insight/study_file.h"
#include "core/io/run_file.h"
#include "core/lesson/exercise_file.h"
#include "core/maths/fnv.h"
#include "core/messages.h"
#include "core/scene/comments.h"
#include "core/scene/nearest.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_tree.h"
#include "core/text_parts.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_entries = 2000;
constexpr std::uintmax_t most_to_parse = 1u << 20;  // bytes of a file
constexpr std::size_t head_size = 1u << 16;         // bytes of a file that is not parsed
constexpr double time_to_parse = 0.05;              // s for the files of a folder

// True if a TOML file can be parsed as its kind.
bool parses(const FileText& file) {
    switch (file.kind) {
        case FileKind::brain:
            return static_cast<bool>(parse_brain(file.text, file.path.string()));
        case FileKind::exercise:
            return static_cast<bool>(parse_exercise(file.text, file.path));
        case FileKind::lecture:
            return static_cast<bool>(read_lecture(file.path));
        case FileKind::study:
            return static_cast<bool>(insight::parse_study(file.text, file.path.string()));
        case FileKind::breeding:
            return static_cast<bool>(evolve::parse_breeding(file.text, file.path.string()));
        case FileKind::run:
            return static_cast<bool>(io::load_run(file.path));
        case FileKind::scene:
            break;
    }
    return static_cast<bool>(parse_scene(file.text, file.path.string()));
}

// True for well-formed TOML, of any program.
bool is_toml(const FileText& file) { return static_cast<bool>(parse_toml(file.text, file.path.string())); }

bool any_line(const std::string& text, const auto& holds) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (holds(line)) return true;
    return false;
}

// Every file of this program has a line "format = 1".
bool has_format_line(const std::string& text) {
    return any_line(text, [](const std::string& line) { return line.starts_with("format"); });
}

bool has_comments(const std::string& text) {
    return any_line(text, [](const std::string& line) { return trimmed(line).starts_with('#'); });
}

// True for the folders of what the lab stores by itself, which the user of a page does not have as files.
bool is_of_page(const fs::path& path) {
    if (!saves_by_download()) return false;
    const UserFolders own = user_folders();
    return path == own.config || path == own.state;
}

// The first bytes of a file and the kind by them.
Result<FileText> read_head(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string head(head_size, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (!in && !in.eof()) return error_of(message_of("unreadable"), path.string());
    head.resize(static_cast<std::size_t>(in.gcount()));
    const FileKind kind = detect_kind(path, head);
    return FileText{path, kind, std::move(head), {}};
}

// `may_parse`: to find broken files. Else files count as sound until they are opened, and only their heads are read.
std::optional<FileEntry> entry_of(const fs::directory_entry& found, bool may_parse) {
    FileEntry entry{found.path().filename().string()};
    if (entry.name.empty() || entry.name[0] == '.' || is_of_page(found.path())) return std::nullopt;
    std::error_code problem;
    entry.is_folder = found.is_directory(problem);
    if (entry.is_folder) return entry;
    const auto extension = found.path().extension();
    if ((extension != ".toml" && extension != io::run_ending) || !found.is_regular_file(problem)) return std::nullopt;
    const std::uintmax_t size = found.file_size(problem);
    if (problem) return std::nullopt;
    const bool parse = may_parse && size <= most_to_parse;
    const auto file = parse ? read_file(found.path()) : read_head(found.path());
    if (!file) {
        entry.broken = true;
        return size <= most_to_parse ? std::optional(entry) : std::nullopt;
    }
    const bool ours = file->kind == FileKind::run || has_format_line(file->text);
    if (!ours && (!parse || is_toml(*file))) return std::nullopt;
    entry.broken = !ours || (parse && !parses(*file));
    entry.kind = ours ? file->kind : FileKind::scene;
    entry.comments = has_comments(file->text);
    return entry;
}

bool leaves_folder(const fs::path& folder, const std::string& named) {
    const fs::path path = fs::path(named).lexically_normal();
    const bool leaves = path.has_root_path() || (!path.empty() && *path.begin() == "..");
    return leaves && !ships((folder / path).lexically_normal());
}

// The scene's text with the comments of the file that the document was opened from, if it can be read afterwards.
std::string with_comments_of(const Document& document, std::string text, const fs::path& path) {
    if (document.lesson || document.path.empty()) return text;
    const auto old = read_file(document.path);
    if (!old || old->kind != FileKind::scene || !has_comments(old->text)) return text;
    std::string commented = with_comments(text, old->text);
    const auto plain = parse_scene(text, path.string()), read = parse_scene(commented, path.string());
    return plain && read && *plain == *read ? commented : text;
}

}  // namespace

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
    const double until = thread_time() + time_to_parse;
    for (; entries != fs::directory_iterator() && listing.entries.size() < most_entries; entries.increment(problem)) {
        if (problem) break;
        if (auto entry = entry_of(*entries, thread_time() < until)) listing.entries.push_back(std::move(*entry));
    }
    std::sort(listing.entries.begin(), listing.entries.end(), [](const FileEntry& a, const FileEntry& b) {
        return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
    });
    return listing;
}

std::optional<Error> fault_of_dropped(const FileText& file) {
    const bool names_files = file.kind == FileKind::exercise || file.kind == FileKind::lecture ||
                             file.kind == FileKind::study || file.kind == FileKind::breeding;
    if (!names_files) return std::nullopt;
    const auto toml = parse_toml(file.text, file.path.string());
    if (!toml) return std::nullopt;  // opening it reports the error
    for (const TomlNode* named : named_files(toml->root))
        if (leaves_folder(file.path.parent_path(), *named->as_text()))
            return error_of(message_of("leaves_folder", in_quotes(*named->as_text())), file.path.string(),
                            static_cast<int>(named->place.line));
    return std::nullopt;
}

fs::path resolved(const std::string& typed, const fs::path& folder, const fs::path& home) {
    if (typed == "~" || typed.starts_with("~/"))
        return (home / typed.substr(typed.size() > 1 ? 2 : 1)).lexically_normal();
    return (folder / typed).lexically_normal();
}

fs::path with_extension(fs::path path, FileKind kind) {
    const char* extension = kind == FileKind::run ? ".run" : ".toml";
    if (path.extension() != extension) path += extension;
    return path;
}

fs::path own_file(const Document& document) {
    if (document.path.empty() || document.lesson || ships(document.path)) return {};
    const auto file = read_file(document.path);
    const bool is_scene = file && file->kind == FileKind::scene && has_format_line(file->text);
    return is_scene ? document.path : fs::path{};
}

Result<std::uint64_t> save_as(const Workspace& space, const fs::path& path, FileKind kind) {
    const auto write = [&](const std::string& text) -> Result<std::uint64_t> {
        if (auto error = write_whole(path, text)) return *error;
        return maths::fnv(text);
    };
    if (kind == FileKind::scene) {
        Scene scene = scene_to_keep(space.document);
        if (auto error = check_scene(scene)) return *error;  // a file that cannot be opened is not written
        if (space.document.is_scene_named_by_file) scene.name.clear();
        return write(with_comments_of(space.document, write_scene(scene), path));
    }
    if (kind == FileKind::run) return write(io::write_run(run_to_keep(space.document)));
    if (kind != FileKind::brain) return error_of(message_of("not_savable"), path.string());
    const Snapshot& now = space.document.session.snapshot();
    const VehicleView* vehicle = find_vehicle(now, space.view.selection.vehicle);
    if (!vehicle) return error_of(message_of("no_brain_to_save"));
    return write(write_brain(*brain_of(now, *vehicle)));
}

std::optional<Error> take_brain(Workspace& space, const FileText& file) {
    Session& session = space.document.session;
    const VehicleView* vehicle = find_vehicle(session.snapshot(), space.view.selection.vehicle);
    if (!vehicle) return error_of(message_of("no_vehicle_for_brain"), file.path.string());
    auto brain = parse_brain(file.text, file.path.string());
    if (!brain) return brain.error();
    auto error = session.apply(SetBrain{target_of(space.view.selection, *vehicle), std::move(*brain)});
    if (!error) ++space.document.edits;
    return error;
}

}  // namespace braitenlab
