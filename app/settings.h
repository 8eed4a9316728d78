// What is remembered between starts, in two small TOML files: what a person chose (settings.toml in the configuration
// folder) and what the lab keeps by itself (state.toml in the state folder).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "ui/preferences.h"

namespace braitenlab {

// Values out of their range come back as the nearest one in it; what a later version wrote beside them is passed over.
// Fails with file and line on bad TOML and on values of the wrong type.
Result<Preferences> parse_preferences(std::string_view toml, std::string file_name, const Preferences& otherwise = {});
std::string write_preferences(const Preferences&);

struct Remembered {
    int width = 0, height = 0;        // of the window; 0: never changed
    std::string last_opened;          // a path; empty: the very first start
    std::vector<std::string> recent;  // paths, the newest first
    std::string folder;               // where the last file was opened or saved
    friend bool operator==(const Remembered&, const Remembered&) = default;
};

Result<Remembered> parse_remembered(std::string_view toml, std::string file_name);
std::string write_remembered(const Remembered&);

inline constexpr std::size_t most_recent = 8;

// The file comes to the front of the recent ones.
void remember_opened(Remembered&, const std::filesystem::path&);

// The two files of one person, read at the start and written when something has changed.
class SettingsFiles {
public:
    // Empty folders: nothing is read and nothing written.
    SettingsFiles(std::filesystem::path config, std::filesystem::path state);

    // A file that cannot be understood is renamed to <name>.broken and answered by an error; what it should have held
    // stays as it is.
    std::vector<Error> read(Preferences&, Remembered&);

    // Writes what differs from what was read or written last. An error is told once until something changes again.
    std::optional<Error> write(const Preferences&, const Remembered&);

private:
    std::filesystem::path settings_, state_;
    std::string settings_text_, state_text_;  // as on the disk
    Preferences start_;                       // where nothing has been chosen yet
};

}  // namespace braitenlab
