#include "ui/widgets/menu_bar.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "core/brain/presets.h"
#include "desk.h"

namespace braitenlab::tests::menu_bar_test {

using namespace ui;

namespace {

const std::vector<std::string> menus{"file", "edit", "view", "simulation", "exercises", "lecture", "help"};

// Shortcuts that need no row: they move the focus, edit a slider, move an object or the camera while a key is held,
// open a menu, or close what is open.
bool needs_no_row(Action action) {
    const std::set<Action> actions{
        Action::slider_LL,    Action::slider_LR, Action::slider_RL,  Action::slider_RR,   Action::less,
        Action::more,         Action::restore,   Action::next_card,  Action::next_widget, Action::previous_widget,
        Action::press,        Action::step_left, Action::step_right, Action::step_up,     Action::step_down,
        Action::nudge,        Action::raise,     Action::lower,      Action::turn_left,   Action::turn_right,
        Action::menu_bar,     Action::view,      Action::cancel,     Action::zoom_in,     Action::zoom_out,
        Action::pan_left,     Action::pan_right, Action::pan_up,     Action::pan_down,    Action::rotate_left,
        Action::rotate_right, Action::slider_LM, Action::slider_RM};
    return actions.contains(action);
}

// The anchors of the rows of the open menu.
std::set<std::string> rows_of(const Desk& desk) {
    const std::string stem = "menu." + desk.panels.menu_bar.open + ".";
    std::set<std::string> rows;
    for (const Shown& shown : desk.shown)
        if (shown.id.starts_with(stem)) rows.insert(shown.id.substr(stem.size()));
    return rows;
}

bool shows_in(const Desk& desk, Rect row, std::string_view words) {
    return std::any_of(desk.written.begin(), desk.written.end(), [&](const Written& w) {
        return w.words == words && row.contains(w.rect.x + w.rect.w / 2, w.rect.y + w.rect.h / 2);
    });
}

struct MenuBar : testing::Test {
    Desk desk;
    MenuBar() {
        desk.now.sources.push_back({0, Channel::smell, 0, 0, 1});
        desk.view.undo_depth = desk.view.redo_depth = 1;
        desk.frame(2);
    }
    void open(const std::string& menu) {
        desk.panels.menu_bar.open = menu;
        desk.frame(2);
    }
    void press(KeyPress key) {
        desk.key(key);
        desk.frame(2);
    }
    std::string opened() const { return desk.panels.menu_bar.open; }
    std::optional<Overlays> wanted() const {
        std::optional<Overlays> last;
        for (const Request& request : desk.all)
            if (const auto* r = std::get_if<OverlaysRequest>(&request)) last = r->overlays;
        return last;
    }
};

}  // namespace

TEST_F(MenuBar, HasARowWithItsKeyForEachShortcutInOneMenu) {
    std::map<std::string, int> found;
    std::map<std::string, bool> keyed;
    for (const std::string& menu : menus) {
        open(menu);
        for (const std::string& row : rows_of(desk)) {
            ++found[row];
            const auto action = action_named(row);
            if (!action) continue;
            const Rect at = desk.where("menu." + menu + "." + row);
            keyed[row] = shows_in(desk, at, key_name(*action, desk.strings));
            EXPECT_TRUE(shows_in(desk, at, desk.strings("action." + row))) << row;
        }
    }
    int rows = 0;
    for (const Shortcut& shortcut : shortcuts()) {
        const std::string row(name(shortcut.action));
        if (needs_no_row(shortcut.action)) {
            EXPECT_EQ(found[row], 0) << row;
            continue;
        }
        ++rows;
        EXPECT_EQ(found[row], 1) << row;
        EXPECT_TRUE(keyed[row]) << row;
    }
    EXPECT_GT(rows, 50);
    for (const char* row : {"save_run", "save_brain", "save_exercise", "export_robot", "export_csv", "hint",
                            "exercise_reset", "about", "glossary"})
        EXPECT_EQ(found[row], 1) << row;
}

TEST_F(MenuBar, NamesNoKeyToAFinger) {
    desk.view.program.touch = true, desk.view.program.finger = 44;
    int seen = 0;
    for (const std::string& menu : menus) {
        open(menu);
        for (const std::string& row : rows_of(desk)) {
            const auto action = action_named(row);
            const Rect* at = desk.anchors.find("menu." + menu + "." + row);  // null: scrolled out of sight
            if (!action || !at || key_name(*action, desk.strings).empty()) continue;
            EXPECT_FALSE(shows_in(desk, *at, key_name(*action, desk.strings))) << row;
            ++seen;
        }
    }
    EXPECT_GT(seen, 20);
}

TEST_F(MenuBar, RequestsTheActionOfEachRow) {
    desk.view.timeline = {0, 900, {60}};
    desk.now.tick = 600;
    desk.view.program.preferences.type_size = 1.5f;
    desk.open_exercise();
    desk.lesson.attempt.answers.prediction = 0;  // else Play asks for it first
    desk.now.tick = 600;
    desk.frame(2);
    int chosen = 0;
    for (const auto& [menu, row] : std::vector<std::pair<std::string, std::string>>{{"file", "screenshot"},
                                                                                    {"file", "exit"},
                                                                                    {"edit", "undo"},
                                                                                    {"edit", "redo"},
                                                                                    {"edit", "duplicate"},
                                                                                    {"edit", "erase"},
                                                                                    {"edit", "next_vehicle"},
                                                                                    {"edit", "previous_vehicle"},
                                                                                    {"edit", "add"},
                                                                                    {"edit", "remove"},
                                                                                    {"view", "sensors"},
                                                                                    {"view", "outlines"},
                                                                                    {"view", "next_field"},
                                                                                    {"view", "home"},
                                                                                    {"view", "follow"},
                                                                                    {"view", "birds_eye"},
                                                                                    {"view", "drivers_eye"},
                                                                                    {"view", "wiring"},
                                                                                    {"view", "full_screen"},
                                                                                    {"view", "theme"},
                                                                                    {"view", "larger"},
                                                                                    {"view", "smaller"},
                                                                                    {"simulation", "play_pause"},
                                                                                    {"simulation", "step"},
                                                                                    {"simulation", "step_back"},
                                                                                    {"simulation", "rewind"},
                                                                                    {"simulation", "fast_forward"},
                                                                                    {"simulation", "reset"},
                                                                                    {"simulation", "new_population"},
                                                                                    {"simulation", "slower"},
                                                                                    {"simulation", "faster"},
                                                                                    {"simulation", "set_bookmark"},
                                                                                    {"simulation", "last_bookmark"},
                                                                                    {"simulation", "drive"},
                                                                                    {"exercises", "hint"},
                                                                                    {"exercises", "exercise_reset"},
                                                                                    {"lecture", "lecture"}}) {
        desk.all.clear();
        desk.panels.menu_bar.open.clear();
        desk.rest();
        desk.choose(menu, row);
        EXPECT_EQ(desk.actions(), std::vector{*action_named(row)}) << menu << "." << row;
        ++chosen;
    }
    EXPECT_EQ(chosen, 37);
}

TEST_F(MenuBar, OpensTheSheetsOfItsRows) {
    FilesView files;
    desk.view.documents.files = &files;
    desk.view.program.version = "9.8.7";
    std::map<std::string, FileKind> kinds;
    for (const auto& [menu, row, sheet] : {std::tuple{"file", "open", Sheet::files},
                                           {"file", "save", Sheet::files},
                                           {"file", "save_as", Sheet::files},
                                           {"file", "save_run", Sheet::files},
                                           {"file", "save_brain", Sheet::files},
                                           {"edit", "settings", Sheet::settings},
                                           {"help", "keys", Sheet::keys},
                                           {"help", "glossary", Sheet::glossary},
                                           {"help", "about", Sheet::about}}) {
        desk.panels.sheet = Sheet::none;
        desk.rest();
        desk.choose(menu, row);
        EXPECT_EQ(desk.panels.sheet, sheet) << row;
        EXPECT_EQ(opened(), "") << row;
        EXPECT_TRUE(desk.actions().empty()) << row;
        kinds[row] = desk.panels.sheets.files.kind;
    }
    EXPECT_EQ(kinds["save_as"], FileKind::scene);
    EXPECT_EQ(kinds["save_run"], FileKind::run);
    EXPECT_EQ(kinds["save_brain"], FileKind::brain);
    desk.frame(3);
    EXPECT_TRUE(shows_in(desk, desk.where("card.about"), "Version 9.8.7"));
    EXPECT_TRUE(shows_in(desk, desk.where("card.about"), "Dear ImGui"));
    press({key::escape});
    EXPECT_FALSE(desk.anchors.find("card.about"));
    desk.choose("view", "charts");
    EXPECT_TRUE(desk.panels.charts.open);
}

TEST_F(MenuBar, KeepsEachRowInItsPlaceWhenFilesWereOpened) {
    const std::vector<RecentFile> recent{{"/y/mine.toml"}, {"/y/old.run"}};
    const auto places = [&] {
        desk.click("menu.file");
        desk.frame(2);
        std::vector<float> found;
        for (const Action action : actions_in(Menu::file)) {
            const std::string row = "menu.file." + std::string(name(action));
            found.push_back(desk.where(row).y);
        }
        desk.key({key::escape});
        desk.frame(2);
        return found;
    };
    const auto before = places();
    desk.view.documents.recent = &recent;
    desk.frame(2);
    EXPECT_EQ(places(), before);
}

TEST_F(MenuBar, OpensRecentFilesAndTheCatalogue) {
    const std::vector<RecentFile> recent{{"/y/mine.toml"}, {"/y/old.run"}};
    const std::vector<CatalogueEntry> catalogue{{"05-aggressor", "/x/5.toml", "Aggressor", "", 5},
                                                {"2a-coward", "/x/2a.toml", "Coward", "It turns away."},
                                                {"empty", "/x/empty.toml", "Empty scene", ""}};
    desk.view.documents.recent = &recent;
    desk.view.documents.catalogue = &catalogue;
    for (const auto& [menu, row, path] : {std::tuple{"file", "recent.2", "/y/old.run"},
                                          {"file", "new_scene", "/x/empty.toml"},
                                          {"exercises", "05-aggressor", "/x/5.toml"},
                                          {"exercises", "2a-coward", "/x/2a.toml"}}) {
        desk.all.clear();
        desk.rest();
        desk.choose(menu, row);
        ASSERT_EQ(desk.all.size(), 1u) << row;
        EXPECT_EQ(std::get<OpenRequest>(desk.all[0]).path, path);
    }
}

TEST_F(MenuBar, ListsTheLecturesAboveTheRowsOfAnOpenOne) {
    const std::vector<CatalogueEntry> lectures{{"four-numbers", "/x/four.toml", "Four numbers", ""}};
    desk.view.documents.lectures = &lectures;
    desk.rest();
    desk.click("menu.lecture"), desk.rest();
    EXPECT_GT(desk.where("menu.lecture.four-numbers").y, desk.where("menu.lecture.lecture").y);
    EXPECT_LT(desk.where("menu.lecture.four-numbers").y, desk.where("menu.lecture.next_page").y);
}

TEST_F(MenuBar, ALongNameOfAnExerciseIsItsFirstSentenceOrEndsBeforeAComma) {
    const std::string rest = " and so on without an end that fits into any menu of this window, however wide it is";
    const std::vector<CatalogueEntry> catalogue{{"a", "/a", "It rests at the lamp. It turns" + rest, "", 1},
                                                {"b", "/b", "It circles the red lamp, 3.5 m away" + rest, "", 2}};
    desk.view.documents.catalogue = &catalogue;
    desk.frame(2);
    open("exercises");
    const auto is_written = [&](std::string_view words) {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& w) { return w.words == words; });
    };
    EXPECT_TRUE(is_written("1  It rests at the lamp."));
    EXPECT_TRUE(is_written("2  It circles the red lamp …"));
}

