// The toolbar in windows of several widths.
#include <algorithm>

#include "desk.h"
#include "ui/widgets/number.h"

namespace braitenlab::tests::toolbar_test {

using namespace ui;

namespace {

constexpr const char* buttons[]{"button.play",   "button.step",   "button.reset", "button.slower", "button.faster",
                                "button.follow", "button.wiring", "button.undo",  "button.save"};

bool is_icon(const Written& w) { return !w.words.empty() && static_cast<unsigned char>(w.words[0]) == 0xEF; }

bool lies_in(const Written& w, Rect r) { return r.contains(w.rect.x + w.rect.w / 2, w.rect.y + w.rect.h / 2); }

bool has_icon(const Desk& desk, const char* button) {
    const Rect r = desk.where(button);
    return std::any_of(desk.written.begin(), desk.written.end(),
                       [&](const Written& w) { return is_icon(w) && lies_in(w, r); });
}

// Words within the button, other than its icon.
bool has_words(const Desk& desk, const char* button) {
    const Rect r = desk.where(button);
    return std::any_of(desk.written.begin(), desk.written.end(),
                       [&](const Written& w) { return !is_icon(w) && lies_in(w, r); });
}

}  // namespace

struct ToolbarInEachLanguage : ::testing::TestWithParam<std::string> {};

TEST_P(ToolbarInEachLanguage, HasWordsOnEveryButtonAt1280Pixels) {
    Desk desk(1280, 800, 1, true);
    desk.strings = speaking(GetParam());
    desk.frame(3);
    for (const std::string button : buttons) {
        if (button == "button.slower" || button == "button.faster") continue;
        EXPECT_TRUE(has_words(desk, button.c_str())) << button;
    }
}

TEST_P(ToolbarInEachLanguage, HasOneRowWithoutOverlapsAtAnyWidth) {
    for (int width = 940; width <= 1920; width += 64) {
        Desk desk(static_cast<float>(width), 800, 1, true);
        desk.strings = speaking(GetParam());
        desk.view.pace = 0.8f;
        desk.frame(3);
        const std::string pace = fill(desk.strings("time.pace"), {fixed(0.8f, 1, decimal_mark(desk.strings))});
        const Rect mode = desk.where("mode");
        int paces = 0;
        for (const Written& w : desk.written) {
            if (w.words != pace) continue;
            ++paces;
            EXPECT_GE(w.rect.x, mode.x + mode.w) << width;
        }
        EXPECT_EQ(paces, 1);
        float end = 0;
        for (const char* button : buttons) {
            const Rect r = desk.where(button);
            EXPECT_GE(r.x, end) << button << " at " << width;
            EXPECT_TRUE(has_icon(desk, button)) << button << " at " << width;
            end = r.x + r.w;
        }
        EXPECT_LE(end, static_cast<float>(width)) << width;
        EXPECT_GE(desk.where("mode").x, end) << width;
        EXPECT_LE(desk.where("time").x + desk.where("time").w, static_cast<float>(width)) << width;
    }
}

TEST_P(ToolbarInEachLanguage, LeavesButtonsOutRatherThanDrawOverThemInTheLeastWindow) {
    for (int width = 640; width < 940; width += 50) {
        Desk desk(static_cast<float>(width), 480, 1, true);
        desk.strings = speaking(GetParam());
        desk.frame(3);
        ASSERT_TRUE(desk.anchors.find("button.play"));
        ASSERT_TRUE(desk.anchors.find("button.follow"));
        float end = 0;
        for (const char* button : buttons) {
            if (!desk.anchors.find(button)) continue;
            EXPECT_GE(desk.where(button).x, end) << button << " at " << width;
            end = desk.where(button).x + desk.where(button).w;
        }
        EXPECT_GE(desk.where("mode").x, end) << width;
    }
}

INSTANTIATE_TEST_SUITE_P(Toolbar, ToolbarInEachLanguage, ::testing::ValuesIn(shipped_codes()),
                         [](const auto& given) { return given.param; });

TEST(Toolbar, RequestsTheActionOfEachButton) {
    const std::pair<const char*, Action> expected[]{
        {"button.play", Action::play_pause}, {"button.step", Action::step},     {"button.reset", Action::reset},
        {"button.follow", Action::follow},   {"button.wiring", Action::wiring}, {"button.slower", Action::slower},
        {"button.faster", Action::faster},   {"button.undo", Action::undo},     {"button.save", Action::save}};
    FilesView files;
    files.save_to = "/home/me/mine.toml";
    Desk desk(1024, 768);
    desk.view.documents.files = &files;
    desk.view.undo_depth = 1;
    desk.frame(3);
    for (const auto& [anchor, action] : expected) {
        desk.all.clear();
        desk.click(anchor);
        EXPECT_EQ(desk.actions(), std::vector{action}) << anchor;
    }
}

TEST(Toolbar, AsksForANameWhereTheFileHasNone) {
    FilesView files;
    Desk desk(1024, 768);
    desk.view.documents.files = &files;
    desk.frame(3);
    desk.click("button.save");
    EXPECT_EQ(desk.panels.sheet, Sheet::files);
    EXPECT_TRUE(desk.panels.sheets.files.saving);
}

TEST(Toolbar, UndoesOnlyWhereThereIsAnEdit) {
    Desk desk(1024, 768);
    desk.frame(3);
    desk.click("button.undo");
    EXPECT_TRUE(desk.actions().empty());
}

// No time passes while a sheet is open.
TEST(Toolbar, TellsOfAPauseWhileASheetIsOpenAndOfTheClipThatIsWritten) {
    Desk desk(1280, 800, 1, true);
    desk.view.mode = Mode::playing;
    desk.frame(3);
    EXPECT_TRUE(desk.says(desk.strings("mode.playing")));
    desk.panels.sheet = Sheet::take;
    desk.frame(3);
    EXPECT_FALSE(desk.says(desk.strings("mode.playing")));
    EXPECT_TRUE(desk.says(desk.strings("mode.paused")));
    desk.view.program.clip_progress = 0.437f;
    desk.frame(3);
    EXPECT_FALSE(desk.says(desk.strings("mode.paused")));
    EXPECT_TRUE(desk.says(fill(desk.strings("mode.clip"), {"43"})));
}

// Speed and status are in a second row; all buttons that are shown are in the window, and the menus' titles.
TEST(Toolbar, ShowsThatATickWasMadeOrTakenBackInAPause) {
    for (const bool still : {false, true}) {
        Desk desk(800, 600, 1, true);
        desk.view.program.reduce_motion = still;
        desk.now.tick = 217, desk.now.seconds = 217 / 60.0;
        desk.view.timeline.latest = 300;
        desk.frame(60);
        EXPECT_FALSE(desk.anchors.find("time.step"));
        EXPECT_TRUE(desk.says("3.62 s"));
        for (const std::uint64_t tick : {218u, 217u}) {
            desk.now.tick = tick, desk.now.seconds = static_cast<double>(tick) / 60;
            desk.frame(2);
            EXPECT_TRUE(desk.anchors.find("time.step")) << tick;
            EXPECT_TRUE(desk.says(tick == 218 ? "3.63 s" : "3.62 s"));
            desk.frame(60);
            EXPECT_FALSE(desk.anchors.find("time.step")) << tick;
        }
        desk.now.tick = 0, desk.now.seconds = 0;
        desk.frame(2);
        EXPECT_FALSE(desk.anchors.find("time.step")) << "a reset is no step";
        desk.view.mode = Mode::playing;
        desk.now.tick = 1;
        desk.frame(2);
        EXPECT_FALSE(desk.anchors.find("time.step")) << "a run is no step";
    }
}

TEST(Toolbar, HasTwoRowsInAnUprightWindow) {
    for (const std::string& code : shipped_codes())
        for (const float width : {410.0f, 512.0f, 640.0f}) {
            Desk desk(width, 2 * width, 1, true);
            desk.strings = speaking(code);
            desk.view.program.touch = true, desk.view.program.finger = 44;
            desk.frame(3);
            const Rect play = desk.where("button.play");
            for (const char* below : {"button.slower", "button.faster", "time", "mode"})
                EXPECT_GE(desk.where(below).y + desk.where(below).h / 2, play.y + play.h) << below;
            for (const char* id : {"button.reset", "button.wiring", "time", "mode", "menu.file", "menu.help"}) {
                const Rect at = desk.where(id);
                EXPECT_TRUE(at.x >= 0 && at.x + at.w <= width) << code << " " << id << " " << width;
            }
        }
}

}  // namespace braitenlab::tests::toolbar_test
