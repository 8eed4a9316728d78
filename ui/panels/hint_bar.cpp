// The line at the bottom: the next step, or a notice.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/breeding/breeding_parts.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompts.h"
#include "ui/scene_input/path_drawing.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// "[play_pause] plays": the key of the action in brackets is drawn as a cap; "[F1]" is drawn as it is.
std::string cap_words(const Ui& ui, std::string_view inside) {
    const auto action = action_named(inside);
    return action ? with_large_arrows(ui, key_name(*action, ui.strings)) : std::string(inside);
}

// Calls `words(text)` and `key(name)` for the parts of a hint, in order.
template <class Words, class Key>
void each_part(const Ui& ui, std::string_view hint, Words words, Key key) {
    while (!hint.empty()) {
        const std::size_t open = hint.find('['), close = open == hint.npos ? hint.npos : hint.find(']', open);
        words(close == hint.npos ? hint : hint.substr(0, open));
        if (close == hint.npos) return;
        key(cap_words(ui, hint.substr(open + 1, close - open - 1)));
        hint.remove_prefix(close + 1);
    }
}

// The hint as a text, with its keys in brackets.
std::string plain_hint(const Ui& ui, std::string_view hint) {
    std::string text;
    each_part(
        ui, hint, [&](std::string_view words) { text += words; },
        [&](const std::string& key) { text += "[" + key + "]"; });
    return text;
}

// A word with the space before it, or the name of a key, which has a cap.
struct HintPiece {
    std::string text;
    bool is_key = false;
};
using HintLine = std::vector<HintPiece>;

std::vector<HintPiece> pieces_of(const Ui& ui, std::string_view hint) {
    std::vector<HintPiece> pieces;
    each_part(
        ui, hint,
        [&](std::string_view words) {
            while (!words.empty()) {
                const std::size_t end = std::min(words.find(' ', words.find_first_not_of(' ')), words.size());
                pieces.push_back({std::string(words.substr(0, end))});
                words.remove_prefix(end);
            }
        },
        [&](const std::string& key) {
            pieces.push_back({key, true});
        });
    return pieces;
}

float width_of(const Ui& ui, const HintPiece& piece, Face face) {
    return piece.is_key ? key_cap_width(ui, piece.text, face) : text_width(ui, face, piece.text);
}

// Hints that say another thing to a finger than that it has no keys.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> hints_for_fingers{
    {{"hint.draw_path", "hint.draw_path_finger"},
     {"hint.turn_slider", "hint.turn_slider_finger"},
     {"hint.turn_slider_paused", "hint.turn_slider_paused_finger"},
     {"hint.slider_drag", "hint.slider_drag_finger"},
     {"hint.first_wire", "hint.first_wire_finger"},
     {"hint.wiring", "hint.wiring_finger"},
     {"hint.wiring_exercise", "hint.wiring_exercise_finger"},
     {"hint.change.slider", "hint.change.slider_finger"},
     {"hint.change.pulsing", "hint.change.pulsing_finger"}}};

constexpr std::string_view between_parts = "  ·  ";

// A part of a hint without its keys: "Play [play_pause]" is "Play", "helps: [hint]" is "helps: Hint". Empty if it
// begins with a key.
std::string part_without_keys(const Ui& ui, std::string_view part) {
    if (part.starts_with('[')) return {};
    std::string words;
    for (;;) {
        const std::size_t open = part.find(" ["), close = part.find(']', open);
        words += part.substr(0, open);
        if (open == part.npos || close == part.npos) return words;
        if (words.ends_with(':')) words += " " + std::string(ui.strings("exercise.hint"));
        part.remove_prefix(close + 1);
    }
}

std::string without_keys(const Ui& ui, std::string_view hint) {
    std::string all;
    while (!hint.empty()) {
        const std::size_t end = hint.find(between_parts);
        const std::string part = part_without_keys(ui, hint.substr(0, end));
        if (!part.empty()) all += (all.empty() ? "" : std::string(between_parts)) + part;
        hint.remove_prefix(end == hint.npos ? hint.size() : end + between_parts.size());
    }
    return all;
}

// True while a text field takes what is typed: no key does then what a hint says.
bool is_typed(const Ui& ui) { return ui.keyboard && ui.keyboard->text == TextInput::open; }

