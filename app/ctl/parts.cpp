#include "app/ctl/parts.h"

#include <algorithm>

#include "app/ctl/ctl.h"
#include "app/ctl/ranks.h"
#include "app/jobs/jobs.h"
#include "app/platform/platform.h"

namespace braitenlab {

Result<Part> part_of(std::string_view text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view command = text.substr(0, end), rest = text.substr(std::min(end + 1, text.size()));
    if (command == "breed") return part_of_breeding(rest);
    if (command == "map") return part_of_map(rest);
    if (command == "study") return part_of_study(rest);
    return Error{"a list of parts of an unknown command; start the same program everywhere"};
}

struct PartRunner::Running {
    int wanted_threads = 0;
    Jobs jobs;
};

PartRunner::PartRunner(int threads)
    : running_(new Running{threads, Jobs(has_ranks() ? worker_threads_of_rank(threads) : threads_for(threads))}) {}
PartRunner::~PartRunner() = default;

int PartRunner::threads() const {
    return has_ranks() ? threads_of_ranks(running_->wanted_threads) : running_->jobs.threads();
}

Result<std::vector<Numbers>> PartRunner::run(const Parts& parts) {
    if (has_ranks()) return run_on_ranks(running_->jobs, running_->wanted_threads, parts);
    auto job = running_->jobs.submit(
        parts.count, [&parts](std::size_t part) { return is_told_to_end() ? Numbers{} : parts.part(part); });
    if (parts.meanwhile) parts.meanwhile();
    running_->jobs.finish();
    auto numbers = job.take();
    if (!*numbers) return numbers->error();
    return is_told_to_end() ? std::vector<Numbers>{} : std::move(**numbers);
}

}  // namespace braitenlab
