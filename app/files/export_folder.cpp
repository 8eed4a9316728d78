#include "app/files/export_folder.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "app/files/safe_file.h"
#include "core/maths/fnv.h"
#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/folder_entries.h"

namespace braitenlab {

namespace {

namespace fs = std::filesystem;

// True for a text of an export: each names the lab in its first 1,000 bytes.
bool names_lab(std::string_view text) {
    constexpr std::size_t begin = 1000;
    return text.substr(0, begin).find("xported from Braitenlab") != std::string_view::npos;
}

// True if the file, if there is one, was written by an export.
bool is_exported(const fs::path& path) {
    const auto text = read_text(path);
    return text && names_lab(*text);
}

// The last lines of a README, a comment that no page shows: the hash of each file as it was exported.
constexpr std::string_view hashes_begin =
                               "\n<!-- Hashes of these files as exported, by which the lab finds edited ones:\n",
                           hashes_end = "-->\n";
constexpr std::string_view export_readme = "README.md";

std::string hashes_of(const std::vector<robots::ExportedFile>& files) {
    std::string text(hashes_begin);
    for (const robots::ExportedFile& file : files)
        text += fmt::format("{:016x} {}\n", maths::fnv(file.text), file.name);
    return text += hashes_end;
}

// Hashes by name of what the export in the folder wrote, and the README without this list.
struct EarlierExport {
    std::map<std::string, std::string> hashes;
    std::string readme_text;
};
EarlierExport export_in(const fs::path& folder) {
    EarlierExport written;
    const auto text = read_text(folder / export_readme);
    if (!text) return written;
    const std::size_t at = text->rfind(hashes_begin);
    const std::size_t end = at == text->npos ? at : text->find(hashes_end, at);
    written.readme_text = end == text->npos ? *text : text->substr(0, at) + text->substr(end + hashes_end.size());
    if (end == text->npos) return written;
    std::istringstream lines(text->substr(at + hashes_begin.size(), end - at - hashes_begin.size()));
    for (std::string hash, name; lines >> hash && std::getline(lines >> std::ws, name);) written.hashes[name] = hash;
    return written;
}

// True for a file of an earlier export: it has a name that exports give, and a text names the lab, so that a file of
// the user with such a name stays. Lists of parts, nets and drawings have no such mark.
bool is_of_earlier_export(const fs::path& folder, const std::string& name) {
    constexpr std::array<std::string_view, 10> marked{"README.md",           "brain.h",   "braitenberg/braitenberg.ino",
                                                      "braitenberg/brain.h", "brain.cir", "brain-exact.cir",
                                                      "brain.aesl",          "brain.py",  "main.py",
                                                      "calibrate.py"};
    if (std::find(marked.begin(), marked.end(), name) != marked.end()) return is_exported(folder / name);
    return name == "parts.csv" || name == "brain.net" || name == "robot.svg" || name == "wiring.svg" ||
           (name.starts_with("wiring-") && name.ends_with(".svg"));
}

// Names of the files of the folder and of its folder for a sketch.
std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code none;
    for (const std::string below : {"", "braitenberg/"})
        for_each_entry(folder / below, [&](const fs::directory_entry& entry) {
            if (entry.is_regular_file(none)) names.push_back(below + entry.path().filename().string());
        });
    return names;
}

// The error if one of these files, or the folder of a sketch, is a link: writing would change what it leads to.
std::optional<Error> link_fault(const fs::path& folder, const std::vector<robots::ExportedFile>& files) {
    std::vector<fs::path> paths{folder / "braitenberg"};
    for (const robots::ExportedFile& file : files) paths.push_back(folder / file.name);
    std::error_code none;
    for (const fs::path& path : paths)
        if (fs::is_symlink(fs::symlink_status(path, none)))
            return error_of(message_of("export_to_link"), path.string());
    return std::nullopt;
}

}  // namespace

std::optional<Error> export_folder_fault(const fs::path& folder) {
    bool is_empty = true, has_export = false;
    for_each_entry(folder, [&](const fs::directory_entry& entry) {
        std::error_code none;
        is_empty = false;
        has_export |= entry.is_regular_file(none) && is_exported(entry.path());
    });
    if (is_empty || has_export) return std::nullopt;
    return error_of(message_of("foreign_folder"), folder.string());
}

std::vector<std::string> edited_files(const fs::path& folder, const std::vector<robots::ExportedFile>& files) {
    const EarlierExport written = export_in(folder);
    std::vector<std::string> edited;
    for (const std::string& name : names_in(folder)) {
        const auto file = std::find_if(files.begin(), files.end(), [&](const auto& each) { return each.name == name; });
        const auto known = written.hashes.find(name);
        const bool is_removed = known != written.hashes.end() && is_of_earlier_export(folder, name);
        if (file == files.end() && !is_removed) continue;
        const auto text = name == export_readme ? Result<std::string>(written.readme_text) : read_text(folder / name);
        if (text && file != files.end() && *text == file->text) continue;
        const bool is_as_written =
            text && known != written.hashes.end() && known->second == fmt::format("{:016x}", maths::fnv(*text));
        if (!is_as_written) edited.push_back(name);
    }
    return edited;
}

std::optional<Error> write_export(const fs::path& folder, const std::vector<robots::ExportedFile>& files) {
    if (auto fault = link_fault(folder, files)) return fault;
    std::vector<std::string> earlier;
    if (is_exported(folder / export_readme)) earlier = names_in(folder);
    std::vector<NewFile> written;
    std::string with_hashes;
    for (const robots::ExportedFile& file : files) {
        const bool has_list = file.name == export_readme && names_lab(file.text);
        if (has_list) with_hashes = file.text + hashes_of(files);
        written.push_back({folder / file.name, has_list ? with_hashes : file.text});
    }
    if (auto error = write_all(written)) return error;
    std::error_code none;
    for (const std::string& name : earlier)
        if (std::none_of(files.begin(), files.end(), [&](const auto& file) { return file.name == name; }) &&
            is_of_earlier_export(folder, name))
            fs::remove(folder / name, none);
    const fs::path sketch = folder / "braitenberg";
    if (!earlier.empty() && fs::is_directory(sketch, none)) fs::remove(sketch, none);  // only where it is empty
    return std::nullopt;
}

}  // namespace braitenlab
