// What scripts and tests read of a running window: the widgets' rectangles and the lab's state, as JSON files.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "app/lab.h"
#include "ui/stage/stage.h"
#include "ui/widgets/anchors.h"

namespace braitenlab {

// {"slider.LL": [x, y, w, h], …} in window pixels.
std::string anchors_json(const Anchors&);

struct FrameFacts {
    std::string focus;  // the anchor that has the keyboard; empty: the viewport
    std::string typed;  // so far, in the text field or number that has the cursor
    int draw_calls = 0;
    bool graphics_watched = false;
    int graphics_errors = 0;  // see Window
    Sight sight;              // by which the scene was drawn
    bool hand = false;        // the mouse cursor says that something can be taken
    double frame_ms = 0;      // work of a frame, without waiting for the display
};

// {mode, tick, seconds, hash, time_scale, selected, character, weights {LL …}, thresholds {LL …}, lesions, driver,
// motor [left, right], sensor_ranges [..], nodes, wires, toggles, undo_depth, redo_depth, population, predators, prey,
// generation, camera, language, focus, typed, overlays {…}, draw_calls, graphics_watched, graphics_errors, frame_ms,
// exercise, thing {kind, index}, hovered {kind, index, handle}, cursor, tool, corners, vehicles, sources, obstacles};
// the last three hold values and, as `at`, where each stands in the window, px, or null behind the eye. The first 64
// alone.
std::string state_json(const Lab&, const StageState&, const FrameFacts&);

// Keeps one file up to date: writes beside it and renames, so that a reader never sees half a file; leaves it alone
// while the text stays the same. The first failure is returned, once.
class KeptFile {
public:
    explicit KeptFile(std::filesystem::path path) : path_(std::move(path)) {}
    bool wanted() const { return !path_.empty(); }
    std::optional<Error> write(std::string text);

private:
    std::filesystem::path path_;
    std::string last_;
    bool failed_ = false;
};

}  // namespace braitenlab
