// A lecture: a slim bar on top, the brain or the counts of the population large below, and the keys that were pressed.
#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/cards.h"
#include "ui/panels/map/map_parts.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr double pressed_key_seconds = 2.5;
constexpr std::size_t most_pressed_keys = 4;
constexpr float least_pitch = 0.9f;  // of the lines of a notice, in lines
constexpr float least_title = 120;   // layout pixels, of a shortened one

struct LectureFigure {
    std::string_view anchor, caption;  // caption: key of the string
    std::string words;
    Colour colour;
};

std::vector<LectureFigure> lecture_counts(const LabView& view, const Ui& ui) {
    const Snapshot& now = *view.now;
    const Palette& p = ui.palette;
    if (now.predators + now.prey == 0) return {};
    return {{"lecture.predators", "lecture.predators", std::to_string(now.predators), p.predator},
            {"lecture.prey", "lecture.prey", std::to_string(now.prey), p.prey},
            {"lecture.captures", "lecture.captures", std::to_string(now.events.captures), p.text}};
}

void draw_figure(Ui& ui, const LectureFigure& f, Rect r) {
    const auto middle = [&](Face face) { return r.y + (r.h - line_height(ui, face)) / 2; };
    float x = r.x + ui.px(16);
    x += put(ui, {x, middle(Face::small)}, ui.strings(f.caption), ui.palette.second_text, Face::small) + ui.px(12);
    const Face face = x + text_width(ui, Face::caption, f.words) <= r.x + r.w - ui.px(8) ? Face::caption : Face::title;
    put(ui, {x, middle(face)}, f.words, legible(f.colour, ui.palette.panel, ui.palette.text), face);
    mark(ui, f.anchor, r);
}

// The keys that were pressed, in the bar up to `right`, the newest at the right end; not those that would be left of
// `free_from`. Returns their left edge.
float pressed_keys(const LabView& view, PanelState& state, Ui& ui, float free_from, float right, Rect bar) {
    auto& keys = state.lecture.pressed;
    std::erase_if(keys, [&](const PressedKey& k) { return view.wall_seconds - k.at > pressed_key_seconds; });
    if (keys.size() > most_pressed_keys)
        keys.erase(keys.begin(), keys.end() - static_cast<std::ptrdiff_t>(most_pressed_keys));
    if (keys.empty()) return right;
    const float h = line_height(ui, Face::title) + ui.px(8), space = ui.px(spacing::small), y = bar.y + (bar.h - h) / 2;
    float x = right;
    for (auto k = keys.rbegin(); k != keys.rend(); ++k) {
        const std::string words = key_name(k->press, ui.strings);
        const float width = std::max(h, text_width(ui, Face::title, words) + ui.px(20));
        if (x - width - space < free_from) break;
        x -= width + space;
        fill_box(ui, {x, y, width, h}, ui.palette.text);
        put_centred(ui, {x + width / 2, y + ui.px(4)}, words, ui.palette.ground, Face::title);
    }
    if (x < right) mark(ui, "lecture.keys", {x, y, right - space - x, h});
    return x;
}

// Says that the shown moment is in the past, and by how many seconds; `left` is its left edge. Returns its right edge.
float past_sign(const LabView& view, Ui& ui, float left, Rect bar) {
    if (view.now->tick >= view.timeline.latest) return left;
    const auto behind = static_cast<float>(view.timeline.latest - view.now->tick) / 60;
    const std::string words = fill(ui.strings("lecture.past"), {fixed(ui, behind, 1)});
    const float h = line_height(ui, Face::title) + ui.px(8), w = text_width(ui, Face::title, words) + ui.px(24);
    const Rect sign{left, bar.y + (bar.h - h) / 2, w, h};
    fill_box(ui, sign, ui.palette.text);
    put(ui, {sign.x + ui.px(12), sign.y + ui.px(4)}, words, ui.palette.ground, Face::title);
    mark(ui, "lecture.past", sign);
    return sign.x + sign.w + ui.px(16);
}

