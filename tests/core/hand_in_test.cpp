#include "core/lesson/hand_in.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/submission.h"

namespace braitenlab::tests::hand_in_test {
namespace {

namespace fs = std::filesystem;

HandIn sample() {
    HandIn hand_in{.student = "Ana López", .exercise = "05-aggressor", .written = "2026-11-22T16:37:29Z"};
    hand_in.prediction = 2, hand_in.runs = 7, hand_in.hints = 3, hand_in.solution_shown = true;
    hand_in.graded_starts = 10, hand_in.passed_starts = 4;
    hand_in.notes = "It turns \"left\".\nWhy? C:\\ ä";
    hand_in.submission.brain = make_graph({.LR = 1.5f, .RL = 1.25f, .LM = 0.1f, .RM = 0.1f});
    return hand_in;
}

// The brain with its nodes and wires in the order of their ids, as a four-neuron brain loses their order.
BrainGraph sorted(BrainGraph graph) {
    std::ranges::sort(graph.nodes, {}, &Node::id);
    std::ranges::sort(graph.wires, {}, [](const Wire& wire) { return WireEnds{wire.from, wire.to}; });
    return graph;
}

void expect_round_trip(const HandIn& hand_in, const std::string& what) {
    const auto read = parse_hand_in(write_hand_in(hand_in), "x" + std::string(hand_in_ending));
    ASSERT_TRUE(read) << what << ": " << read.error().text() << "\n" << write_hand_in(hand_in);
    HandIn expected = hand_in, found = *read;
    expected.submission.brain = sorted(expected.submission.brain);
    found.submission.brain = sorted(found.submission.brain);
    EXPECT_EQ(found, expected) << what;
}

std::string fault(const std::string& toml) {
    const auto read = parse_hand_in(toml, "h.toml");
    return read ? "" : read.error().text();
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

}  // namespace

TEST(HandIn, IsReadAsItWasWritten) { expect_round_trip(sample(), "sample"); }

// The submissions of the course: wires, curves, neurons, thresholds, sensors, learning wires.
TEST(HandIn, HoldsABrainWithoutNodes) {
    HandIn empty = sample();
    empty.submission = {};
    expect_round_trip(empty, "a hand-in without a node");
}

TEST(HandIn, HoldsEverySubmissionOfTheCourse) {
    int submissions = 0, with_sensors = 0, with_curves = 0, with_neurons = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(BRAITENLAB_SOURCE) / "exercises" / "guided")) {
        const auto exercise = load_exercise(entry.path());
        ASSERT_TRUE(exercise) << exercise.error().text();
        std::vector<Submission> all{as_shipped(*exercise), with_solution(*exercise)};
        for (const Answer& wrong : exercise->wrong) all.push_back(wrong.submission);
        for (const Submission& submission : all) {
            HandIn hand_in = sample();
            hand_in.exercise = exercise->id;
            hand_in.submission = submission;
            expect_round_trip(hand_in, exercise->id);
            ++submissions;
            with_sensors += submission.sensors != as_shipped(*exercise).sensors;
            with_curves +=
                std::ranges::any_of(submission.brain.wires, [](const Wire& w) { return w.curve != Curve{}; });
            with_neurons += submission.brain.nodes.size() > 4;
        }
    }
    EXPECT_GT(submissions, 60);
    EXPECT_GT(with_sensors, 0);
    EXPECT_GT(with_curves, 0);
    EXPECT_GT(with_neurons, 0);
}

TEST(HandIn, ReportsTheLineOfAFault) {
    const std::string good = write_hand_in(sample());
    ASSERT_EQ(fault(good), "");
    EXPECT_EQ(fault(""), "h.toml:1: 'format' is missing; begin the file with format = 1");
    EXPECT_TRUE(fault("format = 1\nstudent = \"A").starts_with("h.toml:2: not TOML"));
    EXPECT_EQ(fault("format = 1\nstudent = \"A\"\nexercise = \"5\"\n"),
              "h.toml:1: 'submission' is missing; write the file again in the lab");
    EXPECT_EQ(fault(replaced(good, "Ana López", " ")), "h.toml:2: 'student' is empty");
    EXPECT_TRUE(fault(replaced(good, "runs = 7", "runs = -7")).starts_with("h.toml:6: 'runs' is -7"));
    EXPECT_TRUE(fault(replaced(good, "runs = 7", "ruins = 7")).starts_with("h.toml:6: no key 'ruins'"));
    EXPECT_TRUE(fault(replaced(good, "hints = 3", "hints = \"3\"")).starts_with("h.toml:7: 'hints' should be"));
    EXPECT_TRUE(fault(replaced(good, "passed_starts = 4", "passed_starts = 40")).starts_with("h.toml:10: 'passed"));
    EXPECT_TRUE(fault(replaced(good, "LR = 1.5", "LR = nan")).starts_with("h.toml:14: 'LR' is nan"));
}

TEST(HandIn, WritesTextsWithinTheirLimits) {
    HandIn hand_in = sample();
    hand_in.student = std::string(limits::student_length - 1, 'a') + "ä";
    hand_in.notes = std::string(limits::notes_length + 5, 'n');
    const auto read = parse_hand_in(write_hand_in(hand_in), "x");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->student, std::string(limits::student_length - 1, 'a')) << "not half of a character";
    EXPECT_EQ(read->notes.size(), limits::notes_length);
}

TEST(HandIn, NamesItsFileAfterExerciseAndStudent) {
    EXPECT_EQ(hand_in_name("05-aggressor", "Ana López"), "05-aggressor-ana-lopez.braiten-handin.toml");
    EXPECT_EQ(hand_in_name("05-aggressor", " J. Müller-Weiß "), "05-aggressor-j-mueller-weiss.braiten-handin.toml");
    EXPECT_EQ(hand_in_name("05", "Ana", 2), "05-ana-2.braiten-handin.toml");
    EXPECT_EQ(hand_in_name("05", "../../etc"), "05-etc.braiten-handin.toml") << "no folders";
    EXPECT_EQ(hand_in_name("05", "?"), "05-student.braiten-handin.toml");
    EXPECT_EQ(hand_in_name("05", "李雷"), "05-李雷.braiten-handin.toml");
    EXPECT_LT(hand_in_name("05", std::string(500, 'x')).size(), 120u);
    EXPECT_TRUE(is_hand_in(hand_in_name("05", "Ana")));
    EXPECT_FALSE(is_hand_in("brain.toml"));
}

TEST(HandIn, ComparesNamesOfStudentsWithoutCaseAndSpaces) {
    EXPECT_TRUE(is_same_student("Ana López", " ana  lópez "));
    EXPECT_FALSE(is_same_student("Ana López", "Ana Lopez"));
    EXPECT_FALSE(is_same_student("Ana B", "AnaB"));
}

TEST(HandIn, RefusesABrainThatCannotRunAtItsLine) {
    const std::string good = write_hand_in(sample());
    const std::string wires = "\n[[submission.brain.wire]]\nfrom = \"ML\"\nto = \"SL\"\n";
    EXPECT_EQ(fault(good + wires), "h.toml:13: a wire runs into the sensor 'SL'; sensors only send");
}

TEST(HandIn, NamesItsExercise) {
    const std::string good = write_hand_in(sample());
    EXPECT_EQ(fault(replaced(good, "exercise = \"05-aggressor\"\n", "")),
              "h.toml:1: 'exercise' is missing; write the file again in the lab");
}

}  // namespace braitenlab::tests::hand_in_test
