#include "ui/panels/course/glossary.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/panel_state.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/whole_lines.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr double still_seconds = 1.2;  // the moment that a picture shows where motion is reduced

std::string term_key(const GlossaryTerm& term, std::string_view what) {
    return "glossary." + std::string(term.id) + "." + std::string(what);
}

// Letters of other alphabets are bytes from 0x80 on.
bool is_letter(char c) { return static_cast<unsigned char>(c) >= 0x80 || std::isalnum(static_cast<unsigned char>(c)); }

bool same_letters(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
        return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
    });
}

// The first place of the form in the text as a whole word; npos if there is none.
std::size_t find_word(std::string_view text, std::string_view form) {
    for (std::size_t at = 0; at + form.size() <= text.size(); ++at) {
        if (at > 0 && is_letter(text[at - 1])) continue;
        const std::size_t end = at + form.size();
        if (end < text.size() && is_letter(text[end])) continue;
        if (same_letters(text.substr(at, form.size()), form)) return at;
    }
    return text.npos;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

// The first mention of one term; `begin` is npos if there is none.
Mention first_mention(const GlossaryTerm& term, std::string_view forms, std::string_view text) {
    Mention first{&term, text.npos, 0};
    while (!forms.empty()) {
        const std::size_t comma = std::min(forms.find(','), forms.size());
        const std::string_view form = trimmed(forms.substr(0, comma));
        forms.remove_prefix(std::min(comma + 1, forms.size()));
        const std::size_t at = form.empty() ? text.npos : find_word(text, form);
        if (at < first.begin || (at == first.begin && at != text.npos && at + form.size() > first.end))
            first = {&term, at, at + form.size()};
    }
    return first;
}

// Lines of a paragraph as byte ranges, broken at spaces, each at most `width` window pixels wide if it has a space.
std::vector<std::pair<std::size_t, std::size_t>> lines_of_paragraph(const Ui& ui, std::string_view text, float width) {
    std::vector<std::pair<std::size_t, std::size_t>> lines;
    std::size_t line = 0, last_space = text.npos;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        const bool ends = i == text.size() || text[i] == '\n';
        if (!ends && text[i] != ' ') continue;
        if (text_width(ui, Face::text, text.substr(line, i - line)) > width && last_space != text.npos) {
            lines.emplace_back(line, last_space);
            line = last_space + 1;
        }
        last_space = i;
        if (!ends) continue;
        lines.emplace_back(line, i);
        line = i + 1, last_space = text.npos;
    }
    return lines;
}

void underline_with_dots(const Ui& ui, Rect word, Colour colour) {
    const float y = word.y + word.h - ui.px(1), step = ui.px(4);
    for (float x = word.x + step / 2; x < word.x + word.w; x += step)
        ImGui::GetWindowDrawList()->AddCircleFilled({x, y}, ui.px(1), paint(colour), 6);
}

// The word as a widget over its text.
void mention_item(Ui& ui, GlossaryState& state, const Mention& mention, Rect word) {
    const std::string id = "term." + std::string(mention.term->id);
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    const float height = std::max(word.h, ui.px(24)), width = std::max(word.w, ui.px(24));  // of a target
    ImGui::SetCursorScreenPos({word.x - (width - word.w) / 2, word.y - (height - word.h) / 2});
    const Item at = item(ui, id, {width, height});
    if (at.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    underline_with_dots(ui, word, mix(ui.palette.second_text, ui.palette.accent, at.focused ? 1.0f : at.warmth));
    tooltip(ui, at, ui.strings("glossary.open_how"));
    ImGui::SetCursorScreenPos(cursor);
    if (!at.pressed) return;
    const bool same = state.open == mention.term->id;
    state.open = same ? std::string() : std::string(mention.term->id);
    state.word = word;
    state.just_opened = !same;
}

}  // namespace

std::vector<Mention> mentions_in(const Strings& strings, std::string_view text, const std::vector<std::string>& but) {
    std::vector<Mention> all;
    for (const GlossaryTerm& term : terms()) {
        if (std::find(but.begin(), but.end(), term.id) != but.end()) continue;
        const Mention first = first_mention(term, strings(term_key(term, "forms")), text);
        if (first.begin != text.npos) all.push_back(first);
    }
    std::sort(all.begin(), all.end(),
              [](const Mention& a, const Mention& b) { return std::pair(a.begin, b.end) < std::pair(b.begin, a.end); });
    std::vector<Mention> apart;  // the longest of those that overlap
    for (const Mention& each : all)
        if (apart.empty() || each.begin >= apart.back().end) apart.push_back(each);
    return apart;
}

