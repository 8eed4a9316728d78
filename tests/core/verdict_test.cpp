#include "core/evolve/verdict.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "core/maths/random.h"

namespace braitenlab::tests::verdict_test {
namespace {

using namespace evolve;

// Every second generation; score(predator, prey) by their indices.
Tournament made_up(std::size_t size, const std::function<float(std::size_t, std::size_t)>& score) {
    Tournament tournament;
    for (std::size_t i = 0; i < size; ++i) tournament.generations.push_back(2 * static_cast<int>(i));
    for (std::size_t predator = 0; predator < size; ++predator)
        for (std::size_t prey = 0; prey < size; ++prey) tournament.scores.push_back(score(predator, prey));
    return tournament;
}
float later(std::size_t a, std::size_t b) { return static_cast<float>(a) - static_cast<float>(b); }

TEST(Verdict, ChampionsThatBeatAllEarlierOpponentsAreInAnArmsRace) {
    const auto both =
        made_up(16, [](std::size_t predator, std::size_t prey) { return 0.5F + 0.03F * later(predator, prey); });
    for (const Side side : {Side::predator, Side::prey}) {
        const Verdict verdict = verdict_of(both, side);
        EXPECT_EQ(verdict.course, Course::arms_race);
        EXPECT_EQ(verdict.late, (Generations{24, 30}));
        EXPECT_EQ(verdict.earlier, (Generations{16, 22})) << "the smallest gain";
        EXPECT_NEAR(verdict.gain, 0.12F, 1e-5F);
    }
}

TEST(Verdict, OneSideAloneCanGain) {
    const auto hunters =
        made_up(16, [](std::size_t predator, std::size_t) { return 0.2F + 0.04F * static_cast<float>(predator); });
    EXPECT_EQ(verdict_of(hunters, Side::predator).course, Course::arms_race);
    EXPECT_EQ(verdict_of(hunters, Side::prey).course, Course::unclear) << "prey of all generations are the same";
}

TEST(Verdict, ChampionsThatLoseToForgottenOpponentsGoRoundInCircles) {
    // As rock, paper and scissors: a side beats what came four generations before it and loses to what came twelve
    // before.
    const auto circle = made_up(16, [](std::size_t predator, std::size_t prey) {
        return 0.5F + 0.4F * std::sin(later(predator, prey) * 6.2831853F / 16);
    });
    for (const Side side : {Side::predator, Side::prey}) {
        const Verdict verdict = verdict_of(circle, side);
        EXPECT_EQ(verdict.course, Course::circles);
        EXPECT_EQ(verdict.earlier, (Generations{0, 6}));
        EXPECT_LT(verdict.gain, -0.3F);
    }
}

TEST(Verdict, ADifferenceBelowTheThresholdIsUnclear) {
    const auto gain = [](float by) {
        return made_up(16, [by](std::size_t predator, std::size_t) { return predator >= 12 ? 0.5F + by : 0.5F; });
    };
    EXPECT_EQ(verdict_of(gain(least_gain - 0.01F), Side::predator).course, Course::unclear);
    EXPECT_EQ(verdict_of(gain(least_gain + 0.01F), Side::predator).course, Course::arms_race);
    EXPECT_EQ(verdict_of(gain(-least_gain - 0.01F), Side::predator).course, Course::circles);
}

TEST(Verdict, ChanceIsRarelyTakenForAChange) {
    constexpr int matrices = 300;
    int clear = 0;
    for (int seed = 0; seed < matrices; ++seed) {
        maths::Random random(static_cast<std::uint64_t>(seed), 7);
        const auto noise = made_up(21, [&](std::size_t, std::size_t) { return random.uniform(0, 1); });
        clear += verdict_of(noise, Side::predator).course != Course::unclear;
    }
    EXPECT_LT(clear, matrices / 10);
    EXPECT_GT(clear, 0) << "two standard errors are passed by chance now and then";
}

TEST(Verdict, FewGenerationsAndUnknownScoresSayNothing) {
    const auto race = [](std::size_t size) {
        return made_up(size, [](std::size_t predator, std::size_t) { return 0.1F * static_cast<float>(predator); });
    };
    EXPECT_EQ(verdict_of(race(least_generations - 1), Side::predator).course, Course::too_early);
    EXPECT_EQ(verdict_of(race(least_generations), Side::predator).course, Course::arms_race);
    Tournament unknown = race(least_generations);
    unknown.scores[5] = NAN;
    EXPECT_EQ(verdict_of(unknown, Side::predator).course, Course::too_early);
    EXPECT_EQ(verdict_of({}, Side::prey).course, Course::too_early);
}

}  // namespace
}  // namespace braitenlab::tests::verdict_test
