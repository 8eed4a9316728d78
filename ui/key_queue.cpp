#include "ui/key_queue.h"

#include <string_view>

#include "ui/imgui_compat.h"

namespace braitenlab::ui {

namespace {

// The keys that widgets of Dear ImGui read.
constexpr compat::NamedKey named_keys[]{{ImGuiKey_Tab, key::tab},
                                        {ImGuiKey_LeftArrow, key::left},
                                        {ImGuiKey_RightArrow, key::right},
                                        {ImGuiKey_UpArrow, key::up},
                                        {ImGuiKey_DownArrow, key::down},
                                        {ImGuiKey_PageUp, key::page_up},
                                        {ImGuiKey_PageDown, key::page_down},
                                        {ImGuiKey_Home, key::home},
                                        {ImGuiKey_End, key::end},
                                        {ImGuiKey_Insert, key::insert},
                                        {ImGuiKey_Delete, key::del},
                                        {ImGuiKey_Backspace, key::backspace},
                                        {ImGuiKey_Space, ' '},
                                        {ImGuiKey_Enter, key::enter},
                                        {ImGuiKey_Escape, key::escape},
                                        {compat::keypad_enter, key::enter},
                                        {ImGuiKey_A, 'A'},
                                        {ImGuiKey_C, 'C'},
                                        {ImGuiKey_V, 'V'},
                                        {ImGuiKey_X, 'X'},
                                        {ImGuiKey_Y, 'Y'},
                                        {ImGuiKey_Z, 'Z'}};

constexpr int longest_wait = 12;  // frames to wait for a text field to become active

// True for a key that is no key stroke for a text field: its character follows, or it is a modifier.
bool is_no_stroke(KeyPress press) {
    const bool printed = press.key < key::escape && !press.ctrl;
    return printed || (press.key >= key::first_modifier && press.key <= key::last_modifier);
}

// True if text may follow: the key opens a sheet or a number, moves the focus to a text field, or tells that a search
// is a path.
bool may_lead_to_text(KeyPress press) {
    return press.ctrl || press.key == key::enter || press.key == key::tab || press.key == key::up ||
           press.key == key::down || press.key == '/' || press.key == '\\';
}

// Keys that repeat while held; others, such as play and pause, act once per press.
bool may_repeat(KeyPress press) {
    return (press.key >= key::right && press.key <= key::up) || press.key == key::tab || press.key == '.' ||
           press.key == ',' || press.key == '<' || press.key == '>';
}

bool may_repeat_in_text(KeyPress press) {
    return press.key != key::enter && press.key != key::escape && press.key != key::tab && press.key < key::f1;
}

}  // namespace

KeyPress as_typed(KeyPress press, unsigned character) {
    constexpr std::string_view signs = ".,+-=<>/~";
    // They are answers and sliders: without Shift they are those of their place whatever they type.
    const bool is_used_digit = press.key >= '1' && press.key <= '4' && !press.shift;
    if (character == 0 || character > '~') return press;
    const auto typed = static_cast<char>(character);
    if (press.ctrl) return std::string_view("+-").find(typed) != signs.npos ? KeyPress{typed, true} : press;
    if (is_used_digit) return press;
    const bool is_digit = typed >= '0' && typed <= '9';
    return is_digit || signs.find(typed) != signs.npos ? KeyPress{typed} : press;
}

void KeyQueue::press(KeyPress press, bool repeats, std::uint64_t after) {
    events_.push_back({press, repeats, 0, after});
}

void KeyQueue::type(unsigned character) {
    const bool has_press = !events_.empty() && events_.back().character == 0;
    if (has_press && events_.back().press.key < key::escape)
        events_.back().press = as_typed(events_.back().press, character);
    events_.push_back({{}, false, character, events_.empty() ? 0 : events_.back().after});
}

void KeyQueue::type_with_ctrl(unsigned character) {
    if (events_.empty() || events_.back().character != 0 || !events_.back().press.ctrl) return;
    if (events_.back().press.key < key::escape) events_.back().press = as_typed(events_.back().press, character);
}

KeysOfAFrame KeyQueue::take(TextInput text, std::uint64_t shown) {
    shown_ = shown;
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
    while (has_next()) {
        const Event& event = events_.front();
        if (event.character != 0) {
            frame.characters.push_back(next().character);
        } else if (is_no_stroke(event.press)) {
            frame.presses.push_back(next().press);
        } else if (event.repeats && !may_repeat_in_text(event.press)) {
            next();
        } else {
            // The characters before this key are delivered first, and a key must be released before it is pressed
            // again.
            if (!frame.characters.empty() || event.press.key == last_stroke_.key) break;
            frame.stroke = next().press;
            frame.presses.push_back(*frame.stroke);
            // Drop repeats that are faster than frames, so that the key has no effect after its release.
            while (!events_.empty() && events_.front().repeats && events_.front().press == *frame.stroke) next();
            break;
        }
    }
    return frame;
}

KeysOfAFrame KeyQueue::take_shortcuts() {
    KeysOfAFrame frame;
    std::optional<KeyPress> led;
    while (has_next()) {
        const Event& event = events_.front();
        const bool is_own =
            led && event.character == static_cast<unsigned>(led->key);  // of a sign: it is heard already
        if (led && !is_own && (event.character != 0 || event.press != *led)) break;
        const auto [press, repeats, character, after] = next();
        if (character != 0 || (repeats && !may_repeat(press))) continue;
        frame.presses.push_back(press);
        if (may_lead_to_text(press)) led = press;
    }
    return frame;
}

void expect_queued_input(ImGuiIO& io) { compat::expect_input_of_frames(io, named_keys); }

void hand_over(const KeysOfAFrame& frame, Modifiers held, ImGuiIO& io) {
    if (frame.stroke) held = {frame.stroke->ctrl, frame.stroke->shift, false};
    if (!frame.characters.empty()) held = {};  // Dear ImGui reads characters with Ctrl as a shortcut
    const int down = frame.stroke ? frame.stroke->key : -1;
    compat::set_keys(io, named_keys, down, held.ctrl, held.shift, held.alt);
    for (const unsigned character : frame.characters) io.AddInputCharacter(character);
}

}  // namespace braitenlab::ui