// The number of the page between buttons that do what a clicker's keys do, at the right end; without the buttons where
// they would be left of `free_from`. Returns its left edge.
float page_number(const LabView& view, Ui& ui, float free_from, float right, Rect bar) {
    const auto look = [&](std::string_view sign, std::string_view letter) {
        return has_icons(ui) ? ButtonLook{sign, {}, Emphasis::quiet} : ButtonLook{{}, letter, Emphasis::quiet};
    };
    const ButtonLook previous_look = look(icon::previous, "<"), next_look = look(icon::next, ">");
    const auto page_button = [&](std::string_view anchor, const ButtonLook& its_look, Action action, float x) {
        ImGui::SetCursorScreenPos({x, bar.y + (bar.h - ui.px(ui.tall(button_height))) / 2});
        if (push_button(ui, anchor, its_look, ui.strings("action." + std::string(name(action))),
                        key_name(action, ui.strings)))
            ui.outbox.push_back(action);
    };
    const std::string words =
        std::to_string(view.pages->page + 1) + "/" + std::to_string(view.pages->lecture->pages.size());
    const float w = text_width(ui, Face::title, words), h = line_height(ui, Face::title), gap = ui.px(spacing::tight);
    const float next_x = right - gap - button_width(ui, next_look);
    const float previous_x = next_x - w - 2 * gap - button_width(ui, previous_look);
    const bool has_room = previous_x >= free_from;
    const Rect place{(has_room ? next_x - gap : right - ui.px(12)) - w, bar.y + (bar.h - h) / 2, w, h};
    put(ui, {place.x, place.y}, words, ui.palette.text, Face::title);
    mark(ui, "lecture.page", place);
    if (!has_room) return place.x;
    page_button("lecture.next", next_look, Action::next_page, next_x);
    page_button("lecture.previous", previous_look, Action::previous_page, previous_x);
    return previous_x;
}

// While the camera has been moved: the button that restores it, left of `right`; not where it would be left of
// `free_from`. Returns its left edge.
float home_button(const LabView& view, Ui& ui, float free_from, float right, Rect bar) {
    if (!view.has_moved_camera) return right;
    const std::string_view words = ui.strings("action.home");
    const ButtonLook look{icon::enlarge, has_icons(ui) ? std::string_view{} : words, Emphasis::quiet};
    const float x = right - ui.px(spacing::small) - button_width(ui, look);
    if (x < free_from) return right;
    ImGui::SetCursorScreenPos({x, bar.y + (bar.h - ui.px(ui.tall(button_height))) / 2});
    if (push_button(ui, "lecture.home", look, words, key_name(Action::home, ui.strings)))
        ui.outbox.push_back(Action::home);
    return x;
}

// Between pages of a lecture: the button that goes back to the page that was left, with the key that does so, at the
// right end; the number of the page alone where the words would be left of `free_from`. Returns its left edge.
float back_button(const LabView& view, Ui& ui, float free_from, float right, Rect bar) {
    const LectureView& left = *view.documents.left_pages;
    const std::string page = std::to_string(left.page + 1), key = key_name(Action::previous_page, ui.strings);
    const std::string words = fill(ui.strings("lecture.back"), {page}) + "  " + key, few = page + "  " + key;
    ButtonLook look{icon::undo, words};
    if (right - ui.px(spacing::small) - button_width(ui, look) < free_from) look.words = few;
    const float x = right - ui.px(spacing::small) - button_width(ui, look);
    ImGui::SetCursorScreenPos({x, bar.y + (bar.h - ui.px(ui.tall(button_height))) / 2});
    if (push_button(ui, "lecture.back", look,
                    fill(ui.strings("lecture.resume"), {translated(ui, left.lecture->title), page}), key))
        ui.outbox.emplace_back(back_to_page(view));
    return x;
}

// Without the title of an exercise or a scene that could tell the answer.
std::string title_of_scene(const LabView& view, const Ui& ui) {
    if (!view.lesson) return std::string(translated(ui, view.now->scene->title));
    if (hides_outcome(view)) return exercise_heading(view, ui);
    return std::string(translated(ui, view.lesson->exercise->title));
}

