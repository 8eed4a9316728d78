// The parts of a page of a lecture file: caption, question with counted hands, and the lecturer's notes.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "ui/panels/cards.h"
#include "ui/panels/course/lecture_time.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float caption_side = 20, caption_above = spacing::tight, page_padding = spacing::medium;  // layout pixels
constexpr float hands_field = 44, hands_button = 29, bar_thickness = 16, between_answers = spacing::small,
                count_width = 48;
constexpr float letter_column = 36, small_letter_column = 24;  // of "A", at the caption's size, and beside notes
constexpr float card_around = 60;                              // heading and padding of the card, in height

std::string option_id(const char* stem, std::size_t option) { return stem + std::to_string(option + 1); }

// A count as typed; nullopt for text that is no number.
std::optional<int> typed_count(const std::string& text) {
    int count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return count;
}

// One more or one less hand, and the count as a field, which shows the count while it is not edited. The buttons are
// for the pointer only, so that Tab goes from count to count.
void count_row(const LectureView& page, PanelState& state, Ui& ui, std::size_t option) {
    const int hands = page.hands[static_cast<std::size_t>(page.page)][option];
    const auto ask = [&](int wanted) { ui.outbox.push_back(HandsRequest{static_cast<int>(option), wanted}); };
    TextField& field = state.lecture.hands[option];
    if (!field.active) field.text = std::to_string(hands);
    const std::string less = option_id("lecture.less.", option), more = option_id("lecture.more.", option),
                      count = option_id("lecture.hands.", option);
    Ui pointed = ui;
    pointed.keyboard = nullptr;
    if (push_button(pointed, less, {{}, "−", Emphasis::plain, false, hands > 0, hands_button},
                    ui.strings("lecture.less")))
        ask(hands - 1);
    ImGui::SameLine();
    text_field(ui, field, count, ui.px(hands_field), "0", ui.strings("lecture.hands"));
    if (field.active || field.entered)
        if (const auto typed = typed_count(field.text); typed && *typed != hands) ask(*typed);
    if (field.entered && ui.keyboard) ui.keyboard->focus.clear();  // the next keys are not for the field
    ImGui::SameLine();
    if (push_button(pointed, more, {{}, "+", Emphasis::plain, false, true, hands_button}, ui.strings("lecture.more")))
        ask(hands + 1);
}

// The share of all hands as a bar at the cursor with its percentage at the right edge; in the middle of a row so high.
// Once the answer is known, a count without hands has an empty place.
void share_bar(const LectureView& page, Ui& ui, std::size_t option, Colour colour, float row) {
    const auto& hands = page.hands[static_cast<std::size_t>(page.page)];
    int all = 0;
    for (const int each : hands) all += each;
    const float share = all > 0 ? static_cast<float>(hands[option]) / static_cast<float>(all) : 0;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const auto percent = [&](float each) {
        return fill(ui.strings("lecture.percent"), {std::to_string(std::lround(100 * each))});
    };
    const float beside = text_width(ui, Face::strong, percent(1)) + ui.px(spacing::small), h = ui.px(bar_thickness);
    const float width = std::max(1.0f, ImGui::GetWindowPos().x + card_width(ui) - at.x),
                line = line_height(ui, Face::strong);
    const Rect bar{at.x, at.y + (row - h) / 2, std::max(1.0f, width - beside), h};
    if (all > 0) put_right(ui, {at.x + width, at.y + (row - line) / 2}, percent(share), ui.palette.text, Face::strong);
    if (all > 0 || page.awaits_answer())
        line_box(ui, bar, ui.palette.second_text.with_alpha(0.5f), Corner::round);  // an empty frame: no hands
    const Rect of_share{bar.x, bar.y, bar.w * share, bar.h};  // as long as the share says, also a short one
    if (share > 0) fill_box(ui, of_share, colour, Corner::round);
    mark(ui, option_id("lecture.share.", option), bar);
    ImGui::Dummy({width, row});
}

