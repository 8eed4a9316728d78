#include "ui/panels/actions.h"

#include <algorithm>
#include <string>
#include <utility>

#include "ui/panels/panels.h"
#include "ui/scene_input/edits.h"
#include "ui/scene_input/under_pointer.h"

namespace braitenlab::ui {

namespace {

// ── Conditions: string keys of the reason, or empty ──

constexpr std::string_view nothing_selected = "unavailable.nothing_selected";

bool has_vehicle(const LabView& view) { return selected_vehicle(view) != nullptr; }

bool has_objects(const LabView& view) { return !objects_beside_vehicles(*view.now->scene).empty(); }

std::string_view nothing_to_copy(const LabView& view, const PanelState& state) {
    if (view.mode == Mode::wiring) return state.canvas.selection.nodes.empty() ? "wiring.refused.nothing_to_copy" : "";
    return place_of(*view.now, chosen(view)) ? "" : nothing_selected;
}

std::string_view nothing_to_paste(const LabView& view, const PanelState& state) {
    const bool has_copy = view.mode == Mode::wiring ? !state.canvas.clipboard.neurons.empty() : view.copied_objects > 0;
    return has_copy ? "" : "wiring.refused.nothing_copied";
}

std::string_view nothing_to_select(const LabView& view, const PanelState&) {
    if (view.mode == Mode::wiring || has_objects(view)) return "";
    return view.now->vehicles.empty() ? "unavailable.no_objects" : "";
}

std::string_view nothing_to_erase(const LabView& view, const PanelState& state) {
    if (view.mode == Mode::wiring) return state.canvas.selection.empty() ? nothing_selected : "";
    return removal_of(*view.now, chosen(view)) ? "" : nothing_selected;
}

std::string_view nothing_for_menu(const LabView& view, const PanelState& state) {
    return view.mode == Mode::wiring ? "unavailable.scene_only" : nothing_to_erase(view, state);
}

std::string_view nothing_to_duplicate(const LabView& view, const PanelState& state) {
    if (view.mode == Mode::wiring) return nothing_to_erase(view, state);
    return copy_of(*view.now, chosen(view)) ? "" : nothing_selected;
}

std::string_view nothing_to_lesion(const LabView& view, const PanelState& state) {
    if (!state.brain.lesion_under_pointer.empty()) return "";
    return view.mode == Mode::wiring ? nothing_to_erase(view, state) : "unavailable.lesion";
}

std::string_view no_node_to_probe(const LabView& view, const PanelState& state) {
    if (view.mode != Mode::wiring) return "unavailable.wiring_only";
    return state.canvas.selection.nodes.empty() ? "unavailable.no_node" : "";
}

std::string_view no_nodes_in_sight(const LabView& view, const PanelState& state) {
    return view.mode == Mode::wiring || watches_diagram(view, state) ? "" : "unavailable.no_diagram";
}

// In a lecture X is the key of the diagram's nodes.
std::string_view no_next_object(const LabView& view, const PanelState&) {
    if (view.lecture) return "unavailable.no_diagram";
    return has_objects(view) ? "" : "unavailable.no_objects";
}

std::string_view no_node_to_join(const LabView& view, const PanelState& state) {
    if (view.mode != Mode::wiring) return "unavailable.wiring_only";
    return state.canvas.selection.nodes.size() == 1 ? "" : "wiring.refused.join_one";
}

std::string_view why_no_larger_type(const LabView& view, const PanelState&) {
    constexpr float rounding = 0.001f;
    const float now = view.program.preferences.type_size;
    if (now >= largest_type_size) return "unavailable.largest";
    return now >= view.program.largest_type_size - rounding ? "unavailable.largest_here" : "";
}

std::string_view no_hint(const LabView& view, const PanelState&) {
    if (!view.lesson) return "unavailable.no_exercise";
    if (view.lesson->attempt.answers.hints_shown >= static_cast<int>(view.lesson->exercise->hints.size()))
        return "exercise.hint_none";
    return view.lesson->attempt.answers.hint_ready ? "" : "exercise.hint_wait";
}

// The brain must drive, and it must not be hidden.
std::string_view no_cause(const LabView& view, const PanelState&) {
    if (!has_vehicle(view)) return view.features.why ? "" : "unavailable.no_vehicle";
    return can_tell_why(view) ? "" : "unavailable.why";
}

std::string_view no_map(const LabView& view, const PanelState&) {
    if (view.settings.map) return "";
    if (view.mode == Mode::wiring && has_vehicle(view)) return "unavailable.scene_only";
    return why_no_map(view);
}

// While the audience is asked, an empty diagram would take the place of the scene.
std::string_view no_diagram(const LabView& view, const PanelState&) {
    const VehicleView* vehicle = selected_vehicle(view);
    const bool is_open = view.mode == Mode::wiring || view.settings.watching;
    const bool asks = view.lecture && view.settings.revealed.asks_first && !is_open;
    return asks && vehicle && hides_brain(view, vehicle->kind) ? "unavailable.diagram_hidden" : "";
}

std::string_view no_robots(const LabView& view, const PanelState&) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (view.settings.reality) return "";
    if (!vehicle) return "unavailable.no_vehicle";
    if (view.mode == Mode::wiring) return "unavailable.scene_only";
    const bool is_free = vehicle->driver == Driver::brain && may_show_future(view) && !hides_outcome(view);
    return is_free ? "" : "unavailable.reality";
}

std::string_view no_brain_to_save(const LabView& view, const PanelState&) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle) return "unavailable.no_vehicle";
    return is_brain_secret(view, vehicle->kind) ? "unavailable.hidden_brain" : "";
}

