// The sheet of selection by hand: the runs of a brain's children side by side, of which the student chooses one, by a
// click, by its digit, or by the arrow keys and Enter. Beside them the run of their parent.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <imgui.h>

#include "core/lesson/selection.h"
#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/panels/path_picture.h"
#include "ui/panels/sheets.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr int children_per_row = 3;
constexpr float between_children = spacing::small, most_picture = 280, least_picture = 64;  // layout pixels

bool has_choices_left(const LessonView& lesson) {
    return lesson.selection->generation < lesson.exercise->selection.generations;
}

// How long a child stayed, and of those that stayed equally long at how many other starts they stay.
std::pair<float, int> merit_of(const SelectionView& selection, std::size_t child) {
    return {seconds_survived(selection.children[child]), child < selection.stays.size() ? selection.stays[child] : 0};
}

std::pair<float, int> best_merit(const SelectionView& selection) {
    std::pair<float, int> best{0, 0};
    for (std::size_t i = 0; i < selection.children.size(); ++i) best = std::max(best, merit_of(selection, i));
    return best;
}

// True if the parent stays longer than each child.
bool is_parent_best(const SelectionView& selection) {
    return selection.parent && !selection.children.empty() &&
           seconds_survived(*selection.parent) > best_merit(selection).first;
}

// True once the best child has a frame: the first time, the student compares the seconds.
bool marks_best(const LessonView& lesson) {
    return lesson.selection->generation > 0 || lesson.attempt.answers.hints_shown > 0;
}

// The child that has the frame: of the best ones the first. None while the parent is better.
std::optional<std::size_t> framed_child(const LessonView& lesson) {
    const SelectionView& selection = *lesson.selection;
    if (!marks_best(lesson) || is_parent_best(selection)) return std::nullopt;
    const std::pair<float, int> best = best_merit(selection);
    for (std::size_t i = 0; i < selection.children.size(); ++i)
        if (merit_of(selection, i) >= best) return i;
    return std::nullopt;
}

std::string words_of_choice(const LessonView& lesson, const Ui& ui, std::string_view id) {
    const Exercise& exercise = *lesson.exercise;
    return fill(ui.strings(id),
                {fixed(ui, exercise.seconds, 0), std::to_string(exercise.needed), std::to_string(exercise.starts)});
}

// What is to be chosen, and what for.
std::string words_of_choice(const LessonView& lesson, const Ui& ui) {
    const bool marks = marks_best(lesson);
    return words_of_choice(lesson, ui,
                           !has_choices_left(lesson)                    ? "selection.no_more"
                           : marks && is_parent_best(*lesson.selection) ? "selection.how_parent"
                           : marks                                      ? "selection.how"
                                                                        : "selection.how_first");
}

// Of these words, whatever they will be: nothing moves after a choice.
std::size_t lines_of_choice(const LessonView& lesson, const Ui& ui, float width) {
    std::size_t most = 1;
    for (const char* id : {"selection.no_more", "selection.how_parent", "selection.how", "selection.how_first"})
        most = std::max(most, lines_of_words(ui, words_of_choice(lesson, ui, id), Face::text, width).size());
    return most;
}

// True if the runs at the shown start do not tell the children apart: several stay to the end.
bool shows_other_starts(const Exercise& exercise, const SelectionView& selection) {
    return std::count_if(selection.children.begin(), selection.children.end(),
                         [&](const auto& run) { return !has_fallen(exercise, run); }) > 1;
}

// A dot for each other start: filled where the child stays, with × where it falls. `at`: the left end, in the middle of
// the line.
void draw_stays(Ui& ui, ImVec2 at, int stays, std::string_view anchor) {
    const float radius = ui.px(6), step = ui.px(16), arm = ui.px(3);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (int i = 0; i < other_starts; ++i) {
        const ImVec2 centre{at.x + radius + static_cast<float>(i) * step, at.y};
        if (i < stays) {
            draw.AddCircleFilled(centre, radius, paint(ui.palette.success));
            continue;
        }
        const ImU32 ink = paint(ui.palette.text);
        draw.AddCircle(centre, radius, ink, 0, ui.px(1));
        draw.AddLine({centre.x - arm, centre.y - arm}, {centre.x + arm, centre.y + arm}, ink, ui.px(1.5f));
        draw.AddLine({centre.x - arm, centre.y + arm}, {centre.x + arm, centre.y - arm}, ink, ui.px(1.5f));
    }
    mark(ui, anchor, {at.x, at.y - radius, step * other_starts, 2 * radius});
}

// "fell at 14.2 s" or "stayed 60.0 s"; in less room "14.2 s", since the colour and the × tell the rest.
void write_seconds(const Ui& ui, const Exercise& exercise, const StartResult& run, ImVec2 right_end, float room,
                   bool longest) {
    const bool fell = has_fallen(exercise, run);
    const Face face = longest ? Face::strong : Face::text;
    const std::string seconds = fixed(ui, seconds_survived(run), 1);
    std::string words = fill(ui.strings(fell ? "selection.fell" : "selection.stayed"), {seconds});
    if (text_width(ui, face, words) > room) words = fill(ui.strings("time.seconds"), {seconds});
    const Colour tone = legible(fell ? ui.palette.warning : ui.palette.success, ui.palette.raised, ui.palette.text);
    put_right(ui, right_end, words, tone, face);
}

