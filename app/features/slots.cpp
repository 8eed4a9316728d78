#include "app/features/slots.h"

#include <cmath>
#include <memory>
#include <utility>

#include "app/course/lesson_view.h"
#include "app/jobs/in_pieces.h"
#include "app/lab_edits.h"
#include "app/lab_selection.h"
#include "app/workspace.h"

namespace braitenlab {

namespace {

constexpr float compared_seconds = 30;     // outside exercises
constexpr std::size_t design_ticks = 120;  // about half a millisecond with one vehicle

std::string letter(std::size_t slot) { return slot == 0 ? "A" : "B"; }

std::string_view why_no_slots(const Workspace& space) {
    const VehicleView* vehicle = find_vehicle(shown_snapshot(space), space.view.selection.vehicle);
    return why_no_slots(vehicle, vehicle && shows_driving_brain(space, disclosure_of(space), *vehicle));
}

// The selected vehicle, or null after a message if its brain may not be stored or replaced.
const VehicleView* vehicle_for_slots(Workspace& space) {
    const VehicleView* vehicle = selected_vehicle(space);
    const std::string_view why = why_no_slots(space);
    if (why.empty()) return vehicle;
    say(space, {NoticeKind::failure, std::string(why)});
    return nullptr;
}

bool has(const Slots& slots, const Workspace& space, const VehicleView& vehicle, std::size_t slot) {
    const auto& stored = slots.stored[slot];
    return stored && insight::is_same(*stored, insight::design_of(space.document.session.snapshot(), vehicle));
}

void store(Slots& slots, Workspace& space, const VehicleView& vehicle, std::size_t slot) {
    const Snapshot& now = space.document.session.snapshot();
    slots.stored[slot] = insight::design_of(now, vehicle);
    slots.kinds[slot] = kind_of(now, vehicle).name;
    slots.characters[slot] = character_of(now, vehicle);
    slots.current = slot;
    slots.runs.forget();
    const bool is_first = !slots.stored[1 - slot];
    say(space, {NoticeKind::done, is_first ? "notice.slot_first" : "notice.slot_stored", letter(slot)});
}

// False if the brain was refused.
bool put(Workspace& space, const insight::Design& design) {
    const VehicleView vehicle = *selected_vehicle(space);
    const std::uint64_t gesture = new_gesture(space);
    for (const Command& command : insight::commands_for(design, space.document.session.snapshot(), vehicle,
                                                        target_of(space.view.selection, vehicle)))
        if (!apply(space, command, gesture)) return false;
    return true;
}

bool put(Slots& slots, Workspace& space, std::size_t slot) {
    if (!put(space, *slots.stored[slot])) return false;
    slots.current = slot;
    return true;
}

void put_and_say(Slots& slots, Workspace& space, std::size_t slot) {
    if (put(slots, space, slot)) say(space, {NoticeKind::done, "notice.slot_put", letter(slot)});
}

std::size_t ticks_to_compare(const Workspace& space) {
    const float seconds = space.document.lesson ? space.document.lesson->exercise->seconds : compared_seconds;
    return static_cast<std::size_t>(std::lround(seconds * 60));
}

// True while the run on the screen is the run of A.
bool is_shown(const Workspace& space, const SlotRuns& runs) {
    return runs.run == space.document.run_id && runs.seed == space.document.session.seed() &&
           runs.edits == space.document.edits && runs.vehicle == space.view.selection.vehicle && !space.together;
}

}  // namespace

void store_or_swap(Slots& slots, Workspace& space) {
    const VehicleView* vehicle = vehicle_for_slots(space);
    if (!vehicle) return;
    const bool is_a = has(slots, space, *vehicle, 0), is_b = has(slots, space, *vehicle, 1);
    for (const std::size_t slot : {std::size_t{0}, std::size_t{1}}) {
        if (slots.stored[slot]) continue;
        if (is_a || is_b) return say(space, {NoticeKind::notice, "notice.slot_same", letter(is_a ? 0 : 1)});
        return store(slots, space, *vehicle, slot);
    }
    if (is_a || is_b) return put_and_say(slots, space, is_a ? 1 : 0);
    store(slots, space, *vehicle, slots.current);
}

void handle_slot(Slots& slots, Workspace& space, const SlotRequest& wanted) {
    const VehicleView* vehicle = vehicle_for_slots(space);
    if (!vehicle || wanted.slot > 1) return;
    if (wanted.store || !slots.stored[wanted.slot]) return store(slots, space, *vehicle, wanted.slot);
    put_and_say(slots, space, wanted.slot);
}

Slots without_runs(const Slots& slots) {
    return {.stored = slots.stored, .kinds = slots.kinds, .characters = slots.characters, .current = slots.current};
}

void empty_slots(Slots& slots) { slots = {}; }

bool can_compare_slots(const Slots& slots, Workspace& space) {
    std::string_view why = why_no_slots(space);
    if (why.empty()) why = why_no_comparison(slots.stored[0] && slots.stored[1], disclosure_of(space));
    if (!why.empty()) say(space, {NoticeKind::failure, std::string(why)});
    return why.empty();
}

void compare_slots(Slots& slots, Workspace& space) {
    const VehicleView* vehicle = selected_vehicle(space);
    if (!vehicle) return say(space, {NoticeKind::failure, "unavailable.no_vehicle"});
    SlotRuns runs{.run = space.document.run_id,
                  .seed = space.document.session.seed(),
                  .vehicle = vehicle->id,
                  .question = {space.document.session.bookmark().checkpoint, vehicle->id,
                               target_of(space.view.selection, *vehicle), ticks_to_compare(space)},
                  .designs = {*slots.stored[0], *slots.stored[1]},
                  .before = insight::design_of(space.document.session.snapshot(), *vehicle)};
    const bool is_saved = space.document.edits == space.document.saved_edits;
    if (!put(slots, space, 0)) return;
    if (is_saved) space.document.saved_edits = space.document.edits;  // the comparison's edit, and A is still stored
    runs.edits = space.document.edits;
    slots.runs.forget();
    slots.runs.ask(std::move(runs));
    set_mode(space, Mode::playing);
}

void end_comparison(Slots& slots, Workspace& space) {
    const SlotRuns* asked = slots.runs.question();
    if (!asked) return;
    const bool has_a = is_shown(space, *asked) && selected_vehicle(space);
    const insight::Design before = asked->before;
    slots.runs.forget();
    if (!has_a ||
        insight::is_same(before, insight::design_of(space.document.session.snapshot(), *selected_vehicle(space))))
        return;
    const bool is_saved = space.document.edits == space.document.saved_edits;
    if (!put(space, before)) return;
    for (const std::size_t slot : {std::size_t{0}, std::size_t{1}})
        if (has(slots, space, *selected_vehicle(space), slot)) slots.current = slot;
    if (is_saved) space.document.saved_edits = space.document.edits;
}

std::optional<Session> session_with_own_brain(const Slots& slots, const Workspace& space) {
    const SlotRuns* asked = slots.runs.question();
    if (!asked || !is_shown(space, *asked)) return std::nullopt;
    const Session& shown = space.document.session;
    const VehicleView* vehicle = find_vehicle(shown.snapshot(), asked->vehicle);
    if (!vehicle) return std::nullopt;
    Session own = Session::resume(shown.save(), shown.observer_at_keyframe(), shown.edits());
    for (const Command& command :
         insight::commands_for(asked->before, shown.snapshot(), *vehicle, target_of(space.view.selection, *vehicle)))
        if (own.apply(command)) return std::nullopt;
    return own;
}

void update_slots(Slots& slots, const Workspace& space, Jobs& jobs) {
    const SlotRuns* asked = slots.runs.question();
    if (!asked) return;
    if (asked->run != space.document.run_id) return slots.runs.forget();
    slots.runs.follow([&](const SlotRuns& runs) {
        const auto shared = std::make_shared<const SlotRuns>(runs);
        return jobs.submit(2, [shared](std::size_t part) {
            return InPieces(insight::DesignRun(shared->question, shared->designs[part]), design_ticks,
                            &insight::DesignRun::run);
        });
    });
    if (slots.runs.error()) slots.runs.forget();
}

bool ends_comparison(const Slots& slots, const Workspace& space) {
    const SlotRuns* asked = slots.runs.question();
    return asked && is_shown(space, *asked) && space.document.session.snapshot().tick == asked->question.ticks;
}

bool is_computing(const Slots& slots) { return slots.runs.is_computing(); }

SlotsView slots_of(const Slots& slots, const Workspace& space) {
    SlotsView shown;
    const VehicleView* vehicle = selected_vehicle(space);
    for (std::size_t i = 0; i < 2; ++i) {
        if (!slots.stored[i]) continue;
        shown.slots[i].design = &*slots.stored[i];
        shown.slots[i].kind = slots.kinds[i];
        shown.slots[i].character = slots.characters[i];
        shown.slots[i].is_in_vehicle = vehicle && has(slots, space, *vehicle, i);
    }
    const SlotRuns* asked = slots.runs.question();
    if (!asked || asked->run != space.document.run_id || !disclosure_of(space).future) return shown;
    shown.seconds = static_cast<float>(asked->question.ticks) / 60;
    shown.is_computing = is_computing(slots);
    if (shown.is_computing) return shown;
    const std::vector<insight::ComparedRun>& runs = *slots.runs.answer();
    for (std::size_t i = 0; i < 2; ++i) shown.slots[i].numbers = &runs[i].numbers;
    if (!vehicle || !is_shown(space, *asked)) return shown;
    const Body& body = kind_of(space.document.session.snapshot(), *vehicle).body;
    shown.a = ghost_at(space, runs[0].path, body);
    shown.b = ghost_at(space, runs[1].path, body);
    return shown;
}

}  // namespace braitenlab
