// What the parts of the lab ask of each other: lab.cpp opens, plays and shows it, lab_requests.cpp does what is asked,
// lab_selection.cpp, lab_driving.cpp and lab_lesson.cpp keep what their names say, past.cpp goes back in time.
#pragma once

#include "app/lab.h"

namespace braitenlab {

void set_mode(Lab&, Mode);

// Carries an edit out, or says why not; true when it was done.
bool apply(Lab&, const Command&, std::uint64_t gesture = 0);

// ── Driving ──
void drive(Lab&);  // a person takes the selected vehicle's wheel, or gives it back to who had it

// ── Selection ──
const VehicleView* selected_vehicle(const Lab&);  // null when there is none
Thing chosen(const Lab&);                         // the lamp or obstacle that is selected, else the vehicle
void select(Lab&, const Thing&);
void take(Lab&, const Thing&);  // a lamp or an obstacle; the selected vehicle stays selected
void select_neighbour(Lab&, int step);

// After anything that may have changed who is there: a vehicle stays selected as long as there is one.
void keep_selection(Lab&);

// The selected vehicle, as it was a tick ago, may have died since: the next of its kind is selected, which is told.
void mourn(Lab&, const VehicleView& selected);

// ── Exercise ──
void watch(Lab&);                       // shows the moment to the judge, and what it says to the panels
void tell_judge(Lab&, const Command&);  // that a hand has done this
void show_hint(Lab&);
void reset(Lab&);             // the run; see Session::reset
void restart_exercise(Lab&);  // as it was on opening, brain and all

}  // namespace braitenlab
