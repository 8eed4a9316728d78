#include "ui/panels/offered.h"

#include <cmath>
#include <set>

#include "desk.h"

namespace braitenlab::tests::offered_test {
namespace {

struct Offering : Desk {
    explicit Offering(std::vector<std::string> offers) : Desk(1280, 1000, 1, true) {
        opened.offers = std::move(offers);
        open_exercise();
        lesson.attempt.answers.prediction = 0;
        frame(3);
    }
    bool has(std::string_view anchor) const { return anchors.find(anchor) != nullptr; }
};

TEST(Offered, OnlyTheOfferedControlsAreShown) {
    const Offering desk({"LL", "LM"});
    for (const char* id : {"slider.LL", "bias.LM", "button.free_play"}) EXPECT_TRUE(desk.has(id)) << id;
    for (const char* id : {"slider.LR", "slider.RL", "slider.RR", "threshold.LL", "bias.RM", "button.mirror",
                           "button.cross", "button.presets", "button.drive", "card.sensors"})
        EXPECT_FALSE(desk.has(id)) << id;
}

TEST(Offered, TheLettersOfFewWeightsAreSaidInWords) {
    const Offering two({"LL", "RR"});
    EXPECT_TRUE(two.says("LL: left eye → left motor"));
    EXPECT_TRUE(two.says("RR: right eye → right motor"));
}

TEST(Offered, TheLettersOfAllWeightsAreInTheirTooltips) {
    const Offering four({"LL", "LR", "RL", "RR"});
    EXPECT_FALSE(four.says("left eye → left motor"));
}

TEST(Offered, ThresholdsAndSensorsAreShownWhereTheyAreOffered) {
    const Offering desk({"threshold_LL", "sensors"});
    EXPECT_TRUE(desk.has("threshold.LL"));
    EXPECT_TRUE(desk.has("card.sensors"));
    EXPECT_FALSE(desk.has("slider.LL"));
}

TEST(Offered, PeakAndWidthAreSlidersOfAllWires) {
    Offering desk({"curves"});
    BrainGraph brain = make_graph({.LR = 1, .RL = 1});
    for (Wire& wire : brain.wires) wire.curve = {Response::hump, 0.2f, 0.1f};
    desk.now.brains.assign(desk.now.brains.size(), std::make_shared<BrainGraph>(brain));
    desk.frame(2);
    desk.type_into("curve.peak", "0.4");
    const std::vector<EditRequest> edits = desk.edits();
    ASSERT_EQ(edits.size(), 1u);
    for (const Wire& wire : std::get<SetBrain>(edits[0].command).brain.wires) {
        EXPECT_EQ(wire.curve.peak, 0.4f);
        EXPECT_EQ(wire.curve.width, 0.1f);
    }
    EXPECT_TRUE(desk.has("curve.width"));
}

TEST(Offered, TheMouseMovesPeakAndWidthByHundredths) {
    Offering desk({"curves"});
    BrainGraph brain = make_graph({.LR = 1, .RL = 1});
    for (Wire& wire : brain.wires) wire.curve = {Response::hump, 0.5f, 0.1f};
    desk.now.brains.assign(desk.now.brains.size(), std::make_shared<BrainGraph>(brain));
    desk.frame(2);
    const Rect r = desk.where("curve.peak");
    desk.point(r.x + 0.6f * r.w, r.y + r.h / 2);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    std::set<long> hundredths;
    for (float x = r.x + 0.6f * r.w; x > r.x + 0.4f * r.w; x -= 1) {
        desk.point(x, r.y + r.h / 2);
        desk.frame();
        if (desk.edits().empty()) continue;
        const float peak = std::get<SetBrain>(desk.edits().back().command).brain.wires[0].curve.peak;
        EXPECT_NEAR(100 * peak, std::round(100 * peak), 1e-3f);
        hundredths.insert(std::lround(100 * peak));
    }
    ASSERT_GE(hundredths.size(), 10u);
    EXPECT_EQ(*hundredths.rbegin() - *hundredths.begin() + 1, static_cast<long>(hundredths.size()))
        << "none is skipped";
}

TEST(Offered, ARightClickRestoresThePeakOfTheFile) {
    Offering desk({"curves"});
    BrainGraph brain = make_graph({.LR = 1, .RL = 1});
    for (Wire& wire : brain.wires) wire.curve = {Response::hump, 0.2f, 0.1f};
    Scene file = *desk.now.scene;
    for (Kind& kind : file.kinds) kind.brain = brain;
    desk.view.file = &file;
    for (Wire& wire : brain.wires) wire.curve.peak = 0.6f;
    desk.now.brains.assign(desk.now.brains.size(), std::make_shared<BrainGraph>(brain));
    desk.frame(2);
    desk.click("curve.peak", 1);
    const std::vector<EditRequest> edits = desk.edits();
    ASSERT_EQ(edits.size(), 1u);
    EXPECT_EQ(std::get<SetBrain>(edits[0].command).brain.wires[0].curve.peak, 0.2f);
}

TEST(Offered, TheWiringIsOneClickAwayWhereItIsOffered) {
    Offering desk({"wiring"});
    desk.click("button.open_wiring");
    EXPECT_EQ(desk.actions(), std::vector<Action>{Action::wiring});
    desk.opened.offers = {"LL"};
    desk.frame(2);
    EXPECT_FALSE(desk.has("button.open_wiring"));
}

TEST(Offered, FreePlayShowsAllControls) {
    Offering desk({"LL", "LM"});
    desk.click("button.free_play");
    ASSERT_TRUE(desk.last<FreePlayRequest>());
    EXPECT_TRUE(desk.last<FreePlayRequest>()->on);
    desk.lesson.attempt.work.free_play = true;
    desk.frame(3);
    for (const char* id : {"slider.LR", "button.thresholds", "bias.RM", "button.presets", "card.sensors"})
        EXPECT_TRUE(desk.has(id)) << id;
    desk.click("button.free_play");
    EXPECT_FALSE(desk.last<FreePlayRequest>()->on);
}

TEST(Offered, AnExerciseWithoutOffersShowsAllControls) {
    const Offering desk({});
    for (const char* id : {"slider.LR", "button.thresholds", "bias.RM", "button.presets", "card.sensors"})
        EXPECT_TRUE(desk.has(id)) << id;
    EXPECT_FALSE(desk.has("button.free_play"));
}

TEST(Offered, DialsThatMoveTogetherAreOneSliderAndOneStepOfUndo) {
    Offering desk({"LL=RR", "LM=RM"});
    EXPECT_EQ(desk.where("slider.LL").y, desk.where("slider.RR").y);
    EXPECT_EQ(desk.where("bias.LM").x, desk.where("bias.RM").x);
    desk.type_into("slider.LL", "0.75");
    const std::vector<EditRequest> edits = desk.edits();
    ASSERT_EQ(edits.size(), 2u);
    EXPECT_EQ(turned(edits[0]).dial, Dial::LL);
    EXPECT_EQ(turned(edits[1]).dial, Dial::RR);
    for (const EditRequest& edit : edits) EXPECT_EQ(turned(edit).value, 0.75f);
    EXPECT_EQ(edits[0].gesture, edits[1].gesture);
}

}  // namespace
}  // namespace braitenlab::tests::offered_test
