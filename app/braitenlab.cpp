// The window: opens the lab, then once a frame lets time pass, draws, and carries out what the person asked for.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

#include <fmt/format.h>
#include <imgui.h>

#include "app/data.h"
#include "app/lab.h"
#include "app/options.h"
#include "app/platform.h"
#include "app/report_state.h"
#include "app/screenshot.h"
#include "app/viewport.h"
#include "app/window.h"
#include "render/gl/renderer.h"
#include "render/view/between.h"
#include "ui/prompts.h"
#include "ui/strings.h"
#include "ui/theme.h"
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

FontPaths find_fonts() {
    const auto face = [](const std::vector<std::filesystem::path>& candidates) {
        return first_existing(candidates).string();
    };
    FontPaths paths;
    paths.text =
        face({"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf", "/usr/share/fonts/noto/NotoSans-Regular.ttf",
              "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf"});
    paths.title =
        face({"/usr/share/fonts/truetype/noto/NotoSans-Bold.ttf", "/usr/share/fonts/noto/NotoSans-Bold.ttf",
              "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", "/usr/share/fonts/dejavu/DejaVuSans-Bold.ttf"});
    paths.icons = face({"/usr/share/fonts/truetype/fork-awesome/forkawesome-webfont.ttf",
                        "/usr/share/fonts-fork-awesome/fonts/forkawesome-webfont.ttf"});
    paths.symbols = {face({"/usr/share/fonts/truetype/noto/NotoSansMono-Regular.ttf",
                           "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"}),
                     face({"/usr/share/fonts/truetype/noto/NotoSansMath-Regular.ttf"}),
                     face({"/usr/share/fonts/truetype/noto/NotoSansSymbols2-Regular.ttf"})};
    return paths;
}

// What ships and can be read; a broken file is left out here and says why when it is opened by name.
std::vector<CatalogueEntry> read_catalogue() {
    std::vector<CatalogueEntry> catalogue;
    for (const auto& path : shipped_exercises())
        if (const auto exercise = load_exercise(path))
            catalogue.push_back({path.stem().string(), path.string(), exercise->title, "", exercise->number});
    for (const auto& path : shipped_scenes())
        if (const auto scene = load_scene(path))
            catalogue.push_back({path.stem().string(), path.string(), scene->title, scene->story});
    return catalogue;
}

// The language that is spoken, and where the others lie.
struct Words {
    std::filesystem::path folder;
    std::string language;
    Strings strings;
};

// The language asked for; else the system's, if the lab speaks it; else English.
Result<Words> choose_words(const std::filesystem::path& folder, const std::string& asked) {
    std::string code = asked;
    if (code.empty()) {
        const std::string local = system_language();
        const auto spoken = languages(folder);
        const auto same = [&](const Language& l) { return l.code == local; };
        code = std::any_of(spoken.begin(), spoken.end(), same) ? local : "en";
    }
    auto strings = load_language(folder, code);
    if (!strings) return strings.error();
    return Words{folder, code, std::move(*strings)};
}

