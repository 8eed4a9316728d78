#include "ui/panels/history.h"

#include "desk.h"

namespace braitenlab::tests {

TEST(History, TakesOneSampleAPeriodAndForgetsTheOldest) {
    Desk desk;
    History history;
    for (int i = 0; i < 3000; ++i) {
        desk.now.tick = static_cast<std::uint64_t>(i);
        remember(history, desk.view);
        remember(history, desk.view);
        if (i == 8) {
            EXPECT_EQ(history.signals[0].size(), 3u);
        }
    }
    EXPECT_EQ(history.signals[3].size(), History::signal_samples);
    EXPECT_FLOAT_EQ(history.signals[0].back(), 0.4f);
    EXPECT_FLOAT_EQ(history.signals[3].back(), 0.5f);
    EXPECT_EQ(history.population.size(), 50u);
}

TEST(History, BeginsAgainWithTheRunAndWithAnotherVehicle) {
    Desk desk;
    History history;
    desk.now.tick = 600;
    remember(history, desk.view);
    desk.view.selected = 1;
    desk.now.tick = 700;
    remember(history, desk.view);
    EXPECT_EQ(history.signals[0].size(), 1u);
    EXPECT_EQ(history.population.size(), 2u);
    desk.now.tick = 0;
    remember(history, desk.view);
    EXPECT_EQ(history.population.size(), 1u);
}

}  // namespace braitenlab::tests
