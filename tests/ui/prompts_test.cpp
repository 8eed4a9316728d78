#include "ui/panels/prompts.h"

#include "breeding_on_desk.h"
#include "desk.h"
#include "render/view/pick.h"

namespace braitenlab::tests::prompts_test {

using namespace ui;

struct Prompts : ::testing::Test {
    Desk desk;
    PromptMemory memory;

    Prompt next() { return next_prompt(memory, desk.view); }
    std::string_view anchor() { return next().anchor; }
    void at(double seconds, Mode mode = Mode::playing) {
        desk.now.seconds = seconds;
        desk.now.tick = static_cast<std::uint64_t>(seconds * 60);
        desk.view.timeline.latest = desk.now.tick == 0 ? 0 : std::max(desk.view.timeline.latest, desk.now.tick);
        desk.view.mode = mode;
    }
    // One vehicle and one lamp, as in most scenes of the book.
    void alone() {
        desk.now = snapshot(0);
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->sources.resize(1);
        file_ = *scene;
        desk.view.file = &file_;
        desk.now.scene = scene;
        desk.now.sources.resize(1);
        desk.now.vehicles[0].speed = 1;
    }
    void move_lamp() {
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->sources[0].x += 1;
        desk.now.scene = scene;
    }
    void see(float value) { desk.now.sensed.assign(desk.now.sensed.size(), value); }

private:
    Scene file_;
};

struct LessonPrompts : Prompts {
    LessonPrompts() {
        desk.open_exercise();
        desk.now.vehicles[0].speed = 1;
        desk.lesson.attempt.answers.prediction = 0;
        desk.lesson.attempt.work.has_run = true;
    }
    void all_done() {
        for (Verdict& verdict : desk.lesson.verdicts) verdict.done = true;
    }
};

TEST_F(Prompts, PointToPlayThenToASliderThenDisappear) {
    EXPECT_EQ(anchor(), "button.play");
    EXPECT_EQ(next().hint, "hint.press_play");
    at(1);
    EXPECT_EQ(anchor(), "") << "no prompt while the student watches the behaviour";
    at(5);
    EXPECT_EQ(anchor(), "slider.LR") << "LL of the selected predator has no effect";
    desk.view.undo_depth = 1;
    EXPECT_NE(anchor(), "slider.LR");
    desk.view.undo_depth = 0;
    EXPECT_NE(anchor(), "slider.LR") << "not shown a second time";
    at(0, Mode::paused);
    EXPECT_NE(anchor(), "button.play") << "also after a reset";
}

TEST_F(Prompts, PointToASliderOfTheChosenPair) {
    alone();
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    for (const float side : {1.0f, -1.0f})
        scene->kinds[0].sensors.push_back(
            {.name = side > 0 ? "HL" : "HR", .channel = Channel::heat, .y = 0.2f * side, .angle = 0.5f * side});
    desk.now.scene = scene;
    desk.view.settings.selection.pair = "heat";
    at(5);
    desk.now.sensed = {0.4f, 0.4f, 0, 0.4f};
    EXPECT_EQ(anchor(), "slider.LR") << "HL reads 0, and no wire leads from HR";
}

TEST_F(Prompts, PointToASliderWhoseSensorReadsSomething) {
    alone();
    at(5);
    desk.now.sensed = {0, 0.4f};
    EXPECT_EQ(anchor(), "slider.RR") << "LL and RR are wires; SL reads 0";
    EXPECT_EQ(next().hint, "hint.turn_slider");
    at(5, Mode::paused);
    EXPECT_EQ(next().hint, "hint.turn_slider_paused") << "it does not drive";
}

TEST_F(Prompts, PointToTheLampIfBothEyesReadNothing) {
    alone();
    at(5), see(0);
    EXPECT_EQ(anchor(), lamp_anchor) << "no slider has an effect";
    EXPECT_EQ(next().hint, "hint.lamp_nearer");
    desk.now.sources[0].channel = Channel::heat;
    EXPECT_EQ(anchor(), "") << "the vehicle does not sense heat";
}

TEST_F(Prompts, PointToTheFirstLampThatTheVehicleSenses) {
    alone();
    desk.now.sources.resize(2);
    desk.now.sources[0].channel = Channel::heat;
    desk.now.sources[1].x = 2;
    const CameraView camera_view =
        look(Camera{}, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, {300, 60, 600, 600});
    desk.view.camera_view = &camera_view;
    at(5), see(0);
    desk.frame(2);
    const auto lamp = project(camera_view, {2, 0}, bulb_height);
    ASSERT_TRUE(lamp);
    const Rect ring = desk.where(lamp_anchor);
    EXPECT_NEAR(ring.x + ring.w / 2, lamp->x, 1);
}

TEST_F(Prompts, DoNotCallAVehicleLostThatHasStopped) {
    alone();
    desk.now.vehicles[0].speed = 0;
    desk.view.undo_depth = 1;
    at(5), see(0), next();
    at(9);
    EXPECT_NE(next().hint, "hint.lost") << "its brain may have stopped it, as that of scene Logic does";
}

TEST_F(Prompts, PointToPlayAfterAnEdit) {
    desk.view.undo_depth = 1;
    EXPECT_EQ(anchor(), "button.play");
}

TEST_F(Prompts, DoNotRepeatTheSliderInTheSameScene) {
    at(5);
    EXPECT_EQ(anchor(), "slider.LR");
    at(9);
    EXPECT_NE(anchor(), "slider.LR");
    at(5);
    EXPECT_NE(anchor(), "slider.LR");
    desk.view.documents.opened = "another scene";
    EXPECT_EQ(anchor(), "slider.LR");
}

TEST_F(Prompts, DoNotSuggestInAnotherSceneWhatThePersonHasDone) {
    at(5);
    EXPECT_EQ(anchor(), "slider.LR");
    desk.view.undo_depth = 1;
    next();
    EXPECT_TRUE(memory.followed.slider);
    desk.view.undo_depth = 0;
    desk.view.documents.opened = "another scene";
    EXPECT_NE(anchor(), "slider.LR");
    PromptMemory at_the_next_start;
    at_the_next_start.followed = memory.followed;
    memory = at_the_next_start;
    EXPECT_NE(anchor(), "slider.LR");
}

TEST_F(Prompts, PointInFreePlayToSliderLampWiringAndTimeline) {
    alone();
    at(5);
    EXPECT_EQ(anchor(), "slider.LL");
    desk.view.undo_depth = 1;
    EXPECT_EQ(anchor(), lamp_anchor);
    EXPECT_EQ(next().hint, "hint.drag_lamp");
    move_lamp();
    EXPECT_EQ(anchor(), "button.wiring");
    desk.view.mode = Mode::wiring;
    EXPECT_EQ(anchor(), "pin.SL.out");
    desk.view.undo_depth = 2;
    EXPECT_EQ(anchor(), "") << "a wire was drawn";
    at(10);
    EXPECT_EQ(anchor(), "") << "the wiring is known, and the recording is short";
    at(20);
    EXPECT_EQ(anchor(), "timeline.track");
    at(12, Mode::paused);
    EXPECT_EQ(anchor(), "");
    EXPECT_EQ(next().hint, "hint.in_the_past");
    at(20);
    EXPECT_EQ(next().hint, "") << "all controls are known";
}

TEST_F(Prompts, DoNotAskForAFirstWireInAnExercise) {
    alone();
    desk.view.mode = Mode::wiring;
    EXPECT_EQ(next().hint, "hint.first_wire");
    desk.open_exercise();
    desk.view.mode = Mode::wiring;
    EXPECT_EQ(next().hint, "");
}

TEST_F(Prompts, AskForAWireOnlyWhereOneIsMissing) {
    alone();
    desk.view.mode = Mode::wiring;
    desk.now.brains[0] = std::make_shared<BrainGraph>(make_graph({.LL = 1, .RR = 1}));
    EXPECT_EQ(anchor(), "pin.SL.out") << "to the other motor";
    desk.now.brains[0] = std::make_shared<BrainGraph>(make_graph({.LL = 1, .RL = 1}));
    EXPECT_EQ(anchor(), "") << "the eye is joined to both";
}

TEST_F(Prompts, PointOnlyToPinsOfTheBrain) {
    alone();
    auto brain = std::make_shared<BrainGraph>(*desk.now.brains[0]);
    for (Node& node : brain->nodes)
        if (node.name == "SL") node.name = "warmth";
    desk.now.brains[0] = brain;
    desk.view.mode = Mode::wiring;
    EXPECT_EQ(anchor(), "");
    EXPECT_EQ(next().hint, "") << "no anchor pulses in this mode";
    desk.view.settings.selection.vehicle = no_vehicle;
    EXPECT_EQ(anchor(), "") << "no brain is visible";
}

TEST_F(Prompts, EndAfterATimeLimit) {
    alone();
    at(9);
    EXPECT_EQ(anchor(), lamp_anchor);
    desk.view.wall_seconds = 13;
    EXPECT_EQ(anchor(), "button.wiring");
    desk.view.wall_seconds = 26;
    EXPECT_EQ(anchor(), "");
}

TEST_F(Prompts, PointToResetIfTheVehicleSensesNothing) {
    alone();
    desk.view.undo_depth = 1;
    at(5), see(0);
    EXPECT_NE(anchor(), "button.reset");
    at(7);
    EXPECT_NE(anchor(), "button.reset") << "the vehicle may still turn";
    at(8.5);
    EXPECT_EQ(anchor(), "button.reset");
    EXPECT_EQ(next().hint, "hint.lost");
    see(0.3f);
    EXPECT_NE(anchor(), "button.reset");
    see(0);
    at(0, Mode::paused);
    EXPECT_NE(anchor(), "button.reset") << "the vehicle senses the lamp again";
}

TEST_F(LessonPrompts, PointToResetOnceTheVehicleOfTheExerciseIsGone) {
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->starts.emplace_back().kind = scene->kinds[0].name;
    desk.now.scene = scene;
    at(3);
    EXPECT_NE(next().hint, "hint.gone");
    desk.now.vehicles.clear();
    EXPECT_EQ(anchor(), "button.reset");
    EXPECT_EQ(next().hint, "hint.gone");
    desk.lesson.attempt.answers.hints_shown = 1;
    EXPECT_EQ(next().hint, "hint.gone") << "no control that a hint names can change this run";
}

TEST(EmptyScene, PointsAtNothingAndSaysHowToAddAVehicle) {
    Desk desk;
    desk.now = snapshot(0);
    desk.now.vehicles.clear();
    desk.view.settings.selection = {};
    PromptMemory memory;
    for (const Mode mode : {Mode::paused, Mode::playing}) {
        desk.view.mode = mode;
        EXPECT_EQ(next_prompt(memory, desk.view).anchor, "") << "Play would show nothing";
        desk.frame(3);
        EXPECT_TRUE(desk.says("The scene has no vehicle"));
    }
}

TEST_F(LessonPrompts, SayThatSomethingIsInTheWayWhereEveryRunEndsThere) {
    desk.opened.seconds = 40;
    desk.opened.offers = {"LM", "RM"};
    desk.lesson.attempt.answers.hint_ready = false;
    desk.now.vehicles[0].start = 0;
    at(0, Mode::paused), next();
    desk.now.vehicles[0].speed = 0;
    at(5), next(), at(11.5);
    EXPECT_EQ(next().hint, "hint.change_blocked");
    EXPECT_TRUE(is_slider(anchor())) << anchor();
    EXPECT_EQ(next_change(desk.view, anchor()), "hint.change.pulsing");
}

TEST_F(Prompts, PointToResetIfASingleVehicleIsStuck) {
    alone();
    desk.now.vehicles[0].speed = 0;
    at(5), next(), at(10.5), next(), at(11.5);
    EXPECT_EQ(next().hint, "hint.blocked");
    EXPECT_EQ(anchor(), "button.reset");
    desk.now.vehicles[0].motor = {0.4f, -0.4f};
    EXPECT_EQ(next().hint, "hint.stuck") << "its wheels turn it, they do not push it";
    desk.now.vehicles[0].motor = {0, 0};
    EXPECT_EQ(next().hint, "hint.halted") << "its brain stops it, nothing is in its way";
    desk.now = snapshot(4);
    at(5), next(), at(12);
    EXPECT_NE(anchor(), "button.reset");
}

TEST_F(LessonPrompts, RequestAPredictionBeforeTheFirstPlay) {
    desk.lesson.attempt.work.has_run = false;
    desk.lesson.attempt.answers.prediction = -1;
    EXPECT_EQ(anchor(), "exercise.predict");
    EXPECT_EQ(next().hint, "hint.predict");
    desk.lesson.attempt.answers.prediction = 0;
    EXPECT_EQ(anchor(), "button.play");
}

TEST_F(LessonPrompts, PointToStartOverWhereTheSceneOfTheQuestionIsChanged) {
    at(0, Mode::paused);
    desk.lesson.attempt.work.has_run = false;
    for (const int answer : {-1, 0}) {
        desk.lesson.attempt.answers.prediction = answer;
        desk.lesson.as_given = true;
        EXPECT_NE(next().hint, "hint.start_over") << answer;
        desk.lesson.as_given = false;
        EXPECT_EQ(next().hint, "hint.start_over") << answer;
        EXPECT_EQ(anchor(), "exercise.reset") << answer;
    }
    desk.lesson.attempt.work.has_run = true;
    EXPECT_NE(next().hint, "hint.start_over") << "a run of a changed scene is the choice of the student";
}

TEST_F(LessonPrompts, PointToTheAnchorOfTheNewestHintUntilItIsUsed) {
    at(5), see(0);
    desk.lesson.attempt.answers.hints_shown = 3;
    EXPECT_EQ(anchor(), "slider.LR");
    at(9);
    EXPECT_EQ(anchor(), "slider.LR") << "before the prompt to reset";
    desk.view.undo_depth = 1;
    EXPECT_EQ(anchor(), "button.reset") << "it faces away from the lamp: only a new start shows the change";
    at(0, Mode::paused);
    EXPECT_EQ(anchor(), "button.play");
    at(0);
    EXPECT_EQ(anchor(), "");
}

TEST_F(LessonPrompts, OfferAHintAfterAFailedRun) {
    desk.opened.seconds = 40;
    desk.view.undo_depth = 1;
    at(15);
    EXPECT_NE(anchor(), "exercise.hint");
    at(21);
    EXPECT_EQ(anchor(), "exercise.hint");
    desk.lesson.attempt.answers.hint_ready = false;
    EXPECT_NE(anchor(), "exercise.hint");
}

TEST_F(LessonPrompts, PointToResetAfterAChangeInARunInWhichTheVehicleSensesNothing) {
    desk.now.vehicles.resize(1);
    desk.now.vehicles[0].speed = 0;  // at the wall
    desk.opened.seconds = 40;
    desk.lesson.attempt.work.has_run = true;
    desk.now.tick = 0;
    at(0), next();
    desk.now.tick = 1;
    const auto before = desk.now.brains[0];
    auto wired = std::make_shared<BrainGraph>(*before);
    wired->wires[0].weight += 0.3f;
    desk.now.brains[0] = wired;
    const auto see = [&](float reading) { desk.now.sensed.assign(desk.now.sensed.size(), reading); };
    see(0);
    at(21);
    EXPECT_EQ(anchor(), "exercise.hint") << "it may turn past the lamp";
    at(25);
    EXPECT_EQ(anchor(), "button.reset");
    EXPECT_EQ(next().hint, "hint.changed_since");
    auto biased = std::make_shared<BrainGraph>(*before);
    biased->nodes.back().bias += 0.3f;
    desk.now.brains[0] = biased;
    EXPECT_EQ(anchor(), "exercise.hint") << "a bias acts without a stimulus";
    desk.now.brains[0] = wired;
    see(0.5f);
    EXPECT_EQ(anchor(), "exercise.hint") << "the change shows in this run";
}

TEST_F(LessonPrompts, AskForNoChangeWhileTheRunCompletesAStep) {
    desk.opened.seconds = 40;
    desk.view.undo_depth = 1;
    at(21);
    EXPECT_EQ(anchor(), "exercise.hint");
    desk.lesson.verdicts = {{.measures = {{.value = 8.9f, .needed = 9, .unit = "s"}}}};
    EXPECT_EQ(anchor(), "");
    desk.lesson.verdicts[0].measures[0].value = 0;
    EXPECT_EQ(anchor(), "exercise.hint") << "the condition does not hold";
    desk.lesson.verdicts[0].measures[0] = {.value = 2, .needed = 9, .unit = "s"};
    desk.lesson.verdicts.push_back({.measures = {{.value = 1, .needed = 2, .unit = "m"}}});
    EXPECT_EQ(anchor(), "exercise.hint") << "it takes long";
    desk.lesson.verdicts.pop_back();
    desk.lesson.verdicts[0].measures[0] = {.value = 8.9f, .needed = 9, .unit = "m"};
    EXPECT_EQ(anchor(), "exercise.hint") << "a distance";
}

TEST_F(LessonPrompts, AskForNoChangeWhileWaitingCompletesEveryStep) {
    desk.opened.seconds = 31;
    desk.view.undo_depth = 1;
    at(21);
    desk.lesson.verdicts.assign(2, Verdict{false, {{21, 30, "s"}}});
    EXPECT_TRUE(next().hint.empty());
    desk.lesson.verdicts[1].lost = true;
    EXPECT_EQ(next().hint, "hint.ask");
}

// Of conditioning: the vehicle stands in the dark until a lamp is switched on.
TEST_F(LessonPrompts, AskForNoResetWhileAStepIsStillToBeJudged) {
    desk.now.vehicles.resize(1);
    desk.now.vehicles[0].speed = 0;
    desk.lesson.attempt.work.has_run = true;
    desk.opened.seconds = 60;
    desk.opened.steps.resize(1);
    desk.opened.steps[0].check.earliest = 40;
    desk.lesson.verdicts.assign(1, Verdict{});
    at(1), next();
    at(12);
    EXPECT_EQ(anchor(), "");
    desk.opened.steps[0].check.earliest = 10;
    EXPECT_EQ(anchor(), "button.reset");
}

TEST_F(LessonPrompts, AHintThatNamesAHiddenWidgetSaysNotThatItPulses) {
    const auto says = [&](std::string_view words) {
        desk.frame(3);
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& w) { return w.words.find(words) != std::string::npos; });
    };
    desk.lesson.attempt.work.has_run = true;
    desk.lesson.attempt.answers.prediction = 0;
    desk.lesson.attempt.answers.hints_shown = 1;
    desk.opened.hints = {{"Raise it.", "slider.LL"}};
    at(3);
    EXPECT_TRUE(says("Try what pulses"));
    desk.opened.hints[0].anchor = "wire.weight";  // of the diagram, which is closed
    EXPECT_TRUE(says("Do what the hint says"));
    EXPECT_FALSE(says("Try what pulses"));
}

