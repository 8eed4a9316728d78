// Undo for what is no edit of a brain: where a person has put its nodes.
//
// Edits of brains are undone by the lab. Which of the two came last is told by the lab's undo depth at the time.
#pragma once

#include <optional>
#include <vector>

#include "ui/wiring/tidy.h"

namespace braitenlab {

class PlaceHistory {
public:
    // Nodes were moved from `before` to `after`, on the vehicle's kind, when so many edits could be undone.
    void note(int kind, int undo_depth, Places before, Places after);

    // Whether the last thing done, or undone, was such a move.
    bool can_undo(int kind, int undo_depth) const;
    bool can_redo(int kind, int undo_depth) const;

    // The places to go back or forward to. Precondition: can_undo, can_redo.
    Places undo();
    Places redo();

private:
    struct Move {
        int kind, undo_depth;
        Places before, after;
    };
    std::vector<Move> done_, undone_;
};

}  // namespace braitenlab
