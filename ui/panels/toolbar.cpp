// The bar of buttons below the menu bar; in an upright window it has two rows, and speed and status are in the second
// one. In a narrow window, first the type and the gaps are smaller, then words are left out, the least important group
// first, and at last the buttons at the end, which the menus have, too. Tooltips always show the words.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr int compact_step = 1, first_words_go = 2, narrowest_step = first_words_go + 2;  // steps of narrowness
constexpr int never = 99;
constexpr float toolbar_margin = spacing::medium, between_buttons = spacing::tight,
                toolbar_group_gap = 2 * spacing::small + 1;  // with the line in it
constexpr float speed_width = 52, status_width = 224,
                compact_status = 220;  // the pill, and the clock with the pace below

struct Tool {
    std::string_view anchor, words, icon;  // words: key of the string
    Action action;
    int loses_words;  // step of narrowness at which its words are left out
    bool on = false;
    bool first_of_group = false;
    bool enabled = true;
};

std::vector<Tool> tools(const LabView& view, const PanelState& state) {
    const bool playing = view.mode == Mode::playing;
    std::vector<Tool> all{
        {"button.play", playing ? "button.pause" : "button.play", playing ? icon::pause : icon::play,
         Action::play_pause, never},
        {"button.step", "button.step", icon::step, Action::step, first_words_go + 2},
        {"button.reset", "button.reset", icon::reset, Action::reset, first_words_go + 2},
        {"button.follow", "button.follow", icon::follow, Action::follow, first_words_go + 1,
         view.settings.camera.mode == CameraMode::follow, true},
        {"button.wiring", "button.wiring", icon::wiring, Action::wiring, first_words_go + 1, view.mode == Mode::wiring},
        {"button.undo", "button.undo", icon::undo, Action::undo, first_words_go, false, true},
        {"button.save", "button.save", icon::save, Action::save, first_words_go},
    };
    for (Tool& tool : all)
        tool.enabled = tool.action == Action::follow || why_unavailable(view, state, tool.action).empty();
    return all;
}

ButtonLook tool_look(const Ui& ui, const Tool& tool, int narrowness) {
    const bool is_play = tool.action == Action::play_pause;
    ButtonLook look;
    look.icon = tool.icon;
    if (narrowness < tool.loses_words || !has_icons(ui)) look.words = ui.strings(tool.words);
    look.emphasis = is_play ? Emphasis::primary : Emphasis::quiet;
    if (is_play) look.min_width = 92;  // the same width for Play and Pause
    look.compact = narrowness >= compact_step;
    look.on = tool.on;
    look.enabled = tool.enabled;
    return look;
}

float width_of_status(int narrowness) { return narrowness < compact_step ? status_width : compact_status; }

// `alone`: without speed and status.
float width_of(const Ui& ui, const std::vector<Tool>& all, int narrowness, bool alone) {
    float width = 2 * ui.px(toolbar_margin);
    for (const Tool& tool : all)
        width += button_width(ui, tool_look(ui, tool, narrowness)) +
                 ui.px(tool.first_of_group ? toolbar_group_gap : between_buttons);
    if (alone) return width;
    return width + ui.px(toolbar_group_gap + 2 * ui.tall(34) + speed_width + 2 * between_buttons + toolbar_group_gap +
                         width_of_status(narrowness));
}

void tool_button(const LabView& view, PanelState& state, Ui& ui, const Tool& tool, int narrowness) {
    const Item at = button(ui, tool.anchor, tool_look(ui, tool, narrowness));
    if (at.pressed) state.chosen.push_back(tool.action);
    if (!wants_tooltip(ui, at)) return;
    // "tooltip.play_pause" and so on
    const std::string key = "tooltip." + std::string(name(tool.action));
    const std::string_view why = tool.enabled ? std::string_view{} : why_unavailable(view, state, tool.action);
    tooltip(
        ui, at,
        why.empty() ? ui.strings.find(key, ui.strings("action." + std::string(name(tool.action)))) : ui.strings(why),
        key_name(tool.action, ui.strings));
}