// The text of a hint. To a finger it names no keys and no mouse, while a text is typed no keys.
std::string hint_text(const LabView& view, const Ui& ui, std::string_view key) {
    if (!view.program.touch) return is_typed(ui) ? without_keys(ui, ui.strings(key)) : std::string(ui.strings(key));
    const auto own = std::find_if(hints_for_fingers.begin(), hints_for_fingers.end(),
                                  [key](const auto& row) { return row.first == key; });
    return own != hints_for_fingers.end() ? std::string(ui.strings(own->second)) : without_keys(ui, ui.strings(key));
}

// The hint in lines that are no wider than the room, unless a word is; words of a line are one piece.
std::vector<HintLine> lines_of_hint(const Ui& ui, std::string_view hint, Face face, float room) {
    std::vector<HintLine> lines(1);
    float x = 0;
    for (HintPiece& piece : pieces_of(ui, hint)) {
        const float width = width_of(ui, piece, face);
        if (x + width > room && x > 0 && (piece.is_key || piece.text[0] == ' ')) {
            lines.emplace_back(), x = 0;
            piece.text.erase(0, piece.is_key ? 0 : std::min(piece.text.find_first_not_of(' '), piece.text.size()));
        }
        x += width;
        HintLine& line = lines.back();
        if (!line.empty() && !piece.is_key && !line.back().is_key)
            line.back().text += piece.text;
        else
            line.push_back(std::move(piece));
    }
    return lines;
}

// The bar has one line of small type, or two of the smallest one.
struct HintType {
    Face face = Face::small;
    std::size_t lines = 1;
};
constexpr HintType types_of_hint[]{{Face::small, 1}, {Face::label, 2}};

bool fits_in(const Ui& ui, std::string_view hint, HintType type, float room) {
    const std::vector<HintLine> lines = lines_of_hint(ui, hint, type.face, room);
    return lines.size() <= type.lines && std::all_of(lines.begin(), lines.end(), [&](const HintLine& line) {
               float width = 0;
               for (const HintPiece& piece : line) width += width_of(ui, piece, type.face);
               return width <= room + 1;
           });
}

// The hint, without the last of its parts and then of its words as far as it does not fit in this type.
std::string fitting_hint(const Ui& ui, std::string_view hint, HintType type, float room) {
    for (auto cut = hint.npos; !fits_in(ui, hint, type, room); hint = hint.substr(0, cut))
        if (cut = hint.rfind(between_parts); cut == hint.npos) break;
    if (fits_in(ui, hint, type, room)) return std::string(hint);
    std::string words;
    do {
        const auto cut = hint.rfind(' ');
        if (cut == hint.npos) break;
        hint = hint.substr(0, cut);
        words = std::string(hint) + "…";
    } while (!fits_in(ui, words, type, room));
    return words;
}

// The upper edge of the first of these lines, which are in the middle of the bar.
float top_of_lines(const Ui& ui, Rect bar, Face face, std::size_t lines) {
    return bar.y + (bar.h - static_cast<float>(lines) * line_height(ui, face)) / 2;
}

// A hint that is too long even for two lines is shown in full in its tooltip.
void hint_line(Ui& ui, std::string_view hint, Colour colour, float left, Rect bar) {
    const float room = bar.x + bar.w - ui.px(16) - left;
    const HintType type = fits_in(ui, hint, types_of_hint[0], room) ? types_of_hint[0] : types_of_hint[1];
    const std::string fitting = fitting_hint(ui, hint, type, room);
    const std::vector<HintLine> lines = lines_of_hint(ui, fitting, type.face, room);
    const float line = line_height(ui, type.face);
    float top = top_of_lines(ui, bar, type.face, lines.size());
    for (const HintLine& words : lines) {
        float x = left;
        for (const HintPiece& piece : words)
            x += piece.is_key ? key_cap(ui, {x, top + line / 2}, piece.text, type.face)
                              : put(ui, {x, top}, piece.text, colour, type.face);
        top += line;
    }
    if (fitting == hint) return;
    ImGui::SetCursorScreenPos({bar.x, bar.y});
    tooltip(ui, item(ui, "hint.whole", {bar.w, bar.h}, false), plain_hint(ui, hint));
}

