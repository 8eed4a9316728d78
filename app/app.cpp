#include "app/app.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include <imgui.h>

#include "app/course/exercise_check.h"
#include "app/course/lab_children.h"
#include "app/course/lab_lecture.h"
#include "app/course/lab_lesson.h"
#include "app/course/lab_progress.h"
#include "app/course/notes_page.h"
#include "app/course/reference_runs.h"
#include "app/files/file_commands.h"
#include "app/files/reports.h"
#include "app/frame_pacing.h"
#include "app/lab_requests.h"
#include "app/platform/page.h"
#include "app/platform/platform.h"
#include "app/playback.h"
#include "app/remembered.h"
#include "app/terminal.h"
#include "app/title.h"
#include "render/view/trails.h"
#include "ui/imgui_compat.h"
#include "ui/widgets/theme.h"

namespace braitenlab {

namespace {

constexpr double frame_seconds = 1.0 / 60;

}  // namespace

double seconds_since(std::chrono::steady_clock::time_point then) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

int complain(const Error& error) {
    std::cerr << "braitenlab: " << one_line(error.text()) << "\n";
    return 2;
}

App::App(Options options, Lab lab, Window window, render::Renderer renderer, Words words, Settings settings)
    : options_(std::move(options)),
      lab_(std::move(lab)),
      window_(std::move(window)),
      renderer_(std::move(renderer)),
      words_(std::move(words)),
      settings_(std::move(settings)),
      folders_(user_folders()),
      autosave_(
          !options_.only_draws() && !folders_.state.empty() ? folders_.state / "autosave" : std::filesystem::path{},
          settings_.errors),
      student_files_(!options_.only_draws() && !folders_.state.empty() ? folders_.state / "students"
                                                                       : std::filesystem::path{}),
      reports_{ReportFile(options_.anchors), ReportFile(options_.state)},
      gallery_(options_.only_draws() ? std::filesystem::path{} : folders_.cache) {
    lab_.preferences = settings_.at_start;
    if (is_on_page()) leave_keys_to_browser();
    lab_.link_base = is_on_page() ? page_address() : lab_.preferences.link_base;
    restore_view(lab_, panels_, settings_.state.view);
    if (options_.camera) lab_.view.camera.mode = *options_.camera;
    lab_.view.overlays.field = options_.field;
    begin_asked_lecture();
    if (options_.title) title_ = title_lab([this](const Snapshot& now) { renderer_.remember(now); });
    theme_.apply(lab_.preferences.theme, wanted_scale());
    load_label_font();
    if (!theme_.warning().empty()) std::cerr << "braitenlab: " << theme_.warning() << "\n";
    if (!options_.only_draws() && !folders_.state.empty()) {
        begin_studies(lab_.study, folders_.state / "studies", settings_.state.study);
        if (is_on_page()) lab_.breeding.most_bytes = 1U << 20U;  // a browser keeps about 5 MB, edits and notes included
        begin_breedings(lab_.breeding, folders_.state / "breedings", settings_.state.breeding);
    }
    const std::vector<Error> errors = student_files_.read(lab_.students, settings_.state.student);
    settings_.errors.insert(settings_.errors.begin(), errors.begin(), errors.end());
    refresh(files_, lab_);
    if (options_.play) handle(lab_, Action::play_pause);
    if (!options_.only_draws() && !title_ && !lab_.before_lecture) tell_what_is_off();
    if (!options_.only_draws() && !is_on_page()) show_name();
    times_.began = times_.turn = Clock::now();
}

void App::show_name() {
    constexpr const char* name = "Braitenlab";
    window_.begin_frame({});
    const Rect area = window_.area();
    const Palette colours = palette(lab_.preferences.theme);
    ImFont* large = theme_.fonts().display;
    ImFont* font = large ? large : ImGui::GetFont();
    const float height = compat::size_of(font), width = font->CalcTextSizeA(height, area.w, 0, name).x;
    ImGui::GetForegroundDrawList()->AddText(font, height, {(area.w - width) / 2, (area.h - height) / 2},
                                            ui::paint(colours.text), name);
    ImGui::Render();
    window_.fill(colours.sky);
    window_.draw_widgets();
    window_.show();
}

void App::begin_asked_lecture() {
    if (options_.pages) {
        open_lecture(lab_, options_.pages);
        show_page(lab_, options_.page - 1, options_.revealed);
    } else if (options_.lecture) {
        handle(lab_, Action::lecture);
    }
}

bool App::turn() {
    const auto turn_began = Clock::now();
    double passed = std::chrono::duration<double>(turn_began - times_.turn).count();
    times_.turn = turn_began;
    if (repeatable()) passed = frame_seconds;
    if (ends()) return close(), false;
    handle_files();
    lab_.dragging = ui::drags_vehicle(panels_, lab_.view.selection.vehicle);
    lab_.sheet_open = panels_.sheet != ui::Sheet::none || panels_.lecture.blank;
    autosave_.follow_ending_labs(seconds_since(times_.began), settings_.errors);
    let_requests_interrupt(true);
    let_time_pass(passed);
    let_requests_interrupt(false);
    if (ends()) return close(), false;
    follow_jobs();
    show_errors_of_start();
    frame(static_cast<float>(passed));
    if (ends()) return close(), false;
    if (picture_is_due(seconds_since(times_.began))) {
        if (const auto error = write_picture(options_.screenshot)) exit_code_ = complain(*error);
        return false;
    }
    if (!options_.clip.file.empty()) {
        if (const auto error = write_clip(options_)) exit_code_ = complain(*error);
        return false;
    }
    if (lab_.window.screenshot && frame_.is_drawn) take_screenshot();
    follow_take_away();
    facts_.frame_ms = seconds_since(turn_began) * 1000;
    if (!repeatable() && frame_.is_drawn) window_.show();
    if (!frame_.held_back) write_reports();  // they describe what is shown
    follow_notes_page(lab_, words_.strings, words_.language, folders_.state);
    save_settings(false);
    if (const auto error = autosave_.keep(lab_, lab_.wall_seconds)) show_error(*error);
    if (!lab_.window.to_copy.empty()) ImGui::SetClipboardText(std::exchange(lab_.window.to_copy, {}).c_str());
    if (std::exchange(lab_.window.uploads, false)) choose_files();
    if (lab_.window.full_screen) lab_.window.full_screen = false, window_.toggle_full_screen();
    if (repeatable()) return true;
    const int rate = window_.refresh_rate();
    window_.rest(pause_after_swap(seconds_since(turn_began), rate, options_.graphics.frame_rate));
    if (moves() || frame_.held_back) times_.change = Clock::now();
    if (!options_.only_draws()) window_.poll(idle_wait(seconds_since(times_.change)));
    return true;
}

void App::keep_work() {
    save_settings(true);
    autosave_.keep(lab_, lab_.wall_seconds, Autosave::Occasion::end);  // offered at the next start
}

void App::close() {
    if (!options_.only_draws()) window_.hide();
    if (is_told_to_end()) {
        end_comparison(lab_.slots, lab_);  // the student's own brain is kept
        keep_work();
        clip_.reset();  // removes its incomplete file
        // The other destructors wait for background jobs, which can take seconds.
        std::_Exit(exit_code_);
    }
    save_settings(true);
    autosave_.finish();
}

bool App::ends() {
    window_.poll(0);
    if (is_told_to_end()) return true;
    if (!lab_.window.exit && !window_.close_requested()) return false;
    if (may_leave(lab_, files_)) return true;
    lab_.window.exit = false;
    window_.refuse_close();
    return false;
}

void App::let_time_pass(double passed) {
    if (title_) {
        title_->preferences = lab_.preferences;
        advance_title(*title_, static_cast<float>(std::min(passed, 0.25)));
    }
    if (repeatable()) {
        lab_.wall_seconds += passed;
        tick(lab_);
    } else {
        // A frame of a fast run has many ticks; a trail of one point a frame would have corners.
        advance(lab_, std::min(passed, 0.25), [this](const Snapshot& now) {
            if (now.tick % render::Trail::ticks_between == 0) renderer_.remember(now);
        });
    }
}

void App::follow_jobs() {
    const auto update = [this] {
        update_grading(lab_, jobs_);
        update_gains(lab_, jobs_);
        update_exercise_check(lab_, jobs_);
        update_reference_runs(lab_, jobs_);
        update_children(lab_, jobs_);
        update_features(lab_, jobs_);
    };
    constexpr std::chrono::milliseconds budget{4};  // of a frame, without threads
    if (repeatable())
        update(), jobs_.finish();
    else
        jobs_.deliver(budget);
    update();
    follow_progress(lab_);
}

void App::handle_files() {
    if (panels_.sheet != ui::Sheet::recovery)  // a file dropped there waits for the answer
        for (const std::string& path : window_.take_dropped_files())
            lab_.window.files.push_back(OpenRequest{path, true});
    for (const Request& request : lab_.window.files)
        if (const auto* recover = std::get_if<RecoverRequest>(&request)) handle_recovery(recover->take);
    if (!lab_.window.files.empty()) execute_file_requests(lab_, files_, settings_.state, folders_);
    write_report_files(lab_, words_.strings, folders_.documents, std::chrono::system_clock::now());
    for (const auto& file : std::exchange(lab_.window.saved, {})) autosave_.forget_work_on(file);
    if (options_.only_draws() || seconds_since(times_.file_checked) < 0.3) return;
    times_.file_checked = Clock::now();
    follow_file(lab_, files_);
}

void App::handle_recovery(bool take) {
    if (!take) return autosave_.forget();
    auto recovered = autosave_.recover();
    if (!recovered) return autosave_.set_aside(), show_error(recovered.error());
    recovered->edits = 1;
    leave_pages(lab_);  // on a page of a lecture nothing is kept for recovery
    replace_document(lab_, std::move(*recovered));
    refresh(files_, lab_);
    const auto error = autosave_.keep(lab_, lab_.wall_seconds, Autosave::Occasion::now);
    if (error) return show_error(*error);
    autosave_.offer_no_more();  // the work that is now open would make room
    autosave_.forget();
}

void App::show_error(const Error& error) { say(lab_, error); }

void App::show_errors_of_start() {
    if (!lab_.notice.empty() || settings_.errors.empty()) return;
    show_error(settings_.errors.back());
    settings_.errors.pop_back();
}

void App::save_settings(bool now) {
    if (options_.only_draws() || (!now && seconds_since(times_.settings_saved) < 1)) return;
    times_.settings_saved = Clock::now();
    follow_progress(lab_);  // notes of this frame
    const StudentFiles::Written written = student_files_.write(lab_.students);
    if (written.failed) show_error(*written.failed);
    if (written.merged) lab_.progress_of.reset();  // the notes are read again
    settings_.state.student = student_files_.current_file(lab_.students);
    settings_.state.study = lab_.study.last;
    settings_.state.breeding = lab_.breeding.last;
    settings_.state.view = view_to_store(lab_, panels_);
    if (const auto place = window_.windowed_place()) settings_.state.place = WindowPlace{place->first, place->second};
    if (const auto error = save(settings_, own_preferences(lab_), window_.windowed_size())) show_error(*error);
}

bool App::moves() const {
    const auto& lesson = lab_.document.lesson;
    const bool plays = lab_.playback.mode == Mode::playing && !lab_.sheet_open;
    const bool orbits = (lab_.view.orbits || title_) && !lab_.preferences.reduce_motion;
    const bool predicts = is_computing(lab_.predictions);
    const bool shows_duels = panels_.sheet == ui::Sheet::breeding && lab_.breeding.duels.answer();
    return frame_.got_input || plays || orbits || predicts || lab_.playback.seeks || is_computing(lab_.map) ||
           is_computing(lab_.robots) || is_computing(lab_.slots) || is_computing(lab_.mystery) || lab_.study.runs ||
           is_computing(lab_.breeding) || shows_duels || frame_.makes_pictures || clip_ ||
           (lesson && lesson->grading) || !lab_.window.files.empty();
}

bool App::repeatable() const { return !options_.screenshot.empty() && options_.play; }

bool App::picture_is_due(double wall_seconds) const {
    if (options_.screenshot.empty()) return false;
    if (repeatable()) return lab_.document.session.snapshot().seconds >= options_.after - 1e-9;
    return facts_.frames >= frames_of_layout && wall_seconds >= options_.after;
}

bool App::draws_scene() const {
    if (repeatable()) return picture_is_due(0);
    return options_.screenshot.empty() || facts_.frames + 1 >= frames_of_layout;
}

std::string App::anchors_text() const {
    return anchors_json(frame_.held_back ? frame_.anchors_before : frame_.anchors);
}
std::string App::state_text() const { return state_json(lab_, panels_.scene_input, facts_); }

void App::write_reports() {
    if (reports_.anchors.wanted())
        if (auto error = reports_.anchors.write(anchors_text())) complain(*error);
    constexpr double state_period = 0.02;
    if (!reports_.state.wanted() || seconds_since(reports_.state_written) < state_period) return;
    reports_.state_written = Clock::now();
    if (auto error = reports_.state.write(state_text())) complain(*error);
}

}  // namespace braitenlab