TEST_F(LessonPrompts, PointToNoButtonThatWouldUndoWhatTheHintAsksFor) {
    const auto with = [&](const char* button) {
        desk.opened.hints = {{"Open it.", button}};
        desk.lesson.attempt.answers.hints_shown = 1;
        return next();
    };
    at(5);
    EXPECT_EQ(with("button.watch").anchor, "button.watch");
    desk.view.settings.watching = true;
    EXPECT_EQ(with("button.watch").anchor, "") << "it would close the diagram";
    EXPECT_EQ(with("button.watch").hint, "hint.after_hint");
    EXPECT_EQ(with("button.wiring").anchor, "button.wiring");
    EXPECT_EQ(with("button.play").anchor, "") << "it plays";
    at(5, Mode::paused);
    EXPECT_EQ(with("button.play").anchor, "button.play");
    EXPECT_EQ(with("exercise.compare").anchor, "exercise.compare");
    desk.lesson.attempt.work.compares = true;
    EXPECT_EQ(with("exercise.compare").anchor, "");
    at(5, Mode::wiring);
    EXPECT_EQ(with("button.wiring").anchor, "");
}

TEST_F(LessonPrompts, AskToThinkWhereAHintAsks) {
    const auto with = [&](const char* words, const char* anchor) {
        desk.opened.hints = {{words, anchor}};
        desk.lesson.attempt.answers.hints_shown = 1;
        return next();
    };
    at(5);
    EXPECT_EQ(with("Which is it?", "slider.LL").hint, "hint.think");
    EXPECT_EQ(with("Which is it?", "slider.LL").anchor, "slider.LL");
    EXPECT_EQ(with("Raise it.", "slider.LL").hint, "hint.follow_hint");
    (void)with("What is its sum?", "node.N");
    for (const std::string& language : shipped_codes()) {
        desk.strings = speaking(language);
        desk.frame(3);
        EXPECT_EQ(desk.panels.prompts.highlight.anchor, "button.watch") << "the diagram is closed";
        const std::string_view all = desk.strings("hint.think");
        EXPECT_TRUE(desk.says(all.substr(0, all.find(':')))) << language;
        EXPECT_FALSE(desk.says(desk.strings("hint.after_hint").substr(0, 12))) << language;
    }
}

