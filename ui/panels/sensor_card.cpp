// The card of the sensors of the selected vehicle's kind: position, direction, opening angle, range, and quality.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <imgui.h>

#include "core/scene/enums.h"
#include "core/scene/schema.h"
#include "ui/panels/cards.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

constexpr float degrees_per_radian = 57.295779513f;

// The name of the sensor on the other side: SR for SL. Empty where the name has no side.
std::string other_side(const std::string& name) {
    std::string other = name;
    if (name.empty() || (name.back() != 'L' && name.back() != 'R')) return {};
    other.back() = name.back() == 'L' ? 'R' : 'L';
    return other;
}

template <class Sensors>
auto find_sensor(Sensors& sensors, const std::string& name) -> decltype(&sensors[0]) {
    const auto found = std::find_if(sensors.begin(), sensors.end(), [&](const Sensor& s) { return s.name == name; });
    return found == sensors.end() ? nullptr : &*found;
}

// One number of a sensor as a slider shows it.
struct SensorNumber {
    std::string_view anchor, words, tooltip;  // the latter two are keys of strings
    float Sensor::*value;
    float low, high;
    float factor = 1;  // shown per stored
    float step = 0.01f;
    int decimals = 2;
    std::string_view unit;
    bool sided = false;      // mirrored on the other side
    bool stretches = false;  // the slider's range includes larger values that are in the scene
};

constexpr SensorNumber geometry_numbers[]{
    {"sensor.angle", "sensors.angle", "sensors.angle_how", &Sensor::angle, -180, 180, degrees_per_radian, 1, 0, "°",
     true},
    {"sensor.field", "sensors.field", "sensors.field_how", &Sensor::fov, 1, 360, degrees_per_radian, 1, 0, "°"},
    {"sensor.range", "sensors.range", "sensors.range_how", &Sensor::range, 0.1f, 20, 1, 0.1f, 1, " m", false, true},
    {"sensor.x", "sensors.x", "sensors.x_how", &Sensor::x, -1, 1, 1, 0.01f, 2, " m", false, true},
    {"sensor.y", "sensors.y", "sensors.y_how", &Sensor::y, -1, 1, 1, 0.01f, 2, " m", true, true},
};
constexpr SensorNumber quality_numbers[]{
    {"sensor.half_distance", "sensors.half_distance", "sensors.half_distance_how", &Sensor::half_distance, 0.1f, 20, 1,
     0.1f, 1, " m", false, true},
    {"sensor.noise", "sensors.noise", "sensors.noise_how", &Sensor::noise, 0, 1},
    {"sensor.latency", "sensors.latency", "sensors.latency_how", &Sensor::latency, 0, 1, 1, 0.01f, 2, " s"},
};

class SensorEditor {
public:
    SensorEditor(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle)
        : view_(view), state_(state), ui_(ui), vehicle_(vehicle), kind_(kind_of(*view.now, vehicle)) {
        if (!find_sensor(kind_.sensors, state.sensor)) state.sensor = kind_.sensors.front().name;
        sensor_ = find_sensor(kind_.sensors, state.sensor);
        if (const Kind* filed = filed_kind(view, vehicle)) filed_ = find_sensor(filed->sensors, state.sensor);
    }

    void draw() {
        names();
        channels();
        sides();
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
        for (const SensorNumber& number : geometry_numbers) turn(number);
        ImGui::PopStyleVar();
        gap(ui_, 8);
        choose("sensor.shape", &Sensor::shape);
        choose("sensor.response", &Sensor::response);
        if (!fold_row(ui_, "sensor.more", ui_.strings("sensors.more"), state_.sensor_quality_open)) return;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
        for (const SensorNumber& number : quality_numbers) turn(number);
        ImGui::PopStyleVar();
    }

private:
    // One button per sensor, as many in a row as fit; below them what the chosen one senses.
    void names() {
        const float right = ImGui::GetCursorScreenPos().x + card_width(ui_);
        bool first = true;
        for (const Sensor& sensor : kind_.sensors) {
            const std::string anchor = "sensor." + sensor.name;
            const SmallButton look{anchor, {}, sensor.name, &sensor == sensor_};
            if (!first && ImGui::GetItemRectMax().x + ui_.px(6) + small_button_width(ui_, look, true) <= right)
                ImGui::SameLine(0, ui_.px(6));
            first = false;
            const Item at = small_button(ui_, look);
            tooltip(ui_, at, senses(sensor));
            if (at.pressed) state_.sensor = sensor.name;
        }
        paragraph(ui_,
                  fill(ui_.strings("sensors.of"), {sensor_->name, senses(*sensor_), kind_name(view_, ui_, vehicle_)}),
                  ui_.palette.second_text, Face::small);
    }

