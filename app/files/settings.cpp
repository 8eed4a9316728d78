#include "app/files/settings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <tuple>

#include <fmt/format.h>

#include "app/files/safe_file.h"
#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/toml_tree.h"
#include "core/scene/toml_writer.h"
#include "core/utf8.h"
#include "ui/panels/charts/chart_data.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

template <class T>
std::optional<T> optional_of(const T* value) {
    return value ? std::optional<T>(*value) : std::nullopt;
}

std::optional<int> whole_of(const TomlNode& node) {
    const std::int64_t* whole = node.as_whole();
    return whole && std::in_range<int>(*whole) ? std::optional(static_cast<int>(*whole)) : std::nullopt;
}

std::optional<RecentFile> recent_file(const TomlNode& node) {
    const auto text = [&](const char* key) {
        const TomlNode* value = node.get(key);
        return value ? value->as_text() : nullptr;
    };
    const std::string *path = text("path"), *title = text("title");
    if (!path) return std::nullopt;
    return RecentFile{*path, title ? *title : std::string()};
}

// Reads the values of a file. A missing value stays as it is, and so does one whose word is unknown; a value beyond its
// range is the nearest one in it. `error`: the first value of the wrong type.
struct SettingsReader {
    const TomlFile& file;
    std::optional<Error> error{};

    void flag(const char* key, bool& value) {
        take(
            key, "true_or_false", [&](const TomlNode& node) { return optional_of(node.as_flag()); }, value);
    }
    void whole(const char* key, int& value) { take(key, "a_whole_number", whole_of, value); }
    void number(const char* key, float& value, float least, float largest) {
        float read = value;
        take(
            key, "a_number", [](const TomlNode& node) { return node.as_number(); }, read);
        if (!std::isnan(read)) value = std::clamp(read, least, largest);
    }
    void text(const char* key, std::string& value) {
        take(
            key, "text_in_quotes", [](const TomlNode& node) { return optional_of(node.as_text()); }, value);
    }
    template <std::size_t n, class Enum>
    void word(const char* key, const std::array<std::string_view, n>& words, Enum& value) {
        std::optional<Enum> read = value;
        word(key, words, read);
        value = read.value_or(value);
    }
    template <std::size_t n, class Enum>
    void word(const char* key, const std::array<std::string_view, n>& words, std::optional<Enum>& value) {
        std::string read;
        text(key, read);
        if (read == automatic) value.reset();
        for (std::size_t i = 0; i < n; ++i)
            if (words[i] == read) value = static_cast<Enum>(i);
    }
    void texts(const char* key, std::optional<std::vector<std::string>>& values) {
        texts(key, values.emplace());
        if (!file.root.contains(key)) values.reset();
    }
    void texts(const char* key, std::vector<std::string>& values) {
        elements(key, values, [](const TomlNode& node) { return optional_of(node.as_text()); });
    }
    void files(const char* key, std::vector<RecentFile>& values) { elements(key, values, recent_file); }

    static constexpr std::string_view automatic = "auto";

private:
    template <class T, class Convert>
    void take(const char* key, MessageId<0> wanted, const Convert& convert, T& value) {
        const TomlNode* node = file.root.get(key);
        if (!node) return;
        if (const auto found = convert(*node))
            value = static_cast<T>(*found);
        else if (!error)
            error = error_of(message_of("type_wanted", key) + message_of(wanted), file.name,
                             static_cast<int>(node->place.line));
    }
    // Those of a list that can be read.
    template <class T, class Convert>
    void elements(const char* key, std::vector<T>& values, const Convert& convert) {
        const TomlNode* node = file.root.get(key);
        const TomlNode::List* list = node ? node->as_list() : nullptr;
        if (!list) return;
        for (const TomlNode& element : *list)
            if (auto value = convert(element)) values.push_back(std::move(*value));
    }
};

// Writes the values, one a line. Empty texts and lists are left out.
struct SettingsWriter {
    std::string lines;

    explicit SettingsWriter(const char* about) : lines(fmt::format("# {}\nformat = 1\n", about)) {}

