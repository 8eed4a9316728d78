// The card of the sensors of the selected vehicle or of its kind: adding and removing them, position, direction,
// opening angle, range, and quality.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <variant>

#include <imgui.h>

#include "core/scene/check.h"
#include "core/scene/enums.h"
#include "core/scene/schema.h"
#include "core/scene/sensor_edits.h"
#include "ui/panels/cards.h"
#include "ui/panels/kind/kind_editor.h"
#include "ui/panels/panels.h"
#include "ui/panels/sensor_changes.h"
#include "ui/panels/signal_drag.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float degrees_per_radian = 57.295779513f;

// The channel, the side and the number at the end of the name.
std::string channel_and_side(const Ui& ui, const Sensor& sensor) {
    const std::string_view channel =
        ui.strings.find("view.channel." + std::string(word(sensor.channel)), word(sensor.channel));
    const float side = sensor.y != 0 ? sensor.y : sensor.angle;
    const std::string number = sensor.name.substr(sensor.name.find_last_not_of("0123456789") + 1);
    const std::string words =
        side == 0 ? std::string(channel) : fill(ui.strings(side > 0 ? "sensors.left" : "sensors.right"), {channel});
    return number.empty() ? words : words + " " + number;
}

// One number of a sensor as a slider shows it.
struct SensorNumber {
    std::string_view anchor, words, tooltip;  // the latter two are keys of strings
    std::variant<float Sensor::*, int Sensor::*> value;
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
constexpr std::string_view half_distance = "sensors.half_distance";
constexpr SensorNumber quality_numbers[]{
    {"sensor.half_distance", half_distance, "sensors.half_distance_how", &Sensor::half_distance, 0.1f, 20, 1, 0.1f, 1,
     " m", false, true},
    {"sensor.noise", "sensors.noise", "sensors.noise_how", &Sensor::noise, 0, 1},
    {"sensor.latency", "sensors.latency", "sensors.latency_how", &Sensor::latency, 0, 1, 1, 0.01f, 2, " s"},
    {"sensor.interval", "sensors.interval", "sensors.interval_how", &Sensor::interval, 0, 1, 1, 0.01f, 2, " s"},
    {"sensor.bits", "sensors.bits", "sensors.bits_how", &Sensor::bits, 0, limits::converter_bits, 1, 1, 0, " bit"},
};
constexpr SensorNumber half_lux_number{"sensor.half_lux",
                                       "sensors.half_lux",
                                       "sensors.half_lux_how",
                                       &Sensor::half_lux,
                                       0.1f,
                                       1000,
                                       1,
                                       1,
                                       0,
                                       " lx",
                                       false,
                                       true};

float value_of(const Sensor& sensor, const SensorNumber& number) {
    return number.factor * std::visit([&](auto member) { return static_cast<float>(sensor.*member); }, number.value);
}

void set_value(Sensor& sensor, const SensorNumber& number, float shown) {
    if (const auto* count = std::get_if<int Sensor::*>(&number.value))
        sensor.** count = static_cast<int>(std::lround(shown / number.factor));
    else
        sensor.*std::get<float Sensor::*>(number.value) = shown / number.factor;
}

// The width of the words of these sliders, so that their tracks begin in one line; layout pixels.
float words_width_of(const Ui& ui, std::span<const SensorNumber> numbers) {
    constexpr float space = 8;
    float widest = 0;
    for (const SensorNumber& number : numbers)
        widest = std::max(widest, text_width(ui, Face::text, ui.strings(number.words)));
    return widest / ui.px(1) + space;
}

class SensorEditor {
public:
    SensorEditor(const LabView& view, PanelState& state, Ui& ui, const VehicleView& vehicle)
        : view_(view), state_(state), ui_(ui), vehicle_(vehicle), kind_(kind_of(*view.now, vehicle)) {
        if (kind_.sensors.empty()) return;
        sensor_ = find_sensor(kind_.sensors, state.sensors.shown);
        if (!sensor_) sensor_ = &kind_.sensors.front();
        opposite_ = opposite_of(kind_.sensors, sensor_->name);
        if (const Kind* filed = filed_kind(view, vehicle)) filed_ = find_sensor(filed->sensors, sensor_->name);
    }