// A run that began at the start, seen, with a brain that no other vehicle of the snapshot has.
TEST_F(LessonPrompts, PointToASliderAfterARunThatFailedUnchanged) {
    desk.opened.seconds = 20;
    desk.lesson.attempt.answers.hint_ready = false;
    at(0, Mode::paused);
    EXPECT_EQ(anchor(), "button.play");
    at(1), next();
    see(0);
    at(2), next(), at(8);
    EXPECT_EQ(anchor(), "slider.LL") << "it has seen the lamp";
    EXPECT_EQ(next().hint, "hint.change_then_reset");
    at(0, Mode::paused);
    EXPECT_EQ(anchor(), "slider.LL") << "Play alone repeats the run";
    EXPECT_EQ(next().hint, "hint.change_then_play");
    auto wired = std::make_shared<BrainGraph>(*desk.now.brains[0]);
    wired->wires[0].weight += 0.3f;
    desk.now.brains[0] = wired;
    EXPECT_EQ(anchor(), "button.play");
    desk.lesson.attempt.answers.hint_ready = true;
    desk.view.undo_depth = 1;
    at(1), next(), at(2), next(), at(8);
    EXPECT_EQ(anchor(), "exercise.hint") << "a second try";
}

// No weight moves a vehicle that rests where it sees nothing.
TEST_F(LessonPrompts, PointToABiasAfterARunThatEndedAtRestInTheDark) {
    desk.opened.seconds = 20;
    desk.opened.offers = {"LL", "LM=RM"};
    at(0, Mode::paused), next(), at(1), next();
    see(0);
    desk.now.vehicles[0].speed = 0, desk.now.vehicles[0].motor = {0, 0};
    at(2), next(), at(21);
    EXPECT_EQ(anchor(), "bias.LM");
    at(0, Mode::paused);
    EXPECT_EQ(anchor(), "bias.LM") << "also at the start of the next run";
}

