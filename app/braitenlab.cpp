// The window: opens the lab, then once a frame lets time pass, draws, and carries out what the person asked for.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

#include <fmt/format.h>
#include <imgui.h>

#include "app/autosave.h"
#include "app/catalogue.h"
#include "app/data.h"
#include "app/desk.h"
#include "app/lab.h"
#include "app/lettering.h"
#include "app/look.h"
#include "app/memory.h"
#include "app/options.h"
#include "app/platform.h"
#include "app/report_state.h"
#include "app/screenshot.h"
#include "app/viewport.h"
#include "app/window.h"
#include "app/words.h"
#include "render/gl/renderer.h"
#include "render/view/between.h"
#include "ui/prompts.h"
#include "ui/window.h"

namespace braitenlab {

namespace {

using Clock = std::chrono::steady_clock;
constexpr double frame_seconds = 1.0 / 60;
constexpr const char* first_exercise = "05-aggressor";

double seconds_since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

int complain(const Error& error) {
    std::cerr << "braitenlab: " << error.text() << "\n";
    return 2;
}

// Everything that lives as long as the window is open.
class App {
public:
    App(Options options, Lab lab, Window window, Renderer renderer, Words words, Memory memory)
        : options_(std::move(options)),
          lab_(std::move(lab)),
          window_(std::move(window)),
          renderer_(std::move(renderer)),
          words_(std::move(words)),
          memory_(std::move(memory)),
          autosave_(options_.screenshot.empty() && !state_folder().empty() ? state_folder() / "autosave"
                                                                           : std::filesystem::path{},
                    memory_.complaints),
          catalogue_(read_catalogue()),
          anchors_file_(options_.anchors),
          state_file_(options_.state) {
        lab_.preferences = memory_.preferences;
        lab_.camera.mode = options_.camera;
        lab_.overlays.field = options_.field;
        look_.wear(lab_.preferences.theme, wanted_scale());
        letter_labels();
        if (!look_.warning().empty()) std::cerr << "braitenlab: " << look_.warning() << "\n";
        for (const Error& complaint : memory_.complaints) refuse(complaint);
        refresh(files_, lab_);
        if (options_.play) handle(lab_, Action::play_pause);
    }

    int run() {
        const auto began = Clock::now();
        auto last = began;
        while (!window_.close_requested() && !lab_.exit) {
            const auto frame_began = Clock::now();
            double passed = std::chrono::duration<double>(frame_began - last).count();
            last = frame_began;
            if (repeatable()) passed = frame_seconds;
            window_.poll(0);
            do_what_files_ask();
            let_time_pass(passed);
            frame(static_cast<float>(passed));
            if (picture_is_due(seconds_since(began))) return take_picture(options_.screenshot);
            if (lab_.screenshot) take_picture_for_person();
            facts_.frame_ms = seconds_since(frame_began) * 1000;
            window_.show();
            write_reports();
            keep_memory(false);
            if (const auto error = autosave_.keep(lab_, lab_.wall_seconds)) refuse(*error);
            if (lab_.full_screen) lab_.full_screen = false, window_.toggle_full_screen();
            while (!repeatable() && seconds_since(frame_began) < frame_seconds)
                window_.poll(frame_seconds - seconds_since(frame_began));
        }
        keep_memory(true);
        autosave_.finish();
        return 0;
    }

private:
    // A picture of a run is taken after so many ticks, one a frame, so that it can be repeated.
    bool repeatable() const { return !options_.screenshot.empty() && options_.play; }

    bool picture_is_due(double wall_seconds) const {
        if (options_.screenshot.empty()) return false;
        return (repeatable() ? lab_.session.snapshot().seconds : wall_seconds) >= options_.after - 1e-9;
    }

    void let_time_pass(double passed) {
        if (repeatable()) {
            lab_.wall_seconds += passed;
            tick(lab_);
        } else {
            advance(lab_, std::min(passed, 0.25));
        }
    }