TEST_F(MenuBar, EditsTheDiagramWhileWiring) {
    desk.view.mode = Mode::wiring;
    desk.frame(3);
    desk.choose("edit", "select_all");
    desk.frame(2);
    EXPECT_FALSE(desk.panels.canvas.selection.empty());
    EXPECT_TRUE(desk.all.empty());
}

TEST_F(MenuBar, OpensTheMenuOfTheSelectedObject) {
    const CameraView camera_view =
        look(Camera{}, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, {300, 60, 600, 600});
    desk.view.camera_view = &camera_view;
    desk.frame(2);
    desk.choose("edit", "scene_menu");
    desk.frame(2);
    EXPECT_TRUE(desk.panels.scene_input.menu.open);
    EXPECT_EQ(desk.panels.scene_input.menu.object, vehicle_object(0));
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.brains");
}

TEST_F(MenuBar, DimsARowThatCannotBeUsedAndTellsWhy) {
    desk.view.undo_depth = 0;
    desk.click("menu.edit");
    const auto tells = [&](std::string_view row, std::string_view why) {
        desk.point(row);
        desk.frame(60);
        const auto tip = [&](const Written& w) { return w.words == desk.strings(why); };
        return std::any_of(desk.written.begin(), desk.written.end(), tip);
    };
    EXPECT_TRUE(tells("menu.edit.undo", "unavailable.undo"));
    EXPECT_TRUE(tells("menu.edit.tidy", "unavailable.wiring_only"));
    EXPECT_TRUE(tells("menu.edit.paste", "wiring.refused.nothing_copied"));
    EXPECT_TRUE(tells("menu.edit.take_back", "unavailable.no_polygon"));
    desk.click("menu.edit.undo");
    EXPECT_TRUE(desk.actions().empty());
    EXPECT_EQ(opened(), "edit") << "a dimmed row does not close the menu";
    desk.click("menu.edit.redo");
    EXPECT_EQ(desk.actions(), std::vector{Action::redo});
}

