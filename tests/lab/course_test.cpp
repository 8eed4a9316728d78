// Every exercise of the course, passed by edits of the offered controls alone.
#include <chrono>
#include <filesystem>

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/lab_requests.h"
#include "core/lesson/submission.h"
#include "core/scene/sensor_pairs.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::course_test {
namespace {

using namespace std::chrono_literals;

// The edits that the controls of the exercise send to reach its solution.
std::vector<Command> edits_to_solution(const Exercise& exercise) {
    const Target target{.kind = subject_kind(exercise.scene)};
    const Submission shipped = as_shipped(exercise), solution = with_solution(exercise);
    std::vector<Command> edits;
    if (offers(exercise, offer_parts::sensors) && solution.sensors != shipped.sensors)
        edits.emplace_back(SetSensors{target, solution.sensors});
    if (offers(exercise, offer_parts::wiring) || offers(exercise, offer_parts::curves) ||
        offers(exercise, offer_parts::selection)) {
        edits.emplace_back(SetBrain{target, solution.brain});
        return edits;
    }
    std::vector<SensorPair> pairs;
    for (const KindPair& pair : sensor_pairs(shipped.sensors)) pairs.push_back(pair.sensors);
    if (pairs.empty()) pairs.emplace_back();
    for (const Offer& offer : offered_dials(exercise))
        for (const Dial dial : offer.dials)
            for (const SensorPair& pair : pairs)
                if (const float value = at(read_dials(solution.brain, pair), dial);
                    value != at(read_dials(shipped.brain, pair), dial))
                    edits.emplace_back(TurnDial{target, dial, value, pair});
    return edits;
}

class CourseInTheLab : public testing::TestWithParam<std::string> {};

TEST_P(CourseInTheLab, IsPassedThroughTheOfferedControlsAlone) {
    Lab lab = opened_lab(GetParam().c_str());
    ASSERT_TRUE(lab.document.lesson);
    const Exercise exercise = *lab.document.lesson->exercise;
    const std::vector<Command> edits = edits_to_solution(exercise);
    EXPECT_FALSE(edits.empty());
    for (const Command& edit : edits) handle(lab, EditRequest{edit});
    for (int i = 0; i < 60 * static_cast<int>(exercise.seconds) && !referee_of(lab.document).passed(); ++i) tick(lab);
    ASSERT_TRUE(referee_of(lab.document).passed());
    Jobs jobs(0);
    for (int turn = 0; turn < 100000 && !grade_of(*lab.document.lesson); ++turn) {
        update_grading(lab, jobs);
        jobs.deliver(1ms);
    }
    const LessonView view = lesson_view_of(lab);
    ASSERT_TRUE(view.grade);
    EXPECT_TRUE(view.grade->good);
    EXPECT_FALSE(view.standing.outside_offers || view.standing.too_many_changes);
}

std::vector<std::string> exercises() {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "guided"))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Exercises, CourseInTheLab, testing::ValuesIn(exercises()), [](const auto& each) {
    std::string name = each.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace braitenlab::tests::course_test
