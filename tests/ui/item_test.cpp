// Every widget has a tooltip for a resting pointer.
#include "ui/widgets/item.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "desk.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"

namespace braitenlab::tests::item_test {

using namespace ui;

namespace {

// Opens every screen of the lab and rests the pointer on every widget.
struct Walk {
    std::set<std::string> all, told;

    void look(Desk& desk) {
        desk.frame(4);
        std::set<std::string> here;
        for (const Shown& shown : desk.shown) here.insert(shown.id);
        for (const std::string& id : here)
            if (all.insert(id).second || !told.count(id)) rest_on(desk, id);
        desk.point(-100, -100);
        desk.frame(2);
    }

    // At several points: another widget may cover a part, or a part may have no tooltip.
    void rest_on(Desk& desk, const std::string& id) {
        for (const float across : {0.5f, 0.1f, 0.3f, 0.9f})
            for (const float down : {0.5f, 0.15f}) {
                const Rect* r = desk.anchors.find(id);
                if (!r || told.count(id)) return;
                desk.point(r->x + r->w * across, r->y + r->h * down);
                desk.frame(2);
                for (const Shown& shown : desk.shown)
                    if (shown.has_tooltip) told.insert(shown.id);
            }
    }
};

}  // namespace

TEST(Item, HasATooltipOnEveryWidgetOfEveryScreen) {
    const std::vector<CatalogueEntry> catalogue{{"05-aggressor", "5.toml", "Aggressor", "", 5},
                                                {"2a-coward", "2a.toml", "Coward", "It turns away."}};
    const std::vector<RecentFile> recent{{"/y/mine.toml"}};
    FilesView files;
    files.listing = {"/home/me", {{"pictures", true}, {"mine.toml", false, FileKind::scene}}, ""};
    const RecoveryOffer offer{"Coward", "", "2026-03-01 10:42:05"};
    Walk walk;
    for (const bool exercise : {false, true}) {
        Desk desk(1280, 1400);
        desk.view.documents.catalogue = &catalogue;
        desk.view.documents.recent = &recent;
        desk.view.documents.files = &files;
        if (exercise) desk.open_exercise();
        walk.look(desk);
        desk.view.mode = Mode::wiring;
        walk.look(desk);
        desk.view.mode = Mode::paused;
        for (const KeyPress opens :
             {KeyPress{key::f1}, KeyPress{',', true}, KeyPress{'O', true}, KeyPress{'S', true}}) {
            desk.key(opens);
            walk.look(desk);
            for (int place = 1; place <= 2; ++place)
                desk.panels.sheets.files.place = static_cast<FilesPlace>(place), walk.look(desk);
            desk.key({key::escape});
        }
        desk.frame(2);
        desk.click("button.presets");
        walk.look(desk);
        desk.key({key::escape});
        desk.view.documents.recovery = &offer;
        walk.look(desk);
        desk.view.documents.recovery = nullptr;
        files.leaving = Leaving{"Coward", "/y/mine.toml"};
        walk.look(desk);
        files.leaving.reset();
        desk.view.lecture = true;
        walk.look(desk);
    }
    EXPECT_GT(walk.all.size(), 60u) << "the walk finds widgets";
    for (const std::string& id : walk.all) EXPECT_TRUE(walk.told.count(id)) << id << " has no tooltip";
}

TEST(Item, ShowsItsTooltipWhenThePointerRestsAndAtOnceAfterAnother) {
    Desk desk(1280, 800, 1, true);
    desk.view.mode = Mode::playing;
    desk.frame(3);
    const auto shown = [&](const char* key) {
        for (const Written& w : desk.written)
            if (w.words == desk.strings(key)) return true;
        return false;
    };
    for (int i = 0; i < 60; ++i) {
        desk.point("button.follow", 0.2f + 0.01f * static_cast<float>(i));
        desk.frame(1);
    }
    EXPECT_FALSE(shown("tooltip.follow")) << "the pointer moves for a second";
    desk.frame(26);
    EXPECT_FALSE(shown("tooltip.follow")) << "it has rested for less than half a second";
    desk.frame(8);
    EXPECT_TRUE(shown("tooltip.follow"));
    desk.point("button.wiring");
    desk.frame(2);
    EXPECT_TRUE(shown("tooltip.wiring")) << "at once";
    desk.point(640, 400);
    desk.frame(30);
    desk.point("button.wiring");
    desk.frame(2);
    EXPECT_FALSE(shown("tooltip.wiring")) << "half a second without a tooltip";
}

namespace {

// The widgets of every screen that are lower or narrower than this, one a line. `finger`: 0, or its height in a
// browser.
std::string small_targets(float least_width, float least_height, float finger, const std::set<std::string>& but = {}) {
    std::set<std::string> small;
    const auto look = [&](Desk& desk) {
        desk.view.program.touch = finger > 0, desk.view.program.finger = finger;
        desk.frame(4);
        for (const Shown& each : desk.shown)
            if (each.enabled && (each.rect.w < least_width - 0.5f || each.rect.h < least_height - 0.5f) &&
                std::none_of(but.begin(), but.end(), [&](const std::string& id) { return each.id.starts_with(id); }))
                small.insert(each.id + " " + std::to_string(each.rect.w) + "×" + std::to_string(each.rect.h));
    };
    for (const bool exercise : {false, true}) {
        Desk desk(1280, 1400, 1, true);
        FilesView files;
        files.listing = {"/home/me", {{"pictures", true}, {"mine.toml", false, FileKind::scene}}, ""};
        const std::vector<CatalogueEntry> catalogue{{"05-aggressor", "5.toml", "Aggressor", "", 5}};
        const std::vector<RecentFile> recent{{"/y/mine.toml"}};
        desk.view.documents.files = &files, desk.view.documents.catalogue = &catalogue,
        desk.view.documents.recent = &recent;
        desk.view.timeline.latest = 600, desk.view.timeline.bookmarks = {60};
        if (exercise) desk.open_exercise();
        look(desk);
        for (const Mode mode : {Mode::playing, Mode::wiring, Mode::paused}) {
            desk.view.mode = mode;
            look(desk);
        }
        desk.panels.card(Card::sensors).folded = false, desk.panels.sensors.channel_open = true;
        desk.panels.sensors.quality_open = true, desk.panels.charts.open = true;
        desk.panels.charts.strips = {"SL"};
        for (const Chart chart :
             {Chart::signals, Chart::all, Chart::chosen, Chart::population, Chart::energy, Chart::bars}) {
            desk.panels.charts.shown = chart;
            look(desk);
        }
        desk.panels.charts.open = false;
        desk.now.vehicles[0].driver = Driver::manual;
        look(desk);
        for (const char* menu : {"file", "edit", "view", "simulation", "exercises", "lecture", "help"}) {
            desk.panels.menu_bar.open = menu;
            look(desk);
        }
        desk.panels.menu_bar.open.clear();
        desk.click("button.presets");
        look(desk);
        desk.key({key::escape});
        for (const Sheet sheet : {Sheet::keys, Sheet::settings, Sheet::about, Sheet::files, Sheet::glossary}) {
            desk.panels.sheet = sheet;
            look(desk);
            desk.panels.sheet = Sheet::none;
        }
        desk.view.lecture = true;
        look(desk);
    }
    std::string all;
    for (const std::string& each : small) all += each + "\n";
    return all;
}

}  // namespace

TEST(Item, HasATargetOfAtLeast24PixelsOnEveryScreen) { EXPECT_EQ(small_targets(24, 24, 0), ""); }

// Not words of the glossary within a text, parts of the picture of a brain, bookmarks on the track of the timeline, the
// border beside the diagram and the rows of steps in a low card: higher ones would leave no room for the outcome.
TEST(Item, IsAsHighAsAFingerNeedsOnEveryScreen) {
    EXPECT_EQ(small_targets(24, 44, 44, {"term", "lesion", "bookmark", "canvas", "exercise.step."}), "");
}

TEST(Item, HasItsSizeAgainWhenTheMouseComesBack) {
    Desk desk(1024, 768, 1, true);
    desk.frame(3);
    const Rect before = desk.where("slider.LL"), undo = desk.where("button.undo");
    desk.view.program.touch = true, desk.view.program.finger = 44;
    desk.frame(3);
    EXPECT_GE(desk.where("slider.LL").h, 44);
    EXPECT_GE(desk.where("button.undo").w, 44);
    desk.view.program.touch = false;
    desk.frame(3);
    EXPECT_EQ(desk.where("slider.LL").h, before.h);
    EXPECT_EQ(desk.where("button.undo").h, undo.h);
}

TEST(Item, HidesItsTooltipAfterTheReadingTimeAndAfterAPress) {
    Desk desk(1280, 800, 1, true);
    desk.view.mode = Mode::playing;
    desk.frame(3);
    const auto shown = [&] {
        for (const Written& w : desk.written)
            if (w.words == desk.strings("tooltip.follow")) return true;
        return false;
    };
    desk.point("button.follow");
    desk.frame(10);
    EXPECT_FALSE(shown()) << "no tooltip under a moving pointer";
    desk.frame(50);
    EXPECT_TRUE(shown());
    desk.frame(600);
    EXPECT_FALSE(shown()) << "it uncovers the widgets below after some time";
    desk.point(640, 400);
    desk.frame(5);
    desk.point("button.follow");
    desk.frame(60);
    EXPECT_TRUE(shown()) << "shown again after the pointer returns";
    desk.button(0, true);
    desk.frame(3);
    desk.button(0, false);
    desk.frame(90);
    EXPECT_FALSE(shown()) << "no tooltip after a press";
}

// A key may move another widget below the resting pointer, as the search in the gallery does.
TEST(Item, HidesItsTooltipAfterAKeyUntilThePointerMoves) {
    Desk desk(1280, 800, 1, true);
    desk.frame(3);
    const auto shown = [&] {
        for (const Written& w : desk.written)
            if (w.words == desk.strings("tooltip.follow")) return true;
        return false;
    };
    for (const bool typed : {false, true}) {
        desk.point("button.follow", typed ? 0.4f : 0.5f);
        desk.frame(60);
        EXPECT_TRUE(shown());
        desk.key({key::first_modifier});
        desk.frame(2);
        EXPECT_TRUE(shown()) << "Shift alone does nothing";
        typed ? desk.type("x") : desk.key({key::down});
        desk.frame(2);
        EXPECT_FALSE(shown()) << typed;
        desk.frame(120);
        EXPECT_FALSE(shown()) << "the pointer rests " << typed;
    }
}

TEST(Item, ShowsNoTooltipOfWhatComesUnderThePointerByAPress) {
    Desk desk;
    desk.frame(3);
    desk.click("button.play");
    EXPECT_TRUE(desk.panels.tooltips.hidden);
    desk.point("button.step");
    desk.frame(2);
    EXPECT_FALSE(desk.panels.tooltips.hidden) << "until the pointer moves";
}

TEST(Item, IsRecordedWithAndWithoutATooltip) {
    Desk desk;
    desk.frame(2);
    Ui ui{desk.strings, palette(Theme::dark), {}, 1, desk.anchors, desk.asked};
    std::vector<Shown> shown;
    ui.shown = &shown;
    ImGui::NewFrame();
    const Item bare = item(ui, "bare", {10, 10});
    const Item told = item(ui, "told", {10, 10});
    tooltip(ui, told, "It is told.");
    tooltip(ui, bare, "");
    ImGui::Render();
    ASSERT_EQ(shown.size(), 2u);
    EXPECT_FALSE(shown[0].has_tooltip);
    EXPECT_TRUE(shown[1].has_tooltip);
}

TEST(Item, KeepsItsTooltipInsideTheWindow) {
    constexpr float width = 700, height = 500;
    const std::string words = "A tooltip that is long enough to be wrapped into several lines of small type.";
    const Rect cards[]{{0, 0, 200, 500},   {100, 0, 200, 500}, {250, 0, 200, 500}, {500, 0, 200, 500},
                       {260, 0, 440, 500}, {0, 0, 700, 40},    {0, 460, 700, 40}};
    for (const Rect& card : cards)
        for (const float across : {0.0f, 0.5f, 1.0f})
            for (const float down : {0.0f, 0.5f, 1.0f}) {
                Desk desk(width, height, 1, true);
                for (int i = 0; i < 40; ++i) {
                    desk.anchors.begin();
                    desk.written.clear();
                    Ui ui{desk.strings, palette(Theme::dark), test_fonts(1).loaded.fonts, 1, desk.anchors, desk.asked};
                    ui.written = &desk.written;
                    const ImVec2 at{card.x + across * (card.w - 20), card.y + down * (card.h - 20)};
                    desk.point(at.x + 10, at.y + 10);
                    ImGui::NewFrame();
                    begin_bar(ui, "bar", card);
                    ImGui::SetCursorScreenPos(at);
                    tooltip(ui, item(ui, "told", {20, 20}), words, "Ctrl+T");
                    end_bar();
                    ImGui::Render();
                }
                ASSERT_EQ(desk.written.size(), 2u) << "words and shortcut";
                for (const Written& w : desk.written) {
                    EXPECT_GE(w.rect.x, 10) << card.x << " " << across << " " << down;
                    EXPECT_GE(w.rect.y, 6) << card.x << " " << across << " " << down;
                    EXPECT_LE(w.rect.x + w.rect.w, width - 10) << card.x << " " << across << " " << down;
                    EXPECT_LE(w.rect.y + w.rect.h, height - 6) << card.x << " " << across << " " << down;
                }
            }
}

// Each widget of an exercise and of a scene, with the vehicle where the tooltip would be.
TEST(Item, HasATooltipThatCoversNeitherItNorTheVehicle) {
    int tooltips = 0;
    for (const bool has_exercise : {false, true})
        for (const auto& [width, height] : {std::pair{800.0f, 600.0f}, {1280.0f, 800.0f}}) {
            Desk desk(width, height, 1, true);
            if (has_exercise) desk.open_exercise();
            desk.frame(4);
            Camera camera;
            camera.mode = CameraMode::birds_eye;
            const CameraView sight =
                look(camera, desk.now.scene->arena, nullptr, desk.layout.window, desk.layout.scene);
            desk.view.camera_view = &sight;
            for (const Shown& each : std::vector<Shown>(desk.shown)) {
                const Rect* item = desk.anchors.find(each.id);
                if (!each.has_tooltip || !item || item->w < 8 || item->h < 8) continue;
                desk.now.vehicles[0].x = desk.now.vehicles[0].y = 0;
                for (const bool is_beside : {false, true}) {
                    desk.point(300, 300);
                    desk.frame(2);
                    desk.point(item->x + item->w / 2, item->y + item->h / 2);
                    desk.frame(40);
                    const Rect* tooltip = desk.anchors.find("tooltip");
                    if (!tooltip) break;
                    ++tooltips;
                    const Rect vehicle = desk.panels.tooltips.kept_free;
                    EXPECT_FALSE(tooltip->overlaps(*desk.anchors.find(each.id))) << each.id << " at " << width;
                    EXPECT_FALSE(tooltip->overlaps(vehicle)) << each.id << " at " << width;
                    const auto beside = unproject(sight, {tooltip->x + tooltip->w / 2, tooltip->y + tooltip->h / 2});
                    if (is_beside || !beside) break;
                    desk.now.vehicles[0].x = beside->x, desk.now.vehicles[0].y = beside->y;
                }
            }
        }
    EXPECT_GT(tooltips, 60);
}

TEST(Item, HasNoTooltipWhileTheMouseButtonIsDown) {
    Desk desk(800, 600, 1, true);
    desk.frame(4);
    const Rect slider = desk.where("slider.LL");
    desk.point(slider.x + slider.w / 2, slider.y + slider.h / 2);
    desk.frame(40);
    ASSERT_TRUE(desk.anchors.find("tooltip"));
    desk.button(0, true);
    for (int i = 0; i < 60; ++i) {
        desk.point(slider.x + slider.w / 2 + static_cast<float>(i % 7), slider.y + slider.h / 2);
        desk.frame(2);
        EXPECT_FALSE(desk.anchors.find("tooltip")) << i;
    }
}

TEST(Item, WhatAHintPointsAtHasALightBulbAndTheKeyboardFocusHasNone) {
    const auto has_bulb = [](Desk& desk) {
        const Rect slider = desk.where("slider.LL");
        return std::any_of(desk.written.begin(), desk.written.end(), [&](const Written& w) {
            return w.words == icon::hint && w.rect.x >= slider.x + slider.w && w.rect.x < slider.x + slider.w + 16 &&
                   w.rect.y >= slider.y && w.rect.y + w.rect.h <= slider.y + slider.h + 4;
        });
    };
    Desk desk(1280, 800, 1, true);
    desk.key({'1'});
    desk.frame(3);
    ASSERT_EQ(desk.panels.keyboard.focus, "slider.LL");
    EXPECT_FALSE(has_bulb(desk));
    desk.open_exercise();
    desk.lesson.attempt.work.has_run = true;
    desk.lesson.attempt.answers.prediction = 0;
    desk.view.mode = Mode::playing;
    desk.opened.hints = {{"Lower it.", "slider.LL"}};
    desk.lesson.attempt.answers.hints_shown = 1;
    desk.frame(3);
    EXPECT_TRUE(has_bulb(desk)) << "in the margin of the card, where it covers no number";
}

TEST(Item, TheLightBulbOfAHintIsBesideAPinAndNotOnIt) {
    for (const float width : {800.0f, 1280.0f}) {
        Desk desk(width, 600, 1, true);
        desk.now = shipped_scene("empty");
        desk.view.mode = Mode::wiring;
        desk.frame(5);
        ASSERT_EQ(desk.panels.prompts.highlight.anchor, "pin.SL.out");
        EXPECT_FALSE(desk.pointed_out.bulb.overlaps(desk.where("pin.SL.out"))) << width;
        EXPECT_GT(desk.pointed_out.bulb.w, 0);
    }
}

TEST(Item, HasARingOfAHintAroundItsWordsAndBothAreInsideTheCard) {
    struct {
        float width, height, scale;
    } const windows[]{{1280, 800, 1}, {1024, 768, 1}, {2560, 1600, 2}};
    for (const auto& window : windows)
        for (const char* asked : {"slider.LL", "slider.RR", "exercise.predict", "button.play"}) {
            Desk desk(window.width, window.height, window.scale, true);
            desk.open_exercise();
            const std::string id = asked;
            if (id.starts_with("slider")) {
                desk.lesson.attempt.work.has_run = true, desk.lesson.attempt.answers.prediction = 0;
                desk.view.mode = Mode::playing;
                desk.opened.hints = {{"Lower it.", asked}};
                desk.lesson.attempt.answers.hints_shown = 1;
            } else if (id == "button.play") {
                desk.lesson.attempt.answers.prediction = 0;
            }
            desk.frame(4);
            ASSERT_EQ(desk.panels.prompts.highlight.anchor, id) << window.width;
            SCOPED_TRACE(id + " in a window of " + std::to_string(window.width));
            const Rect row = desk.where(id), ring = desk.pointed_out.ring, bulb = desk.pointed_out.bulb;
            const Rect card = id == "button.play"        ? desk.layout.toolbar
                              : id == "exercise.predict" ? desk.where("card.exercise")
                                                         : desk.where("card.brain");
            const auto contains = [](const Rect& outer, const Rect& inner, float across, float down) {
                return outer.x + across <= inner.x && outer.x + outer.w - across >= inner.x + inner.w &&
                       outer.y + down <= inner.y && outer.y + outer.h - down >= inner.y + inner.h;
            };
            EXPECT_TRUE(contains(card, ring, 0, 0));
            EXPECT_TRUE(contains(card, bulb, 0, 0));
            EXPECT_LE(std::fabs(bulb.y + bulb.h / 2 - ring.y), 16 * window.scale) << "at the upper corner";
            int texts = 0;
            for (const Written& w : desk.written) {
                const float x = w.rect.x + w.rect.w / 2, y = w.rect.y + w.rect.h / 2;
                if (w.words == icon::hint || !row.contains(x, y)) continue;
                ++texts;
                EXPECT_TRUE(contains(ring, w.rect, spacing::small * window.scale, spacing::tight * window.scale))
                    << w.words;
                const bool apart = bulb.x >= w.rect.x + w.rect.w || bulb.y + bulb.h <= w.rect.y ||
                                   bulb.x + bulb.w <= w.rect.x || bulb.y >= w.rect.y + w.rect.h;
                EXPECT_TRUE(apart) << w.words;
            }
            EXPECT_GE(texts, 1);
        }
}

TEST(Item, TheLightBulbOfAFoldedCardCoversNeitherItsWordsNorItsSign) {
    for (const float width : {800.0f, 1280.0f}) {
        Desk desk(width, width == 800 ? 600.0f : 800.0f, 1, true);
        desk.open_exercise();
        desk.lesson.attempt.work.has_run = true;
        desk.lesson.attempt.answers.prediction = 0;
        desk.view.mode = Mode::playing;
        desk.opened.hints = {{"Lower it.", "slider.LL"}};
        desk.lesson.attempt.answers.hints_shown = 1;
        desk.panels.card(Card::brain).folded = true;
        desk.frame(6);
        ASSERT_EQ(desk.panels.prompts.highlight.anchor, "card.brain.fold") << width;
        const Rect heading = desk.where("card.brain.fold"), bulb = desk.pointed_out.bulb;
        EXPECT_TRUE(bulb.overlaps(heading)) << width;
        int texts = 0;
        for (const Written& each : desk.written) {
            const float x = each.rect.x + each.rect.w / 2, y = each.rect.y + each.rect.h / 2;
            if (each.words == icon::hint || !heading.contains(x, y)) continue;
            const float letters = 0.2f * each.rect.h;  // above and below them the line is empty
            EXPECT_FALSE(bulb.overlaps({each.rect.x, each.rect.y + letters, each.rect.w, each.rect.h - 2 * letters}))
                << each.words << " " << width;
            ++texts;
        }
        EXPECT_EQ(texts, 2) << width;
    }
}

TEST(Item, ASliderThatWasDraggedHasNoTooltipUntilThePointerLeavesIt) {
    Desk desk(800, 600, 1, true);
    desk.frame(4);
    const auto tells = [&] { return desk.says("−2.00 to +2.00"); };
    const Rect row = desk.where("slider.LL");
    desk.point(row.x + row.w / 2, row.y + row.h / 2);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    desk.point(row.x + row.w / 2 + 10, row.y + 2 * row.h);
    desk.frame(4);
    desk.point(row.x + row.w / 2 + 10, row.y + row.h / 2);
    desk.frame(2);
    desk.button(0, false);
    desk.frame(2);
    desk.point(row.x + row.w / 2 + 11, row.y + row.h / 2);
    desk.frame(60);
    EXPECT_FALSE(tells()) << "what it changes is watched";
    desk.point(300, 300);
    desk.frame(4);
    desk.point(row.x + row.w / 2, row.y + row.h / 2);
    desk.frame(60);
    EXPECT_TRUE(tells());
}

}  // namespace braitenlab::tests::item_test