// Of the lecture, or of the scene. With two stored brains it says whose are compared, or which of them the vehicle has:
// the title of the scene is that of its own brain.
std::string title_of_bar(const LabView& view, const Ui& ui) {
    if (!view.settings.revealed.title) return {};
    if (view.pages) return std::string(translated(ui, view.pages->lecture->title));
    std::string title = title_of_scene(view, ui);
    const SlotsView& slots = view.features.slots;
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle || !slots.slots[0].design || !slots.slots[1].design) return title;
    const auto character = [&](std::size_t slot) {
        return std::string(ui.strings("character." + std::string(name(slots.slots[slot].character))));
    };
    if (slots.seconds > 0 && slots.slots[0].is_in_vehicle && !hides_character(view, *vehicle))
        return fill(ui.strings("slots.both"), {character(0), character(1)});
    for (const std::size_t slot : {std::size_t{0}, std::size_t{1}})
        if (slots.slots[slot].is_in_vehicle) return fill(ui.strings("slots.in_scene"), {title, slot == 0 ? "A" : "B"});
    return title;
}

// How a notice is written into the bar, so that it covers neither the scene nor the values: in two lines, else in as
// many of the smallest type as the bar has room for, which are then closer to each other.
struct NoticeType {
    Face face;
    std::size_t lines;  // of the notice
    std::size_t most;   // in the bar
};

NoticeType type_of_notice(const Ui& ui, std::string_view words, float room, Rect bar) {
    const float width = room - (has_icons(ui) ? ui.px(22) : 0);
    for (const Face face : {Face::text, Face::small})
        if (const std::size_t lines = lines_of_words(ui, words, face, width).size(); lines <= 2)
            return {face, lines, 2};
    const float line = line_height(ui, Face::small);
    const auto most = 1 + static_cast<std::size_t>((bar.h - line) / (least_pitch * line));
    return {Face::small, lines_of_words(ui, words, Face::small, width).size(), std::max<std::size_t>(2, most)};
}

// The part of the room that the notice needs, with the space beside it; 0 without one.
float width_of_notice(const LabView& view, const Ui& ui, float room, Rect bar) {
    if (view.notice.empty()) return 0;
    const std::string words = text_of(view.notice, ui.strings);
    for (const std::size_t most : {2u, 3u})  // lines: rather the whole room than a third one
        for (float share = 0.4f; share <= 1; share += 0.1f)
            if (const NoticeType type = type_of_notice(ui, words, share * room, bar);
                type.lines <= std::min(most, type.most))
                return share * room + ui.px(12);
    return room + ui.px(12);
}

// In place of the title.
void bar_notice(const LabView& view, Ui& ui, float from, float room, Rect bar) {
    const Colour colour = colour_of(view.notice.kind, ui.palette);
    const float text = from + (has_icons(ui) ? ui.px(22) : 0);
    put_icon(ui, {from + ui.px(7), bar.y + bar.h / 2}, sign_of(view.notice.kind), colour);
    const std::string words = text_of(view.notice, ui.strings);
    const NoticeType type = type_of_notice(ui, words, room, bar);
    const std::size_t count = std::min(type.lines, type.most);
    const float line = line_height(ui, type.face), gaps = static_cast<float>(count - 1);
    const float pitch = count > 1 ? std::min(line, (bar.h - line) / gaps) : line;
    float y = bar.y + (bar.h - line - gaps * pitch) / 2;
    std::vector<std::string> lines = lines_of_words(ui, words, type.face, from + room - text);
    for (std::size_t i = count; i < lines.size(); ++i) lines[count - 1] += " " + lines[i];
    for (std::size_t i = 0; i < count; ++i, y += pitch)
        put(ui, {text, y}, shortened(ui, lines[i], type.face, from + room - text), colour, type.face);
    mark(ui, "hint.bar", {from, bar.y, room, bar.h});
}

// True while the exercise of the page waits for its prediction. Then its card has the room of the sliders.
bool asks_prediction(const LabView& view) {
    return view.pages && view.lesson && view.pages->shows(PagePart::exercise) && view.may.open_prediction &&
           awaits_prediction(*view.lesson);
}

