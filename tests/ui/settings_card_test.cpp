// The sheet of preferences, and how a sheet blocks keyboard and mouse.
#include <set>

#include "desk.h"
#include "ui/panels/cards.h"

namespace braitenlab::tests::settings_card_test {

using namespace ui;

struct SettingsCard : testing::Test {
    Desk desk;
    SettingsCard() {
        desk.frame(2);
        desk.key({',', true});
        desk.frame(3);
    }
    // Applies the requests before the next frame, as the lab does.
    void click_and_obey(std::string_view anchor) {
        desk.point(anchor);
        desk.frame(2);
        for (const bool down : {true, false}) {
            desk.button(0, down);
            desk.frame(1);
            wanted();
        }
    }
    const Preferences& wanted() {
        for (const Request& request : desk.all)
            if (const auto* asked = std::get_if<PreferencesRequest>(&request))
                desk.view.program.preferences = asked->preferences;
        desk.all.clear();
        return desk.view.program.preferences;
    }
};

TEST_F(SettingsCard, ChangesOneSettingPerClick) {
    desk.click("settings.theme.2");
    EXPECT_EQ(wanted(), (Preferences{.theme = Theme::light}));
    desk.click("settings.type.3");
    EXPECT_EQ(wanted(), (Preferences{.theme = Theme::light, .type_size = 1.5f}));
    desk.click("settings.motion.2");
    EXPECT_TRUE(wanted().reduce_motion);
    desk.click("settings.quality.2");
    EXPECT_EQ(wanted().quality, Quality::low);
    desk.click("settings.quality.1");
    EXPECT_EQ(wanted().quality, std::nullopt);
    desk.click("settings.language.3");
    EXPECT_EQ(wanted().language, desk.spoken[2].code);
    desk.click("settings.language.3");
    EXPECT_TRUE(desk.all.empty()) << "the chosen value gives no request";
}

TEST(SettingsCardWithFonts, ShowsTheTypeSizeInEffectWhereTheWindowIsTooSmallForTheChosenOne) {
    for (const std::string& code : shipped_codes()) {
        Desk desk(1024, 768, 1, true);
        desk.strings = speaking(code);
        desk.view.program.preferences.type_size = 1.5f;
        desk.frame(2);
        desk.key({',', true});
        desk.frame(3);
        const auto shown = [&](std::string_view words) {
            for (const Written& w : desk.written)
                if (w.words == words) return true;
            return false;
        };
        const std::string words = fill(desk.strings("settings.type_reduced"), {"125", "150"});
        EXPECT_NE(words.find("125 %"), std::string::npos);
        EXPECT_FALSE(shown(words));
        desk.view.program.type_size = 1.25f;
        desk.frame(3);
        EXPECT_TRUE(shown(words)) << code;
    }
}

TEST_F(SettingsCard, TellsTheQualityThatIsMeasured) {
    for (const auto& [quality, words] :
         {std::pair{Quality::low, "Auto now uses: Low"}, {Quality::high, "Auto now uses: High"}}) {
        desk.view.program.quality = quality;
        desk.frame(2);
        EXPECT_TRUE(desk.says(words));
    }
    desk.view.program.preferences.quality = Quality::high;
    desk.frame(2);
    EXPECT_FALSE(desk.says("Auto now uses: High"));
    EXPECT_TRUE(desk.says("Every vehicle rounded, smooth edges"));
}

TEST_F(SettingsCard, ResetsEverythingAndCanUndoIt) {
    const Preferences mine{Theme::light, "es", 1.5f, true, Quality::low};
    desk.view.program.native_language = "de";
    desk.view.program.preferences = mine;
    desk.panels.card(Card::brain).folded = true;
    desk.frame(2);
    click_and_obey("settings.reset");
    EXPECT_EQ(desk.view.program.preferences, (Preferences{.language = "de"}));
    EXPECT_FALSE(desk.panels.card(Card::brain).folded);
    desk.frame(2);
    click_and_obey("settings.restore");
    EXPECT_EQ(desk.view.program.preferences, mine);
}

TEST_F(SettingsCard, ResetsTheFoldOfEachCardOfTheTable) {
    desk.view.program.preferences.type_size = 1.5f;
    for (const CardTraits& row : cards()) desk.panels.card(row.card).folded = !row.folded;
    desk.frame(2);
    click_and_obey("settings.reset");
    for (const CardTraits& row : cards()) EXPECT_EQ(desk.panels.card(row.card).folded, row.folded) << row.anchor;
}

TEST_F(SettingsCard, BlocksKeyboardAndMouseForTheWindowBelow) {
    desk.all.clear();
    for (int i = 0; i < 30; ++i) {
        desk.key({key::tab});
        desk.frame(1);
        EXPECT_TRUE(desk.panels.keyboard.focus.starts_with("settings.")) << desk.panels.keyboard.focus;
    }
    desk.key({'A'});
    desk.key({'R'});
    desk.frame(2);
    EXPECT_TRUE(desk.actions().empty());
    desk.key({' '});
    EXPECT_TRUE(desk.actions().empty()) << "the run is paused while a sheet is open";
}

TEST(Sheets, PassNoKeyOfTheLab) {
    Desk desk;
    FilesView files;
    desk.view.documents.files = &files;
    desk.frame(2);
    const std::set<Action> of_window{Action::exit, Action::full_screen, Action::screenshot, Action::larger,
                                     Action::smaller};
    for (const Sheet sheet : {Sheet::keys, Sheet::settings, Sheet::files, Sheet::recovery, Sheet::leaving})
        for (const Shortcut& shortcut : shortcuts()) {
            desk.panels.sheet = sheet;
            desk.all.clear();
            desk.key(shortcut.press);
            for (const Request& request : desk.all) {
                const auto* action = std::get_if<Action>(&request);
                const bool is_why_not = std::holds_alternative<NoticeRequest>(request);  // the type is the smallest
                EXPECT_TRUE(is_why_not ? of_window.contains(shortcut.action) : action && of_window.contains(*action))
                    << key_name(shortcut.press, desk.strings) << " on sheet " << static_cast<int>(sheet);
            }
        }
}

TEST(TypeSize, AKeyThatCannotMakeItLargerSaysWhy) {
    Desk desk;
    desk.frame(2);
    const auto answer = [&](float preferred, float room) {
        desk.view.program.preferences.type_size = preferred;
        desk.view.program.largest_type_size = room;
        desk.all.clear();
        desk.key({'=', true});
        const auto* why = desk.last<NoticeRequest>();
        return why ? why->key : std::string(desk.actions().empty() ? "silent" : "larger");
    };
    EXPECT_EQ(answer(1, 1.2f), "larger");
    EXPECT_EQ(answer(1.125f, 1.2f), "larger") << "as far as there is room";
    EXPECT_EQ(answer(1, 1), "unavailable.largest_here") << "at the first press, too";
    EXPECT_EQ(answer(1.25f, 1.2f), "unavailable.largest_here");
    EXPECT_EQ(answer(2, 3), "unavailable.largest");
}

TEST_F(SettingsCard, ReturnsTheFocusWhenItCloses) {
    desk.key({key::escape});
    desk.frame(2);
    desk.panels.keyboard.focus = "button.step";
    desk.frame(2);
    desk.key({',', true});
    desk.frame(2);
    EXPECT_EQ(desk.panels.keyboard.focus, "settings.language.1");
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_EQ(desk.panels.keyboard.focus, "button.step");
}

TEST_F(SettingsCard, ClosesOnAClickBesideIt) {
    desk.point(5, 400);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(1);
    desk.button(0, false);
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.settings"));
}

}  // namespace braitenlab::tests::settings_card_test
