#include "ui/key_queue.h"

#include "ui/imgui_compat.h"

namespace braitenlab {

namespace {

constexpr int longest_wait = 12;  // frames for a text field to take the cursor; then keys mean what they always mean

// Says nothing to a text field by itself: its character follows it, or the key that it modifies.
bool is_no_stroke(KeyPress press) {
    const bool printed = press.key < key::escape && !press.ctrl;
    return printed || (press.key >= key::first_modifier && press.key <= key::last_modifier);
}

// Text may be typed after it: the key opens a sheet, a number, or moves the focus to a field.
bool may_lead_to_text(KeyPress press) {
    return press.ctrl || press.key == key::enter || press.key == key::tab || press.key == key::up ||
           press.key == key::down;
}

// While it is held. Play and pause and the like must not flicker.
bool may_repeat(KeyPress press) {
    return (press.key >= key::right && press.key <= key::up) || press.key == key::tab || press.key == '.' ||
           press.key == ',';
}

bool may_repeat_in_text(KeyPress press) {
    return press.key != key::enter && press.key != key::escape && press.key != key::tab && press.key < key::f1;
}

}  // namespace

void KeyQueue::press(KeyPress press, bool repeats) { events_.push_back({press, repeats, 0}); }

void KeyQueue::type(unsigned character) { events_.push_back({{}, false, character}); }

KeysOfAFrame KeyQueue::take(TextInput text) {
    awaited_ = text == TextInput::awaited ? awaited_ + 1 : 0;
    if (text == TextInput::awaited && awaited_ <= longest_wait) return {};
    KeysOfAFrame frame = text == TextInput::open ? take_text() : take_shortcuts();
    last_stroke_ = frame.stroke.value_or(KeyPress{});
    return frame;
}

KeyQueue::Event KeyQueue::next() {
    const Event event = events_.front();
    events_.pop_front();
    return event;
}

KeysOfAFrame KeyQueue::take_text() {
    KeysOfAFrame frame;
    while (!events_.empty()) {
        const Event& event = events_.front();
        if (event.character != 0) {
            frame.characters.push_back(next().character);
        } else if (is_no_stroke(event.press)) {
            frame.presses.push_back(next().press);
        } else if (event.repeats && !may_repeat_in_text(event.press)) {
            next();
        } else {
            // It waits for the characters before it; and a key that is down has to come up before it goes down again.
            if (!frame.characters.empty() || event.press.key == last_stroke_.key) break;
            frame.stroke = next().press;
            frame.presses.push_back(*frame.stroke);
            // A held key that repeats faster than frames come must not go on after it was let go.
            while (!events_.empty() && events_.front().repeats && events_.front().press == *frame.stroke) next();
            break;
        }
    }
    return frame;
}

KeysOfAFrame KeyQueue::take_shortcuts() {
    KeysOfAFrame frame;
    std::optional<KeyPress> led;
    while (!events_.empty()) {
        const Event& event = events_.front();
        if (led && (event.character != 0 || event.press != *led)) break;
        const auto [press, repeats, character] = next();
        if (character != 0 || (repeats && !may_repeat(press))) continue;  // characters: nobody reads them
        frame.presses.push_back(press);
        if (may_lead_to_text(press)) led = press;
    }
    return frame;
}

void hand_over(const KeysOfAFrame& frame, Modifiers held, ImGuiIO& io) {
    if constexpr (compat::keeps_a_key_queue) return;
    if (frame.stroke) held = {frame.stroke->ctrl, frame.stroke->shift, false};
    if (!frame.characters.empty()) held = {};  // with Ctrl they would count as a shortcut
    compat::set_keys(io, frame.stroke ? frame.stroke->key : -1, held.ctrl, held.shift, held.alt);
    for (const unsigned character : frame.characters) io.AddInputCharacter(character);
}

}  // namespace braitenlab
