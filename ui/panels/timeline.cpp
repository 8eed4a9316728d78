// The recorded minute of the run as a strip, with bookmarks and a playhead that can be dragged.
#include <algorithm>
#include <cmath>
#include <string>

#include <imgui.h>

#include "core/session/recording.h"
#include "ui/panels/panels.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float timeline_margin = spacing::medium, reading_width = 62, flag_side = 24, groove = 4;  // layout pixels
constexpr float roomy = 260;                  // a narrower strip shows the track only
constexpr std::uint64_t between_lines = 600;  // ticks: ten seconds
constexpr std::uint64_t key_step = 60;        // ticks per press of an arrow key

// One minute on the pixels of a rectangle; it scrolls when the run is longer.
struct TimelineTrack {
    Rect rect;
    std::uint64_t first = 0;

    float x(std::uint64_t tick) const {
        const double share = (static_cast<double>(tick) - static_cast<double>(first)) / recorded_ticks;
        return rect.x + rect.w * static_cast<float>(std::clamp(share, 0.0, 1.0));
    }
    std::uint64_t tick(float x) const {
        const double share = std::clamp(static_cast<double>((x - rect.x) / rect.w), 0.0, 1.0);
        return first + static_cast<std::uint64_t>(std::llround(share * recorded_ticks));
    }
};

std::string seconds_text(const Ui& ui, double ticks) {
    return fill(ui.strings("time.seconds"), {fixed(ui, static_cast<float>(ticks / 60), 1)});
}

void timeline_button(Ui& ui, ImVec2 at, std::string_view id, std::string_view sign, std::string_view fallback,
                     Action action, bool enabled) {
    ImGui::SetCursorScreenPos(at);
    ButtonLook look{sign, has_icons(ui) ? std::string_view{} : fallback, Emphasis::quiet};
    look.min_width = ui.tall(button_height);
    look.enabled = enabled;
    const Item button_item = button(ui, id, look);
    if (button_item.pressed) ui.outbox.push_back(action);
    if (!wants_tooltip(ui, button_item)) return;
    tooltip(ui, button_item, ui.strings("action." + std::string(name(action))), key_name(action, ui.strings));
}

void draw_track(const LabView& view, const Ui& ui, const TimelineTrack& track, float middle, const Item& item) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Palette& p = ui.palette;
    const float half = ui.px(groove) / 2;
    const auto bar = [&](float from, float to, Colour colour) {
        draw.AddRectFilled({from, middle - half}, {to, middle + half}, paint(colour), half);
    };
    const std::uint64_t now = view.now->tick;
    const auto first_line = (track.first + between_lines - 1) / between_lines * between_lines;
    for (std::uint64_t line = first_line; line <= track.first + recorded_ticks; line += between_lines)
        draw.AddLine({track.x(line), middle - ui.px(7)}, {track.x(line), middle + ui.px(7)}, paint(p.line), ui.px(1));
    bar(track.rect.x, track.rect.x + track.rect.w, p.line.with_alpha(0.6f));
    bar(track.x(view.timeline.earliest), track.x(view.timeline.latest), p.second_text.with_alpha(0.55f));
    bar(track.x(view.timeline.earliest), track.x(now), p.accent);
    const float size = ui.px(6.5f + 1.5f * item.warmth);
    draw.AddCircleFilled({track.x(now), middle}, size, paint(p.text), 24);
    if (now < view.timeline.latest) draw.AddCircle({track.x(now), middle}, size, paint(p.accent), 24, ui.px(2));
}

void bookmarks(const LabView& view, Ui& ui, const TimelineTrack& track, float top) {
    const auto& marks = view.timeline.bookmarks;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const float x = track.x(marks[i]), w = ui.px(flag_side), h = ui.px(flag_side), half = ui.px(5);
        ImGui::SetCursorScreenPos({x - w / 2, top});
        const Item flag = item(ui, "bookmark." + std::to_string(i + 1), {w, h});
        const Colour colour = flag.hovered || flag.focused ? ui.palette.text : ui.palette.memory;
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const float tip = top + h - ui.px(7);  // above the knob
        draw.AddTriangleFilled({x - half, tip - 2 * half}, {x + half, tip - 2 * half}, {x, tip}, paint(colour));
        const int index = static_cast<int>(i);
        if (flag.pressed) ui.outbox.push_back(BookmarkRequest{index});
        const bool erase = flag.focused && ui.keyboard && take(*ui.keyboard, key::del);
        if (erase || (flag.hovered && ImGui::IsMouseClicked(1))) ui.outbox.push_back(BookmarkRequest{index, true});
        tooltip(ui, flag, fill(ui.strings("timeline.bookmark"), {seconds_text(ui, static_cast<double>(marks[i]))}));
    }
}

