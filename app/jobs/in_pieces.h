// A run as a part of a job (app/jobs/jobs.h): a number of its ticks each step.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

namespace braitenlab {

// `Run` has advance(ticks), which is true once the run is complete. Then result(run) is the result of the part.
template <class Run, class Take>
class InPieces {
public:
    InPieces(Run run, std::size_t ticks, Take result) : run_(std::move(run)), ticks_(ticks), result_(result) {}

    std::optional<std::decay_t<std::invoke_result_t<Take&, Run&>>> operator()() {
        if (!run_.advance(ticks_)) return std::nullopt;
        return std::invoke(result_, run_);
    }
    float progress() const requires requires(const Run& run) { run.progress(); }
    { return run_.progress(); }

private:
    Run run_;
    std::size_t ticks_;
    Take result_;
};

}  // namespace braitenlab