    void draw() {
        scope_choice(view_, ui_, vehicle_, "sensor.scope", ui_.strings("sensors.scope_how"));
        own_sensors();
        if (sensor_)
            names();
        else
            paragraph(ui_, ui_.strings("sensors.blind"), ui_.palette.second_text, Face::small);
        const bool turns_first = view_.lesson && sensor_;  // what an exercise asks for; its card leaves little height
        if (turns_first) geometry();
        more_sensors();
        if (!sensor_) return;
        channels();
        sides();
        if (!turns_first) geometry();
        choose("sensor.shape", &Sensor::shape);
        response();
        if (!fold_row(ui_, "sensor.more", ui_.strings("sensors.more"), state_.sensors.quality_open)) return;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
        words_width_ = words_width_of(ui_, quality_numbers);
        for (const SensorNumber& number : quality_numbers)
            if (number.words != half_distance || has_half_distance()) turn(number);
        ImGui::PopStyleVar();
    }

private:
    void geometry() {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
        words_width_ = words_width_of(ui_, geometry_numbers);
        for (const SensorNumber& number : geometry_numbers) turn(number);
        ImGui::PopStyleVar();
        gap(ui_, 8);
    }

    // That the vehicle does not have the sensors of its kind, with a button that gives it those again.
    void own_sensors() {
        if (vehicle_.design < 0) return;
        paragraph(ui_, ui_.strings("sensors.own"), ui_.palette.second_text, Face::small);
        if (!small_push_button(ui_, {"sensor.as_kind", icon::undo, ui_.strings("sensors.as_kind")},
                               ui_.strings("sensors.as_kind_how")))
            return;
        const auto& of_kind = view_.now->scene->kinds[static_cast<std::size_t>(vehicle_.kind)].sensors;
        ui_.outbox.push_back(EditRequest{SetSensors{{.vehicle = vehicle_.id}, of_kind}, next_gesture()});
    }

    // Buttons that add, mirror and remove sensors, and the channels of a new one.
    void more_sensors() {
        const auto pressed = [&](const SmallButton& look, std::string_view how, bool first = false) {
            const float right = ImGui::GetCursorScreenPos().x + card_width(ui_);
            if (!first) beside_or_below(ui_, small_button_width(ui_, look, true), right);
            return small_push_button(ui_, look, ui_.strings(how));
        };
        if (pressed({"sensor.add", icon::add, ui_.strings("sensors.add"), state_.sensors.adding}, "sensors.add_how",
                    true))
            state_.sensors.adding = !state_.sensors.adding;
        const bool has_image = sensor_ && (sensor_->y != 0 || sensor_->angle != 0);
        if (has_image && pressed({"sensor.mirror", icon::mirror, ui_.strings("sensors.mirror")}, "sensors.mirror_how"))
            set(with_mirror_image(kind_.sensors, sensor_->name));
        if (sensor_ && pressed({"sensor.remove", icon::remove, ui_.strings("sensors.remove")}, "sensors.remove_how"))
            set(without_chosen());
        if (state_.sensors.adding) new_channels();
        gap(ui_, 4);
    }

    void new_channels() {
        const std::array words{ui_.strings("sensors.pair"), ui_.strings("sensors.single")};
        const int chosen = segments(ui_, "sensor.new.sides", words, state_.sensors.single ? 1 : 0, card_width(ui_));
        if (chosen >= 0) state_.sensors.single = chosen == 1;
        const std::optional<Channel> channel = channel_buttons("sensor.new.", nullptr);
        if (!channel) return;
        const bool as_pair = row_of(*channel).is_paired && !state_.sensors.single;
        const std::vector<Sensor> added = new_sensors(kind_.sensors, *channel, as_pair, names_taken(view_, vehicle_));
        set(with_sensors(kind_.sensors, added));
        state_.sensors.shown = added.front().name;
        state_.sensors.adding = false;
    }

    // The chosen sensor and, unless it is edited alone, that on the other side are removed.
    std::vector<Sensor> without_chosen() const {
        std::vector<Sensor> sensors = kind_.sensors;
        std::erase_if(sensors, [&](const Sensor& s) {
            return s.name == sensor_->name || (!state_.sensors.alone && s.name == opposite_);
        });
        return sensors;
    }

    std::uint64_t next_gesture() { return gestures::panels + ++state_.sliders.gesture; }
    void set(std::vector<Sensor> sensors) {
        request_sensors(view_, ui_.outbox, vehicle_, std::move(sensors), next_gesture());
    }

