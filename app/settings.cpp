#include "app/settings.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include <toml++/toml.h>

#include "app/safe_file.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

// A table being read, and the first value in it that is of the wrong type.
struct Reading {
    toml::table table;
    std::string file;
    std::optional<Error> error;

    template <class T>
    void take(const char* key, T& value, const char* what) {
        const toml::node* node = table.get(key);
        if (!node) return;
        if (const auto found = node->value<T>())
            value = *found;
        else if (!error)
            error =
                Error{std::string("'") + key + "' must be " + what, file, static_cast<int>(node->source().begin.line)};
    }
};

Result<Reading> read_settings(std::string_view text, std::string file_name) {
    try {
        return Reading{toml::parse(text, file_name), file_name, std::nullopt};
    } catch (const toml::parse_error& error) {
        return Error{std::string(error.description()), file_name, static_cast<int>(error.source().begin.line)};
    }
}

std::string text_of(const toml::table& table, const char* about) {
    std::ostringstream out;
    out << "# " << about << "\n" << table << "\n";
    return out.str();
}

}  // namespace

Result<Preferences> parse_preferences(std::string_view toml, std::string file_name, const Preferences& otherwise) {
    auto reading = read_settings(toml, std::move(file_name));
    if (!reading) return reading.error();
    Preferences p = otherwise;
    std::string theme = p.theme == Theme::light ? "light" : "dark";
    reading->take("theme", theme, "\"dark\" or \"light\"");
    reading->take("language", p.language, "a language's code, as in \"de\"");
    reading->take("type_size", p.type_size, "a number from 1 to 2");
    reading->take("reduce_motion", p.reduce_motion, "true or false");
    if (reading->error) return *reading->error;
    p.theme = theme == "light" ? Theme::light : Theme::dark;
    p.type_size = p.type_size > least_type_size ? std::min(p.type_size, largest_type_size) : least_type_size;
    return p;
}

std::string write_preferences(const Preferences& p) {
    return text_of(toml::table{{"format", 1},
                               {"theme", p.theme == Theme::light ? "light" : "dark"},
                               {"language", p.language},
                               {"type_size", p.type_size},
                               {"reduce_motion", p.reduce_motion}},
                   "Chosen in the lab's settings.");
}

Result<Remembered> parse_remembered(std::string_view toml, std::string file_name) {
    auto reading = read_settings(toml, std::move(file_name));
    if (!reading) return reading.error();
    Remembered r;
    reading->take("width", r.width, "a whole number");
    reading->take("height", r.height, "a whole number");
    reading->take("last_opened", r.last_opened, "a path in quotes");
    reading->take("folder", r.folder, "a path in quotes");
    if (reading->error) return *reading->error;
    if (const toml::array* recent = reading->table["recent"].as_array())
        for (const toml::node& node : *recent)
            if (const auto path = node.value<std::string>(); path && r.recent.size() < most_recent)
                r.recent.push_back(*path);
    constexpr int largest = 16384;  // as for --size
    if (r.width < 640 || r.height < 480 || r.width > largest || r.height > largest) r.width = r.height = 0;
    return r;
}

std::string write_remembered(const Remembered& r) {
    toml::array recent;
    for (const std::string& path : r.recent) recent.push_back(path);
    return text_of(toml::table{{"format", 1},
                               {"width", r.width},
                               {"height", r.height},
                               {"last_opened", r.last_opened},
                               {"folder", r.folder},
                               {"recent", recent}},
                   "What the lab remembers by itself.");
}

void remember_opened(Remembered& r, const fs::path& file) {
    std::error_code problem;
    fs::path path = fs::absolute(file, problem).lexically_normal();
    if (problem) path = file;
    r.last_opened = path.string();
    std::erase(r.recent, r.last_opened);
    r.recent.insert(r.recent.begin(), r.last_opened);
    if (r.recent.size() > most_recent) r.recent.resize(most_recent);
}

namespace {

std::optional<std::string> text_of_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (path.empty() || !file) return std::nullopt;
    return std::string{std::istreambuf_iterator<char>(file), {}};
}

// Out of the way, so that it is told once and written anew; what a person wrote into it is not lost.
Error set_aside(const fs::path& path, Error error) {
    fs::path aside = path;
    aside += ".broken";
    std::error_code problem;
    fs::rename(path, aside, problem);
    error.what += problem ? "; it is passed over" : "; it is passed over and kept as " + aside.filename().string();
    return error;
}

}  // namespace

SettingsFiles::SettingsFiles(fs::path config, fs::path state)
    : settings_(config.empty() ? config : config / "settings.toml"),
      state_(state.empty() ? state : state / "state.toml") {}

std::vector<Error> SettingsFiles::read(Preferences& preferences, Remembered& remembered) {
    std::vector<Error> complaints;
    const auto read_one = [&](const fs::path& path, std::string& text, auto parse, auto& value) {
        const auto found = text_of_file(path);
        if (!found) return;
        auto parsed = parse(*found, path.string());
        if (!parsed) return complaints.push_back(set_aside(path, parsed.error()));
        text = *found;
        value = *parsed;
    };
    read_one(
        settings_, settings_text_,
        [&](const std::string& text, std::string file) { return parse_preferences(text, file, preferences); },
        preferences);
    read_one(state_, state_text_, parse_remembered, remembered);
    start_ = preferences;
    return complaints;
}

std::optional<Error> SettingsFiles::write(const Preferences& preferences, const Remembered& remembered) {
    std::optional<Error> failed;
    const auto write_one = [&](const fs::path& path, std::string& on_disk, std::string text) {
        if (path.empty() || text == on_disk) return;
        on_disk = std::move(text);  // on failure too: nobody wants to hear it again every second
        if (auto error = write_whole(path, on_disk)) failed = std::move(error);
    };
    // Untouched preferences stay unwritten: a system's language may change under them.
    if (!settings_text_.empty() || preferences != start_)
        write_one(settings_, settings_text_, write_preferences(preferences));
    write_one(state_, state_text_, write_remembered(remembered));
    return failed;
}

}  // namespace braitenlab
