#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "core/utf8.h"
#include "ui/panels/study/study_draft.h"
#include "ui/panels/value_choice.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/number_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using insight::AxisValue;
using insight::Study;
using insight::StudyMeasure;

namespace {

// Layout pixels.
constexpr float name_width = 190, column_gap_of_draft = spacing::large, number_columns = 3;
constexpr int most_levels = 9, most_seeds = 100;
static_assert(most_levels * most_levels * most_seeds <= static_cast<int>(insight::limits::study_runs));

// A value can be varied by a file only where it has a path there.
std::vector<AxisValue> values_with_paths(const insight::ValueSubject& subject) {
    std::vector<AxisValue> values = axis_values(subject);
    std::erase_if(values, [](const AxisValue& value) { return value.paths.empty(); });
    return values;
}

// Some units are words that explain the number.
bool has_short_unit(const AxisValue& value) { return value.unit.size() <= 8; }

void choose_value(DraftValue& value, const AxisValue& chosen) {
    value.id = chosen.id, value.from = chosen.from, value.to = chosen.to;
}

// Another scene begins with the direction of its sensors, else the first value, and with measures that suit it.
void begin_draft(const LabView& view, StudyDraft& draft, const std::vector<AxisValue>& values) {
    const bool known = std::all_of(draft.values.begin(), draft.values.end(), [&](const DraftValue& value) {
        return value.id.empty() || find_value(values, value.id);
    });
    if (draft.run == view.run_id && known && !draft.values[0].id.empty()) return;
    draft = {.open = draft.open, .run = view.run_id, .values = {}, .measures = {}};
    const AxisValue* first = find_value(values, "sensor.angle");
    if (!first && !values.empty()) first = &values.front();
    if (first) choose_value(draft.values[0], *first);
    const bool has_prey = view.now->predators > 0 && view.now->prey > 0;
    draft.measures = has_prey ? std::vector{StudyMeasure::captures, StudyMeasure::prey}
                              : std::vector{StudyMeasure::closest, StudyMeasure::time_to_touch};
}

// A slider in a column of a row.
std::optional<float> draft_number(Ui& ui, SliderState& sliders, const std::string& id, SliderLook look, float value,
                                  float width, double seconds) {
    look.words_width = 50, look.number_width = 62;
    look.meaning = false, look.signed_number = look.low < 0;
    const auto edit = slider(ui, sliders, id, value, width, seconds, look);
    return edit ? std::optional(edit->value) : std::nullopt;
}

SliderLook whole_look(std::string_view words, float low, float high, float home) {
    return {.words = words,
            .tooltip = {},
            .low = low,
            .high = high,
            .home = home,
            .step = 1,
            .nudge = 1,
            .decimals = 0,
            .whole = true};
}

// The name of the value, which unfolds the list, and its levels.
void value_row(const LabView& view, StudyDraft& draft, SliderState& sliders, Ui& ui,
               const std::vector<AxisValue>& values, std::size_t which, float width) {
    DraftValue& value = draft.values[which];
    const AxisValue* of = find_value(values, value.id);
    const std::string begin = "study.value." + std::to_string(which + 1);
    const bool open = draft.unfolded == static_cast<int>(which);
    const std::string words = of ? axis_words(ui, *of) : std::string(ui.strings("study.no_value"));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (small_push_button(ui,
                          {begin, open ? icon::unfolded : icon::folded,
                           shortened(ui, words, Face::small, ui.px(name_width - 40)), open},
                          ui.strings("study.value_how"))) {
        draft.unfolded = open ? -1 : static_cast<int>(which);
        if (of) draft.group = group_of(of->owner);
    }
    const float space = ui.px(column_gap_of_draft);
    const float each = (width - ui.px(name_width) - number_columns * space) / number_columns;
    if (of) {
        const std::string unit = unit_after(of->unit);
        float x = at.x + ui.px(name_width);
        for (float* end : {&value.from, &value.to}) {
            const bool is_from = end == &value.from;
            SliderLook look = end_look(ui, *of, is_from, *end);
            if (has_short_unit(*of)) look.unit = unit;
            ImGui::SetCursorScreenPos({x, at.y - ui.px(2)});
            if (const auto edit =
                    draft_number(ui, sliders, begin + (is_from ? ".from" : ".to"), look, *end, each, view.wall_seconds))
                *end = *edit;
            x += each + space;
        }
        ImGui::SetCursorScreenPos({x, at.y - ui.px(2)});
        if (const auto edit =
                draft_number(ui, sliders, begin + ".levels", whole_look(ui.strings("study.levels"), 2, most_levels, 3),
                             static_cast<float>(value.levels), each, view.wall_seconds))
            value.levels = static_cast<int>(std::lround(*edit));
    }
    ImGui::SetCursorScreenPos({at.x, at.y + ui.px(ui.tall(slider_height) + 4)});
    if (!open) return;
    if (which > 0 && !value.id.empty() &&
        choice_in_row(ui, begin + ".none", std::string(ui.strings("study.no_value")), false, true, at.x + width))
        value.id.clear(), draft.unfolded = -1;
    const AxisValue* chosen = value_choice(ui, values, begin, value.id, draft.group, width);
    if (!chosen || chosen->id == draft.values[1 - which].id) return gap(ui, 6);
    choose_value(value, *chosen);
    draft.unfolded = -1;
}

// False for a measure that is 0 in every run of the scene.
bool can_differ(StudyMeasure measure, const Snapshot& now) {
    const Scene& scene = *now.scene;
    const bool has_roles = now.predators + now.prey > 0, has_edge = scene.arena.edge == Boundary::open;
    switch (measure) {
        case StudyMeasure::captures:
        case StudyMeasure::predators:
        case StudyMeasure::prey:
            return has_roles;
        case StudyMeasure::deaths:
        case StudyMeasure::births:
            return has_roles || has_edge || scene.ecology.drain > 0;
        case StudyMeasure::falls:
            return has_edge;
        default:
            return true;
    }
}

void measure_row(const Snapshot& now, StudyDraft& draft, Ui& ui, bool has_vehicle, float right) {
    bool is_first = true;
    std::vector<StudyMeasure>& chosen = draft.measures;
    for (const insight::StudyMeasureTraits& row : insight::study_measure_table) {
        if ((row.of_vehicle && !has_vehicle) || !can_differ(row.value, now)) {
            std::erase(chosen, row.value);
            continue;
        }
        const bool on = std::find(chosen.begin(), chosen.end(), row.value) != chosen.end();
        const std::string words(ui.strings("study.measure." + std::string(row.word)));
        if (choice_in_row(ui, "study.measured." + std::string(row.word), words, on, is_first, right)) {
            on ? (void)std::erase(chosen, row.value) : chosen.push_back(row.value);
            std::sort(chosen.begin(), chosen.end());
        }
        is_first = false;
    }
}

// A study measures the vehicle of a start by its name, else the first one.
bool can_be_measured(const LabView& view, const VehicleView& vehicle) {
    return vehicle.start >= 0 || vehicle.id == view.now->vehicles.front().id;
}

}  // namespace

