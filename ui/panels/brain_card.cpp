// The selected vehicle's brain: who it is, what its wiring does, the sliders, and this moment's numbers.
#include <algorithm>
#include <array>
#include <string>

#include <imgui.h>

#include "core/brain/presets.h"
#include "core/scene/names.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

constexpr float low_column = 680;  // layout pixels: below it the picture is smaller

const std::shared_ptr<const BrainGraph>& brain_of(const Snapshot& now, const VehicleView& vehicle) {
    return now.brains[static_cast<std::size_t>(vehicle.brain)];
}

const Kind& kind_of(const Snapshot& now, const VehicleView& vehicle) {
    return now.scene->kinds[static_cast<std::size_t>(vehicle.kind)];
}

Target target_of(const LabView& view, const VehicleView& vehicle) {
    return view.whole_kind ? Target{no_vehicle, vehicle.kind} : Target{vehicle.id, -1};
}

Character recognised(PanelState& state, const std::shared_ptr<const BrainGraph>& brain) {
    if (state.recognised.brain != brain) state.recognised = {brain, recognise(*brain)};
    return state.recognised.character;
}

// Swatch, name, and the recogniser's word as a chip.
void title(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = line_height(ui, Face::title), size = ui.px(16), width = card_width(ui);
    put_role(ui, {at.x + size / 2, at.y + height / 2}, size, vehicle.role);
    // Where all are alike the kind's name says nothing, or gives an exercise's answer away.
    const bool lone_kind = view.now->scene->kinds.size() == 1 && vehicle.role == Role::none;
    const std::string kind =
        lone_kind ? std::string(ui.strings("kind.vehicle")) : kind_name(ui, kind_of(*view.now, vehicle));
    const std::string name = kind + " " + std::to_string(vehicle.id + 1);
    const std::string_view character = braitenlab::name(recognised(state, brain_of(*view.now, vehicle)));
    const std::string_view word = ui.strings.find("character." + std::string(character), character);
    const float left = at.x + size + ui.px(8), name_width = text_width(ui, Face::title, name);
    const float word_width = chip_width(ui, word),
                word_left = std::min(left + name_width + ui.px(10), at.x + width - word_width);
    ImGui::PushClipRect(at, {word_left - ui.px(4), at.y + height}, true);
    put(ui, {left, at.y}, name, ui.palette.text, Face::title);
    ImGui::PopClipRect();
    chip(ui, {word_left, at.y + height / 2}, word);
    const Item row = item(ui, "brain.character", {width, height}, false);
    tooltip(ui, row, ui.strings("character_story." + std::string(character)));
}

void scope(const LabView& view, Ui& ui, const VehicleView& vehicle) {
    const auto same = [&](const VehicleView& other) { return other.kind == vehicle.kind; };
    if (std::count_if(view.now->vehicles.begin(), view.now->vehicles.end(), same) < 2) return;
    const std::string kind = kind_of(*view.now, vehicle).name;
    const std::array words{ui.strings("scope.one"), ui.strings.find("kind_all." + kind, ui.strings("scope.all"))};
    const int chosen = segments(ui, "scope", words, view.whole_kind ? 1 : 0, card_width(ui));
    if (chosen >= 0) ui.outbox.push_back(ScopeRequest{chosen == 1});
}

struct DialSlider {
    Dial dial;
    std::string_view anchor, tooltip;
};

constexpr DialSlider weights[]{{Dial::LL, "slider.LL", "dial.LL"},
                               {Dial::LR, "slider.LR", "dial.LR"},
                               {Dial::RL, "slider.RL", "dial.RL"},
                               {Dial::RR, "slider.RR", "dial.RR"}};
constexpr std::string_view threshold_anchors[]{"threshold.LL", "threshold.LR", "threshold.RL", "threshold.RR"};
constexpr DialSlider biases[]{{Dial::LM, "bias.LM", "dial.LM"}, {Dial::RM, "bias.RM", "dial.RM"}};

class Dials {
public:
    Dials(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle)
        : view_(view),
          state_(state),
          ui_(ui),
          target_(target_of(view, vehicle)),
          values_(read_dials(*brain_of(*view.now, vehicle))) {}