// While the user drives, or the camera mode is driver, the hint is the key that ends this. Empty in other modes.
std::string mode_hint(const LabView& view, const Ui& ui) {
    if (view.mode == Mode::wiring) return {};
    const VehicleView* vehicle = selected_vehicle(view);
    const bool drives = vehicle && vehicle->driver == Driver::manual,
               rides = view.settings.camera.mode == CameraMode::driver;
    std::string hint;
    if (drives) hint = hint_text(view, ui, "hint.driving");
    if (!hint.empty() && rides) hint += between_parts;
    if (rides) hint += hint_text(view, ui, "hint.eyes");
    return hint;
}

// The hint when there is no prompt.
std::string_view usual_hint(const LabView& view) {
    if (view.now->vehicles.empty()) return "hint.empty_scene";
    const bool has_none = view.settings.selection.vehicle == no_vehicle;
    if (view.mode == Mode::wiring)
        return has_none ? "hint.no_vehicle" : view.lesson ? "hint.wiring_exercise" : "hint.wiring";
    if (view.mode == Mode::playing)
        return view.settings.camera.mode == CameraMode::follow ? "hint.following" : "hint.playing";
    return has_none ? "hint.no_vehicle" : "hint.paused";
}

// The key that brings the focus to the slider with this anchor, in brackets; without one, that to the next control.
std::string key_to_slider(const LabView& view, std::string_view anchor) {
    constexpr std::array keys{Action::slider_LL, Action::slider_LR, Action::slider_RL,
                              Action::slider_RR, Action::slider_LM, Action::slider_RM};
    const std::size_t number = number_of_slider(view, anchor);
    const bool has_key = number < std::min(numbered_sliders(view).size(), keys.size());
    return "[" + std::string(name(has_key ? keys[number] : Action::next_card)) + "]";
}

// What the user may change next, with the key of the slider: of the one that pulses, else of the first one.
std::string words_of_change(const LabView& view, const Ui& ui) {
    const std::string_view change = next_change(view, ui.highlight);
    const std::vector<std::string_view> sliders = numbered_sliders(view);
    const std::string_view first = sliders.empty() ? "curve.peak" : sliders.front();
    return fill(hint_text(view, ui, change),
                {key_to_slider(view, change == "hint.change.pulsing" ? ui.highlight : first)});
}

// The hint with what fills its gaps.
std::string filled_hint(const LabView& view, const Ui& ui, std::string_view hint) {
    if (hint == "hint.look_at_ancestor" || hint == "hint.look_at_last" || hint == "hint.take_worse") {
        const auto [ancestor, last] = telling_matches(view.features.breeding).value_or(TellingMatches{{0, 0}, {0, 0}});
        const BreedingCell& cell = hint == "hint.look_at_ancestor" ? ancestor : last;
        const int other = hint == "hint.take_worse" ? ancestor.prey : cell.predator;
        return fill(hint_text(view, ui, hint), {std::to_string(cell.prey), std::to_string(other)});
    }
    const auto gap = [&]() -> std::string {
        if (hint == "hint.passed") return std::string(ui.strings(next_exercise_key(view)));
        if (hint == "hint.turn_slider" || hint == "hint.turn_slider_paused") return key_to_slider(view, ui.highlight);
        if (hint == "hint.breed_against") return std::string(ui.strings("breeding.opponents_random"));
        if (hint == "hint.breeding_runs") return breeding_percent(view.features.breeding, ui);
        if (hint == "hint.take_champion") return std::to_string(chosen_cell(view.features.breeding).prey);
        return words_of_change(view, ui);
    };
    return fill(hint_text(view, ui, hint), {gap()});
}

void write_hint(const LabView& view, Ui& ui, float x, Rect bar, std::string_view hint) {
    if (hint == "hint.slider_drag") {
        hint_line(ui, fill(hint_text(view, ui, hint), {ui.strings("key.shift")}), ui.palette.text, x, bar);
        return;
    }
    if (const VehicleView* drawn = hint == "hint.draw_path" ? vehicle_to_draw_for(view) : nullptr) {
        hint_line(ui, fill(hint_text(view, ui, hint), {std::to_string(drawn->id + 1)}), ui.palette.text, x, bar);
        return;
    }
    if (const std::string of_mode = mode_hint(view, ui); !of_mode.empty())
        return hint_line(ui, of_mode, ui.palette.text, x, bar);
    if (is_typed(ui) && ui.keyboard->focus == "exercise.student")  // Enter hands in
        return hint_line(ui, ui.strings("exercise.student_how"), ui.palette.text, x, bar);
    const bool is_slider_focused = !view.program.touch && ui.keyboard && has_slider_focus(*ui.keyboard);
    if (is_slider_focused && hint != "hint.changed_since" && hint != "hint.passed") {
        const std::string_view keys = view.mode == Mode::paused ? "hint.slider_keys_paused" : "hint.slider_keys";
        hint_line(ui, fill(ui.strings(keys), {ui.strings("key.shift")}), ui.palette.text, x, bar);
        return;
    }
    const bool prompted = !hint.empty();
    if (prompted) {
        put_icon(ui, {x + ui.px(6), bar.y + bar.h / 2}, icon::hint, ui.palette.accent, Face::small);
        if (has_icons(ui)) x += ui.px(20);
    }
    hint_line(ui, filled_hint(view, ui, prompted ? hint : usual_hint(view)),
              prompted ? ui.palette.text : ui.palette.second_text, x, bar);
}

