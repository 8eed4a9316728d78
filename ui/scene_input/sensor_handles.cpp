#include "ui/scene_input/sensor_handles.h"

#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "core/maths/degrees.h"
#include "core/scene/sensor_edits.h"
#include "ui/scene_input/handles.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

// Layout pixels.
constexpr float least_distance = 36;    // of a handle of the arc from the mount
constexpr float edge_distance = 56;     // of a handle from the border of the scene, where tools are
constexpr float decides_after = 5;      // of movement: whether the axis turns or changes the range
constexpr float mount_from_scale = 45;  // pixels per metre; below, the vehicle is too small for the handle `mount`

constexpr double shift_step = 15;  // degrees
constexpr float full_circle = 2 * maths::pi;

bool has_field(const Sensor& sensor) { return row_of(sensor.channel).has_field; }
bool has_range(const Sensor& sensor) { return has_field(sensor) && sensor.channel != Channel::touch; }
bool has_direction(const Sensor& sensor) { return has_field(sensor) && sensor.shape != SensorShape::omni; }

vec2 to_floor(const VehicleView& vehicle, vec2 local) {
    return vec2{vehicle.x, vehicle.y} + maths::rotate(local, maths::direction(vehicle.heading));
}
vec2 to_vehicle(const VehicleView& vehicle, vec2 place) {
    return maths::rotate(place - vec2{vehicle.x, vehicle.y}, maths::direction(-vehicle.heading));
}

// The farthest point in this direction, at most `range` away, that no card covers.
vec2 visible_point(const SceneInputFrame& frame, vec2 from, vec2 direction, float range) {
    const float scale = pixels_per_metre(frame.camera_view, from), margin = edge_distance * frame.scale;
    const float least = scale > 0 ? least_distance * frame.scale / scale : 1;
    const Rect& area = frame.area;
    float distance = std::max(range, least);
    for (; distance > least; distance *= 0.9f) {
        const auto at = project(frame.camera_view, from + direction * distance);
        if (at && at->x > area.x + margin && at->x < area.x + area.w - margin && at->y > area.y + margin &&
            at->y < area.y + area.h - margin)
            break;
    }
    return from + direction * std::max(distance, least);
}

// The selected vehicle, or the one whose sensor is dragged, if its sensors can have handles.
const VehicleView* vehicle_with_handles(const SceneInputState& state, const SceneInputFrame& frame) {
    const LabView& view = frame.view;
    const bool drags = state.sensors.drag.handle != SensorHandle::none;
    const bool shows = state.sensors.shown && shows_handles(state, view);
    if (!shows && !drags) return nullptr;
    return find_vehicle(*view.now, drags ? state.sensors.drag.vehicle : view.settings.selection.vehicle);
}

SensorHandle handle_at(const SensorHandlePlaces& places, const SceneInputFrame& frame) {
    NearestHandle<SensorHandle> search{frame};
    search.offer(SensorHandle::axis, places.axis);
    search.offer(SensorHandle::left, places.left);
    search.offer(SensorHandle::right, places.right);
    if (shows_mount(frame, places.mount)) search.offer(SensorHandle::mount, places.mount);
    return search.found;
}

float rounded(float value, float steps_per_unit) { return std::round(value * steps_per_unit) / steps_per_unit; }

// The pointer from the mount at the press, in the vehicle's frame.
vec2 from_mount(const VehicleView& vehicle, const Sensor& sensor, vec2 floor) {
    return to_vehicle(vehicle, floor) - vec2{sensor.x, sensor.y};
}

// Decides by the first pixels of the movement: across the axis it turns the sensor, along the axis it changes the
// range, until the pointer is beyond the mount.
void decide_axis(SensorDrag& drag, const Sensor& began, const SceneInputFrame& frame, vec2 pointer) {
    // Pulled straight across the mount, the axis points to the other side.
    if (drag.axis == AxisDrag::range && has_direction(began) && maths::dot(drag.press, pointer) < 0)
        drag.axis = AxisDrag::angle;
    if (drag.axis != AxisDrag::undecided) return;
    if (!has_range(began)) return void(drag.axis = AxisDrag::angle);
    if (!has_direction(began)) return void(drag.axis = AxisDrag::range);
    if (maths::distance(frame.pointer.at, drag.press_pixel) < decides_after * frame.scale) return;
    const vec2 axis = maths::direction(began.angle), moved = pointer - drag.press;
    const bool turns = std::fabs(maths::cross(axis, moved)) >= std::fabs(maths::dot(axis, moved));
    drag.axis = turns ? AxisDrag::angle : AxisDrag::range;
}