    void flag(const char* key, bool value) { line(key, value ? "true" : "false"); }
    void whole(const char* key, int value) { line(key, fmt::format("{}", value)); }
    void number(const char* key, float value, float, float) { line(key, toml_text::number(value)); }
    void text(const char* key, std::string_view value) {
        if (!value.empty()) line(key, quoted(value));
    }
    template <std::size_t n, class Enum>
    void word(const char* key, const std::array<std::string_view, n>& words, Enum value) {
        word(key, words, std::optional(value));
    }
    template <std::size_t n, class Enum>
    void word(const char* key, const std::array<std::string_view, n>& words, std::optional<Enum> value) {
        text(key, value ? words[static_cast<std::size_t>(*value)] : SettingsReader::automatic);
    }
    void texts(const char* key, const std::optional<std::vector<std::string>>& values) {
        if (values) list(key, *values, quoted);
    }
    void texts(const char* key, const std::vector<std::string>& values) {
        if (!values.empty()) list(key, values, quoted);
    }
    void files(const char* key, const std::vector<RecentFile>& values) {
        list(key, values, [](const RecentFile& file) {
            return fmt::format("{{ path = {}, title = {} }}", quoted(file.path), quoted(file.title));
        });
    }

private:
    void line(const char* key, const std::string& value) { lines += fmt::format("{} = {}\n", key, value); }
    template <class Values, class Text>
    void list(const char* key, const Values& values, const Text& text) {
        std::string all;
        for (const auto& value : values) all += (all.empty() ? "" : ", ") + text(value);
        line(key, "[" + all + "]");
    }
    // A file that is no UTF-8 could not be read again: a name that is none is left out.
    static std::string quoted(std::string_view value) { return toml_text::quote(is_utf8(value) ? value : ""); }
};

// The values of each file, for reading and for writing.
template <class Visitor, class P>
void visit_preferences(Visitor& file, P& p) {
    file.word("theme", theme_words, p.theme);
    file.text("language", p.language);
    file.number("type_size", p.type_size, least_type_size, largest_type_size);
    file.flag("reduce_motion", p.reduce_motion);
    file.word("quality", quality_words, p.quality);
    file.text("link_base", p.link_base);
}

template <class Visitor, class View>
void visit_view(Visitor& file, View& view) {
    file.word("camera", camera_mode_words, view.settings.camera.mode);
    file.number("diagram_share", view.settings.canvas_share, least_canvas_share, largest_canvas_share);
    file.whole("prediction", view.settings.overlays.prediction);
    file.word("trail_colour", trail_value_words, view.settings.overlays.trail_colour.value);
    visit_kept_flags(view.settings, [&](const char* key, auto& value) { file.flag(key, value); });
    file.flag("knows_sliders", view.followed.slider);
    file.flag("knows_lamps", view.followed.lamp);
    file.flag("knows_wiring", view.followed.wiring);
    file.flag("knows_timeline", view.followed.timeline);
    file.flag("breeds_weights", view.may_change.weights);
    file.flag("breeds_biases", view.may_change.biases);
    file.flag("breeds_thresholds", view.may_change.thresholds);
    file.flag("breeds_eyes", view.may_change.eyes);
    file.texts("strips", view.strips);
    file.texts("folded", view.folded);
}

template <class Visitor, class State, class Place>
void visit_state(Visitor& file, State& r, Place& place) {
    file.whole("width", r.width);
    file.whole("height", r.height);
    file.text("last_opened", r.last_opened);
    file.text("folder", r.folder);
    file.files("recent", r.recent);
    file.text("student", r.student);
    file.text("study", r.study);
    file.text("breeding", r.breeding);
    visit_view(file, r.view);
    if (place) file.whole("x", place->x), file.whole("y", place->y);
}

}  // namespace

Result<Preferences> parse_preferences(std::string_view toml, std::string file_name, const Preferences& otherwise) {
    const auto file = parse_toml(toml, std::move(file_name));
    if (!file) return file.error();
    SettingsReader reader{*file};
    Preferences p = otherwise;
    visit_preferences(reader, p);
    if (reader.error) return *reader.error;
    return p;
}

std::string write_preferences(const Preferences& p) {
    SettingsWriter writer("Preferences of Braitenlab.");
    visit_preferences(writer, p);
    return writer.lines;
}

Result<StoredState> parse_state(std::string_view toml, std::string file_name) {
    const auto file = parse_toml(toml, std::move(file_name));
    if (!file) return file.error();
    SettingsReader reader{*file};
    StoredState r;
    std::optional<WindowPlace> place;
    if (file->root.contains("x") && file->root.contains("y")) place.emplace();
    visit_state(reader, r, place);
    if (reader.error) return *reader.error;
    constexpr int largest = 16384, farthest = 100000;  // the first as for --size
    if (r.width < 640 || r.height < 480 || r.width > largest || r.height > largest) r.width = r.height = 0;
    if (place && std::abs(place->x) < farthest && std::abs(place->y) < farthest) r.place = place;
    Overlays& overlays = r.view.settings.overlays;
    overlays.prediction = std::clamp(overlays.prediction, 0, longest_prediction);
    TrailValue& trails = overlays.trail_colour.value;
    if (trails == TrailValue::reading) trails = Overlays{}.trail_colour.value;  // a reading depends on the scene
    r.view.strips.resize(std::min(r.view.strips.size(), ui::most_strips));
    r.recent.resize(std::min(r.recent.size(), most_recent));
    return r;
}

