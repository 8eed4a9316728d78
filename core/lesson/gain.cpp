#include "core/lesson/gain.h"

#include <algorithm>
#include <cmath>

#include "core/lesson/submission.h"

namespace braitenlab {

namespace {

float lacking(const Measure& measure) {
    if (measure.met || !std::isfinite(measure.value)) return 0;
    const bool is_above = measure.needed_most && measure.value > *measure.needed_most;
    const float needed = is_above ? *measure.needed_most : measure.needed;
    return std::min(1.0f, std::fabs(measure.value - needed) / std::max(0.1f, std::fabs(needed)));
}

}  // namespace

float lacking(const StartResult& run) {
    float all = 0;
    for (const Verdict& verdict : run.verdicts) {
        if (verdict.done) continue;
        float most = 0.01f;
        for (const Measure& measure : verdict.measures) most = std::max(most, lacking(measure));
        all += most;
    }
    return all;
}

std::vector<Submission> tries_of(const Exercise& exercise, const Submission& submission, const SensorPair& pair) {
    std::vector<Submission> tries{submission};
    for (const Offer& offer : offered_dials(exercise)) {
        const DialRange limits = range(offer.dials.front());
        for (std::size_t i = 0; i < values_tried; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(values_tried - 1);
            Submission& changed = tries.emplace_back(submission);
            for (const Dial dial : offer.dials)
                turn(changed.brain, dial, limits.low + share * (limits.high - limits.low), pair);
        }
    }
    return tries;
}

std::vector<float> gains_of(const std::vector<StartResult>& runs) {
    std::vector<float> gains;
    if (runs.empty()) return gains;
    const float lacks = lacking(runs.front());
    for (std::size_t first = 1; first + values_tried <= runs.size(); first += values_tried) {
        float least = lacks;
        for (std::size_t i = 0; i < values_tried; ++i) least = std::min(least, lacking(runs[first + i]));
        gains.push_back(lacks > 0 ? (lacks - least) / lacks : 0);
    }
    return gains;
}

}  // namespace braitenlab
