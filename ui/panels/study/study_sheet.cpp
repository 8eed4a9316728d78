// The sheet of a study: a row for each combination of values, with a dot for each run, the box from quartile to
// quartile and the median, and beside them how often the runs of the same seed differ from those of the first row.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "core/insight/study_table.h"
#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/panels/study/study_draft.h"
#include "ui/panels/value_choice.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"
#include "ui/words/measure_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using insight::Study;
using insight::StudyMeasureTraits;
using insight::StudyRow;
using insight::StudySummary;

// Layout pixels.
constexpr float least_row = 20, most_row = 44, column_gap = spacing::medium, dot_of_run = 2.2f;

std::string measure_words(const Ui& ui, const StudyMeasureTraits& measure) {
    std::string words(ui.strings("study.measure." + std::string(measure.word)));
    return measure.unit.empty() ? words : words + " (" + std::string(measure.unit) + ")";
}

// "eyes 80°, speed 3 m/s", with the names in the language of the strings.
std::string row_words(const Ui& ui, const Study& study, std::size_t combination) {
    const std::vector<std::size_t> levels = levels_of(study, combination);
    std::string words;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        words += (i > 0 ? ", " : "") + std::string(translated(ui, study.values[i].name)) + " " +
                 level_words(ui.strings, study.values[i], levels[i]);
    }
    return words;
}

class StudyPlot {
public:
    StudyPlot(const StudyView& view, std::size_t measure, Ui& ui)
        : ui_(ui), study_(view.base->study()), rows_(*view.rows), measure_(measure) {
        for (std::size_t i = 0; i < study_.combinations(); ++i)
            summaries_.push_back(summary_of(study_, rows_, i, measure_));
        find_range();
    }

    void draw(float width, float height) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float line = line_height(ui_, Face::small) + ui_.px(4);
        const auto count = static_cast<float>(summaries_.size());
        const float row = std::clamp((height - 2 * line) / count, ui_.px(least_row), ui_.px(most_row));
        const Rect all{at.x, at.y, width, 2 * line + row * count};
        mark(ui_, "study.plot", all);
        columns(all);
        headings(all.y);
        const Axis unused{0, 1, "", 0, false};
        const Rect outer{plot_.x, all.y + line, plot_.w, row * count + line};
        const Rect inner = plot_ground(ui_, outer, axis_, unused);
        plot_.x = inner.x, plot_.w = inner.w;
        if (has_never_)
            put_centred(ui_, {inner.x + inner.w, inner.y + inner.h + ui_.px(3)}, ui_.strings("map.never"),
                        ui_.palette.second_text, Face::label);
        for (std::size_t i = 0; i < summaries_.size(); ++i)
            draw_row(i, {inner.x, inner.y + inner.h / count * static_cast<float>(i), inner.w, inner.h / count});
        ImGui::Dummy({width, all.h});
    }

