#include "app/ctl/progress.h"

#include <sstream>

#include <gtest/gtest.h>

namespace braitenlab::tests::progress_test {

TEST(Progress, WritesALineEveryTenSecondsWithTheTimeThatIsLeft) {
    std::ostringstream out;
    const Progress::Clock::time_point begun{};
    const auto after = [&](int seconds) { return begun + std::chrono::seconds(seconds); };
    Progress progress("runs", 100, 20, out, begun);
    progress.at(25, after(9));
    EXPECT_EQ(out.str(), "") << "nothing for a short command";
    progress.at(30, after(10));
    EXPECT_EQ(out.str(), "braitenctl: 30 of 100 runs, about 70 s left\n") << "the 20 took no time of this command";
    progress.at(40, after(19));
    progress.at(60, after(20));
    progress.at(100, after(40));
    EXPECT_EQ(out.str(), "braitenctl: 30 of 100 runs, about 70 s left\nbraitenctl: 60 of 100 runs, about 20 s left\n");
}

}  // namespace braitenlab::tests::progress_test