// The captions of a lecture have one size: the largest in which each of them has two lines at most.
Face face_of_captions(const Lecture& lecture, const Ui& ui, float width) {
    const bool fits = std::all_of(lecture.pages.begin(), lecture.pages.end(), [&](const LecturePage& page) {
        return lines_of_words(ui, translated(ui, page.caption), Face::caption, width).size() <= 2;
    });
    return fits ? Face::caption : Face::title;
}

float height_of(const Ui& ui, std::string_view words, Face face, float width) {
    return static_cast<float>(lines_of_words(ui, words, face, width).size()) * line_height(ui, face);
}

// Where the smallest type of the options is needed, the words of the question have it too, and gaps are smaller.
float gap_of_options(Face of_options) { return of_options == Face::strong ? spacing::tight : spacing::medium; }
Face face_of_text(Face of_options) { return of_options == Face::strong ? Face::strong : Face::title; }
float gap_of_text(Face of_options) { return of_options == Face::strong ? spacing::small : page_padding; }

// Of the options of a question, each with a row for its hands below it. `indent`: of the words, window pixels.
float height_of_options(const Ui& ui, const LectureQuestion& asked, Face face, float width, float indent) {
    const float row = ui.px(ui.tall(button_height) + gap_of_options(face) + 2 * spacing::tight);
    float used = 0;
    for (const std::string& option : asked.options)
        used += height_of(ui, translated(ui, option), face, width - indent) + row;
    return used;
}

float height_of_text(const Ui& ui, const LectureQuestion& asked, Face of_options) {
    if (asked.text.empty()) return 0;
    return height_of(ui, translated(ui, asked.text), face_of_text(of_options), card_width(ui)) + ui.px(page_padding);
}

// So have the options of its questions: the largest in which each question fits into this height.
Face face_of_options(const Lecture& lecture, const Ui& ui, float width, float height) {
    for (const Face face : {Face::caption, Face::title})
        if (std::all_of(lecture.pages.begin(), lecture.pages.end(), [&](const LecturePage& page) {
                return height_of_text(ui, page.question, face) +
                           height_of_options(ui, page.question, face, width, ui.px(letter_column)) <=
                       height;
            }))
            return face;
    return Face::strong;
}

std::string letter_of(std::size_t option) { return {static_cast<char>('A' + option)}; }

// Beside notes the options are small.
float indent_of_options(const LectureView& page, const Ui& ui) {
    return ui.px(page.notes ? small_letter_column : letter_column);
}

// The words of an option with the letter by which the lecturer calls it. The cursor is then at its row for the hands:
// below the letter, so that the bar is long, or behind it where there are no words.
void lettered_option(const LectureView& page, Ui& ui, std::size_t option, Colour letter, Colour words, Face face) {
    const float indent = indent_of_options(page, ui);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (page.current().question.options[option].empty()) {
        put(ui, {at.x, at.y + (ui.px(button_height) - line_height(ui, face)) / 2}, letter_of(option), letter, face);
        return ImGui::SetCursorScreenPos({at.x + indent, at.y});
    }
    put(ui, at, letter_of(option), letter, face);
    ImGui::SetCursorScreenPos({at.x + indent, at.y});
    even_paragraph(ui, translated(ui, page.current().question.options[option]), words, face);
    ImGui::SetCursorScreenPos({at.x, ImGui::GetCursorScreenPos().y});
}

void option_to_count(const LabView& view, PanelState& state, Ui& ui, std::size_t option, Face face) {
    const LectureView& page = *asked(view);
    lettered_option(page, ui, option, ui.palette.accent, ui.palette.text, face);
    count_row(page, state, ui, option);
    ImGui::SameLine();
    share_bar(page, ui, option, ui.palette.accent, ui.px(ui.tall(button_height)));
    gap(ui, gap_of_options(face));
}

bool is_right(const LectureQuestion& asked, std::size_t option) { return static_cast<int>(option) == asked.answer; }

