// The processes (ranks) of an MPI job: ranks.cpp in braitenctl-mpi, no_ranks.cpp in braitenctl, where there are none.
//
// Rank 0 runs the command, the others compute parts for it. For each list of parts rank 0 sends a text, of which each
// rank makes the same list, and then numbers of parts as ranks ask for them. Only numbers come back, each with the
// index of its part, so that neither the number of ranks nor their speed changes a result.
#pragma once

#include <functional>
#include <vector>

#include "app/ctl/parts.h"

namespace braitenlab {

class Jobs;  // app/jobs/jobs.h

// Returns the exit code of the command, which only the first rank runs. Each rank ends at once when the launcher is
// gone. Fails where the launcher has started processes that do not find each other.
int run_in_ranks(const std::function<int()>& command);

// True in rank 0 of several.
bool has_ranks();

// Threads that this rank may use, so that the ranks of a computer have one for each of its processors; 0 without ranks.
int threads_of_rank();
// The same without the one that looks for messages, which computes as well; `wanted` instead, if that is not 0.
int worker_threads_of_rank(int wanted);
// Of all ranks; `wanted` in each, if that is not 0.
int threads_of_ranks(int wanted);

// PartRunner::run() on all ranks. Precondition: has_ranks().
Result<std::vector<Numbers>> run_on_ranks(Jobs&, int wanted_threads, const Parts&);

}  // namespace braitenlab
