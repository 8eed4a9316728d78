#include "core/lesson/selection.h"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/lesson/submission.h"
#include "core/scene/file_kind.h"
#include "tests/tells.h"

namespace braitenlab::tests::selection_test {
namespace {

const Exercise& exercise() {
    static const auto loaded =
        load_exercise(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/guided/20-selection.toml");
    if (!loaded) throw std::runtime_error(loaded.error().text());
    return *loaded;
}

Parent first_parent(std::uint64_t seed) { return {as_shipped(exercise()).brain, seed}; }

TEST(Selection, ChildrenDifferFromTheirParentAndFromEachOther) {
    const Parent parent = first_parent(1);
    const std::vector<BrainGraph> children = children_of(exercise(), parent);
    ASSERT_EQ(children.size(), 9u);
    EXPECT_EQ(children, children_of(exercise(), parent));
    for (std::size_t i = 0; i < children.size(); ++i) {
        EXPECT_NE(children[i], parent.brain);
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(children[i], children[k]);
    }
}

TEST(Selection, ThoseOfTwoChildrenAndOfTheSameParentAgainHaveOtherErrors) {
    const Parent parent = first_parent(1);
    const BrainGraph& brain = parent.brain;
    EXPECT_NE(children_of(exercise(), chosen(parent, brain, 0)), children_of(exercise(), chosen(parent, brain, 1)));
    EXPECT_NE(children_of(exercise(), chosen(parent, brain, 9)), children_of(exercise(), parent));
}

TEST(Selection, TheChildrenKeepToWhatTheExerciseOffersAndAnotherBiasDoesNot) {
    ASSERT_TRUE(offers_selection(exercise()));
    for (const BrainGraph& child : children_of(exercise(), first_parent(1)))
        EXPECT_TRUE(keeps_to_offers(exercise(), with_brain(exercise(), child)));
    BrainGraph designed = first_parent(1).brain;
    turn(designed, Dial::LM, 0.1f);
    EXPECT_EQ(outside_offers(exercise(), with_brain(exercise(), designed)), std::vector<std::string>{"LM"});
}

TEST(Selection, ATableOfSelectionWithoutItsOfferIsAnErrorAtItsLine) {
    const std::filesystem::path path = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises/guided/20-selection.toml";
    std::string text = *read_text(path);
    const std::string offer = "offers = [\"selection\"]";
    text.replace(text.find(offer), offer.size(), "offers = [\"LL\"]");
    const auto read = parse_exercise(text, path);
    ASSERT_FALSE(read);
    EXPECT_TRUE(tells(read.error(), message_of("selection_not_offered")));
    EXPECT_GT(read.error().line, 1);
}

TEST(Selection, ARunThatFallsEndsThereAndItsPathEndsAtTheEdge) {
    const StartResult run = try_start(exercise(), as_shipped(exercise()), 1);
    EXPECT_TRUE(has_fallen(exercise(), run));
    EXPECT_LT(run.seconds, 10);
    const maths::vec2 end = run.path.back();
    EXPECT_GT(std::max(std::fabs(end.x) / 6, std::fabs(end.y) / 4.5f), 0.98f) << end.x << ", " << end.y;
    const StartResult whole = try_start(exercise(), with_solution(exercise()), 1);
    EXPECT_FALSE(has_fallen(exercise(), whole));
    EXPECT_NEAR(whole.seconds, 60, 0.1f);
}

TEST(Selection, TheFirstNineChildrenThatAStudentSeesDoNotAllFallAtTheSameTime) {
    std::vector<float> seconds;
    for (const BrainGraph& child : children_of(exercise(), first_parent(1001)))  // as the window begins
        seconds.push_back(try_start(exercise(), with_brain(exercise(), child), exercise().seed).seconds);
    std::sort(seconds.begin(), seconds.end());
    EXPECT_GT(seconds.back(), 1.2f * seconds.front()) << "one is visibly better";
    EXPECT_LT(seconds.back(), exercise().seconds - 1) << "and not yet good";
}

TEST(Selection, OnlyTheShippedBrainsChildrenHaveTheErrorsOfTheFirstOnes) {
    Exercise same = exercise();
    same.selection.first = 0;
    const Parent first = first_parent(1);
    EXPECT_NE(children_of(exercise(), first), children_of(same, first));
    const Parent later = chosen(first, children_of(exercise(), first)[0], 0);
    EXPECT_EQ(children_of(exercise(), later), children_of(same, later));
}

// The number of choices after which the exercise is passed, when the longest survivor is chosen each time; one more
// than the exercise has when it is not.
int choices_needed(std::uint64_t seed) {
    Parent parent = first_parent(seed);
    for (int choice = 1; choice <= exercise().selection.generations; ++choice) {
        const std::vector<BrainGraph> children = children_of(exercise(), parent);
        std::size_t best = 0;
        float longest = -1;
        for (std::size_t i = 0; i < children.size(); ++i) {
            const StartResult run = try_start(exercise(), with_brain(exercise(), children[i]), exercise().seed);
            if (run.seconds > longest) longest = run.seconds, best = i;
        }
        parent = chosen(parent, children[best], best);
        const bool survives = longest >= exercise().seconds - 0.1f;
        if (survives && grade(exercise(), with_brain(exercise(), parent.brain)).good) return choice;
    }
    return exercise().selection.generations + 1;
}

TEST(Selection, WhoeverChoosesTheLongestSurvivorPassesWithinTheGenerationsForMostSeeds) {
    int passed = 0, at_once = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const int choices = choices_needed(seed);
        passed += choices <= exercise().selection.generations;
        at_once += choices == 1;
    }
    EXPECT_GE(passed, 8);
    EXPECT_EQ(at_once, 0) << "one choice is too easy";
}

TEST(Selection, AllowsNoErrorThatTheCopiesCannotHave) {
    BrainGraph masked = first_parent(1).brain;
    masked.wires[0].threshold = 0.9f;
    EXPECT_FALSE(keeps_to_offers(exercise(), with_brain(exercise(), masked))) << "thresholds are copied exactly";
    BrainGraph cut = first_parent(1).brain;
    cut.wires.pop_back();
    EXPECT_FALSE(keeps_to_offers(exercise(), with_brain(exercise(), cut))) << "no wire is lost";
}

TEST(Selection, ARunThatPassedOrLastedToItsEndHasNotFallen) {
    EXPECT_TRUE(has_fallen(exercise(), {.passed = false, .seconds = 5}));
    EXPECT_FALSE(has_fallen(exercise(), {.passed = true, .seconds = 5}));
    EXPECT_FALSE(has_fallen(exercise(), {.passed = false, .seconds = exercise().seconds}));
}

}  // namespace
}  // namespace braitenlab::tests::selection_test
