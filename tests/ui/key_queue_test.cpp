#include "ui/key_queue.h"

#include <string>

#include "desk.h"

namespace braitenlab::tests::key_queue_test {

using namespace ui;
namespace {

constexpr KeyPress select_all{'A', true}, save_as{'S', true, true};

void strike(KeyQueue& queue, char letter) {
    queue.press({letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter});
    queue.type(static_cast<unsigned char>(letter));
}
void strike(KeyQueue& queue, const std::string& letters) {
    for (const char letter : letters) strike(queue, letter);
}
std::string text(const KeysOfAFrame& frame) { return {frame.characters.begin(), frame.characters.end()}; }

TEST(KeyQueue, ReturnsAllShortcutsInOneFrame) {
    KeyQueue queue;
    for (int i = 0; i < 20; ++i) strike(queue, ' ');
    const KeysOfAFrame frame = queue.take(TextInput::none);
    EXPECT_EQ(frame.presses, std::vector<KeyPress>(20, KeyPress{' '}));
    EXPECT_TRUE(frame.characters.empty()) << "no text field is open";
    EXPECT_FALSE(frame.stroke);
    EXPECT_TRUE(queue.take(TextInput::none).presses.empty());
}

TEST(KeyQueue, ASignIsWhatIsTypedAndADigitIsAtItsPlace) {
    struct Typed {
        KeyPress key;
        char character;
        KeyPress press;
        const char* layout;
    };
    for (const Typed& each : {Typed{{';', false, true}, '.', {'.'}, "French"},
                              {{'=', false, true}, '+', {'+'}, "French and English"},
                              {{'6'}, '-', {'-'}, "French"},
                              {{'<', false, true}, '>', {'>'}, "French, German and Spanish"},
                              {{'<'}, '<', {'<'}, "French, German and Spanish"},
                              {{',', false, true}, '<', {'<'}, "English"},
                              {{'1'}, '&', {'1'}, "French"},
                              {{'3', false, true}, '3', {'3'}, "French"},
                              {{'5'}, '(', {'5'}, "French"},
                              {{'6', false, true}, '6', {'6'}, "French"},
                              {{'1', false, true}, '+', {'+'}, "Swiss"},
                              {{'1'}, '+', {'1'}, "Czech: the digits are shifted"},
                              {{'.', false, true}, '>', {'>'}, "English"},
                              {{'.', false, true}, ':', {'.', false, true}, "German"},
                              {{'7', false, true}, '/', {'/'}, "German"},
                              {{'+'}, '~', {'~'}, "German"},
                              {{'A', false, true}, 'A', {'A', false, true}, "any"}}) {
        KeyQueue queue;
        queue.press(each.key);
        queue.type(static_cast<unsigned char>(each.character));
        EXPECT_EQ(queue.take(TextInput::none).presses, std::vector{each.press}) << each.layout << each.character;
    }
    EXPECT_EQ(action_for({'>'}), Action::fast_forward);
    EXPECT_EQ(action_for({'<'}), Action::rewind);
    EXPECT_EQ(as_typed({'0', true, true}, '='), (KeyPress{'0', true, true})) << "with Ctrl nothing is typed";
}

TEST(KeyQueue, ACharacterWithoutAKeyOfItsOwnChangesNoPress) {
    KeyQueue queue;
    strike(queue, 'a');
    queue.type('+');  // an input method
    queue.press({key::enter});
    queue.type('.');
    EXPECT_EQ(queue.take(TextInput::none).presses, (std::vector{KeyPress{'A'}, KeyPress{key::enter}}));
}

TEST(KeyQueue, StopsAfterAKeyThatMayOpenATextField) {
    KeyQueue queue;
    queue.press(save_as);
    strike(queue, "hi");
    EXPECT_EQ(queue.take(TextInput::none).presses, std::vector{save_as});
    EXPECT_TRUE(queue.take(TextInput::awaited).presses.empty());
    EXPECT_TRUE(queue.take(TextInput::awaited).characters.empty());
    EXPECT_EQ(text(queue.take(TextInput::open)), "hi");
}

TEST(KeyQueue, ReturnsShortcutsAgainIfNoTextFieldOpens) {
    KeyQueue queue;
    queue.press({key::enter});
    strike(queue, ' ');
    EXPECT_EQ(queue.take(TextInput::none).presses, std::vector{KeyPress{key::enter}});
    EXPECT_EQ(queue.take(TextInput::none).presses, std::vector{KeyPress{' '}});
}

TEST(KeyQueue, WaitsForALimitedTimeForATextField) {
    KeyQueue queue;
    strike(queue, ' ');
    int frames = 0;
    while (queue.take(TextInput::awaited).presses.empty() && frames < 100) ++frames;
    EXPECT_LT(frames, 30);
}

TEST(KeyQueue, ReturnsCharactersOrOneKeyToATextField) {
    KeyQueue queue;
    strike(queue, "hello");
    queue.press(select_all);
    strike(queue, "x");
    queue.press({key::home});
    queue.press({key::first_modifier});  // for a capital Y: no separate frame
    strike(queue, "y");
    std::vector<std::string> heard;
    for (int i = 0; i < 5; ++i) {
        const KeysOfAFrame frame = queue.take(TextInput::open);
        EXPECT_TRUE(frame.characters.empty() || !frame.stroke) << i;
        heard.push_back(frame.stroke ? std::to_string(frame.stroke->key) : text(frame));
    }
    EXPECT_EQ(heard, (std::vector<std::string>{"hello", "65", "x", "268", "y"}));
}

TEST(KeyQueue, ReleasesAKeyBeforeItIsPressedAgain) {
    KeyQueue queue;
    queue.press({key::left});
    queue.press({key::left});
    EXPECT_TRUE(queue.take(TextInput::open).stroke);
    EXPECT_FALSE(queue.take(TextInput::open).stroke);
    EXPECT_TRUE(queue.take(TextInput::open).stroke);
}

TEST(KeyQueue, RepeatsHeldKeysOnlyForActionsThatCanRepeat) {
    KeyQueue queue;
    queue.press({' '}, true);
    queue.press({key::left}, true);
    queue.press({key::backspace}, true);
    EXPECT_EQ(queue.take(TextInput::none).presses, std::vector{KeyPress{key::left}}) << "Space does not repeat";
    queue.press({key::enter}, true);
    queue.press({key::backspace}, true);
    EXPECT_EQ(queue.take(TextInput::open).stroke, KeyPress{key::backspace});
}

TEST(KeyQueue, StopsRepeatingInTextOnReleaseAtAnyFrameRate) {
    KeyQueue queue;
    queue.press({key::backspace});
    for (int i = 0; i < 50; ++i) queue.press({key::backspace}, true);
    strike(queue, "x");
    int strokes = 0, frames = 0;
    for (KeysOfAFrame frame = queue.take(TextInput::open); frame.characters.empty(); ++frames) {
        ASSERT_LT(frames, 100);
        strokes += frame.stroke.has_value();
        frame = queue.take(TextInput::open);
    }
    EXPECT_LE(strokes, 2);
}

// The same queue with a text field.
struct TypedQuickly : testing::Test {
    Desk desk;
    FilesView files;
    KeyQueue queue;

