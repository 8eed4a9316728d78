// The menu of preset brains, with buttons to load and save a brain file.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <imgui.h>

#include "core/brain/presets.h"
#include "core/scene/sensor_edits.h"
#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/panels/sensor_changes.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float preset_width = 396, between_presets = spacing::small,
                preset_padding = spacing::medium;  // layout pixels

// Two columns, which both fit into the window; in an upright window one, which scrolls. The menu does not touch the
// edge.
struct PresetColumns {
    std::size_t count;
    float width;  // window pixels
};
PresetColumns preset_columns(const Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float room = window.x - ui.px(4 * spacing::small);
    if (is_upright(window.x / ui.px(1), window.y / ui.px(1))) return {1, std::min(ui.px(preset_width), room)};
    return {2, std::min(ui.px(preset_width), std::floor((room - ui.px(between_presets)) / 2))};
}

std::string_view story_of(const Ui& ui, const Preset& preset) {
    return ui.strings.find("preset_story." + std::string(preset.name), "");
}

// With as many lines as its story needs in the column.
float preset_height(const Ui& ui, const Preset& preset, float width) {
    const float room = width - 2 * ui.px(spacing::medium);
    const std::size_t lines = lines_of_words(ui, story_of(ui, preset), Face::small, room).size();
    const float words = line_height(ui, Face::text) + static_cast<float>(lines) * line_height(ui, Face::small);
    return std::max(words + ui.px(preset_padding), ui.px(ui.finger));
}

// Draws a preset; pressed: the user has chosen it. A bar marks the current brain of the vehicle.
Item preset_row(Ui& ui, const Preset& preset, bool current, const Rect& at) {
    const std::string key(preset.name);
    ImGui::SetCursorScreenPos({at.x, at.y});
    const Item row = item(ui, "preset." + key, {at.w, at.h});
    fill_box(ui, row.rect, ui.palette.line.with_alpha(0.6f * row.warmth));
    if (current)
        fill_box(ui, {row.rect.x, row.rect.y + ui.px(6), ui.px(3), row.rect.h - ui.px(12)}, ui.palette.accent,
                 Corner::bar);
    const float x = row.rect.x + ui.px(spacing::medium);
    put(ui, {x, row.rect.y + ui.px(5)}, ui.strings.find("preset." + key, key), ui.palette.text, Face::strong);
    put_on(*ImGui::GetWindowDrawList(), ui, {x, row.rect.y + ui.px(6) + line_height(ui, Face::text)},
           story_of(ui, preset), ui.palette.second_text, Face::small, row.rect.w - 2 * ui.px(spacing::medium));
    tooltip(ui, row, ui.strings("tooltip.presets"));
    return row;
}

void preset_rows(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle) {
    const BrainGraph& brain = *brain_of(*view.now, vehicle);
    const ImVec2 start = ImGui::GetCursorScreenPos();
    const PresetColumns columns = preset_columns(ui);
    const float width = columns.width;
    const std::size_t count = presets().size(), half = (count + columns.count - 1) / columns.count;
    std::array<float, 2> y{start.y, start.y};  // of the next row of each column
    for (std::size_t i = 0; i < count; ++i) {
        const Preset& preset = presets()[i];
        float& top = y[i < half ? 0 : 1];
        const Rect at{start.x + (i < half ? 0.0f : width + ui.px(between_presets)), top, width,
                      preset_height(ui, preset, width)};
        top += at.h + ui.px(spacing::hair);
        BrainGraph made = graft(brain, preset.brain);
        const Item row = preset_row(ui, preset, same_wiring(made, brain), at);
        if (row.hovered) state.brain.what_if = {SetBrain{target_of(view, vehicle), made}};
        if (!row.pressed) continue;
        if (!lacking_for(kind_of(*view.now, vehicle).sensors, preset).empty()) {
            state.brain.presets.asked = preset.name;
            return;
        }
        ui.outbox.push_back(EditRequest{SetBrain{target_of(view, vehicle), std::move(made)},
                                        gestures::panels + ++state.sliders.gesture});
        ImGui::CloseCurrentPopup();
    }
    ImGui::SetCursorScreenPos({start.x, std::max(y[0], y[1])});
}

// "prey (SL, SR), heat (HL, HR)": by channel.
std::string names_by_channel(const Ui& ui, const std::vector<Sensor>& sensors) {
    std::string words;
    for (const ChannelTraits& row : channel_table) {
        std::string names;
        for (const Sensor& sensor : sensors)
            if (sensor.channel == row.value) names += (names.empty() ? "" : ", ") + sensor.name;
        if (names.empty()) continue;
        words += (words.empty() ? "" : ", ") + std::string(ui.strings("sense." + std::string(row.word))) + " (" +
                 names + ")";
    }
    return words;
}

