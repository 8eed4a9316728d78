// Queue of keyboard events between GLFW's callbacks and frames. Dear ImGui 1.86 has no such queue: it misses a key that
// is pressed and released within a frame, and it receives characters before keys. The queue of later versions knows
// nothing of sheets that open in between. Therefore each frame gets either characters or one key stroke, with every
// version.
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
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
// . , + - = < > / ~ at different places: a digit is the key of its place or what is typed, a sign is what is typed, and
// with Ctrl a sign of the type size only.
KeyPress as_typed(KeyPress, unsigned character);

class KeyQueue {
public:
    // Adds a press or a repeat of a key, and then the character that the key types, if there is one. `after`: changes
    // of mouse buttons before it (MouseQueue::changes): a click may open the text field that it is for.
    void press(KeyPress, bool repeats = false, std::uint64_t after = 0);
    void type(unsigned character);
    // The character that the last key types while Ctrl is held: it goes to no text field.
    void type_with_ctrl(unsigned character);

    // Removes and returns the events for one frame, in order. While text is typed: a run of characters, or one key.
    // Otherwise: all events up to a key that may open a text field. `shown`: changes of mouse buttons that earlier
    // frames have got; later events wait. Call once per frame.
    KeysOfAFrame take(TextInput, std::uint64_t shown = std::numeric_limits<std::uint64_t>::max());

private:
    struct Event {
        KeyPress press;
        bool repeats = false;
        unsigned character = 0;  // not 0: a typed character; `press` is unused
        std::uint64_t after = 0;
    };
    bool has_next() const { return !events_.empty() && events_.front().after <= shown_; }
    Event next();
    KeysOfAFrame take_text();
    KeysOfAFrame take_shortcuts();

    std::deque<Event> events_;
    KeyPress last_stroke_;  // of the last frame; {} for none
    int awaited_ = 0;       // frames
    std::uint64_t shown_ = 0;
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
