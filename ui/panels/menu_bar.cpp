// The menu bar: which menu has which rows, and why a row cannot be chosen now.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/enums.h"
#include "ui/panels/course/exercise_names.h"
#include "ui/panels/file_lists.h"
#include "ui/panels/panels.h"
#include "ui/panels/trail_legend.h"
#include "ui/scene_input/edits.h"
#include "ui/strings.h"
#include "ui/widgets/paint.h"

namespace braitenlab::ui {

namespace {

constexpr std::size_t most_recent = 5;
constexpr float longest_name = 260, longest_exercise = 520;  // of a recent file and an exercise, layout pixels

struct MenuNames {
    std::string_view name, words;  // words: key of the string
};
constexpr std::array<MenuNames, 7> menu_names{{{"file", "menus.file"},
                                               {"edit", "menus.edit"},
                                               {"view", "menus.view"},
                                               {"simulation", "menus.simulation"},
                                               {"exercises", "menus.exercises"},
                                               {"lecture", "menus.lecture"},
                                               {"help", "menus.help"}}};

// The menu of each action, in the order of the rows.
struct MenuPlace {
    std::string_view menu;
    Action action;
    bool rule_above = false;
};
constexpr MenuPlace menu_places[]{
    {"file", Action::new_scene},
    {"file", Action::open},
    {"file", Action::save, true},
    {"file", Action::save_as},
    {"file", Action::save_run},
    {"file", Action::save_brain},
    {"file", Action::save_exercise},
    {"file", Action::copy_link, true},
    {"file", Action::export_robot},
    {"file", Action::export_csv},
    {"file", Action::take_away},
    {"file", Action::screenshot},
    {"file", Action::exit, true},

    {"edit", Action::undo},
    {"edit", Action::redo},
    {"edit", Action::cut, true},
    {"edit", Action::copy},
    {"edit", Action::paste},
    {"edit", Action::duplicate},
    {"edit", Action::erase},
    {"edit", Action::select_all},
    {"edit", Action::next_vehicle, true},
    {"edit", Action::previous_vehicle},
    {"edit", Action::next_object},
    {"edit", Action::previous_object},
    {"edit", Action::add},
    {"edit", Action::remove},
    {"edit", Action::add_here},
    {"edit", Action::scene_menu},
    {"edit", Action::close_outline},
    {"edit", Action::take_back},
    {"edit", Action::menu, true},
    {"edit", Action::probe},
    {"edit", Action::join},
    {"edit", Action::lesion},
    {"edit", Action::tidy},
    {"edit", Action::values, true},
    {"edit", Action::settings, true},

    {"view", Action::sensors},
    {"view", Action::outlines},
    {"view", Action::trails},
    {"view", Action::surfaces},
    {"view", Action::memory},
    {"view", Action::labels},
    {"view", Action::last_run},
    {"view", Action::next_field},
    {"view", Action::home, true},
    {"view", Action::slow_orbit},
    {"view", Action::follow},
    {"view", Action::birds_eye},
    {"view", Action::drivers_eye},
    {"view", Action::wiring, true},
    {"view", Action::watch},
    {"view", Action::fit},
    {"view", Action::charts},
    {"view", Action::full_screen, true},
    {"view", Action::theme},
    {"view", Action::larger},
    {"view", Action::smaller},

    {"simulation", Action::play_pause},
    {"simulation", Action::step},
    {"simulation", Action::step_back},
    {"simulation", Action::rewind},
    {"simulation", Action::fast_forward},
    {"simulation", Action::reset, true},
    {"simulation", Action::another_start},
    {"simulation", Action::return_run},
    {"simulation", Action::new_population},
    {"simulation", Action::slower, true},
    {"simulation", Action::faster},
    {"simulation", Action::set_bookmark, true},
    {"simulation", Action::last_bookmark},
    {"simulation", Action::drive, true},
    {"simulation", Action::why},
    {"simulation", Action::map},
    {"simulation", Action::slot},
    {"simulation", Action::compare},
    {"simulation", Action::mystery},
    {"simulation", Action::studies},
    {"simulation", Action::reality},

    {"exercises", Action::hint},
    {"exercises", Action::exercise_reset},

    {"lecture", Action::lecture},
    {"lecture", Action::first_page, true},
    {"lecture", Action::next_page},
    {"lecture", Action::previous_page},
    {"lecture", Action::notes},
    {"lecture", Action::notes_page},
    {"lecture", Action::hide_title, true},
    {"lecture", Action::hide_character},
    {"lecture", Action::hide_brain},
    {"lecture", Action::draw_marks, true},
    {"lecture", Action::clear_marks},
    {"lecture", Action::blank},

    {"help", Action::keys},
    {"help", Action::glossary},
    {"help", Action::about},
};

// A row and its effect: an action or a request.
struct LabMenuRow {
    MenuEntry entry;
    std::optional<Action> action{};
    std::optional<Request> request{};
    std::optional<Sheet> sheet{};  // opened in the next frame
};

bool is_overlay(Action action) { return action >= Action::sensors && action <= Action::next_field; }

// Whether a switch is on; nullopt for other actions.
std::optional<bool> switched_on(const LabView& view, const PanelState& state, Action action) {
    const Overlays& shown = view.settings.overlays;
    switch (action) {
        case Action::sensors:
            return view.settings.sensors;
        case Action::outlines:
            return view.settings.outlines;
        case Action::trails:
            return shown.trails;
        case Action::surfaces:
            return shown.surfaces;
        case Action::memory:
            return shown.memory;
        case Action::labels:
            return shown.labels;
        case Action::slow_orbit:
            return view.settings.orbits;
        case Action::last_run:
            return shown.last_run;
        case Action::why:
            return view.why != nullptr;
        case Action::follow:
            return view.settings.camera.mode == CameraMode::follow;
        case Action::birds_eye:
            return view.settings.camera.mode == CameraMode::birds_eye;
        case Action::drivers_eye:
            return view.settings.camera.mode == CameraMode::driver;
        case Action::wiring:
            return view.mode == Mode::wiring;
        case Action::watch:
            return view.settings.watching;
        case Action::values:
            return view.settings.values;
        case Action::charts:
            return state.charts_open;
        case Action::map:
            return view.settings.map;
        case Action::reality:
            return view.settings.reality;
        default:
            return std::nullopt;
    }
}

LabMenuRow action_row(const LabView& view, const PanelState& state, const Ui& ui, const MenuPlace& place) {
    const std::string word(name(place.action));
    LabMenuRow row{.action = place.action};
    MenuEntry& e = row.entry;
    e.anchor = "menu." + std::string(place.menu) + "." + word;
    e.words = ui.strings("action." + word);
    e.keys = key_name(place.action, ui.strings);
    const std::string_view why = why_unavailable(view, state, place.action);
    e.enabled = why.empty();
    e.how = e.enabled ? ui.strings.find("tooltip." + word, "") : ui.strings(why);
    e.on = switched_on(view, state, place.action);
    e.rule_above = place.rule_above;
    e.stays_open = is_overlay(place.action);
    return row;
}

LabMenuRow menu_heading(std::string_view words) {
    LabMenuRow row;
    row.entry.words = words;
    row.entry.heading = row.entry.rule_above = true;
    return row;
}

void add_recent_files(std::vector<LabMenuRow>& rows, const LabView& view, const Ui& ui) {
    if (!view.recent || view.recent->empty()) return;
    rows.push_back(menu_heading(ui.strings("menus.recent")));
    for (std::size_t i = 0; i < std::min(most_recent, view.recent->size()); ++i) {
        const RecentFile& file = (*view.recent)[i];
        LabMenuRow row{.request = OpenRequest{file.path}};
        row.entry.anchor = "menu.file.recent." + std::to_string(i + 1);
        row.entry.words = shortened(ui, recent_words(view, ui, *view.recent, file), Face::text, ui.px(longest_name));
        row.entry.how = file.path;
        rows.push_back(std::move(row));
    }
}

// The fields of the channels in the scene, and none.
void add_fields(std::vector<LabMenuRow>& rows, const LabView& view, const Ui& ui) {
    rows.push_back(menu_heading(ui.strings("view.field")));
    const auto add = [&](std::string anchor, std::string_view words, std::optional<Channel> field) {
        Overlays wanted = view.settings.overlays;
        LabMenuRow row;
        row.entry.anchor = "menu.view.field." + std::move(anchor);
        row.entry.words = words;
        row.entry.on = wanted.field == field;
        row.entry.stays_open = true;
        wanted.field = field;
        row.request = OverlaysRequest{wanted};
        rows.push_back(std::move(row));
    };
    add("none", ui.strings("view.no_field"), std::nullopt);
    for (const Channel c : channels_with_intensity(*view.now))
        add(std::string(word(c)), ui.strings("view.channel." + std::string(word(c))), c);
}

// The seconds of the predicted path; each choice sets the next number, the last one is none. One row, so that the menu
// fits into a low window.
LabMenuRow row_of_prediction(const LabView& view, const Ui& ui) {
    constexpr std::array<int, 4> seconds{0, 3, 8, longest_prediction};
    Overlays wanted = view.settings.overlays;
    const auto next = std::upper_bound(seconds.begin(), seconds.end(), wanted.prediction);
    LabMenuRow row;
    row.entry.anchor = "menu.view.prediction";
    const std::string shown = wanted.prediction > 0
                                  ? fill(ui.strings("view.seconds"), {std::to_string(wanted.prediction)})
                                  : std::string(ui.strings("view.no_prediction"));
    row.entry.words = fill(ui.strings("view.prediction"), {shown});
    row.entry.how = ui.strings("view.prediction_how");
    row.entry.on = wanted.prediction > 0;
    row.entry.stays_open = true;
    wanted.prediction = next == seconds.end() ? seconds.front() : *next;
    row.request = OverlaysRequest{wanted};
    return row;
}

// What the trails show; each choice sets the next one and shows the trails.
LabMenuRow row_of_trail_colour(const LabView& view, const Ui& ui) {
    Overlays wanted = view.settings.overlays;
    LabMenuRow row;
    row.entry.anchor = "menu.view.trail_colour";
    row.entry.words = fill(ui.strings("view.trail.colour"), {trail_colour_words(view, ui)});
    row.entry.how = ui.strings("view.trail.how");
    row.entry.on = wanted.trail_colour.value != TrailValue::plain;
    row.entry.stays_open = true;
    wanted.trails = true;
    wanted.trail_colour = next_trail_colour(view);
    row.request = OverlaysRequest{wanted};
    return row;
}

// "9/10" of the best grade, after a check mark once it is passed.
std::string passed_words(const LabView& view, const Ui& ui, const CatalogueEntry& entry) {
    const ExerciseProgress* progress = progress_of(view, entry);
    std::string best = best_words(progress);
    if (!progress || !progress->passed) return best;
    return (has_icons(ui) ? std::string(icon::check) : std::string(ui.strings("exercise.passed_sign"))) + " " + best;
}

// Opens the sheet of the students.
LabMenuRow student_row_of_menu(const LabView& view, const Ui& ui) {
    LabMenuRow row{.sheet = Sheet::students};
    row.entry.anchor = "menu.exercises.students";
    row.entry.words = view.student.empty() ? std::string(ui.strings("students.open"))
                                           : fill(ui.strings("students.open_named"), {view.student});
    row.entry.how = ui.strings("students.what");
    return row;
}

void add_catalogue(std::vector<LabMenuRow>& rows, const LabView& view, const Ui& ui) {
    if (!view.catalogue) return;
    for (const bool exercises : {true, false}) {
        int chapter = 0;
        rows.push_back(menu_heading(ui.strings(exercises ? "open.exercises" : "open.scenes")));
        for (const CatalogueEntry& shipped : *view.catalogue) {
            if ((shipped.number > 0) != exercises) continue;
            if (shipped.chapter != chapter) rows.push_back(menu_heading(chapter_title(ui, shipped.chapter)));
            chapter = shipped.chapter;
            LabMenuRow row{.request = OpenRequest{shipped.path}};
            row.entry.anchor = "menu.exercises." + shipped.name;
            const std::string number =
                exercises ? ui::number_words(view, shipped.number, shipped.name) + "  " : std::string();
            const float room = ui.px(longest_exercise) - text_width(ui, Face::text, number);
            row.entry.words = number + shortened_at_clause(ui, exercise_words(view, ui, shipped), Face::text, room);
            row.entry.how = translated(ui, shipped.exercise ? shipped.exercise->goal : shipped.story);
            row.entry.keys = passed_words(view, ui, shipped);
            row.entry.open = shipped.name == view.opened;
            rows.push_back(std::move(row));
        }
    }
}

// The lecture that was left, at the page where it was left.
LabMenuRow row_of_left_lecture(const LabView& view, const Ui& ui) {
    const LectureView& left = *view.left_pages;
    LabMenuRow row{.request = OpenRequest{.path = left.lecture->path.string(), .resume = true}};
    row.entry.anchor = "menu.lecture.resume";
    row.entry.words =
        fill(ui.strings("lecture.resume"), {translated(ui, left.lecture->title), std::to_string(left.page + 1)});
    return row;
}

void add_lectures(std::vector<LabMenuRow>& rows, const LabView& view, const Ui& ui) {
    if (view.left_pages && !view.lecture) rows.push_back(row_of_left_lecture(view, ui));
    if (!view.lectures || view.lectures->empty()) return;
    rows.push_back(menu_heading(ui.strings("open.lectures")));
    for (const CatalogueEntry& shipped : *view.lectures) {
        LabMenuRow row{.request = OpenRequest{shipped.path}};
        row.entry.anchor = "menu.lecture." + shipped.name;
        row.entry.words = translated(ui, shipped.title);
        rows.push_back(std::move(row));
    }
}

std::vector<LabMenuRow> rows_of(const LabView& view, const PanelState& state, const Ui& ui, std::string_view menu) {
    std::vector<LabMenuRow> rows;
    for (const MenuPlace& place : menu_places) {
        if (place.menu != menu) continue;
        rows.push_back(action_row(view, state, ui, place));
        if (place.action == Action::open) add_recent_files(rows, view, ui);
        if (place.action == Action::next_field) add_fields(rows, view, ui);
        if (place.action == Action::trails) rows.push_back(row_of_trail_colour(view, ui));
        if (place.action == Action::last_run) rows.push_back(row_of_prediction(view, ui));
        if (place.action == Action::exercise_reset && view.students) rows.push_back(student_row_of_menu(view, ui));
        if (place.action == Action::exercise_reset) add_catalogue(rows, view, ui);
        if (place.action == Action::blank) add_lectures(rows, view, ui);
    }
    return rows;
}

std::array<MenuTitle, menu_names.size()> lab_menu_titles(const Ui& ui) {
    std::array<MenuTitle, menu_names.size()> titles;
    for (std::size_t i = 0; i < titles.size(); ++i) {
        const bool is_view = menu_names[i].name == "view";
        titles[i] = {menu_names[i].name, ui.strings(menu_names[i].words),
                     ui.strings(is_view ? "tooltip.view" : "action.menu_bar"),
                     key_name(is_view ? Action::view : Action::menu_bar, ui.strings)};
    }
    return titles;
}

// Cut, copy, paste and select all in the scene.
std::string_view why_not_in_scene(const LabView& view, Action action) {
    const Snapshot& now = *view.now;
    if (action == Action::paste) return view.copied_objects > 0 ? "" : "wiring.refused.nothing_copied";
    if (action == Action::select_all)
        return now.vehicles.empty() && objects_beside_vehicles(*now.scene).empty() ? "unavailable.no_objects" : "";
    return place_of(now, chosen(view)) ? "" : "unavailable.nothing_selected";
}

std::string_view why_not_on_canvas(const LabView& view, const PanelState& state, Action action) {
    if (view.mode != Mode::wiring) return "unavailable.wiring_only";
    const wiring::CanvasState& canvas = state.canvas;
    if (action == Action::paste) return canvas.clipboard.neurons.empty() ? "wiring.refused.nothing_copied" : "";
    if (action == Action::cut || action == Action::copy)
        return canvas.selection.nodes.empty() ? "wiring.refused.nothing_to_copy" : "";
    if (action == Action::probe) return canvas.selection.nodes.empty() ? "unavailable.no_node" : "";
    if (action == Action::join) return canvas.selection.nodes.size() == 1 ? "" : "wiring.refused.join_one";
    return "";
}

// Duplicate, delete, lesion and the context menu: of the canvas's selection while wiring, else of the scene's.
std::string_view why_not_on_selection(const LabView& view, const PanelState& state, Action action) {
    constexpr std::string_view nothing = "unavailable.nothing_selected";
    if (view.mode == Mode::wiring) {
        if (action == Action::scene_menu) return "unavailable.scene_only";
        return state.canvas.selection.empty() ? nothing : "";
    }
    if (action == Action::lesion) return "unavailable.lesion";
    if (action == Action::duplicate) return copy_of(*view.now, chosen(view)) ? "" : nothing;
    return removal_of(*view.now, chosen(view)) ? "" : nothing;
}

std::string_view why_not_in_time(const LabView& view, Action action) {
    const TimelineView& time = view.timeline;
    if (action == Action::last_bookmark) return time.bookmarks.empty() ? "unavailable.no_bookmark" : "";
    if (action == Action::fast_forward) return time.latest > view.now->tick ? "" : "unavailable.latest";
    return time.earliest < view.now->tick ? "" : "unavailable.earliest";
}

std::string_view why_not_in_exercise(const LabView& view, Action action) {
    if (!view.lesson) return "unavailable.no_exercise";
    if (action == Action::exercise_reset) return "";
    if (view.lesson->hints_shown >= static_cast<int>(view.lesson->exercise->hints.size())) return "exercise.hint_none";
    return view.lesson->hint_ready ? "" : "exercise.hint_wait";
}

std::string_view why_not_with_vehicle(const LabView& view, const PanelState& state, Action action) {
    const VehicleId selected = view.settings.selection.vehicle;
    if (selected != no_vehicle && find_vehicle(*view.now, selected)) return "";
    return switched_on(view, state, action).value_or(false) ? "" : "unavailable.no_vehicle";
}

// The brain must drive, and it must not be hidden.
std::string_view why_no_cause(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (!vehicle) return why_not_with_vehicle(view, state, Action::why);
    return can_tell_why(view) ? "" : "unavailable.why";
}

std::string_view why_no_map(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (!vehicle) return why_not_with_vehicle(view, state, Action::map);
    if (view.mode == Mode::wiring) return "unavailable.scene_only";
    return can_show_map(view, *vehicle) ? "" : "unavailable.map";
}

std::string_view why_no_brain_file(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (vehicle && is_brain_secret(view, vehicle->kind)) return "unavailable.hidden_brain";
    return why_not_with_vehicle(view, state, Action::save_brain);
}

// A saved run has its brains in plain text.
bool has_hidden_brain(const Scene& scene) {
    return std::any_of(scene.kinds.begin(), scene.kinds.end(), [](const Kind& kind) { return kind.hidden; });
}

std::string_view why_no_robots(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (!vehicle) return why_not_with_vehicle(view, state, Action::reality);
    if (view.mode == Mode::wiring) return "unavailable.scene_only";
    const bool is_free = vehicle->driver == Driver::brain && may_show_future(view) && !hides_outcome(view);
    return is_free ? "" : "unavailable.reality";
}

std::string_view why_no_robot(const LabView& view, const PanelState& state) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    if (!vehicle) return why_not_with_vehicle(view, state, Action::export_robot);
    return hides_brain(view, vehicle->kind) ? "wiring.hidden" : "";
}

std::string_view why_no_csv(const LabView& view, const PanelState& state) {
    const bool of_vehicle = state.chart == Chart::signals || state.chart == Chart::all || state.chart == Chart::chosen;
    const bool empty = of_vehicle                   ? state.history.signals.empty()
                       : state.chart == Chart::bars ? view.now->vehicles.empty()
                                                    : state.history.population.empty();
    return empty ? "charts.nothing" : "";
}

}  // namespace

