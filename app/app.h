// The program with a window. Each turn advances time, draws a frame and executes the user's requests.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "app/applied_theme.h"
#include "app/files/autosave.h"
#include "app/files/breeding_files.h"
#include "app/files/data.h"
#include "app/files/settings.h"
#include "app/files/student_files.h"
#include "app/files/study_files.h"
#include "app/gallery.h"
#include "app/jobs/jobs.h"
#include "app/lab.h"
#include "app/options.h"
#include "app/pictures/clip.h"
#include "app/report_state.h"
#include "app/viewport.h"
#include "app/window.h"
#include "app/words.h"
#include "render/gl/offscreen.h"
#include "render/gl/renderer.h"
#include "render/view/quality.h"
#include "ui/window.h"

namespace braitenlab {

// Prints the error to stderr. Returns 2, the exit code for bad input.
int complain(const Error&);

// Until the layout is settled: it follows the cards and the heights of their text in the frame before.
inline constexpr int frames_of_layout = 4;
inline constexpr float label_em = 14;  // layout pixels, letters of the scene's labels

// Wall seconds from `then` until now.
double seconds_since(std::chrono::steady_clock::time_point then);

class App {
public:
    App(Options, Lab, Window, render::Renderer, Words, Settings);

    // One iteration of the main loop. Returns false when the program has ended: the user has closed it, the system has
    // told it to end, or the picture of --screenshot or the clip of --clip is written. Precondition: turn() has not
    // returned false before.
    bool turn();

    // The exit code: 0, or 2 if the picture or the clip could not be written. Valid after turn() has returned
    // false.
    int exit_code() const { return exit_code_; }

    // Keeps the framebuffer into which the window is redirected; nullopt: it is not.
    void draw_into(std::optional<render::Offscreen> canvas) { canvas_ = std::move(canvas); }

    // Saves the settings, and the work for the next start. For a page, which may end without a further call.
    void keep_work();

    // Background jobs between two turns, for a page; see work_between_turns().
    bool work() { return jobs_.work(std::chrono::milliseconds(12)); }

    // What --state and --anchors write (app/report_state.h), as JSON.
    std::string state_text() const;
    std::string anchors_text() const;

private:
    using Clock = std::chrono::steady_clock;

    // ── The main loop, app.cpp ──
    // Shows the name of the program until the first frame is drawn.
    void show_name();
    // Opens the lecture or the lecture view of the command line.
    void begin_asked_lecture();
    // Collects events. True if the program can end now; asked more than once in a turn, so that a window disappears
    // soon. If there are unsaved edits, opens the sheet about them; the answer is a request.
    bool ends();
    // Hides the window, then saves what is needed at the end of the program.
    void close();
    void let_time_pass(double passed);
    // Delivers the results of background jobs.
    void follow_jobs();
    // Executes the requests from dropped files, the file browser and recovery.
    void handle_files();
    // Opens or discards the recovered work. The file of the crashed lab is removed after the work is saved again.
    void handle_recovery(bool take);
    void show_error(const Error& error);
    // Shows the errors of the start one after the other, the last one first.
    void show_errors_of_start();
    // Writes settings that have changed; at most once per second unless `now`.
    void save_settings(bool now);
    // True if the picture changes without input, or if there was input in this turn.
    bool moves() const;
    // True for --screenshot with --play: one tick per frame, so that the picture does not depend on wall time.
    bool repeatable() const;
    bool picture_is_due(double wall_seconds) const;
    // False for frames of --screenshot that cannot be its picture: they have the layout only.
    bool draws_scene() const;
    void write_reports();

    // ── A frame, app_frame.cpp ──
    // Window pixels per layout pixel. --scale applies to the type size at the start of the program.
    float wanted_scale() const;
    float unlimited_scale() const;              // as if the window were large enough
    float largest_type_size_of_window() const;  // for which it has room
    // The same outside a lecture, before it is reduced for a small window.
    float preferred_scale() const;
    // The type size in effect, if the window is too small for the preferred one; else 0.
    float reduced_type_size() const;
    // Applies language, theme and scale. Call between frames.
    void follow_preferences();
    // Loads the font of the scene's labels at the size of the window's small type.
    void load_label_font();
    // Reloads changed shaders, at most twice per second. A broken shader is reported, and the previous one stays in
    // use.
    void follow_shaders();
    LabView whole_view();  // what the panels see of the lab, of the files and of the program
    void frame(float passed);
    CameraKeys camera_keys(bool arrows_are_free) const;
    // Returns false if the last picture stays. `hidden_brains`: by kind.
    bool draw_scene(std::vector<bool> hidden_brains);
    // True if the last picture has the same widgets and is still in the window. Call once per frame.
    bool may_stay();
    // The lab whose scene is shown: behind the title page another one.
    const Lab& shown_lab() const { return title_ ? *title_ : lab_; }
    // Makes one picture of the file browser while it is open.
    void make_pictures();
    // Leaves the title page.
    void begin();
    void tell_what_is_off();
    // Draws with the level of quality that was asked for, or the measured one; measures some frames. Returns false if
    // the last picture stays.
    bool draw_measured(Picture);
    Quality quality() const;
    float resolution() const;
    // What the scene shows, without a camera view.
    Picture scene_picture(std::vector<bool> hidden_brains) const;
    // Of the last frame, window pixels; empty outside a lecture.
    std::vector<Rect> cards_of_lecture() const;

