// Handles of a sensor's field in the scene: they change its direction, opening angle, range and position on the
// vehicle. Without Dear ImGui, except draw_sensor_handles().
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/maths/vec.h"
#include "core/world/command.h"
#include "ui/request.h"
#include "ui/widgets/ui.h"

namespace braitenlab {
struct LabView;
}

namespace braitenlab::ui {

struct SceneInputState;
struct SceneInputFrame;

// axis: in the middle of the arc; along the arc it turns the sensor, outwards it changes the range. left, right: ends
// of the arc; they change the opening angle. mount: the sensor's position.
enum class SensorHandle { none, axis, left, right, mount };
inline constexpr std::array<std::string_view, 5> sensor_handle_words{"none", "axis", "left", "right", "mount"};
static_assert(has_enumerators<SensorHandle, sensor_handle_words.size()>());
constexpr std::string_view word(SensorHandle handle) { return sensor_handle_words[static_cast<std::size_t>(handle)]; }

// What a drag of the handle `axis` changes; undecided until the pointer has moved by some pixels.
enum class AxisDrag { undecided, angle, range };

struct SensorDrag {
    SensorHandle handle = SensorHandle::none;  // none: no drag
    AxisDrag axis = AxisDrag::undecided;
    VehicleId vehicle = no_vehicle;
    Target target;                     // of the edits
    std::vector<Sensor> began;         // all sensors of the vehicle at the press
    std::vector<SetSensors> restored;  // by Esc: the target's sensors at the press, and the own ones of its vehicles
    std::string name, opposite;  // of the sensor and of that on the other side, which changes, too; empty: none does
    maths::vec2 press;           // of the pointer at the press, from the mount, in the vehicle's frame; m
    maths::vec2 press_pixel;     // window pixels
    std::uint64_t gesture = 0;
};

struct SensorHandleState {
    // Set by the window before each frame from the sensor card.
    bool shown = false;
    std::string sensor;  // name; the first sensor if the vehicle has none of this name
    bool alone = false;  // edits do not apply to the sensor on the other side

    SensorHandle hovered = SensorHandle::none;
    SensorDrag drag;
};

// Positions on the floor, m. A handle of the arc is nearer than the range where the arc is out of sight.
struct SensorHandlePlaces {
    Sensor sensor;
    std::optional<Sensor> opposite;  // that changes with it
    maths::vec2 mount;
    std::optional<maths::vec2> axis, left, right;  // none: the sensor has no range, or no direction
};

// nullopt: no handles are shown.
std::optional<SensorHandlePlaces> sensor_handle_places(const SceneInputState&, const SceneInputFrame&);

// False where the vehicle is too small for the handle `mount`.
bool shows_mount(const SceneInputFrame&, maths::vec2 mount);

// One frame of the mouse. True while it uses the mouse: from the press on a handle to the release.
bool use_sensor_handles(SceneInputState&, const SceneInputFrame&, Outbox&);

// Ends a drag and restores the sensors; false without a drag.
bool cancel_sensor_drag(SceneInputState&, const Snapshot&, Outbox&);

// Outlines of the fields, handles, and a note at the pointer. Anchors: handle.axis, handle.left, handle.right,
// handle.mount. draw_sensor_handles.cpp
void draw_sensor_handles(const SceneInputState&, const SceneInputFrame&, const Ui&);

}  // namespace braitenlab::ui