TEST_F(LessonPrompts, ChangedSensorsMakeAnotherRunToo) {
    desk.opened.seconds = 20;
    at(0, Mode::paused), next();
    at(21);
    EXPECT_NE(anchor(), "button.reset");
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].sensors[0].angle += 1;
    desk.now.scene = scene;
    EXPECT_EQ(anchor(), "button.reset");
    EXPECT_EQ(next().hint, "hint.changed_since");
}

TEST_F(Prompts, GoOnFromTheMomentOfAChangeInThePast) {
    at(0, Mode::paused), next();
    at(10), next();
    at(4, Mode::paused);
    EXPECT_EQ(next().hint, "hint.in_the_past");
    desk.view.undo_depth = 1;
    desk.view.timeline.latest = desk.now.tick;  // the change has removed what came later
    EXPECT_EQ(anchor(), "button.play");
    EXPECT_EQ(next().hint, "hint.play_on");
    at(5);
    EXPECT_NE(next().hint, "hint.play_on");
    at(5, Mode::paused);
    EXPECT_NE(next().hint, "hint.play_on") << "it has played on";
}

TEST_F(Prompts, AVehicleWithoutWiresNeedsABrainBeforePlay) {
    alone();
    auto empty = std::make_shared<BrainGraph>(*desk.now.brains[0]);
    empty->wires.clear();
    for (Node& node : empty->nodes) node.bias = 0;
    const auto before = desk.now.brains[0];
    desk.now.brains[0] = empty;
    EXPECT_EQ(anchor(), "bias.LM") << "Play moves nothing";
    EXPECT_EQ(next().hint, "hint.no_wires");
    at(9);
    EXPECT_EQ(anchor(), "bias.LM");
    desk.now.brains[0] = before;
    at(0, Mode::paused);
    EXPECT_NE(anchor(), "bias.LM");
}

