#include "app/platform/platform.h"

#include <chrono>
#include <csignal>
#include <cstdlib>

#include <gtest/gtest.h>

namespace braitenlab::tests::platform_test {
namespace {

using Clock = std::chrono::steady_clock;

void work_for(std::chrono::milliseconds time) {
    const auto end = Clock::now() + time;
    while (Clock::now() < end) {
    }
}

constexpr std::chrono::milliseconds long_work{20000}, longer_than_patience{400};

TEST(Platform, EndsLongWorkSoonAfterARequestToEnd) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        const auto began = Clock::now();
        EXPECT_EXIT(
            {
                is_told_to_end();
                let_requests_interrupt(true);
                raise(signal);
                work_for(long_work);
                std::exit(0);
            },
            testing::KilledBySignal(signal), "");
        EXPECT_LT(Clock::now() - began, long_work / 2);
    }
}

TEST(Platform, EndsLongWorkThatBeginsAfterTheRequest) {
    EXPECT_EXIT(
        {
            is_told_to_end();
            raise(SIGTERM);
            work_for(longer_than_patience);
            let_requests_interrupt(true);
            work_for(long_work);
            std::exit(0);
        },
        testing::KilledBySignal(SIGTERM), "");
}

TEST(Platform, WaitsForWorkThatMayNotBeInterrupted) {
    EXPECT_EXIT(
        {
            is_told_to_end();
            raise(SIGTERM);
            work_for(longer_than_patience);
            std::exit(is_told_to_end() ? 7 : 1);
        },
        testing::ExitedWithCode(7), "");
}

TEST(Platform, LetsAProgramFinishThatHasSeenTheRequest) {
    EXPECT_EXIT(
        {
            is_told_to_end();
            let_requests_interrupt(true);
            raise(SIGTERM);
            if (!is_told_to_end()) std::exit(1);
            work_for(longer_than_patience);
            std::exit(7);
        },
        testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace braitenlab::tests::platform_test