void rule(Ui& ui, float x, Rect bar) {
    ImGui::GetWindowDrawList()->AddLine({x, bar.y + ui.px(12)}, {x, bar.y + bar.h - ui.px(12)}, paint(ui.palette.line),
                                        ui.px(1));
}

std::string speed_words(const Ui& ui, float time_scale) {
    struct Fraction {
        float value;
        const char* words;
    };
    for (const Fraction f : {Fraction{0.125f, "1/8×"}, Fraction{0.25f, "1/4×"}, Fraction{0.5f, "1/2×"}})
        if (time_scale < f.value * 1.01f && time_scale > f.value * 0.99f) return f.words;
    return fixed(ui, time_scale, time_scale < 1 ? 2 : 0) + "×";
}

// Slower, the speed, faster. Returns the right end.
float speed_control(const LabView& view, Ui& ui, float x, Rect bar) {
    const float y = bar.y + (bar.h - ui.px(ui.tall(button_height))) / 2;
    const auto end = [&](std::string_view id, std::string_view sign, std::string_view fallback, Action action,
                         bool enabled) {
        ImGui::SetCursorScreenPos({x, y});
        ButtonLook look{sign, has_icons(ui) ? std::string_view{} : fallback, Emphasis::quiet};
        look.enabled = enabled;
        look.min_width = 34;
        const Item at = button(ui, id, look);
        if (at.pressed) ui.outbox.push_back(action);
        tooltip(ui, at, ui.strings("action." + std::string(name(action))), key_name(action, ui.strings));
        x = at.right();
    };
    end("button.slower", icon::slower, "−", Action::slower, view.time_scale > 0.126f);
    const Rect value{x, y, ui.px(speed_width), ui.px(ui.tall(button_height))};
    put_centred(ui, {x + value.w / 2, bar.y + bar.h / 2 - line_height(ui, Face::text) / 2},
                speed_words(ui, view.time_scale), ui.palette.text);
    mark(ui, "speed", value);
    x += value.w;
    end("button.faster", icon::faster, "+", Action::faster, view.time_scale < 15.9f);
    return x;
}

// How strongly the clock is marked because a tick was made or taken back in a pause: 1 at once, then less, 0 after a
// while. Dear ImGui stores the tick and the moment.
float mark_of_step(const LabView& view, const Ui& ui) {
    constexpr double seconds = 0.6;
    ImGuiStorage& memory = *ImGui::GetStateStorage();
    const ImGuiID of_tick = ImGui::GetID("tick"), since = ImGui::GetID("step since");
    const int tick = static_cast<int>(view.now->tick), before = memory.GetInt(of_tick, tick);
    memory.SetInt(of_tick, tick);
    if (view.mode == Mode::paused && std::abs(tick - before) == 1)
        memory.SetFloat(since, static_cast<float>(ImGui::GetTime()));
    const double begun = memory.GetFloat(since, -1), age = ImGui::GetTime() - begun;
    if (view.mode != Mode::paused || begun < 0 || age > seconds) return 0;
    return ui.still ? 1 : static_cast<float>(1 - age / seconds);
}