    // ── Pictures and clips, app_pictures.cpp ──
    std::optional<Error> write_picture(const std::filesystem::path&);
    // Writes a picture to the user's folder of pictures.
    void take_screenshot();
    // The scene without cards in a picture of this size.
    SceneLook scene_look(int width, int height) const;
    // The characters of labels in such a picture.
    render::Lettering lettering_of(const SceneLook&) const;
    // Executes the request of the sheet for pictures and clips, and works on the clip.
    void follow_take_away();
    std::optional<Error> take(const TakeAway&, const std::filesystem::path&);
    std::optional<Error> write_scene(const std::filesystem::path&, int width, int height);
    // Draws the whole window anew at another size, with the sheet closed.
    std::optional<Error> write_window(const std::filesystem::path&, int width, int height);
    std::optional<Error> begin_clip(const TakeAway&, const std::filesystem::path&);
    // Writes the clip of the command line.
    std::optional<Error> write_clip(const Options&);

    // Moments of the last time.
    struct Times {
        Clock::time_point began = Clock::now();  // end of the constructor
        Clock::time_point turn = began, settings_saved = began, file_checked = began, shaders_checked = began;
        Clock::time_point change = began;  // see idle_wait()
    };

    // What ships with the program.
    struct Shipped {
        std::vector<CatalogueEntry> scenes = read_catalogue(), lectures = read_lecture_catalogue();
        std::vector<insight::Study> studies = shipped_study_list();
        std::vector<evolve::Breeding> breedings = shipped_breeding_list();
    };

    // What the last frame has drawn and found.
    struct Frame {
        ui::Anchors anchors, anchors_before;  // of this frame, and of the last one before it that was shown
        std::vector<ui::Written> written;     // texts, recorded for the file of the state only
        Outbox outbox;
        std::vector<Rect> opaque;  // see Ui::opaque
        Snapshot shown;            // interpolated between the last two ticks
        bool got_input = false;
        bool held_back = false;                  // it was not shown, because a card or a sheet had the wrong height
        bool is_drawn = false;                   // it was neither held back nor equal to the last picture
        std::optional<std::uint64_t> widgets{};  // hash of those in the last picture; nullopt: not compared
        bool makes_pictures = false;             // of the gallery
        float magnified = 1;                     // factor on the scale, while the window is drawn at another size
        bool reported_label_font = false;
        // Document::run_id, lecture and language whose texts leave_own_texts() has got.
        std::tuple<std::uint64_t, const Lecture*, std::string> open{};
    };

    // With --state and --anchors.
    struct Reports {
        ReportFile anchors, state;
        Clock::time_point state_written{};
    };

    // With --quality auto.
    struct MeasuredQuality {
        QualityChoice choice;
        std::string of{};  // name of the document that it was measured for
    };

    Options options_;
    Jobs jobs_;
    Lab lab_;
    Window window_;
    render::Renderer renderer_;
    std::optional<render::Offscreen> canvas_;  // with --screenshot and --clip
    Words words_;
    Settings settings_;
    UserFolders folders_;
    Autosave autosave_;
    StudentFiles student_files_;
    Shipped shipped_;
    Times times_;
    int exit_code_ = 0;
    AppliedTheme theme_;
    FilesView files_;
    ui::PanelState panels_;
    ViewportState viewport_;
    Frame frame_;
    FrameFacts facts_;
    Reports reports_;
    Gallery gallery_;
    std::optional<Clip> clip_;  // being written
    std::optional<Lab> title_;  // the scene behind the title page, while it is shown
    MeasuredQuality quality_{QualityChoice(options_.graphics.first_quality)};
};

}  // namespace braitenlab
