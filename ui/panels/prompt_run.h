// What the prompts ask of the run: what the student's vehicle sees, whether it is stuck, and whether the run failed.
#pragma once

#include <optional>
#include <span>

#include "ui/lab_view.h"
#include "ui/panels/prompt_state.h"

namespace braitenlab::ui {

inline constexpr float sees_nothing = 0.02f;  // reading of a sensor, 0..1, below which it counts as blind

// The vehicle that the student changes: of several the first of the kind that the exercise is about. Null: none.
const VehicleView* subject_of(const LabView&);

// True once no vehicle that the student of the exercise changes is left: it was eaten or has used up its energy.
bool is_subject_gone(const LabView&);

// The readings of the vehicle's sensors, in their order.
std::span<const float> readings(const Snapshot&, const VehicleView&);

// True if the vehicle has sensors, and none of them reads anything.
bool is_blind(const Snapshot&, const VehicleView&);

// True for a vehicle that something holds although its motors turn: what its brain does then changes nothing.
bool is_held(const LabView&, const VehicleView&);

// What the student changes: of the subject, or of its kind when it is gone. nullopt: the scene has none.
std::optional<TriedBrain> tried_now(const LabView&);
bool are_equal(const std::optional<TriedBrain>&, const std::optional<TriedBrain>&);

// Call once a frame. A single vehicle that senses nothing or does not move needs a reset. In scenes with several
// vehicles both are common.
void watch_run(PromptMemory&, const LabView&);

// True if this run has shown the present brain and sensors from its start on: a reset alone then gives the same run.
bool is_as_at_start(const PromptMemory&, const LabView&);

// True if the run has not shown the present brain and sensors from its start on.
bool has_changed_since_start(const PromptMemory&, const LabView&);

// True if wires were changed in this run and the vehicle senses nothing: they then carry nothing, and the change shows
// after a reset only.
bool has_missed_a_change(const PromptMemory&, const LabView&);

// Reset, with the reason why the vehicle is stuck or lost; empty if it is neither.
Prompt way_out(const PromptMemory&, const LabView&);

// ── In an exercise ──

bool all_steps_done(const LessonView&);

// True if this run cannot complete every step any more.
bool has_failed(const LabView&);

// True if the run alone completes a step within the next seconds, or every step in the end: then no hint asks for a
// change.
bool is_completing_a_step(const LessonView&);

// True while a step is still to be judged at a later time, after lamps were switched for example: the vehicle may stand
// and see nothing until then.
bool waits_for_a_step(const LabView&);

// Notes that the brain and the sensors with which the run began have failed in it.
void remember_failure(PromptMemory&, const LabView&);

}  // namespace braitenlab::ui