    std::string_view senses(const Sensor& sensor) const {
        return ui_.strings.find("wiring.senses." + std::string(word(sensor.channel)), word(sensor.channel));
    }

    // The channel: a list of all channels, while it is unfolded.
    void channels() {
        if (!fold_row(ui_, "sensor.channel", ui_.strings("sensors.channel"), state_.sensor_channel_open)) return;
        const float right = ImGui::GetCursorScreenPos().x + card_width(ui_);
        bool first = true;
        for (const ChannelTraits& row : channel_table) {
            const Channel channel = row.value;
            const std::string_view word = row.word;
            const std::string anchor = "sensor.channel." + std::string(word);
            const SmallButton look{
                anchor, {}, ui_.strings.find("view.channel." + std::string(word), word), channel == sensor_->channel};
            if (!first && ImGui::GetItemRectMax().x + ui_.px(6) + small_button_width(ui_, look, true) <= right)
                ImGui::SameLine(0, ui_.px(6));
            first = false;
            if (!small_button(ui_, look).pressed || channel == sensor_->channel) continue;
            edit(++state_.sliders.gesture, [&, to = channel](Sensor& s, bool) { s.channel = to; });
        }
        gap(ui_, 4);
    }

    // Whether edits also apply, mirrored, to the sensor on the other side.
    void sides() {
        if (!find_sensor(kind_.sensors, other_side(sensor_->name))) return;
        const std::array words{ui_.strings("sensors.both"), ui_.strings("sensors.one")};
        const int chosen = segments(ui_, "sensor.sides", words, state_.sensor_alone ? 1 : 0, card_width(ui_));
        if (chosen >= 0) state_.sensor_alone = chosen == 1;
    }

    // One segment per row of the enumeration's table; the keys of their words are "sensors.WORD".
    template <class Enum>
    void choose(std::string_view anchor, Enum Sensor::*member) {
        std::vector<std::string_view> words;
        for (const auto& row : table_of(Enum{}))
            words.push_back(ui_.strings.find("sensors." + std::string(row.word), row.word));
        const int chosen = segments(ui_, anchor, words, static_cast<int>(sensor_->*member), card_width(ui_));
        if (chosen < 0) return;
        edit(++state_.sliders.gesture, [=](Sensor& s, bool) { s.*member = static_cast<Enum>(chosen); });
    }

    void turn(const SensorNumber& number) {
        const float value = sensor_->*number.value * number.factor;
        SliderLook look;
        look.words = ui_.strings(number.words);
        look.tooltip = ui_.strings(number.tooltip);
        look.low = number.low, look.high = number.high;
        if (number.stretches) {
            const float most = std::max(number.high, std::ceil(std::fabs(value)));
            look.high = most;
            if (number.low < 0) look.low = -most;
        }
        look.home = filed_ ? filed_->*number.value * number.factor : value;
        look.step = number.step, look.decimals = number.decimals, look.unit = number.unit;
        look.meaning = false;
        look.signed_number = number.low < 0;
        look.words_width = 84, look.number_width = 56;
        const auto wanted =
            slider(ui_, state_.sliders, number.anchor, value, card_width(ui_), view_.wall_seconds, look);
        if (!wanted) return;
        edit(wanted->gesture - gestures::panels, [&](Sensor& s, bool mirrored) {
            s.*number.value = wanted->value / number.factor * (mirrored && number.sided ? -1.0f : 1.0f);
        });
    }

    // Requests the change for the chosen sensor and, unless it is edited alone, for the one on the other side.
    template <class Change>
    void edit(std::uint64_t gesture, Change change) {
        std::vector<Sensor> sensors = kind_.sensors;
        change(*find_sensor(sensors, sensor_->name), false);
        if (!state_.sensor_alone)
            if (Sensor* other = find_sensor(sensors, other_side(sensor_->name))) change(*other, true);
        ui_.outbox.push_back(
            EditRequest{SetSensors{target_of(view_, vehicle_), std::move(sensors)}, gestures::panels + gesture});
    }

    const LabView& view_;
    PanelState& state_;
    Ui& ui_;
    const VehicleView& vehicle_;
    const Kind& kind_;
    const Sensor* sensor_ = nullptr;
    const Sensor* filed_ = nullptr;  // as the file has it
};

}  // namespace

void sensor_card(const LabView& view, PanelState& state, Ui& ui, Rect place) {
    const bool open = open_card(state, ui, Card::sensors, place);
    const VehicleView* vehicle = find_vehicle(*view.now, view.settings.selection.vehicle);
    const bool blind = !vehicle || kind_of(*view.now, *vehicle).sensors.empty();
    if (open && blind) paragraph(ui, ui.strings("sensors.none"), ui.palette.second_text);
    if (open && !blind) SensorEditor(view, state, ui, *vehicle).draw();
    end_card(state.card(Card::sensors));
}

}  // namespace braitenlab::ui
