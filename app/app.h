// The window and all that lives as long as it is open: once a frame it lets time pass, draws, and carries out what the
// person asked for.
#pragma once

#include <chrono>
#include <vector>

#include "app/autosave.h"
#include "app/catalogue.h"
#include "app/lab.h"
#include "app/look.h"
#include "app/memory.h"
#include "app/options.h"
#include "app/report_state.h"
#include "app/viewport.h"
#include "app/window.h"
#include "app/words.h"
#include "render/gl/renderer.h"
#include "ui/window.h"

namespace braitenlab {

// Says on stderr what is wrong; 2, the exit code for it.
int complain(const Error&);

// Wall seconds from `then` until now.
double seconds_since(std::chrono::steady_clock::time_point then);

class App {
public:
    App(Options, Lab, Window, Renderer, Words, Memory);

    // Until the person leaves, or the picture of --screenshot is taken; the exit code.
    int run();

private:
    using Clock = std::chrono::steady_clock;

    // ── From start to end, app.cpp ──
    // Unsaved edits are asked about first; the answer comes back as a request.
    bool ends();
    void let_time_pass(double passed);
    // What was dropped onto the window, and what was asked for in its browser.
    void do_what_files_ask();
    // What a crash left is forgotten only when it is on the disk again under this lab's name.
    void do_recovery(bool take);
    void refuse(const Error& error);
    // Once a second, and at the end, what has changed is written; where nothing has, nothing is.
    void keep_memory(bool now);
    // A picture of a run is taken after so many ticks, one a frame, so that it can be repeated.
    bool repeatable() const;
    bool picture_is_due(double wall_seconds) const;
    void write_reports();

    // ── A frame, app_frame.cpp ──
    // Window pixels per layout pixel. --scale says it for the type size that the session begins with.
    float wanted_scale() const;
    // Between two frames: language, theme and scale as they are wanted now.
    void follow_preferences();
    // Framebuffer pixels, of which a display of high density has more than one per window pixel.
    float density() const;
    // The scene's labels at the size of the window's small type.
    void letter_labels();
    // A shader that was saved while the lab runs is in use within half a second; a broken one is told and left.
    void follow_shaders();
    void frame(float passed);
    Arrows arrows() const;
    void draw_scene();
    int take_picture(const std::filesystem::path& path);
    void take_picture_for_person();

    Options options_;
    Lab lab_;
    Window window_;
    Renderer renderer_;
    Words words_;
    Memory memory_;
    Autosave autosave_;
    Clock::time_point memory_kept_ = Clock::now(), file_checked_ = Clock::now();
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

}  // namespace braitenlab
