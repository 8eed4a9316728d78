// Where the card of the exercise stops when it scrolls by itself: at the top of a whole row, so that no line is cut
// below the goal.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Heights are window pixels from the top of the card's body.
struct ExerciseRows {
    enum class Aim { top, outcome, newest_hint };
    struct Part {
        float top = 0, end = 0;
    };

    std::vector<float> tops;               // of the rows drawn in this frame, ascending
    std::optional<float> first_open_step;  // its top
    Part outcome;                          // of the prediction; without hints from the first open step on
    Part newest_hint;
    Aim aim = Aim::top;
    int settling = 0;  // frames for which the card still scrolls, because rows around its aim appear in the next ones
};

// The first of these tops, ascending, that is `wanted` or more; where that is beyond `latest`, the last one before it.
// 0 without any.
float row_to_stop_at(std::span<const float> tops, float wanted, float latest);

// Call before the rows of a frame.
void begin_rows(ExerciseRows&);

// The next row begins at the cursor. Returns its top.
float begin_row(ExerciseRows&);

// Scrolls to this part in this frame and the next ones.
void aim_at(ExerciseRows&, ExerciseRows::Aim);

// Scrolls the body while it settles: to the first row with which the end of the aim is in sight, within a row where
// none is so, but not beyond the top of the aim. Call after the rows.
void scroll_to_aim(const Ui&, ExerciseRows&);

}  // namespace braitenlab::ui
