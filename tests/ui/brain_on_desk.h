// What tests of the brain card share: the brain of a requested edit, and lesions in it.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "desk.h"

namespace braitenlab::tests {

inline BrainGraph brain_asked_for(const Desk& desk) {
    const auto edits = desk.edits();
    if (edits.size() != 1) throw std::runtime_error("not one edit but " + std::to_string(edits.size()));
    EXPECT_NE(edits[0].gesture, 0u) << "a separate step of undo";
    return std::get<SetBrain>(edits[0].command).brain;
}

// Applies the requested edits, as the app does.
inline void give(Desk& desk, const BrainGraph& brain) {
    desk.now.brains[0] = std::make_shared<BrainGraph>(brain);
    desk.all.clear();
    desk.rest();
}

inline bool is_cut(const BrainGraph& brain, const char* from, const char* to) {
    return find_wire(brain, find_node(brain, std::string(from))->id, find_node(brain, std::string(to))->id)->cut;
}

}  // namespace braitenlab::tests
