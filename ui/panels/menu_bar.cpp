// The menu bar: titles, the rows of actions and those of files, fields, exercises and lectures.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/enums.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/files/file_lists.h"
#include "ui/panels/panels.h"
#include "ui/panels/trail_legend.h"
#include "ui/widgets/paint.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr std::size_t most_recent = 5;
constexpr float longest_name = 260, longest_exercise = 620;  // of a recent file and an exercise, layout pixels

struct MenuNames {
    std::string_view name, words;  // words: key of the string
};
// In the order of Menu.
constexpr std::array<MenuNames, 7> menu_names{{{"file", "menus.file"},
                                               {"edit", "menus.edit"},
                                               {"view", "menus.view"},
                                               {"simulation", "menus.simulation"},
                                               {"exercises", "menus.exercises"},
                                               {"lecture", "menus.lecture"},
                                               {"help", "menus.help"}}};
static_assert(menu_names.size() == static_cast<std::size_t>(Menu::help));

// A row and its effect: an action or a request.
struct LabMenuRow {
    MenuEntry entry;
    std::optional<Action> action{};
    std::optional<Request> request{};
    std::optional<Sheet> sheet{};  // opened in the next frame
};

LabMenuRow action_row(const LabView& view, const PanelState& state, const Ui& ui, std::string_view menu,
                      Action action) {
    const std::string word(name(action));
    LabMenuRow row{.action = action};
    MenuEntry& e = row.entry;
    e.anchor = "menu." + std::string(menu) + "." + word;
    e.words = ui.strings("action." + word);
    if (!view.program.touch) e.keys = key_name(action, ui.strings);
    const std::string_view why = why_unavailable(view, state, action);
    e.enabled = why.empty();
    e.how = e.enabled ? ui.strings.find("tooltip." + word, "") : ui.strings(why);
    e.on = switched_on(view, state, action);
    e.stays_open = traits(action).menu.stays_open;
    return row;
}

LabMenuRow menu_heading(std::string_view words) {
    LabMenuRow row;
    row.entry.words = words;
    row.entry.heading = row.entry.rule_above = true;
    return row;
}

void add_recent_files(std::vector<LabMenuRow>& rows, const LabView& view, const Ui& ui) {
    if (!view.documents.recent || view.documents.recent->empty()) return;
    rows.push_back(menu_heading(ui.strings("menus.recent")));
    for (std::size_t i = 0; i < std::min(most_recent, view.documents.recent->size()); ++i) {
        const RecentFile& file = (*view.documents.recent)[i];
        LabMenuRow row{.request = OpenRequest{file.path}};
        row.entry.anchor = "menu.file.recent." + std::to_string(i + 1);
        row.entry.words = recent_words(view, ui, *view.documents.recent, file, ui.px(longest_name));
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
    row.entry.words = view.documents.student.empty()
                          ? std::string(ui.strings("students.open"))
                          : fill(ui.strings("students.open_named"), {view.documents.student});
    row.entry.how = ui.strings("students.what");
    return row;
}

void add_catalogue(std::vector<LabMenuRow>& rows, const LabView& view, const Ui& ui) {
    if (!view.documents.catalogue) return;
    for (const bool exercises : {true, false}) {
        int chapter = 0;
        rows.push_back(menu_heading(ui.strings(exercises ? "open.exercises" : "open.scenes")));
        for (const CatalogueEntry& shipped : *view.documents.catalogue) {
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
            row.entry.how = told_of(view, ui, shipped);
            row.entry.keys = passed_words(view, ui, shipped);
            row.entry.open = shipped.name == view.documents.opened;
            row.entry.in_sight = row.entry.open && exercises;  // not a scene: they are below all exercises
            rows.push_back(std::move(row));
        }
    }
}

// The lecture that was left, at the page where it was left.
LabMenuRow row_of_left_lecture(const LabView& view, const Ui& ui) {
    const LectureView& left = *view.documents.left_pages;
    LabMenuRow row{.request = back_to_page(view)};
    row.entry.anchor = "menu.lecture.resume";
    row.entry.words =
        fill(ui.strings("lecture.resume"), {translated(ui, left.lecture->title), std::to_string(left.page + 1)});
    return row;
}

void add_lectures(std::vector<LabMenuRow>& rows, const LabView& view, const Ui& ui) {
    if (view.documents.left_pages && !view.lecture) rows.push_back(row_of_left_lecture(view, ui));
    if (!view.documents.lectures || view.documents.lectures->empty()) return;
    rows.push_back(menu_heading(ui.strings("open.lectures")));
    for (const CatalogueEntry& shipped : *view.documents.lectures) {
        LabMenuRow row{.request = OpenRequest{shipped.path}};
        row.entry.anchor = "menu.lecture." + shipped.name;
        row.entry.words = translated(ui, shipped.title);
        rows.push_back(std::move(row));
    }
}

std::vector<LabMenuRow> rows_of(const LabView& view, const PanelState& state, const Ui& ui, std::size_t menu) {
    std::vector<LabMenuRow> rows;
    int section = 0;
    for (const Action action : actions_in(static_cast<Menu>(menu + 1))) {
        rows.push_back(action_row(view, state, ui, menu_names[menu].name, action));
        rows.back().entry.rule_above = std::exchange(section, traits(action).menu.section) != section;
        if (action == Action::next_field) add_fields(rows, view, ui);
        if (action == Action::trails) rows.push_back(row_of_trail_colour(view, ui));
        if (action == Action::last_run) rows.push_back(row_of_prediction(view, ui));
        if (action == Action::exercise_reset && view.documents.students) rows.push_back(student_row_of_menu(view, ui));
        if (action == Action::exercise_reset) add_catalogue(rows, view, ui);
        if (action == Action::lecture) add_lectures(rows, view, ui);
    }
    if (static_cast<Menu>(menu + 1) == Menu::file)
        add_recent_files(rows, view, ui);  // last: other rows keep their place
    return rows;
}

// The position among the menus; the last one if there is none of this name.
std::size_t menu_named(std::string_view name) {
    std::size_t at = 0;
    while (at < menu_names.size() - 1 && menu_names[at].name != name) ++at;
    return at;
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
    const std::vector<LabMenuRow> rows = rows_of(view, state, ui, menu_named(state.menu_bar.open));
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

void toggle_menu(MenuBarState& menus, std::string_view menu) {
    menus.presses.clear();
    menus.open = menus.open == menu ? std::string_view{} : menu;
}

void switch_menu(MenuBarState& menus, int step) {
    const auto count = static_cast<int>(menu_names.size());
    auto at = static_cast<int>(menu_named(menus.open));
    if (menus.open.empty()) at = step = 0;
    menus.presses.clear();
    menus.open = menu_names[static_cast<std::size_t>((at + step + count) % count)].name;
}

}  // namespace braitenlab::ui
