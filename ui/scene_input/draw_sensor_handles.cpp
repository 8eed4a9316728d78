#include <string>
#include <vector>

#include <imgui.h>

#include "core/maths/angle.h"
#include "ui/scene_input/draw.h"
#include "ui/scene_input/sensor_handles.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

// The outline of a sensor's field, from its position along both arms.
void draw_field(const SceneInputFrame& frame, const Ui& ui, const VehicleView& vehicle, const Sensor& sensor,
                Colour colour) {
    if (!row_of(sensor.channel).has_field) return;
    const vec2 mount =
        vec2{vehicle.x, vehicle.y} + maths::rotate(vec2{sensor.x, sensor.y}, maths::direction(vehicle.heading));
    const bool is_round = sensor.shape == SensorShape::omni || sensor.fov > 2 * maths::pi - 0.01f;
    const float half = is_round ? maths::pi : sensor.fov / 2;
    const float range = sensor.channel == Channel::touch ? 1 : sensor.range;
    const int steps = sensor.shape == SensorShape::triangle ? 1 : 48;
    std::vector<ImVec2> points;
    const auto add = [&](vec2 place) {
        const auto at = project(frame.camera_view, place);
        if (at) points.push_back({at->x, at->y});
    };
    if (!is_round) add(mount);
    for (int i = 0; i <= steps; ++i) {
        const float angle = -half + 2 * half * static_cast<float>(i) / static_cast<float>(steps);
        add(mount + maths::from_polar(range, vehicle.heading + sensor.angle + angle));
    }
    draw_line(ui, points, colour, 1.5f, true);
}

// From the sensor to its handle, which is not on the arc where the arc is out of sight.
void draw_axis(const SceneInputFrame& frame, const Ui& ui, vec2 mount, vec2 handle) {
    const auto from = project(frame.camera_view, mount), to = project(frame.camera_view, handle);
    if (from && to) draw_line(ui, {{from->x, from->y}, {to->x, to->y}}, ui.palette.accent.with_alpha(0.4f), 1, false);
}

std::string note_words(const Ui& ui, const SensorHandleState& handles, const Sensor& sensor) {
    const SensorHandle handle = handles.drag.handle != SensorHandle::none ? handles.drag.handle : handles.hovered;
    const bool is_dragged = handles.drag.handle != SensorHandle::none;
    const auto degrees = [&](float radians) { return fixed(ui, maths::degrees(radians), 0) + "°"; };
    const auto named = [&](std::string_view key, const std::string& value) {
        return std::string(ui.strings(key)) + " " + value;
    };
    if (handle == SensorHandle::axis && !is_dragged) return std::string(ui.strings("scene_input.sensor_axis"));
    if (handle == SensorHandle::axis && handles.drag.axis == AxisDrag::range)
        return named("sensors.range", fixed(ui, sensor.range, 1) + " m");
    if (handle == SensorHandle::axis)
        return named("sensors.angle", with_sign(ui, maths::degrees(sensor.angle), 0) + "°");
    if (handle == SensorHandle::mount)
        return named("sensors.x", with_sign(ui, sensor.x, 2) + " m · ") +
               named("sensors.y", with_sign(ui, sensor.y, 2) + " m");
    return named("sensors.field", degrees(sensor.fov));
}

}  // namespace

void draw_sensor_handles(const SceneInputState& state, const SceneInputFrame& frame, const Ui& ui) {
    const auto places = sensor_handle_places(state, frame);
    const SensorHandleState& handles = state.sensors;
    const bool drags = handles.drag.handle != SensorHandle::none;
    const VehicleView* vehicle =
        places ? find_vehicle(*frame.view.now, drags ? handles.drag.vehicle : frame.view.settings.selection.vehicle)
               : nullptr;
    if (!vehicle) return;
    const Palette& p = ui.palette;
    if (places->opposite) draw_field(frame, ui, *vehicle, *places->opposite, p.accent.with_alpha(0.45f));
    draw_field(frame, ui, *vehicle, places->sensor, p.accent);
    if (places->axis) draw_axis(frame, ui, places->mount, *places->axis);
    const SensorHandle warm = drags ? handles.drag.handle : handles.hovered;
    const auto knob = [&](SensorHandle handle, const std::optional<vec2>& place) {
        if (place) draw_handle(frame, ui, *place, handle == warm, "handle." + std::string(word(handle)));
    };
    knob(SensorHandle::left, places->left);
    knob(SensorHandle::right, places->right);
    knob(SensorHandle::axis, places->axis);
    if (shows_mount(frame, places->mount)) knob(SensorHandle::mount, places->mount);
    if (warm != SensorHandle::none)
        draw_note(frame, ui, note_words(ui, handles, places->sensor), p.line, frame.pointer.at);
}

}  // namespace braitenlab::ui
