// The card of the open scene and the card of the selected lamp, obstacle or zone.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/maths/angle.h"
#include "core/maths/degrees.h"
#include "core/scene/enums.h"
#include "ui/imgui_compat.h"
#include "ui/panels/cards.h"
#include "ui/panels/charts/chart_data.h"
#include "ui/panels/course/prediction.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/panels.h"
#include "ui/scene_input/edits.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/record_fields.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float words_width = 84;  // layout pixels

struct ObjectNumber {
    std::string_view anchor, words, tooltip, unit;
    float low, high, home, step;
    int decimals;
};

constexpr ObjectNumber source_strength{"thing.strength", "thing.strength", "thing.strength_how", "", 0, 1, 1, 0.01f, 2};
constexpr ObjectNumber obstacle_length{"thing.length", "thing.length", "thing.length_how", " m", 0.2f, 10, 1, 0.01f, 2};
constexpr ObjectNumber obstacle_width{"thing.width", "thing.width", "thing.width_how", " m", 0.2f, 10, 1, 0.01f, 2};
constexpr ObjectNumber obstacle_heading{"thing.heading", "thing.heading", "thing.heading_how", "°", -180, 180, 0, 1, 0};
constexpr ObjectNumber obstacle_mass{"thing.mass", "thing.mass", "thing.mass_how", " kg", 0, 50, 0, 0.1f, 1};
constexpr std::array<std::string_view, 8> zone_fields{"heading", "length", "width", "recharge",
                                                      "wind_x",  "wind_y", "slope", "pull"};

// The edit by the slider, or nullopt.
std::optional<SliderEdit> turn(const LabView& view, PanelState& state, Ui& ui, const ObjectNumber& which, float value) {
    SliderLook look;
    look.words = ui.strings(which.words);
    look.tooltip = ui.strings(which.tooltip);
    look.low = which.low, look.high = which.high, look.home = which.home;
    look.step = which.step, look.decimals = which.decimals, look.unit = which.unit;
    look.signed_number = which.low < 0;
    look.meaning = false;
    look.words_width = words_width;
    look.number_width = 58;
    return slider(ui, state.sliders, which.anchor, value, card_width(ui), view.wall_seconds, look);
}

// A round spot in a channel's colour; true when it was pressed.
bool channel_swatch(Ui& ui, Channel channel, bool chosen) {
    const float size = ui.px(ui.tall(28));
    const Item at = item(ui, "thing.channel." + std::string(word(channel)), {size, size});
    const ImVec2 middle{at.middle_x(), at.middle_y()};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen || at.warmth > 0)
        list.AddCircle(middle, ui.px(12),
                       paint(chosen ? ui.palette.text : ui.palette.second_text.with_alpha(at.warmth)), 24, ui.px(1.5f));
    list.AddCircleFilled(middle, ui.px(8), paint(colour_of(ui.palette, channel)), 24);
    tooltip(ui, at, ui.strings("source." + std::string(word(channel))));
    return at.pressed;
}

void object_buttons(Ui& ui) {
    gap(ui, 8);
    if (push_button(ui, "thing.duplicate", {{}, ui.strings("action.duplicate")}, ui.strings("action.duplicate"),
                    key_name(Action::duplicate, ui.strings)))
        ui.outbox.push_back(Action::duplicate);
    ImGui::SameLine(0, ui.px(spacing::small));
    if (push_button(ui, "thing.erase", {{}, ui.strings("menu.erase")}, ui.strings("menu.erase"),
                    key_name(Action::erase, ui.strings)))
        ui.outbox.push_back(Action::erase);
}

void source_values(const LabView& view, PanelState& state, Ui& ui, int index) {
    const Source& now = view.now->scene->sources[static_cast<std::size_t>(index)];
    std::optional<Source> to;
    std::uint64_t gesture = 0;
    paragraph(ui, ui.strings("source." + std::string(word(now.channel))), ui.palette.text, Face::strong);
    bool first = true;
    for (const Channel channel : source_channels) {
        if (!std::exchange(first, false)) ImGui::SameLine(0, ui.px(spacing::tight));
        if (channel_swatch(ui, channel, channel == now.channel) && channel != now.channel)
            to = now, to->channel = channel;
    }
    if (const auto edit = turn(view, state, ui, source_strength, now.strength))
        to = now, to->strength = edit->value, gesture = edit->gesture;
    const std::array<std::string_view, 2> words{ui.strings("thing.light_only"), ui.strings("thing.solid")};
    const int chosen = segments(ui, "thing.solid", words, now.solid ? 1 : 0, card_width(ui));
    if (chosen >= 0 && (chosen == 1) != now.solid) to = now, to->solid = chosen == 1;
    if (to) ui.outbox.push_back(EditRequest{EditSource{index, *to}, gesture});
}

