// The state of a running window for scripts and tests: widget rectangles and lab state, as JSON files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/lab.h"
#include "render/view/picture.h"
#include "ui/scene_input/scene_input.h"
#include "ui/widgets/anchors.h"
#include "ui/widgets/drawn_text.h"

namespace braitenlab {

// {"slider.LL": [x, y, w, h], …} in window pixels.
std::string anchors_json(const ui::Anchors&);

struct FrameFacts {
    std::string focus;                        // anchor of the widget with the keyboard focus; empty: the viewport
    std::string menu;                         // name of the open menu of the menu bar; empty: none
    std::string typed;                        // text so far in the focused text field or number
    std::vector<std::string> probes, strips;  // names of the signals beside nodes of the diagram, and on the chart
    int draw_calls = 0;
    Quality quality = Quality::medium;  // of the last picture
    float resolution = 1;               // of the last picture, pixels drawn per pixel of the window
    ui::TextFacts text;                 // of the window, without the labels in the scene
    bool graphics_watched = false;
    int graphics_errors = 0;  // see Window
    CameraView camera_view;   // camera view of the frame
    bool hand = false;        // the mouse cursor is a hand: a drag would move an object
    double frame_ms = 0;      // duration of a frame, without waiting for the display
    int frames = 0;           // so far
    int pictures = 0;         // drawn so far: a frame that is equal to the last picture is not
    maths::vec2 pointer;      // as the frame saw it, window pixels; (-1, -1): outside
    int pressed = 0;          // mouse button held: 1 left, 2 middle, 3 right; 0: none
};

// {mode, tick, seconds, hash, time_scale, selected, character, weights {LL …}, thresholds {LL …}, lesions, driver,
// motor [left, right], sensor_ranges [..], nodes, wires, toggles, undo_depth, redo_depth, population, predators, prey,
// generation, camera, language, focus, menu, typed, probes [names], strips [names], overlays {…}, draw_calls,
// quality, resolution, text {smallest_px, clipped}, graphics_watched, graphics_errors, frame_ms, frames, pictures,
// pointer [x, y], pressed, exercise, student {name, students, passed, exercises}, breeding {generation, running, cell
// [predator, prey], panel {predator, prey}}, thing {kind, index}, hovered {kind, index, handle}, cursor, tool, corners,
// vehicles, sources, obstacles}. The last three are lists of at most 64; `at` is the position in the window in pixels,
// or null behind the camera. `probes` (of the diagram) and `strips` (on the chart's tab "Chosen") may have names that
// the selected vehicle lacks.
std::string state_json(const Lab&, const ui::SceneInputState&, const FrameFacts&);

// A file that is replaced as a whole when its text changes, so that a reader always gets a complete file. The first
// error is returned once; nothing is written after it.
class ReportFile {
public:
    explicit ReportFile(std::filesystem::path path) : path_(std::move(path)) {}
    bool wanted() const { return !path_.empty(); }
    std::optional<Error> write(std::string text);

private:
    std::filesystem::path path_;
    std::string last_;
    bool failed_ = false;
};

}  // namespace braitenlab
