// The score of a rebuilt brain, and the files of a hidden one.
#include "core/insight/mystery.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "core/scene/sealed.h"
#include "tests/core/scenes.h"
#include "tests/tells.h"

namespace braitenlab::tests::mystery_test {
namespace {

using insight::Design;
using insight::MysteryBase;
using insight::MysteryQuestion;
using insight::MysteryScore;
using insight::Path;

constexpr FourNeurons loves{.LL = -0.6f, .RR = -1.2f, .LM = 0.5f, .RM = 0.5f};

Scene with_lamp() {
    Scene scene = alone(loves);
    scene.arena.width = 16, scene.arena.height = 12;
    scene.sources = {{.name = "lamp", .x = 1, .y = 2}};
    return scene;
}

MysteryQuestion question(const FourNeurons& rebuilt) {
    MysteryQuestion asked{.scene = with_lamp(), .seed = 5, .vehicle = 0, .random_brains = 6, .ticks = 480};
    const Kind& kind = asked.scene.kinds.front();
    asked.hidden = {kind.brain, kind.sensors};
    asked.rebuilt = {make_graph(rebuilt), kind.sensors};
    return asked;
}

MysteryScore score(const MysteryQuestion& asked) {
    const auto base = MysteryBase::create(asked);
    EXPECT_TRUE(base) << base.error().text();
    std::vector<insight::MysteryStart> starts;
    for (std::size_t start = 0; start < asked.starts; ++start) {
        insight::MysteryRun run(*base, start);
        while (!run.advance(1024)) {
        }
        starts.push_back(run.result());
    }
    return insight::score_of(std::move(starts));
}

TEST(Mystery, TheSameBrainHasAllPointsAndAnotherFewer) {
    const MysteryScore same = score(question(loves));
    EXPECT_EQ(same.score, 100);
    EXPECT_EQ(same.gap, 0);
    EXPECT_GT(same.random_gap, 1);
    ASSERT_EQ(same.starts.size(), 10u);
    EXPECT_EQ(same.starts[3].hidden, same.starts[3].rebuilt);
    FourNeurons nearly = loves, opposite = loves;
    nearly.RR = -1.1f;
    opposite.LL = opposite.RR = 0, opposite.LR = opposite.RL = 1.5f;
    const MysteryScore near_score = score(question(nearly)), far_score = score(question(opposite));
    EXPECT_LT(near_score.score, 100);
    EXPECT_GT(near_score.score, far_score.score);
    EXPECT_GT(near_score.score, 60);
    EXPECT_LT(far_score.score, 60);
}

TEST(Mystery, RandomBrainsHaveFewPointsInTheMean) {
    int sum = 0;
    constexpr int brains = 6;
    for (std::uint64_t number = 100; number < 100 + brains; ++number) {
        MysteryQuestion asked = question(loves);
        asked.rebuilt.brain = insight::random_brain(asked.hidden.sensors, 5, number);
        sum += score(asked).score;
    }
    EXPECT_LT(sum / brains, 40);
}

TEST(Mystery, ABrainThatDoesNothingHasNoPoints) {
    MysteryQuestion asked = question({});
    asked.hidden.brain = make_graph({.LM = 0.2f, .RM = 0.25f});
    const MysteryScore nothing = score(asked);
    EXPECT_EQ(nothing.score, 0);
    EXPECT_EQ(nothing.gap, nothing.still_gap);
    EXPECT_LT(nothing.still_gap, nothing.random_gap) << "random brains alone would give it points";
}

TEST(Mystery, IsTheSameEachTimeAndInPieces) {
    const MysteryQuestion asked = question({.LR = 1, .RL = 1});
    const MysteryScore once = score(asked), again = score(asked);
    EXPECT_EQ(once.score, again.score);
    EXPECT_EQ(once.gap, again.gap);
    EXPECT_EQ(once.random_gap, again.random_gap);
    const auto base = MysteryBase::create(asked);
    insight::MysteryRun run(*base, 4);
    float progress = 0;
    while (!run.advance(37)) {
        EXPECT_GE(run.progress(), progress);
        progress = run.progress();
    }
    EXPECT_EQ(run.progress(), 1);
    EXPECT_EQ(run.result().gap, once.starts[4].gap);
    EXPECT_EQ(run.result().rebuilt, once.starts[4].rebuilt);
}

TEST(Mystery, StartsDifferAndAreInTheArena) {
    const MysteryScore all = score(question(loves));
    for (std::size_t i = 0; i < all.starts.size(); ++i) {
        const Pose at = all.starts[i].hidden.front();
        EXPECT_LT(std::abs(at.x), 8);
        EXPECT_LT(std::abs(at.y), 6);
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(at, all.starts[k].hidden.front());
    }
}

TEST(Mystery, TheGapIsTheMeanDistanceAtTheSameTime) {
    const Path standing(5, Pose{0, 0, 0});
    Path leaving;
    for (int i = 0; i < 5; ++i) leaving.push_back({static_cast<float>(i), 0, 0});
    Arena arena;
    arena.width = arena.height = 20;
    EXPECT_FLOAT_EQ(insight::path_gap(standing, leaving, arena), 2);
    const Path ended(leaving.begin(), leaving.begin() + 2);
    EXPECT_FLOAT_EQ(insight::path_gap(ended, leaving, arena), (0 + 0 + 1 + 2 + 3) / 5.0f) << "it stays where it ended";
    Path beyond = standing;
    for (Pose& pose : beyond) pose.x = 18;
    EXPECT_FLOAT_EQ(insight::path_gap(standing, beyond, arena), 18);
    arena.edge = Boundary::torus;
    EXPECT_FLOAT_EQ(insight::path_gap(standing, beyond, arena), 2);
    EXPECT_EQ(insight::path_gap({}, leaving, arena), 0);
}

TEST(Mystery, AQuestionWithoutTheVehicleIsRefused) {
    MysteryQuestion asked = question(loves);
    asked.vehicle = 7;
    EXPECT_FALSE(MysteryBase::create(asked));
}

TEST(Mystery, AHiddenBrainIsNotPlainInTheFileAndComesBack) {
    Scene scene = with_lamp();
    scene.kinds[0].hidden = true;
    const std::string text = write_scene(scene);
    for (const char* plain : {"brain", "LL", "-0.6", "RR"}) EXPECT_EQ(text.find(plain), std::string::npos) << text;
    const auto read = parse_scene(text, "scene.toml");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->kinds[0].hidden);
    EXPECT_EQ(read->kinds[0].brain, scene.kinds[0].brain);
    EXPECT_EQ(write_scene(*read), text);
    scene.kinds[0].hidden = false;
    EXPECT_NE(write_scene(scene).find("LL = -0.6"), std::string::npos);
}

TEST(Mystery, ADamagedHiddenBrainIsAnErrorWithItsLine) {
    Scene scene = with_lamp();
    scene.kinds[0].hidden = true;
    std::string text = write_scene(scene);
    const std::size_t at = text.find("tester = \"") + 20;
    text[at] = text[at] == 'a' ? 'b' : 'a';
    const auto read = parse_scene(text, "scene.toml");
    ASSERT_FALSE(read);
    EXPECT_GT(read.error().line, 0);
    EXPECT_TRUE(tells(read.error(), message_of("sealed_damaged")));
    EXPECT_FALSE(parse_scene("format = 1\n[sealed]\nnobody = \"" + seal(scene.kinds[0].brain) + "\"\n", "x.toml"));
    EXPECT_FALSE(unseal("xyz"));
    EXPECT_FALSE(unseal(""));
}

}  // namespace
}  // namespace braitenlab::tests::mystery_test
