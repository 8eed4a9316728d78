// The values of one kind on the card of the arena and the kinds.
#include "ui/panels/kind/kind_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <imgui.h>

#include "core/scene/driven_wheels.h"
#include "core/scene/population.h"
#include "core/scene/schema.h"
#include "ui/panels/panels.h"
#include "ui/scene_input/edits.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr int most_typed = 2000;  // vehicles of a kind that the slider offers

// A disc in the colour; the sign of the role for none. True when it was pressed.
bool colour_swatch(Ui& ui, const std::string& id, std::string_view colour, bool chosen, Role role, float size) {
    const Item at = item(ui, id, {size, size});
    const ImVec2 middle{at.middle_x(), at.middle_y()};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen || at.warmth > 0)
        list.AddCircle(middle, ui.px(10),
                       paint(chosen ? ui.palette.text : ui.palette.second_text.with_alpha(at.warmth)), 24, ui.px(1.5f));
    if (colour.empty())
        put_role(ui, middle, ui.px(13), role);
    else
        list.AddCircleFilled(middle, ui.px(7), paint(braitenlab::colour_of(colour).value_or(ui.palette.text)), 24);
    tooltip(ui, at, ui.strings(colour.empty() ? "values.colour_none" : "values.colour_how"));
    return at.pressed;
}

// Editing of one kind. All changes of a frame are one EditKind: the press that leaves a text field can also be the
// first one of a slider.
class KindEditor {
public:
    KindEditor(const LabView& view, PanelState& state, Ui& ui, int index)
        : view_(view),
          state_(state),
          ui_(ui),
          index_(index),
          kind_(view.now->scene->kinds[static_cast<std::size_t>(index)]),
          filed_(filed()) {}

    void draw() {
        if (!view_.lesson) name();
        count();
        choices();
        colours();
        if (fold("values.body", state_.values.body_open)) body();
        if (fold("values.realism", state_.values.realism_open)) realism();
        if (fold("values.memory", state_.values.memory_open)) memory();
        if (fold("values.lamps", state_.values.lamps_open)) lamps();
        if (fold("values.path", state_.values.path_open)) path();
        send();
    }

private:
    FieldRows rows() const { return rows_for(view_, state_, ui_); }
    bool fold(std::string_view id, bool& open) const { return fold_row(ui_, id, ui_.strings(id), open); }
    const Kind& filed() const {
        const Kind* known = filed_kind(view_, kind_.name);
        return known ? *known : kind_;
    }
    // The kind as changed in this frame.
    Kind& changed(std::uint64_t gesture) {
        if (!to_) to_ = kind_;
        gesture_ = gesture;
        return *to_;
    }
    void send() {
        if (to_) ui_.outbox.push_back(EditRequest{EditKind{index_, std::move(*to_)}, gesture_});
        for (EditRequest& edit : sensor_edits_) ui_.outbox.push_back(std::move(edit));
    }

    void name() {
        FieldRows row = rows();
        row.anchor = "kind." + kind_.name, row.words = "field.kind.";
        if (auto typed = row.text("name", kind_.name, limits::name_length))
            changed(row.next_gesture()).name = std::move(*typed);
    }

    void choices() {
        constexpr std::string_view shown[]{"driver", "role"};
        const auto edit = record_fields(rows(), kind_, filed_, shown);
        if (!edit) return;
        Kind& to = changed(edit->gesture);
        to.driver = edit->to.driver, to.role = edit->to.role;
    }

    void count() {
        const auto& all = view_.now->vehicles;
        const auto present =
            std::count_if(all.begin(), all.end(), [this](const VehicleView& v) { return v.kind == index_; });
        FieldRows row = rows();
        row.anchor = "kind", row.words = "field.kind.";
        const auto number = static_cast<float>(present), home = filed_number(number);
        const double most = std::max<double>({most_typed, number, home});
        const auto wanted = row.number({"count", "", {0, most}, number, home, true});
        if (wanted)
            ui_.outbox.push_back(EditRequest{SetPopulation{index_, static_cast<int>(wanted->value)}, wanted->gesture});
    }

    // The number of vehicles of the kind as a run of the file begins; `present` of a kind that the file lacks.
    float filed_number(float present) const {
        const int kind = view_.file ? find_kind(*view_.file, kind_.name) : -1;
        if (kind < 0) return present;
        const StartNumbers numbers = start_numbers(*view_.file);
        const auto k = static_cast<std::size_t>(kind);
        return static_cast<float>(numbers.with_start[k] + numbers.in_population[k]);
    }

    void colours() {
        const Role role = kind_.role == Role::wiring ? Role::none : kind_.role;
        if (const auto wanted = colour_row(rows(), "kind.colour.", kind_.colour, role))
            changed(rows().next_gesture()).colour = *wanted;
    }

    void body() {
        size();
        driven();
        constexpr std::string_view shown[]{"mass", "top_speed", "motor_force", "voltage", "nominal_voltage"};
        const auto edit = record_fields(rows(), kind_.body, filed_.body, shown);
        if (!edit) return;
        Body& to = changed(edit->gesture).body;
        to.mass = edit->to.mass, to.top_speed = edit->to.top_speed, to.motor_force = edit->to.motor_force;
        to.voltage = edit->to.voltage, to.nominal_voltage = edit->to.nominal_voltage;
    }

