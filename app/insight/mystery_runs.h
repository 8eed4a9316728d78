// Mystery brain: hides the brain of a kind, adds a vehicle for another brain in the same body, and scores that brain in
// the background.
#pragma once

#include <cstdint>
#include <optional>

#include "app/jobs/jobs.h"
#include "core/insight/mystery.h"

namespace braitenlab {

struct Lab;
struct LabView;
struct MysteryRequest;
struct MysteryView;

struct MysteryRuns {
    std::uint64_t run = 0;                               // Document::run_id of what follows
    std::optional<insight::MysteryQuestion> question{};  // asked, or answered by `score`
    std::optional<Job<insight::MysteryScore>> job{};
    std::optional<insight::MysteryScore> score{};
    std::optional<Error> error{};
    bool begins = false;  // the job is submitted at the next update
};

void handle_mystery(Lab&, const MysteryRequest&);

// Call once per turn, after Jobs::deliver.
void update_mystery(Lab&, Jobs&);

bool is_computing(const MysteryRuns&);

// Points into the lab.
MysteryView mystery_of(const Lab&);

}  // namespace braitenlab
