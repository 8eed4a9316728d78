// Copies of objects: within a scene and from one scene to another.
#include "ui/scene_input/clipboard.h"

#include <gtest/gtest.h>

#include "app/lab_requests.h"
#include "app/lab_selection.h"
#include "core/brain/four_neurons.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::clipboard_test {
namespace {

const Scene& scene_of(const Lab& lab) { return *lab.document.session.snapshot().scene; }

// The scene of the coward with a box, a zone and a second lamp, none of which is selected.
Lab furnished() {
    Lab lab = opened_lab("2a-coward");
    handle(lab, EditRequest{AddSource{{.name = "stove", .channel = Channel::heat, .x = 4, .y = 4, .strength = 0.5f}}});
    handle(lab, EditRequest{AddObstacle{{.name = "box", .x = 2, .y = 4, .heading = 0.5f}}});
    handle(lab, EditRequest{AddZone{{.name = "pond", .x = 4, .y = 2, .surface = Surface::ice}}});
    handle(lab, TakeRequest{});
    return lab;
}

const SceneObject stove{SceneObjectKind::source, 1}, box{SceneObjectKind::obstacle, 0}, pond{SceneObjectKind::zone, 0};

TEST(Clipboard, PastesCopiedObjectsAroundAPositionAsOneStepOfUndo) {
    Lab lab = furnished();
    const int depth = lab.document.session.undo_depth();
    const Scene before = scene_of(lab);
    handle(lab, SelectObjectsRequest{{stove, box, pond}});
    handle(lab, Action::copy);
    EXPECT_EQ(ui::object_count(lab.clipboard), 3u);
    handle(lab, PasteRequest{maths::vec2{-4, -4}});
    ASSERT_EQ(scene_of(lab).sources.size(), before.sources.size() + 1);
    EXPECT_EQ(scene_of(lab).sources.back().channel, Channel::heat);
    EXPECT_NEAR(scene_of(lab).sources.back().x, -3, 1e-4f) << "the middle of the three is at (3, 3)";
    EXPECT_NEAR(scene_of(lab).obstacles.back().x, -5, 1e-4f);
    EXPECT_EQ(scene_of(lab).obstacles.back().heading, 0.5f);
    EXPECT_NEAR(scene_of(lab).zones.back().y, -5, 1e-4f);
    EXPECT_EQ(selected_objects(lab.view.selection).size(), 3u) << "what was pasted is selected";
    EXPECT_EQ(lab.document.session.undo_depth(), depth + 1);
    handle(lab, Action::undo);
    EXPECT_EQ(scene_of(lab), before);
    handle(lab, Action::redo);
    EXPECT_EQ(scene_of(lab).zones.size(), 2u);
}

TEST(Clipboard, CutsAndErasesAllSelectedObjectsAsOneStepOfUndo) {
    for (const Action action : {Action::cut, Action::erase}) {
        Lab lab = furnished();
        const Scene before = scene_of(lab);
        const int depth = lab.document.session.undo_depth();
        handle(lab, SelectObjectsRequest{{stove, box, pond, vehicle_object(0)}});
        handle(lab, action);
        EXPECT_EQ(scene_of(lab).sources.size(), 1u);
        EXPECT_TRUE(scene_of(lab).obstacles.empty());
        EXPECT_TRUE(scene_of(lab).zones.empty());
        EXPECT_TRUE(lab.document.session.snapshot().vehicles.empty());
        EXPECT_EQ(ui::object_count(lab.clipboard), action == Action::cut ? 4u : 0u);
        EXPECT_EQ(lab.document.session.undo_depth(), depth + 1);
        handle(lab, Action::undo);
        EXPECT_EQ(scene_of(lab), before);
        EXPECT_EQ(lab.document.session.snapshot().vehicles.size(), 1u);
    }
}

TEST(Clipboard, DuplicatesSeveralObjectsBesideThem) {
    Lab lab = furnished();
    handle(lab, SelectObjectsRequest{{box, pond}});
    handle(lab, Action::duplicate);
    ASSERT_EQ(scene_of(lab).zones.size(), 2u);
    EXPECT_NEAR(scene_of(lab).zones[1].x - scene_of(lab).zones[0].x, 0.8f, 1e-4f);
    EXPECT_EQ(scene_of(lab).obstacles.size(), 2u);
    EXPECT_EQ(ui::object_count(lab.clipboard), 0u) << "the clipboard is unchanged";
}

TEST(Clipboard, BringsBrainAndDriverOfAVehicleToAnotherSceneWithItsKind) {
    Lab lab = opened_lab("2a-coward");
    const BrainGraph own = make_graph({.LR = 0.7f, .LM = 0.2f});
    handle(lab, EditRequest{SetBrain{{.vehicle = 0}, own}});
    handle(lab, EditRequest{ChooseDriver{0, Driver::wander}});
    handle(lab, Action::copy);
    Lab other = opened_lab("2a-coward");
    replace_document(lab, std::move(other.document));
    EXPECT_EQ(ui::object_count(lab.clipboard), 1u) << "it survives the change of the scene";
    handle(lab, PasteRequest{maths::vec2{3, -4}});
    const Snapshot& now = lab.document.session.snapshot();
    ASSERT_EQ(now.vehicles.size(), 2u);
    EXPECT_EQ(*brain_of(now, now.vehicles[1]), own);
    EXPECT_EQ(now.vehicles[1].driver, Driver::wander);
    EXPECT_NEAR(now.vehicles[1].x, 3, 1e-4f);
    EXPECT_EQ(lab.view.selection.vehicle, now.vehicles[1].id);
}

TEST(Clipboard, AddsTheKindOfAVehicleToASceneWithoutItAsOneStepOfUndo) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, SelectObjectsRequest{{vehicle_object(0), {SceneObjectKind::source, 0}}});
    handle(lab, Action::copy);
    const Kind coward = scene_of(lab).kinds[0];
    Lab other = opened_lab("predator-prey");
    replace_document(lab, std::move(other.document));
    const Scene before = scene_of(lab);
    handle(lab, PasteRequest{});
    handle(lab, PasteRequest{});
    ASSERT_EQ(scene_of(lab).kinds.size(), before.kinds.size() + 1) << "the second copy finds the kind";
    EXPECT_EQ(scene_of(lab).kinds.back().name, "coward");
    EXPECT_EQ(scene_of(lab).kinds.back().sensors, coward.sensors);
    const Snapshot& now = lab.document.session.snapshot();
    EXPECT_EQ(now.vehicles.back().kind, static_cast<int>(before.kinds.size()));
    EXPECT_EQ(*brain_of(now, now.vehicles.back()), coward.brain);
    EXPECT_EQ(now.vehicles.size(), 22u);
    handle(lab, Action::undo);
    handle(lab, Action::undo);
    EXPECT_EQ(scene_of(lab), before);
    EXPECT_EQ(lab.document.session.snapshot().vehicles.size(), 20u);
}

