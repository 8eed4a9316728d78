// Queue of keyboard events between GLFW's callbacks and frames. Dear ImGui 1.86 has no such queue: it misses a key that
// is pressed and released within a frame, and it receives characters before keys. The queue of later versions knows
// nothing of sheets that open in between. Therefore each frame gets either characters or one key stroke, with every
// version.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "ui/shortcuts.h"
#include "ui/widgets/keyboard.h"

struct ImGuiIO;

namespace braitenlab::ui {

// The keyboard events of one frame.
struct KeysOfAFrame {
    std::vector<KeyPress> presses;     // for press_key(), in order
    std::vector<unsigned> characters;  // Unicode code points for the active text field
    std::optional<KeyPress> stroke;    // for the text field, instead of characters: down in this frame, up in the next
};

// The press of a key that types this character. Layouts have the digits at one place, shifted or not, and the signs
// . , + - = < > at different places: a digit is the key of its place or what is typed, a sign is what is typed.
KeyPress as_typed(KeyPress, unsigned character);

class KeyQueue {
public:
    // Adds a press or a repeat of a key, and then the character that the key types, if there is one.
    void press(KeyPress, bool repeats = false);
    void type(unsigned character);

    // Removes and returns the events for one frame, in order. While text is typed: a run of characters, or one key.
    // Otherwise: all events up to a key that may open a text field. Call once per frame.
    KeysOfAFrame take(TextInput);

private:
    struct Event {
        KeyPress press;
        bool repeats = false;
        unsigned character = 0;  // not 0: a typed character; `press` is unused
    };
    Event next();
    KeysOfAFrame take_text();
    KeysOfAFrame take_shortcuts();

    std::deque<Event> events_;
    KeyPress last_stroke_;  // of the last frame; {} for none
    int awaited_ = 0;       // frames
};

// Prepares the current context of Dear ImGui for KeyQueue and MouseQueue. Call once, before its first frame.
void expect_queued_input(ImGuiIO&);

// Passes the frame's events to Dear ImGui; call before its frame begins. `held`: modifiers that are down, for mouse
// clicks.
struct Modifiers {
    bool ctrl = false, shift = false, alt = false;
};
void hand_over(const KeysOfAFrame&, Modifiers held, ImGuiIO&);

}  // namespace braitenlab::ui