private:
    double number(std::size_t combination, std::size_t seed) const {
        const std::size_t run = combination * static_cast<std::size_t>(study_.seeds) + seed;
        return run < rows_.size() ? rows_[run][measure_] : NAN;
    }

    void find_range() {
        double low = INFINITY, high = -INFINITY;
        for (const StudyRow& row : rows_)
            if (std::isfinite(row[measure_]))
                low = std::min(low, row[measure_]), high = std::max(high, row[measure_]);
            else if (std::isinf(row[measure_]))
                has_never_ = true;
        if (!(low <= high)) low = 0, high = 1;
        low = std::min(low, 0.0);  // lengths of boxes compare only from 0
        if (high <= low) high = low + 1;
        const double span = high - low;
        axis_ = {low, high + 0.04 * span, "", span < 5 ? 1 : 0};
        if (has_never_) axis_.high = high + 0.12 * span;
        decimals_ = row_of(study_.measures[measure_]).unit.empty() ? 0 : span < 10 ? 2 : 1;
    }

    std::string text(double number) const {
        if (!std::isfinite(number)) return std::string(ui_.strings("map.never"));
        const bool is_whole = decimals_ == 0 && number == std::floor(number);
        return fixed(ui_, number, is_whole ? 0 : std::max(1, decimals_));
    }

    std::string against_words(const StudySummary& summary) const {
        const std::size_t equal = summary.pairs - summary.more - summary.less;
        return fill(ui_.strings("study.compared"),
                    {std::to_string(summary.more), std::to_string(equal), std::to_string(summary.less)});
    }

    // Words on the left, the median and the comparison on the right, the plot between them.
    void columns(Rect all) {
        const float space = ui_.px(column_gap);
        float words = 0, against = text_width(ui_, Face::small, ui_.strings("study.against"));
        float median = text_width(ui_, Face::small, ui_.strings("study.median"));
        for (std::size_t i = 0; i < summaries_.size(); ++i) {
            words = std::max(words, text_width(ui_, Face::small, row_words(ui_, study_, i)));
            median = std::max(median, text_width(ui_, Face::strong, text(summaries_[i].spread.median)));
            against = std::max(against, text_width(ui_, Face::small, against_words(summaries_[i])));
        }
        words_ = {all.x, all.y, std::min(words, 0.34f * all.w), all.h};
        against_right_ = all.x + all.w;
        median_right_ = against_right_ - against - space;
        plot_ = {words_.x + words_.w + space, all.y, median_right_ - median - 2 * space - words_.x - words_.w, all.h};
    }

    void headings(float y) const {
        const Colour quiet = ui_.palette.second_text;
        put(ui_, {plot_.x, y},
            shortened(ui_, measure_words(ui_, row_of(study_.measures[measure_])), Face::small, plot_.w), quiet,
            Face::small);
        put_right(ui_, {median_right_, y}, ui_.strings("study.median"), quiet, Face::small);
        if (summaries_.size() > 1)
            put_right(ui_, {against_right_, y}, ui_.strings("study.against"), quiet, Face::small);
    }

    float x_of(double number, Rect row) const {
        const double shown = std::isfinite(number) ? number : axis_.high;
        const double share = (shown - axis_.low) / (axis_.high - axis_.low);
        return row.x + static_cast<float>(std::clamp(share, 0.0, 1.0)) * row.w;
    }

    void draw_row(std::size_t i, Rect row) const {
        const StudySummary& summary = summaries_[i];
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const float small = line_height(ui_, Face::small), middle = row.y + row.h / 2;
        const std::size_t group = summaries_.size() / study_.values.front().levels.size();
        if (i > 0 && i % group == 0)
            draw.AddLine({words_.x, row.y}, {against_right_, row.y}, paint(ui_.palette.line), ui_.px(1));
        put(ui_, {words_.x, middle - small / 2}, shortened(ui_, row_words(ui_, study_, i), Face::small, words_.w),
            ui_.palette.text, Face::small);
        if (summary.spread.count == 0) return;
        box(draw, summary.spread, row);
        for (std::size_t seed = 0; seed < static_cast<std::size_t>(study_.seeds); ++seed)
            dot(draw, number(i, seed), seed, row);
        put_right(ui_, {median_right_, middle - line_height(ui_, Face::strong) / 2}, text(summary.spread.median),
                  ui_.palette.text, Face::strong);
        if (i > 0 && summary.pairs > 0)
            put_right(ui_, {against_right_, middle - small / 2}, against_words(summary), ui_.palette.second_text,
                      Face::small);
    }

    void box(ImDrawList& draw, const maths::Spread& spread, Rect row) const {
        const float half = 0.32f * row.h, middle = row.y + row.h / 2;
        const float left = x_of(spread.lower, row), right = x_of(spread.upper, row), at = x_of(spread.median, row);
        const Colour tone = ui_.palette.accent;
        draw.AddRectFilled({left, middle - half}, {right, middle + half}, paint(tone.with_alpha(0.28f)),
                           ui_.px(radius::bar));
        draw.AddRect({left, middle - half}, {right, middle + half}, paint(tone.with_alpha(0.8f)), ui_.px(radius::bar),
                     0, ui_.px(1));
        draw.AddLine({at, middle - half - ui_.px(2)}, {at, middle + half + ui_.px(2)}, paint(tone), ui_.px(3));
    }

    // Runs of one seed have the same height in their rows.
    void dot(ImDrawList& draw, double number, std::size_t seed, Rect row) const {
        if (std::isnan(number)) return;
        constexpr float golden = 0.61803399f;
        const float share = std::fmod(static_cast<float>(seed + 1) * golden, 1.0f) - 0.5f;
        draw.AddCircleFilled({x_of(number, row), row.y + row.h / 2 + 0.5f * share * row.h}, ui_.px(dot_of_run),
                             paint(ui_.palette.text.with_alpha(0.62f)), 10);
    }

    Ui& ui_;
    const Study& study_;
    const std::vector<StudyRow>& rows_;
    std::size_t measure_;
    std::vector<StudySummary> summaries_;
    Axis axis_;
    bool has_never_ = false;
    int decimals_ = 0;
    Rect words_, plot_;
    float median_right_ = 0, against_right_ = 0;
};