    // What was dropped onto the window, and what was asked for in its browser.
    void do_what_files_ask() {
        for (const std::string& path : window_.take_dropped_files()) lab_.files.push_back(OpenRequest{path});
        for (const Request& request : lab_.files)
            if (const auto* recover = std::get_if<RecoverRequest>(&request)) do_recovery(recover->take);
        if (!lab_.files.empty()) do_files(lab_, files_, memory_.remembered, words_.strings);
    }

    // What a crash left is forgotten only when it is on the disk again under this lab's name.
    void do_recovery(bool take) {
        if (!take) return autosave_.forget();
        auto recovered = autosave_.recover();
        if (!recovered) return refuse(recovered.error());
        recovered->work = 1;
        replace_lab(lab_, std::move(*recovered));
        refresh(files_, lab_);
        const auto error = autosave_.keep(lab_, lab_.wall_seconds, true);
        error ? refuse(*error) : autosave_.forget();
    }

    void refuse(const Error& error) {
        lab_.notice = error.text();
        lab_.notice_until = lab_.wall_seconds + 10;
    }

    // Window pixels per layout pixel. --scale says it for the type size that the session begins with.
    float wanted_scale() const {
        if (!options_.scale) return window_.content_scale() * lab_.preferences.type_size;
        return *options_.scale * lab_.preferences.type_size / memory_.preferences.type_size;
    }

    // Between two frames: language, theme and scale as they are wanted now.
    void follow_preferences() {
        if (const auto error = speak(words_, lab_.preferences.language)) {
            lab_.preferences.language = words_.language;
            refuse(*error);
        }
        if (look_.wear(lab_.preferences.theme, wanted_scale())) window_.forget_fonts(), letter_labels();
    }

    // Framebuffer pixels, of which a display of high density has more than one per window pixel.
    float density() const { return static_cast<float>(window_.framebuffer_width()) / std::max(1.0f, window_.area().w); }

    // The scene's labels at the size of the window's small type.
    void letter_labels() {
        constexpr float label_em = 14;  // layout pixels
        const auto pixels = static_cast<int>(std::lround(label_em * look_.scale() * density()));
        auto [lettering, warning] = label_font(find_font, pixels, *look_.fonts().small);
        renderer_.use_lettering(std::move(lettering));
        if (!warning.empty() && !told_of_labels_) std::cerr << "braitenlab: " << warning << "\n";
        told_of_labels_ = true;
    }

    // A shader that was saved while the lab runs is in use within half a second; a broken one is told and left.
    void follow_shaders() {
        if (seconds_since(shaders_checked_) < 0.5) return;
        shaders_checked_ = Clock::now();
        if (const auto error = renderer_.follow_shaders()) complain(*error), refuse(*error);
    }

    // Once a second, and at the end, what has changed is written; where nothing has, nothing is.
    void keep_memory(bool now) {
        if (!options_.screenshot.empty() || (!now && seconds_since(memory_kept_) < 1)) return;
        memory_kept_ = Clock::now();
        if (const auto error = keep(memory_, desk_preferences(lab_), window_.windowed_size())) refuse(*error);
    }

    void frame(float passed) {
        follow_preferences();
        follow_shaders();
        window_.begin_frame();
        LabView view = view_of(lab_);
        view.catalogue = &catalogue_;
        view.languages = &words_.languages;
        view.recent = &memory_.remembered.recent;
        view.files = &files_;
        if (autosave_.leftover()) view.recovery = &autosave_.leftover()->offer;
        const Rect area = window_.area();
        const WindowLayout layout = lay_out(area.w, area.h, look_.scale(), view, panels_.charts_open);
        aim(viewport_, lab_, area, layout.scene, passed);
        view.sight = &viewport_.sight;
        outbox_.clear();
        bool arrows_are_free = true;
        for (const KeyPress press : window_.take_keys()) arrows_are_free &= !press_key(view, panels_, press, outbox_);

        anchors_.begin();
        Ui ui{.strings = words_.strings,
              .palette = palette(view.theme),
              .fonts = look_.fonts(),
              .scale = look_.scale(),
              .anchors = anchors_,
              .outbox = outbox_,
              .highlight = next_prompt(view),
              .pulse = pulse(view)};
        draw_window(view, panels_, ui, layout);

        const bool arrows_move_camera = arrows_are_free && view.mode != Mode::wiring &&
                                        panels_.keyboard.focus.empty() && !takes_arrows(view, ImGui::GetIO().KeyCtrl);
        const Arrows held = arrows_move_camera ? arrows() : Arrows{};
        const bool steers = steer_by_keys(lab_, held.turn, held.raise);
        drive_camera(lab_, viewport_, panels_.stage, steers ? Arrows{} : held, area, layout.scene, passed);
        draw_scene();
        facts_.focus = panels_.keyboard.focus;
        window_.bind();
        window_.end_frame();
        for (const Request& request : outbox_) handle(lab_, request);
    }