// Everything that lives as long as the window is open.
class App {
public:
    App(Options options, Lab lab, Window window, Renderer renderer, Words words)
        : options_(std::move(options)),
          lab_(std::move(lab)),
          window_(std::move(window)),
          renderer_(std::move(renderer)),
          words_(std::move(words)),
          catalogue_(read_catalogue()),
          anchors_file_(options_.anchors),
          state_file_(options_.state) {
        lab_.theme = options_.theme;
        lab_.language = words_.language;
        lab_.camera.mode = options_.camera;
        scale_ = options_.scale.value_or(window_.content_scale());
        apply_theme(lab_.theme, scale_);
        LoadedFonts loaded = load_fonts(*ImGui::GetIO().Fonts, scale_, find_fonts());
        fonts_ = loaded.fonts;
        if (!loaded.warning.empty()) std::cerr << "braitenlab: " << loaded.warning << "\n";
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
            open_wanted();
            let_time_pass(passed);
            frame(static_cast<float>(passed));
            if (picture_is_due(seconds_since(began))) return take_picture(options_.screenshot);
            if (lab_.screenshot) take_picture_for_person();
            facts_.frame_ms = seconds_since(frame_began) * 1000;
            window_.show();
            write_reports();
            if (lab_.full_screen) lab_.full_screen = false, window_.toggle_full_screen();
            while (!repeatable() && seconds_since(frame_began) < frame_seconds)
                window_.poll(frame_seconds - seconds_since(frame_began));
        }
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
        sight_age_ += static_cast<float>(passed);
    }

    // What was dropped onto the window or chosen from the menu; the last one counts.
    void open_wanted() {
        for (const std::string& path : window_.take_dropped_files()) lab_.open = path;
        if (lab_.open.empty()) return;
        auto opened = open_lab(std::exchange(lab_.open, {}), std::nullopt, {});
        if (opened)
            replace_lab(std::move(*opened));
        else
            refuse(opened.error());
    }

    void refuse(const Error& error) {
        lab_.notice = error.text();
        lab_.notice_until = lab_.wall_seconds + 10;
    }

    // The words of the language that was asked for last; one that cannot be read leaves the words as they are.
    void speak_wanted() {
        if (lab_.language == words_.language) return;
        auto strings = load_language(words_.folder, lab_.language);
        if (strings)
            words_.strings = std::move(*strings), words_.language = lab_.language;
        else
            lab_.language = words_.language, refuse(strings.error());
    }

    void replace_lab(Lab next) {
        next.theme = lab_.theme;
        next.language = lab_.language;
        next.sensors = lab_.sensors;
        next.outlines = lab_.outlines;
        next.wall_seconds = lab_.wall_seconds;
        lab_ = std::move(next);
    }

    void frame(float passed) {
        if (lab_.theme_changed) lab_.theme_changed = false, apply_theme(lab_.theme, scale_);
        speak_wanted();
        window_.begin_frame();
        LabView view = view_of(lab_);
        view.catalogue = &catalogue_;
        const Rect area = window_.area();
        const WindowLayout layout = lay_out(area.w, area.h, scale_, view);
        outbox_.clear();
        bool arrows_are_free = true;
        for (const KeyPress press : window_.take_keys()) arrows_are_free &= !press_key(view, panels_, press, outbox_);

        anchors_.begin();
        Ui ui{.strings = words_.strings,
              .palette = palette(lab_.theme),
              .fonts = fonts_,
              .scale = scale_,
              .anchors = anchors_,
              .outbox = outbox_,
              .highlight = next_prompt(view),
              .pulse = pulse(view)};
        draw_window(view, panels_, ui, layout);

        const VehicleView* followed =
            rides(lab_.camera.mode) ? find_vehicle(lab_.session.snapshot(), lab_.selected) : nullptr;
        aim(followed, area, layout.scene, passed);
        drive_viewport(lab_, viewport_, sight_, arrows_are_free && panels_.keyboard.focus.empty() ? arrows() : Arrows{},
                       passed);
        draw_scene();
        window_.bind();
        window_.end_frame();
        for (const Request& request : outbox_) handle(lab_, request);
    }

    Arrows arrows() const {
        if (ImGui::GetIO().WantTextInput) return {};
        const auto held = [this](int glfw_key) { return window_.holds(glfw_key) ? 1.0f : 0.0f; };
        return {held(key::right) - held(key::left), held(key::up) - held(key::down)};
    }

    // Where the camera looks from; a change of camera is a short glide, everything else follows at once.
    void aim(const VehicleView* followed, const Rect& area, const Rect& free_area, float passed) {
        const Sight wanted = look(lab_.camera, lab_.session.scene().arena, followed, area, free_area);
        if (lab_.camera.mode != last_camera_mode_ || lab_.selected != last_followed_) sight_age_ = 0;
        last_camera_mode_ = lab_.camera.mode;
        last_followed_ = lab_.selected;
        constexpr float glide_seconds = 0.6f;
        sight_ = has_sight_ && sight_age_ < glide_seconds && sight_.window == wanted.window
                     ? glide(sight_, wanted, passed)
                     : wanted;
        has_sight_ = true;
    }

    void draw_scene() {
        // Framebuffer pixels, of which a display of high density has more than one per window pixel.
        const float density = static_cast<float>(window_.framebuffer_width()) / std::max(1.0f, window_.area().w);
        Picture picture;
        picture.sight = sight_;
        picture.sight.window = {0, 0, static_cast<float>(window_.framebuffer_width()),
                                static_cast<float>(window_.framebuffer_height())};
        picture.theme = lab_.theme;
        picture.selected = lab_.selected;
        picture.hovered = viewport_.hovered.vehicle;
        picture.driver = lab_.camera.mode == CameraMode::driver ? lab_.selected : no_vehicle;
        picture.sensors = lab_.sensors;
        picture.outlines = lab_.outlines;
        picture.pixel_scale = density * scale_;
        shown_ = lab_.session.snapshot();
        if (!repeatable()) stand_between(shown_, lab_.before, between_ticks(lab_));
        renderer_.draw(shown_, picture);
        facts_.draw_calls = renderer_.draw_calls();
    }

    int take_picture(const std::filesystem::path& path) {
        if (auto error = write_png(path, window_.framebuffer_width(), window_.framebuffer_height(), window_.pixels()))
            return complain(*error);
        return 0;
    }

    void take_picture_for_person() {
        lab_.screenshot = false;
        const auto path = next_screenshot_name(std::filesystem::current_path());
        if (auto error = write_png(path, window_.framebuffer_width(), window_.framebuffer_height(), window_.pixels()))
            return refuse(*error);
        lab_.notice = path.string();
        lab_.notice_until = lab_.wall_seconds + 6;
    }

    void write_reports() {
        if (anchors_file_.wanted())
            if (auto error = anchors_file_.write(anchors_json(anchors_))) complain(*error);
        constexpr double state_period = 0.05;
        if (!state_file_.wanted() || seconds_since(state_written_) < state_period) return;
        state_written_ = Clock::now();
        if (auto error = state_file_.write(state_json(lab_, facts_))) complain(*error);
    }

    Options options_;
    Lab lab_;
    Window window_;
    Renderer renderer_;
    Words words_;
    std::vector<CatalogueEntry> catalogue_;
    Fonts fonts_;
    float scale_ = 1;
    PanelState panels_;
    ViewportState viewport_;
    Anchors anchors_;
    Outbox outbox_;
    Snapshot shown_;  // what is drawn: the moment between the last two ticks
    Sight sight_;
    bool has_sight_ = false;
    float sight_age_ = 1e9f;
    CameraMode last_camera_mode_ = CameraMode::overview;
    VehicleId last_followed_ = no_vehicle;
    FrameFacts facts_;
    KeptFile anchors_file_, state_file_;
    Clock::time_point state_written_{};
};

int open_and_run(const Options& options) {
    const auto data = data_folder();
    if (!data) return complain(data.error());
    const auto path = find_shipped(options.file.empty() ? first_exercise : options.file);
    if (!path) return complain(path.error());
    auto lab = open_lab(*path, options.seed, options.settings);
    if (!lab) return complain(lab.error());
    auto words = choose_words(*data / "ui" / "strings", options.language);
    if (!words) return complain(words.error());
    auto window = Window::open({.title = "Braitenlab",
                                .width = options.width,
                                .height = options.height,
                                .full_screen = options.full_screen,
                                .smooth_in_software = !options.screenshot.empty()});
    if (!window) return complain(window.error());
    auto renderer = Renderer::create(*data / "shaders", options.sectors);
    if (!renderer) return complain(renderer.error());
    return App(options, std::move(*lab), std::move(*window), std::move(*renderer), std::move(*words)).run();
}

}  // namespace

}  // namespace braitenlab

int main(int argc, char** argv) {
    const auto line = braitenlab::read_command_line(argc, argv);
    return line.exit_code ? *line.exit_code : braitenlab::open_and_run(line.options);
}
