#include "app/insight/explanation.h"

#include <algorithm>

#include "app/course/lesson_view.h"
#include "app/lab.h"
#include "app/lab_selection.h"

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
void gather_moments(Lab& lab, const VehicleView& vehicle) {
    Explanation& e = lab.explanation;
    const Session& session = lab.document.session;
    const Snapshot& now = session.snapshot();
    if (e.past_vehicle == vehicle.id && e.past_tick == now.tick && e.run == lab.document.run_id && !e.past.empty())
        return;
    e.past.clear();
    if (now.vehicles.size() > most_for_a_replay) return add_moment(e, now, vehicle);
    const std::uint64_t from = now.tick - std::min<std::uint64_t>(now.tick, insight::silenced_ticks);
    session.replay(from, {.tick = [&](const Snapshot& past) {
                       if (const VehicleView* then = find_vehicle(past, vehicle.id)) add_moment(e, past, *then);
                   }});
}

bool is_current(const Lab& lab, VehicleId vehicle) {
    const Explanation& e = lab.explanation;
    const std::uint64_t tick = lab.document.session.snapshot().tick;
    if (!e.why || e.why->vehicle != vehicle || e.run != lab.document.run_id || e.edits != lab.document.edits)
        return false;
    if (lab.playback.mode != Mode::playing) return e.why->tick == tick;
    return e.why->tick <= tick && tick < e.why->tick + ticks_between;
}

}  // namespace

void record_moment(Lab& lab) {
    const VehicleView* vehicle = lab.explanation.on ? selected_vehicle(lab) : nullptr;
    const Snapshot& now = lab.document.session.snapshot();
    if (vehicle && insight::has_hidden_neurons(*brain_of(now, *vehicle))) add_moment(lab.explanation, now, *vehicle);
}

void update_explanation(Lab& lab) {
    Explanation& e = lab.explanation;
    const VehicleView* vehicle = e.on ? selected_vehicle(lab) : nullptr;
    if (!vehicle) return e.why.reset();
    if (is_current(lab, vehicle->id)) return;
    const Snapshot& now = lab.document.session.snapshot();
    if (insight::has_hidden_neurons(*brain_of(now, *vehicle))) gather_moments(lab, *vehicle);
    e.run = lab.document.run_id, e.edits = lab.document.edits;
    e.why = insight::why(now, *vehicle, e.past);
}

void explain_at(Lab& lab, std::uint64_t tick) {
    if (!selected_vehicle(lab)) return;
    if (lab.playback.mode == Mode::playing) set_mode(lab, Mode::paused);
    seek(lab, {.tick = tick});
    lab.explanation.on = true;
    update_explanation(lab);
}

const insight::Why* explanation_of(const Lab& lab) {
    const VehicleView* vehicle = selected_vehicle(lab);
    if (!lab.explanation.why || lab.together || !vehicle || lab.explanation.why->vehicle != vehicle->id) return nullptr;
    const Disclosure may = disclosure_of(lab);
    if (!may.why || !shows_driving_brain(lab, may, *vehicle)) return nullptr;
    return &*lab.explanation.why;
}

}  // namespace braitenlab