// Empty if no hands were counted.
std::string count_of(const LectureView& page, std::size_t option) {
    const auto& hands = page.hands[static_cast<std::size_t>(page.page)];
    const bool counted = std::any_of(hands.begin(), hands.end(), [](int each) { return each > 0; });
    return counted ? std::to_string(hands[option]) : std::string();
}

// Behind the last words of the right option, which begin at `at`; where that line is full, below its letter.
void sign_of_right(const LectureView& page, Ui& ui, std::size_t option, ImVec2 at, Face face) {
    const float indent = indent_of_options(page, ui), line = line_height(ui, face), width = card_width(ui);
    const auto lines = even_lines(ui, translated(ui, page.current().question.options[option]), face, width - indent);
    const std::string_view sign = has_icons(ui) ? icon::check : "✓";
    const float wide = text_width(ui, Face::title, sign);
    const float behind = indent + text_width(ui, face, lines.back()) + ui.px(spacing::small);
    const bool has_room = behind + wide <= width;
    const std::size_t row = has_room ? lines.size() - 1 : std::max<std::size_t>(1, lines.size() - 1);
    const float x = at.x + (has_room ? behind : 0), y = at.y + line * static_cast<float>(row);
    put(ui, {x, y + (line - line_height(ui, Face::title)) / 2}, sign, ui.palette.success, Face::title);
    mark(ui, "lecture.tick", {x, y, wide, line});
}

// Once the answer is known: words and bar are where they were while hands were counted.
void answered_in_place(const LectureView& page, Ui& ui, std::size_t option, Face face) {
    const bool right = is_right(page.current().question, option);
    const Colour colour = right ? ui.palette.success : ui.palette.text;
    const ImVec2 words = ImGui::GetCursorScreenPos();
    lettered_option(page, ui, option, right ? colour : ui.palette.accent, colour, face);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (right) mark(ui, "lecture.right", {words.x, words.y, card_width(ui), at.y - words.y});
    if (right) sign_of_right(page, ui, option, words, face);
    const float row = ui.px(ui.tall(button_height)), width = ui.px(hands_field + 2 * hands_button + 2 * spacing::small);
    const float line = line_height(ui, Face::title);
    const Rect count{at.x, at.y + (row - line) / 2, width, line};
    put_right(ui, {count.x + width - ui.px(spacing::small), count.y}, count_of(page, option), colour, Face::title);
    mark(ui, option_id("lecture.count.", option), count);
    ImGui::SetCursorScreenPos({at.x + width + ui.px(spacing::small), at.y});
    share_bar(page, ui, option, colour, row);
    gap(ui, gap_of_options(face));
}

// The type of the options of an answer in a lower window. The right one is larger than the others, unless even the
// smallest reason then has no room: in such a tight answer each bar is directly below its option.
struct AnswerType {
    Face of_right;
    bool is_tight() const { return of_right == of_wrong; }
    Face of_option(bool right) const { return right ? of_right : of_wrong; }
    static constexpr Face of_wrong = Face::strong;
};

// Each option keeps its letter.
std::string words_of_answer(const Ui& ui, const LectureQuestion& asked, std::size_t option) {
    return letter_of(option) + (is_right(asked, option) ? "  ✓ " : "  ") +
           std::string(translated(ui, asked.options[option]));
}

// The room of a question's card: the height of its content, the size of the options before the answer, and the indent
// of their words.
struct AnswerRoom {
    float height;
    Face of_options;
    float indent;
};

// True if the reason fits below the options in their places.
bool fits_in_place(const Ui& ui, const LectureQuestion& asked, const AnswerRoom& room, Face of_reason) {
    const float used = height_of_options(ui, asked, room.of_options, card_width(ui), room.indent) +
                       height_of_text(ui, asked, room.of_options);
    return used + height_of(ui, translated(ui, asked.why), of_reason, card_width(ui)) <= room.height;
}

