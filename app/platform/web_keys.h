// Keys of a browser's events, as GLFW numbers them.
#pragma once

#include <bitset>

#include "ui/key_queue.h"

struct EmscriptenKeyboardEvent;

namespace braitenlab::web {

// False for a key of the browser itself: F11, F12, F5 unless take_reload_key() was told otherwise, and a key with Ctrl,
// Alt or the command key that the lab has no use for (Ctrl+T, Ctrl+W, Ctrl+R …).
bool is_for_lab(const EmscriptenKeyboardEvent&);

// The key as a shortcut: the character that it types on this layout, in upper case, or GLFW's number. 0: unknown.
KeyPress press_of(const EmscriptenKeyboardEvent&);

// The character that it types; 0: none.
unsigned character_of(const EmscriptenKeyboardEvent&);

class HeldKeys {
public:
    void set(const EmscriptenKeyboardEvent&, bool down);
    bool has(int glfw_key) const;
    ui::Modifiers modifiers() const { return modifiers_; }

private:
    std::bitset<512> held_;
    ui::Modifiers modifiers_;
};

}  // namespace braitenlab::web
