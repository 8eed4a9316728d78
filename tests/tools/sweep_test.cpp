#include "app/ctl/sweep.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::sweep_test {
namespace {

using Texts = std::vector<std::string>;

Sweep parsed(const Texts& settings, const std::string& seed = "") {
    auto sweep = parse_sweep(settings, seed);
    if (!sweep) throw std::runtime_error(sweep.error().text());
    return *sweep;
}

// The values of the only --set argument.
Texts values(const std::string& text) { return parsed({"path=" + text}).values.at(0).values; }

// The message for these arguments; empty when they are valid.
std::string complaint(const Texts& settings, const std::string& seed = "") {
    const auto sweep = parse_sweep(settings, seed);
    return sweep ? "" : sweep.error().text();
}

void expect_complaint(const std::string& expected, const Texts& settings, const std::string& seed = "") {
    EXPECT_NE(complaint(settings, seed).find(expected), std::string::npos)
        << "expected: " << expected << "\nmessage:  " << complaint(settings, seed);
}

TEST(Sweep, IsASingleRunWithoutARangeOrAList) {
    const Sweep none = parsed({});
    EXPECT_FALSE(none.is_sweep);
    EXPECT_EQ(none.first_seed, 1u);
    EXPECT_EQ(none.runs(), 1u);
    const Sweep one = parsed({"a=0.5", "b= two words"}, "7");
    EXPECT_FALSE(one.is_sweep);
    EXPECT_EQ(one.first_seed, 7u);
    EXPECT_EQ(one.values.at(1).values, Texts{"two words"});
}

TEST(Sweep, ARangeHasBothEndsInEitherDirection) {
    EXPECT_EQ(values("0:1:0.25"), (Texts{"0", "0.25", "0.5", "0.75", "1"}));
    EXPECT_EQ(values("1:-1:-1"), (Texts{"1", "0", "-1"}));
    EXPECT_EQ(values("0:1:0.3"), (Texts{"0", "0.3", "0.6", "0.9"})) << "the next one is above the end";
    EXPECT_EQ(values("2:2:1"), Texts{"2"});
}

TEST(Sweep, ARangeHasRoundedNumbersAndLosesNoEndByRounding) {
    EXPECT_EQ(values("0:1:0.1"), (Texts{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"}));
    EXPECT_EQ(values("-0.3:0:0.1"), (Texts{"-0.3", "-0.2", "-0.1", "0"}));
}

TEST(Sweep, AListIsSplitOutsideQuotesAndBracketsOnly) {
    EXPECT_EQ(values("1, 2,3"), (Texts{"1", "2", "3"}));
    EXPECT_EQ(values("'a, b',\"c:d\""), (Texts{"'a, b'", "\"c:d\""}));
    EXPECT_EQ(values("[1, 2]"), Texts{"[1, 2]"});
    EXPECT_EQ(values("\"a: b, c\""), Texts{"\"a: b, c\""});
}

TEST(Sweep, ARangeOfOneValueOrSeedIsASweepToo) {
    EXPECT_TRUE(parsed({"a=1:1:1"}).is_sweep);
    EXPECT_TRUE(parsed({}, "3:3").is_sweep);
}

TEST(Sweep, CombinesAllValuesTheLastOneFastest) {
    const Sweep sweep = parsed({"a=1,2", "b=x", "c=0:2:1"}, "5:8");
    EXPECT_EQ(sweep.first_seed, 5u);
    EXPECT_EQ(sweep.seeds, 4u);
    EXPECT_EQ(sweep.combinations(), 6u);
    EXPECT_EQ(sweep.runs(), 24u);
    std::string all;
    for (std::size_t i = 0; i < sweep.combinations(); ++i)
        for (const Setting& setting : combination(sweep, i)) all += setting.path + "=" + setting.value + " ";
    EXPECT_EQ(all, "a=1 b=x c=0 a=1 b=x c=1 a=1 b=x c=2 a=2 b=x c=0 a=2 b=x c=1 a=2 b=x c=2 ");
}

TEST(Sweep, SeveralDialsGetTheSameValue) {
    const Sweep one = parsed({"LR=RL=0.8"});
    EXPECT_FALSE(one.is_sweep);
    const std::vector<Setting> both = combination(one, 0);
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0].path + both[0].value, "LR0.8");
    EXPECT_EQ(both[1].path + both[1].value, "RL0.8");
    const Sweep range = parsed({"kind.a.brain.LR = kind.a.brain.RL = 0:1:0.5", "x=1"});
    EXPECT_EQ(range.combinations(), 3u);
    EXPECT_EQ(range.values[0].name(), "kind.a.brain.LR=kind.a.brain.RL");
    EXPECT_EQ(values_of(range, 1), (std::vector<std::string>{"0.5", "1"}));
    EXPECT_EQ(combination(parsed({"scene.title=LR=1"}), 0)[0].value, "LR=1") << "a title may hold this text";
    expect_complaint("RL: is given twice", {"LR=RL=0,1", "RL=1"});
}

TEST(Sweep, SaysHowToSetTwoPathsToTwoValues) {
    expect_complaint("give each path its own --set: --set LR=0.8 --set RL=0.4", {"LR=0.8,RL=0.4"});
}

TEST(Sweep, RefusesAStepThatDoesNotLeadToTheEnd) {
    expect_complaint("--set a=0:1:0: the step is 0; give another one", {"a=0:1:0"});
    expect_complaint("--set a=0:1:-0.5: the step leads away from 1; write 0:1:0.5", {"a=0:1:-0.5"});
    expect_complaint("--set a=1:0:0.5: the step leads away from 0; write 1:0:-0.5", {"a=1:0:0.5"});
}

TEST(Sweep, RefusesARangeThatIsNotOfThreeNumbers) {
    expect_complaint("--set a=0:one:0.5: 'one' is not a number", {"a=0:one:0.5"});
    expect_complaint("--set a=0:nan:1: 'nan' is not a number", {"a=0:nan:1"});
    expect_complaint("--set a=0:1:: '' is not a number", {"a=0:1:"});
    expect_complaint("--set a=0:1: a range has three numbers", {"a=0:1"});
    expect_complaint("--set a=0:1:2:3: a range has three numbers", {"a=0:1:2:3"});
    expect_complaint("put other text with a colon in quotes", {"title=Part 1: light"});
}

TEST(Sweep, SaysHowToWriteARangeWithTwoDots) {
    expect_complaint("a range is A:B:STEP; write LR=0:1:0.1", {"LR=0..1"});
    expect_complaint("write LR=1:-1:-0.2", {"LR=1 .. -1"});
    EXPECT_TRUE(parse_sweep({"scene.title=wait..."}, ""));
}

TEST(Sweep, RefusesAListWithoutAValueOrWithARange) {
    expect_complaint("--set a=1,,2: a value is missing beside a comma", {"a=1,,2"});
    expect_complaint("--set a=1,: a value is missing beside a comma", {"a=1,"});
    expect_complaint("--set a=3,0:1:0.5: a list has no ranges", {"a=3,0:1:0.5"});
}

TEST(Sweep, RefusesSeedsThatAreNotAscendingWholeNumbers) {
    for (const char* seed : {"-1", "1.5", "one", "1:", ":2", "1:2:3", "1,2", "99999999999999999999"})
        expect_complaint(std::string("--seed ") + seed + ": a seed is a whole number from 0 up; write 7, or 1:10", {},
                         seed);
    expect_complaint("--seed 5:2: the last seed is below the first; write 2:5", {}, "5:2");
}

TEST(Sweep, RefusesTooManyRuns) {
    EXPECT_EQ(parsed({"a=1:100:1"}, "1:100").runs(), most_runs);
    expect_complaint("--set and --seed: this gives 10100 runs, and the most is 10000; take", {"a=1:100:1"}, "1:101");
    expect_complaint("--set a=0:1:1e-9: this gives 1000000001 runs", {"a=0:1:1e-9"});
    expect_complaint("--seed 0:18446744073709551615: this gives 18446744073709551616 runs", {},
                     "0:18446744073709551615");
    const std::string wide = "=1:10000:1";
    expect_complaint("runs, and the most is 10000", {"a" + wide, "b" + wide, "c" + wide, "d" + wide, "e" + wide});
}

TEST(Sweep, RefusesAPathGivenTwiceInASweepOnly) {
    expect_complaint("--set a: is given twice; give all its values in one --set", {"a=1", "a=2,3"});
    EXPECT_EQ(complaint({"a=1", "a=2"}), "");
}

TEST(Sweep, RefusesASettingWithoutAPath) { expect_complaint("write PATH=VALUE", {"0:1:0.5"}); }

}  // namespace
}  // namespace braitenlab::tests::sweep_test