    void size() {
        constexpr std::string_view shown[]{"length", "width"};
        const auto edit = record_fields(rows(), kind_.body, filed_.body, shown);
        if (!edit) return;
        const float length = edit->to.length, width = edit->to.width;
        changed(edit->gesture).body = resized(kind_.body, length, width);
        change_sensors(edit->gesture, [&](Sensor& sensor) {  // the eyes stay at their places on the chassis
            sensor.x = std::clamp(sensor.x * length / kind_.body.length, -10.0f, 10.0f);
            sensor.y = std::clamp(sensor.y * width / kind_.body.width, -10.0f, 10.0f);
        });
    }

    // The places and sizes of the wheels with a motor.
    void driven() {
        const DrivenWheels now = driven_wheels(kind_.body), home = driven_wheels(filed_.body);
        if (now.track <= 0) return;
        FieldRows row = rows();
        row.anchor = "body", row.words = "field.body.";
        const auto track = row.number({"track", "m", {0.02, 20}, now.track, home.track});
        const auto radius = row.number({"wheel_radius", "m", {0.005, 5}, now.radius, home.radius});
        if (!track && !radius) return;
        Body& to = changed(track ? track->gesture : radius->gesture).body;
        to = with_driven_wheels(to, {track ? track->value : now.track, radius ? radius->value : now.radius});
    }

    // Changes each sensor of the kind and, as SetSensors of a kind discards them, each own sensor of its vehicles.
    template <class Change>
    void change_sensors(std::uint64_t gesture, Change change) {
        const auto add = [&](const Target& target, std::vector<Sensor> sensors) {
            for (Sensor& sensor : sensors) change(sensor);
            sensor_edits_.push_back({SetSensors{target, std::move(sensors)}, gesture});
        };
        add({.kind = index_}, kind_.sensors);
        for (const VehicleView& v : view_.now->vehicles)
            if (v.kind == index_ && v.design >= 0) add({.vehicle = v.id}, kind_of(*view_.now, v).sensors);
    }

    // What makes real robots differ from ideal ones.
    void realism() {
        constexpr std::string_view of_body[]{"mismatch", "dead_band"};
        if (const auto edit = record_fields(rows(), kind_.body, filed_.body, of_body)) {
            Body& to = changed(edit->gesture).body;
            to.mismatch = edit->to.mismatch, to.dead_band = edit->to.dead_band;
        }
        if (!kind_.sensors.empty()) {
            of_all_sensors("noise", &Sensor::noise);
            of_all_sensors("latency", &Sensor::latency);
        }
        constexpr std::string_view of_arena[]{"ambient"};
        FieldRows row = rows();
        row.anchor = "realism";
        const Arena& arena = view_.now->scene->arena;
        if (const auto edit = record_fields(row, arena, view_.file ? view_.file->arena : arena, of_arena))
            ui_.outbox.push_back(EditRequest{EditArena{edit->to}, edit->gesture});
    }

    void of_all_sensors(const char* key, float Sensor::*member) {
        FieldRows row = rows();
        row.anchor = "realism", row.words = "field.sensors.";
        float largest = 0;
        for (const Sensor& sensor : kind_.sensors) largest = std::max(largest, sensor.*member);
        const bool is_time = member == &Sensor::latency;
        const auto wanted = row.number({key, is_time ? "s" : "", {0, 1}, largest, 0});
        if (wanted) change_sensors(wanted->gesture, [&](Sensor& sensor) { sensor.*member = wanted->value; });
    }

    void memory() {
        if (const auto edit = record_fields(rows(), kind_.memory, filed_.memory))
            changed(edit->gesture).memory = edit->to;
    }

    // The lamps that each vehicle of the kind carries.
    void lamps() {
        for (std::size_t i = 0; i < kind_.lamps.size(); ++i) {
            FieldRows row = rows();
            row.anchor = "lamp." + std::to_string(i + 1);
            if (auto edit = record_fields(row, kind_.lamps[i], kind_.lamps[i])) {
                replace(&Kind::lamps, i, std::move(edit->to), edit->gesture);
                continue;
            }
            const std::string gone = row.anchor + ".remove";
            const bool pressed = small_push_button(ui_, {gone, {}, ui_.strings("values.lamp_remove")},
                                                   ui_.strings("values.lamp_remove"));
            gap(ui_, 10);
            if (pressed) remove(row, &Kind::lamps, i);
        }
        if (kind_.lamps.size() >= limits::lamps) return;
        if (!small_push_button(ui_, {"lamp.add", icon::add, ui_.strings("values.lamp_add")},
                               ui_.strings("values.lamp_add_how")))
            return;
        std::vector<CarriedLamp>& all = changed(rows().next_gesture()).lamps;
        const auto is_used = [&](const std::string& name) {
            return std::any_of(all.begin(), all.end(), [&](const CarriedLamp& l) { return l.name == name; });
        };
        std::string name = "lamp";
        for (int number = 2; is_used(name); ++number) name = "lamp-" + std::to_string(number);
        all.push_back({.name = name});
    }

