// What the rows of ui/actions.def mean for the panels: place in a menu, condition, switch and effect of an action.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"

namespace braitenlab::ui {

// The menus of the menu bar, in its order; none: the action is in no menu.
enum class Menu { none, file, edit, view, simulation, exercises, lecture, help };

struct MenuPlace {
    Menu menu = Menu::none;
    int section = 0, row = 0;  // 0-based; rows with the same number are in the order of the table
    bool stays_open = false;   // the menu stays open after a click
};

// An action that is executed. `press` is empty if it was chosen with the pointer.
struct Acting {
    const LabView& view;
    PanelState& state;
    KeyPress press;
    Outbox& outbox;
};

struct ActionTraits {
    MenuPlace menu{};
    std::string_view (*why_not)(const LabView&, const PanelState&) = nullptr;
    bool (*is_on)(const LabView&, const PanelState&) = nullptr;
    bool (*act)(const Acting&) = nullptr;
};

const ActionTraits& traits(Action);

// The actions of a menu, in the order of its rows.
std::vector<Action> actions_in(Menu);

// The string key of the reason why the action cannot be executed now; empty if it can.
std::string_view why_unavailable(const LabView&, const PanelState&, Action);

// Whether the action is a switch that is on; nullopt for other actions.
std::optional<bool> switched_on(const LabView&, const PanelState&, Action);

// True while the wiring diagram is beside or below the scene.
bool watches_diagram(const LabView&, const PanelState&);

// Executes what the action does to the panels. False for an action of the lab.
bool act_on_panels(const Acting&, Action);

// The shipped scene that Action::new_scene opens; null when it is missing.
const CatalogueEntry* empty_scene(const LabView&);

}  // namespace braitenlab::ui
