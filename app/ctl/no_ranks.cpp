#include "app/ctl/ranks.h"

namespace braitenlab {

int run_in_ranks(const std::function<int()>& command) { return command(); }
bool has_ranks() { return false; }
int threads_of_rank() { return 0; }
int worker_threads_of_rank(int wanted) { return wanted; }
int threads_of_ranks(int wanted) { return wanted; }
Result<std::vector<Numbers>> run_on_ranks(Jobs&, int, const Parts&) { return std::vector<Numbers>{}; }

}  // namespace braitenlab
