#include "app/insight/slots.h"

#include <cmath>
#include <memory>
#include <utility>

#include "app/course/lab_lesson.h"
#include "app/course/lesson_view.h"
#include "app/course/reference_runs.h"
#include "app/lab.h"
#include "app/lab_edits.h"
#include "app/lab_selection.h"
#include "app/playback.h"

namespace braitenlab {

namespace {

constexpr float compared_seconds = 30;     // outside exercises
constexpr std::size_t design_ticks = 120;  // about half a millisecond with one vehicle

std::string letter(std::size_t slot) { return slot == 0 ? "A" : "B"; }

// The run of a design as a part of a job.
class DesignPiece {
public:
    DesignPiece(const insight::CompareQuestion& question, const insight::Design& design) : run_(question, design) {}
    std::optional<insight::ComparedRun> operator()() {
        if (!run_.advance(design_ticks)) return std::nullopt;
        return run_.run();
    }
    float progress() const { return run_.progress(); }

private:
    insight::DesignRun run_;
};

std::string_view why_no_slots(const Lab& lab) {
    const VehicleView* vehicle = find_vehicle(shown_snapshot(lab), lab.view.selection.vehicle);
    return why_no_slots(vehicle, vehicle && shows_driving_brain(lab, disclosure_of(lab), *vehicle));
}

// The selected vehicle, or null after a message if its brain may not be stored or replaced.
const VehicleView* vehicle_for_slots(Lab& lab) {
    const VehicleView* vehicle = selected_vehicle(lab);
    const std::string_view why = why_no_slots(lab);
    if (why.empty()) return vehicle;
    say(lab, {NoticeKind::failure, std::string(why)});
    return nullptr;
}

bool has(const Lab& lab, const VehicleView& vehicle, std::size_t slot) {
    const auto& stored = lab.slots.stored[slot];
    return stored && insight::is_same(*stored, insight::design_of(lab.document.session.snapshot(), vehicle));
}

void store(Lab& lab, const VehicleView& vehicle, std::size_t slot) {
    const Snapshot& now = lab.document.session.snapshot();
    Slots& slots = lab.slots;
    slots.stored[slot] = insight::design_of(now, vehicle);
    slots.kinds[slot] = kind_of(now, vehicle).name;
    slots.characters[slot] = character_of(now, vehicle);
    slots.current = slot;
    slots.runs.reset();
    const bool is_first = !slots.stored[1 - slot];
    say(lab, {NoticeKind::done, is_first ? "notice.slot_first" : "notice.slot_stored", letter(slot)});
}

// False if the brain was refused.
bool put(Lab& lab, std::size_t slot) {
    const VehicleView vehicle = *selected_vehicle(lab);
    const std::uint64_t gesture = gestures::lab + ++lab.gesture;
    for (const Command& command : insight::commands_for(*lab.slots.stored[slot], lab.document.session.snapshot(),
                                                        vehicle, target_of(lab.view.selection, vehicle)))
        if (!apply(lab, command, gesture)) return false;
    lab.slots.current = slot;
    return true;
}

void put_and_say(Lab& lab, std::size_t slot) {
    if (put(lab, slot)) say(lab, {NoticeKind::done, "notice.slot_put", letter(slot)});
}

std::size_t ticks_to_compare(const Lab& lab) {
    const float seconds = lab.document.lesson ? lab.document.lesson->exercise->seconds : compared_seconds;
    return static_cast<std::size_t>(std::lround(seconds * 60));
}

// True while the run on the screen is the run of A.
bool is_shown(const Lab& lab, const SlotRuns& runs) {
    return runs.run == lab.document.run_id && runs.seed == lab.document.session.seed() &&
           runs.edits == lab.document.edits && runs.vehicle == lab.view.selection.vehicle && !lab.together;
}

}  // namespace

void store_or_swap(Lab& lab) {
    const VehicleView* vehicle = vehicle_for_slots(lab);
    if (!vehicle) return;
    const bool is_a = has(lab, *vehicle, 0), is_b = has(lab, *vehicle, 1);
    const Slots& slots = lab.slots;
    for (const std::size_t slot : {std::size_t{0}, std::size_t{1}}) {
        if (slots.stored[slot]) continue;
        if (is_a || is_b) return say(lab, {NoticeKind::notice, "notice.slot_same", letter(is_a ? 0 : 1)});
        return store(lab, *vehicle, slot);
    }
    if (is_a || is_b) return put_and_say(lab, is_a ? 1 : 0);
    store(lab, *vehicle, slots.current);
}

void handle_slot(Lab& lab, const SlotRequest& wanted) {
    const VehicleView* vehicle = vehicle_for_slots(lab);
    if (!vehicle || wanted.slot > 1) return;
    if (wanted.store || !lab.slots.stored[wanted.slot]) return store(lab, *vehicle, wanted.slot);
    put_and_say(lab, wanted.slot);
}

void compare_slots(Lab& lab) {
    std::string_view why = why_no_slots(lab);
    if (why.empty()) why = why_no_comparison(lab.slots.stored[0] && lab.slots.stored[1], disclosure_of(lab));
    if (!why.empty()) return say(lab, {NoticeKind::failure, std::string(why)});
    reset(lab);
    const VehicleView* vehicle = selected_vehicle(lab);
    if (!vehicle) return say(lab, {NoticeKind::failure, "unavailable.no_vehicle"});
    SlotRuns runs{.run = lab.document.run_id,
                  .seed = lab.document.session.seed(),
                  .vehicle = vehicle->id,
                  .question = {lab.document.session.bookmark().checkpoint, vehicle->id,
                               target_of(lab.view.selection, *vehicle), ticks_to_compare(lab)},
                  .designs = {*lab.slots.stored[0], *lab.slots.stored[1]}};
    if (!put(lab, 0)) return;
    runs.edits = lab.document.edits;
    lab.slots.runs = std::move(runs);
    set_mode(lab, Mode::playing);
}

void update_slots(Lab& lab, Jobs& jobs) {
    if (!lab.slots.runs) return;
    SlotRuns& runs = *lab.slots.runs;
    if (runs.run != lab.document.run_id) return lab.slots.runs.reset();
    if (runs.job) {
        auto done = runs.job->take();
        if (!done) return;
        runs.job.reset();
        if (!*done) return lab.slots.runs.reset();
        runs.runs = std::move(**done);
    } else if (runs.runs.empty()) {
        const auto shared = std::make_shared<const std::pair<insight::CompareQuestion, std::array<insight::Design, 2>>>(
            runs.question, runs.designs);
        runs.job =
            jobs.submit(2, [shared](std::size_t part) { return DesignPiece(shared->first, shared->second[part]); });
    }
}

bool is_computing(const Slots& slots) { return slots.runs && slots.runs->runs.empty(); }

SlotsView slots_of(const Lab& lab) {
    SlotsView shown;
    const Slots& slots = lab.slots;
    const VehicleView* vehicle = selected_vehicle(lab);
    for (std::size_t i = 0; i < 2; ++i) {
        if (!slots.stored[i]) continue;
        shown.slots[i].design = &*slots.stored[i];
        shown.slots[i].kind = slots.kinds[i];
        shown.slots[i].character = slots.characters[i];
        shown.slots[i].is_in_vehicle = vehicle && has(lab, *vehicle, i);
    }
    if (!slots.runs || slots.runs->run != lab.document.run_id || !disclosure_of(lab).future) return shown;
    const SlotRuns& runs = *slots.runs;
    shown.seconds = static_cast<float>(runs.question.ticks) / 60;
    shown.is_computing = runs.runs.empty();
    if (shown.is_computing) return shown;
    for (std::size_t i = 0; i < 2; ++i) shown.slots[i].numbers = &runs.runs[i].numbers;
    if (!vehicle || !is_shown(lab, runs)) return shown;
    const Body& body = kind_of(lab.document.session.snapshot(), *vehicle).body;
    shown.a = ghost_at(lab, runs.runs[0].path, body);
    shown.b = ghost_at(lab, runs.runs[1].path, body);
    return shown;
}

}  // namespace braitenlab
