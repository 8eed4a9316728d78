// What the keyboard did, in its order, until the window has time for it. Dear ImGui 1.86 keeps no such queue: of keys
// pressed and released within a frame it sees none, and characters overtake keys there. A frame therefore gives it
// either characters or a single key.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "ui/shortcuts.h"
#include "ui/widgets/keyboard.h"

struct ImGuiIO;

namespace braitenlab {

namespace key {
inline constexpr int first_modifier = 340, last_modifier = 347;  // Shift, Ctrl, Alt …
}

// What one frame hears of the keyboard.
struct KeysOfAFrame {
    std::vector<KeyPress> presses;     // for press_key(), in order
    std::vector<unsigned> characters;  // for the text field that has the cursor: Unicode code points
    std::optional<KeyPress> stroke;    // for the same, instead of characters: down in this frame, up in the next
};

class KeyQueue {
public:
    // A key went down, or repeats while it is held; then the character that it types, if it types one.
    void press(KeyPress, bool repeats = false);
    void type(unsigned character);

    // As much as a frame can hear without anything overtaking. While text is typed: a run of characters, or one key.
    // Else: everything, but nothing beyond a key after which text may be typed. Call once a frame.
    KeysOfAFrame take(TextInput);

private:
    struct Event {
        KeyPress press;
        bool repeats = false;
        unsigned character = 0;  // not 0: this was typed, and `press` says nothing
    };
    Event next();
    KeysOfAFrame take_text();
    KeysOfAFrame take_shortcuts();

    std::deque<Event> events_;
    KeyPress last_stroke_;  // handed over a frame ago; {} for none
    int awaited_ = 0;       // frames
};

// Tells Dear ImGui, before its frame begins, what this frame hears. `held` are the modifiers that are down now: those
// that a mouse goes with. Does nothing from 1.87 on, which keeps a queue of its own.
struct Modifiers {
    bool ctrl = false, shift = false, alt = false;
};
void hand_over(const KeysOfAFrame&, Modifiers held, ImGuiIO&);

}  // namespace braitenlab
