// A hidden brain in the lab: nothing shows it, another is built in the same body, both are compared.
#include <gtest/gtest.h>

#include "app/features/mystery_runs.h"
#include "app/lab_requests.h"
#include "core/scene/scene_file.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::lab_mystery_test {
namespace {

struct LabMystery : testing::Test {
    Lab lab = opened_lab("2b-aggressor");
    Jobs jobs{0};

    const Snapshot& now() const { return lab.document.session.snapshot(); }
    const VehicleView& vehicle() const { return *find_vehicle(now(), lab.view.selection.vehicle); }
    void compute() {
        update_mystery(lab.mystery, lab, jobs);
        jobs.finish();
        update_mystery(lab.mystery, lab, jobs);
    }
};

TEST_F(LabMystery, NothingShowsAHiddenBrain) {
    const VehicleId hidden = vehicle().id;
    handle(lab, MysteryRequest{MysteryEdit::hide});
    const LabView view = view_of(lab);
    EXPECT_TRUE(is_brain_secret(view, vehicle().kind)) << "card, equations, canvas and lesions ask this";
    EXPECT_EQ(hidden_brains(view), std::vector{true}) << "deck";
    EXPECT_TRUE(hides_character(view, vehicle()));
    EXPECT_EQ(why_no_map(view), "unavailable.map_secret");
    EXPECT_EQ(why_no_slots(view), "unavailable.why");
    EXPECT_EQ(view.features.mystery.hidden, hidden);
    EXPECT_EQ(write_scene(lab.document.session.edited_scene()).find("brain"), std::string::npos);
    handle(lab, MysteryRequest{MysteryEdit::reveal});
    EXPECT_FALSE(is_brain_secret(view_of(lab), vehicle().kind));
    EXPECT_EQ(hidden_brains(view_of(lab)), std::vector<bool>{});
    handle(lab, Action::undo);
    EXPECT_TRUE(is_brain_secret(view_of(lab), vehicle().kind)) << "one step of undo";
}

TEST_F(LabMystery, AnotherVehicleHasTheSameBodyAndAnEmptyBrain) {
    handle(lab, MysteryRequest{MysteryEdit::hide});
    const Kind hidden = kind_of(now(), vehicle());
    handle(lab, MysteryRequest{MysteryEdit::rebuild});
    ASSERT_EQ(now().vehicles.size(), 2u);
    const Kind& rebuilt = kind_of(now(), vehicle());
    EXPECT_NE(rebuilt.name, hidden.name);
    EXPECT_FALSE(rebuilt.hidden);
    EXPECT_EQ(rebuilt.sensors, hidden.sensors);
    EXPECT_EQ(rebuilt.body, hidden.body);
    EXPECT_TRUE(brain_of(now(), vehicle())->wires.empty());
    EXPECT_EQ(view_of(lab).features.mystery.rebuilt, vehicle().id);
    handle(lab, Action::undo);
    EXPECT_EQ(now().vehicles.size(), 1u);
    EXPECT_EQ(now().scene->kinds.size(), 1u) << "one step of undo";
}

TEST_F(LabMystery, TheSameBrainScoresAllPointsAndAnEmptyOneFewer) {
    const BrainGraph hidden = *brain_of(now(), vehicle());
    handle(lab, MysteryRequest{MysteryEdit::hide});
    handle(lab, MysteryRequest{MysteryEdit::rebuild});
    handle(lab, MysteryRequest{MysteryEdit::score});
    EXPECT_TRUE(view_of(lab).features.mystery.is_computing);
    compute();
    ASSERT_TRUE(view_of(lab).features.mystery.score)
        << (lab.mystery.score.error() ? lab.mystery.score.error()->text() : "");
    EXPECT_LT(view_of(lab).features.mystery.score->score, 90);
    EXPECT_EQ(view_of(lab).features.mystery.score->starts.size(), 10u);
    handle(lab, EditRequest{SetBrain{{.vehicle = vehicle().id}, hidden}});
    handle(lab, MysteryRequest{MysteryEdit::score});
    EXPECT_FALSE(view_of(lab).features.mystery.score) << "the old one is gone";
    compute();
    ASSERT_TRUE(view_of(lab).features.mystery.score);
    EXPECT_EQ(view_of(lab).features.mystery.score->score, 100);
    replace_document(lab, opened_lab("2a-coward").document);
    compute();
    EXPECT_FALSE(view_of(lab).features.mystery.score);
}

}  // namespace
}  // namespace braitenlab::tests::lab_mystery_test