TEST_F(Prompts, WithoutAnyLampTheLampToolPulses) {
    alone();
    desk.now.sources.clear();
    see(0);
    at(1), next();
    at(9);
    EXPECT_EQ(anchor(), "tool.lamp");
    EXPECT_EQ(next().hint, "hint.nothing_shines");
    desk.now.sources.resize(1);
    EXPECT_NE(anchor(), "tool.lamp") << "a lamp is there, out of sight";
}

TEST_F(LessonPrompts, TheBrainCardOfAVehicleThatIsGoneNamesReset) {
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->starts.emplace_back().kind = scene->kinds[0].name;
    desk.now.scene = scene;
    desk.now.vehicles.clear();
    desk.view.settings.selection.vehicle = no_vehicle;
    at(3);
    for (const std::string& language : shipped_codes()) {
        desk.strings = speaking(language);
        desk.frame(3);
        EXPECT_TRUE(desk.says(desk.strings("brain.gone").substr(0, 12))) << language;
        EXPECT_FALSE(desk.says(desk.strings("brain.no_vehicle").substr(0, 12))) << language;
    }
}

TEST_F(LessonPrompts, PointAtPartsOfTheDiagramInTheWiringEditor) {
    desk.opened.hints = {{"Click it.", "wire.LR"}};
    desk.lesson.attempt.answers.hints_shown = 1;
    at(5, Mode::wiring);
    EXPECT_EQ(anchor(), "wire.LR");
    EXPECT_TRUE(next().hint.empty()) << "the words of the mode stay";
    desk.view.undo_depth = 1;
    EXPECT_EQ(anchor(), "") << "an edit followed it";
}

