#include "app/lab_edits.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/course/lesson_view.h"
#include "app/lab_selection.h"
#include "app/what_changed.h"
#include "ui/scene_input/clipboard.h"
#include "ui/scene_input/edits.h"

namespace braitenlab {

void report_time_change(Workspace& space, std::uint64_t latest_before) {
    constexpr std::uint64_t reported = 30;  // ticks
    const std::uint64_t now = space.document.session.snapshot().tick, latest = space.document.session.latest();
    // Rounded as the clock of the toolbar has it.
    const std::string seconds = fmt::format("{:.1f}", static_cast<float>(space.document.session.snapshot().seconds));
    if (latest > latest_before && latest > now + reported)
        say(space, {NoticeKind::done, "notice.time_back", seconds, "", true});
    if (latest_before <= latest + reported) return;
    const bool can_come_back = space.document.session.undo_brings_time_back();
    say(space,
        {NoticeKind::notice, can_come_back ? "notice.forgotten" : "notice.forgotten_for_good", seconds, "", true});
}

bool apply(Workspace& space, const Command& command, std::uint64_t gesture) {
    const std::uint64_t latest = space.document.session.latest();
    const auto error = space.document.session.apply(command, gesture);
    if (error) {
        say(space, *error);
    } else {
        ++space.document.edits;
        watch(space);
        report_time_change(space, latest);
    }
    if (!selected_vehicle(space)) space.selected_kind.clear();  // removed by hand: the next one, of any kind
    keep_selection(space);
    return !error;
}

namespace {

enum class Direction { undo, redo };

// The notice says what the edit has changed that is taken back or made again.
template <class Change>
void change(Workspace& space, Direction direction, const Change& make) {
    const std::uint64_t latest = space.document.session.latest();
    const Snapshot before = space.document.session.snapshot();
    const UndoResult made = make();
    space.document.edits += made.done;
    keep_selection(space);
    watch(space);
    const Snapshot& now = space.document.session.snapshot();
    if (made.done && direction == Direction::undo)
        say(space, {NoticeKind::done, "notice.undone", what_changed(now, before)});
    if (made.done && direction == Direction::redo)
        say(space, {NoticeKind::done, "notice.redone", what_changed(before, now)});
    report_time_change(space, latest);
    if (made.error) say(space, *made.error);
}

// Applies an edit and selects what it has added.
void apply_and_select(Workspace& space, const Command& command, std::uint64_t gesture) {
    if (!apply(space, command, gesture)) return;
    if (const SceneObject added = ui::added_by(space.document.session.snapshot(), command)) select(space, added);
}

void erase(Workspace& space) {
    const std::uint64_t gesture = new_gesture(space);
    for (const Command& command :
         ui::removals_of(space.document.session.snapshot(), selected_objects(space.view.selection)))
        apply(space, command, gesture);
}

// Duplicates the selected objects. Edits of a single copied vehicle apply to it alone.
void duplicate(Workspace& space) {
    const Snapshot& now = space.document.session.snapshot();
    const std::vector<SceneObject> objects = selected_objects(space.view.selection);
    if (objects.size() > 1) return paste(space, ui::copied(now, objects), std::nullopt);
    const auto copy = ui::copy_of(now, chosen_object(space.view.selection));
    if (!copy || !apply(space, *copy)) return;
    if (const SceneObject added = ui::added_by(space.document.session.snapshot(), *copy)) select(space, added);
    if (std::holds_alternative<AddVehicle>(*copy)) space.view.selection.whole_kind = false;
}

void copy(Workspace& space) {
    Scene copy = ui::copied(space.document.session.snapshot(), selected_objects(space.view.selection));
    if (ui::object_count(copy) > 0) space.clipboard = std::move(copy);
}

void select_all(Workspace& space) {
    const Snapshot& now = space.document.session.snapshot();
    std::vector<SceneObject> all = objects_beside_vehicles(*now.scene);
    for (const VehicleView& v : now.vehicles) all.push_back(vehicle_object(v.id));
    select_objects(space, all);
}

}  // namespace

void undo(Workspace& space) {
    change(space, Direction::undo, [&] { return space.document.session.undo(); });
}

void redo(Workspace& space) {
    change(space, Direction::redo, [&] { return space.document.session.redo(); });
}

void edit(Workspace& space, const EditRequest& r) {
    const bool from_diagram = r.gesture >= gestures::canvas && r.gesture < gestures::viewport;
    if (from_diagram && space.playback.mode == Mode::playing) set_mode(space, Mode::paused);
    apply_and_select(space, r.command, r.gesture);
}

void paste(Workspace& space, const Scene& copy, std::optional<maths::vec2> at) {
    const std::uint64_t gesture = new_gesture(space);
    std::vector<SceneObject> added;
    for (const Command& command : ui::pasted(space.document.session.snapshot(), copy, at)) {
        const Command with_room = ui::with_room(space.document.session.snapshot(), command);
        if (!apply(space, with_room, gesture)) break;  // the notice says why
        if (const SceneObject one = ui::added_by(space.document.session.snapshot(), with_room)) added.push_back(one);
    }
    select_objects(space, added);
}

void act_on_objects(Workspace& space, Action action) {
    if (space.playback.mode == Mode::wiring) return;
    if (action == Action::erase || action == Action::cut) {
        if (action == Action::cut) copy(space);
        erase(space);
    } else if (action == Action::duplicate) {
        duplicate(space);
    } else if (action == Action::copy) {
        copy(space);
    } else if (action == Action::select_all) {
        select_all(space);
    }
}

void drive(Workspace& space) {
    const VehicleView* vehicle = selected_vehicle(space);
    if (!vehicle) return;
    const Snapshot& now = space.document.session.snapshot();
    const Driver of_kind = now.scene->kinds[static_cast<std::size_t>(vehicle->kind)].driver;
    const Driver otherwise = of_kind == Driver::manual ? Driver::brain : of_kind;
    apply(space, ChooseDriver{vehicle->id, vehicle->driver == Driver::manual ? otherwise : Driver::manual});
}

bool steer_by_keys(Workspace& space, float right, float ahead) {
    Session& session = space.document.session;
    const VehicleView* vehicle = selected_vehicle(space);
    const bool drives = vehicle && vehicle->driver == Driver::manual;
    // Stop the vehicle driven before, if it is no longer selected or no longer driven manually.
    if (space.steered.vehicle != no_vehicle && (!drives || vehicle->id != space.steered.vehicle)) {
        (void)session.apply(steer(space.steered.vehicle, 0, 0));
        space.steered = {};
    }
    if (!drives) return false;
    const Steer wanted = steer(vehicle->id, right, ahead);
    const bool idle = right == 0 && ahead == 0;
    if (idle && space.steered.vehicle == no_vehicle) return true;  // the on-screen stick may be driving
    if (wanted != space.steered) (void)session.apply(wanted);
    space.steered = idle ? Steer{} : wanted;
    return true;
}

}  // namespace braitenlab
