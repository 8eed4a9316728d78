// The program with a window: reads the command line, opens a document and a window, and runs the main loop.
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "app/app.h"
#include "app/course/lab_lecture.h"
#include "app/files/breeding_files.h"
#include "app/files/data.h"
#include "app/files/file_commands.h"
#include "app/files/links.h"
#include "app/files/study_files.h"
#include "app/platform/memory.h"
#include "app/platform/page.h"
#include "app/platform/platform.h"
#include "app/terminal.h"
#include "core/insight/study_file.h"
#include "core/io/link.h"
#include "core/messages.h"
#include "render/gl/offscreen.h"

namespace braitenlab {

namespace {

constexpr const char* first_exercise = "01-drive";

struct Opened {
    std::filesystem::path path;  // empty: a link
    Lab lab;
    std::shared_ptr<const Lecture> lecture{};  // whose first page is open
};

// Without a FILE: opens the last file again, else the first exercise.
Result<Opened> open_usual(const Options& options, Settings& settings) {
    if (const std::string& last = settings.state.last_opened; !last.empty()) {
        if (const auto found = find_shipped(last))
            if (auto lab = open_lab(*found, options.seed, options.settings)) return Opened{*found, std::move(*lab)};
        settings.errors.push_back(error_of(message_of("was_open_last"), last));
    }
    const auto first = find_shipped(first_exercise);
    if (!first) return first.error();
    auto lab = open_lab(*first, options.seed, options.settings);
    if (!lab) return lab.error();
    return Opened{*first, std::move(*lab)};
}

Result<Opened> open_asked(const Options& options) {
    const bool is_link = io::is_link(options.file) || io::begins_like_link(options.file);
    auto linked = is_link ? io::decode_link(options.file) : io::Linked{};
    if (!linked) return linked.error();
    if (is_link && linked->exercise.empty()) {
        auto document = linked_document(std::move(linked->scene));
        if (!document) return document.error();
        return Opened{{}, make_lab(std::move(*document))};
    }
    const auto path = is_link ? linked_exercise(linked->exercise) : find_shipped(options.file);
    if (!path) return path.error();
    if (const auto file = read_file(*path); file && file->kind == FileKind::lecture) {
        auto lecture = read_whole_lecture(*path);
        if (!lecture) return lecture.error();
        auto lab = open_lab(lecture->pages.front().file, std::nullopt, {});
        if (!lab) return lab.error();
        return Opened{*path, std::move(*lab), std::make_shared<const Lecture>(std::move(*lecture))};
    }
    if (const auto file = read_file(*path); file && file->kind == FileKind::study) {
        const auto study = insight::parse_study(file->text, path->string());
        if (!study) return study.error();
        const auto scene = scene_beside(*path, study->scene);
        if (!scene) return scene.error();
        auto lab = open_lab(*scene, options.seed, options.settings);
        if (!lab) return lab.error();
        show_study(lab->study, path->string());
        return Opened{*path, std::move(*lab)};
    }
    if (const auto file = read_file(*path); file && file->kind == FileKind::breeding) {
        if (options.seed || !options.settings.empty())
            return error_of(message_of("breeding_has_own_values"), path->string());
        const auto base = load_breeding(*path);
        if (!base) return base.error();
        auto document = linked_document((*base)->scene());
        if (!document) return document.error();
        Lab lab = make_lab(std::move(*document));
        show_breeding(lab.breeding, *path);
        return Opened{{}, std::move(lab)};
    }
    auto lab = open_lab(*path, options.seed, options.settings);
    if (!lab) return lab.error();
    return Opened{*path, std::move(*lab)};
}

// If FILE cannot be opened, opens another document and shows the error in the window, because there is no terminal
// after a double click on the file. With --screenshot, --clip or --set it fails, because a script must not get another
// scene; and for a name in the address of a page, which then offers to start without it.
Result<Opened> open_at_start(const Options& options, Settings& settings) {
    if (options.file.empty()) return open_usual(options, settings);
    auto asked = open_asked(options);
    // Else it is a link, or the path of a lecture that a reload opens again.
    const bool is_name_in_address = is_on_page() && options.file.find_first_of("#/") == std::string::npos;
    if (asked || options.only_draws() || !options.settings.empty() || is_name_in_address) return asked;
    complain(asked.error());
    auto instead = open_usual(options, settings);
    settings.errors.push_back(asked.error());  // the window shows the last error first
    return instead;
}

// The size on the command line, else that of the last session, else the default. Window pixels.
std::pair<int, int> window_size(const Options& options, const StoredState& state) {
    if (options.size_given || state.width == 0) return {options.width, options.height};
    return {state.width, state.height};
}

// The background of the first scene.
Colour first_colour(const Options& options, const Opened& opened, const Settings& settings) {
    const bool lectures = opened.lecture || options.lecture;
    return palette(lectures ? opened.lab.lectures.theme : settings.at_start.theme).sky;
}

// The first start of a person, without a FILE and without options of a script.
bool is_first_start(const Options& options, const Settings& settings) {
    return settings.state.last_opened.empty() && settings.errors.empty() && !options.only_draws() &&
           options.file.empty() && options.settings.empty() && !options.play && !options.lecture;
}

int open_and_run(Options options) {
    if (const auto fault = fault_of_outputs(options)) return complain(*fault);
    const auto data = data_folder();
    if (!data) return complain(data.error());
    // A picture depends on the command line alone: no settings are read for it.
    const UserFolders folders = options.only_draws() ? UserFolders{} : user_folders();
    SettingsFiles files(folders.config, folders.state);
    Settings settings = read_settings(
        std::move(files), {options.theme, options.language, options.graphics.has_quality, options.graphics.quality},
        native_language(*data / "ui" / "strings"), prefers_light() ? Theme::light : Theme::dark);
    options.title |= is_first_start(options, settings);
    auto opened = open_at_start(options, settings);
    if (!opened) return complain(opened.error());
    options.pages = opened->lecture;
    if (!opened->lecture && !opened->path.empty()) add_recent_file(settings.state, opened->path, opened->lab.document);
    auto words = load_words(*data / "ui" / "strings", settings.at_start.language);
    if (!words) return complain(words.error());
    const auto [width, height] = window_size(options, settings.state);
    const bool is_off_screen = options.only_draws() && !options.full_screen;
    auto window = Window::open({.title = "Braitenlab",
                                .width = is_off_screen ? Options{}.width : width,
                                .height = is_off_screen ? Options{}.height : height,
                                .fits_display = !options.size_given && !is_off_screen,
                                .full_screen = options.full_screen,
                                .visible = !options.only_draws() || options.full_screen,
                                .watch_graphics = options.graphics.watch});
    if (!window) return complain(window.error());
    if (const auto& place = settings.state.place;
        place && !options.full_screen && can_be_grabbed(*place, {width, height}, window->displays()))
        window->move_to(place->x, place->y);
    // Compiling the shaders takes a second or two on a software renderer.
    if (!options.only_draws()) window->fill(first_colour(options, *opened, settings)), window->show();
    std::optional<render::Offscreen> canvas;
    if (is_off_screen) {
        canvas.emplace(width, height);
        const int most = render::Offscreen::largest();
        if (!canvas->ready()) return complain(error_of(message_of("picture_too_large", most, most)));
        window->redirect(Window::Canvas{canvas->framebuffer(), width, height});
    }
    auto renderer = render::Renderer::create(*data / "shaders", options.graphics.sectors);
    if (!renderer) return complain(renderer.error());
    const auto app = std::make_shared<App>(options, std::move(opened->lab), std::move(*window), std::move(*renderer),
                                           std::move(*words), std::move(settings));
    app->draw_into(std::move(canvas));
    when_page_is_left([app] { app->keep_work(); });
    work_between_turns([app] { return app->work(); });
    offer_to_page("state", [app] { return app->state_text(); });
    offer_to_page("anchors", [app] { return app->anchors_text(); });
    repeat([app] { return app->turn(); });
    return app->exit_code();
}

}  // namespace

}  // namespace braitenlab

int main(int argc, char** argv) {
    braitenlab::keep_freed_memory();
    braitenlab::use_utf8(argc, argv);
    const braitenlab::InertOutput inert;
    const auto line = braitenlab::read_command_line(argc, argv);
    if (!line.exit_code) return braitenlab::open_and_run(line.options);
    std::cout.flush();
    if (std::cout) return *line.exit_code;
    return braitenlab::complain({"standard output could not be written; check that it has room"});
}