TEST(PromptsInALowWindow, ACardScrollsOnceToTheWidgetOfAHint) {
    Desk low(1024, 330, 1, true);  // the brain card has room for some of its sliders
    low.open_exercise();
    low.lesson.attempt.work.has_run = low.lesson.attempt.work.outcome_known = true;
    low.lesson.attempt.answers.prediction = 0;
    low.view.mode = Mode::playing;
    low.opened.hints = {{"Raise it.", "bias.RM"}};
    low.frame(4);
    ASSERT_FALSE(low.anchors.find("bias.RM")) << "below the fold";
    low.lesson.attempt.answers.hints_shown = 1;
    low.frame(4);
    EXPECT_TRUE(low.anchors.find("bias.RM"));
    low.point("bias.RM");
    ImGui::GetIO().MouseWheel = 20;
    low.frame(4);
    EXPECT_FALSE(low.anchors.find("bias.RM")) << "the student scrolls back";
}

TEST_F(LessonPrompts, NameWhatTheExerciseOffers) {
    const std::vector<std::pair<std::vector<std::string>, std::string_view>> cases{
        {{"LM", "RM"}, "slider"}, {{"curves"}, "slider"},   {{"wiring"}, "wire"},
        {{"sensors"}, "sensor"},  {{"selection"}, "child"}, {{}, "slider"}};
    for (const auto& [offered, what] : cases) {
        desk.opened.offers = offered;
        desk.follow_disclosure();
        EXPECT_EQ(next_change(desk.view), "hint.change." + std::string(what));
    }
    desk.opened.offers = {"wiring"};
    desk.lesson.attempt.work.free_play = true;
    EXPECT_EQ(next_change(desk.view), "hint.change.slider") << "free play offers all";
    desk.lesson.attempt.work.free_play = false;
    desk.lesson.attempt.answers.prediction = -1;
    desk.follow_disclosure();
    EXPECT_EQ(next_change(desk.view), "hint.change.answer");
    desk.view.may.open_prediction = false;
    EXPECT_EQ(next_change(desk.view), "hint.change.answer_later") << "while a run is not at its start";
    for (const std::string& language : shipped_codes()) {
        desk.strings = speaking(language);
        desk.lesson.attempt.answers.prediction = 0;
        at(1);
        desk.frame(2);
        std::string bar;
        for (const Written& w : desk.written) bar += w.words;
        EXPECT_NE(bar.find(desk.strings("hint.change.wire")), std::string::npos) << language;
        EXPECT_EQ(bar.find("{}"), std::string::npos) << language;
    }
}

TEST_F(LessonPrompts, PointToAControlThatTheExerciseOffers) {
    const std::vector<std::pair<std::vector<std::string>, std::string_view>> cases{
        {{"LM", "RM"}, "bias.LM"},         {{"curves"}, "curve.peak"}, {{"wiring"}, "button.wiring"},
        {{"LM=RM", "LL=RR"}, "slider.LL"}, {{"selection"}, ""},        {{"LR=RL"}, "slider.LR"}};
    for (const auto& [offered, wanted] : cases) {
        memory = {};
        desk.opened.offers = offered;
        at(5);
        next();
        EXPECT_EQ(anchor(), wanted);
    }
}

TEST_F(LessonPrompts, PointToTheBiasThatAHintOfTheExerciseNames) {
    desk.opened.offers = {"LM", "RM"};
    for (const char* hinted : {"bias.RM", "bias.LM"}) {
        memory = {};
        desk.opened.hints.back().anchor = hinted;
        at(5);
        next();
        EXPECT_EQ(anchor(), hinted);
    }
}

TEST_F(LessonPrompts, PointToTheNextExerciseAfterAPass) {
    at(9);
    all_done();
    EXPECT_EQ(next().hint, "hint.steps_done") << "the other starts have no dots yet";
    desk.lesson.grade = graded({true, false}, false);
    EXPECT_EQ(next().hint, "hint.other_starts");
    EXPECT_EQ(anchor(), "exercise.hint") << "what is seen from this start does not help further";
    desk.lesson.attempt.answers.hint_ready = false;
    EXPECT_TRUE(is_slider(anchor())) << "until the next hint";
    desk.lesson.attempt.answers.hint_ready = true;
    desk.lesson.standing.changed_since_done = true;
    EXPECT_EQ(next().hint, "hint.changed_since") << "the steps say nothing about the present brain";
    EXPECT_EQ(anchor(), "button.reset");
    desk.lesson.standing.changed_since_done = false;
    desk.lesson.grade = graded({true, true}, true);
    EXPECT_EQ(anchor(), "exercise.next");
    EXPECT_EQ(next().hint, "hint.passed");
}

