#include "app/lab_edits.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/course/lab_lesson.h"
#include "app/lab_selection.h"
#include "app/playback.h"
#include "ui/scene_input/clipboard.h"
#include "ui/scene_input/edits.h"

namespace braitenlab {

void report_time_change(Lab& lab, std::uint64_t latest_before) {
    constexpr std::uint64_t reported = 30;  // ticks
    const std::uint64_t now = lab.document.session.snapshot().tick, latest = lab.document.session.latest();
    const std::string seconds = fmt::format("{:.1f}", lab.document.session.snapshot().seconds);
    if (latest > latest_before && latest > now + reported)
        say(lab, {NoticeKind::done, "notice.time_back", seconds, "", true});
    if (latest_before <= latest + reported) return;
    const bool can_come_back = lab.document.session.undo_brings_time_back();
    say(lab, {NoticeKind::notice, can_come_back ? "notice.forgotten" : "notice.forgotten_for_good", seconds, "", true});
}

bool apply(Lab& lab, const Command& command, std::uint64_t gesture) {
    const std::uint64_t latest = lab.document.session.latest();
    const auto error = lab.document.session.apply(command, gesture);
    if (error) {
        say(lab, *error);
    } else {
        ++lab.document.edits;
        watch(lab);
        report_time_change(lab, latest);
    }
    keep_selection(lab);
    return !error;
}

namespace {

// Undo or redo.
template <class Change>
void change(Lab& lab, const Change& make) {
    const std::uint64_t latest = lab.document.session.latest();
    const UndoResult made = make();
    lab.document.edits += made.done;
    keep_selection(lab);
    watch(lab);
    report_time_change(lab, latest);
    if (made.error) say(lab, *made.error);
}

// Applies an edit and selects what it has added.
void apply_and_select(Lab& lab, const Command& command, std::uint64_t gesture) {
    if (!apply(lab, command, gesture)) return;
    if (const SceneObject added = ui::added_by(lab.document.session.snapshot(), command)) select(lab, added);
}

}  // namespace

void undo(Lab& lab) {
    change(lab, [&] { return lab.document.session.undo(); });
}

void redo(Lab& lab) {
    change(lab, [&] { return lab.document.session.redo(); });
}

void edit(Lab& lab, const EditRequest& r) {
    const bool from_diagram = r.gesture >= gestures::canvas && r.gesture < gestures::viewport;
    if (from_diagram && lab.playback.mode == Mode::playing) set_mode(lab, Mode::paused);
    apply_and_select(lab, r.command, r.gesture);
}

void paste(Lab& lab, const Scene& copy, std::optional<maths::vec2> at) {
    const std::uint64_t gesture = gestures::lab + ++lab.gesture;
    std::vector<SceneObject> added;
    for (const Command& command : ui::pasted(lab.document.session.snapshot(), copy, at)) {
        const Command with_room = ui::with_room(lab.document.session.snapshot(), command);
        if (!apply(lab, with_room, gesture)) break;  // the notice says why
        if (const SceneObject one = ui::added_by(lab.document.session.snapshot(), with_room)) added.push_back(one);
    }
    select_objects(lab, added);
}

namespace {

void erase(Lab& lab) {
    const std::uint64_t gesture = gestures::lab + ++lab.gesture;
    for (const Command& command :
         ui::removals_of(lab.document.session.snapshot(), selected_objects(lab.view.selection)))
        apply(lab, command, gesture);
}

// Duplicates the selected objects. Edits of a single copied vehicle apply to it alone.
void duplicate(Lab& lab) {
    const Snapshot& now = lab.document.session.snapshot();
    const std::vector<SceneObject> objects = selected_objects(lab.view.selection);
    if (objects.size() > 1) return paste(lab, ui::copied(now, objects), std::nullopt);
    const auto copy = ui::copy_of(now, chosen_object(lab.view.selection));
    if (!copy || !apply(lab, *copy)) return;
    if (const SceneObject added = ui::added_by(lab.document.session.snapshot(), *copy)) select(lab, added);
    if (std::holds_alternative<AddVehicle>(*copy)) lab.view.selection.whole_kind = false;
}

void copy(Lab& lab) {
    Scene copy = ui::copied(lab.document.session.snapshot(), selected_objects(lab.view.selection));
    if (ui::object_count(copy) > 0) lab.clipboard = std::move(copy);
}

void select_all(Lab& lab) {
    const Snapshot& now = lab.document.session.snapshot();
    std::vector<SceneObject> all = objects_beside_vehicles(*now.scene);
    for (const VehicleView& v : now.vehicles) all.push_back(vehicle_object(v.id));
    select_objects(lab, all);
}

}  // namespace

void act_on_objects(Lab& lab, Action action) {
    if (lab.playback.mode == Mode::wiring) return;
    if (action == Action::erase || action == Action::cut) {
        if (action == Action::cut) copy(lab);
        erase(lab);
    } else if (action == Action::duplicate) {
        duplicate(lab);
    } else if (action == Action::copy) {
        copy(lab);
    } else if (action == Action::select_all) {
        select_all(lab);
    }
}

}  // namespace braitenlab