// True if it fits below options with their counts beside them, of which the right one is large.
bool fits_below_short_options(const Ui& ui, const LectureQuestion& asked, const AnswerRoom& room, Face of_reason) {
    constexpr float reserve = spacing::small;  // of card_around; the right option is smaller only if this does not do
    float used = ui.px(spacing::tight) + height_of_text(ui, asked, room.of_options);
    for (std::size_t i = 0; i < asked.options.size(); ++i)
        used += ui.px(bar_thickness + between_answers + spacing::tight) +
                height_of(ui, words_of_answer(ui, asked, i), is_right(asked, i) ? Face::title : AnswerType::of_wrong,
                          card_width(ui) - ui.px(count_width));
    used += height_of(ui, translated(ui, asked.why), of_reason, card_width(ui));
    return used <= (of_reason == Face::small ? room.height + ui.px(reserve) : room.height);
}

// The reasons of a lecture have one size: the largest in which each of them fits, with the options in their places
// wherever these can be.
Face face_of_reasons(const Lecture& lecture, const Ui& ui, const AnswerRoom& room) {
    for (const Face face : {Face::title, Face::text})
        if (std::all_of(lecture.pages.begin(), lecture.pages.end(), [&](const LecturePage& page) {
                return page.question.options.empty() || fits_in_place(ui, page.question, room, face) ||
                       (!fits_in_place(ui, page.question, room, Face::text) &&
                        fits_below_short_options(ui, page.question, room, face));
            }))
            return face;
    return Face::small;
}

// In a lower window the count is beside the option, and wrong options are smaller: the reason finds room.
void answered_option(const LectureView& page, Ui& ui, std::size_t option, AnswerType type) {
    const LectureQuestion& asked = page.current().question;
    const bool right = is_right(asked, option);
    const Colour colour = right ? ui.palette.success : ui.palette.text;
    const Face face = type.of_option(right);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = line_height(ui, face), width = card_width(ui) - ui.px(count_width);
    put_right(ui, {at.x + card_width(ui), at.y + (line - line_height(ui, Face::title)) / 2}, count_of(page, option),
              colour, Face::title);
    mark(ui, option_id("lecture.count.", option), {at.x + width, at.y, ui.px(count_width), line});
    if (right) mark(ui, "lecture.right", {at.x, at.y, width, line});
    even_paragraph(ui, words_of_answer(ui, asked, option), colour, face, width);
    if (type.is_tight()) ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ui.px(spacing::tight));
    share_bar(page, ui, option, colour, ui.px(bar_thickness));
    gap(ui, between_answers);
}

// The reason is below all options, as it is read after them.
void answered(const LectureView& page, Ui& ui, Face of_options, float height) {
    const LectureQuestion& asked = page.current().question;
    const AnswerRoom room{height, of_options, indent_of_options(page, ui)};
    const Face of_reason = face_of_reasons(*page.lecture, ui, room);
    const bool is_in_place = fits_in_place(ui, asked, room, of_reason);
    const bool is_tight = !is_in_place && !fits_below_short_options(ui, asked, room, of_reason);
    for (std::size_t i = 0; i < asked.options.size(); ++i)
        is_in_place ? answered_in_place(page, ui, i, of_options)
                    : answered_option(page, ui, i, {is_tight ? AnswerType::of_wrong : Face::title});
    if (!asked.why.empty()) even_paragraph(ui, translated(ui, asked.why), ui.palette.text, of_reason);
}

// Minutes and seconds: "12:05".
std::string clock_text(double seconds) {
    const auto whole = static_cast<int>(std::max(0.0, seconds));
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

float minutes_until(const LectureView& page) {
    float sum = 0;
    for (int i = 0; i <= page.page; ++i) sum += page.lecture->pages[static_cast<std::size_t>(i)].minutes;
    return sum;
}

}  // namespace

