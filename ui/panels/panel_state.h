// What the panels remember between frames: folds, drags, the focus. Nothing of it is the lab's.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/brain/graph.h"
#include "core/world/command.h"
#include "ui/panels/energy_order.h"
#include "ui/panels/files_state.h"
#include "ui/panels/history.h"
#include "ui/panels/recognised.h"
#include "ui/preferences.h"
#include "ui/prompts.h"
#include "ui/scene_input/scene_input.h"
#include "ui/widgets/card.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/sheet.h"
#include "ui/widgets/slider.h"
#include "ui/wiring/canvas.h"

namespace braitenlab {

// The large pictures: one at a time.
enum class Chart { signals, population, energy, bars };

// What lies over the whole window: at most one.
enum class Sheet { none, keys, settings, files, recovery, leaving };

// What a lecture folds away, to come back exactly.
struct BeforeLecture {
    std::array<CardState, 6> cards;  // those that it gives back as it found them (lecture.cpp)
    bool information_opened = false;
    std::string focus;
};

// A key to show to the audience.
struct PressedKey {
    KeyPress press;
    double at = 0;  // wall seconds
};

struct PanelState {
    CardState exercise, scene, brain, information, charts, thing;
    CardState sensors{.folded = true};
    SliderState sliders;
    Keyboard keyboard;
    wiring::CanvasState canvas;
    SceneInputState scene_input;
    Recognised recognised;
    History history;
    PromptMemory prompts;
    std::string lesion_under_pointer;  // the anchor of what a click or L would hurt or heal; empty: none
    std::string lesion_wanted;         // by key: the same, until the picture has seen it
    Steer steered;                     // by the stick, last
    bool stick_held = false;
    std::string sensor;                // by name: the one whose numbers the card shows
    bool sensor_channel_open = false;  // the choice of what it senses
    bool sensor_alone = false;         // edited without the one on the other side
    bool sensor_quality_open = false;  // noise and delay
    bool charts_open = false;
    Chart chart = Chart::signals;
    EnergyOrder energy_order;
    std::vector<std::size_t> energy_rows;  // in that order, of the snapshot's vehicles
    bool playhead_held = false;
    bool why_open = false;
    Sheet sheet = Sheet::none;
    SheetState keys, settings;
    SheetState recovery, leaving;
    bool recovery_asked = false;
    bool leaving_asked = false;
    int leaving_done = 0;  // FilesView::done when a name was asked for to save under
    FilesState files;
    std::optional<Preferences> before_reset;          // what Reset All took away, until something is chosen anew
    bool view_menu = false, focus_view_menu = false;  // what the scene shows, E
    bool presets_open = false, close_presets = false;
    bool outcome_told = false;   // of the exercise below: told once, it stays
    std::size_t hints_seen = 0;  // of the same, already scrolled to
    bool grade_seen = false;
    std::string exercise_id;
    bool information_opened = false;  // by hand: it then stays open in a low window
    std::optional<BeforeLecture> before_lecture;
    std::vector<PressedKey> pressed;  // in a lecture, the newest last
};

}  // namespace braitenlab
