#include "app/jobs/jobs.h"

#include <chrono>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "core/world/world.h"
#include "tests/core/scenes.h"

namespace braitenlab {
namespace {

using namespace std::chrono_literals;

// Delivers until the job has a result. A part that never ends is stopped by the time limit of the test program.
template <class T>
Result<T> result_of(Jobs& jobs, Job<T>& job) {
    for (;;) {
        jobs.deliver(1ms);
        if (auto result = job.take()) return *result;
        std::this_thread::sleep_for(100us);
    }
}

// Waits for another thread; false after ten seconds.
template <class Condition>
bool becomes_true(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + 10s;
    while (!condition() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(100us);
    return condition();
}

// A simulation that is run in steps of 25 ticks; gives the hash of the world after 100.
class Simulation {
public:
    explicit Simulation(std::uint64_t seed) : world_(std::move(*World::create(tests::crowd(30), seed))) {}
    std::optional<std::uint64_t> operator()() {
        for (int i = 0; i < 25; ++i) world_.step();
        return world_.tick() < 100 ? std::nullopt : std::optional(world_.hash());
    }
    float progress() const { return static_cast<float>(world_.tick()) / 100; }

private:
    World world_;
};

// Depends on the order of the values.
std::uint64_t mix(const std::vector<std::uint64_t>& values) {
    return std::accumulate(values.begin(), values.end(), std::uint64_t{1},
                           [](std::uint64_t sum, std::uint64_t value) { return sum * 31 + value; });
}

class JobsOnThreads : public testing::TestWithParam<int> {
protected:
    Jobs jobs{GetParam()};
};
INSTANTIATE_TEST_SUITE_P(, JobsOnThreads, testing::Values(0, 1, 2, 4), testing::PrintToStringParamName());

TEST_P(JobsOnThreads, GiveTheSameResultOnAnyNumberOfThreads) {
    std::vector<std::uint64_t> expected;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        Simulation simulation(seed);
        std::optional<std::uint64_t> hash;
        while (!hash) hash = simulation();
        expected.push_back(*hash);
    }
    Job<std::uint64_t> job = jobs.submit(
        12, [](std::size_t part) { return Simulation(part); }, mix);
    const auto result = result_of(jobs, job);
    ASSERT_TRUE(result);
    EXPECT_EQ(*result, mix(expected));
}

TEST_P(JobsOnThreads, ReduceInTheOrderOfTheParts) {
    const auto late_first = [](std::size_t part) {
        std::this_thread::sleep_for(std::chrono::milliseconds(8 - part));
        return std::to_string(part);
    };
    Job<std::string> job = jobs.submit(8, late_first, [](const std::vector<std::string>& parts) {
        return std::accumulate(parts.begin(), parts.end(), std::string());
    });
    EXPECT_EQ(*result_of(jobs, job), "01234567");
}

TEST_P(JobsOnThreads, GiveOneResultPerPartWithoutAReduction) {
    Job<std::vector<bool>> job = jobs.submit(5, [](std::size_t part) { return part % 2 == 0; });
    EXPECT_EQ(*result_of(jobs, job), (std::vector<bool>{true, false, true, false, true}));
    EXPECT_FALSE(job.active());
    EXPECT_FALSE(job.take()) << "a result is taken once";
}

TEST_P(JobsOnThreads, CallASingleStepUntilItHasAResult) {
    Job<std::uint64_t> job = jobs.submit(Simulation(3));
    Simulation expected(3);
    std::optional<std::uint64_t> hash;
    while (!hash) hash = expected();
    EXPECT_EQ(*result_of(jobs, job), *hash);
    Job<bool> answer = jobs.submit([calls = 0]() mutable { return ++calls < 3 ? std::nullopt : std::optional(true); });
    EXPECT_TRUE(*result_of(jobs, answer));
}

TEST_P(JobsOnThreads, ReduceNothingForAJobWithoutParts) {
    Job<std::size_t> job = jobs.submit(
        0, [](std::size_t part) { return part; }, [](const std::vector<std::size_t>& parts) { return parts.size(); });
    jobs.deliver(0ns);
    EXPECT_EQ(job.progress().fraction, 1.0f);
    const auto result = job.take();
    ASSERT_TRUE(result);
    EXPECT_EQ(**result, 0u);
}

TEST_P(JobsOnThreads, ReportTheFirstExceptionInTheOrderOfTheParts) {
    Job<std::vector<std::size_t>> job = jobs.submit(6, [](std::size_t part) -> std::size_t {
        if (part < 2) return part;
        std::this_thread::sleep_for(std::chrono::milliseconds(6 - part));
        throw std::runtime_error("part " + std::to_string(part));
    });
    const auto result = result_of(jobs, job);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().text(), "a background job failed: part 2");
}

TEST_P(JobsOnThreads, ReportAnExceptionInTheReduction) {
    Job<int> job = jobs.submit(
        2, [](std::size_t) { return 1; }, [](const std::vector<int>&) -> int { throw 1; });
    const auto result = result_of(jobs, job);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().text(), "a background job failed: unknown exception");
}

