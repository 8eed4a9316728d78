// The lamp or obstacle that is selected, with its values.
#include <algorithm>
#include <array>
#include <string>

#include <imgui.h>

#include "core/maths/angle.h"
#include "core/scene/names.h"
#include "ui/panels/panels.h"
#include "ui/scene_input/edits.h"
#include "ui/shortcuts.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

constexpr float words_width = 84;  // layout pixels

struct Value {
    std::string_view anchor, words, tooltip, unit;
    float low, high, home, step;
    int decimals;
};

constexpr Value strength{"thing.strength", "thing.strength", "thing.strength_how", "", 0, 1, 1, 0.01f, 2};
constexpr Value length{"thing.length", "thing.length", "thing.length_how", " m", 0.2f, 10, 1, 0.01f, 2};
constexpr Value width{"thing.width", "thing.width", "thing.width_how", " m", 0.2f, 10, 1, 0.01f, 2};
constexpr Value heading{"thing.heading", "thing.heading", "thing.heading_how", "°", -180, 180, 0, 1, 0};
constexpr Value mass{"thing.mass", "thing.mass", "thing.mass_how", " kg", 0, 50, 0, 0.1f, 1};

// What the slider made of the value; nothing where the hand left it alone.
std::optional<SliderEdit> turn(const LabView& view, PanelState& state, Ui& ui, const Value& which, float value) {
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
bool swatch(Ui& ui, Channel channel, bool chosen) {
    const float size = ui.px(28);
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

void buttons(Ui& ui) {
    gap(ui, 8);
    const Item copy = button(ui, "thing.duplicate", {{}, ui.strings("action.duplicate")});
    tooltip(ui, copy, ui.strings("action.duplicate"), key_name(Action::duplicate, ui.strings));
    if (copy.pressed) ui.outbox.push_back(Action::duplicate);
    ImGui::SameLine(0, ui.px(8));
    const Item gone = button(ui, "thing.erase", {{}, ui.strings("menu.erase")});
    tooltip(ui, gone, ui.strings("menu.erase"), key_name(Action::erase, ui.strings));
    if (gone.pressed) ui.outbox.push_back(Action::erase);
}

void source_values(const LabView& view, PanelState& state, Ui& ui, int index) {
    const Source& now = view.now->scene->sources[static_cast<std::size_t>(index)];
    std::optional<Source> to;
    std::uint64_t gesture = 0;
    paragraph(ui, ui.strings("source." + std::string(word(now.channel))), ui.palette.text, Face::strong);
    bool first = true;
    for (const Channel channel : source_channels) {
        if (!std::exchange(first, false)) ImGui::SameLine(0, ui.px(4));
        if (swatch(ui, channel, channel == now.channel) && channel != now.channel) to = now, to->channel = channel;
    }
    if (const auto edit = turn(view, state, ui, strength, now.strength))
        to = now, to->strength = edit->value, gesture = edit->gesture;
    const std::array<std::string_view, 2> words{ui.strings("thing.light_only"), ui.strings("thing.solid")};
    const int chosen = segments(ui, "thing.solid", words, now.solid ? 1 : 0, card_width(ui));
    if (chosen >= 0 && (chosen == 1) != now.solid) to = now, to->solid = chosen == 1;
    if (to) ui.outbox.push_back(EditRequest{EditSource{index, *to}, gesture});
}

void obstacle_values(const LabView& view, PanelState& state, Ui& ui, int index) {
    // Movable ones stand elsewhere than the scene has them: an edit starts from where this one is.
    Obstacle now = view.now->scene->obstacles[static_cast<std::size_t>(index)];
    const Pose place = *place_of(*view.now, {SceneObjectKind::obstacle, index});
    now.x = place.x, now.y = place.y, now.heading = place.heading;
    std::optional<Obstacle> to;
    std::uint64_t gesture = 0;
    const auto number = [&](const Value& which, float value, auto set) {
        const auto edit = turn(view, state, ui, which, value);
        if (!edit) return;
        to = now;
        set(*to, edit->value);
        gesture = edit->gesture;
    };
    if (now.corners.empty()) {
        number(length, now.length, [](Obstacle& o, float v) { o.length = v; });
        number(width, now.width, [](Obstacle& o, float v) { o.width = v; });
    } else {
        paragraph(ui, fill(ui.strings("thing.corners"), {std::to_string(now.corners.size())}), ui.palette.second_text);
    }
    number(heading, maths::degrees(now.heading), [](Obstacle& o, float v) { o.heading = maths::radians(v); });
    number(mass, now.mass, [](Obstacle& o, float v) { o.mass = v; });
    if (to) ui.outbox.push_back(EditRequest{EditObstacle{index, *to}, gesture});
}

}  // namespace

void object_card(const LabView& view, PanelState& state, Ui& ui, Rect place) {
    const bool source = view.settings.selection.object.kind == SceneObjectKind::source;
    const auto words = ui.strings(source ? "thing.source" : "thing.obstacle");
    if (begin_card(ui, state.object, "card.thing", words, place)) {
        if (source)
            source_values(view, state, ui, view.settings.selection.object.index);
        else
            obstacle_values(view, state, ui, view.settings.selection.object.index);
        object_buttons(ui);
    }
    end_card(state.object);
}

}  // namespace braitenlab
