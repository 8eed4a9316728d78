#include "render/view/quality.h"

namespace braitenlab {

namespace {

// Measurements in a row. Fewer pictures a second are better than coarse ones, and the first ones are slow everywhere.
constexpr int slow_needed = 3, very_slow_needed = 8, fast_needed = 8, fast_needed_if_coarse = 2;

Quality beside(Quality level, int step) { return static_cast<Quality>(static_cast<int>(level) + step); }

}  // namespace

void QualityChoice::add(double seconds) {
    const bool lowest = level_ == Quality::low;
    slow_in_a_row_ = seconds > (lowest ? very_slow : slow) ? slow_in_a_row_ + 1 : 0;
    fast_in_a_row_ = seconds < (coarse_ ? fast_if_coarse : fast) ? fast_in_a_row_ + 1 : 0;
    if (slow_in_a_row_ >= (lowest ? very_slow_needed : slow_needed) && !coarse_) {
        if (lowest)
            coarse_ = true;
        else
            level_ = highest_ = beside(level_, -1);
        slow_in_a_row_ = fast_in_a_row_ = 0;
    } else if (fast_in_a_row_ >= (coarse_ ? fast_needed_if_coarse : fast_needed) && (coarse_ || level_ != highest_)) {
        if (!coarse_) level_ = beside(level_, 1);
        coarse_ = false;
        slow_in_a_row_ = fast_in_a_row_ = 0;
    }
}

}  // namespace braitenlab