TEST_F(MenuBar, CanBeUsedByKeysAlone) {
    press({'2'});
    ASSERT_EQ(desk.panels.keyboard.focus, "slider.LR");
    press({key::f10});
    EXPECT_EQ(opened(), "file");
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.file.open") << "no shipped scene is empty";
    press({key::left});
    EXPECT_EQ(opened(), "help");
    press({key::right});
    press({key::right});
    EXPECT_EQ(opened(), "edit");
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.edit.undo");
    press({key::down});
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.edit.redo");
    press({key::down});
    press({key::down});
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.edit.copy");
    press({key::down});
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.edit.duplicate") << "a dimmed row is left out: nothing can be pasted";
    for (int i = 0; i < 3; ++i) press({key::up});
    press({key::enter});
    EXPECT_EQ(desk.actions(), std::vector{Action::redo});
    EXPECT_EQ(opened(), "");
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.LR") << "the focus returns";
    press({key::alt});
    EXPECT_EQ(opened(), "file");
    press({'R'});
    EXPECT_EQ(opened(), "file") << "other keys wait";
    press({key::escape});
    EXPECT_EQ(opened(), "");
    EXPECT_EQ(desk.panels.keyboard.focus, "slider.LR");
    EXPECT_EQ(desk.actions(), std::vector{Action::redo});
}