// The shipped studies, and the one from a file of the user.
void study_choice(const LabView& lab, StudyDraft& draft, Ui& ui, float right) {
    const StudyView& view = lab.features.study;
    const auto choice = [&](const Study& study, bool first) {
        const bool is_open = view.base && view.base->study().id == study.id, on = is_open && !draft.open;
        const std::string title(translated(ui, study.title));
        if (choice_in_row(ui, "study.open." + study.id, title, on, first, right) && !on) {
            draft.open = false;
            if (!is_open) ui.outbox.emplace_back(StudyRequest{StudyEdit::open, study.id});
        }
        return is_open;
    };
    bool is_shipped = false;
    for (const Study& study : *view.shipped) is_shipped |= choice(study, &study == &view.shipped->front());
    if (view.base && !is_shipped) choice(view.base->study(), false);
    const std::string_view why = why_no_draft(lab);
    const SmallButton which{"study.new", {}, ui.strings("study.new"), draft.open};
    beside_or_below(ui, small_button_width(ui, which, true), right);
    if (small_push_button(ui, which, ui.strings(why.empty() ? "study.new_how" : why)) && why.empty())
        draft.open = !draft.open;
    if (!why.empty()) draft.open = false;
}

void measure_choice(const Study& study, PanelState& state, Ui& ui, float right) {
    if (study.measures.size() < 2) return;
    for (std::size_t i = 0; i < study.measures.size(); ++i) {
        const StudyMeasureTraits& row = row_of(study.measures[i]);
        const bool is_shown = i == state.sheets.study.measure;
        if (choice_in_row(ui, "study.measure." + std::string(row.word), measure_words(ui, row), is_shown, i == 0,
                          right))
            state.sheets.study.measure = i;
    }
}

// "83 of 240 runs of 60 s", with a bar while they are computed.
void progress(const StudyView& view, Ui& ui) {
    const Study& study = view.base->study();
    const std::size_t done = view.rows->size();
    const std::string seconds = fixed(ui, study.seconds, 0);
    paragraph(ui,
              fill(ui.strings("study.progress"),
                   {std::to_string(done), std::to_string(study.runs()), seconds, std::to_string(study.seeds)}),
              ui.palette.second_text, Face::small);
    progress_bar(ui, static_cast<float>(done) / static_cast<float>(study.runs()), spacing::tight);
}

void save_table(const StudyView& view, Ui& ui) {
    const Study& study = view.base->study();
    ExportRequest table{study.id, insight::study_header(study)};
    for (std::size_t run = 0; run < view.rows->size(); ++run)
        table.text += insight::study_line(*view.base, run, (*view.rows)[run]);
    ui.outbox.emplace_back(std::move(table));
}

// True if the sheet closes.
bool draft_buttons(StudyDraft& draft, std::optional<Study> study, Ui& ui) {
    ButtonLook look{icon::play, ui.strings("study.run"), Emphasis::primary};
    look.enabled = study.has_value();
    if (button(ui, "study.build", look).pressed && study) {
        ui.outbox.emplace_back(StudyRequest{StudyEdit::build, {}, std::make_shared<const Study>(std::move(*study))});
        ui.outbox.emplace_back(StudyRequest{StudyEdit::run, {}});
        draft.open = false;
    }
    ImGui::SameLine();
    return close_button(ui, "study.close", Emphasis::plain);
}

