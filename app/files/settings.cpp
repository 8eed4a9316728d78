#include "app/files/settings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "app/files/safe_file.h"
#include "app/playback.h"
#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/toml_tree.h"
#include "core/scene/toml_writer.h"
#include "core/utf8.h"
#include "ui/panels/chart_data.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

// A file being read, and the first value of the wrong type in it. `what`: the message of the type.
struct SettingsReader {
    TomlFile file;
    std::optional<Error> error{};

    void read(const char* key, std::string& value, MessageId<0> what) {
        take(key, value, what, [](const TomlNode& node) { return optional_of(node.as_text()); });
    }
    void read(const char* key, bool& value, MessageId<0> what) {
        take(key, value, what, [](const TomlNode& node) { return optional_of(node.as_flag()); });
    }
    void read(const char* key, int& value, MessageId<0> what) {
        take(key, value, what, [](const TomlNode& node) {
            const std::int64_t* whole = node.as_whole();
            return optional_of(whole && std::in_range<int>(*whole) ? whole : nullptr);
        });
    }
    void read(const char* key, float& value, MessageId<0> what) {
        take(key, value, what, [](const TomlNode& node) { return node.as_number(); });
    }
    // The texts of a list; other elements are left out. nullopt without a list.
    std::optional<std::vector<std::string>> texts(const char* key) const {
        const TomlNode* node = file.root.get(key);
        const TomlNode::List* list = node ? node->as_list() : nullptr;
        if (!list) return std::nullopt;
        std::vector<std::string> found;
        for (const TomlNode& element : *list)
            if (const std::string* text = element.as_text()) found.push_back(*text);
        return found;
    }

private:
    template <class T>
    static std::optional<T> optional_of(const T* value) {
        return value ? std::optional<T>(*value) : std::nullopt;
    }
    template <class T, class Convert>
    void take(const char* key, T& value, MessageId<0> what, const Convert& convert) {
        const TomlNode* node = file.root.get(key);
        if (!node) return;
        if (const auto found = convert(*node))
            value = static_cast<T>(*found);
        else if (!error)
            error = error_of(message_of("type_wanted", key) + message_of(what), file.name,
                             static_cast<int>(node->place.line));
    }
};

Result<SettingsReader> read_settings_table(std::string_view text, std::string file_name) {
    auto file = parse_toml(text, std::move(file_name));
    if (!file) return file.error();
    return SettingsReader{std::move(*file)};
}

// The lines of a file, one a key.
struct SettingsText {
    std::string lines;

    explicit SettingsText(const char* about) : lines(fmt::format("# {}\nformat = 1\n", about)) {}

    void add(const char* key, bool value) { line(key, value ? "true" : "false"); }
    void add(const char* key, int value) { line(key, fmt::format("{}", value)); }
    void add(const char* key, float value) { line(key, toml_text::number(value)); }
    void add(const char* key, std::string_view value) { line(key, text_value(value)); }
    void add(const char* key, const std::vector<std::string>& values) {
        std::string list;
        for (const std::string& value : values) list += (list.empty() ? "" : ", ") + text_value(value);
        line(key, "[" + list + "]");
    }
    void line(const char* key, const std::string& value) { lines += fmt::format("{} = {}\n", key, value); }

    // A file that is no UTF-8 could not be read again: a name that is none is left out.
    static std::string text_value(std::string_view value) { return toml_text::quote(is_utf8(value) ? value : ""); }
};

}  // namespace

Result<Preferences> parse_preferences(std::string_view toml, std::string file_name, const Preferences& otherwise) {
    auto reader = read_settings_table(toml, std::move(file_name));
    if (!reader) return reader.error();
    Preferences p = otherwise;
    std::string theme(word(p.theme));
    reader->read("theme", theme, "text_in_quotes");
    reader->read("language", p.language, "text_in_quotes");
    reader->read("type_size", p.type_size, "a_number");
    reader->read("reduce_motion", p.reduce_motion, "true_or_false");
    std::string quality;
    reader->read("quality", quality, "text_in_quotes");
    reader->read("link_base", p.link_base, "text_in_quotes");
    if (reader->error) return *reader->error;
    p.theme = theme == word(Theme::light) ? Theme::light : Theme::dark;
    for (std::size_t i = 0; i < quality_words.size(); ++i)
        if (quality == quality_words[i]) p.quality = static_cast<Quality>(i);
    if (quality == "auto") p.quality.reset();
    p.type_size = p.type_size > least_type_size ? std::min(p.type_size, largest_type_size) : least_type_size;
    return p;
}

std::string write_preferences(const Preferences& p) {
    SettingsText text("Preferences of Braitenlab.");
    text.add("theme", word(p.theme));
    text.add("language", p.language);
    text.add("type_size", p.type_size);
    text.add("reduce_motion", p.reduce_motion);
    text.add("quality", p.quality ? word(*p.quality) : "auto");
    if (!p.link_base.empty()) text.add("link_base", p.link_base);
    return text.lines;
}