TEST_F(LessonPrompts, SayThatNothingIsGradedWhereMoreIsChangedThanTheExerciseAllows) {
    at(9);
    all_done();
    for (bool Standing::*const beyond : {&Standing::outside_offers, &Standing::too_many_changes}) {
        desk.lesson.standing = {};
        desk.lesson.standing.*beyond = true;
        EXPECT_EQ(next().hint, "hint.not_graded");
    }
}

TEST_F(Prompts, DoNotPulseWithReducedMotion) {
    desk.view.program.reduce_motion = true;
    desk.view.wall_seconds = 0;
    EXPECT_EQ(pulse(desk.view), 1);
    desk.view.program.reduce_motion = false;
    EXPECT_NEAR(pulse(desk.view), 0, 1e-6f);
}

// An exercise that is solved by breeding.
struct BredPrompts : LessonPrompts {
    BredPrompts() {
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->starts.emplace_back().kind = scene->kinds[0].name;
        desk.opened.scene = *scene;
        desk.now.scene = scene;
        desk.now.vehicles[0].start = 0;
        desk.opened.offers = {"LL", "RR", "breeding:chase-ten"};
        desk.opened.hints.assign(2, {"Press Breeding.", "exercise.breeding"});
        desk.opened.seconds = 15;
        at(0, Mode::paused), next();
    }
    void show_breeding(const BredOnDesk& bred) {
        BreedingView& view = desk.view.features.breeding;
        view.base = bred.base, view.state = &bred.state, view.matrix = &bred.matrix;
    }
    // A person has watched both matches.
    void look_at_both() {
        BreedingView& view = desk.view.features.breeding;
        const auto matches = telling_matches(view);
        ASSERT_TRUE(matches);
        view.watched = {matches->last, matches->ancestor}, view.watches_by_itself = false;
    }
    void take_champion() {
        auto brain = std::make_shared<BrainGraph>(*desk.now.brains[0]);
        brain->wires[0].weight += 0.5f;
        desk.now.brains[0] = brain;
    }
};

TEST_F(BredPrompts, PlayFirstThenStartTheBreeding) {
    at(3);
    EXPECT_EQ(anchor(), "") << "the run shows what the prey do before they are bred";
    EXPECT_EQ(next().hint, "");
    at(3, Mode::paused);
    EXPECT_EQ(anchor(), "button.play");
    at(16);
    EXPECT_EQ(anchor(), "breeding.start") << "and no slider";
    EXPECT_EQ(next().hint, "hint.breed");
    desk.lesson.attempt.answers.hints_shown = 1;
    EXPECT_EQ(anchor(), "breeding.start");
    EXPECT_EQ(next_change(desk.view), "hint.change.breed");
    at(0, Mode::paused);
    EXPECT_EQ(anchor(), "breeding.start") << "the run is not to be repeated";
}

TEST_F(BredPrompts, WaitWhileTheBreedingRunsThenTakeTheChampionAndPlay) {
    at(16), next();
    BredOnDesk begun(3);
    show_breeding(begun);
    desk.view.features.breeding.runs = true;
    EXPECT_EQ(next().hint, "hint.breeding_runs");
    EXPECT_EQ(anchor(), "") << "there is nothing to press";
    desk.view.features.breeding.runs = false;
    EXPECT_EQ(anchor(), "breeding.start") << "it was stopped";
    BredOnDesk bred(begun.base->breeding().generations + 1);
    show_breeding(bred), look_at_both();
    EXPECT_EQ(anchor(), "breeding.take");
    take_champion();
    EXPECT_EQ(anchor(), "button.reset") << "the run has not shown it from its start on";
    EXPECT_EQ(next().hint, "hint.changed_since");
    at(0, Mode::paused);
    EXPECT_EQ(anchor(), "button.play");
    EXPECT_EQ(next().hint, "hint.play_bred");
    at(5);
    EXPECT_EQ(next().hint, "");
    EXPECT_EQ(anchor(), "");
    desk.lesson.verdicts[1].lost = true;
    EXPECT_EQ(anchor(), "breeding.matrix") << "another prey";
    EXPECT_EQ(next().hint, "hint.breed_again");
    desk.lesson.verdicts[1].lost = false;
    at(15.5);
    EXPECT_EQ(anchor(), "breeding.matrix") << "the time of a graded run is over";
    desk.view.features.breeding.runs = true;
    EXPECT_EQ(next().hint, "hint.breeding_runs");
}

TEST_F(BredPrompts, LeadToTheMatchInWhichAnAncestorIsBetterThanTheLastPreyBeforeItIsTaken) {
    at(16), next();
    BredOnDesk bred(BredOnDesk(0).base->breeding().generations + 1);
    for (float& score : bred.matrix.scores) score = 0.4f;
    const std::size_t last = bred.matrix.size() - 1;
    bred.matrix.scores[12 * bred.matrix.size() + last] = 0.8f;
    bred.matrix.scores[12 * bred.matrix.size() + 9] = 0.1f;
    bred.matrix.scores[12 * bred.matrix.size() + 10] = NAN;
    show_breeding(bred);
    EXPECT_EQ(anchor(), "breeding.cell.12.9");
    EXPECT_EQ(next().hint, "hint.look_at_ancestor");
    BreedingView& view = desk.view.features.breeding;
    view.watched = {{12, 9}}, view.watches_by_itself = true;
    EXPECT_EQ(anchor(), "breeding.cell.12.9") << "no person has chosen it";
    view.watches_by_itself = false;
    EXPECT_EQ(anchor(), "breeding.cell.12." + std::to_string(last));
    EXPECT_EQ(next().hint, "hint.look_at_last");
    view.watched = {{12, static_cast<int>(last)}, {12, 9}};
    EXPECT_EQ(anchor(), "breeding.take");
    EXPECT_EQ(next().hint, "hint.take_worse");
    for (float& score : bred.matrix.scores) score = 0.4f;
    look_at_both();
    EXPECT_EQ(next().hint, "hint.take_champion") << "no ancestor is better";
}