TEST_F(MenuBar, UsesKeysThatArriveInOneFrame) {
    for (const KeyPress key :
         {KeyPress{key::f10}, KeyPress{key::right}, KeyPress{key::right}, KeyPress{key::right}, KeyPress{key::down}})
        desk.key(key);
    desk.frame(3);
    EXPECT_EQ(opened(), "simulation");
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.simulation.step");
    press({key::escape});
    EXPECT_EQ(desk.panels.keyboard.focus, "");
}

TEST_F(MenuBar, ExportsTheChart) {
    desk.now.tick = 600, desk.now.seconds = 10;
    desk.frame(2);
    desk.choose("file", "export_csv");
    ASSERT_EQ(desk.all.size(), 1u);
    EXPECT_EQ(std::get<ExportRequest>(desk.all[0]).name, "signals");
}

TEST_F(MenuBar, PlaysAndListsTheKeysWhileAMenuIsOpen) {
    press({key::f10});
    press({' '});
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause});
    EXPECT_EQ(opened(), "file");
    press({key::f1});
    EXPECT_EQ(desk.panels.sheet, Sheet::keys);
    EXPECT_EQ(opened(), "");
}

TEST_F(MenuBar, FollowsThePointerFromTitleToTitle) {
    desk.point("menu.edit");
    desk.frame(3);
    EXPECT_EQ(opened(), "") << "no menu opens before a click";
    desk.click("menu.file");
    EXPECT_EQ(opened(), "file");
    desk.point("menu.edit");
    desk.frame(2);
    EXPECT_EQ(opened(), "edit");
    press({key::right});
    EXPECT_EQ(opened(), "view") << "a pointer at rest does not take the menu back";
    desk.click("menu.edit");
    EXPECT_EQ(opened(), "edit");
    desk.click("menu.edit");
    EXPECT_EQ(opened(), "") << "a click on the title of the open menu closes it";
}

TEST_F(MenuBar, IsGoneInALectureAndWhileASheetIsOpen) {
    desk.click("menu.file");
    desk.view.lecture = true;
    desk.frame(3);
    EXPECT_EQ(opened(), "");
    EXPECT_FALSE(desk.anchors.find("menu.file"));
    press({key::f10});
    EXPECT_EQ(opened(), "");
    EXPECT_EQ(desk.layout.toolbar.y, 0);
}

