// Mystery brain: hides the brain of a kind, adds a vehicle for another brain in the same body, and scores that brain in
// the background.
#pragma once

#include <cstdint>

#include "app/jobs/asked.h"
#include "core/insight/mystery.h"

namespace braitenlab {

struct Workspace;
struct MysteryRequest;
struct MysteryView;

struct MysteryRuns {
    std::uint64_t run = 0;  // Document::run_id of the score
    Asked<insight::MysteryQuestion, insight::MysteryScore> score{};
};

void handle_mystery(MysteryRuns&, Workspace&, const MysteryRequest&);

// Call once per turn, after Jobs::deliver.
void update_mystery(MysteryRuns&, const Workspace&, Jobs&);

bool is_computing(const MysteryRuns&);

// Points into the runs.
MysteryView mystery_of(const MysteryRuns&, const Workspace&);

}  // namespace braitenlab