const CatalogueEntry* empty_scene(const LabView& view) {
    if (!view.catalogue) return nullptr;
    const auto is_empty_scene = [](const CatalogueEntry& entry) { return entry.name == "empty"; };
    const auto found = std::find_if(view.catalogue->begin(), view.catalogue->end(), is_empty_scene);
    return found == view.catalogue->end() ? nullptr : &*found;
}

std::string_view why_unavailable(const LabView& view, const PanelState& state, Action action) {
    switch (action) {
        case Action::undo:
            return view.undo_depth > 0 ? "" : "unavailable.undo";
        case Action::redo:
            return view.redo_depth > 0 ? "" : "unavailable.redo";
        case Action::cut:
        case Action::copy:
        case Action::paste:
        case Action::select_all:
            return view.mode == Mode::wiring ? why_not_on_canvas(view, state, action) : why_not_in_scene(view, action);
        case Action::menu:
        case Action::probe:
        case Action::join:
        case Action::tidy:
        case Action::fit:
            return why_not_on_canvas(view, state, action);
        case Action::duplicate:
        case Action::erase:
        case Action::lesion:
        case Action::scene_menu:
            return why_not_on_selection(view, state, action);
        case Action::close_outline:
        case Action::take_back:
            return view.mode != Mode::wiring && !state.scene_input.corners.empty() ? "" : "unavailable.no_polygon";
        case Action::next_vehicle:
        case Action::previous_vehicle:
        case Action::remove:
            return view.now->vehicles.empty() ? "unavailable.no_vehicles" : "";
        case Action::next_object:
        case Action::previous_object:
            return objects_beside_vehicles(*view.now->scene).empty() ? "unavailable.no_objects" : "";
        case Action::add_here:
            return view.mode == Mode::wiring ? "unavailable.scene_only" : "";
        case Action::follow:
        case Action::drivers_eye:
        case Action::drive:
            return why_not_with_vehicle(view, state, action);
        case Action::save_brain:
            return why_no_brain_file(view, state);
        case Action::save_run:
            return has_hidden_brain(*view.now->scene) ? "unavailable.hidden_run" : "";
        case Action::why:
            return why_no_cause(view, state);
        case Action::map:
            return view.settings.map ? "" : why_no_map(view, state);
        case Action::return_run:
            return view.has_left_run ? "" : "unavailable.no_last_run";
        case Action::slot:
            return why_no_slots(view);
        case Action::compare:
            return why_no_comparison(view);
        case Action::reality:
            return view.settings.reality ? "" : why_no_robots(view, state);
        case Action::charts:
            return view.mode == Mode::wiring ? "unavailable.scene_only" : "";
        case Action::larger:
            return view.preferences.type_size < largest_type_size ? "" : "unavailable.largest";
        case Action::smaller:
            return view.preferences.type_size > least_type_size ? "" : "unavailable.smallest";
        case Action::step_back:
        case Action::rewind:
        case Action::fast_forward:
        case Action::last_bookmark:
            return why_not_in_time(view, action);
        case Action::slower:
            return view.time_scale > 0.126f ? "" : "unavailable.slowest";
        case Action::faster:
            return view.time_scale < 15.9f ? "" : "unavailable.fastest";
        case Action::hint:
        case Action::exercise_reset:
            return why_not_in_exercise(view, action);
        case Action::new_scene:
            return empty_scene(view) ? "" : "unavailable.no_empty_scene";
        case Action::save_exercise:
            return view.now->scene->starts.empty() ? "author.no_vehicle" : "";
        case Action::export_robot:
            return why_no_robot(view, state);
        case Action::export_csv:
            return why_no_csv(view, state);
        case Action::first_page:
            return view.pages || view.left_pages ? "" : "unavailable.no_lecture";
        case Action::next_page:
        case Action::previous_page:
        case Action::notes:
        case Action::notes_page:
        case Action::blank:
            return view.pages ? "" : "unavailable.no_lecture";
        case Action::slow_orbit:
            return view.reduce_motion ? "unavailable.motion_reduced" : "";
        case Action::draw_marks:
        case Action::clear_marks:
        case Action::hide_title:
        case Action::hide_character:
        case Action::hide_brain:
            return view.lecture ? "" : "unavailable.no_lecture_view";
        default:
            return "";
    }
}