    TypedQuickly() {
        expect_queued_input(ImGui::GetIO());
        files.suggested = "scene";
        desk.view.documents.files = &files;
        desk.frame(2);
    }
    void hear(int frames) {
        for (; frames > 0; --frames) {
            const KeysOfAFrame keys = queue.take(desk.panels.keyboard.text);
            hand_over(keys, {}, ImGui::GetIO());
            for (const KeyPress press : keys.presses) desk.key(press);
            desk.frame();
        }
    }
    const std::string& name() const { return desk.panels.sheets.files.typed.text; }
};

TEST_F(TypedQuickly, ReachesAFieldThatTheFirstKeyOpens) {
    queue.press(save_as);
    queue.press(select_all);
    strike(queue, "hello");
    queue.press(select_all);
    strike(queue, "x");
    queue.press({key::home});
    strike(queue, "y");
    hear(40);
    EXPECT_EQ(name(), "yx");
    EXPECT_TRUE(desk.actions().empty());
}

TEST_F(TypedQuickly, KeepsCharactersAndKeysInTheirOrder) {
    queue.press(save_as);
    queue.press(select_all);
    strike(queue, "abcd");
    for (int i = 0; i < 3; ++i) queue.press({key::left});
    queue.press({key::backspace});
    strike(queue, "1 2");
    queue.press({key::end});
    strike(queue, "!");
    hear(60);
    EXPECT_EQ(name(), "1 2bcd!");
}

TEST_F(TypedQuickly, SavesUnderTheNameTypedBeforeEnterAndPlaysAfterEscape) {
    queue.press(save_as);
    queue.press(select_all);
    strike(queue, "new one");
    queue.press({key::enter});
    queue.press({key::escape});
    strike(queue, ' ');
    hear(60);
    std::vector<std::string> saved;
    for (const Request& request : desk.all)
        if (const auto* save = std::get_if<SaveRequest>(&request)) saved.push_back(save->path);
    EXPECT_EQ(saved, std::vector<std::string>{"new one"});
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause});
}