// Asks whether the vehicle also gets the sensors of the preset, which it lacks.
void ask_for_sensors(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle, const Preset& preset) {
    const std::vector<Sensor>& sensors = kind_of(*view.now, vehicle).sensors;
    const ImVec2 start = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({start.x + ui.px(spacing::medium), start.y + ui.px(4)});
    ImGui::BeginGroup();
    const std::string key(preset.name);
    paragraph(ui, ui.strings.find("preset." + key, key), ui.palette.text, Face::strong, preset_columns(ui).width);
    paragraph(ui, fill(ui.strings("own_brain.ask"), {names_by_channel(ui, lacking_for(sensors, preset))}),
              ui.palette.second_text, Face::text, preset_columns(ui).width);
    gap(ui, 6);
    BrainGraph made = graft(*brain_of(*view.now, vehicle), preset.brain);
    const auto chosen = [&](std::string_view id, std::string_view words, Emphasis emphasis) {
        const bool pressed = button(ui, id, {.words = ui.strings(words), .emphasis = emphasis}).pressed;
        if (pressed) state.brain.presets.asked.clear();
        return pressed;
    };
    const auto gesture = [&] { return gestures::panels + ++state.sliders.gesture; };
    if (chosen("preset.with_sensors", "own_brain.with_sensors", Emphasis::primary)) {
        request_brain_and_sensors(view, ui.outbox, vehicle, std::move(made),
                                  with_sensors(sensors, lacking_for(sensors, preset)), gesture());
        ImGui::CloseCurrentPopup();
    } else if (chosen("preset.brain_only", "own_brain.brain_only", Emphasis::plain)) {
        ui.outbox.push_back(EditRequest{SetBrain{target_of(view, vehicle), std::move(made)}, gesture()});
        ImGui::CloseCurrentPopup();
    } else {
        chosen("preset.back", "own_brain.back", Emphasis::quiet);
    }
    ImGui::Dummy({1, ui.px(spacing::tight)});
    compat::end_group();
}

// A preset defines two sensors. Names the other sensors of the vehicle, which keep their wires.
void kept_sensors(Ui& ui, const BrainGraph& brain) {
    std::string names;
    for (const std::string& name : kept_by_graft(brain, find_preset("2a-coward")->brain))
        names += (names.empty() ? "" : ", ") + name;
    if (names.empty()) return;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    put(ui, {at.x + ui.px(spacing::medium), at.y + ui.px(4)}, fill(ui.strings("own_brain.stays"), {names}),
        ui.palette.second_text, Face::small);
    ImGui::Dummy({1, line_height(ui, Face::small) + ui.px(spacing::small)});
}

// Buttons that open the file browser to load or save a brain.
void own_brains(PanelState& state, Ui& ui) {
    const auto wanted = [&](const SmallButton& look, std::string_view how) {
        const bool pressed = small_push_button(ui, look, how);
        if (pressed) ImGui::CloseCurrentPopup(), state.sheet = Sheet::files;
        return pressed;
    };
    ImGui::SetCursorScreenPos(
        {ImGui::GetCursorScreenPos().x + ui.px(spacing::medium), ImGui::GetCursorScreenPos().y + ui.px(6)});
    if (wanted({"preset.load", icon::load, ui.strings("own_brain.load")}, ui.strings("own_brain.load_how"))) {
        begin_files(state.sheets.files, false);
        state.sheets.files.place = FilesPlace::folder;
        state.sheets.files.only = FileKind::brain;
        ui.outbox.push_back(BrowseRequest{});
    }
    ImGui::SameLine(0, ui.px(spacing::small));
    if (wanted({"preset.save", icon::save, ui.strings("own_brain.save")}, ui.strings("own_brain.save_how")))
        begin_files(state.sheets.files, true, FileKind::brain);
    ImGui::Dummy({1, ui.px(spacing::tight)});
}

}  // namespace

void presets_menu(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle, bool wanted,
                  ImVec2 corner) {
    if (wanted) ImGui::OpenPopup("presets");
    // A menu that is opened by key gets the focus. When it is closed, the focus before it is restored.
    if (wanted && ui.keyboard && ui.keyboard->focus == "button.presets")
        ui.keyboard->focus = "preset." + std::string(presets().front().name);
    const float lowest = ImGui::GetIO().DisplaySize.y - ui.px(spacing::small);
    corner.y = std::max(ui.px(spacing::small), std::min(corner.y, lowest - state.brain.presets.height));
    corner.x = std::max(corner.x, state.brain.presets.width + ui.px(spacing::small));
    if (preset_columns(ui).count == 1)
        ImGui::SetNextWindowSizeConstraints({0, 0}, {ImGui::GetIO().DisplaySize.x, lowest - ui.px(spacing::small)});
    ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {1, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(spacing::small), ui.px(spacing::small)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(spacing::tight), ui.px(spacing::hair)});
    const bool was_open = state.brain.presets.open;
    state.brain.presets.open = ImGui::BeginPopup("presets");
    if (state.brain.presets.open) {
        if (state.brain.presets.closes) ImGui::CloseCurrentPopup();
        if (const Preset* asked = find_preset(state.brain.presets.asked)) {
            ask_for_sensors(view, state, ui, vehicle, *asked);
        } else {
            preset_rows(view, state, ui, vehicle);
            kept_sensors(ui, *brain_of(*view.now, vehicle));
            own_brains(state, ui);
        }
        state.brain.presets.height = ImGui::GetWindowHeight();
        state.brain.presets.width = ImGui::GetWindowWidth();
        compat::end_popup();
    } else if (was_open && ui.keyboard && ui.keyboard->focus.substr(0, 7) == "preset.") {
        ui.keyboard->focus = "button.presets";
    }
    if (!state.brain.presets.open) state.brain.presets.asked.clear();
    state.brain.presets.closes = false;
    ImGui::PopStyleVar(2);
}

}  // namespace braitenlab::ui
