#include "app/platform/web_keys.h"

#include <array>
#include <string_view>
#include <utility>

#include <emscripten/html5.h>

#include "app/platform/page.h"
#include "core/utf8.h"
#include "ui/shortcuts.h"

namespace braitenlab::web {

namespace {

constexpr int first_f_key = key::f1;

// KeyboardEvent.key of the keys without a character.
constexpr std::array<std::pair<std::string_view, int>, 19> named_keys{{{"Escape", key::escape},
                                                                       {"Enter", key::enter},
                                                                       {"Tab", key::tab},
                                                                       {"Backspace", key::backspace},
                                                                       {"Insert", key::insert},
                                                                       {"Delete", key::del},
                                                                       {"ArrowRight", key::right},
                                                                       {"ArrowLeft", key::left},
                                                                       {"ArrowDown", key::down},
                                                                       {"ArrowUp", key::up},
                                                                       {"PageUp", key::page_up},
                                                                       {"PageDown", key::page_down},
                                                                       {"Home", key::home},
                                                                       {"End", key::end},
                                                                       {"ContextMenu", key::menu},
                                                                       {"F1", key::f1},
                                                                       {"F5", key::f5},
                                                                       {"F9", key::f9},
                                                                       {"F10", key::f10}}};

bool takes_f5 = false;

// The only code point of a text; 0 if it has none or several.
unsigned only_character(std::string_view text) {
    if (text.empty()) return 0;
    const CodePoint first = first_code_point(text);
    return first.is_valid && first.size == text.size() ? first.code : 0;
}

bool with_ctrl(const EmscriptenKeyboardEvent& e) { return e.ctrlKey || e.metaKey; }

// AltGr types a character; browsers on Windows report it as Ctrl and Alt.
bool is_typed(const EmscriptenKeyboardEvent& e) {
    return only_character(e.key) >= ' ' && (!with_ctrl(e) || (e.ctrlKey && e.altKey));
}

// The digit at its place, else the character without Shift; 0: none.
int unshifted(const EmscriptenKeyboardEvent& e, unsigned c) {
    const std::string_view code = e.code;
    if (code.size() == 6 && code.starts_with("Digit")) return code[5];
    if (e.shiftKey && code == "Period") return '.';
    if (e.shiftKey && code == "Comma") return ',';
    if (c > 0x7F) return 0;
    return c >= 'a' && c <= 'z' ? static_cast<int>(c - 'a' + 'A') : static_cast<int>(c);
}

}  // namespace

bool is_for_lab(const EmscriptenKeyboardEvent& e) {
    if (is_typed(e)) return true;
    const int key = press_of(e).key;
    if (with_ctrl(e)) return key != 'V' && !is_for_browser({key, true});  // the browser pastes
    if (key == key::f5 && !takes_f5) return false;
    return key != 0 && !e.altKey;
}

KeyPress press_of(const EmscriptenKeyboardEvent& e) {
    const bool ctrl = with_ctrl(e) && !is_typed(e);
    for (const auto& [name, number] : named_keys)
        if (name == e.key) return {number, ctrl, static_cast<bool>(e.shiftKey)};
    const unsigned c = only_character(e.key);
    const int key = c == 0 ? 0 : unshifted(e, c);
    if (key == 0) return {};
    return ui::as_typed({key, ctrl, static_cast<bool>(e.shiftKey)}, c);
}

unsigned character_of(const EmscriptenKeyboardEvent& e) { return is_typed(e) ? only_character(e.key) : 0; }

void HeldKeys::set(const EmscriptenKeyboardEvent& e, bool down) {
    modifiers_ = {with_ctrl(e), static_cast<bool>(e.shiftKey), static_cast<bool>(e.altKey)};
    if (const int key = press_of(e).key; key > 0 && key < static_cast<int>(held_.size()))
        held_.set(static_cast<std::size_t>(key), down);
    if (!down && e.metaKey) held_.reset();  // macOS does not report the release of a key while Command is held
}

bool HeldKeys::has(int glfw_key) const {
    return glfw_key >= 0 && glfw_key < static_cast<int>(held_.size()) && held_.test(static_cast<std::size_t>(glfw_key));
}

}  // namespace braitenlab::web

namespace braitenlab {

void take_reload_key(bool wanted) { web::takes_f5 = wanted; }

}  // namespace braitenlab