void menu_bar(PanelState& state, Ui& ui, Rect bar) { menu_titles(ui, state.menu_bar, lab_menu_titles(ui), bar); }

void lab_menu(const LabView& view, PanelState& state, Ui& ui, Rect bar, Rect window) {
    if (state.menu_bar.open.empty()) return state.menu_bar.drawn.clear();
    const std::vector<LabMenuRow> rows = rows_of(view, state, ui, state.menu_bar.open);
    std::vector<MenuEntry> entries;
    for (const LabMenuRow& row : rows) entries.push_back(row.entry);
    const int chosen = menu_panel(ui, state.menu_bar, lab_menu_titles(ui), entries, bar, window);
    if (chosen < 0) return;
    const LabMenuRow& row = rows[static_cast<std::size_t>(chosen)];
    if (row.action) state.chosen.push_back(*row.action);
    if (row.request) ui.outbox.push_back(*row.request);
    if (row.sheet) state.sheet = *row.sheet;
}

std::string_view menu_title_at(const Ui& ui, float x, float y) {
    for (const MenuNames& menu : menu_names) {
        const Rect* at = ui.anchors.find("menu." + std::string(menu.name));
        if (at && at->contains(x, y)) return menu.name;
    }
    return {};
}

void switch_menu(MenuBarState& menus, int step) {
    const auto count = static_cast<int>(menu_names.size());
    int at = 0;
    while (at < count - 1 && menu_names[static_cast<std::size_t>(at)].name != menus.open) ++at;
    if (menus.open.empty()) at = step = 0;
    menus.presses.clear();
    menus.open = menu_names[static_cast<std::size_t>((at + step + count) % count)].name;
}

}  // namespace braitenlab::ui
