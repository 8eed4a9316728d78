// The card of the map of behaviour: a cell for each pair of values, the dot of the present ones, and a legend.
#include <algorithm>
#include <utility>

#include <imgui.h>

#include "ui/panels/cards.h"
#include "ui/panels/map/map_parts.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float least_field = 112, least_field_in_lecture = 128;  // layout pixels

// `room`: height of the card at most, window pixels. The field is smaller where the card would not fit.
void draw_map(const MapFrame& frame, float room) {
    const Ui& ui = frame.ui;
    const bool in_lecture = frame.view.lecture;
    const float width = card_width(ui), ends = map_ends_width(frame);
    constexpr float heading_and_gaps = 108;  // layout pixels
    const float rows = 2 * (ui.tall(small_button_height) + 4);
    const bool has_kinds = frame.map.measure == insight::MapMeasure::behaviour;
    const float legend = map_legend_width(frame);
    // In a lecture, where type is large and the height is little, as far as the words leave room for the field.
    const bool is_beside =
        in_lecture && has_kinds && legend <= width - ends - ui.px(beside_field + least_field_in_lecture);
    const auto lines = static_cast<float>(is_beside ? 0 : map_legend_rows(frame));
    const float words_and_legend = map_words_height(frame, width) + lines * (line_height(ui, Face::small) + ui.px(4));
    const float left = room - ui.px(heading_and_gaps + rows) - words_and_legend - frame.state.added_height;
    const float most = width - ends - (is_beside ? legend + ui.px(beside_field) : 0);
    const float side = std::clamp(left, std::min(ui.px(in_lecture ? least_field_in_lecture : least_field), most), most);
    map_upper_row(frame, width);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect field{at.x + ends, at.y, side, side};
    map_vertical_ends(frame, field);
    ImGui::SetCursorScreenPos({field.x, field.y});
    map_field(frame, side);
    if (is_beside) map_legend_beside(frame, field, legend);
    map_lower_row(frame, field, at.x, width);
    map_words(frame, width);
    if (!is_beside) map_legend(frame, width);
}

// Folds the card of the scene, above the map, where the column is too low for both.
void make_room(const LabView& view, PanelState& state, const Ui& ui, Rect place) {
    CardState& scene = state.card(Card::scene);
    const CardState& map = state.card(Card::map);
    const bool is_cut = map.content > 0 && wanted_height(ui, map) > place.h + 1;
    if (view.lesson || !is_cut || scene.folded || scene.opened_by_user) return;
    scene.folded = state.map.folded_scene = true;
}

}  // namespace

bool shows_map_of_lecture(const LabView& view) {
    return view.lecture && view.settings.map && view.mode != Mode::wiring;
}

// In a lecture the map has the room of the brain's card, too, until that is unfolded.
void follow_map(const LabView& view, PanelState& state) {
    CardState& brain = state.card(Card::brain);
    if (std::exchange(state.map.is_open, view.settings.map) != view.settings.map && shows_map_of_lecture(view))
        state.map.folded_brain = !std::exchange(brain.folded, true);
    if (view.settings.map) return;
    if (state.map.folded_scene) state.card(Card::scene).folded = false;
    if (state.map.folded_brain && view.lecture) brain.folded = false;
    state.map = {};
}

void map_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect column) {
    const bool open = open_card(state, ui, Card::map, place);
    const VehicleView* vehicle = selected_vehicle(view);
    if (open && view.features.map && vehicle) {
        const insight::ValueSubject subject{*view.now, *vehicle, target_of(view, *vehicle), shown_pair(view, *vehicle)};
        const std::vector<insight::AxisValue> values = axis_values(subject);
        const insight::AxisValue *x = find_value(values, view.features.map->x.path),
                                 *y = find_value(values, view.features.map->y.path);
        if (x && y)
            draw_map({view, *view.features.map, state.map, state.sliders, ui, subject, values, x, y},
                     column.h - (view.lecture ? 0 : folded_height(ui) + ui.px(12)));  // of the card below
    } else if (open) {
        if (const std::string_view why_not = why_no_map(view); !why_not.empty())
            paragraph(ui, ui.strings(why_not), ui.palette.second_text, Face::small);
    }
    CardState& card = state.card(Card::map);
    end_card(ui, card);
    make_room(view, state, ui, place);
    if (std::exchange(card.folded, false)) ui.outbox.push_back(Action::map);  // folding closes it
}

}  // namespace braitenlab::ui
