// What the notices of undo and redo say.
#include "app/what_changed.h"

#include "app/lab_requests.h"
#include "core/lesson/submission.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::what_changed_test {

namespace {

// The notice of the undo of these commands, which are one step.
Notice notice_of_undo(Lab& lab, std::initializer_list<Command> commands) {
    const std::uint64_t gesture = new_gesture(lab);
    for (const Command& command : commands) handle(lab, EditRequest{command, gesture});
    lab.notice = {};
    handle(lab, Action::undo);
    return lab.notice;
}

}  // namespace

TEST(WhatChanged, AnUndoSaysWhatItTakesBack) {
    Lab lab = opened_lab("22-breeding");
    const Submission champion = lab.document.lesson->exercise->solution.submission;
    const Target prey{.kind = 0};
    const auto said = [&](std::initializer_list<Command> commands) { return notice_of_undo(lab, commands).words; };
    EXPECT_EQ(said({TurnDial{prey, Dial::LL, 1}}), "LL");
    EXPECT_EQ(said({TurnDial{prey, Dial::LL, 1}, TurnDial{prey, Dial::RM, 1}}), "LL, RM");
    EXPECT_EQ(said({SetSensors{prey, champion.sensors}}), "changed.sensors");
    EXPECT_EQ(said({SetSensors{prey, champion.sensors}, SetBrain{prey, champion.brain}}), "changed.brain_and_sensors");
    BrainGraph wired = lab.document.lesson->exercise->scene.kinds[0].brain;
    wired.wires.pop_back();
    EXPECT_EQ(said({SetBrain{prey, wired}}), "changed.brain");
    EXPECT_EQ(said({MoveVehicle{0, 1, 2, 0}}), "changed.vehicles");
    EXPECT_EQ(said({RemoveObstacle{0}}), "changed.obstacles");
    EXPECT_EQ(said({AddZone{Zone{}}}), "changed.zones");
    EXPECT_EQ(said({AddSource{Source{}}}), "changed.lamps");
    EXPECT_EQ(said({AddVehicle{}}), "changed.vehicles");
    EXPECT_EQ(said({AddSource{Source{}}, AddVehicle{}}), "changed.vehicles_and_lamps");
    Arena arena = lab.document.session.snapshot().scene->arena;
    arena.grip = 0.5f;
    EXPECT_EQ(said({EditArena{arena}}), "changed.values");
    EXPECT_EQ(said({Retitle{.title = "Another"}}), "changed.other");
}

TEST(WhatChanged, OfADiagramSaysWhetherItWasTidied) {
    Lab lab = opened_lab("22-breeding");
    const Target prey{.kind = 0};
    const BrainGraph& brain = lab.document.lesson->exercise->scene.kinds[0].brain;
    const PlaceNodes moved{prey, {{brain.nodes[0].id, maths::vec2{40, 60}}}}, tidied{prey, {{brain.nodes[0].id, {}}}};
    EXPECT_EQ(notice_of_undo(lab, {moved}).words, "changed.places");
    handle(lab, Action::redo);
    EXPECT_EQ(lab.notice.words, "changed.places");
    EXPECT_EQ(notice_of_undo(lab, {tidied}).words, "wiring.arrange");
    handle(lab, Action::redo);
    EXPECT_EQ(lab.notice.words, "wiring.arrange");
}

TEST(WhatChanged, ARedoSaysItToo) {
    Lab lab = opened_lab("22-breeding");
    EXPECT_EQ(notice_of_undo(lab, {TurnDial{{.kind = 0}, Dial::LL, 1}}).key, "notice.undone");
    handle(lab, Action::redo);
    EXPECT_EQ(lab.notice.key, "notice.redone");
    EXPECT_EQ(lab.notice.words, "LL");
    lab.notice = {};
    handle(lab, Action::redo);
    EXPECT_TRUE(lab.notice.empty()) << "there is nothing to redo";
}

}  // namespace braitenlab::tests::what_changed_test