TEST(MenuBarInEachWindow, KeepsEveryRowInsideTheWindow) {
    struct Size {
        float width, height, scale;
    };
    std::vector<CatalogueEntry> catalogue{{"05-aggressor", "5.toml", "Aggressor", "", 5}};
    for (int i = 0; i < 14; ++i) {
        const std::string number = std::to_string(i);
        catalogue.push_back({"scene-" + number, number + ".toml", "A scene of that number " + number, ""});
    }
    const std::vector<RecentFile> recent(9,
                                         {"/y/a-file-with-a-name-that-is-much-longer-than-a-menu-is-wide-2026.toml"});
    for (const std::string& code : shipped_codes())
        for (const Size size : {Size{940, 570, 1}, {800, 600, 1}, {1024, 768, 1}, {2048, 1536, 2}, {1880, 1140, 2}}) {
            Desk small(size.width, size.height, size.scale, true);
            small.strings = speaking(code);
            small.view.documents.catalogue = &catalogue;
            small.view.documents.recent = &recent;
            small.frame(2);
            EXPECT_LT(small.where("menu.help").x + small.where("menu.help").w, size.width);
            for (const std::string& menu : menus) {
                small.panels.menu_bar.open = menu;
                small.frame(3);
                const Rect panel = small.where("menu.rows");
                EXPECT_LE(panel.x + panel.w, size.width) << menu;
                EXPECT_LE(panel.y + panel.h, size.height) << menu;
                for (const std::string& row : rows_of(small)) {
                    const Rect at = small.where("menu." + menu + "." + row);
                    EXPECT_GE(at.h, 18 * size.scale) << menu << "." << row << " is not scrolled out of sight, " << code;
                    EXPECT_LE(at.y + at.h, panel.y + panel.h) << menu << "." << row;
                }
                for (const Written& each : small.written)
                    if (panel.contains(each.rect.x, each.rect.y) &&
                        std::fabs(each.clip.x - panel.x - 4 * size.scale) < 2) {
                        EXPECT_LE(each.rect.y + each.rect.h, each.clip.y + each.clip.h)
                            << each.words << " is whole, " << code << " " << size.height;
                    }
            }
        }
}

TEST(MenuBarInEachWindow, OpensAtTheRowOfTheOpenFileWhereverItWasScrolledBefore) {
    Desk low(940, 300, 1, true);
    std::vector<CatalogueEntry> catalogue;
    for (int i = 1; i <= 22; ++i) {
        const std::string number = std::to_string(i);
        catalogue.push_back({"exercise-" + number, number + ".toml", "Title " + number, "", i});
    }
    low.view.documents.catalogue = &catalogue;
    const auto is_in_sight = [&](const std::string& name) {
        const Rect *row = low.anchors.find("menu.exercises." + name), panel = low.where("menu.rows");
        return row && row->y >= panel.y && row->y + row->h <= panel.y + panel.h;
    };
    for (const char* opened : {"exercise-11", "exercise-22", "exercise-3"}) {
        low.view.documents.opened = opened;
        low.frame(2);
        low.panels.menu_bar.open = "exercises";
        low.frame(3);
        EXPECT_TRUE(is_in_sight(opened)) << opened;
        const Rect panel = low.where("menu.rows");
        low.point(panel.x + panel.w / 2, panel.y + panel.h / 2);
        for (int i = 0; i < 5; ++i) ImGui::GetIO().MouseWheel = -5, low.frame(2);
        low.panels.menu_bar.open.clear();
        low.frame(2);
    }
}

TEST(MenuBarInEachWindow, OpensAtTheFirstExerciseWhileASceneIsOpen) {
    Desk low(940, 300, 1, true);
    std::vector<CatalogueEntry> catalogue;
    for (int i = 1; i <= 22; ++i) {
        const std::string number = std::to_string(i);
        catalogue.push_back({"exercise-" + number, number + ".toml", "Title " + number, "", i});
    }
    catalogue.push_back({"4a-orbit", "4a.toml", "Orbit", ""});
    low.view.documents.catalogue = &catalogue;
    low.view.documents.opened = "4a-orbit";
    low.frame(2);
    low.panels.menu_bar.open = "exercises";
    low.frame(3);
    const Rect *row = low.anchors.find("menu.exercises.exercise-1"), panel = low.where("menu.rows");
    ASSERT_TRUE(row);
    EXPECT_GE(row->y, panel.y);
}

