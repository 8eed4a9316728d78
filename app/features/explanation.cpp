#include "app/features/explanation.h"

#include <algorithm>

#include "app/course/lesson_view.h"
#include "app/lab_selection.h"
#include "app/seeking.h"
#include "app/workspace.h"

namespace braitenlab {

namespace {

constexpr std::uint64_t ticks_between = 6;      // while playing
constexpr std::size_t most_for_a_replay = 100;  // vehicles; repeating half a second of more would be seen as a jerk

void add_moment(Explanation& e, const Snapshot& now, const VehicleView& vehicle) {
    if (e.past_vehicle != vehicle.id || e.past_tick + 1 != now.tick) e.past.clear();
    if (e.past.size() > insight::silenced_ticks) e.past.erase(e.past.begin());
    e.past.push_back(insight::moment_of(now, vehicle));
    e.past_tick = now.tick, e.past_vehicle = vehicle.id;
}

// Repeats the recorded ticks where the moments are not known: after the time was changed, or at first.
void gather_moments(Explanation& e, const Workspace& space, const VehicleView& vehicle) {
    const Session& session = space.document.session;
    const Snapshot& now = session.snapshot();
    if (e.past_vehicle == vehicle.id && e.past_tick == now.tick && e.run == space.document.run_id && !e.past.empty())
        return;
    e.past.clear();
    if (now.vehicles.size() > most_for_a_replay) return add_moment(e, now, vehicle);
    const std::uint64_t from = now.tick - std::min<std::uint64_t>(now.tick, insight::silenced_ticks);
    session.replay(from, {.tick = [&](const Snapshot& past) {
                       if (const VehicleView* then = find_vehicle(past, vehicle.id)) add_moment(e, past, *then);
                   }});
}

bool is_current(const Explanation& e, const Workspace& space, VehicleId vehicle) {
    const std::uint64_t tick = space.document.session.snapshot().tick;
    if (!e.why || e.why->vehicle != vehicle || e.run != space.document.run_id || e.edits != space.document.edits)
        return false;
    if (space.playback.mode != Mode::playing) return e.why->tick == tick;
    return e.why->tick <= tick && tick < e.why->tick + ticks_between;
}

}  // namespace

void record_moment(Explanation& e, const Workspace& space) {
    const VehicleView* vehicle = e.on ? selected_vehicle(space) : nullptr;
    const Snapshot& now = space.document.session.snapshot();
    if (vehicle && insight::has_hidden_neurons(*brain_of(now, *vehicle))) add_moment(e, now, *vehicle);
}

void update_explanation(Explanation& e, const Workspace& space) {
    const VehicleView* vehicle = e.on ? selected_vehicle(space) : nullptr;
    if (!vehicle) return e.why.reset();
    if (is_current(e, space, vehicle->id)) return;
    const Snapshot& now = space.document.session.snapshot();
    if (insight::has_hidden_neurons(*brain_of(now, *vehicle))) gather_moments(e, space, *vehicle);
    e.run = space.document.run_id, e.edits = space.document.edits;
    e.why = insight::why(now, *vehicle, e.past);
}

void explain_at(Explanation& e, Workspace& space, std::uint64_t tick) {
    if (!selected_vehicle(space)) return;
    if (space.playback.mode == Mode::playing) set_mode(space, Mode::paused);
    seek(space, {.tick = tick});
    e.on = true;
    update_explanation(e, space);
}

const insight::Why* explanation_of(const Explanation& e, const Workspace& space) {
    const VehicleView* vehicle = selected_vehicle(space);
    if (!e.why || space.together || !vehicle || e.why->vehicle != vehicle->id) return nullptr;
    const Disclosure may = disclosure_of(space);
    if (!may.why || !shows_driving_brain(space, may, *vehicle)) return nullptr;
    return &*e.why;
}

}  // namespace braitenlab