std::string write_state(const StoredState& r) {
    SettingsWriter writer("Stored by Braitenlab.");
    visit_state(writer, r, r.place);
    return writer.lines;
}

void add_recent(StoredState& r, const fs::path& file, std::string title) {
    std::error_code problem;
    fs::path path = fs::absolute(file, problem).lexically_normal();
    if (problem) path = file;
    r.last_opened = path.string();
    std::erase_if(r.recent, [&](const RecentFile& each) { return each.path == r.last_opened; });
    r.recent.insert(r.recent.begin(), {r.last_opened, std::move(title)});
    if (r.recent.size() > most_recent) r.recent.resize(most_recent);
}

namespace {

Error set_aside_settings(const fs::path& path, const Error& error) {
    const auto aside = set_aside(path);
    const Message what =
        aside ? message_of("settings_kept_aside", aside->filename().string()) : message_of("settings_ignored");
    return error_of(message_of(error) + what, error.file, error.line);
}

}  // namespace

SettingsFiles::SettingsFiles(fs::path config, fs::path state)
    : settings_(config.empty() ? config : config / "settings.toml"),
      state_(state.empty() ? state : state / "state.toml") {}

std::vector<Error> SettingsFiles::read(Preferences& preferences, StoredState& state) {
    std::vector<Error> errors;
    const auto read_one = [&](const fs::path& path, std::string& text, auto parse, auto& value) {
        std::error_code none;
        if (path.empty() || !fs::exists(path, none)) return;
        const auto found = read_text(path);
        if (!found) return errors.push_back(set_aside_settings(path, found.error()));
        auto parsed = parse(*found, path.string());
        if (!parsed) return errors.push_back(set_aside_settings(path, parsed.error()));
        text = *found;
        value = *parsed;
    };
    read_one(
        settings_, settings_text_,
        [&](const std::string& text, std::string file) { return parse_preferences(text, file, preferences); },
        preferences);
    read_one(state_, state_text_, parse_state, state);
    start_ = preferences;
    return errors;
}

std::optional<Error> SettingsFiles::write(const Preferences& preferences, const StoredState& state) {
    std::optional<Error> failed;
    const auto write_one = [&](const fs::path& path, std::string& on_disk, std::string text) {
        if (path.empty() || text == on_disk) return;
        on_disk = std::move(text);  // also if writing fails: the error is reported once
        if (auto error = write_whole(path, on_disk)) failed = std::move(error);
    };
    // Preferences are not written before the user changes one: until then, the system's language applies.
    if (!settings_text_.empty() || preferences != start_)
        write_one(settings_, settings_text_, write_preferences(preferences));
    write_one(state_, state_text_, write_state(state));
    return failed;
}

Settings read_settings(SettingsFiles files, const PreferenceOverrides& overrides, const std::string& native_language,
                       Theme native_theme) {
    Settings settings{.files = std::move(files)};
    settings.stored.theme = native_theme;
    settings.stored.language = settings.native_language = native_language;
    settings.errors = settings.files.read(settings.stored, settings.state);
    settings.at_start = settings.stored;
    if (overrides.theme) settings.at_start.theme = *overrides.theme;
    if (!overrides.language.empty()) settings.at_start.language = overrides.language;
    if (overrides.has_quality) settings.at_start.quality = overrides.quality;
    settings.last = settings.at_start;
    return settings;
}

bool can_be_grabbed(WindowPlace place, std::pair<int, int> size, const std::vector<std::array<int, 4>>& displays) {
    constexpr int least = 100;  // px of the upper edge
    return std::any_of(displays.begin(), displays.end(), [&](const std::array<int, 4>& display) {
        const auto [x, y, width, height] = display;
        const int left = std::max(place.x, x), right = std::min(place.x + size.first, x + width);
        return right - left >= least && place.y >= y && place.y < y + height - least;
    });
}

std::optional<Error> save(Settings& settings, const Preferences& now, std::pair<int, int> window_size) {
    const Preferences before = std::exchange(settings.last, now);
    Preferences& stored = settings.stored;
    if (now.theme != before.theme) stored.theme = now.theme;
    if (now.language != before.language) stored.language = now.language;
    if (now.type_size != before.type_size) stored.type_size = now.type_size;
    if (now.reduce_motion != before.reduce_motion) stored.reduce_motion = now.reduce_motion;
    if (now.quality != before.quality) stored.quality = now.quality;
    std::tie(settings.state.width, settings.state.height) = window_size;
    return settings.files.write(stored, settings.state);
}

}  // namespace braitenlab
