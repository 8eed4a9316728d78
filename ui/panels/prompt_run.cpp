#include "ui/panels/prompt_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/subject.h"
#include "ui/panels/panels.h"

namespace braitenlab::ui {

namespace {

constexpr float standstill = 0.03f;                // m/s
constexpr double lost_after = 3, stuck_after = 6;  // simulated seconds; 3a-love rests for five

// True if the brain gives the wheels little or no speed; else something is in the way of a vehicle that stands.
bool is_halted(const VehicleView& vehicle) {
    constexpr float at_rest = 0.05f;
    return std::fabs(vehicle.motor[0]) < at_rest && std::fabs(vehicle.motor[1]) < at_rest;
}

// `since`: the time from which on the condition holds; −1 while it does not.
void keep_time(double& since, bool holds, double now) {
    if (!holds || now < since) since = -1;
    if (holds && since < 0) since = now;
}

bool lasts(double since, double for_seconds, double now) { return since >= 0 && now - since >= for_seconds; }

// The most that each sensor of the subject has read in this run; at its start, in the last one.
void remember_readings(PromptMemory& memory, const LabView& view) {
    const VehicleView* subject = subject_of(view);
    const bool begins = !std::exchange(memory.has_begun, view.now->tick > 0);
    if (view.now->tick == 0 || !subject) return;
    const std::span<const float> values = readings(*view.now, *subject);
    const bool stands = std::fabs(subject->speed) < standstill && is_halted(*subject);
    memory.halted_blind = (memory.halted_blind && !begins) || (stands && is_blind(*view.now, *subject));
    if (begins || memory.most_read.size() != values.size()) memory.most_read.assign(values.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) memory.most_read[i] = std::max(memory.most_read[i], values[i]);
}

// Why a vehicle does not move.
std::string_view hint_at_rest(const VehicleView& vehicle) {
    if (is_halted(vehicle)) return "hint.halted";
    return wheels_push(vehicle.motor[0], vehicle.motor[1]) ? "hint.blocked" : "hint.stuck";
}

}  // namespace

bool all_steps_done(const LessonView& lesson) {
    return std::all_of(lesson.verdicts.begin(), lesson.verdicts.end(), [](const Verdict& v) { return v.done; });
}

bool is_blind(const Snapshot& now, const VehicleView& vehicle) {
    const auto begin = now.sensed.begin() + vehicle.first_sensed;
    const auto count = static_cast<std::ptrdiff_t>(kind_of(now, vehicle).sensors.size());
    return count > 0 && std::all_of(begin, begin + count, [](float value) { return value < sees_nothing; });
}

std::span<const float> readings(const Snapshot& now, const VehicleView& vehicle) {
    const auto first = static_cast<std::size_t>(vehicle.first_sensed);
    return std::span(now.sensed).subspan(first, kind_of(now, vehicle).sensors.size());
}

bool is_held(const LabView& view, const VehicleView& vehicle) {
    return view.mode == Mode::playing && std::fabs(vehicle.speed) < standstill && !is_halted(vehicle);
}

const VehicleView* subject_of(const LabView& view) {
    const auto& vehicles = view.now->vehicles;
    if (vehicles.size() == 1) return &vehicles.front();
    const int kind = view.lesson ? subject_kind(*view.now->scene) : -1;
    const auto found =
        std::find_if(vehicles.begin(), vehicles.end(), [&](const VehicleView& v) { return v.kind == kind; });
    return found == vehicles.end() ? nullptr : &*found;
}

std::optional<TriedBrain> tried_now(const LabView& view) {
    const Snapshot& now = *view.now;
    if (const VehicleView* subject = subject_of(view))
        return TriedBrain{brain_of(now, *subject), kind_of(now, *subject).sensors};
    const int kind = view.lesson ? subject_kind(*now.scene) : -1;
    const auto index = static_cast<std::size_t>(kind);
    if (kind < 0 || index >= now.kind_brains.size()) return std::nullopt;
    return TriedBrain{now.kind_brains[index], now.scene->kinds[index].sensors};
}

bool are_equal(const std::optional<TriedBrain>& a, const std::optional<TriedBrain>& b) {
    return a && b && (a->brain == b->brain || *a->brain == *b->brain) && a->sensors == b->sensors;
}

bool is_as_at_start(const PromptMemory& memory, const LabView& view) {
    return are_equal(memory.at_start, tried_now(view));
}

bool has_changed_since_start(const PromptMemory& memory, const LabView& view) {
    return view.now->tick > 0 && memory.at_start && tried_now(view) && !is_as_at_start(memory, view);
}

void watch_run(PromptMemory& memory, const LabView& view) {
    const Snapshot& now = *view.now;
    const VehicleView* vehicle = now.vehicles.size() == 1 ? &now.vehicles.front() : nullptr;
    const bool counts = vehicle && vehicle->driver == Driver::brain && now.tick > 0;
    const bool stands = vehicle && std::fabs(vehicle->speed) < standstill;
    keep_time(memory.blind_since, counts && !stands && is_blind(now, *vehicle), now.seconds);
    keep_time(memory.still_since, counts && stands, now.seconds);
    keep_time(memory.dark_since, counts && is_blind(now, *vehicle), now.seconds);
    if (now.tick == 0) memory.at_start = tried_now(view);
    remember_readings(memory, view);
}

Prompt way_out(const PromptMemory& memory, const LabView& view) {
    if (lasts(memory.still_since, stuck_after, view.now->seconds))
        return {"button.reset", hint_at_rest(view.now->vehicles.front())};
    if (lasts(memory.blind_since, lost_after, view.now->seconds)) return {"button.reset", "hint.lost"};
    return {};
}

bool is_completing_a_step(const LessonView& lesson) {
    constexpr float soon = 5;  // s
    const auto lasts_for = [](const Verdict& verdict, float most) {
        return !verdict.done && !verdict.lost &&
               std::any_of(verdict.measures.begin(), verdict.measures.end(), [most](const Measure& m) {
                   return m.unit == "s" && !m.at_most && !m.best && m.value > 0 && m.value < m.needed &&
                          m.needed - m.value <= most;
               });
    };
    const auto& verdicts = lesson.verdicts;
    return std::any_of(verdicts.begin(), verdicts.end(), [&](const Verdict& v) { return lasts_for(v, soon); }) ||
           std::all_of(verdicts.begin(), verdicts.end(),
                       [&](const Verdict& v) { return v.done || lasts_for(v, INFINITY); });
}

bool waits_for_a_step(const LabView& view) {
    const auto& steps = view.lesson->exercise->steps;
    const auto& verdicts = view.lesson->verdicts;
    for (std::size_t i = 0; i < std::min(steps.size(), verdicts.size()); ++i)
        if (!verdicts[i].done && !verdicts[i].lost && static_cast<double>(steps[i].check.earliest) > view.now->seconds)
            return true;
    return false;
}

bool has_missed_a_change(const PromptMemory& memory, const LabView& view) {
    if (!lasts(memory.dark_since, lost_after, view.now->seconds) || waits_for_a_step(view)) return false;
    const auto& brain = brain_of(*view.now, view.now->vehicles.front());
    return memory.at_start && memory.at_start->brain != brain && memory.at_start->brain->wires != brain->wires;
}

bool has_failed(const LabView& view) {
    const auto& verdicts = view.lesson->verdicts;
    return view.now->seconds >= static_cast<double>(view.lesson->exercise->seconds) ||
           std::any_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.lost && !v.done; });
}

bool is_subject_gone(const LabView& view) {
    const Snapshot& now = *view.now;
    const int kind = view.lesson ? subject_kind(*now.scene) : -1;
    return now.tick > 0 && kind >= 0 &&
           std::none_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& v) { return v.kind == kind; });
}

void remember_failure(PromptMemory& memory, const LabView& view) {
    if (!view.lesson || view.now->tick == 0 || all_steps_done(*view.lesson) || !is_as_at_start(memory, view)) return;
    const bool is_out = !way_out(memory, view).anchor.empty() && !waits_for_a_step(view);
    if (!is_out && !has_failed(view) && !is_subject_gone(view)) return;
    if (are_equal(memory.failed, memory.at_start)) return;
    memory.failed = memory.at_start;
    memory.failed_base = view.features.breeding.base;
    memory.failed_generation = last_generation(view.features.breeding);
}

}  // namespace braitenlab::ui