// A notice that is too long even for two lines is shown in full in its tooltip.
void write_notice(const LabView& view, Ui& ui, float x, Rect bar) {
    const Colour colour = colour_of(view.notice.kind, ui.palette);
    put_icon(ui, {x + ui.px(6), bar.y + bar.h / 2}, sign_of(view.notice.kind), colour, Face::small);
    if (has_icons(ui)) x += ui.px(20);
    const float room = bar.x + bar.w - ui.px(16) - x;
    const std::string words = text_of(view.notice, ui.strings);
    const bool is_short = text_width(ui, Face::small, words) <= room;
    const HintType type = is_short ? types_of_hint[0] : types_of_hint[1];
    const std::vector<std::string> lines = lines_of_words(ui, words, type.face, room);
    const bool fits = lines.size() <= type.lines && std::all_of(lines.begin(), lines.end(), [&](const auto& line) {
                          return text_width(ui, type.face, line) <= room;
                      });
    const float top = top_of_lines(ui, bar, type.face, std::min(lines.size(), type.lines));
    put_lines(ui, {x, top}, words, colour, type.face, room, type.lines);
    if (fits) return;
    ImGui::SetCursorScreenPos({bar.x, bar.y});
    tooltip(ui, item(ui, "hint.notice", {bar.w, bar.h}, false), words);
}

// While a breeding runs, how far it is, at the right end of the bar: its sheet may be closed. The room left of it.
Rect room_beside_breeding(const LabView& view, Ui& ui, Rect bar) {
    if (!view.features.breeding.runs) return bar;
    const std::string words = fill(ui.strings("hint.breeding_goes_on"), {breeding_percent(view.features.breeding, ui)});
    const std::string fitting = shortened(ui, words, Face::small, bar.w / 2);
    const float width = text_width(ui, Face::small, fitting), x = bar.x + bar.w - ui.px(16) - width;
    put(ui, {x, top_of_lines(ui, bar, Face::small, 1)}, fitting, ui.palette.second_text, Face::small);
    mark(ui, "hint.breeding", {x, bar.y, width, bar.h});
    bar.w -= width + ui.px(16);
    return bar;
}

}  // namespace

std::string words_of_hint(const LabView& view, const Ui& ui, std::string_view hint) {
    return plain_hint(ui, filled_hint(view, ui, hint));
}

bool has_slider_focus(const Keyboard& keyboard) {
    if (!keyboard.shown) return false;
    const std::string& focus = keyboard.focus;
    return is_slider(focus);
}

std::string_view sign_of(NoticeKind kind) {
    switch (kind) {
        case NoticeKind::done:
            return icon::check;
        case NoticeKind::failure:
            return icon::warning;
        default:
            return icon::notice;
    }
}

Colour colour_of(NoticeKind kind, const Palette& p) {
    const Colour wanted = kind == NoticeKind::done ? p.success : kind == NoticeKind::failure ? p.warning : p.accent;
    return legible(wanted, p.panel, p.text);
}

void hint_bar(const LabView& view, Ui& ui, Rect bar, std::string_view hint) {
    begin_bar(ui, "hint bar", bar);
    const float x = bar.x + ui.px(16);
    const Rect room = hint == "hint.breeding_runs" ? bar : room_beside_breeding(view, ui, bar);
    view.notice.empty() ? write_hint(view, ui, x, room, hint) : write_notice(view, ui, x, room);
    mark(ui, "hint.bar", bar);
    end_bar();
}

}  // namespace braitenlab::ui
