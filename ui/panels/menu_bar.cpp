// The menu bar: which menu has which rows.
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
        row.entry.words = recent_words(view, ui, *view.recent, file, ui.px(longest_name));
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
            row.entry.words =
                number + shortened_first_sentence(ui, exercise_words(view, ui, shipped), Face::text, room);
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
        if (place.action == Action::lecture) add_lectures(rows, view, ui);
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

}  // namespace

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