// The frame of a picture, its run and its seconds below. `label`: what is written on the left of the seconds. That of
// the child that stayed longest has a frame of its own.
void draw_child(const Ui& ui, const Item& at, const Exercise& exercise, const StartResult& run, std::string_view label,
                bool longest) {
    const float line = line_height(ui, Face::text), inset = ui.px(spacing::tight);
    fill_box(ui, at.rect, mix(ui.palette.raised, ui.palette.accent, 0.2f * at.warmth), Corner::box);
    line_box(ui, at.rect, longest ? ui.palette.success : ui.palette.line, Corner::box);
    const Colour tone = legible(ui.palette.accent, ui.palette.panel, ui.palette.text);
    const maths::vec2 half{exercise.scene.arena.width / 2, exercise.scene.arena.height / 2};
    const FloorMap map({-half, half},
                       {at.rect.x + inset, at.rect.y + inset, at.rect.w - 2 * inset, at.rect.h - line - 2 * inset});
    draw_run(ui, exercise, run, map, tone);
    const float y = at.bottom() - line - ui.px(2);
    put(ui, {at.rect.x + ui.px(6), y}, label, ui.palette.second_text, Face::text);
    const float of_label = text_width(ui, Face::text, label) + ui.px(label.empty() ? 0 : 6);
    write_seconds(ui, exercise, run, {at.right() - ui.px(6), y}, at.rect.w - ui.px(12) - of_label, longest);
}

// The digit that was pressed for a child, 0-based; −1: none. Digits of other children are removed, too.
int taken_digit(Keyboard& keyboard, std::size_t children) {
    int digit = -1;
    for (int i = 0; i < 9; ++i)
        if (take(keyboard, '1' + i) && static_cast<std::size_t>(i) < children) digit = i;
    return digit;
}

void child_pictures(const LessonView& lesson, Ui& ui, ImVec2 size) {
    const SelectionView& selection = *lesson.selection;
    const bool may_choose = has_choices_left(lesson);
    const std::optional<std::size_t> framed = framed_child(lesson);
    const bool has_dots = shows_other_starts(*lesson.exercise, selection) && !selection.stays.empty();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(between_children), ui.px(between_children)});
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < selection.children.size(); ++i) {
        if (i % children_per_row != 0) ImGui::SameLine();
        const std::string number = std::to_string(i + 1);
        const Item at = item(ui, "selection.child." + number, size, may_choose);
        const StartResult& run = selection.children[i];
        draw_child(ui, at, *lesson.exercise, run, number, i == framed);
        if (i == framed) mark(ui, "selection.framed", at.rect);
        std::string how(ui.strings(may_choose ? "selection.child_how" : "selection.no_more"));
        if (has_dots && !has_fallen(*lesson.exercise, run)) {
            const int stays = merit_of(selection, i).second;
            draw_stays(ui, {at.rect.x + ui.px(8), at.rect.y + ui.px(12)}, stays, "selection.stays." + number);
            how.insert(
                0,
                fill(ui.strings("selection.stays_how"), {std::to_string(stays), std::to_string(other_starts)}) + "\n");
        }
        tooltip(ui, at, how, may_choose ? number : "");
        if (at.pressed) ui.outbox.emplace_back(ChooseChildRequest{static_cast<int>(i)});
    }
    compat::end_group();
    ImGui::PopStyleVar();
    if (!ui.keyboard) return;
    const int digit = taken_digit(*ui.keyboard, selection.children.size());
    if (digit >= 0 && may_choose) ui.outbox.emplace_back(ChooseChildRequest{digit});
}

void parent_picture(const LessonView& lesson, Ui& ui, ImVec2 size) {
    const SelectionView& selection = *lesson.selection;
    const bool may_choose = has_choices_left(lesson);
    ImGui::BeginGroup();
    paragraph(ui, ui.strings("selection.parent"), ui.palette.second_text, Face::small, size.x);
    const Item at = item(ui, "selection.parent", size, may_choose);
    if (selection.parent)
        draw_child(ui, at, *lesson.exercise, *selection.parent, "", marks_best(lesson) && is_parent_best(selection));
    tooltip(ui, at, ui.strings(may_choose ? "selection.parent_how" : "selection.no_more"));
    if (at.pressed) ui.outbox.emplace_back(ChooseChildRequest{-1});
    if (shows_other_starts(*lesson.exercise, selection))
        paragraph(ui, ui.strings("selection.dots"), ui.palette.second_text, Face::small, size.x);
    compat::end_group();
}