TEST_F(TypedQuickly, ReachesTheFieldOfThePathThatASlashOpens) {
    queue.press({'O', true});
    strike(queue, "../my b.toml");
    hear(40);
    EXPECT_EQ(name(), "../my b.toml");
    EXPECT_TRUE(desk.actions().empty());
}

TEST_F(TypedQuickly, ReachesTheNumberThatEnterOpens) {
    queue.press({'2'});
    queue.type('2');
    queue.press({key::enter});
    strike(queue, "0.75");
    queue.press({key::enter});
    strike(queue, ' ');
    hear(60);
    const auto edits = desk.edits();
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_FLOAT_EQ(turned(edits[0]).value, 0.75f);
    EXPECT_EQ(desk.actions(), std::vector{Action::play_pause}) << "'.' within the number is no step";
}

}  // namespace
TEST(KeyQueue, AKeyAfterAClickWaitsForTheFieldThatTheClickOpens) {
    KeyQueue queue;
    queue.press({'Q'}, false, 0);
    queue.press({'1'}, false, 2);  // after a press and a release
    queue.type('1');
    queue.press({'.'}, false, 2);
    queue.type('.');
    EXPECT_EQ(queue.take(TextInput::none, 0).presses, std::vector{KeyPress{'Q'}}) << "before the click";
    EXPECT_TRUE(queue.take(TextInput::none, 1).presses.empty()) << "the press is shown in this frame";
    EXPECT_TRUE(queue.take(TextInput::awaited, 2).presses.empty());
    EXPECT_EQ(text(queue.take(TextInput::open, 2)), "1.");
}

TEST(KeyQueue, ASignWithCtrlIsWhatTheKeyTypesOnItsLayout) {
    KeyQueue queue;
    const auto heard = [&](KeyPress press, unsigned character) {
        queue.press(press);
        queue.type_with_ctrl(character);
        return queue.take(TextInput::none).presses;
    };
    const std::vector larger{KeyPress{'+', true}};
    EXPECT_EQ(heard({'1', true, true}, '+'), larger) << "Swiss";
    EXPECT_EQ(heard({'1', true}, '+'), larger) << "Czech";
    EXPECT_EQ(heard({'S', true, true}, 'S'), (std::vector{KeyPress{'S', true, true}}));
    EXPECT_EQ(heard({'1', false, true}, '+'), (std::vector{KeyPress{'1', false, true}})) << "without Ctrl: see type()";
}

}  // namespace braitenlab::tests::key_queue_test
