// Judges an exercise's steps from the snapshots of a run; the window and the command line use the same referee.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/lesson/reference.h"
#include "core/world/command.h"
#include "core/world/snapshot.h"

namespace braitenlab {

// One step, judged: once done it stays done, and its measures stay as they were then. Those of a lost step stay as they
// were at the end of the exercise's time.
struct Verdict {
    bool done = false;
    std::vector<Measure> measures;  // at least one; the values to show
    bool lost = false;              // it cannot be done any more in this run
};

// Everything that a referee remembers of the run: enough to continue from the tick that it saw last.
struct RefereeState {
    struct Judged {
        CheckState check;
        bool done = false;
    };
    std::vector<Judged> steps;        // as Exercise::steps
    std::vector<VehicleId> subjects;  // as Scene::starts; see Subjects
    std::uint64_t tick = 0;           // of the last snapshot
    bool begun = false;               // a snapshot was seen
    bool disturbed = false;           // something was changed by hand after the first tick, or the start was not seen
    bool by_hand = false;             // see Referee::by_hand
    bool changed = false;             // see Referee::as_given
    bool was_changed = false;         // changed at a tick after the first, which is not taken back
};

class Referee {
public:
    explicit Referee(const Exercise&);

    // Call for the start and after every tick. A snapshot of an earlier tick than the last one, or of tick 0, begins a
    // new run; the same tick again changes nothing.
    void watch(const Snapshot&);

    // Call after a command, with the moment after it. From now on the run does not count when it has begun and the
    // command changes something else than the student may change (see Submission).
    void watch(const Snapshot&, const Command&);

    // True when this run does not count: its start was not watched, it was disturbed by a command, or at some tick
    // after the first the scene was not the exercise's (see is_as_given) or a vehicle was not driven as in the
    // exercise. Steps done before stay done.
    bool by_hand() const { return state_.by_hand; }

    // True if every brain, sensor and body has been that of the exercise's file since the start: a change that is
    // undone before the run goes on does not count.
    bool as_given() const { return !state_.changed; }

    std::vector<Verdict> verdicts() const;  // one per step
    bool passed() const;                    // every step is done
    bool lost() const;                      // a step that is not done cannot be done any more in this run

    // Takes a referee of the same exercise back to an earlier state of its own, or on to a later one.
    const RefereeState& state() const { return state_; }
    void restore(RefereeState state) { state_ = std::move(state); }

private:
    // What of the run's scene is as in the exercise. It is compared again once the scene or a brain is another one.
    struct Comparison {
        Comparison() = default;
        Comparison(const Exercise&, const Snapshot&);

        std::shared_ptr<const Scene> scene{};
        std::vector<std::shared_ptr<const BrainGraph>> brains{};  // Snapshot::kind_brains
        int subject = -1;                                         // see subject_kind()
        bool is_given = false;        // see is_as_given(); other kinds than the subject have their brains
        bool has_every_part = false;  // each kind has its brain, sensors and body
    };

    void begin(const Snapshot&);
    const Comparison& compared(const Snapshot&);
    bool is_undisturbed(const Snapshot&);
    void note_changes(const Snapshot&);

    const ReferencePath* reference_at(const Snapshot&);

    std::shared_ptr<const Exercise> exercise_;
    std::shared_ptr<Reference> reference_;  // null until a step needs it
    RefereeState state_;
    Comparison comparison_;
    std::vector<bool> done_;  // of the steps; kept between ticks for its memory
};

// The state as JSON, and back. nullopt when the text is no state of a referee of this exercise.
std::string write_referee_state(const RefereeState&);
std::optional<RefereeState> read_referee_state(std::string_view json, const Exercise&);

// Whether a scene offers what the exercise's scene offers. The subject's kind may have another brain, other sensors and
// another body, as these are what the student changes.
bool is_as_given(const Exercise&, const Scene&);

}  // namespace braitenlab
