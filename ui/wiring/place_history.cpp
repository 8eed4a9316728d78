#include "ui/wiring/place_history.h"

#include <utility>

namespace braitenlab {
namespace {

constexpr std::size_t most_moves = 200;  // undo reaches this far back

}  // namespace

void PlaceHistory::note(int kind, int undo_depth, Places before, Places after) {
    if (before == after) return;
    undone_.clear();
    done_.push_back({kind, undo_depth, std::move(before), std::move(after)});
    if (done_.size() > most_moves) done_.erase(done_.begin());
}

bool PlaceHistory::can_undo(int kind, int undo_depth) const {
    return !done_.empty() && done_.back().kind == kind && done_.back().undo_depth == undo_depth;
}

bool PlaceHistory::can_redo(int kind, int undo_depth) const {
    return !undone_.empty() && undone_.back().kind == kind && undone_.back().undo_depth == undo_depth;
}

Places PlaceHistory::undo() {
    undone_.push_back(std::move(done_.back()));
    done_.pop_back();
    return undone_.back().before;
}

Places PlaceHistory::redo() {
    done_.push_back(std::move(undone_.back()));
    undone_.pop_back();
    return done_.back().after;
}

}  // namespace braitenlab