void obstacle_values(const LabView& view, PanelState& state, Ui& ui, int index) {
    // A movable obstacle may have left its position in the scene: edit it where it is now.
    Obstacle now = view.now->scene->obstacles[static_cast<std::size_t>(index)];
    const Pose place = *place_of(*view.now, {SceneObjectKind::obstacle, index});
    now.x = place.x, now.y = place.y, now.heading = place.heading;
    std::optional<Obstacle> to;
    std::uint64_t gesture = 0;
    const auto number = [&](const ObjectNumber& which, float value, auto set) {
        const auto edit = turn(view, state, ui, which, value);
        if (!edit) return;
        to = now;
        set(*to, edit->value);
        gesture = edit->gesture;
    };
    if (now.corners.empty()) {
        number(obstacle_length, now.length, [](Obstacle& o, float v) { o.length = v; });
        number(obstacle_width, now.width, [](Obstacle& o, float v) { o.width = v; });
    } else {
        paragraph(ui, fill(ui.strings("thing.corners"), {std::to_string(now.corners.size())}), ui.palette.second_text);
    }
    number(obstacle_heading, maths::degrees(now.heading),
           [](Obstacle& o, float v) { o.heading = maths::from_degrees(static_cast<double>(v)); });
    number(obstacle_mass, now.mass, [](Obstacle& o, float v) { o.mass = v; });
    if (to) ui.outbox.push_back(EditRequest{EditObstacle{index, *to}, gesture});
}

// A square in a surface's colour; true when it was pressed.
bool surface_swatch(Ui& ui, Surface surface, bool chosen) {
    const float size = ui.px(ui.tall(28)), half = ui.px(8), frame = ui.px(12);
    const std::string name(word(surface));
    const Item at = item(ui, "thing.surface." + name, {size, size});
    const auto square = [&](float reach) {
        return Rect{at.middle_x() - reach, at.middle_y() - reach, 2 * reach, 2 * reach};
    };
    if (chosen || at.warmth > 0)
        line_box(ui, square(frame), chosen ? ui.palette.text : ui.palette.second_text.with_alpha(at.warmth));
    if (surface != Surface::none) fill_box(ui, square(half), colour_of(ui.palette, surface), Corner::bar);
    line_box(ui, square(half), ui.palette.second_text, Corner::bar);
    tooltip(ui, at, ui.strings("field.surface." + name));
    return at.pressed;
}

// Rectangle, ellipse or polygon. A press of polygon starts to draw its corners; the others are the edit.
std::optional<Zone> zone_shape(PanelState& state, Ui& ui, const Zone& zone) {
    const std::array<std::string_view, 3> words{ui.strings("thing.rectangle"), ui.strings("thing.ellipse"),
                                                ui.strings("thing.polygon")};
    const int now = !zone.corners.empty() ? 2 : zone.round ? 1 : 0;
    const int pressed = segments(ui, "thing.shape", words, now, card_width(ui), ui.strings("thing.shape_how"));
    if (pressed == 2) {
        choose_tool(state.scene_input, SceneInputTool::polygon);
        state.scene_input.redrawn = zone.name;
    }
    if (pressed < 0 || pressed == 2 || pressed == now) return std::nullopt;
    Zone to = zone;
    to.corners.clear();
    to.round = pressed == 1;
    return to;
}

void zone_values(const LabView& view, PanelState& state, Ui& ui, int index) {
    const Zone& now = view.now->scene->zones[static_cast<std::size_t>(index)];
    std::optional<Zone> to;
    std::uint64_t gesture = 0;
    const std::string surface_words = std::string(ui.strings("field.zone.surface")) + ": " +
                                      std::string(ui.strings("field.surface." + std::string(word(now.surface))));
    paragraph(ui, surface_words, ui.palette.text, Face::strong);
    for (const SurfaceTraits& surface : surface_table) {
        if (surface.value != Surface::none) ImGui::SameLine(0, ui.px(spacing::tight));
        if (surface_swatch(ui, surface.value, surface.value == now.surface) && surface.value != now.surface)
            to = now, to->surface = surface.value;
    }
    if (auto shaped = zone_shape(state, ui, now)) to = std::move(shaped);
    std::vector<std::string_view> shown(zone_fields.begin(), zone_fields.end());
    if (!now.corners.empty())
        std::erase_if(shown, [](std::string_view key) { return key == "length" || key == "width"; });
    const FieldRows rows{.ui = ui,
                         .state = state.fields,
                         .sliders = state.sliders,
                         .wall_seconds = view.wall_seconds,
                         .anchor = "thing",
                         .words_width = words_width};
    if (auto edit = record_fields(rows, now, Zone{}, shown)) to = std::move(edit->to), gesture = edit->gesture;
    if (to) ui.outbox.push_back(EditRequest{EditZone{index, *to}, gesture});
}

