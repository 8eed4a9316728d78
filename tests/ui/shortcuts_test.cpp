#include "ui/shortcuts.h"

#include "desk.h"

namespace braitenlab::tests::shortcuts_test {

using namespace ui;

TEST(Shortcuts, HaveNoKeyTwice) {
    const auto all = shortcuts();
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(all[i].press == all[j].press && all[i].place == all[j].place)
                << key_name(all[i].press, english());
}

TEST(Shortcuts, ReturnTheActionOfAKey) {
    EXPECT_EQ(action_for({' '}), Action::play_pause);
    EXPECT_EQ(action_for({'A'}), Action::add);
    EXPECT_EQ(action_for({'A', false, true}), Action::remove);
    EXPECT_EQ(action_for({'Z', true, true}), Action::redo);
    EXPECT_EQ(action_for({'A', true, false}), std::nullopt);
}

TEST(Shortcuts, NameEveryActionBothWays) {
    for (int i = 0; i <= static_cast<int>(last_action); ++i) {
        const auto action = static_cast<Action>(i);
        ASSERT_FALSE(name(action).empty()) << i;
        EXPECT_EQ(action_named(name(action)), action);
    }
}

TEST(Shortcuts, AreNamedAsOnTheKeyboard) {
    const Strings strings = english();
    EXPECT_EQ(key_name(Action::exit, strings), "Ctrl+Q");
    EXPECT_EQ(key_name(Action::redo, strings), "Ctrl+Shift+Z");
    EXPECT_EQ(key_name(Action::play_pause, strings), "Space");
    EXPECT_EQ(key_name(Action::full_screen, strings), "F11");
    EXPECT_EQ(key_name(Action::exercise_reset, strings), "");
    EXPECT_EQ(key_name(Action::fast_forward, strings), ">") << "no . without Shift is needed, as Shift+. is";
    EXPECT_EQ(key_name(Action::rewind, strings), "<");
}

TEST(Shortcuts, InTheHintBarHaveAnAction) {
    const Strings strings = english();
    for (const auto& [key, words] : strings.all()) {
        if (!key.starts_with("hint.")) continue;
        for (std::size_t open = words.find('['); open != words.npos; open = words.find('[', open + 1)) {
            const std::string inside = words.substr(open + 1, words.find(']', open) - open - 1);
            if (inside == "F1" || key == "hint.slider_drag")
                continue;  // the gap of the latter is a key held while dragging
            const auto action = action_named(inside);
            ASSERT_TRUE(action) << key << ": " << inside;
            EXPECT_FALSE(key_name(*action, strings).empty()) << key << ": " << inside;
        }
    }
}

TEST(Shortcuts, OfABrowserAreNotThoseOfAPage) {
    for (const KeyPress press :
         {KeyPress{'N', true}, {'Q', true}, {'+', true}, {key::f12}, {key::tab, true}, {key::left, true}})
        EXPECT_TRUE(is_for_browser(press)) << key_name(press, english());
    for (const KeyPress press :
         {KeyPress{'S', true}, {'S', true, true}, {'Z', true}, {'V', true}, {key::f1}, {'W'}, {key::left}})
        EXPECT_FALSE(is_for_browser(press)) << key_name(press, english());
    for (const Shortcut& shortcut : shortcuts()) EXPECT_TRUE(is_shown(shortcut.press)) << "outside a page each is";
}

}  // namespace braitenlab::tests::shortcuts_test
