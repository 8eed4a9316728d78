// The selected vehicle's brain: who it is, what its wiring does, the sliders, and this moment's numbers.
#include <algorithm>
#include <array>
#include <string>

#include <imgui.h>

#include "core/scene/names.h"
#include "ui/panels/panels.h"
#include "ui/panels/selected.h"
#include "ui/shortcuts.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

constexpr float low_column = 680;  // layout pixels: below it the picture is smaller

// Swatch, name, and the recogniser's word as a chip.
void title(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = line_height(ui, Face::title), size = ui.px(16), width = card_width(ui);
    put_role(ui, {at.x + size / 2, at.y + height / 2}, size, vehicle.role);
    const std::string name = kind_name(view, ui, vehicle) + " " + std::to_string(vehicle.id + 1);
    // Where its brain has no say, the chip says who drives.
    const bool thinks = vehicle.driver == Driver::brain;
    const std::string_view character =
        thinks ? braitenlab::name(recognised(state.recognised, *view.now, vehicle, view.wall_seconds))
               : word(vehicle.driver);
    const std::string_view label =
        ui.strings.find((thinks ? "character." : "driver.") + std::string(character), character);
    const float left = at.x + size + ui.px(8), name_width = text_width(ui, Face::title, name);
    const float word_width = chip_width(ui, label),
                word_left = std::min(left + name_width + ui.px(10), at.x + width - word_width);
    ImGui::PushClipRect(at, {word_left - ui.px(4), at.y + height}, true);
    put(ui, {left, at.y}, name, ui.palette.text, Face::title);
    ImGui::PopClipRect();
    chip(ui, {word_left, at.y + height / 2}, label);
    const Item row = item(ui, "brain.character", {width, height}, false);
    if (row.hovered) tooltip(ui, row, ui.strings((thinks ? "character_story." : "drive.") + std::string(character)));
}

void scope(const LabView& view, Ui& ui, const VehicleView& vehicle) {
    const auto same = [&](const VehicleView& other) { return other.kind == vehicle.kind; };
    if (std::count_if(view.now->vehicles.begin(), view.now->vehicles.end(), same) < 2) return;
    const std::string kind = kind_of(*view.now, vehicle).name;
    const std::array words{ui.strings("scope.one"), ui.strings.find("kind_all." + kind, ui.strings("scope.all"))};
    const int chosen = segments(ui, "scope", words, view.settings.selection.whole_kind ? 1 : 0, card_width(ui),
                                ui.strings("scope.how"));
    if (chosen >= 0) ui.outbox.push_back(ScopeRequest{chosen == 1});
}

}  // namespace

std::string kind_name(const Ui& ui, const Kind& kind) {
    std::string name(ui.strings.find("kind." + kind.name, kind.name));
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

std::string kind_name(const LabView& view, const Ui& ui, const VehicleView& vehicle) {
    const bool lone_kind = view.now->scene->kinds.size() == 1 && vehicle.role == Role::none;
    return lone_kind ? std::string(ui.strings("kind.vehicle")) : kind_name(ui, kind_of(*view.now, vehicle));
}

void brain_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect room) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    const std::string keys = key_name(Action::drive, ui.strings);
    const bool by_hand = vehicle && vehicle->driver == Driver::manual;
    std::array buttons{
        HeadingButton{"button.presets", ui.strings("button.presets"), ui.strings("tooltip.presets")},
        HeadingButton{"button.drive", ui.strings("button.drive"), ui.strings("tooltip.drive"), keys, by_hand}};
    const bool open = begin_card(ui, state.brain, "card.brain", ui.strings("brain.heading"), place,
                                 vehicle ? std::span(buttons) : std::span<HeadingButton>{});
    if (open && !vehicle) paragraph(ui, ui.strings("brain.nobody"), ui.palette.second_text);
    if (open && vehicle) {
        if (buttons[1].pressed) {
            ui.outbox.push_back(Action::drive);
            state.keyboard.focus.clear();  // the arrow keys are to steer, not to walk the card
        }
        title(view, state, ui, *vehicle);
        scope(view, ui, *vehicle);
        dial_sliders(view, state, ui, *vehicle);
        gap(ui, 8);
        if (vehicle->driver == Driver::brain)
            equations(view, ui, *vehicle);
        else
            driver_panel(state, ui, *vehicle);
        // The wiring canvas shows the same, larger.
        if (view.mode != Mode::wiring) brain_picture(view, state, ui, *vehicle, room.h < ui.px(low_column) ? 90 : 116);
        presets_menu(view, state, ui, *vehicle, buttons[0].pressed,
                     {place.x + place.w - ui.px(16), place.y + ui.px(36)});
    }
    end_card(state.brain);
}

}  // namespace braitenlab