    void draw() {
        const float width = card_width(ui_), space = ui_.px(14);
        const float threshold_width = ui_.px(104), weight_width = width - threshold_width - space;
        captions(weight_width + space);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {space, 0});
        for (std::size_t i = 0; i < std::size(weights); ++i) {
            turn(weights[i].dial, weights[i].anchor, weight_width, weight_look(weights[i]));
            ImGui::SameLine();
            turn(threshold_of(weights[i].dial), threshold_anchors[i], threshold_width, threshold_look());
        }
        const float half = (width - space) / 2;
        for (const DialSlider& bias : biases) {
            turn(bias.dial, bias.anchor, half, bias_look(bias));
            if (bias.dial == Dial::LM) ImGui::SameLine();
        }
        ImGui::PopStyleVar();
    }

private:
    void captions(float threshold_x) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        put(ui_, at, ui_.strings("brain.weight"), ui_.palette.second_text, Face::small);
        put(ui_, {at.x + threshold_x, at.y}, ui_.strings("brain.threshold"), ui_.palette.second_text, Face::small);
        ImGui::Dummy({1, line_height(ui_, Face::small) - ui_.px(1)});
    }

    SliderLook weight_look(const DialSlider& which) const {
        SliderLook look;
        look.words = name(which.dial);
        look.tooltip = ui_.strings(which.tooltip);
        return look;
    }
    SliderLook threshold_look() const {
        SliderLook look;
        look.tooltip = ui_.strings("dial.threshold");
        look.low = 0, look.high = 1;
        look.signed_number = look.meaning = false;
        look.words_width = 0, look.number_width = 38;
        return look;
    }
    SliderLook bias_look(const DialSlider& which) const {
        SliderLook look = weight_look(which);
        look.low = -1, look.high = 1;
        look.words_width = 28;
        return look;
    }

    void turn(Dial dial, std::string_view anchor, float width, const SliderLook& look) {
        const auto edit = slider(ui_, state_.sliders, anchor, at(values_, dial), width, view_.wall_seconds, look);
        if (edit) ui_.outbox.push_back(EditRequest{TurnDial{target_, dial, edit->value}, edit->gesture});
    }

    const LabView& view_;
    PanelState& state_;
    Ui& ui_;
    Target target_;
    FourNeurons values_;
};

// The canonical vehicles, one click away.
void presets_menu(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle, bool wanted,
                  ImVec2 corner) {
    if (wanted) ImGui::OpenPopup("presets");
    ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(8), ui.px(8)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(4), ui.px(2)});
    state.presets_open = ImGui::BeginPopup("presets");
    if (state.presets_open) {
        if (state.close_presets) ImGui::CloseCurrentPopup();
        for (const Preset& preset : presets()) {
            const std::string key(preset.name);
            const Item row = item(ui, "preset." + key,
                                  {ui.px(340), line_height(ui, Face::text) + line_height(ui, Face::small) + ui.px(12)});
            fill_box(ui, row.rect, ui.palette.line.with_alpha(0.6f * row.warmth));
            const float x = row.rect.x + ui.px(10);
            put(ui, {x, row.rect.y + ui.px(5)}, ui.strings.find("preset." + key, key), ui.palette.text, Face::strong);
            put(ui, {x, row.rect.y + ui.px(6) + line_height(ui, Face::text)},
                ui.strings.find("preset_story." + key, ""), ui.palette.second_text, Face::small);
            if (!row.pressed) continue;
            ui.outbox.push_back(EditRequest{SetBrain{target_of(view, vehicle), preset.brain},
                                            gestures::panels + ++state.sliders.gesture});
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
    }
    state.close_presets = false;
    ImGui::PopStyleVar(2);
}

}  // namespace

std::string kind_name(const Ui& ui, const Kind& kind) {
    std::string name(ui.strings.find("kind." + kind.name, kind.name));
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

void brain_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect room) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.selected);
    HeadingButton choose{"button.presets", ui.strings("button.presets"), ui.strings("tooltip.presets")};
    const bool open =
        begin_card(ui, state.brain, "card.brain", ui.strings("brain.heading"), place, vehicle ? &choose : nullptr);
    if (open && !vehicle) paragraph(ui, ui.strings("brain.nobody"), ui.palette.second_text);
    if (open && vehicle) {
        title(view, state, ui, *vehicle);
        scope(view, ui, *vehicle);
        Dials(view, state, ui, *vehicle).draw();
        gap(ui, 8);
        equations(view, ui, *vehicle);
        // The wiring canvas shows the same, larger.
        if (view.mode != Mode::wiring) brain_picture(view, ui, *vehicle, room.h < ui.px(low_column) ? 90 : 116);
        presets_menu(view, state, ui, *vehicle, choose.pressed, {place.x + place.w - ui.px(16), place.y + ui.px(36)});
    }
    end_card(state.brain);
}

}  // namespace braitenlab