std::string_view no_brain_for_robot(const LabView& view, const PanelState&) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle) return "unavailable.no_vehicle";
    return hides_brain(view, vehicle->kind) ? "wiring.hidden" : "";
}

std::string_view no_slots(const LabView& view, const PanelState&) { return why_no_slots(view); }

std::string_view no_comparison(const LabView& view, const PanelState&) { return why_no_comparison(view); }

std::string_view no_chart(const LabView& view, const PanelState& state) {
    const ChartsState& charts = state.charts;
    const bool of_vehicle =
        charts.shown == Chart::signals || charts.shown == Chart::all || charts.shown == Chart::chosen;
    const bool empty = of_vehicle                    ? charts.history.signals.empty()
                       : charts.shown == Chart::bars ? view.now->vehicles.empty()
                                                     : charts.history.population.empty();
    return empty ? "charts.nothing" : "";
}

// The map, the robots and a comparison have the room of the count.
std::string_view no_tally(const LabView& view, const PanelState&) {
    if (!view.lecture) return "unavailable.no_lecture_view";
    if (view.pages) return "unavailable.tally";
    const bool is_covered = view.settings.map || view.settings.reality || view.features.slots.seconds > 0;
    return is_covered ? "unavailable.tally_covered" : "";
}

std::string_view no_marks(const LabView& view, const PanelState& state) {
    if (!view.lecture) return "unavailable.no_lecture_view";
    return state.lecture.marks.lines.empty() ? "unavailable.no_marks" : "";
}

// ── Effects ──

// In a lecture the browser begins with what ships: there a word that is typed is searched for.
void open_files(const Acting& at, bool saving, FileKind kind = FileKind::scene) {
    PanelState& state = at.state;
    begin_files(state.sheets.files, saving, kind);
    if (at.view.lecture) state.sheets.files.place = FilesPlace::shipped;
    state.sheet = Sheet::files;
}

bool open_empty_scene(const Acting& at) {
    if (const CatalogueEntry* scene = empty_scene(at.view)) at.outbox.push_back(OpenRequest{scene->path});
    return true;
}

// False for a scene that has a file: the lab saves it there.
bool save_under_a_name(const Acting& at) {
    if (at.view.documents.files && !at.view.documents.files->save_to.empty()) return false;
    open_files(at, true);
    return true;
}

bool request_lesion(const Acting& at) {
    BrainState& brain = at.state.brain;
    if (brain.lesion_under_pointer.empty()) return false;
    brain.lesion_requested = brain.lesion_under_pointer;
    return true;
}

// Closes the cards that have the room of the watched diagram. False if the lab then shows the diagram.
bool make_room_for_diagram(const Acting& at) {
    if (!at.state.map.replaces_diagram) return false;
    const ViewSettings& shown = at.view.settings;
    if (shown.map) at.outbox.push_back(Action::map);
    if (shown.reality) at.outbox.push_back(Action::reality);
    if (shown.values) at.outbox.push_back(Action::values);
    return shown.watching;
}

bool edit_draft_again(const Acting& at) {
    at.state.sheets.author.goes_on = true;
    return false;
}