TEST_F(BredPrompts, ThatANewChampionIsTriedBeforeAnotherIsChosen) {
    const int all = BredOnDesk(0).base->breeding().generations + 1;
    BredOnDesk first(all), second(all);
    show_breeding(first);
    take_champion();
    at(0, Mode::paused), next();
    at(15.5);
    EXPECT_EQ(anchor(), "breeding.matrix") << "it has failed";
    show_breeding(second);
    EXPECT_EQ(anchor(), "breeding.take") << "of the new breeding none has been tried";
    EXPECT_EQ(next().hint, "hint.take_champion");
    take_champion();
    at(0, Mode::paused), next();
    EXPECT_EQ(anchor(), "button.play");
    at(15.5);
    EXPECT_EQ(anchor(), "breeding.matrix");
}

TEST_F(BredPrompts, SayBeforeTheFirstBreedingThatItsOpponentsSeldomBringAChampion) {
    BredOnDesk bred(0, 2, "chase");
    at(16);
    EXPECT_EQ(next().hint, "hint.breed") << "none is open";
    show_breeding(bred);
    desk.view.features.breeding.shipped = &bred.shipped;
    desk.opened.offers.back() = "breeding:chase";
    EXPECT_EQ(next().hint, "hint.breed_shipped");
    EXPECT_EQ(anchor(), "breeding.start");
    desk.panels.sheet = Sheet::breeding;
    desk.frame(4);
    EXPECT_TRUE(desk.anchors.find("breeding.hint")) << "the sheet covers the bar";
    for (evolve::Breeding& each : bred.shipped) each.opponents = evolve::Opponents::generalist;
    EXPECT_EQ(next().hint, "hint.breed_others") << "others are chosen";
}

TEST_F(BredPrompts, LeadToOtherOpponentsAfterAChampionOfThoseOfTheFileHasFailed) {
    BredOnDesk bred(BredOnDesk(0).base->breeding().generations + 1, 2, "chase");
    show_breeding(bred);
    desk.view.features.breeding.shipped = &bred.shipped;
    desk.opened.offers.back() = "breeding:chase";
    desk.lesson.attempt.answers.hints_shown = 1;
    at(16);
    EXPECT_NE(anchor(), "breeding.against.random") << "the first champion is tried before";
    take_champion();
    at(0, Mode::paused), next();
    at(16);
    EXPECT_EQ(anchor(), "breeding.against.random");
    EXPECT_EQ(next().hint, "hint.breed_against");
    for (evolve::Breeding& each : bred.shipped) each.opponents = evolve::Opponents::generalist;
    EXPECT_NE(anchor(), "breeding.against.random") << "others are chosen";
    at(0, Mode::paused);
    EXPECT_NE(anchor(), "button.play") << "it has failed from here";
}

TEST_F(LessonPrompts, PointToTheSolutionWhenNoHintIsLeftAndEachControlHasHadARun) {
    desk.opened.offers = {"LL", "RR"};
    desk.opened.seconds = 15;
    at(0, Mode::paused), next();
    Attempt& attempt = desk.lesson.attempt;
    attempt.answers.hints_shown = static_cast<int>(desk.opened.hints.size());
    next();
    desk.view.undo_depth = 1;  // the hint is followed
    at(16);
    for (const int runs : {1, 2}) {
        attempt.work.runs = runs;
        EXPECT_NE(anchor(), "exercise.show_me") << runs;
    }
    attempt.work.runs = 3;
    EXPECT_EQ(anchor(), "exercise.show_me");
    EXPECT_EQ(next().hint, "hint.show_me");
    attempt.answers.hint_ready = false;
    EXPECT_NE(anchor(), "exercise.show_me") << "not yet";
}

TEST_F(LessonPrompts, PointToResetAfterAFailedRunInWhichTheBrainWasChanged) {
    desk.opened.seconds = 40;
    at(0, Mode::paused), next();
    auto changed = std::make_shared<BrainGraph>(*desk.now.brains[0]);
    changed->nodes.back().bias += 0.3f;
    desk.now.brains[0] = changed;
    at(21);
    EXPECT_EQ(anchor(), "exercise.hint") << "the run can still succeed";
    desk.lesson.verdicts[0].lost = true;
    EXPECT_EQ(anchor(), "button.reset");
    EXPECT_EQ(next().hint, "hint.changed_since");
    desk.lesson.verdicts[0].lost = false;
    at(41);
    EXPECT_EQ(anchor(), "button.reset") << "its time is over";
    at(0, Mode::paused), next();
    at(41);
    desk.view.undo_depth = 1;
    EXPECT_EQ(anchor(), "exercise.hint") << "the whole run has shown the change";
}

}  // namespace braitenlab::tests::prompts_test