TEST_P(JobsOnThreads, DeliverNothingOfACancelledJob) {
    auto steps = std::make_shared<std::atomic<int>>(0);
    const auto endless = [steps](std::size_t) {
        return [steps]() -> std::optional<int> {
            ++*steps;
            return std::nullopt;
        };
    };
    auto job = jobs.submit(3, endless);
    EXPECT_TRUE(becomes_true([&] {
        jobs.deliver(0ns);
        return *steps > 5;
    }));
    job.cancel();
    EXPECT_FALSE(job.active());
    jobs.finish();  // returns, since no further step begins
    const int steps_by_then = *steps;
    jobs.deliver(1ms);
    EXPECT_EQ(*steps, steps_by_then);
    EXPECT_FALSE(job.take());
    EXPECT_EQ(job.progress().parts, 0u);
}

TEST_P(JobsOnThreads, CancelAJobWhoseHandleIsReplaced) {
    const auto endless = [](std::size_t) { return []() -> std::optional<int> { return std::nullopt; }; };
    auto job = jobs.submit(2, endless, [](std::vector<int>) { return 1; });
    jobs.deliver(0ns);
    job = jobs.submit(
        1, [](std::size_t) { return 2; }, [](std::vector<int> parts) { return parts[0]; });
    EXPECT_EQ(*result_of(jobs, job), 2);
    jobs.finish();
}

TEST_P(JobsOnThreads, EndTheirThreadsOnDestruction) {
    auto steps = std::make_shared<std::atomic<int>>(0);
    Job<std::vector<int>> job;
    {
        Jobs inner(GetParam());
        job = inner.submit(4, [steps](std::size_t) {
            return [steps]() -> std::optional<int> {
                ++*steps;
                return std::nullopt;
            };
        });
        EXPECT_TRUE(becomes_true([&] {
            inner.deliver(0ns);
            return *steps > 5;
        }));
    }
    const int steps_by_then = *steps;
    std::this_thread::sleep_for(2ms);
    EXPECT_EQ(*steps, steps_by_then);
    EXPECT_FALSE(job.active());
    EXPECT_FALSE(job.take());
}

TEST_P(JobsOnThreads, KeepAShortJobFromWaitingForALongOne) {
    const auto endless = [](std::size_t) { return []() -> std::optional<int> { return std::nullopt; }; };
    auto long_job = jobs.submit(20, endless);
    Job<std::vector<std::size_t>> short_job = jobs.submit(3, [](std::size_t part) { return part; });
    EXPECT_TRUE(result_of(jobs, short_job));
    EXPECT_TRUE(long_job.active());
}

TEST_P(JobsOnThreads, CountCompletePartsAndTheProgressInsideParts) {
    auto may_end = std::make_shared<std::atomic<bool>>(false);
    struct Half {
        std::shared_ptr<std::atomic<bool>> may_end;
        bool at_once;
        std::optional<int> operator()() const { return at_once || *may_end ? std::optional(1) : std::nullopt; }
        float progress() const { return 0.5f; }
    };
    auto job = jobs.submit(4, [may_end](std::size_t part) { return Half{may_end, part == 0}; });
    EXPECT_EQ(job.progress().parts, 4u);
    EXPECT_EQ(job.progress().fraction, 0.0f);
    EXPECT_TRUE(becomes_true([&] {
        jobs.deliver(0ns);
        return job.progress().done == 1 && job.progress().fraction >= 0.375f;
    })) << "one part is complete, another is half done";
    *may_end = true;
    jobs.finish();
    EXPECT_EQ(job.progress().done, 4u);
    EXPECT_EQ(job.progress().fraction, 1.0f);
}

TEST(Jobs, RunAsManyPartsInParallelAsThereAreThreads) {
    if (Jobs::default_threads() == 0) GTEST_SKIP() << "a build without threads";
    Jobs jobs(4);
    EXPECT_EQ(jobs.threads(), 4);
    auto begun = std::make_shared<std::atomic<int>>(0);
    Job<std::vector<bool>> job = jobs.submit(4, [begun](std::size_t) {
        ++*begun;
        return becomes_true([&] { return *begun == 4; });
    });
    EXPECT_EQ(*result_of(jobs, job), std::vector<bool>(4, true));
}

TEST(Jobs, ChangeProgressAndResultOnlyInDeliver) {
    if (Jobs::default_threads() == 0) GTEST_SKIP() << "a build without threads";
    Jobs jobs(2);
    auto ended = std::make_shared<std::atomic<bool>>(false);
    Job<int> job = jobs.submit(
        1, [](std::size_t) { return 7; },
        [ended](const std::vector<int>& parts) {
            *ended = true;
            return parts[0];
        });
    ASSERT_TRUE(becomes_true([&] { return ended->load(); }));
    std::this_thread::sleep_for(2ms);
    EXPECT_EQ(job.progress().done, 0u);
    EXPECT_FALSE(job.take());
    EXPECT_EQ(*result_of(jobs, job), 7);
}

