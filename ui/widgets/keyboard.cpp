#include "ui/widgets/keyboard.h"

#include <algorithm>
#include <span>
#include <utility>

#include "ui/imgui_compat.h"

namespace braitenlab::ui {

namespace {

using StopSpan = std::span<const Keyboard::Stop>;

int stop_index(StopSpan stops, std::string_view id) {
    const auto found = std::find_if(stops.begin(), stops.end(), [id](const auto& stop) { return stop.id == id; });
    return found == stops.end() ? -1 : static_cast<int>(found - stops.begin());
}

int next_card(StopSpan stops, int from) {
    const int count = static_cast<int>(stops.size());
    if (from < 0) return 0;
    const int card = stops[static_cast<std::size_t>(from)].card;
    for (int i = from; i < count; ++i)
        if (stops[static_cast<std::size_t>(i)].card != card) return i;
    return 0;
}

}  // namespace

void show_focus_for(Keyboard& keyboard, KeyPress press) {
    const bool arrow = press.key >= key::right && press.key <= key::up, digit = press.key >= '1' && press.key <= '6';
    if (press.key == ' ') keyboard.shown = false;
    if (press.key == key::tab || press.key == key::enter || arrow || digit || press.ctrl || press.key >= key::f1)
        keyboard.shown = true;
}

void begin_keyboard(Keyboard& keyboard) {
    const StopSpan stops(keyboard.last_stops.data(), keyboard.last_count);
    const int count = static_cast<int>(stops.size());
    int at = stop_index(stops, keyboard.focus);
    if (at < 0 && !stops.empty() && !keyboard.revealed)
        keyboard.focus.clear();  // a focus set since the last frame is kept
    while (const auto press = take(keyboard, key::tab)) {
        if (count == 0) continue;
        at = press->ctrl ? next_card(stops, at) : press->shift ? (at <= 0 ? count : at) - 1 : (at + 1) % count;
        keyboard.focus = stops[static_cast<std::size_t>(at)].id;
        keyboard.revealed = true;
    }
    keyboard.stop_count = 0;
    keyboard.card = 0;
}

void hold_keyboard(Keyboard* keyboard) {
    if (!keyboard) return;
    if (!keyboard->was_held && !keyboard->held) keyboard->focus_before = std::exchange(keyboard->focus, {});
    keyboard->held = true;
    keyboard->stop_count = 0;
}

void end_keyboard(Keyboard& keyboard) {
    const StopSpan stops(keyboard.stops.data(), keyboard.stop_count);
    keyboard.left &= keyboard.held && keyboard.focus.empty();
    if (keyboard.held && !keyboard.left && stop_index(stops, keyboard.focus) < 0)
        keyboard.focus = stops.empty() ? "" : stops.front().id;
    if (keyboard.was_held && !keyboard.held) keyboard.focus = std::exchange(keyboard.focus_before, {});
    const int at = stop_index(stops, keyboard.focus);
    keyboard.text = at < 0 ? TextInput::none : stops[static_cast<std::size_t>(at)].text;
    keyboard.was_held = std::exchange(keyboard.held, false);
    keyboard.presses.clear();
    keyboard.revealed = false;
    keyboard.last_stops.swap(keyboard.stops);
    std::swap(keyboard.last_count, keyboard.stop_count);
}

void release_keyboard(Keyboard& keyboard) {
    if (!std::exchange(keyboard.was_held, false)) return;
    keyboard.focus = std::exchange(keyboard.focus_before, {});
    keyboard.revealed = !keyboard.focus.empty();  // the widget is drawn again in the next frame
}

void begin_stops(Keyboard* keyboard) {
    if (keyboard) ++keyboard->card;
}

bool stop_here(Keyboard* keyboard, std::string_view id) {
    if (!keyboard) return false;
    if (keyboard->stop_count == keyboard->stops.size()) keyboard->stops.emplace_back();
    Keyboard::Stop& stop = keyboard->stops[keyboard->stop_count++];
    stop.id.assign(id);
    stop.card = keyboard->card;
    stop.text = TextInput::none;
    return keyboard->focus == id;
}

void takes_text(Keyboard* keyboard, std::string_view id, bool has_cursor) {
    if (!keyboard || keyboard->stop_count == 0) return;
    Keyboard::Stop& stop = keyboard->stops[keyboard->stop_count - 1];
    if (stop.id == id) stop.text = has_cursor ? TextInput::open : TextInput::awaited;
}

void end_text_by_press(const Keyboard& keyboard) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (keyboard.text != TextInput::open || !ImGui::IsMouseClicked(0) || keyboard.field.contains(mouse.x, mouse.y))
        return;
    ImGui::ClearActiveID();
}

void leave(Keyboard* keyboard, std::string_view id) {
    if (!keyboard || keyboard->focus != id) return;
    keyboard->focus.clear();
    keyboard->left = true;
}

std::optional<KeyPress> take(Keyboard& keyboard, int wanted) {
    auto& presses = keyboard.presses;
    const auto found =
        std::find_if(presses.begin(), presses.end(), [wanted](const KeyPress& p) { return p.key == wanted; });
    if (found == presses.end()) return std::nullopt;
    const KeyPress press = *found;
    presses.erase(found);
    return press;
}

}  // namespace braitenlab::ui
