// Attempt: what a student has done so far at the open exercise, and how it stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/maths/vec.h"

namespace braitenlab {

// Why the last hand-in was not written.
enum class HandInRefusal { none, earlier_is_better, outside_offers, too_many_changes };

struct RefusedHandIn {
    HandInRefusal reason = HandInRefusal::none;
    int passed = 0, starts = 0;  // of the earlier hand-in; meaningful with earlier_is_better
    int needed = 0;              // starts that a hand-in must pass to be as good; meaningful with earlier_is_better
};

// Each part has a lifetime of its own; assign the part to begin it anew.
struct Attempt {
    // Until the exercise begins again for another student.
    struct Answers {
        int prediction = -1;                    // the option chosen, 0-based; −1: none yet
        std::vector<maths::vec2> drawn_path{};  // the prediction as a path on the floor, m; empty: none was drawn
        std::uint64_t drawn_seed = 0;           // of the run at whose start it was drawn
        int hints_shown = 0;                    // of Exercise::hints
        bool hint_ready = true;                 // the next hint, after the last one the solution, may be shown now
    } answers{};

    // Until the exercise is started over; undoing that restores it.
    struct Work {
        bool has_run = false;                  // played at least once
        int runs = 0;                          // begun
        bool outcome_known = false;            // a run of the scene as given has shown what was to be predicted
        bool free_play = false;                // all controls are shown, not only the offered ones
        bool solution_shown = false;           // the solution was set for the student
        bool compares = false;                 // the run with the solution is shown beside the student's
        std::string written{};                 // path of the last hand-in or lab record; empty: none
        RefusedHandIn refused{};               // the last request to hand in, if nothing was written
        std::vector<maths::vec2> real_path{};  // what was to be drawn, m; empty until the outcome is known
        float path_difference = 0;             // m, between both paths, see path_distance; valid with real_path
        bool path_reversed = false;            // drawn against the way it was driven; valid with real_path
    } work{};

    // Until another exercise is opened; the progress of the student keeps them.
    std::string notes{};
};

// How the present submission stands. It follows from the vehicle, the last grade and the student's progress; updated
// once per turn.
struct Standing {
    bool is_graded = false;           // it has a grade
    bool changed_since_done = false;  // every step was done, and the brain was changed since, or during the run
    bool outside_offers = false;      // it changes what is not offered: it is not graded
    bool too_many_changes = false;    // it changes more controls than Exercise::changes: it is not graded
    bool passed_before = false;       // the student has passed the exercise, with any brain
    bool has_kept = false;            // the student's progress has another submission
    std::optional<std::size_t> starts_tested{};  // so far, while it is graded
};

// Before anything is answered.
inline Attempt::Answers unanswered(const Exercise& exercise) { return {.hint_ready = !exercise.hints.empty()}; }

inline bool has_predicted(const Attempt::Answers& a) { return a.prediction >= 0 || !a.drawn_path.empty(); }

}  // namespace braitenlab
