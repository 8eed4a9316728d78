// The window's program: reads the command line, opens what is to be opened, and runs.
#include <string>
#include <utility>

#include "app/app.h"
#include "app/data.h"
#include "app/desk.h"

namespace braitenlab {

namespace {

constexpr const char* first_exercise = "05-aggressor";

struct Opened {
    std::filesystem::path path;
    Lab lab;
};

// What is open at the start when nothing is asked for: what was open last; else the first exercise.
Result<Opened> open_usual(const Options& options, Memory& memory) {
    if (const std::string& last = memory.remembered.last_opened; !last.empty()) {
        if (const auto found = find_shipped(last))
            if (auto lab = open_lab(*found, options.seed, options.settings)) return Opened{*found, std::move(*lab)};
        memory.complaints.push_back({"was open last, but cannot be opened now", last});
    }
    const auto first = find_shipped(first_exercise);
    if (!first) return first.error();
    auto lab = open_lab(*first, options.seed, options.settings);
    if (!lab) return lab.error();
    return Opened{*first, std::move(*lab)};
}

Result<Opened> open_asked(const Options& options) {
    const auto path = find_shipped(options.file);
    if (!path) return path.error();
    auto lab = open_lab(*path, options.seed, options.settings);
    if (!lab) return lab.error();
    return Opened{*path, std::move(*lab)};
}

// A file that cannot be opened is no reason to open no window: who has double-clicked it sees no terminal. But a script
// that asked for a picture of it, or for other values in it, must not get another scene.
Result<Opened> open_at_start(const Options& options, Memory& memory) {
    if (options.file.empty()) return open_usual(options, memory);
    auto asked = open_asked(options);
    if (asked || !options.screenshot.empty() || !options.settings.empty()) return asked;
    complain(asked.error());
    auto instead = open_usual(options, memory);
    memory.complaints.push_back(asked.error());  // the last one is what the window shows
    return instead;
}

int open_and_run(const Options& options) {
    const auto data = data_folder();
    if (!data) return complain(data.error());
    Memory memory = recall(options, native_language(*data / "ui" / "strings"));
    auto opened = open_at_start(options, memory);
    if (!opened) return complain(opened.error());
    remember_file(memory.remembered, opened->path);
    auto words = words_in(*data / "ui" / "strings", memory.preferences.language);
    if (!words) return complain(words.error());
    auto window = Window::open({.title = "Braitenlab",
                                .width = size_of(options, memory.remembered).first,
                                .height = size_of(options, memory.remembered).second,
                                .full_screen = options.full_screen,
                                .watch_graphics = options.watch_graphics,
                                .smooth_in_software = !options.screenshot.empty()});
    if (!window) return complain(window.error());
    auto renderer = Renderer::create(*data / "shaders", options.sectors);
    if (!renderer) return complain(renderer.error());
    App app(options, std::move(opened->lab), std::move(*window), std::move(*renderer), std::move(*words),
            std::move(memory));
    while (app.turn()) {
    }
    return app.exit_code();
}

}  // namespace

}  // namespace braitenlab

int main(int argc, char** argv) {
    const auto line = braitenlab::read_command_line(argc, argv);
    return line.exit_code ? *line.exit_code : braitenlab::open_and_run(line.options);
}