std::vector<double> levels_of(const DraftValue& value) {
    const double span = std::fabs(static_cast<double>(value.to) - static_cast<double>(value.from));
    const double step = span > 0 ? std::pow(10, std::floor(std::log10(span)) - 3) : 1;
    std::vector<double> levels;
    for (int i = 0; i < value.levels; ++i) {
        const double share = static_cast<double>(i) / std::max(1, value.levels - 1);
        const double level =
            static_cast<double>(value.from) + (static_cast<double>(value.to) - static_cast<double>(value.from)) * share;
        const double steps = std::round(level / step);
        levels.push_back(step < 1 ? steps / std::round(1 / step) : steps * step);  // 0.3, not 0.30000000000000004
    }
    return levels;
}

std::optional<Study> study_of(const StudyDraft& draft, const Ui& ui, const LabView& view, const VehicleView& vehicle,
                              const std::vector<AxisValue>& values) {
    const Scene& scene = *view.now->scene;
    Study study;
    study.title = fill(ui.strings("study.of_scene"),
                       {scene.title.empty() ? view.documents.opened : std::string(translated(ui, scene.title))});
    study.title = utf8_cut(std::move(study.title), limits::title_length);
    study.seconds = draft.seconds, study.seeds = draft.seeds;
    if (vehicle.start >= 0) study.vehicle = scene.starts[static_cast<std::size_t>(vehicle.start)].name;
    for (const DraftValue& value : draft.values)
        if (const AxisValue* of = find_value(values, value.id); of && value.from != value.to)
            study.values.push_back(
                {axis_words(ui, *of), has_short_unit(*of) ? std::string(of->unit) : "", of->paths, levels_of(value)});
    for (const StudyMeasure measure : draft.measures) study.measure_words.emplace_back(row_of(measure).word);
    study.measures = draft.measures;
    if (study.values.empty() || study.measures.empty()) return std::nullopt;
    return study;
}

std::string_view why_no_draft(const LabView& view) { return why_no_map(view); }

std::optional<Study> study_builder(const LabView& view, StudyDraft& draft, SliderState& sliders, Ui& ui, float width) {
    const VehicleView& vehicle = *selected_vehicle(view);
    const insight::ValueSubject subject{*view.now, vehicle, target_of(view, vehicle), shown_pair(view, vehicle)};
    const std::vector<AxisValue> values = values_with_paths(subject);
    begin_draft(view, draft, values);
    subheading(ui, ui.strings("study.vary"));
    for (std::size_t i = 0; i < draft.values.size(); ++i) value_row(view, draft, sliders, ui, values, i, width);
    gap(ui, 6);
    subheading(ui, ui.strings("study.measured"));
    measure_row(*view.now, draft, ui, can_be_measured(view, vehicle), ImGui::GetCursorScreenPos().x + width);
    gap(ui, 6);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float each = width / 2 - ui.px(column_gap_of_draft);
    SliderLook starts = whole_look(ui.strings("study.starts"), 2, most_seeds, 20);
    SliderLook seconds = whole_look(ui.strings("study.seconds"), 5, 120, 20);
    seconds.unit = " s";
    if (const auto edit =
            draft_number(ui, sliders, "study.seeds", starts, static_cast<float>(draft.seeds), each, view.wall_seconds))
        draft.seeds = static_cast<int>(std::lround(*edit));
    ImGui::SetCursorScreenPos({at.x + each + 2 * ui.px(column_gap_of_draft), at.y});
    if (const auto edit = draft_number(ui, sliders, "study.seconds", seconds, draft.seconds, each, view.wall_seconds))
        draft.seconds = *edit;
    ImGui::SetCursorScreenPos({at.x, at.y + ui.px(ui.tall(slider_height) + 8)});
    auto study = study_of(draft, ui, view, vehicle, values);
    if (study)
        paragraph(ui,
                  fill(ui.strings("study.draft_runs"), {std::to_string(study->runs()), fixed(ui, draft.seconds, 0)}),
                  ui.palette.second_text, Face::small);
    else
        paragraph(ui, ui.strings("study.draft_lacks"), ui.palette.warning, Face::small);
    return study;
}

}  // namespace braitenlab::ui