TEST(Clipboard, AddsAKindOfAnotherNameWhereTheDesignDiffers) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::copy);
    Kind larger = scene_of(lab).kinds[0];
    larger.body.mass = 20;
    handle(lab, EditRequest{EditKind{0, larger}});
    handle(lab, PasteRequest{maths::vec2{3, -4}});
    ASSERT_EQ(scene_of(lab).kinds.size(), 2u);
    EXPECT_NE(scene_of(lab).kinds[1].name, scene_of(lab).kinds[0].name);
    EXPECT_EQ(lab.document.session.snapshot().vehicles.back().kind, 1);
}

TEST(Clipboard, AddsAKindOfAnotherNameOnceForSeveralPastes) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::copy);
    Kind larger = scene_of(lab).kinds[0];
    larger.body.mass = 20;
    handle(lab, EditRequest{EditKind{0, larger}});
    for (int i = 0; i < 3; ++i) handle(lab, PasteRequest{maths::vec2{3, -4}});
    EXPECT_EQ(scene_of(lab).kinds.size(), 2u);
    const Snapshot& now = lab.document.session.snapshot();
    ASSERT_EQ(now.vehicles.size(), 4u);
    EXPECT_EQ(now.vehicles[3].kind, 1);
    EXPECT_EQ(kind_of(now, now.vehicles[3]).body.mass, scene_of(lab).kinds[1].body.mass);
    EXPECT_NE(kind_of(now, now.vehicles[3]).body.mass, 20);
}

TEST(Clipboard, GivesPastedVehiclesFreePositions) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, Action::copy);
    for (int i = 0; i < 3; ++i) handle(lab, PasteRequest{maths::vec2{3, -4}});
    const auto& vehicles = lab.document.session.snapshot().vehicles;
    ASSERT_EQ(vehicles.size(), 4u);
    for (std::size_t i = 1; i < 4; ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_GT(std::hypot(vehicles[i].x - vehicles[k].x, vehicles[i].y - vehicles[k].y), 1) << i << " " << k;
}

TEST(LabSelection, SelectsAllObjectsAndKeepsThemWhenIndicesChange) {
    Lab lab = furnished();
    handle(lab, Action::select_all);
    EXPECT_EQ(selected_objects(lab.view.selection).size(), 5u);
    handle(lab, SelectObjectsRequest{{pond, stove}});
    EXPECT_EQ(lab.view.selection.object, pond);
    handle(lab, EditRequest{RemoveSource{0}});
    ASSERT_EQ(lab.view.selection.more.size(), 1u);
    EXPECT_EQ(lab.view.selection.more[0], (SceneObject{SceneObjectKind::source, 0})) << "the stove";
    handle(lab, EditRequest{RemoveSource{0}});
    EXPECT_TRUE(lab.view.selection.more.empty());
    handle(lab, SelectRequest{0});
    EXPECT_EQ(selected_objects(lab.view.selection), std::vector{vehicle_object(0)});
}

TEST(LabSelection, StepsThroughLampsObstaclesAndZones) {
    Lab lab = furnished();
    const VehicleId vehicle = lab.view.selection.vehicle;
    std::vector<SceneObject> seen;
    for (int i = 0; i < 5; ++i) handle(lab, Action::next_object), seen.push_back(lab.view.selection.object);
    const SceneObject lamp{SceneObjectKind::source, 0};
    EXPECT_EQ(seen, (std::vector{lamp, stove, box, pond, lamp}));
    handle(lab, Action::previous_object);
    EXPECT_EQ(lab.view.selection.object, pond);
    EXPECT_EQ(lab.view.selection.vehicle, vehicle) << "its brain is still shown";
}

}  // namespace
}  // namespace braitenlab::tests::clipboard_test