    Arrows arrows() const {
        if (ImGui::GetIO().WantTextInput) return {};
        const auto held = [this](Action action) {
            for (const Shortcut& shortcut : shortcuts())
                if (shortcut.action == action && window_.holds(shortcut.press.key)) return 1.0f;
            return 0.0f;
        };
        return {held(Action::turn_right) - held(Action::turn_left), held(Action::raise) - held(Action::lower)};
    }

    void draw_scene() {
        Picture picture;
        picture.sight = viewport_.sight;
        picture.sight.window = {0, 0, static_cast<float>(window_.framebuffer_width()),
                                static_cast<float>(window_.framebuffer_height())};
        picture.theme = lab_.preferences.theme;
        picture.selected = lab_.selected;
        const Thing& hovered = panels_.stage.hovered.thing;
        picture.hovered = hovered.kind == ThingKind::vehicle ? hovered.index : no_vehicle;
        picture.driver = lab_.camera.mode == CameraMode::driver ? lab_.selected : no_vehicle;
        picture.sensors = lab_.sensors;
        picture.outlines = lab_.outlines;
        picture.overlays = lab_.overlays;
        picture.pixel_scale = density() * look_.scale();
        shown_ = lab_.session.snapshot();
        if (!repeatable()) stand_between(shown_, lab_.before, between_ticks(lab_));
        renderer_.draw(shown_, picture);
        facts_.draw_calls = renderer_.draw_calls();
        facts_.sight = viewport_.sight;
        facts_.hand = ImGui::GetMouseCursor() == ImGuiMouseCursor_Hand;
        facts_.graphics_errors = window_.graphics_errors();
    }

    int take_picture(const std::filesystem::path& path) {
        if (auto error = write_png(path, window_.framebuffer_width(), window_.framebuffer_height(), window_.pixels()))
            return complain(*error);
        return 0;
    }

    void take_picture_for_person() {
        lab_.screenshot = false;
        std::error_code none;  // writing will say what is wrong
        const auto folder = pictures_folder();
        std::filesystem::create_directories(folder, none);
        const auto path = next_screenshot_name(folder);
        if (auto error = write_png(path, window_.framebuffer_width(), window_.framebuffer_height(), window_.pixels()))
            return refuse(*error);
        lab_.notice = fill(words_.strings("notice.screenshot"), {path.string()});
        lab_.notice_until = lab_.wall_seconds + 6;
    }

    void write_reports() {
        if (anchors_file_.wanted())
            if (auto error = anchors_file_.write(anchors_json(anchors_))) complain(*error);
        constexpr double state_period = 0.05;
        if (!state_file_.wanted() || seconds_since(state_written_) < state_period) return;
        state_written_ = Clock::now();
        if (auto error = state_file_.write(state_json(lab_, panels_.stage, facts_))) complain(*error);
    }

    Options options_;
    Lab lab_;
    Window window_;
    Renderer renderer_;
    Words words_;
    Memory memory_;
    Autosave autosave_;
    Clock::time_point memory_kept_ = Clock::now();
    std::vector<CatalogueEntry> catalogue_;
    Look look_;
    FilesView files_;
    PanelState panels_;
    ViewportState viewport_;
    Anchors anchors_;
    Outbox outbox_;
    Snapshot shown_;  // what is drawn: the moment between the last two ticks
    FrameFacts facts_;
    KeptFile anchors_file_, state_file_;
    Clock::time_point shaders_checked_ = Clock::now();
    bool told_of_labels_ = false;
    Clock::time_point state_written_{};
};

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