// Watch, back, Close.
std::array<ButtonLook, 3> looks_of_buttons(const Ui& ui) {
    return {{{icon::play, ui.strings("selection.watch"), Emphasis::primary},
             {icon::undo, ui.strings("selection.back")},
             {{}, ui.strings("keys.close")}}};
}

// True if the sheet closes.
bool children_buttons(const LabView& view, PanelState& state, Ui& ui) {
    auto [play, back, end] = looks_of_buttons(ui);
    const bool watch = push_button(ui, "selection.watch", play, ui.strings("selection.watch_how"));
    if (watch && view.mode != Mode::playing) state.chosen.push_back(Action::play_pause);
    ImGui::SameLine();
    back.enabled = view.lesson->selection->generation > 0;
    if (push_button(ui, "selection.back", back, ui.strings("selection.back_how")))
        ui.outbox.emplace_back(EarlierGenerationRequest{});
    ImGui::SameLine();
    const bool close =
        push_button(ui, "selection.close", end, ui.strings("keys.close_how"), key_name({key::escape}, ui.strings));
    return watch || close;
}

// Of the parent and three children beside each other, of the buttons below, and of words in few lines, which leave room
// to the pictures; without the borders of the sheet.
float width_of_rows(const Ui& ui, Rect window, float picture) {
    float buttons = 2 * ImGui::GetStyle().ItemSpacing.x;
    for (const ButtonLook& look : looks_of_buttons(ui)) buttons += button_width(ui, look);
    const float words = std::min(ui.px(640), window.w - ui.px(100));
    return std::max({4 * picture + 3 * ui.px(between_children), buttons, words});
}

// Width of a picture: nine with their seconds fit below the words without scrolling where they can. `shape`: height of
// the floor by its width; `line`: of the seconds.
float picture_width(const LessonView& lesson, const Ui& ui, Rect window, float shape, float line) {
    const float wide = std::min((window.w - ui.px(100)) / 4, ui.px(most_picture));
    const std::size_t lines = std::max<std::size_t>(2, lines_of_choice(lesson, ui, width_of_rows(ui, window, 0)));
    const float around = ui.px(196) + static_cast<float>(lines) * line_height(ui, Face::text);
    const float high = (window.h - around) / 3 - line - ui.px(between_children);
    return std::max(std::min(high / shape, wide), ui.px(least_picture));
}

}  // namespace

void children_sheet(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    if (!view.lesson || !view.lesson->selection) return void(state.sheet = Sheet::none);
    const LessonView& lesson = *view.lesson;
    const std::string generation =
        fill(ui.strings("selection.generation"),
             {std::to_string(lesson.selection->generation), std::to_string(lesson.exercise->selection.generations)});
    const Arena& arena = lesson.exercise->scene.arena;
    const float shape = std::clamp(arena.height / arena.width, 0.6f, 1.0f),
                line = line_height(ui, Face::text) + ui.px(8);
    const float picture = picture_width(lesson, ui, window, shape, line);
    const ImVec2 size{std::floor(picture), std::floor(picture * shape + line)};
    const float width = width_of_rows(ui, window, picture) + ui.px(56);
    SheetState& sheet = open_sheet(state, ui, Sheet::children, window, generation, width / ui.scale);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const std::size_t lines = lines_of_choice(lesson, ui, card_width(ui));
    put_lines(ui, start, words_of_choice(lesson, ui), ui.palette.text, Face::text, card_width(ui), lines);
    ImGui::Dummy({1, static_cast<float>(lines) * line_height(ui, Face::text)});
    parent_picture(lesson, ui, size);
    ImGui::SameLine(0, ui.px(spacing::large));
    if (lesson.selection->children.empty()) {  // the words take the room of the pictures
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const int rows = (lesson.exercise->selection.children + children_per_row - 1) / children_per_row;
        const float space = ui.px(between_children), between_rows = static_cast<float>(rows - 1) * space;
        put_lines(ui, at, ui.strings("selection.wait"), ui.palette.second_text, Face::text, 3 * picture, 3);
        ImGui::Dummy({3 * size.x + 2 * space, static_cast<float>(rows) * size.y + between_rows});
    } else {
        child_pictures(lesson, ui, size);
    }
    sheet_buttons(ui, sheet);
    const bool closed = children_buttons(view, state, ui);
    if (end_sheet(sheet) || closed) state.sheet = Sheet::none;
}

void generation_of_selection(const LabView& view, Ui& ui) {
    const LessonView& lesson = *view.lesson;
    if (!lesson.selection) return;
    paragraph(ui,
              fill(ui.strings("selection.generation"), {std::to_string(lesson.selection->generation),
                                                        std::to_string(lesson.exercise->selection.generations)}),
              ui.palette.second_text);
    gap(ui, spacing::small);
}

void selection_button(const LabView& view, PanelState& state, Ui& ui) {
    if (!view.lesson->selection) return;
    if (push_button(ui, "selection.open", {{}, ui.strings("selection.open"), Emphasis::primary},
                    ui.strings("selection.open_how")))
        state.sheet = Sheet::children;
}

}  // namespace braitenlab::ui
