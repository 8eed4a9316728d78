#include "app/app.h"

#include <algorithm>
#include <iostream>

#include "app/desk.h"
#include "app/platform.h"

namespace braitenlab {

namespace {

constexpr double frame_seconds = 1.0 / 60;

}  // namespace

double seconds_since(std::chrono::steady_clock::time_point then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

int complain(const Error& error) {
    std::cerr << "braitenlab: " << error.text() << "\n";
    return 2;
}

App::App(Options options, Lab lab, Window window, Renderer renderer, Words words, Memory memory)
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

int App::run() {
    const auto began = Clock::now();
    auto last = began;
    while (!ends()) {
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
        if (!repeatable()) window_.show();
        write_reports();
        keep_memory(false);
        if (const auto error = autosave_.keep(lab_, lab_.wall_seconds)) refuse(*error);
        if (lab_.full_screen) lab_.full_screen = false, window_.toggle_full_screen();
        while (!repeatable() && seconds_since(frame_began) < frame_seconds)
            window_.poll(frame_seconds - seconds_since(frame_began));
    }
    keep_memory(true);
    if (is_told_to_end())
        autosave_.keep(lab_, lab_.wall_seconds,
                       Autosave::Occasion::end);  // nobody could be asked: offered at next start
    else
        autosave_.finish();
    return 0;
}

bool App::ends() {
    if (is_told_to_end()) return true;
    if (!lab_.exit && !window_.close_requested()) return false;
    if (may_leave(lab_, files_)) return true;
    lab_.exit = false;
    window_.refuse_close();
    return false;
}

void App::let_time_pass(double passed) {
    if (repeatable()) {
        lab_.wall_seconds += passed;
        tick(lab_);
    } else {
        advance(lab_, std::min(passed, 0.25));
    }
}

void App::do_what_files_ask() {
    for (const std::string& path : window_.take_dropped_files()) lab_.files.push_back(OpenRequest{path, true});
    for (const Request& request : lab_.files)
        if (const auto* recover = std::get_if<RecoverRequest>(&request)) do_recovery(recover->take);
    if (!lab_.files.empty()) do_files(lab_, files_, memory_.remembered);
    if (!options_.screenshot.empty() || seconds_since(file_checked_) < 0.3) return;
    file_checked_ = Clock::now();
    follow_file(lab_, files_);
}

void App::do_recovery(bool take) {
    if (!take) return autosave_.forget();
    auto recovered = autosave_.recover();
    if (!recovered) return refuse(recovered.error());
    recovered->work = 1;
    replace_lab(lab_, std::move(*recovered));
    refresh(files_, lab_);
    const auto error = autosave_.keep(lab_, lab_.wall_seconds, Autosave::Occasion::now);
    error ? refuse(*error) : autosave_.forget();
}

void App::refuse(const Error& error) { say(lab_, {NoticeKind::failure, "", error.text()}); }

void App::keep_memory(bool now) {
    if (!options_.screenshot.empty() || (!now && seconds_since(memory_kept_) < 1)) return;
    memory_kept_ = Clock::now();
    if (const auto error = keep(memory_, desk_preferences(lab_), window_.windowed_size())) refuse(*error);
}

bool App::repeatable() const { return !options_.screenshot.empty() && options_.play; }

bool App::picture_is_due(double wall_seconds) const {
    if (options_.screenshot.empty()) return false;
    return (repeatable() ? lab_.session.snapshot().seconds : wall_seconds) >= options_.after - 1e-9;
}

void App::write_reports() {
    if (anchors_file_.wanted())
        if (auto error = anchors_file_.write(anchors_json(anchors_))) complain(*error);
    constexpr double state_period = 0.05;
    if (!state_file_.wanted() || seconds_since(state_written_) < state_period) return;
    state_written_ = Clock::now();
    if (auto error = state_file_.write(state_json(lab_, panels_.stage, facts_))) complain(*error);
}

}  // namespace braitenlab