std::string time_words(const LectureView& page, const Strings& strings) {
    return fill(strings("lecture.time"),
                {clock_text(page.seconds), clock_text(60.0 * static_cast<double>(minutes_until(page))),
                 clock_text(60.0 * static_cast<double>(page.lecture->minutes))});
}

void lecture_caption(const LabView& view, Ui& ui, Rect r) {
    begin_bar(ui, "lecture caption", r);
    const float width = r.w - 2 * ui.px(caption_side);
    const Face face = face_of_captions(*view.pages->lecture, ui, width);
    const auto lines = even_lines(ui, translated(ui, view.pages->current().caption), face, width);
    float y = r.y + (r.h - static_cast<float>(lines.size()) * line_height(ui, face)) / 2;
    for (const std::string& line : lines) {
        put(ui, {r.x + ui.px(caption_side), y}, line, ui.palette.text, face);
        y += line_height(ui, face);
    }
    mark(ui, "lecture.caption", r);
    end_bar();
}

// Of a question that is asked without a page: one option less or one more.
void tally_buttons(const LectureView& tally, Ui& ui) {
    const std::size_t options = tally.current().question.options.size();
    for (const bool is_more : {false, true}) {
        const std::size_t wanted = is_more ? options + 1 : options - 1;
        const std::string words = (is_more ? "+ " : "− ") + letter_of(is_more ? options : options - 1);
        ButtonLook look{{}, words, Emphasis::quiet};
        look.enabled = wanted >= least_tally_options && wanted <= most_tally_options;
        if (is_more) ImGui::SameLine();
        if (push_button(ui, is_more ? "tally.more" : "tally.fewer", look,
                        ui.strings(is_more ? "lecture.more_options" : "lecture.fewer_options")))
            ui.outbox.push_back(TallyRequest{wanted});
    }
}

void lecture_question(const LabView& view, PanelState& state, Ui& ui, Rect r) {
    const LectureView& page = *braitenlab::asked(view);
    const LectureQuestion& asked = page.current().question;
    if (state.lecture.hands.size() != asked.options.size()) state.lecture.hands.assign(asked.options.size(), {});
    CardState& card = state.lecture.question;
    const bool is_first = !card.folded && card.content == 0;  // open, it has the whole height until it is measured
    Rect place = r;
    if (!is_first) place.h = std::min(r.h, wanted_height(ui, card));
    if (begin_card(ui, card, "lecture.question", ui.strings("lecture.question"), place)) {
        const float below = view.pages ? 0 : button_height + spacing::tight;  // the buttons of a tally
        const float height = r.h - ui.px(card_around + below);
        // Beside notes there is less room.
        const Face face = page.notes ? Face::strong : face_of_options(*page.lecture, ui, card_width(ui), height);
        if (!asked.text.empty()) {
            even_paragraph(ui, translated(ui, asked.text), ui.palette.text, face_of_text(face));
            gap(ui, gap_of_text(face));
        }
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), ui.px(spacing::tight)});
        if (!page.shows(PagePart::answer))
            for (std::size_t i = 0; i < asked.options.size(); ++i) option_to_count(view, state, ui, i, face);
        else
            answered(page, ui, face, height);
        if (!view.pages) tally_buttons(page, ui);
        ImGui::PopStyleVar();
    }
    end_card(ui, card);
    state.is_unsettled |= is_first || (!card.folded && card.is_cut);
    state.lecture.question_height = wanted_height(ui, card);
}

void lecture_notes(const LabView& view, PanelState& state, Ui& ui, Rect r) {
    const LectureView& page = *view.pages;
    CardState& card = state.lecture.notes;
    if (begin_card(ui, card, "lecture.notes", time_words(page, ui.strings), r)) {
        if (std::exchange(state.lecture.notes_page, page.page) != page.page) ImGui::SetScrollY(0);
        paragraph(ui, translated(ui, page.current().notes), ui.palette.text, Face::small);
    }
    end_card(ui, card);
    state.lecture.notes_height = wanted_height(ui, card);
}

}  // namespace braitenlab::ui