// The state as a coloured word with its sign, and the simulated time: in a pause between two tenths with one digit
// more, so that each tick changes it.
// No time passes while a sheet is open.
void status_pill(const LabView& view, const PanelState& state, Ui& ui, float x, float layout_width, Rect bar) {
    const Palette& p = ui.palette;
    const bool playing = view.mode == Mode::playing && state.sheet == Sheet::none, wiring = view.mode == Mode::wiring;
    const Colour colour = legible(playing ? p.accent : wiring ? p.memory : p.text, p.panel, p.text);
    const std::optional<float> clip = view.program.clip_progress;
    const std::string percent = std::to_string(static_cast<int>(std::floor(100 * clip.value_or(0))));
    const std::string words = fill(ui.strings(clip      ? "mode.clip"
                                              : playing ? "mode.playing"
                                              : wiring  ? "mode.wiring"
                                                        : "mode.paused"),
                                   {percent});
    const float middle = bar.y + bar.h / 2;
    const Rect pill{x, middle - ui.px(13), ui.px(104), ui.px(26)};
    fill_box(ui, pill, colour.with_alpha(0.14f), Corner::round);
    const float icon_room = has_icons(ui) ? ui.px(18) : 0;
    const bool fits = icon_room + text_width(ui, Face::small, words) <= pill.w - ui.px(12);
    const Face face = fits ? Face::small : Face::label;
    const float left = pill.x + (pill.w - icon_room - text_width(ui, face, words)) / 2;
    put_icon(ui, {left + ui.px(5), middle},
             clip      ? icon::save
             : playing ? icon::play
             : wiring  ? icon::wiring
                       : icon::pause,
             colour, Face::small);
    put(ui, {left + icon_room, middle - line_height(ui, face) / 2}, words, colour, face);
    mark(ui, "mode", pill);
    constexpr std::uint64_t tenth = 6;  // ticks
    const int decimals = view.mode == Mode::paused && view.now->tick % tenth != 0 ? 2 : 1;
    const std::string time =
        fill(ui.strings("time.seconds"), {fixed(ui, static_cast<float>(view.now->seconds), decimals)});
    const Rect clock{pill.x + pill.w + ui.px(8), pill.y, ui.px(layout_width - 112), pill.h};
    const float raised = view.pace ? line_height(ui, Face::small) / 2 : 0;
    if (const float strength = mark_of_step(view, ui); strength > 0) {
        const float w = text_width(ui, Face::text, time) + ui.px(2 * spacing::small);
        const Rect box{clock.x + clock.w - w + ui.px(spacing::small), clock.y, w, clock.h};
        fill_box(ui, box, p.accent.with_alpha(0.3f * strength));
        line_box(ui, box, p.accent.with_alpha(strength));
        mark(ui, "time.step", box);
    }
    put_right(ui, {clock.x + clock.w, middle - line_height(ui, Face::text) / 2 - raised}, time, p.text);
    if (view.pace) {  // the computer is too slow for the requested speed
        const std::string pace = fill(ui.strings("time.pace"), {fixed(ui, *view.pace, *view.pace < 0.095f ? 2 : 1)});
        put_right(ui, {clock.x + clock.w, middle + line_height(ui, Face::text) / 2 - raised}, pace,
                  colour_of(NoticeKind::failure, p), Face::small);
        mark(ui, "pace", clock);
    }
    mark(ui, "time", clock);
}

}  // namespace

void toolbar(const LabView& view, PanelState& state, Ui& ui, Rect bar) {
    begin_bar(ui, "toolbar", bar);
    std::vector<Tool> all = tools(view, state);
    int narrowness = 0;
    const bool has_two_rows = bar.h >= 2 * ui.px(ui.tall(button_height));
    while (narrowness < narrowest_step && width_of(ui, all, narrowness, has_two_rows) > bar.w) ++narrowness;
    while (all.back().action != Action::follow && width_of(ui, all, narrowness, has_two_rows) > bar.w) all.pop_back();
    const Rect whole = bar, last{bar.x, bar.y + bar.h / 2, bar.w, bar.h / 2};
    if (has_two_rows) bar.h /= 2;

    const float y = bar.y + (bar.h - ui.px(ui.tall(button_height))) / 2;
    float x = bar.x + ui.px(toolbar_margin);
    const auto next_group = [&] {
        x += ui.px(toolbar_group_gap - between_buttons);
        rule(ui, x - ui.px((toolbar_group_gap - between_buttons) / 2 + between_buttons / 2), bar);
    };
    for (const Tool& tool : all) {
        if (tool.action == Action::follow && !has_two_rows) {
            next_group();
            x = speed_control(view, ui, x, bar) + ui.px(between_buttons);
        }
        if (tool.first_of_group) next_group();
        ImGui::SetCursorScreenPos({x, y});
        tool_button(view, state, ui, tool, narrowness);
        x += button_width(ui, tool_look(ui, tool, narrowness)) + ui.px(between_buttons);
    }
    const float status = width_of_status(narrowness);
    const Rect of_status = has_two_rows ? last : whole;
    if (has_two_rows) speed_control(view, ui, bar.x + ui.px(toolbar_margin), last);
    status_pill(view, state, ui, bar.x + bar.w - ui.px(toolbar_margin + status), status, of_status);
    end_bar();
}

}  // namespace braitenlab::ui