TEST(MenuBarInEachWindow, OpensWithItsFirstRowsWhereTheRowOfTheOpenFileIsInSightToo) {
    Desk low(800, 600, 1, true);
    std::vector<CatalogueEntry> catalogue;
    for (int i = 1; i <= 22; ++i) {
        const std::string number = std::to_string(i);
        catalogue.push_back({"exercise-" + number, number + ".toml", "Title " + number, "", i});
    }
    for (int i = 1; i <= 20; ++i)  // below the exercises: they do not fit
        catalogue.push_back({"scene-" + std::to_string(i), std::to_string(i) + ".toml", "A scene", ""});
    low.view.documents.catalogue = &catalogue;
    for (const int opened : {1, 6, 18}) {
        low.view.documents.opened = "exercise-" + std::to_string(opened);
        low.frame(2);
        low.panels.menu_bar.open = "exercises";
        low.frame(3);
        const Rect panel = low.where("menu.rows");
        for (const std::string& row : {std::string("hint"), low.view.documents.opened}) {
            const Rect* at = low.anchors.find("menu.exercises." + row);
            ASSERT_TRUE(at) << row << ", " << opened;
            EXPECT_TRUE(at->y >= panel.y && at->y + at->h <= panel.y + panel.h) << row << ", " << opened;
        }
        low.panels.menu_bar.open.clear();
        low.frame(2);
    }
}

TEST(MenuBarInEachWindow, ScrollsToTheFocusWhereTheWindowIsTooLow) {
    Desk low(940, 300, 1, true);
    low.frame(2);
    low.key({'E'});
    low.frame(2);
    EXPECT_FALSE(low.anchors.find("menu.view.theme"));
    for (int i = 0; i < 40 && low.panels.keyboard.focus != "menu.view.theme"; ++i) low.key({key::down}), low.frame(2);
    ASSERT_EQ(low.panels.keyboard.focus, "menu.view.theme");
    low.frame(2);
    EXPECT_TRUE(low.anchors.find("menu.view.theme"));
}

TEST_F(MenuBar, SwitchesOverlaysAndStaysOpen) {
    desk.click("menu.view");
    desk.frame(2);
    for (const auto& [row, action] : {std::pair{"menu.view.trails", Action::trails},
                                      {"menu.view.surfaces", Action::surfaces},
                                      {"menu.view.memory", Action::memory},
                                      {"menu.view.labels", Action::labels},
                                      {"menu.view.sensors", Action::sensors},
                                      {"menu.view.outlines", Action::outlines}}) {
        desk.all.clear();
        desk.click(row);
        EXPECT_EQ(desk.actions(), std::vector{action}) << row;
        desk.frame(1);
    }
    EXPECT_TRUE(desk.anchors.find("menu.rows"));
}

TEST_F(MenuBar, OffersTheFieldsOfTheChannelsInTheScene) {
    desk.click("menu.view");
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("menu.view.field.smell"));
    EXPECT_FALSE(desk.anchors.find("menu.view.field.heat"));
    desk.click("menu.view.field.smell");
    ASSERT_TRUE(wanted());
    EXPECT_EQ(wanted()->field, Channel::smell);
    desk.view.settings.overlays.field = Channel::smell;
    desk.frame(1);
    desk.click("menu.view.field.none");
    EXPECT_EQ(wanted()->field, std::nullopt);
}

TEST_F(MenuBar, ConsumesTheClickThatClosesIt) {
    desk.click("menu.view");
    desk.frame(2);
    ASSERT_TRUE(desk.anchors.find("menu.rows"));
    desk.click("button.wiring");
    EXPECT_FALSE(desk.anchors.find("menu.rows"));
    EXPECT_TRUE(desk.actions().empty());
    desk.click("button.wiring");
    EXPECT_EQ(desk.actions(), std::vector{Action::wiring});
    desk.click("menu.view");
    desk.frame(2);
    desk.click("menu.view");
    EXPECT_FALSE(desk.anchors.find("menu.rows")) << "its title closes it too";
}

TEST(PresetsMenu, EndsInsideALowWindow) {
    Desk desk(1280, 640, 2);
    desk.panels.brain.presets.wanted = true;
    desk.frame(4);
    ASSERT_TRUE(desk.panels.brain.presets.open);
    const Rect last = desk.where("preset.load");
    EXPECT_GT(last.h, 40) << "not clipped";
    EXPECT_LE(last.y + last.h, 640);
    EXPECT_GE(desk.where("preset." + std::string(presets().front().name)).y, 0);
}

