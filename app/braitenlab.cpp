// The window's program: reads the command line, opens what is to be opened, and runs.
#include <string>
#include <utility>

#include "app/app.h"
#include "app/data.h"
#include "app/desk.h"

namespace braitenlab {

namespace {

constexpr const char* first_exercise = "05-aggressor";

// What is open at the start: the file asked for; else what was open last; else the first exercise.
Result<std::filesystem::path> file_to_open(const Options& options, Memory& memory) {
    if (!options.file.empty()) return find_shipped(options.file);
    if (const std::string& last = memory.remembered.last_opened; !last.empty()) {
        if (const auto found = find_shipped(last); found && open_lab(*found, std::nullopt, {})) return found;
        memory.complaints.push_back({"was open last, but cannot be opened now", last});
    }
    return find_shipped(first_exercise);
}

int open_and_run(const Options& options) {
    const auto data = data_folder();
    if (!data) return complain(data.error());
    Memory memory = recall(options, native_language(*data / "ui" / "strings"));
    const auto path = file_to_open(options, memory);
    if (!path) return complain(path.error());
    auto lab = open_lab(*path, options.seed, options.settings);
    if (!lab) return complain(lab.error());
    remember_file(memory.remembered, *path);
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
    return App(options, std::move(*lab), std::move(*window), std::move(*renderer), std::move(*words), std::move(memory))
        .run();
}

}  // namespace

}  // namespace braitenlab

int main(int argc, char** argv) {
    const auto line = braitenlab::read_command_line(argc, argv);
    return line.exit_code ? *line.exit_code : braitenlab::open_and_run(line.options);
}
