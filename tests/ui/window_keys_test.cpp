// Ctrl+V with a link on the clipboard.
#include "ui/window_keys.h"

#include "desk.h"

namespace braitenlab::tests::window_keys_test {

using namespace ui;

namespace {

constexpr KeyPress copy_key{'C', true}, paste_key{'V', true};
constexpr const char* link = "https://lab.example/#b1.abc";

}  // namespace

TEST(WindowKeys, OpenALinkFromTheClipboard) {
    Desk desk;
    desk.frame(2);
    ImGui::SetClipboardText(link);
    desk.key(paste_key);
    ASSERT_TRUE(desk.last<OpenRequest>());
    EXPECT_EQ(desk.last<OpenRequest>()->path, link);
    EXPECT_FALSE(desk.last<PasteRequest>());
}

TEST(WindowKeys, ADigitFocusesEachSliderOfTheBrain) {
    Desk desk;
    desk.frame(3);
    int digit = '1';
    for (const char* slider : {"slider.LL", "slider.LR", "slider.RL", "slider.RR", "bias.LM", "bias.RM"}) {
        desk.key({digit++});
        desk.frame(2);
        EXPECT_EQ(desk.panels.keyboard.focus, slider);
        EXPECT_TRUE(desk.panels.keyboard.shown) << slider;
    }
}

TEST(WindowKeys, OpenALinkWhileWiring) {
    Desk desk;
    desk.view.mode = Mode::wiring;
    desk.frame(2);
    ImGui::SetClipboardText(link);
    desk.key(paste_key);
    EXPECT_TRUE(desk.last<OpenRequest>());
}

TEST(WindowKeys, PasteObjectsThatWereCopiedAfterTheLink) {
    Desk desk;
    desk.frame(2);
    ImGui::SetClipboardText(link);
    desk.key(copy_key);
    desk.key(paste_key);
    EXPECT_FALSE(desk.last<OpenRequest>());
    ImGui::SetClipboardText("https://lab.example/#b1.newer");
    desk.key(paste_key);
    EXPECT_TRUE(desk.last<OpenRequest>());
}

TEST(WindowKeys, TakeOtherTextOfTheClipboardForNoLink) {
    Desk desk;
    desk.frame(2);
    ImGui::SetClipboardText("https://lab.example/");
    desk.key(paste_key);
    EXPECT_FALSE(desk.last<OpenRequest>());
}

TEST(WindowKeys, GiveATextFieldWhatIsPastedThere) {
    Desk desk;
    desk.frame(2);
    ImGui::SetClipboardText(link);
    desk.panels.sheet = Sheet::files;
    desk.frame(4);
    desk.key(paste_key);
    EXPECT_FALSE(desk.last<OpenRequest>());
}

// Also where Tab selects the next vehicle.
TEST(WindowKeys, TabGoesToTheFoldedCardThatPulsesAndEnterUnfoldsIt) {
    Desk desk(800, 600, 1, true);
    desk.open_exercise();
    desk.now = snapshot(4);
    desk.lesson.attempt.work.has_run = true, desk.lesson.attempt.answers.prediction = 0;
    desk.view.mode = Mode::playing;
    desk.opened.hints = {{"Lower it.", "slider.LL"}};
    desk.lesson.attempt.answers.hints_shown = 1;
    desk.panels.card(Card::brain).folded = true;
    desk.frame(6);
    ASSERT_EQ(desk.panels.prompts.highlight.anchor, "card.brain.fold");
    desk.key({key::tab});
    desk.frame(2);
    EXPECT_EQ(desk.panels.keyboard.focus, "card.brain.fold");
    EXPECT_TRUE(desk.all.empty()) << "no other vehicle is selected";
    desk.key({key::enter});
    desk.frame(4);
    EXPECT_FALSE(desk.panels.card(Card::brain).folded);
    desk.panels.keyboard.focus.clear();
    desk.key({key::tab});
    EXPECT_EQ(desk.actions().size(), 1u) << "nothing is folded that pulses";
}

}  // namespace braitenlab::tests::window_keys_test
