#include "render/view/quality.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::quality_test {
namespace {

void add(QualityChoice& choice, double seconds, int times) {
    for (int i = 0; i < times; ++i) choice.add(seconds);
}

TEST(QualityChoice, BeginsWithMediumAndStaysWhileFramesAreNeitherSlowNorFast) {
    QualityChoice choice;
    add(choice, 0.012, 100);
    EXPECT_EQ(choice.level(), Quality::medium);
}

TEST(QualityChoice, StepsDownAfterSlowFramesInARowOnly) {
    QualityChoice choice;
    for (int i = 0; i < 50; ++i) add(choice, 0.04, 2), add(choice, 0.012, 1);
    EXPECT_EQ(choice.level(), Quality::medium) << "single slow frames";
    add(choice, 0.04, 3);
    EXPECT_EQ(choice.level(), Quality::low);
    add(choice, 0.04, 100);
    EXPECT_EQ(choice.level(), Quality::low) << "nothing is below low";
}

TEST(QualityChoice, HalvesTheResolutionWhereLowQualityIsVerySlowToo) {
    QualityChoice choice;
    add(choice, 0.1, 3);
    EXPECT_EQ(choice.level(), Quality::low);
    EXPECT_EQ(choice.resolution(), 1);
    add(choice, 0.1, 7);
    EXPECT_EQ(choice.resolution(), 1) << "for a moment";
    add(choice, 0.1, 1);
    EXPECT_EQ(choice.level(), Quality::low);
    EXPECT_EQ(choice.resolution(), 0.5f);
    add(choice, 0.03, 100);
    EXPECT_EQ(choice.resolution(), 0.5f) << "all pixels would take more than twice as long";
    EXPECT_FALSE(choice.measures(QualityChoice::frames_between)) << "seldom, because it stops the machine";
    add(choice, 0.02, 2);
    EXPECT_EQ(choice.resolution(), 1);
}

TEST(QualityChoice, MeasuresFewFramesAtRestAndNoneOfThemAtTheLowerResolution) {
    QualityChoice sharp, coarse(Quality::low);
    add(coarse, 0.1, 8);
    int moving = 0, resting = 0, coarse_resting = 0;
    for (int frame = 0; frame < 960; ++frame) {
        moving += sharp.measures(frame), resting += sharp.measures(frame, true);
        coarse_resting += coarse.measures(frame, true);
    }
    EXPECT_EQ(moving, 120);
    EXPECT_EQ(resting, 15);
    EXPECT_EQ(coarse_resting, 0);
}

TEST(QualityChoice, BeginsWithAllPixelsAndKeepsThemFromTwelvePicturesASecondOn) {
    QualityChoice choice(Quality::low);
    EXPECT_EQ(choice.level(), Quality::low);
    EXPECT_EQ(choice.resolution(), 1);
    add(choice, 0.055, 100);
    EXPECT_EQ(choice.resolution(), 1);
    add(choice, 0.002, 8);
    EXPECT_EQ(choice.level(), Quality::medium);
}

TEST(QualityChoice, StepsUpAfterManyFastFrames) {
    QualityChoice choice;
    add(choice, 0.002, 7);
    EXPECT_EQ(choice.level(), Quality::medium);
    add(choice, 0.002, 1);
    EXPECT_EQ(choice.level(), Quality::high);
}

TEST(QualityChoice, DoesNotReturnToALevelThatWasTooSlowUntilItStartsOver) {
    QualityChoice choice;
    add(choice, 0.04, 3), add(choice, 0.002, 100);
    EXPECT_EQ(choice.level(), Quality::low);
    choice.start_over();
    add(choice, 0.002, 8);
    EXPECT_EQ(choice.level(), Quality::high);
}

}  // namespace
}  // namespace braitenlab::tests::quality_test
