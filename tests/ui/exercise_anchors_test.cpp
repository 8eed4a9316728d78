#include <set>

#include "core/lesson/anchors.h"
#include "desk.h"

namespace braitenlab::tests::exercise_anchors_test {

// The states of an exercise in which the window shows different widgets.
void (*const states[])(LessonView&){
    [](LessonView&) {},
    [](LessonView& lesson) {
        lesson.attempt.answers.prediction = 0, lesson.attempt.work.has_run = true;
        lesson.selection.emplace();
    },
    [](LessonView& lesson) {
        lesson.attempt.answers.prediction = 0, lesson.attempt.work.has_run = true;
        lesson.attempt.answers.hints_shown = static_cast<int>(lesson.exercise->hints.size());
        lesson.grade = graded(std::vector<bool>(static_cast<std::size_t>(lesson.exercise->starts), false), false);
        lesson.shipped_grade = lesson.grade;
        lesson.shipped_grade->starts.front().verdicts = {Verdict{false, {{6, 12, "s"}}}};
    }};

void record(Exercise exercise, void (*state)(LessonView&), Mode mode, std::set<std::string>& ids) {
    Desk desk(1920, 1700, 1, true);  // has room for the exercise, the map and the robots
    desk.opened = std::move(exercise);
    desk.opened.median.step = 1;
    desk.open_exercise();
    desk.panels.card(ui::Card::information).folded = false;
    desk.now.brains = {std::make_shared<BrainGraph>(desk.opened.scene.kinds[0].brain)};
    desk.now.kind_brains = desk.now.brains;
    state(desk.lesson);
    const insight::MapCells cells(8);
    desk.view.features.map = MapView{.cells = &cells, .x = *insight::axis_of("LL=RR"), .y = *insight::axis_of("LR=RL")};
    desk.view.settings.map = desk.view.settings.reality = true;
    const auto report = insight::report_of({}, std::vector<insight::RobotResult>(3), false);
    desk.view.features.robots = RobotsView{.count = 3, .is_on = true, .report = &report};
    const insight::Design design;
    desk.view.features.slots.slots[0].design = &design;
    desk.view.mode = mode;
    const auto note = [&] {
        desk.frame(4);
        for (const auto& [id, rect] : desk.anchors.all()) ids.insert(id);
    };
    note();
    desk.view.features.robots->is_on = false;
    desk.lesson.attempt.work.has_run = desk.lesson.attempt.work.outcome_known = false;  // the prediction is open
    desk.lesson.grade.reset();
    note();
    desk.view.settings.map = desk.view.settings.reality = false;  // room for the whole exercise card
    note();
    desk.lesson.at_start = false, desk.lesson.attempt.work.has_run = true;  // title and reason
    note();
}

// A window with an exercise whose brain has all four wires, and which offers all controls or some.
std::set<std::string> recorded_anchors(const Exercise& exercise) {
    std::set<std::string> ids;
    for (const Mode mode : {Mode::paused, Mode::wiring})
        for (const auto state : states) record(exercise, state, mode, ids);
    Exercise some = exercise;
    some.offers = {"LL=RR", "LR", "curves", "wiring", "breeding:chase-ten"};
    some.prediction.path_of = "one";
    for (Wire& wire : some.scene.kinds[0].brain.wires) wire.curve = {Response::hump, 0.2f, 0.1f};
    record(some, states[0], Mode::paused, ids);
    record(some, states[1], Mode::paused, ids);
    return ids;
}

TEST(ExerciseAnchors, EqualTheAnchorsThatTheWindowRecords) {
    Exercise opened = exercise();
    opened.scene = *snapshot(0).scene;
    opened.scene.starts.emplace_back().kind = opened.scene.kinds[0].name;
    opened.scene.kinds[0].brain =
        make_graph({.LL = 1, .LR = 0.5f, .RL = 0.5f, .RR = 1, .threshold_LR = 0.1f, .LM = 0.1f, .RM = 0.1f});
    const auto anchors = anchors_of(opened);
    const std::set<std::string> known(anchors.begin(), anchors.end());
    std::set<std::string> recorded = recorded_anchors(opened);
    EXPECT_EQ(known.size(), anchors.size()) << "an anchor is listed twice";
    for (const std::string& id : known) EXPECT_TRUE(recorded.count(id)) << "the window has no " << id;
    // The words of the glossary in a text depend on the text; a hint that names one underlines it itself.
    std::erase_if(recorded,
                  [](const std::string& id) { return id.starts_with("term.") || id.starts_with("reality.robot."); });
    for (const std::string& id : recorded) EXPECT_TRUE(known.count(id)) << "core/lesson/anchors.cpp lacks " << id;
}

}  // namespace braitenlab::tests::exercise_anchors_test