// The sensor after the drag up to this pointer, given from the mount at the press.
Sensor dragged(const SensorDrag& drag, Sensor sensor, const Body& body, vec2 pointer, bool snaps) {
    const auto bearing = [](vec2 v) { return maths::arctangent2(v.y, v.x); };
    const float least = maths::from_degrees(1);
    if (drag.handle == SensorHandle::mount) {
        const vec2 moved = pointer - drag.press;
        const float far_x = body.length / 2 + 0.3f, far_y = body.width / 2 + 0.3f;
        sensor.x = std::clamp(rounded(sensor.x + moved.x, 100), -far_x, far_x);
        sensor.y = std::clamp(rounded(sensor.y + moved.y, 100), -far_y, far_y);
    } else if (drag.handle == SensorHandle::axis && drag.axis == AxisDrag::angle) {
        const float turned = sensor.angle + bearing(pointer) - bearing(drag.press);
        sensor.angle = maths::to_degree_steps(maths::wrap_angle(turned), snaps ? shift_step : 1);
    } else if (drag.handle == SensorHandle::axis && drag.axis == AxisDrag::range) {
        const vec2 axis = maths::direction(bearing(drag.press));
        const float grown = std::max(0.0f, maths::dot(axis, pointer)) / std::max(1e-3f, maths::length(drag.press));
        sensor.range = std::clamp(rounded(sensor.range * grown, 10), 0.1f, 100.0f);
    } else if (drag.handle == SensorHandle::left || drag.handle == SensorHandle::right) {
        const float side = drag.handle == SensorHandle::left ? 1.0f : -1.0f;
        float half = side * maths::wrap_angle(bearing(pointer) - sensor.angle);
        if (half < 0) half = half < -maths::pi / 2 ? maths::pi : 0;
        const float most = sensor.shape == SensorShape::triangle ? maths::radians(179) : full_circle;
        sensor.fov = std::clamp(maths::to_degree_steps(2 * half, snaps ? shift_step : 1), least, most);
    }
    return sensor;
}

// All sensors at the press, with the dragged one replaced, and the same numbers, mirrored, of the one on the other
// side.
std::vector<Sensor> replaced(const SensorDrag& drag, const Sensor& to) {
    std::vector<Sensor> sensors = drag.began;
    for (Sensor& sensor : sensors) {
        if (sensor.name == drag.name) sensor = to;
        if (sensor.name != drag.opposite) continue;
        const Sensor& from = *find_sensor(drag.began, drag.name);
        if (to.x != from.x) sensor.x = to.x;
        if (to.y != from.y) sensor.y = -to.y;
        if (to.angle != from.angle) sensor.angle = -to.angle;
        if (to.fov != from.fov) sensor.fov = to.fov;
        if (to.range != from.range) sensor.range = to.range;
    }
    return sensors;
}

// The commands that restore the sensors of the target and, for a kind, the own sensors of its vehicles.
std::vector<SetSensors> present_sensors(const Snapshot& now, const Target& target) {
    if (target.vehicle != no_vehicle) return {{target, kind_of(now, *find_vehicle(now, target.vehicle)).sensors}};
    std::vector<SetSensors> all{{target, now.scene->kinds[static_cast<std::size_t>(target.kind)].sensors}};
    for (const VehicleView& v : now.vehicles)
        if (v.kind == target.kind && v.design >= 0) all.push_back({{.vehicle = v.id}, kind_of(now, v).sensors});
    return all;
}

