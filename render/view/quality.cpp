#include "render/view/quality.h"

namespace braitenlab {

namespace {

constexpr int slow_needed = 3, fast_needed = 8;  // measurements in a row

Quality beside(Quality level, int step) { return static_cast<Quality>(static_cast<int>(level) + step); }

}  // namespace

void QualityChoice::add(double seconds) {
    slow_in_a_row_ = seconds > slow ? slow_in_a_row_ + 1 : 0;
    fast_in_a_row_ = seconds < fast ? fast_in_a_row_ + 1 : 0;
    if (slow_in_a_row_ >= slow_needed && level_ != Quality::low) {
        level_ = highest_ = beside(level_, -1);
        slow_in_a_row_ = fast_in_a_row_ = 0;
    } else if (fast_in_a_row_ >= fast_needed && level_ != highest_) {
        level_ = beside(level_, 1);
        slow_in_a_row_ = fast_in_a_row_ = 0;
    }
}

}  // namespace braitenlab