TEST(Jobs, RunOneStepPerDeliverWithoutThreadsAndBudget) {
    Jobs jobs(0);
    auto steps = std::make_shared<int>(0);
    auto job = jobs.submit(3, [steps](std::size_t) {
        return [steps]() -> std::optional<int> { return ++*steps % 4 == 0 ? std::optional(*steps) : std::nullopt; };
    });
    for (int deliveries = 1; deliveries <= 12; ++deliveries) {
        jobs.deliver(0ns);
        ASSERT_EQ(*steps, deliveries);
    }
    ASSERT_TRUE(job.active());
    EXPECT_EQ(**job.take(), (std::vector<int>{4, 8, 12}));
}

TEST(Jobs, RunAllStepsOfAJobSubmittedFirstBeforeThoseOfOthers) {
    Jobs jobs(0);
    const auto order = std::make_shared<std::string>();
    const auto steps = [order](char name) {
        return [order, name, left = 3]() mutable -> std::optional<int> {
            *order += name;
            return --left == 0 ? std::optional(0) : std::nullopt;
        };
    };
    auto a = jobs.submit(steps('a')), b = jobs.submit(steps('b'));
    jobs.deliver(0ns);
    auto c = jobs.submit_first(steps('c'));
    jobs.finish();
    EXPECT_EQ(*order, "acccbabab");
}

TEST(Jobs, EndOneByOneWhereSubmittedSoAndTakeATurnEachBesideOthers) {
    Jobs jobs(0);
    const auto order = std::make_shared<std::string>();
    const auto part = [order](char name) { return [order, name](std::size_t) { return *order += name, 0; }; };
    auto a = jobs.submit_one_by_one(3, part('a')), b = jobs.submit_one_by_one(2, part('b'));
    jobs.deliver(0ns);
    auto other = jobs.submit(2, part('o'));
    auto c = jobs.submit_one_by_one(2, part('c'));
    jobs.finish();
    EXPECT_EQ(*order, "aaabbocco");
}

TEST(Jobs, RunAStepOnTheCallingThreadBesideWorkers) {
    if (Jobs::default_threads() == 0) GTEST_SKIP() << "a build without threads";
    Jobs jobs(1);
    const auto caller = std::this_thread::get_id();
    const auto others = std::make_shared<std::atomic<int>>(0);
    const auto is_held = std::make_shared<std::atomic<bool>>(true);
    auto job = jobs.submit(3, [=](std::size_t) {
        if (std::this_thread::get_id() == caller) return true;
        ++*others;
        return !becomes_true([&] { return !*is_held; });
    });
    ASSERT_TRUE(becomes_true([&] { return *others == 1; }));
    EXPECT_TRUE(jobs.step());
    EXPECT_TRUE(jobs.step());
    EXPECT_FALSE(jobs.step()) << "the third part is the worker's";
    jobs.publish();
    EXPECT_EQ(job.progress().done, 2u);
    *is_held = false;
    jobs.finish();
    EXPECT_EQ(**job.take(), (std::vector<bool>{false, true, true}));
}

TEST(Jobs, BeginNoStepThatWouldEndAfterTheBudget) {
    Jobs jobs(0);
    auto steps = std::make_shared<int>(0);
    auto job = jobs.submit([steps]() -> std::optional<int> {
        std::this_thread::sleep_for(20ms);
        return ++*steps == 9 ? std::optional(9) : std::nullopt;
    });
    jobs.deliver(30ms);
    EXPECT_EQ(*steps, 1) << "a second one would take it to 40 ms";
}

TEST(Jobs, RunStepsOnTheCallingThreadWithoutThreads) {
    Jobs jobs(0);
    auto job = jobs.submit(3, [](std::size_t) { return std::this_thread::get_id(); });
    EXPECT_EQ(*result_of(jobs, job), std::vector(3, std::this_thread::get_id()));
}

TEST(Jobs, WorkBetweenFramesWithoutThreadsAndPublishNothing) {
    Jobs jobs(0);
    int steps = 0;
    auto job = jobs.submit(std::size_t{5}, [&steps](std::size_t part) { return ++steps, part; });
    while (jobs.work(0ns)) EXPECT_EQ(job.progress().done, 0u);
    EXPECT_EQ(steps, 5);
    EXPECT_FALSE(job.take()) << "before a frame";
    jobs.deliver(0ns);
    EXPECT_TRUE(job.take());
    EXPECT_FALSE(jobs.work(1ms)) << "nothing waits";
}

}  // namespace
}  // namespace braitenlab