void draw_entry(const LabView& view, Ui& ui, const GlossaryTerm& term, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect frame{at.x, at.y, width, std::min(ui.px(150), width * 0.6f)};
    fill_box(ui, frame, ui.palette.raised, Corner::box);
    ImGui::PushClipRect({frame.x, frame.y}, {frame.x + frame.w, frame.y + frame.h}, true);
    const float inset = ui.px(spacing::small);
    term.draw(ui, {frame.x + inset, frame.y + inset, frame.w - 2 * inset, frame.h - 2 * inset},
              view.program.reduce_motion ? still_seconds : view.wall_seconds);
    ImGui::PopClipRect();
    mark(ui, "glossary.picture", frame);
    ImGui::Dummy({frame.w, frame.h});
    paragraph(ui, ui.strings(term_key(term, "text")), ui.palette.text, Face::text, width);
}

void paragraph_with_terms(Ui& ui, GlossaryState& state, std::string_view text, Colour colour) {
    const std::vector<Mention> mentions = mentions_in(ui.strings, text, state.mentioned);
    if (mentions.empty()) return paragraph(ui, text, colour);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float line_step = line_height(ui, Face::text), width = card_width(ui) - ImGui::GetCursorPosX();
    const WholeLines whole(start.y, line_step);
    const auto lines = lines_of_paragraph(ui, text, width);
    float y = start.y;
    for (const auto& [begin, end] : lines) {
        put(ui, {start.x, y}, text.substr(begin, end - begin), colour);
        y += line_step;
    }
    ImGui::Dummy({width, y - start.y});
    const ImVec2 after = ImGui::GetCursorScreenPos();
    for (const Mention& mention : mentions) {
        state.mentioned.emplace_back(mention.term->id);
        bool is_first = true;  // a mention of several words may go on in the next line
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const std::size_t begin = std::max(mention.begin, lines[i].first);
            const std::size_t end = std::min(mention.end, lines[i].second);
            if (begin >= end) continue;
            const float before = text_width(ui, Face::text, text.substr(lines[i].first, begin - lines[i].first));
            const Rect word{start.x + before, start.y + static_cast<float>(i) * line_step,
                            text_width(ui, Face::text, text.substr(begin, end - begin)), line_step};
            if (std::exchange(is_first, false))
                mention_item(ui, state, mention, word);
            else
                underline_with_dots(ui, word, ui.palette.second_text);
        }
    }
    ImGui::SetCursorScreenPos(after);
}

void term_card(const LabView& view, PanelState& panels, Ui& ui, Rect window) {
    GlossaryState& state = panels.glossary;
    const bool just_opened = std::exchange(state.just_opened, false);
    const bool still_there =
        std::find(state.mentioned.begin(), state.mentioned.end(), state.open) != state.mentioned.end();
    state.mentioned.clear();
    const GlossaryTerm* term = find_term(state.open);
    if (!term || panels.sheet != Sheet::none || !still_there) return state.open.clear();
    const float width = ui.px(260), pad = ui.px(spacing::medium), beside = ui.px(spacing::medium);
    const std::string sentence(ui.strings(term_key(*term, "text")));
    const float words = ImGui::CalcTextSize(sentence.c_str(), nullptr, false, width - 2 * pad).y;
    const float height =
        2 * pad + line_height(ui, Face::title) + std::min(ui.px(150), (width - 2 * pad) * 0.6f) + words + ui.px(22);
    const Rect* card = ui.anchors.find("card.exercise");  // beside it, so that its text stays visible
    const Rect from = card ? *card : state.word;
    const bool fits_right = from.x + from.w + beside + width < window.x + window.w;
    const float x = fits_right ? from.x + from.w + beside : std::max(window.x, from.x - beside - width);
    const float y = std::clamp(state.word.y, window.y, std::max(window.y, window.y + window.h - height));
    const Rect place{x, y, width, height};
    begin_bar(ui, "term", place, true);
    card_ground(ui, place);
    fill_box(ui, place, ui.palette.panel);
    line_box(ui, place, ui.palette.line);
    ImGui::SetCursorScreenPos({place.x + pad, place.y + pad});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::small), ui.px(spacing::small)});
    ImGui::BeginGroup();
    paragraph(ui, ui.strings(term_key(*term, "name")), ui.palette.text, Face::title, width - 2 * pad);
    draw_entry(view, ui, *term, width - 2 * pad);
    compat::end_group();
    ImGui::PopStyleVar();
    mark(ui, "card.term", place);
    end_bar();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool beside_it = !place.contains(mouse.x, mouse.y) && !state.word.contains(mouse.x, mouse.y);
    if (!just_opened && ImGui::IsMouseClicked(0) && beside_it) state.open.clear();
}

}  // namespace braitenlab::ui
