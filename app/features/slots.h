// Slots A and B: two stored brains with their sensors, and their runs from the same start.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/asked.h"
#include "core/insight/compare.h"
#include "core/session/session.h"
#include "core/world/character.h"

namespace braitenlab {

struct Workspace;
struct SlotsView;
struct SlotRequest;

// A comparison of both slots.
struct SlotRuns {
    std::uint64_t run = 0, seed = 0;  // Document::run_id and the seed of the run
    std::int64_t edits = 0;           // Document::edits after A was put into the vehicle
    VehicleId vehicle = no_vehicle;
    insight::CompareQuestion question;
    std::array<insight::Design, 2> designs;
    insight::Design before;  // of the vehicle
};

// A person who opens another document, or goes to another page of a lecture, begins with empty slots. They stay when
// the same file is read again, or the document of an exercise changes places with its scene. The runs end with the
// document, and when a slot changes.
struct Slots {
    std::array<std::optional<insight::Design>, 2> stored{};
    std::array<std::string, 2> kinds{};  // name of the vehicle's kind
    std::array<Character, 2> characters{};
    std::size_t current = 0;                                    // stored or put last
    Asked<SlotRuns, std::vector<insight::ComparedRun>> runs{};  // two
};

// Stores the selected vehicle's brain in the first empty slot. With both in use: puts the other brain into the vehicle
// if the vehicle has one of the two, else stores the edited brain in the slot that was used last.
void store_or_swap(Slots&, Workspace&);

// Puts the brain of a slot into the vehicle, as one step of undo; or stores the vehicle's brain in the slot.
void handle_slot(Slots&, Workspace&, const SlotRequest&);

// The stored brains without their runs.
Slots without_runs(const Slots&);

// Forgets both brains and their runs. The vehicle keeps the brain that it has.
void empty_slots(Slots&);

// True if both runs may be compared now; else says why not.
bool can_compare_slots(const Slots&, Workspace&);
// Puts A into the vehicle, plays, and asks for both runs. What needed no saving before needs none then. Precondition:
// can_compare_slots(), and the run was reset.
void compare_slots(Slots&, Workspace&);

// Call once per turn, after Jobs::deliver.
void update_slots(Slots&, const Workspace&, Jobs&);

// Forgets both runs and gives the vehicle the brain that it had before, unless it has been edited since. What needed no
// saving before needs none then.
void end_comparison(Slots&, Workspace&);

// While the run of A is shown that was asked to be compared: the same run with the brain that the vehicle had before,
// so that what is kept after a crash is the person's own work. Else nullopt. Costs the steps since the run's last
// keyframe.
std::optional<Session> session_with_own_brain(const Slots&, const Workspace&);

// True at the last tick of the compared runs, while the run on the screen is that of A.
bool ends_comparison(const Slots&, const Workspace&);

bool is_computing(const Slots&);

// Points into the slots.
SlotsView slots_of(const Slots&, const Workspace&);

}  // namespace braitenlab
