// The wait after a buffer swap, for displays with and without vertical sync.
#include "app/frame_pacing.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::frame_pacing_test {
namespace {

TEST(FramePacing, DoesNotWaitIfTheSwapHasWaited) {
    for (const int rate : {50, 60, 75, 120, 144, 240}) {
        EXPECT_EQ(pause_after_swap(1.0 / rate, rate), 0) << rate;
        EXPECT_EQ(pause_after_swap(0.97 / rate, rate), 0) << "with the jitter of a real display, " << rate;
        EXPECT_EQ(pause_after_swap(2.0 / rate, rate), 0) << "a missed refresh, " << rate;
    }
}

TEST(FramePacing, WaitsIfTheSwapHasNotWaited) {
    for (const int rate : {60, 144}) {
        const double worked = 0.002, pause = pause_after_swap(worked, rate);
        EXPECT_GT(worked + pause, 0.85 / rate);
        EXPECT_LT(worked + pause, 1.0 / rate) << "the next refresh is not missed";
    }
}

TEST(FramePacing, RunsAtSixtyPicturesPerSecondOnADisplayOfUnknownRate) {
    EXPECT_DOUBLE_EQ(pause_after_swap(0.004, 0), 1.0 / 60 - 0.004);
    EXPECT_EQ(pause_after_swap(0.02, 0), 0);
}

TEST(FramePacing, DrawsNoMorePicturesThanTheUserAllows) {
    EXPECT_DOUBLE_EQ(pause_after_swap(0.004, 60, 20), 0.05 - 0.004);
    EXPECT_DOUBLE_EQ(pause_after_swap(0.004, 0, 20), 0.05 - 0.004);
    EXPECT_EQ(pause_after_swap(0.06, 60, 20), 0);
    EXPECT_EQ(pause_after_swap(0.004, 60, 1000), pause_after_swap(0.004, 60)) << "the display is slower than the limit";
}

TEST(FramePacing, DrawsTenFramesPerSecondOnceNothingMoves) {
    EXPECT_EQ(idle_wait(0), 0);
    EXPECT_EQ(idle_wait(0.9), 0) << "the camera may still ease";
    EXPECT_DOUBLE_EQ(idle_wait(1.1), 0.1);
}

}  // namespace
}  // namespace braitenlab::tests::frame_pacing_test
