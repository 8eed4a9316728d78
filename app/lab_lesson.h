// The open exercise: its referee, its hints, and its reset. Each function does nothing where no exercise is open,
// except where it says otherwise.
#pragma once

#include "app/lab.h"

namespace braitenlab {

// Shows the current moment to the referee and its verdicts to the panels.
void watch(Lab&);

// Tells the referee that the user has applied this command.
void tell_referee(Lab&, const Command&);

// Call once per turn, after Jobs::deliver. Once every step is done, grades the submission from all starts in the
// background; shows progress and grade in the lesson's view. An edit of the submission cancels grading, and starts it
// again while every step is done.
void update_grading(Lab&, Jobs&);

// ── The referee in time. Its state is stored beside each keyframe of the session and recomputed from there. ──

// Steps the session. In the recorded past the referee sees the commands that the recording holds.
void step_session(Document&);

// Stores the referee's state when the present tick is that of a keyframe. Call after each tick and each command.
void record_referee(Document&);

// The state stored beside the last keyframe; null at the start of the run and when it is not known.
const RefereeState* referee_at_keyframe(const Document&);

// Takes the referee through the run from the last keyframe to the present moment. Call when the session has gone to
// another tick.
void recompute_referee(Document&);

// recompute_referee() with this state beside the last keyframe. Call when the session has gone to another run.
void restore_referee(Document&, const std::optional<RefereeState>&);

void show_hint(Lab&);

// Resets the run; see Session::reset. Works for every document.
void reset(Lab&);

// Resets the run, the brains and the progress to their state on opening. Without an exercise: reset().
void restart_exercise(Lab&);

}  // namespace braitenlab