// Opens and folds the cards that a page shows, when it has gone to another step, and the sliders once a prediction is
// made; then the lecturer can fold them.
void follow_page(const LabView& view, PanelState& state) {
    const std::array<int, 3> step = view.pages
                                        ? std::array{static_cast<int>(view.run_id), view.pages->page, view.pages->step}
                                        : std::array{-1, -1, -1};
    const std::array<int, 3> before = std::exchange(state.lecture.step, step);
    const bool asks = asks_prediction(view), was_asked = std::exchange(state.lecture.asks_prediction, asks);
    if (view.pages && was_asked && !asks && view.pages->shows(PagePart::sliders))
        state.card(Card::brain).folded = false;
    if (!view.pages || before == step) return;
    const bool new_page = before[0] != step[0] || before[1] != step[1];
    if (new_page) state.lecture.hands.clear(), state.card(Card::slots).folded = false;
    const bool is_answered_now =
        view.pages->shows(PagePart::answer) && !shows(view.pages->current(), PagePart::answer, before[2]);
    if (new_page) state.lecture.question.content = 0;  // its height is that of the page before
    if (new_page || is_answered_now) state.lecture.question.folded = false;
    for (const auto& [part, card] : {std::pair{PagePart::sliders, Card::brain}, {PagePart::exercise, Card::exercise}}) {
        const bool shown = view.pages->shows(part);
        const bool was_shown = shows(view.pages->current(), part, before[2]);
        if (new_page || shown != was_shown) state.card(card).folded = !shown;
        if (card == Card::brain && asks) state.card(card).folded = true;
    }
}

// Folds the cards of the brain and of the slots while the runs of both slots are shown, so that these have the room.
// After the runs the card of the slots unfolds: it has their numbers.
void follow_comparison(const LabView& view, PanelState& state) {
    const SlotsView& slots = view.features.slots;
    const bool compares = view.lecture && slots.a && slots.b && view.now->seconds < static_cast<double>(slots.seconds);
    if (std::exchange(state.lecture.compares, compares) == compares || !view.lecture) return;
    if (compares) state.card(Card::brain).folded = true;
    state.card(Card::slots).folded = compares;
}

// A count of hands that begins takes the place of the sum in the diagram.
void follow_tally(const LabView& view, PanelState& state) {
    const bool counts = view.tally != nullptr;
    if (!std::exchange(state.lecture.counts, counts) && counts && view.mode != Mode::wiring)
        state.canvas.selection = {};
}

// Folds cards when lecture mode begins, and restores them when it ends.
void follow_lecture_mode(const LabView& view, PanelState& state) {
    if (view.lecture == state.lecture.before.has_value()) return;
    if (view.lecture) {
        BeforeLecture& before = state.lecture.before.emplace();
        before.focus = std::exchange(state.keyboard.focus, {});
        for (const CardTraits& row : cards()) {
            CardState& card = state.card(row.card);
            before.cards[static_cast<std::size_t>(row.card)] = card;
            card.folded |= row.in_lecture == InLecture::folded;
        }
        return;
    }
    for (const CardTraits& row : cards())
        if (row.in_lecture != InLecture::unchanged)
            state.card(row.card) = state.lecture.before->cards[static_cast<std::size_t>(row.card)];
    state.keyboard.focus = state.lecture.before->focus;
    state.lecture.before.reset();
    state.lecture.pressed.clear();
    state.lecture.controls = false;
}

}  // namespace

OpenRequest back_to_page(const LabView& view) {
    return {.path = view.documents.left_pages->lecture->path.string(), .resume = true};
}

// In two lines of smaller type where one has no room; else shortened.
void title_in_bar(Ui& ui, std::string_view title, float from, float room, Rect bar) {
    const auto lines = lines_of_words(ui, title, Face::text, room);
    const bool wraps = text_width(ui, Face::title, title) > room && lines.size() <= 2;
    const Face face = wraps ? Face::text : Face::title;
    const float height = line_height(ui, face) * (wraps ? static_cast<float>(lines.size()) : 1.0f);
    const ImVec2 at{from, bar.y + (bar.h - height) / 2};
    Ui cuts = ui;
    cuts.shortened = nullptr;  // a title that gives way is no text that is cut by mistake
    if (wraps) return void(put_lines(cuts, at, title, ui.palette.second_text, face, room, 2));
    put(ui, at, shortened(cuts, title, face, room), ui.palette.second_text, face);
}