    // One button per sensor, as many in a row as fit; below them what the chosen one senses.
    void names() {
        const float right = ImGui::GetCursorScreenPos().x + card_width(ui_);
        bool first = true;
        for (const Sensor& sensor : kind_.sensors) {
            const std::string anchor = "sensor." + sensor.name;
            const std::string words = sensor_label(ui_, kind_.sensors, sensor);
            const SmallButton look{anchor, {}, words, &sensor == sensor_};
            if (!first) beside_or_below(ui_, small_button_width(ui_, look, true), right);
            first = false;
            const Item at = small_button(ui_, look);
            tooltip(ui_, at, senses(sensor));
            drag_signal(state_, ui_, at.held, sensor.name);
            if (at.pressed) state_.sensors.shown = sensor.name;
        }
        paragraph(ui_,
                  fill(ui_.strings("sensors.of"), {sensor_->name, senses(*sensor_), kind_name(view_, ui_, vehicle_)}),
                  ui_.palette.second_text, Face::small);
        if (!view_.lesson) name();  // hints of an exercise use the names
    }

    // The name of the chosen sensor. A name that is not possible is refused with a notice.
    void name() {
        FieldRows row = rows_for(view_, state_, ui_);
        row.anchor = "sensor." + sensor_->name, row.words = "sensors.", row.words_width = 84;
        const auto typed = row.text("name", sensor_->name, limits::name_length);
        if (!typed || *typed == sensor_->name) return;
        if (name_fault(*typed)) return ui_.outbox.push_back(NoticeRequest{"notice.bad_name", *typed, {}});
        if (is_name_taken(view_, vehicle_, *typed))
            return ui_.outbox.push_back(NoticeRequest{"notice.name_taken", *typed, {}});
        request_renamed_sensor(view_, ui_.outbox, vehicle_, sensor_->name, *typed, next_gesture());
        state_.sensors.shown = *typed;
    }

    std::string_view senses(const Sensor& sensor) const {
        return ui_.strings.find("wiring.senses." + std::string(word(sensor.channel)), word(sensor.channel));
    }

    // The channel: a list of all channels, while it is unfolded.
    void channels() {
        if (!fold_row(ui_, "sensor.channel", ui_.strings("sensors.channel"), state_.sensors.channel_open)) return;
        const std::optional<Channel> chosen = channel_buttons("sensor.channel.", &sensor_->channel);
        if (chosen && *chosen != sensor_->channel)
            edit(++state_.sliders.gesture, [to = *chosen](Sensor& s, bool) { s.channel = to; });
        gap(ui_, 4);
    }

    // One button per channel, with the anchor `prefix` and the channel's word; the channel whose button is pressed.
    std::optional<Channel> channel_buttons(const std::string& prefix, const Channel* shown) {
        const float right = ImGui::GetCursorScreenPos().x + card_width(ui_);
        std::optional<Channel> pressed;
        for (const ChannelTraits& row : channel_table) {
            const std::string anchor = prefix + std::string(row.word);
            const SmallButton look{anchor,
                                   {},
                                   ui_.strings.find("view.channel." + std::string(row.word), row.word),
                                   shown && row.value == *shown};
            const bool is_first = &row == &channel_table.front();
            if (!is_first) beside_or_below(ui_, small_button_width(ui_, look, true), right);
            if (small_button(ui_, look).pressed) pressed = row.value;
        }
        return pressed;
    }

    // Whether edits also apply, mirrored, to the sensor on the other side.
    void sides() {
        if (opposite_.empty()) return;
        const std::array words{ui_.strings("sensors.both"), ui_.strings("sensors.one")};
        const int chosen = segments(ui_, "sensor.sides", words, state_.sensors.alone ? 1 : 0, card_width(ui_));
        if (chosen >= 0) state_.sensors.alone = chosen == 1;
    }

    // The card offers two laws. Photocells and tables are of measured sensors, whose files give their other numbers.
    void response() {
        const SensorResponse now = sensor_->response;
        if (now == SensorResponse::graded || now == SensorResponse::boolean)
            return choose("sensor.response", &Sensor::response, 2);
        paragraph(ui_, ui_.strings("sensors." + std::string(word(now))), ui_.palette.second_text, Face::small);
        if (now != SensorResponse::photocell) return;
        words_width_ = words_width_of(ui_, std::span(&half_lux_number, 1));
        turn(half_lux_number);
    }

