#include "ui/scene_input/scene_input.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "core/maths/angle.h"
#include "core/maths/degrees.h"
#include "ui/scene_input/draw.h"
#include "ui/scene_input/draw_insight.h"
#include "ui/scene_input/draw_lesson.h"
#include "ui/scene_input/draw_outside.h"
#include "ui/scene_input/edits.h"
#include "ui/scene_input/interaction.h"
#include "ui/scene_input/path_drawing.h"
#include "ui/scene_input/point_handles.h"
#include "ui/scene_input/polygon_tool.h"
#include "ui/scene_input/sensor_handles.h"
#include "ui/scene_input/tools.h"
#include "ui/scene_input/trail_moments.h"
#include "ui/scene_input/under_pointer.h"

namespace braitenlab::ui {

using maths::vec2;

namespace {

constexpr float nudge_step = 0.1f, fine_nudge = 0.01f;         // m
constexpr float crosshair_step = 0.5f, fine_crosshair = 0.1f;  // m
constexpr float path_step = 0.25f, fine_path_step = 0.1f;      // m
constexpr float key_turn = maths::radians(5);
constexpr double nudge_pause = 1;  // s without a key ends a gesture

// True if the right button opens the menu of the scene: also where another menu is open, which the press closes.
bool right_press(const SceneInputState& state, Rect area) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool reaches =
        !io.WantCaptureMouseUnlessPopupClose || (state.below_menu && area.contains(io.MousePos.x, io.MousePos.y));
    return ImGui::IsMouseClicked(ImGuiMouseButton_Right) && reaches;
}

SceneInputPointer current_pointer(const SceneInputState& state, Rect area) {
    const ImGuiIO& io = ImGui::GetIO();
    SceneInputPointer pointer;
    pointer.at = {io.MousePos.x, io.MousePos.y};
    pointer.right_pressed = right_press(state, area);
    pointer.over = (!io.WantCaptureMouse || pointer.right_pressed || state.drag.phase != SceneInputPhase::idle) &&
                   ImGui::IsMousePosValid();
    pointer.left_pressed = !io.WantCaptureMouse && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
    pointer.left_double = !io.WantCaptureMouse && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    pointer.middle_pressed = !io.WantCaptureMouse && ImGui::IsMouseClicked(ImGuiMouseButton_Middle);
    pointer.left_down = io.MouseDown[0], pointer.right_down = io.MouseDown[1], pointer.middle_down = io.MouseDown[2];
    pointer.shift = io.KeyShift;
    return pointer;
}

// Shows the hand cursor over an object that a press would take, and during a drag. (GLFW 3.3 has no cursor for moving.)
void show_cursor(const SceneInputState& state) {
    const SceneInputPhase phase = state.drag.phase;
    const bool busy = phase == SceneInputPhase::move || phase == SceneInputPhase::turn || phase == SceneInputPhase::pan;
    const bool on_handle =
        phase == SceneInputPhase::handle || state.sensors.hovered != SensorHandle::none || state.points.hovered;
    if (busy || on_handle || state.hovered || state.trail_moment) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

// The axis of the floor nearest to a direction on the screen, so that arrow keys move objects along grid lines.
vec2 floor_direction(const CameraView& camera_view, int key) {
    const vec2 right{camera_view.view[0][0], -camera_view.view[2][0]}, up{-right.y, right.x};
    const vec2 way = key == key::right ? right : key == key::left ? -right : key == key::up ? up : -up;
    if (std::fabs(way.x) > std::fabs(way.y)) return {way.x > 0 ? 1.0f : -1.0f, 0};
    return {0, way.y > 0 ? 1.0f : -1.0f};
}

bool is_arrow_key(int key) { return key == key::left || key == key::right || key == key::up || key == key::down; }

// Moves each of the selected objects to `to(pose)`. Quick presses are one gesture.
template <class To>
bool put_by_key(const LabView& view, SceneInputState& state, To to, Outbox& outbox) {
    const SceneObject object = chosen(view);
    if (!place_of(*view.now, object) || state.drag.phase != SceneInputPhase::idle) return false;
    if (object != state.nudged || view.wall_seconds - state.nudged_at > nudge_pause) ++state.gesture;
    state.nudged = object;
    state.nudged_at = view.wall_seconds;
    for (const SceneObject& one : selected_objects(view.settings.selection)) {
        const auto place = place_of(*view.now, one);
        const auto command = place ? move_of(*view.now, one, to(*place)) : std::nullopt;
        if (!command) continue;
        outbox.push_back(EditRequest{*command, gestures::viewport + state.gesture});
        if (auto start = start_of(*view.now, *command))
            outbox.push_back(EditRequest{*start, gestures::viewport + state.gesture});
    }
    return true;
}

bool nudge(const LabView& view, SceneInputState& state, KeyPress press, Outbox& outbox) {
    const vec2 way = floor_direction(*view.camera_view, press.key) * (press.shift ? fine_nudge : nudge_step);
    return put_by_key(
        view, state,
        [way](Pose at) {
            return Pose{at.x + way.x, at.y + way.y, at.heading};
        },
        outbox);
}

// A source has no heading: the key has no effect on it.
bool turn_by_key(const LabView& view, SceneInputState& state, float by, Outbox& outbox) {
    const bool alone = view.settings.selection.more.empty();
    if (alone && chosen(view).kind == SceneObjectKind::source) return false;
    return put_by_key(
        view, state,
        [by](Pose at) {
            return Pose{at.x, at.y, maths::wrap_angle(maths::to_degree_steps(at.heading + by))};
        },
        outbox);
}

// Up and Down move through the rows of the open menu; Esc and Left close it or go back. Enter goes to the focused row.
bool key_for_menu(SceneInputMenu& menu, Keyboard& keyboard, KeyPress press) {
    if (press.key == key::escape || (press.key == key::left && menu.page != MenuPage::top)) {
        if (menu.page == MenuPage::top)
            menu.open = false;
        else
            menu.page = MenuPage::top;
        keyboard.focus.clear();
        return true;
    }
    const bool back = press.key == key::up || (press.key == key::tab && press.shift);
    if ((!back && press.key != key::down && press.key != key::tab) || menu.rows.empty()) return false;
    const auto& rows = menu.rows;
    const auto at = std::find(rows.begin(), rows.end(), keyboard.focus);
    const auto count = static_cast<std::ptrdiff_t>(rows.size());
    const std::ptrdiff_t index = at == rows.end() ? (back ? 0 : -1) : at - rows.begin();
    keyboard.focus = rows[static_cast<std::size_t>((index + (back ? -1 : 1) + count) % count)];
    return true;
}

// Enter with the mouse ends what the tool draws; with the crosshair it sets a corner.
bool enter_for_tool(const LabView& view, SceneInputState& state, bool keep_tool, Outbox& outbox) {
    if (state.crosshair) {
        if (state.tool == SceneInputTool::ruler && state.corners.size() > 1) state.corners.clear();
        if (const auto at = aim(state, view, state.pointer)) set_corner(state, view, *at, keep_tool, outbox);
    } else if (state.tool == SceneInputTool::polygon) {
        close_outline(state, view, keep_tool, outbox);
    } else if (state.tool == SceneInputTool::tape) {
        end_line(state, view, keep_tool, outbox);
    } else {
        return false;
    }
    return true;
}

bool key_for_tool(const LabView& view, SceneInputState& state, Action action, KeyPress press, Outbox& outbox) {
    if (state.tool == SceneInputTool::hand) return false;
    if (action == Action::close_outline) return enter_for_tool(view, state, press.shift, outbox);
    if (action == Action::take_back) return take_back_corner(state), true;
    if (action != Action::nudge || state.drag.phase != SceneInputPhase::idle) return false;
    const float step = press.shift ? fine_crosshair : crosshair_step;
    move_crosshair(state, view, floor_direction(*view.camera_view, press.key) * step);
    return true;
}

// The path of a prediction: arrows draw it, Backspace takes a step back, Enter makes it the prediction.
bool key_for_path(const LabView& view, SceneInputState& state, Action action, KeyPress press, Outbox& outbox) {
    if (!state.path.on) return false;
    if (action == Action::close_outline) return finish_path_drawing(state, outbox);
    if (action == Action::take_back) return take_back_path_step(state);
    if (action != Action::nudge) return false;
    const float step = press.shift ? fine_path_step : path_step;
    return draw_path_step(state, view, floor_direction(*view.camera_view, press.key) * step);
}

// Discards the gesture, the tool and the menu that were used in another document.
void follow_document(SceneInputState& state, const LabView& view) {
    if (state.run_id == view.run_id) return;
    state.run_id = view.run_id;
    choose_tool(state, SceneInputTool::hand);
    state.hovered = {}, state.trail_moment.reset(), state.nudged = {};
    state.drag = {}, state.sensors.drag = {}, state.points.drag = {};
    state.refusal = {}, state.menu = {}, state.path = {};
}

}  // namespace

bool takes_arrows(const LabView& view, const SceneInputState& state, bool ctrl) {
    if (!view.camera_view || view.mode == Mode::wiring) return false;
    if (state.tool != SceneInputTool::hand || state.path.on) return true;
    return view.settings.selection.object || !view.settings.selection.more.empty() ||
           (ctrl && view.settings.selection.vehicle != no_vehicle);
}

void scene_input(const LabView& view, SceneInputState& state, Ui& ui, Rect area, Rect tools) {
    follow_document(state, view);
    state.labels = {};
    if (!view.camera_view) return;
    state.labels.keep_free(*view.now, *view.camera_view);
    state.labels.keep_obstacles_free(*view.now, *view.camera_view);
    if (tools.w > 0) state.labels.take(tools);
    const SceneInputFrame frame{view, *view.camera_view, ui.scale, area, current_pointer(state, area), &state.labels};
    interact(state, frame, ui.outbox);
    show_cursor(state);
    draw_sources_outside(frame, ui);
    draw_insight(frame, ui);
    if (state.trail_moment && state.drag.phase == SceneInputPhase::idle)
        draw_trail_moment(frame, ui, *state.trail_moment);
    draw_lesson(state, frame, ui);
    draw_sensor_handles(state, frame, ui);
    draw_scene_input(state, frame, ui);
    draw_point_handles(state, frame, ui);
}

std::uint64_t gesture_by_keys(const SceneInputState& state, double wall_seconds) {
    const bool is_recent = state.nudged_at >= 0 && wall_seconds - state.nudged_at <= nudge_pause;
    return is_recent && state.drag.phase == SceneInputPhase::idle ? gestures::viewport + state.gesture : 0;
}

bool press_key(const LabView& view, SceneInputState& state, Keyboard& keyboard, KeyPress press, Outbox& outbox) {
    if (!view.camera_view || view.mode == Mode::wiring) return false;
    if (state.menu.open && key_for_menu(state.menu, keyboard, press)) return true;
    if (!keyboard.focus.empty()) return false;                                    // a widget has the keyboard
    if (press.key == key::del) return state.drag.phase != SceneInputPhase::idle;  // a dragged object is not deleted
    // With arrows Shift means finer steps and Ctrl includes vehicles.
    const auto action = action_for(is_arrow_key(press.key) ? KeyPress{press.key} : press, KeyPlace::scene);
    if (!action) return false;
    if (key_for_path(view, state, *action, press, outbox)) return true;
    if (key_for_tool(view, state, *action, press, outbox)) return true;
    switch (*action) {
        case Action::cancel:
            return cancel(state, view, outbox);
        case Action::scene_menu:
            open_menu_of(state, view, chosen(view));
            return true;
        case Action::copy:
        case Action::cut:
        case Action::select_all:
            outbox.push_back(*action);
            return true;
        case Action::paste: {
            const auto floor = state.over ? unproject(*view.camera_view, state.pointer) : std::nullopt;
            outbox.push_back(PasteRequest{floor});
            return true;
        }
        case Action::add_here:
            open_menu_of_floor(state, view);
            return true;
        case Action::rotate_left:
            return turn_by_key(view, state, key_turn, outbox);
        case Action::rotate_right:
            return turn_by_key(view, state, -key_turn, outbox);
        case Action::nudge:
            return takes_arrows(view, state, press.ctrl) && nudge(view, state, press, outbox);
        default:
            return false;
    }
}

}  // namespace braitenlab::ui