    // Replaces or removes an element of the kind's lamps or waypoints. A removal in the same frame can have changed the
    // indices: then nothing is replaced.
    template <class Element>
    void replace(std::vector<Element> Kind::*list, std::size_t index, Element to, std::uint64_t gesture) {
        std::vector<Element>& all = changed(gesture).*list;
        if (all.size() == (kind_.*list).size()) all[index] = std::move(to);
    }
    template <class Element>
    void remove(const FieldRows& row, std::vector<Element> Kind::*list, std::size_t index) {
        std::vector<Element>& all = changed(row.next_gesture()).*list;
        if (all.size() == (kind_.*list).size()) all.erase(all.begin() + static_cast<std::ptrdiff_t>(index));
    }

    // The waypoints, each with a button that removes it, and one that adds another.
    void path() {
        paragraph(ui_, ui_.strings("values.path_how"), ui_.palette.second_text, Face::small);
        const Arena& arena = view_.now->scene->arena;
        for (std::size_t i = 0; i < kind_.waypoints.size(); ++i) {
            FieldRows row = rows();
            row.anchor = "waypoint." + std::to_string(i + 1);
            row.words = "field.waypoint.";
            row.words_width = 28;
            const std::string gone = row.anchor + ".remove", number = std::to_string(i + 1);
            put(ui_, ImGui::GetCursorScreenPos(), number, ui_.palette.second_text, Face::small);
            ImGui::SetCursorScreenPos(
                {ImGui::GetCursorScreenPos().x + card_width(ui_) - ui_.px(28), ImGui::GetCursorScreenPos().y});
            const Item at = small_button(ui_, {gone, icon::cross, "×"}, false);
            tooltip(ui_, at, ui_.strings("values.waypoint_remove"));
            const auto edit = waypoint(row, kind_.waypoints[i], arena);
            if (at.pressed)
                remove(row, &Kind::waypoints, i);
            else if (edit)
                replace(&Kind::waypoints, i, edit->to, edit->gesture);
        }
        if (push_button(ui_, "waypoint.add", {icon::add, ui_.strings("values.waypoint_add"), Emphasis::plain},
                        ui_.strings("values.path_how")) &&
            kind_.waypoints.size() < limits::waypoints) {
            const VehicleView* selected = selected_vehicle(view_);
            changed(rows().next_gesture())
                .waypoints.push_back(selected ? Waypoint{selected->x, selected->y} : Waypoint{});
        }
    }

    // The place of a waypoint within the arena.
    std::optional<RecordEdit<Waypoint>> waypoint(const FieldRows& row, const Waypoint& now, const Arena& arena) const {
        RecordEdit<Waypoint> edit{now};
        bool changed = false;
        const auto turn = [&](const char* key, float Waypoint::*member, float extent) {
            const double most = std::max<double>(extent / 2, std::fabs(now.*member));
            if (const auto wanted = row.number({key, "m", {-most, most}, now.*member, now.*member})) {
                edit.to.*member = wanted->value, edit.gesture = wanted->gesture;
                changed = true;
            }
        };
        turn("x", &Waypoint::x, arena.width);
        turn("y", &Waypoint::y, arena.height);
        return changed ? std::optional(edit) : std::nullopt;
    }

    const LabView& view_;
    PanelState& state_;
    Ui& ui_;
    int index_;
    const Kind& kind_;
    const Kind& filed_;  // as the file has it
    std::optional<Kind> to_;
    std::uint64_t gesture_ = 0;
    std::vector<EditRequest> sensor_edits_;  // sent after that of the kind
};

}  // namespace

FieldRows rows_for(const LabView& view, PanelState& state, Ui& ui) {
    return {ui, state.fields, state.sliders, view.wall_seconds};
}

std::optional<std::string> colour_row(const FieldRows& rows, const std::string& anchor, const std::string& now,
                                      Role role) {
    Ui& ui = rows.ui;
    const float size = ui.px(ui.tall(24)), left = ui.px(rows.words_width);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    put(ui, {at.x, at.y + (size - line_height(ui, Face::text)) / 2}, ui.strings("values.colour"), ui.palette.text);
    const int per_row = std::max(1, static_cast<int>((card_width(ui) - left) / size));
    std::optional<std::string> pressed;
    for (int i = 0; i <= static_cast<int>(std::size(body_colours)); ++i) {
        ImGui::SetCursorScreenPos(
            {at.x + left + size * static_cast<float>(i % per_row), at.y + size * static_cast<float>(i / per_row)});
        const std::string_view colour = i == 0 ? std::string_view{} : body_colours[static_cast<std::size_t>(i - 1)];
        if (colour_swatch(ui, anchor + std::to_string(i), colour, colour == now, role, size) && colour != now)
            pressed = colour;
    }
    gap(ui, 12);
    return pressed;
}

void kind_editor(const LabView& view, PanelState& state, Ui& ui, int kind) { KindEditor(view, state, ui, kind).draw(); }

}  // namespace braitenlab::ui