    // Whether the distance of half the reading decides a reading: that of a photocell depends on it only by sources of
    // which no intensity in candela is known.
    bool has_half_distance() const {
        if (sensor_->response == SensorResponse::graded) return true;
        if (sensor_->response != SensorResponse::photocell) return false;
        const auto is_by_strength = [](const auto& lamp) { return lamp.candela <= 0; };
        const Scene& scene = *view_.now->scene;
        return std::any_of(scene.sources.begin(), scene.sources.end(), is_by_strength) ||
               std::any_of(scene.kinds.begin(), scene.kinds.end(), [&](const Kind& kind) {
                   return std::any_of(kind.lamps.begin(), kind.lamps.end(), is_by_strength);
               });
    }

    // One segment per row of the enumeration's table, up to `most`; the keys of their words are "sensors.WORD".
    template <class Enum>
    void choose(std::string_view anchor, Enum Sensor::*member, std::size_t most = 8) {
        std::vector<std::string_view> words;
        for (const auto& row : table_of(Enum{}))
            if (words.size() < most) words.push_back(ui_.strings.find("sensors." + std::string(row.word), row.word));
        const int chosen = segments(ui_, anchor, words, static_cast<int>(sensor_->*member), card_width(ui_));
        if (chosen < 0) return;
        edit(++state_.sliders.gesture, [=](Sensor& s, bool) { s.*member = static_cast<Enum>(chosen); });
    }

    void turn(const SensorNumber& number) {
        const float value = value_of(*sensor_, number);
        SliderLook look;
        look.words = ui_.strings(number.words);
        look.tooltip = ui_.strings(number.tooltip);
        look.low = number.low, look.high = number.high;
        if (number.stretches) {
            const float most = std::max(number.high, std::ceil(std::fabs(value)));
            look.high = most;
            if (number.low < 0) look.low = -most;
        }
        look.home = filed_ ? value_of(*filed_, number) : value;
        look.step = number.step, look.decimals = number.decimals, look.unit = number.unit;
        look.whole = std::holds_alternative<int Sensor::*>(number.value);
        look.meaning = false;
        look.signed_number = number.low < 0;
        look.words_width = words_width_, look.number_width = 52;
        const auto wanted =
            slider(ui_, state_.sliders, number.anchor, value, card_width(ui_), view_.wall_seconds, look);
        if (!wanted) return;
        edit(wanted->gesture - gestures::panels, [&](Sensor& s, bool mirrored) {
            set_value(s, number, mirrored && number.sided ? -wanted->value : wanted->value);
        });
    }

    // Requests the change for the chosen sensor and, unless it is edited alone, for the one on the other side.
    template <class Change>
    void edit(std::uint64_t gesture, Change change) {
        std::vector<Sensor> sensors = kind_.sensors;
        change(*find_sensor(sensors, sensor_->name), false);
        if (!state_.sensors.alone)
            if (Sensor* other = find_sensor(sensors, opposite_)) change(*other, true);
        ui_.outbox.push_back(
            EditRequest{SetSensors{target_of(view_, vehicle_), std::move(sensors)}, gestures::panels + gesture});
    }

    const LabView& view_;
    PanelState& state_;
    Ui& ui_;
    const VehicleView& vehicle_;
    const Kind& kind_;
    const Sensor* sensor_ = nullptr;  // null: there is none
    std::string opposite_;            // name of the sensor on the other side; empty: there is none
    const Sensor* filed_ = nullptr;   // as the file has it
    float words_width_ = 0;           // layout pixels
};

}  // namespace

std::string sensor_label(const Ui& ui, const std::vector<Sensor>& all, const Sensor& sensor) {
    if (!wiring::has_code_as_name(sensor)) return sensor.name;
    std::string words = channel_and_side(ui, sensor);
    const bool is_ambiguous = std::any_of(all.begin(), all.end(), [&](const Sensor& other) {
        return other.name != sensor.name && wiring::has_code_as_name(other) && channel_and_side(ui, other) == words;
    });
    return is_ambiguous ? words + " (" + sensor.name + ")" : words;
}

void sensor_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect) {
    const bool open = open_card(state, ui, Card::sensors, place);
    const VehicleView* vehicle = selected_vehicle(view);
    if (open && !vehicle) paragraph(ui, ui.strings("sensors.none"), ui.palette.second_text);
    if (open && vehicle) SensorEditor(view, state, ui, *vehicle).draw();
    end_card(ui, state.card(Card::sensors));
}

}  // namespace braitenlab::ui