void begin_sensor_drag(SceneInputState& state, const SceneInputFrame& frame, const SensorHandlePlaces& places,
                       const VehicleView& vehicle, vec2 floor) {
    SensorDrag& drag = state.sensors.drag;
    drag = {};
    drag.handle = state.sensors.hovered;
    drag.vehicle = vehicle.id;
    drag.target = target_of(frame.view, vehicle);
    drag.began = kind_of(*frame.view.now, vehicle).sensors;
    drag.restored = present_sensors(*frame.view.now, drag.target);
    drag.name = places.sensor.name;
    if (places.opposite) drag.opposite = places.opposite->name;
    drag.press = from_mount(vehicle, places.sensor, floor);
    drag.press_pixel = frame.pointer.at;
    drag.gesture = gestures::viewport + ++state.gesture;
    state.drag = {};
    state.drag.phase = SceneInputPhase::handle;
}

}  // namespace

std::optional<SensorHandlePlaces> sensor_handle_places(const SceneInputState& state, const SceneInputFrame& frame) {
    const VehicleView* vehicle = vehicle_with_handles(state, frame);
    if (!vehicle) return std::nullopt;
    const std::vector<Sensor>& sensors = kind_of(*frame.view.now, *vehicle).sensors;
    if (sensors.empty()) return std::nullopt;
    const Sensor* chosen_sensor = find_sensor(sensors, state.sensors.sensor);
    SensorHandlePlaces places{.sensor = chosen_sensor ? *chosen_sensor : sensors.front(), .opposite = {}, .mount = {}};
    const Sensor& sensor = places.sensor;
    const Sensor* opposite = state.sensors.alone ? nullptr : find_sensor(sensors, opposite_of(sensors, sensor.name));
    if (opposite) places.opposite = *opposite;
    places.mount = to_floor(*vehicle, {sensor.x, sensor.y});
    const auto at = [&](float angle) {
        return visible_point(frame, places.mount, maths::direction(vehicle->heading + sensor.angle + angle),
                             has_range(sensor) ? sensor.range : 1);
    };
    if (has_field(sensor)) places.axis = at(0);
    if (has_direction(sensor) && sensor.fov < full_circle - 0.01f)
        places.left = at(sensor.fov / 2), places.right = at(-sensor.fov / 2);
    else if (has_direction(sensor))
        places.left = at(maths::pi);  // a full circle is narrowed by one handle
    return places;
}

bool shows_mount(const SceneInputFrame& frame, vec2 mount) {
    return pixels_per_metre(frame.camera_view, mount) >= mount_from_scale * frame.scale;
}

bool use_sensor_handles(SceneInputState& state, const SceneInputFrame& frame, Outbox& outbox) {
    SensorHandleState& handles = state.sensors;
    SensorDrag& drag = handles.drag;
    const VehicleView* vehicle = vehicle_with_handles(state, frame);
    const auto places = sensor_handle_places(state, frame);
    const auto floor = floor_at(frame);
    if (drag.handle == SensorHandle::none) {
        const bool is_free = places && frame.pointer.over && state.drag.phase == SceneInputPhase::idle;
        handles.hovered = is_free ? handle_at(*places, frame) : SensorHandle::none;
        if (handles.hovered == SensorHandle::none || !frame.pointer.left_pressed || !floor) return false;
        begin_sensor_drag(state, frame, *places, *vehicle, *floor);
        return true;
    }
    if (!vehicle || !places || !frame.pointer.left_down) {
        drag = {}, state.drag = {};
        return true;
    }
    const Sensor* began = find_sensor(drag.began, drag.name);
    if (!floor || !began) return true;
    const vec2 pointer = from_mount(*vehicle, *began, *floor);
    if (drag.handle == SensorHandle::axis) decide_axis(drag, *began, frame, pointer);
    const Kind& kind = kind_of(*frame.view.now, *vehicle);
    std::vector<Sensor> wanted = replaced(drag, dragged(drag, *began, kind.body, pointer, frame.pointer.shift));
    if (wanted != kind.sensors) outbox.push_back(EditRequest{SetSensors{drag.target, std::move(wanted)}, drag.gesture});
    return true;
}

bool cancel_sensor_drag(SceneInputState& state, const Snapshot& now, Outbox& outbox) {
    SensorDrag& drag = state.sensors.drag;
    if (drag.handle == SensorHandle::none) return false;
    for (SetSensors& set : drag.restored)
        if (set.target.vehicle == no_vehicle || find_vehicle(now, set.target.vehicle))
            outbox.push_back(EditRequest{std::move(set), drag.gesture});
    drag = {}, state.drag = {};
    return true;
}

}  // namespace braitenlab::ui