// Goes on with the exercise that was saved by the sheet, else begins one of the open scene.
bool open_author(const Acting& at) {
    if (at.view.documents.has_draft) {
        at.outbox.push_back(Action::edit_again);
        return edit_draft_again(at), true;
    }
    begin_author(at.view, at.state.sheets.author);
    at.state.sheet = Sheet::author;
    return true;
}

// Moves the focus to a slider of the brain. Where the exercise offers fewer, to the first one, and says which ones it
// offers.
void focus_slider(const Acting& at, std::size_t number) {
    const LabView& view = at.view;
    if (!view.settings.revealed.brain)  // a lecture shows it later
        return at.outbox.push_back(NoticeRequest{"unavailable.hidden_sliders", {}, {}});
    const std::vector<std::string_view> sliders = numbered_sliders(view);
    const bool is_chosen = number < sliders.size();
    if (!is_chosen) {
        std::string offered;
        for (const Offer& offer : offered_dials(*view.lesson->exercise))
            offered += (offered.empty() ? "" : ", ") + words_of(offer);
        const std::string_view key = sliders.empty() ? "notice.no_slider_offered" : "notice.no_such_slider";
        at.outbox.push_back(NoticeRequest{std::string(key), std::to_string(number + 1), offered});
        number = 0;
    }
    if (sliders.empty()) return;
    at.state.card(Card::brain).folded = false;
    at.state.keyboard.focus = sliders[number];
    at.state.keyboard.revealed = true;
    // In a lecture nothing else says that digits, which are keys of sliders, are no number before Enter.
    if (view.lecture && is_chosen) at.outbox.push_back(NoticeRequest{"notice.slider_chosen", {}, {}});
}

// ── The table ──

#define NEEDS(condition, otherwise)                                                                          \
    []([[maybe_unused]] const LabView& view, [[maybe_unused]] const PanelState& state) -> std::string_view { \
        return (condition) ? "" : (otherwise);                                                               \
    }
#define ON(condition) \
    []([[maybe_unused]] const LabView& view, [[maybe_unused]] const PanelState& state) -> bool { return condition; }
#define DOES(...) [](const Acting& at) -> bool { return (__VA_ARGS__), true; }
#define OPENS(which) DOES(at.state.sheet = Sheet::which)
#define ACTION(id, keys, ...) {__VA_ARGS__},
#define VIEW_SWITCH(id, keys, flag, ...) {__VA_ARGS__, .is_on = ON(view.settings.flag)},

constexpr ActionTraits action_rows[]{
#include "ui/actions.def"
};
static_assert(std::size(action_rows) == static_cast<std::size_t>(last_action) + 1);

#undef NEEDS
#undef ON
#undef DOES
#undef OPENS

}  // namespace

const ActionTraits& traits(Action action) { return action_rows[static_cast<std::size_t>(action)]; }

std::vector<Action> actions_in(Menu menu) {
    std::vector<Action> found;
    for (std::size_t i = 0; i < std::size(action_rows); ++i)
        if (action_rows[i].menu.menu == menu) found.push_back(static_cast<Action>(i));
    std::stable_sort(found.begin(), found.end(), [](Action a, Action b) {
        const MenuPlace &x = traits(a).menu, &y = traits(b).menu;
        return std::pair(x.section, x.row) < std::pair(y.section, y.row);
    });
    return found;
}

bool watches_diagram(const LabView& view, const PanelState& state) {
    return view.settings.watching && view.mode != Mode::wiring && !state.map.replaces_diagram;
}

std::string_view why_unavailable(const LabView& view, const PanelState& state, Action action) {
    const auto why_not = traits(action).why_not;
    return why_not ? why_not(view, state) : std::string_view{};
}

std::optional<bool> switched_on(const LabView& view, const PanelState& state, Action action) {
    const auto is_on = traits(action).is_on;
    return is_on ? std::optional(is_on(view, state)) : std::nullopt;
}

bool act_on_panels(const Acting& at, Action action) {
    const auto act = traits(action).act;
    return act && act(at);
}

const CatalogueEntry* empty_scene(const LabView& view) {
    if (!view.documents.catalogue) return nullptr;
    const auto is_empty_scene = [](const CatalogueEntry& entry) { return entry.name == "empty"; };
    const auto found = std::find_if(view.documents.catalogue->begin(), view.documents.catalogue->end(), is_empty_scene);
    return found == view.documents.catalogue->end() ? nullptr : &*found;
}

}  // namespace braitenlab::ui