TEST(PresetsMenu, ConsumesTheClickThatClosesIt) {
    Desk desk;
    desk.frame(2);
    desk.click("button.presets");
    desk.frame(2);
    ASSERT_TRUE(desk.panels.brain.presets.open);
    desk.click("button.play");
    EXPECT_FALSE(desk.panels.brain.presets.open);
    EXPECT_TRUE(desk.actions().empty());
}

TEST_F(MenuBar, OpensByOneClickWhileThePresetsAreOpenAndTheReverse) {
    desk.click("button.presets");
    ASSERT_TRUE(desk.panels.brain.presets.open);
    desk.click("menu.view");
    EXPECT_FALSE(desk.panels.brain.presets.open);
    EXPECT_TRUE(desk.anchors.find("menu.rows"));
    desk.rest();
    desk.click("button.presets");
    EXPECT_TRUE(desk.panels.brain.presets.open);
    EXPECT_FALSE(desk.anchors.find("menu.rows"));
    EXPECT_TRUE(desk.all.empty()) << "the clicks do nothing else";
}

TEST_F(MenuBar, GivesWayToTheMenuOfTheSceneOnARightClick) {
    const CameraView camera_view =
        look(Camera{}, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, {300, 60, 600, 600});
    desk.view.camera_view = &camera_view;
    const auto right_click = [&] {
        desk.point(640, 640);
        desk.frame(2);
        desk.button(1, true);
        desk.frame(2);
        desk.button(1, false);
        desk.frame(3);
    };
    desk.click("menu.view");
    ASSERT_TRUE(desk.anchors.find("menu.rows"));
    right_click();
    EXPECT_FALSE(desk.anchors.find("menu.rows"));
    EXPECT_TRUE(desk.panels.scene_input.menu.open);
    desk.rest();
    desk.click("button.presets");
    EXPECT_TRUE(desk.panels.brain.presets.open);
    EXPECT_FALSE(desk.panels.scene_input.menu.open);
    right_click();
    EXPECT_FALSE(desk.panels.brain.presets.open);
    EXPECT_TRUE(desk.panels.scene_input.menu.open);
    desk.rest();
    desk.click("menu.view");
    EXPECT_FALSE(desk.panels.scene_input.menu.open);
    EXPECT_TRUE(desk.anchors.find("menu.rows"));
}

TEST_F(MenuBar, OpensTheViewMenuOnItsKey) {
    press({'E'});
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.view.sensors");
    press({key::down});
    press({key::down});
    EXPECT_EQ(desk.panels.keyboard.focus, "menu.view.trails");
    press({key::enter});
    EXPECT_EQ(desk.actions(), std::vector{Action::trails});
    EXPECT_TRUE(desk.anchors.find("menu.rows")) << "a switch leaves the menu open";
    press({key::escape});
    EXPECT_FALSE(desk.anchors.find("menu.rows"));
}

TEST(MenuBarType, IsOfOneSizeInEachMenu) {
    const std::vector<CatalogueEntry> catalogue{
        {"01-drive", "/x/01-drive.toml", "Drive", "", 1},
        {"02-long", "/x/02-long.toml", "Make the vehicle follow the line for a whole lap without leaving it once", "",
         2}};
    for (const float width : {512.0f, 1280.0f})
        for (const std::string& menu : menus) {
            Desk desk(width, 1024, 1, true);
            desk.view.program.touch = true, desk.view.program.finger = 57;
            desk.view.documents.catalogue = &catalogue;
            desk.frame(3);
            std::set<const void*> below;
            for (const Written& w : desk.written) below.insert(w.sheet);
            desk.panels.menu_bar.open = menu;
            desk.frame(3);
            std::set<float> sizes;
            for (const std::string& row : rows_of(desk))
                if (const Rect* at = desk.anchors.find("menu." + menu + "." + row))
                    for (const Written& w : desk.written)
                        if (!below.contains(w.sheet) && w.rect.y >= at->y && w.rect.y + w.rect.h <= at->y + at->h)
                            sizes.insert(w.size);
            EXPECT_EQ(sizes.size(), 1u) << menu << width;
        }
}

}  // namespace braitenlab::tests::menu_bar_test
