// Slots A and B in the lab: storing, exchanging, undo, and both runs from the same start.
#include "app/features/slots.h"

#include <cmath>

#include <gtest/gtest.h>

#include "app/files/file_commands.h"
#include "app/lab_requests.h"
#include "app/lab_selection.h"
#include "app/playback.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::slots_test {
namespace {

struct SlotsTest : testing::Test {
    Lab lab = opened_lab("2b-aggressor");
    Jobs jobs{0};

    const VehicleView& vehicle() const {
        return *find_vehicle(lab.document.session.snapshot(), lab.view.selection.vehicle);
    }
    Target target() const { return target_of(view_of(lab), vehicle()); }
    const BrainGraph& brain() const { return *brain_of(lab.document.session.snapshot(), vehicle()); }
    void turn(Dial dial, float value) { handle(lab, EditRequest{TurnDial{target(), dial, value}}); }
    // A: as shipped, B: a coward.
    void store_both() {
        handle(lab, Action::slot);
        for (const Dial dial : {Dial::LR, Dial::RL}) turn(dial, 0);
        for (const Dial dial : {Dial::LL, Dial::RR}) turn(dial, 1.5f);
        handle(lab, Action::slot);
    }
    void run(int ticks) {
        for (int i = 0; i < ticks; ++i) tick(lab);
    }
    void compute() {
        update_slots(lab.slots, lab, jobs);
        jobs.finish();
        update_slots(lab.slots, lab, jobs);
    }
    Pose place() const { return {vehicle().x, vehicle().y, vehicle().heading}; }
    SlotsView shown() const { return view_of(lab).features.slots; }
};

TEST_F(SlotsTest, OneKeyFillsAThenBThenExchanges) {
    const BrainGraph shipped = brain();
    store_both();
    const BrainGraph other = brain();
    ASSERT_TRUE(shown().slots[0].design && shown().slots[1].design);
    EXPECT_EQ(shown().slots[0].character, Character::aggressor);
    EXPECT_EQ(shown().slots[1].character, Character::coward);
    EXPECT_TRUE(shown().slots[1].is_in_vehicle);
    handle(lab, Action::slot);
    EXPECT_TRUE(same_wiring(brain(), shipped)) << "A is in the vehicle";
    handle(lab, Action::slot);
    EXPECT_TRUE(same_wiring(brain(), other));
    turn(Dial::LM, 0.7f);
    handle(lab, Action::slot);
    EXPECT_TRUE(shown().slots[1].is_in_vehicle) << "an edited brain is stored where the last one came from";
    EXPECT_FALSE(shown().slots[0].is_in_vehicle);
}

TEST_F(SlotsTest, AComparisonHasNoForecast) {
    store_both();
    const auto try_out = [&] {
        lab.predictions.what_if = {TurnDial{target(), Dial::LM, 0.4f}};
        for (int i = 0; i < 4; ++i) update_predictions(lab.predictions, lab, jobs), jobs.finish();
        return prediction_of(lab.predictions, lab).has_value();
    };
    ASSERT_TRUE(try_out());
    EXPECT_TRUE(view_of(lab).features.prediction);
    handle(lab, Action::compare);
    compute();
    ASSERT_TRUE(try_out());
    ASSERT_TRUE(shown().b);
    EXPECT_FALSE(view_of(lab).features.prediction);
}

TEST_F(SlotsTest, TheSameBrainIsNotStoredTwice) {
    handle(lab, Action::slot);
    handle(lab, Action::slot);
    EXPECT_FALSE(shown().slots[1].design);
    EXPECT_EQ(lab.notice.key, "notice.slot_same");
}

TEST_F(SlotsTest, PuttingABrainWithItsSensorsIsOneStepOfUndo) {
    handle(lab, Action::slot);
    auto sensors = kind_of(lab.document.session.snapshot(), vehicle()).sensors;
    const std::vector<Sensor> shipped = sensors;
    sensors[0].range = 5;
    handle(lab, EditRequest{SetSensors{target(), sensors}});
    turn(Dial::LL, 1);
    const BrainGraph edited = brain();
    const int depth = lab.document.session.undo_depth();
    handle(lab, SlotRequest{0, false});
    EXPECT_EQ(kind_of(lab.document.session.snapshot(), vehicle()).sensors, shipped);
    EXPECT_EQ(lab.document.session.undo_depth(), depth + 1);
    handle(lab, Action::undo);
    EXPECT_EQ(kind_of(lab.document.session.snapshot(), vehicle()).sensors, sensors);
    EXPECT_TRUE(same_wiring(brain(), edited));
}

TEST_F(SlotsTest, ComparingDrivesAWithBBesideItInTime) {
    store_both();
    run(50);
    handle(lab, Action::compare);
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    EXPECT_EQ(lab.playback.mode, Mode::playing);
    EXPECT_TRUE(shown().slots[0].is_in_vehicle);
    EXPECT_TRUE(shown().is_computing);
    compute();
    ASSERT_TRUE(shown().a && shown().b);
    EXPECT_FALSE(view_of(lab).features.last_run) << "B is the ghost";
    run(200);
    ASSERT_TRUE(shown().a && shown().b);
    EXPECT_EQ((*shown().a->path)[200], place()) << "the run is that of A, bit for bit";
    EXPECT_EQ(shown().a->count, 201u);
    EXPECT_NE(shown().b->pose, shown().a->pose);
    EXPECT_TRUE(shown().slots[0].numbers && shown().slots[1].numbers);
    handle(lab, SeekRequest{20});
    EXPECT_EQ(shown().b->count, 21u);
    turn(Dial::LM, 0.9f);
    EXPECT_FALSE(shown().b) << "the vehicle does not drive as A any more";
    EXPECT_TRUE(shown().slots[0].numbers) << "the table stays";
}

TEST_F(SlotsTest, ComparingLeavesNothingToBeSaved) {
    handle(lab, Action::slot);
    replace_document(lab, opened_lab("2a-coward").document);
    handle(lab, Action::slot);
    handle(lab, Action::compare);
    EXPECT_FALSE(has_unsaved_edits(lab)) << "A is still in its slot";
    turn(Dial::LM, 0.9f);
    EXPECT_TRUE(has_unsaved_edits(lab));
    handle(lab, Action::compare);
    EXPECT_TRUE(has_unsaved_edits(lab)) << "the edit before is of the person";
}

TEST_F(SlotsTest, EscapeAfterAComparisonGivesTheVehicleItsBrainBack) {
    handle(lab, Action::slot);
    replace_document(lab, opened_lab("2a-coward").document);
    handle(lab, Action::lecture);
    handle(lab, Action::slot);
    const BrainGraph own = brain();
    handle(lab, Action::compare);
    ASSERT_FALSE(same_wiring(brain(), own));
    compute();
    run(60);
    handle(lab, Action::cancel);
    EXPECT_TRUE(same_wiring(brain(), own));
    EXPECT_FALSE(shown().b) << "the comparison has ended";
    EXPECT_TRUE(shown().slots[1].is_in_vehicle);
    EXPECT_FALSE(has_unsaved_edits(lab));
    handle(lab, Action::compare);
    turn(Dial::LM, 0.9f);
    const BrainGraph edited = brain();
    handle(lab, Action::cancel);
    EXPECT_TRUE(same_wiring(brain(), edited)) << "an edit since then stays";
}

TEST_F(SlotsTest, InALectureTheRunPausesAtTheEndOfTheComparison) {
    for (const bool lecture : {false, true}) {
        lab = opened_lab("2b-aggressor");
        if (lecture) handle(lab, Action::lecture);
        store_both();
        lab.playback.time_scale = 16;
        handle(lab, Action::compare);
        compute();
        const auto end = static_cast<std::uint64_t>(std::lround(shown().seconds * 60));
        const auto now = [&] { return lab.document.session.snapshot().tick; };
        for (int frame = 0; frame < 1000 && lab.playback.mode == Mode::playing && now() < end + 20; ++frame)
            advance(lab, 0.02);
        EXPECT_EQ(lab.playback.mode, lecture ? Mode::paused : Mode::playing);
        EXPECT_EQ(lab.document.session.snapshot().tick == end, lecture);
        EXPECT_EQ(lab.notice.key == "notice.comparison_pauses", lecture);
        EXPECT_EQ(shown().a && shown().b, lecture) << "both are still in the picture";
        if (!lecture) continue;
        set_mode(lab, Mode::playing);
        for (int frame = 0; frame < 10; ++frame) advance(lab, 0.02);
        EXPECT_EQ(lab.playback.mode, Mode::playing) << "it goes on";
    }
}

TEST_F(SlotsTest, TheGhostDrivesAsTheVehicleDoesWithB) {
    store_both();
    handle(lab, Action::compare);
    compute();
    const ReferencePath of_b = *shown().b->path;
    handle(lab, Action::reset);
    handle(lab, SlotRequest{1, false});
    run(300);
    EXPECT_EQ(of_b[300], place());
}

TEST_F(SlotsTest, AreEmptiedAndTheVehicleKeepsItsBrain) {
    store_both();
    const auto brain = *brain_of(lab.document.session.snapshot(), *selected_vehicle(lab));
    handle(lab, Action::compare);
    compute();
    handle(lab, EmptySlotsRequest{});
    EXPECT_FALSE(shown().has_any());
    EXPECT_FALSE(shown().b);
    handle(lab, SlotRequest{0, true});
    EXPECT_TRUE(shown().slots[0].design);
    EXPECT_FALSE(shown().slots[1].design);
    EXPECT_EQ(brain.wires.size(), brain_of(lab.document.session.snapshot(), *selected_vehicle(lab))->wires.size());
}

TEST_F(SlotsTest, AnotherSlotOrDocumentEndsTheComparison) {
    store_both();
    handle(lab, Action::compare);
    compute();
    EXPECT_GT(shown().seconds, 0);
    handle(lab, SlotRequest{0, true});
    EXPECT_EQ(shown().seconds, 0);
    handle(lab, Action::compare);
    replace_document(lab, opened_lab("2a-coward").document);
    compute();
    EXPECT_EQ(shown().seconds, 0);
    EXPECT_TRUE(shown().slots[0].design && shown().slots[1].design) << "the brains stay";
}

TEST_F(SlotsTest, NothingIsComparedWithOneBrain) {
    handle(lab, Action::slot);
    run(10);
    handle(lab, Action::compare);
    EXPECT_EQ(lab.notice.key, "unavailable.slots_empty");
    EXPECT_EQ(lab.document.session.snapshot().tick, 10u);
}

TEST_F(SlotsTest, AHiddenBrainCannotBeStoredAndAnOpenPredictionNotCompared) {
    replace_document(lab, opened_lab("19-mystery").document);
    const Snapshot& now = lab.document.session.snapshot();
    for (const VehicleView& each : now.vehicles) {
        if (!is_brain_secret(view_of(lab), each.kind)) continue;
        handle(lab, SelectRequest{each.id});
        handle(lab, Action::slot);
        EXPECT_FALSE(shown().slots[0].design);
        EXPECT_EQ(lab.notice.key, "unavailable.why");
    }
    replace_document(lab, opened_lab("05-aggressor").document);
    handle(lab, Action::slot);
    turn(Dial::LR, 1);
    handle(lab, Action::slot);
    handle(lab, Action::compare);
    EXPECT_EQ(lab.notice.key, "unavailable.before_answer");
}

}  // namespace
}  // namespace braitenlab::tests::slots_test