void lecture_bar(const LabView& view, PanelState& state, Ui& ui, Rect bar) {
    begin_bar(ui, "lecture", bar);
    const bool playing = view.mode == Mode::playing;
    const float y = bar.y + (bar.h - ui.px(ui.tall(button_height))) / 2;
    ImGui::SetCursorScreenPos({bar.x + ui.px(12), y});
    ButtonLook play{playing ? icon::pause : icon::play, ui.strings(playing ? "button.pause" : "button.play"),
                    Emphasis::primary};
    play.min_width = 92;
    const Item start = button(ui, "button.play", play);
    tooltip(ui, start, ui.strings("tooltip.play_pause"), key_name(Action::play_pause, ui.strings));
    if (start.pressed) ui.outbox.push_back(Action::play_pause);
    const std::string time = fill(ui.strings("time.seconds"), {fixed(ui, static_cast<float>(view.now->seconds), 1)});
    put(ui, {start.right() + ui.px(16), bar.y + (bar.h - line_height(ui, Face::title)) / 2}, time, ui.palette.text,
        Face::title);
    ButtonLook leave{icon::cross, has_icons(ui) ? std::string_view{} : ui.strings("lecture.leave"), Emphasis::quiet};
    const float width = button_width(ui, leave);
    ImGui::SetCursorScreenPos({bar.x + bar.w - ui.px(12) - width, y});
    const Item end = button(ui, "lecture.leave", leave);
    tooltip(ui, end, ui.strings("lecture.leave"), key_name(Action::lecture, ui.strings));
    if (end.pressed) ui.outbox.push_back(Action::lecture);
    // The title or a notice, between the clock and the button that ends the lecture. A notice has the room that it
    // needs before all buttons and keys.
    const float after_clock = start.right() + ui.px(16 + 96);
    const float from = past_sign(view, ui, after_clock, bar);
    const float until = from + width_of_notice(view, ui, end.rect.x - ui.px(12) - from, bar);
    const float page = view.pages                  ? page_number(view, ui, until, end.rect.x, bar)
                       : view.documents.left_pages ? back_button(view, ui, until, end.rect.x, bar)
                                                   : end.rect.x;
    const float home = home_button(view, ui, until, page, bar);
    const float right = pressed_keys(view, state, ui, until, home, bar);
    const float room = std::max(0.0f, right - ui.px(12) - from);
    // In a lecture file the number of the page says enough where the title has hardly any room.
    std::string title = title_of_bar(view, ui);
    if (view.pages && room < ui.px(least_title) && text_width(ui, Face::title, title) > room) title.clear();
    if (state.lecture.marks.drawing)
        sign_of_pen(ui, {from, bar.y, room, bar.h});
    else if (view.notice.empty())
        title_in_bar(ui, title, from, room, bar);
    else
        bar_notice(view, ui, from, room, bar);
    end_bar();
}

bool shows_lecture_figures(const LabView& view) {
    return view.lecture && !shows_map_of_lecture(view) &&
           (!view.pages || (!view.pages->notes && view.pages->shows(PagePart::values)));
}

void lecture_figures(const LabView& view, PanelState& state, Ui& ui, Rect bar) {
    if (bar.h <= 0 || !shows_lecture_figures(view)) return;
    begin_bar(ui, "lecture figures", bar);
    if (const VehicleView* vehicle = vehicle_of_live_picture(view)) {
        live_brain(view, state, ui, *vehicle, bar);
        return end_bar();
    }
    const auto all = lecture_counts(view, ui);
    const float each = bar.w / static_cast<float>(std::max<std::size_t>(1, all.size()));
    for (std::size_t i = 0; i < all.size(); ++i)
        draw_figure(ui, all[i], {bar.x + each * static_cast<float>(i), bar.y, each, bar.h});
    end_bar();
}

void blank_window(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    state.lecture.blank &= view.lecture;
    if (!state.lecture.blank) return;
    ImGui::SetNextWindowPos({window.x, window.y});
    ImGui::SetNextWindowSize({window.w, window.h});
    ImGui::Begin("lecture blank", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) state.lecture.blank = false;
    mark(ui, "lecture.blank", window);
    compat::end_window();
    ImGui::GetForegroundDrawList()->AddRectFilled({window.x, window.y}, {window.x + window.w, window.y + window.h},
                                                  IM_COL32_BLACK);
}

void follow_lecture(const LabView& view, PanelState& state) {
    follow_lecture_mode(view, state);
    follow_page(view, state);
    follow_comparison(view, state);
    follow_tally(view, state);
}

}  // namespace braitenlab::ui
