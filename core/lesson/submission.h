// What a student hands in for an exercise, and whether it keeps to the controls that the exercise offers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/lesson/exercise.h"
#include "core/world/snapshot.h"

namespace braitenlab {

Submission as_shipped(const Exercise&);
Submission with_brain(const Exercise&, BrainGraph);  // as shipped but for the brain
Submission with_solution(const Exercise&);

// What the first vehicle of a run of the exercise has now; when it is gone, what its kind has.
Submission submission_of(const Exercise&, const Snapshot&);

// The exercise's scene in which the first vehicle's kind has the submission.
Scene scene_with(const Exercise&, const Submission&);

// A control that an exercise can offer: dials that move together ("LL=RR"), or a part.
struct Offer {
    std::string text;         // as in the file
    std::vector<Dial> dials;  // empty for a part
};

// The parts that an exercise can offer besides dials.
namespace offer_parts {
inline constexpr std::string_view wiring = "wiring";    // all nodes and wires
inline constexpr std::string_view curves = "curves";    // the curves of the wires that the dials belong to
inline constexpr std::string_view sensors = "sensors";  // the values of the sensors; not their number and names
// What the errors of copies can change (core/brain/mutate.h); the student chooses among the copies.
inline constexpr std::string_view selection = "selection";
inline constexpr std::string_view all[]{wiring, curves, sensors, selection};
}  // namespace offer_parts

// nullopt for a text that is neither a part nor dials joined by '='.
std::optional<Offer> parse_offer(std::string_view);

// True if the exercise offers all controls, or this one. Precondition of the second: one of offer_parts.
bool offers_all(const Exercise&);
bool offers(const Exercise&, Dial);
bool offers(const Exercise&, std::string_view part);

// The shipped breeding that the exercise offers, "chase-ten"; empty: none.
std::string_view offered_breeding(const Exercise&);

// The offered dials, in the order of the file.
std::vector<Offer> offered_dials(const Exercise&);

// True if both have the same brain, sensors and body. Places and the order of nodes and wires do not count.
bool is_same_submission(const Submission&, const Submission&);

// True if the submission is not as shipped.
bool is_edited(const Exercise&, const Submission&);

// What the submission changes that the exercise does not offer: names of dials, "wiring", "curves", "sensors", "body".
// Lesions and learning of the wires that the dials belong to are "wiring".
// Empty when it keeps to the offered controls.
std::vector<std::string> outside_offers(const Exercise&, const Submission&);

// True if the submission changes more offered controls than Exercise::changes.
bool changes_too_many(const Exercise&, const Submission&);

// True if the submission changes nothing but offered controls, and no more of them than Exercise::changes.
bool keeps_to_offers(const Exercise&, const Submission&);

// Number of offered controls with another value than as shipped. Dials that move together are one control.
int changed_controls(const Exercise&, const Submission&);

}  // namespace braitenlab