namespace {

std::optional<RecentFile> recent_file(const TomlNode& node) {
    const auto text = [&](const char* key) {
        const TomlNode* value = node.get(key);
        return value ? value->as_text() : nullptr;
    };
    const std::string *path = text("path"), *title = text("title");
    if (!path) return std::nullopt;
    return RecentFile{*path, title ? *title : std::string()};
}

// Reads or writes the values of a stored view that are true or false: visit(key, value).
template <class View, class Visit>
void visit_flags(View& view, const Visit& visit) {
    visit_kept_flags(view.settings, visit);
    visit("knows_sliders", view.followed.slider);
    visit("knows_lamps", view.followed.lamp);
    visit("knows_wiring", view.followed.wiring);
    visit("knows_timeline", view.followed.timeline);
    visit("breeds_weights", view.may_change.weights);
    visit("breeds_biases", view.may_change.biases);
    visit("breeds_thresholds", view.may_change.thresholds);
    visit("breeds_eyes", view.may_change.eyes);
}

void read_view(SettingsReader& reader, StoredView& view) {
    visit_flags(view, [&](const char* key, bool& value) { reader.read(key, value, "true_or_false"); });
    reader.read("diagram_share", view.settings.canvas_share, "a_number");
    reader.read("speed", view.time_scale, "a_number");
    int& prediction = view.settings.overlays.prediction;
    reader.read("prediction", prediction, "a_whole_number");
    prediction = std::clamp(prediction, 0, longest_prediction);
    std::string camera(camera_mode_words[static_cast<std::size_t>(view.settings.camera.mode)]);
    reader.read("camera", camera, "text_in_quotes");
    for (std::size_t i = 0; i < camera_mode_words.size(); ++i)
        if (camera_mode_words[i] == camera) view.settings.camera.mode = static_cast<CameraMode>(i);
    TrailValue& trails = view.settings.overlays.trail_colour.value;
    std::string trail_colour(word(trails));
    reader.read("trail_colour", trail_colour, "text_in_quotes");
    for (const TrailValue value : {TrailValue::wheels, TrailValue::speed})  // a reading depends on the scene
        if (word(value) == trail_colour) trails = value;
    const auto clamped = [](float value, float low, float high, float otherwise) {
        return value >= low && value <= high ? value : std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
    };
    view.settings.canvas_share =
        clamped(view.settings.canvas_share, least_canvas_share, largest_canvas_share, ViewSettings{}.canvas_share);
    view.time_scale = clamped(view.time_scale, least_time_scale, largest_time_scale, 1);
    if (auto strips = reader.texts("strips")) {
        view.strips = std::move(*strips);
        view.strips.resize(std::min(view.strips.size(), ui::most_strips));
    }
    view.folded = reader.texts("folded");
}

void read_place(SettingsReader& reader, std::optional<WindowPlace>& place) {
    constexpr int farthest = 100000;
    WindowPlace read;
    reader.read("x", read.x, "a_whole_number");
    reader.read("y", read.y, "a_whole_number");
    if (!reader.file.root.contains("x") || !reader.file.root.contains("y")) return;
    if (std::abs(read.x) < farthest && std::abs(read.y) < farthest) place = read;
}

}  // namespace

Result<StoredState> parse_state(std::string_view toml, std::string file_name) {
    auto reader = read_settings_table(toml, std::move(file_name));
    if (!reader) return reader.error();
    StoredState r;
    reader->read("width", r.width, "a_whole_number");
    reader->read("height", r.height, "a_whole_number");
    reader->read("last_opened", r.last_opened, "text_in_quotes");
    reader->read("folder", r.folder, "text_in_quotes");
    reader->read("student", r.student, "text_in_quotes");
    reader->read("study", r.study, "text_in_quotes");
    reader->read("breeding", r.breeding, "text_in_quotes");
    read_view(*reader, r.view);
    read_place(*reader, r.place);
    if (reader->error) return *reader->error;
    const TomlNode* recent = reader->file.root.get("recent");
    if (recent && recent->as_list())
        for (const TomlNode& node : *recent->as_list())
            if (const auto file = recent_file(node); file && r.recent.size() < most_recent) r.recent.push_back(*file);
    constexpr int largest = 16384;  // as for --size
    if (r.width < 640 || r.height < 480 || r.width > largest || r.height > largest) r.width = r.height = 0;
    return r;
}

std::string write_state(const StoredState& r) {
    SettingsText text("Stored by Braitenlab.");
    text.add("width", r.width);
    text.add("height", r.height);
    text.add("last_opened", r.last_opened);
    text.add("folder", r.folder);
    std::string recent;
    for (const RecentFile& file : r.recent)
        recent += fmt::format("{}{{ path = {}, title = {} }}", recent.empty() ? "" : ", ",
                              SettingsText::text_value(file.path), SettingsText::text_value(file.title));
    text.line("recent", "[" + recent + "]");
    text.add("camera", camera_mode_words[static_cast<std::size_t>(r.view.settings.camera.mode)]);
    text.add("diagram_share", r.view.settings.canvas_share);
    text.add("speed", r.view.time_scale);
    text.add("prediction", r.view.settings.overlays.prediction);
    text.add("trail_colour", word(r.view.settings.overlays.trail_colour.value));
    visit_flags(r.view, [&](const char* key, bool value) { text.add(key, value); });
    if (!r.student.empty()) text.add("student", r.student);
    if (!r.study.empty()) text.add("study", r.study);
    if (!r.breeding.empty()) text.add("breeding", r.breeding);
    if (r.place) text.add("x", r.place->x), text.add("y", r.place->y);
    if (!r.view.strips.empty()) text.add("strips", r.view.strips);
    if (r.view.folded) text.add("folded", *r.view.folded);
    return text.lines;
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

// Renames the file, so that it is reported once and its text is kept.
Error set_aside_settings(const fs::path& path, const Error& error) {
    fs::path aside = path;
    aside += ".broken";
    std::error_code problem;
    fs::rename(path, aside, problem);
    const Message what =
        problem ? message_of("settings_ignored") : message_of("settings_kept_aside", aside.filename().string());
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

Settings read_settings(SettingsFiles files, const PreferenceOverrides& overrides, const std::string& native_language) {
    Settings settings{.files = std::move(files)};
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
