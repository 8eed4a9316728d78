// The values stored between two starts, in two TOML files: the user's preferences (settings.toml in the configuration
// folder) and values that the program stores (state.toml in the state folder).
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/evolve/scene_breeding.h"
#include "core/result.h"
#include "render/view/view_settings.h"
#include "ui/panels/prompt_state.h"
#include "ui/request.h"

namespace braitenlab {

// Values outside their range are clamped; unknown keys, as of a later version, are ignored. Keys that are missing keep
// their value in `otherwise`. Fails with file and line on malformed TOML and on values of the wrong type.
Result<Preferences> parse_preferences(std::string_view toml, std::string file_name, const Preferences& otherwise = {});
std::string write_preferences(const Preferences&);

// The upper left corner of the window on the desktop, in screen coordinates, which may be negative.
struct WindowPlace {
    int x = 0, y = 0;
    friend bool operator==(const WindowPlace&, const WindowPlace&) = default;
};

// How the scene was shown last: restored at the next start.
struct StoredView {
    ViewSettings settings;  // of the camera its mode; the file has the flags of visit_kept_flags() and few other values
    std::optional<std::vector<std::string>> folded{};  // anchors of the folded cards; nullopt: first start
    ui::PromptsFollowed followed{};
    std::vector<std::string> strips{};  // names of the signals chosen for the chart, at most most_strips
    evolve::MayChange may_change{};     // in a breeding of the open scene
    friend bool operator==(const StoredView&, const StoredView&) = default;
};

struct StoredState {
    int width = 0, height = 0;       // of the window; 0: never changed
    std::string last_opened;         // a path; empty: first start
    std::vector<RecentFile> recent;  // the newest first
    std::string folder;              // of the file opened or saved last
    StoredView view{};
    std::optional<WindowPlace> place{};  // of the window; nullopt: unknown
    std::string student{};               // file of the student who worked last, see StudentFiles; empty: the first
    std::string study{};                 // StudyRuns::last
    std::string breeding{};              // BreedingRuns::last
    friend bool operator==(const StoredState&, const StoredState&) = default;
};

// Fails as parse_preferences does.
Result<StoredState> parse_state(std::string_view toml, std::string file_name);
std::string write_state(const StoredState&);

inline constexpr std::size_t most_recent = 8;

// Makes the file the last one opened and moves it to the front of the recent files. `title`: of the scene or exercise.
void add_recent(StoredState&, const std::filesystem::path&, std::string title = {});

// The two files of one user: read at the start, written when something has changed.
class SettingsFiles {
public:
    // With an empty folder, its file is neither read nor written.
    SettingsFiles(std::filesystem::path config, std::filesystem::path state);

    // A malformed file is renamed to <name>.broken and reported; its value stays unchanged.
    std::vector<Error> read(Preferences&, StoredState&);

    // Writes what differs from the files. An error is returned once until something changes again.
    std::optional<Error> write(const Preferences&, const StoredState&);

private:
    std::filesystem::path settings_, state_;
    std::string settings_text_, state_text_;  // as in the files
    Preferences start_;                       // as they were after reading
};

// Preferences given on the command line. They apply to this session and are not stored.
struct PreferenceOverrides {
    std::optional<Theme> theme;
    std::string language;  // empty: not given
    bool has_quality = false;
    std::optional<Quality> quality{};  // with has_quality
};

struct Settings {
    SettingsFiles files;
    Preferences stored;    // as in the file
    Preferences at_start;  // stored, with the overrides
    Preferences last;      // at the last call of save()
    std::string native_language;
    StoredState state;
    std::vector<Error> errors;  // of files that could not be read
};

// `native_language` and `native_theme` are used until a preference is stored.
Settings read_settings(SettingsFiles, const PreferenceOverrides&, const std::string& native_language,
                       Theme native_theme = Theme::dark);

// Writes what has changed. Values that come from the overrides alone are not stored.
std::optional<Error> save(Settings&, const Preferences& now, std::pair<int, int> window_size);

// True if a part of the window's upper edge that a person can grab lies on a display. Displays: x, y, width, height.
bool can_be_grabbed(WindowPlace, std::pair<int, int> size, const std::vector<std::array<int, 4>>& displays);

}  // namespace braitenlab
