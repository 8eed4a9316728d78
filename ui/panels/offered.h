// Which controls the open exercise offers.
#pragma once

#include "core/lesson/submission.h"
#include "ui/lab_view.h"

namespace braitenlab::ui {

// False outside an exercise, in free play, and in an exercise that offers all controls.
inline bool offers_some(const LabView& view) {
    return view.lesson && !view.lesson->attempt.work.free_play && !offers_all(*view.lesson->exercise);
}

// True for a control that is shown: a dial, or offer_parts::curves and ::sensors. The wiring editor is always
// reachable; what it changes outside the offers is not graded.
template <class Control>
bool is_offered(const LabView& view, Control control) {
    return !offers_some(view) || offers(*view.lesson->exercise, control);
}

// The shipped breeding that the exercise offers, "chase-ten"; empty: none.
inline std::string_view offered_breeding(const Exercise& exercise) {
    constexpr std::string_view stem = "breeding:";
    for (const std::string& offer : exercise.offers)
        if (offer.starts_with(stem)) return std::string_view(offer).substr(stem.size());
    return {};
}

}  // namespace braitenlab::ui