// True if the sheet closes.
bool study_buttons(const StudyView& view, Ui& ui) {
    const std::size_t done = view.base ? view.rows->size() : 0;
    ButtonLook first{icon::pause, ui.strings("study.stop"), Emphasis::primary};
    first.min_width = least_width_for(ui, first, {"study.run", "study.go_on", "study.stop", "study.complete"});
    if (view.base && view.runs) {
        const Item stop = button(ui, "study.stop", first);
        tooltip(ui, stop, ui.strings("study.stop_how"));
        if (stop.pressed) ui.outbox.emplace_back(StudyRequest{StudyEdit::stop, {}});
        ImGui::SameLine();
    } else if (view.base && done < view.base->study().runs()) {
        first.icon = icon::play, first.words = ui.strings(done > 0 ? "study.go_on" : "study.run");
        const Item run = button(ui, "study.run", first);
        if (run.pressed) ui.outbox.emplace_back(StudyRequest{StudyEdit::run, {}});
        ImGui::SameLine();
    } else if (view.base) {  // keeps the place, so that a click on Stop as the last run ends is no click on Save
        first.icon = icon::check, first.words = ui.strings("study.complete"), first.enabled = false;
        button(ui, "study.complete", first);
        ImGui::SameLine();
    }
    const bool is_own = view.is_built || view.has_file;  // else a shipped one: its table goes to a new file
    ButtonLook look{icon::save, ui.strings(view.is_built ? "study.save_study" : "study.save")};
    look.enabled = is_own ? view.table.empty() : done > 0;
    const Item save = button(ui, "study.save", look);
    tooltip(ui, save, ui.strings(view.is_built ? "study.save_study_how" : "study.save_how"));
    if (save.pressed && is_own) ui.outbox.emplace_back(StudyRequest{StudyEdit::save, {}});
    if (save.pressed && !is_own) save_table(view, ui);
    ImGui::SameLine();
    ButtonLook figure{icon::save, ui.strings("study.figure")};
    figure.enabled = view.base && done == view.base->study().runs();
    if (push_button(ui, "study.figure", figure, ui.strings("study.figure_how")))
        ui.outbox.emplace_back(StudyRequest{StudyEdit::figure, {}});
    ImGui::SameLine();
    return close_button(ui, "study.close", Emphasis::plain);
}

}  // namespace

void follow_study(const LabView& lab, PanelState& state, Ui&) {
    if (std::exchange(state.sheets.study.shown, lab.features.study.shown) != lab.features.study.shown)
        state.sheet = Sheet::study;
}

void study_sheet(const LabView& lab, PanelState& state, Ui& ui, Rect window) {
    const StudyView& view = lab.features.study;
    if (!view.base && !view.error && view.shipped && !view.shipped->empty())
        ui.outbox.emplace_back(StudyRequest{StudyEdit::open, view.last.empty() ? view.shipped->front().id : view.last});
    SheetState& sheet = open_sheet(state, ui, Sheet::study, window);
    const float top = ImGui::GetCursorScreenPos().y, right = ImGui::GetCursorScreenPos().x + card_width(ui);
    if (view.shipped) study_choice(lab, state.sheets.study.draft, ui, right);
    gap(ui, 8);
    std::optional<Study> drafted;
    const bool drafts = state.sheets.study.draft.open;
    if (drafts) drafted = study_builder(lab, state.sheets.study.draft, state.sliders, ui, card_width(ui));
    if (view.error && !drafts) paragraph(ui, text_of(*view.error, ui.strings), ui.palette.warning);
    if (view.base && !drafts) {
        const Study& study = view.base->study();
        if (state.sheets.study.measure >= study.measures.size()) state.sheets.study.measure = 0;
        if (!study.story.empty()) paragraph(ui, translated(ui, study.story), ui.palette.text);
        progress(view, ui);
        if (!view.table.empty())
            paragraph(ui, fill(ui.strings("study.table"), {view.table}), ui.palette.second_text, Face::small);
        measure_choice(study, state, ui, right);
        gap(ui, 8);
        const float used = ImGui::GetCursorScreenPos().y - top;
        StudyPlot(view, state.sheets.study.measure, ui).draw(card_width(ui), window.h - used - ui.px(220));
        if (study.combinations() > 1) paragraph(ui, ui.strings("study.how"), ui.palette.second_text, Face::small);
    }
    sheet_buttons(ui, sheet);
    const bool closed =
        drafts ? draft_buttons(state.sheets.study.draft, std::move(drafted), ui) : study_buttons(view, ui);
    if (end_sheet(sheet) || closed) state.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