// "3 vehicles, 1 source": the numbers of selected objects of each sort.
std::string counts_of(const Ui& ui, const std::vector<SceneObject>& objects) {
    std::string all;
    for (const SceneObjectKind kind :
         {SceneObjectKind::vehicle, SceneObjectKind::source, SceneObjectKind::obstacle, SceneObjectKind::zone}) {
        const auto count = std::count_if(objects.begin(), objects.end(),
                                         [kind](const SceneObject& object) { return object.kind == kind; });
        if (count == 0) continue;
        const std::string key = (count == 1 ? "thing.one_" : "thing.many_") + std::string(word(kind));
        all += (all.empty() ? "" : ", ") + fill(ui.strings(key), {std::to_string(count)});
    }
    return all;
}

// What is selected and what acts on all of it, and whose values follow.
void several_objects(const LabView& view, Ui& ui, const std::vector<SceneObject>& objects) {
    paragraph(ui, counts_of(ui, objects), ui.palette.text, Face::title);
    const std::string how = fill(ui.strings("thing.several_how"),
                                 {key_name(Action::duplicate, ui.strings), key_name(Action::copy, ui.strings),
                                  key_name(Action::erase, ui.strings)});
    paragraph(ui, how, ui.palette.second_text, Face::small);
    const SceneObject object = view.settings.selection.object;
    if (!object) return;
    gap(ui, 8);
    subheading(ui, fill(ui.strings("thing.values_of"), {name_of(*view.now->scene, object)}));
}

void goal_row(const PanelState& state, Ui& ui, const PopulationGoal& goal) {
    const auto best = static_cast<float>(std::floor(longest_time_with(state.charts.history, goal.role, goal.count)));
    const bool done = best >= goal.seconds;
    gap(ui, 8);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const float left = ui.px(26);
    ImGui::BeginGroup();
    ImGui::Indent(left);
    paragraph(ui,
              fill(ui.strings("scene.goal_" + std::string(word(goal.role))),
                   {std::to_string(goal.count), fixed(ui, goal.seconds, 0)}),
              ui.palette.text, done ? Face::strong : Face::text);
    if (best > 0)
        paragraph(ui, fill(ui.strings("scene.goal_best"), {fixed(ui, best, 0)}), ui.palette.second_text, Face::small);
    ImGui::Unindent(left);
    compat::end_group();
    const float height = ImGui::GetItemRectSize().y;
    check_mark(ui, {start.x + ui.px(9), start.y + line_height(ui, Face::text) / 2}, ui.px(8), done,
               eased(ui, "scene.goal", done ? 1.0f : 0.0f, 0.2f));
    mark(ui, "scene.goal", {start.x, start.y, card_width(ui), height});
}

}  // namespace

void object_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect) {
    const SceneObject object = view.settings.selection.object;
    const std::vector<SceneObject> all = selected_objects(view.settings.selection);
    const std::string_view heading =
        ui.strings(all.size() > 1 ? "thing.selection" : "thing." + std::string(word(object.kind)));
    if (open_card(state, ui, Card::object, place, {}, heading)) {
        if (all.size() > 1) several_objects(view, ui, all);
        if (object.kind == SceneObjectKind::source)
            source_values(view, state, ui, object.index);
        else if (object.kind == SceneObjectKind::zone)
            zone_values(view, state, ui, object.index);
        else if (object.kind == SceneObjectKind::obstacle)
            obstacle_values(view, state, ui, object.index);
        object_buttons(ui);
    }
    end_card(ui, state.card(Card::object));
}

void scene_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect) {
    std::array buttons{HeadingButton{"button.values", ui.strings("button.values"), ui.strings("tooltip.values"),
                                     key_name(Action::values, ui.strings), view.settings.values}};
    const bool open = open_card(state, ui, Card::scene, place, view.lecture ? std::span<HeadingButton>{} : buttons);
    if (buttons[0].pressed) ui.outbox.push_back(Action::values);
    if (open) {
        const Scene& scene = *view.now->scene;
        const bool hides = hides_open_title(view);
        if (!hides)
            paragraph(ui, scene.title.empty() ? std::string_view(scene.name) : translated(ui, scene.title),
                      ui.palette.text, Face::title);
        if (!scene.story.empty() && !hides) paragraph(ui, translated(ui, scene.story), ui.palette.second_text);
        if (scene.goal.role != Role::none) goal_row(state, ui, scene.goal);
        start_row(view, state, ui);
    }
    end_card(ui, state.card(Card::scene));
}

}  // namespace braitenlab::ui