// Mouse on the track, or arrow keys while it has the focus.
void scrub(const LabView& view, PanelState& state, Ui& ui, const TimelineTrack& track, const Item& item) {
    const auto within = [&](std::uint64_t tick) {
        return std::clamp(tick, std::max(view.timeline.earliest, track.first), view.timeline.latest);
    };
    const std::uint64_t under_mouse = within(track.tick(ImGui::GetIO().MousePos.x));
    if (item.held && (!state.playhead_held || under_mouse != view.now->tick))
        ui.outbox.push_back(SeekRequest{under_mouse, true});
    if (state.playhead_held && !item.held) ui.outbox.push_back(SeekRequest{under_mouse, false});
    state.playhead_held = item.held;
    if (!item.focused || !ui.keyboard) return;
    const std::uint64_t now = view.now->tick;
    if (take(*ui.keyboard, key::left)) ui.outbox.push_back(SeekRequest{within(now - std::min(now, key_step)), false});
    if (take(*ui.keyboard, key::right)) ui.outbox.push_back(SeekRequest{within(now + key_step), false});
}

// Time between the shown tick and the newest one.
void reading(const LabView& view, Ui& ui, Rect place) {
    const auto behind = static_cast<double>(view.timeline.latest - view.now->tick);
    const bool at_front = behind == 0;
    const std::string words = at_front ? std::string(ui.strings("timeline.now")) : "−" + seconds_text(ui, behind);
    put_right(ui, {place.x + place.w, place.y + (place.h - line_height(ui, Face::small)) / 2}, words,
              at_front ? ui.palette.second_text : ui.palette.text, Face::small);
    mark(ui, "timeline.behind", place);
}

}  // namespace

void timeline(const LabView& view, PanelState& state, Ui& ui, Rect strip) {
    if (strip.w < ui.px(80)) return;
    begin_bar(ui, "timeline", strip, false, Corner::box);
    const bool is_roomy = strip.w >= ui.px(roomy);
    // All parts are on one line; the flags of bookmarks stand on the track.
    const float middle = strip.y + strip.h / 2, button_top = middle - ui.px(ui.tall(button_height)) / 2;
    float left = strip.x + ui.px(timeline_margin), right = strip.x + strip.w - ui.px(timeline_margin);
    if (is_roomy) {
        left = strip.x + ui.px(4);
        timeline_button(ui, {left, button_top}, "timeline.rewind", icon::slower, "<<", Action::rewind,
                        view.now->tick > view.timeline.earliest);
        left += ui.px(ui.tall(button_height) + 8);
        right = strip.x + strip.w - ui.px(4 + ui.tall(button_height));
        timeline_button(ui, {right, button_top}, "timeline.bookmark", icon::bookmark, "+", Action::set_bookmark, true);
        right -= ui.px(reading_width + 6);
        reading(view, ui, {right, button_top, ui.px(reading_width), ui.px(ui.tall(button_height))});
        right -= ui.px(8);
    }
    const std::uint64_t latest = view.timeline.latest;
    const float reach = std::min(ui.px(ui.tall(2 * spacing::large)), strip.h) / 2;
    const TimelineTrack track{{left, middle - reach, right - left, 2 * reach},
                              latest > recorded_ticks ? latest - recorded_ticks : 0};
    bookmarks(view, ui, track, std::max(strip.y, middle - ui.px(flag_side)));
    ImGui::SetCursorScreenPos({track.rect.x - ui.px(6), track.rect.y});
    const Item item_of_track = item(ui, "timeline.track", {track.rect.w + ui.px(12), track.rect.h});
    scrub(view, state, ui, track, item_of_track);
    draw_track(view, ui, track, middle, item_of_track);
    if (wants_tooltip(ui, item_of_track))
        tooltip(ui, item_of_track,
                fill(ui.strings("timeline.track"),
                     {seconds_text(ui, static_cast<double>(track.tick(ImGui::GetIO().MousePos.x)))}));
    end_bar();
}

}  // namespace braitenlab::ui
