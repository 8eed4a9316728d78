#include "app/files/export_folder.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/files/safe_file.h"
#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/folder_entries.h"

namespace braitenlab {

namespace {

namespace fs = std::filesystem;

// True if the file, if there is one, was written by an export: each text names the lab in its first 1,000 bytes.
bool is_exported(const fs::path& path) {
    constexpr std::size_t begin = 1000;
    const auto text = read_text(path);
    return text && std::string_view(*text).substr(0, begin).find("xported from Braitenlab") != std::string_view::npos;
}

// True for a file of an earlier export: it has a name that exports give, and a text names the lab, so that a file of
// the user with such a name stays. Lists of parts, nets and drawings have no such mark.
bool is_of_earlier_export(const fs::path& folder, const std::string& name) {
    constexpr std::array<std::string_view, 9> marked{"README.md",           "brain.h",   "braitenberg/braitenberg.ino",
                                                     "braitenberg/brain.h", "brain.cir", "brain-exact.cir",
                                                     "brain.aesl",          "brain.py",  "main.py"};
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

std::optional<Error> write_export(const fs::path& folder, const std::vector<robots::ExportedFile>& files) {
    if (auto fault = link_fault(folder, files)) return fault;
    std::vector<std::string> earlier;
    if (is_exported(folder / "README.md")) earlier = names_in(folder);
    std::vector<NewFile> written;
    for (const robots::ExportedFile& file : files) written.push_back({folder / file.name, file.text});
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
