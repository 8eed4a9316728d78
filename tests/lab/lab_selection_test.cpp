// The selection and driving by hand.
#include "app/lab_selection.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/lab_edits.h"
#include "app/lab_requests.h"
#include "app/lab_reset.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::lab_selection_test {
namespace {

TEST(LabSelection, DrivesTheVehicleWhileArrowKeysAreHeld) {
    Lab lab = opened_lab("2a-coward");
    EXPECT_FALSE(steer_by_keys(lab, 0, 1)) << "while its brain drives, the keys move the camera";
    handle(lab, Action::drive);
    const auto moved_in_a_second = [&] {
        for (int i = 0; i < 60; ++i) tick(lab);
        return lab.document.session.snapshot().vehicles[0].motor;
    };
    EXPECT_TRUE(steer_by_keys(lab, 0, 1));
    EXPECT_EQ(moved_in_a_second(), (std::array{1.0f, 1.0f}));
    steer_by_keys(lab, 1, 0);
    const auto turning = moved_in_a_second();
    EXPECT_GT(turning[0], 0) << "to the right";
    EXPECT_FLOAT_EQ(turning[1], -turning[0]);
    steer_by_keys(lab, 0, 0);
    EXPECT_EQ(moved_in_a_second(), (std::array{0.0f, 0.0f}));
    handle(lab, Action::drive);
    EXPECT_EQ(lab.document.session.snapshot().vehicles[0].driver, Driver::brain);
    EXPECT_NE(moved_in_a_second(), (std::array{0.0f, 0.0f})) << "the brain drives again";
}

TEST(LabSelection, StopsAVehicleThatIsNoLongerSelected) {
    Lab lab = opened_lab("predator-prey");
    handle(lab, Action::drive);
    steer_by_keys(lab, 0, 1);
    handle(lab, Action::next_vehicle);
    EXPECT_FALSE(steer_by_keys(lab, 0, 1));
    tick(lab);
    EXPECT_EQ(lab.document.session.snapshot().vehicles[0].motor, (std::array{0.0f, 0.0f}));
}

TEST(LabSelection, MovesToTheNextVehicleIfItsVehicleIsRemoved) {
    Lab lab = opened_lab("predator-prey");
    EXPECT_EQ(lab.view.selection.vehicle, 0);
    handle(lab, EditRequest{RemoveVehicle{0}});
    EXPECT_EQ(lab.view.selection.vehicle, 1);
    handle(lab, Action::previous_vehicle);
    EXPECT_EQ(lab.view.selection.vehicle, 19);
    handle(lab, Action::next_vehicle);
    EXPECT_EQ(lab.view.selection.vehicle, 1);
}

TEST(LabSelection, HasNoObjectTwiceAfterTheChosenVehicleIsRemoved) {
    Lab lab = opened_lab("predator-prey");
    handle(lab, SelectObjectsRequest{{vehicle_object(0), vehicle_object(1), vehicle_object(2)}});
    handle(lab, EditRequest{RemoveVehicle{0}});
    EXPECT_EQ(selected_objects(lab.view.selection), (std::vector{vehicle_object(1), vehicle_object(2)}));
}

TEST(LabSelection, HasNoObjectTwiceAfterTheChosenVehicleDies) {
    Lab lab = opened_lab("predator-prey");
    const VehicleView dead = lab.document.session.snapshot().vehicles[0];
    std::vector<SceneObject> all;
    for (const VehicleView& v : lab.document.session.snapshot().vehicles) all.push_back(vehicle_object(v.id));
    handle(lab, SelectObjectsRequest{all});
    ASSERT_FALSE(lab.document.session.apply(RemoveVehicle{0}));
    reselect_after_death(lab, dead);
    const std::vector<SceneObject> selected = selected_objects(lab.view.selection);
    EXPECT_EQ(selected.size(), 19u);
    EXPECT_EQ(std::count(selected.begin(), selected.end(), chosen_object(lab.view.selection)), 1);
}

TEST(LabSelection, SelectsWhatTheUserAddsAtAPosition) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, EditRequest{AddVehicle{0, Pose{1, 1, 0}}});
    EXPECT_EQ(lab.view.selection.vehicle, 1);
    handle(lab, Action::add);
    EXPECT_EQ(lab.view.selection.vehicle, 2) << "it is where there is room: selected, it is found";
    const auto sources = static_cast<int>(lab.document.session.snapshot().sources.size());
    handle(lab, EditRequest{AddSource{Source{.x = 2}}});
    EXPECT_EQ(lab.view.selection.object, (SceneObject{SceneObjectKind::source, sources}));
    EXPECT_EQ(lab.view.selection.vehicle, 2) << "its brain is still shown";
}

TEST(LabSelection, KeepsASourceWhenOthersAreRemoved) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, EditRequest{AddSource{Source{.name = "mine", .x = 2}}});
    const int index = lab.view.selection.object.index;
    ASSERT_GT(index, 0);
    handle(lab, EditRequest{RemoveSource{0}});
    EXPECT_EQ(lab.view.selection.object.index, index - 1);
    handle(lab, Action::erase);
    EXPECT_FALSE(lab.view.selection.object);
    EXPECT_EQ(find_source(*lab.document.session.snapshot().scene, "mine"), -1);
}

TEST(LabSelection, SelectsDuplicatesAndErasesAZone) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, EditRequest{AddZone{{.name = "pond", .x = 2, .length = 3, .surface = Surface::ice}}});
    EXPECT_EQ(lab.view.selection.object, (SceneObject{SceneObjectKind::zone, 0}));
    handle(lab, Action::duplicate);
    const std::vector<Zone>& zones = lab.document.session.snapshot().scene->zones;
    ASSERT_EQ(zones.size(), 2u);
    EXPECT_EQ(zones[1].surface, Surface::ice);
    EXPECT_NE(zones[1].x, 2);
    handle(lab, TakeRequest{{SceneObjectKind::zone, 1}});
    handle(lab, EditRequest{RemoveZone{0}});
    EXPECT_EQ(lab.view.selection.object, (SceneObject{SceneObjectKind::zone, 0})) << "its index has changed";
    handle(lab, Action::erase);
    EXPECT_TRUE(lab.document.session.snapshot().scene->zones.empty());
    EXPECT_FALSE(lab.view.selection.object);
    for (int i = 0; i < 4; ++i) handle(lab, Action::undo);
    EXPECT_TRUE(lab.document.session.snapshot().scene->zones.empty());
    EXPECT_EQ(lab.document.session.undo_depth(), 0);
}

TEST(LabSelection, IsErasedAndDuplicated) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, EditRequest{AddObstacle{Obstacle{.x = 2, .length = 3}}});
    handle(lab, Action::duplicate);
    ASSERT_EQ(lab.document.session.snapshot().scene->obstacles.size(), 2u);
    const Obstacle& copy = lab.document.session.snapshot().scene->obstacles[1];
    EXPECT_EQ(copy.length, 3);
    EXPECT_NE(copy.x, 2) << "beside it, not in it";
    EXPECT_EQ(lab.view.selection.object, (SceneObject{SceneObjectKind::obstacle, 1}));
    handle(lab, Action::erase);
    EXPECT_EQ(lab.document.session.snapshot().scene->obstacles.size(), 1u);
    EXPECT_EQ(lab.document.session.snapshot().vehicles.size(), 1u) << "the vehicle is not selected first";
    handle(lab, Action::duplicate);
    EXPECT_EQ(lab.document.session.snapshot().vehicles.size(), 2u);
    handle(lab, Action::wiring);
    handle(lab, Action::erase);
    EXPECT_EQ(lab.document.session.snapshot().vehicles.size(), 2u) << "Del belongs to the canvas in wiring mode";
}

TEST(LabSelection, CopiesTheBrainOfADuplicatedVehicle) {
    Lab lab = opened_lab("2a-coward");
    handle(lab, EditRequest{TurnDial{{.vehicle = 0}, Dial::LR, 1.25f}});
    handle(lab, Action::duplicate);
    const Snapshot& now = lab.document.session.snapshot();
    ASSERT_EQ(now.vehicles.size(), 2u);
    EXPECT_EQ(read_dials(*now.brains[static_cast<std::size_t>(now.vehicles[1].brain)]).LR, 1.25f);
}

TEST(LabSelection, MovesToTheNextOfTheKindIfItsVehicleDies) {
    Lab lab = opened_lab("predator-prey");
    const auto prey = [&] {
        for (const VehicleView& v : lab.document.session.snapshot().vehicles)
            if (v.role == Role::prey) return v.id;
        return no_vehicle;
    };
    handle(lab, SelectRequest{prey()});
    const VehicleId first = lab.view.selection.vehicle;
    for (int i = 0; i < 60 * 120 && lab.view.selection.vehicle == first; ++i) tick(lab);
    ASSERT_NE(lab.view.selection.vehicle, first) << "it survives two minutes";
    EXPECT_EQ(find_vehicle(lab.document.session.snapshot(), lab.view.selection.vehicle)->role, Role::prey);
    EXPECT_TRUE(lab.notice.key == "notice.eaten_prey" || lab.notice.key == "notice.starved_prey") << lab.notice.key;
    EXPECT_EQ(lab.notice.words, std::to_string(first + 1));
    EXPECT_EQ(lab.notice.more, std::to_string(lab.view.selection.vehicle + 1));
    EXPECT_EQ(lab.notice.kind, NoticeKind::notice);
}

TEST(LabSelection, ARunThatBeginsAnewSelectsAVehicleAfterADeathButNotAgainstTheUser) {
    Lab lab = opened_lab("18-prey");
    const VehicleId prey = lab.view.selection.vehicle;
    for (int i = 0; i < 60 * 30 && lab.view.selection.vehicle == prey; ++i) tick(lab);
    ASSERT_EQ(lab.view.selection.vehicle, no_vehicle) << "no other prey";
    tick(lab);
    EXPECT_EQ(lab.view.selection.vehicle, no_vehicle);
    handle(lab, Action::reset);
    ASSERT_TRUE(selected_vehicle(lab));
    EXPECT_EQ(selected_vehicle(lab)->role, Role::prey);
    select_none(lab);
    tick(lab);
    handle(lab, Action::reset);
    EXPECT_FALSE(selected_vehicle(lab)) << "the user has selected none";
}

TEST(LabSelection, TabPassesOverVehiclesWhoseBrainAnExerciseHides) {
    Lab lab = opened_lab("19-mystery");
    const VehicleId own = lab.view.selection.vehicle, hidden = 1 - own;
    handle(lab, Action::next_vehicle);
    EXPECT_EQ(lab.view.selection.vehicle, own);
    handle(lab, SelectRequest{hidden});
    ASSERT_EQ(lab.view.selection.vehicle, hidden) << "a click selects it";
    handle(lab, Action::previous_vehicle);
    EXPECT_EQ(lab.view.selection.vehicle, own);
}

TEST(LabSelection, SaysThatTheSelectedVehicleFellOverTheEdge) {
    Lab lab = opened_lab("20-selection");
    const auto falls = [&] { return lab.document.session.snapshot().events.falls; };
    while (falls() == 0 && lab.document.session.snapshot().seconds < 20) {
        EXPECT_NE(lab.notice.key, "notice.fell");
        tick(lab);
    }
    ASSERT_EQ(falls(), 1);
    EXPECT_EQ(lab.notice.key, "notice.fell");
    EXPECT_EQ(lab.notice.words, "1");
    reset(lab);
    EXPECT_NE(lab.notice.key, "notice.fell") << "the run is at another tick";
}

std::vector<VehicleId> all_of(const Lab& lab, Role role) {
    std::vector<VehicleId> ids;
    for (const VehicleView& v : lab.document.session.snapshot().vehicles)
        if (v.role == role) ids.push_back(v.id);
    return ids;
}

// A lab whose selected vehicle is prey, in a run that has begun: none dies before its first tick.
struct LabWithDyingPrey {
    Lab lab = opened_lab("predator-prey");
    VehicleView dead;
    LabWithDyingPrey() {
        tick(lab);
        handle(lab, SelectRequest{all_of(lab, Role::prey).front()});
        dead = *selected_vehicle(lab);
    }
    void die() {
        EXPECT_FALSE(lab.document.session.apply(RemoveVehicle{dead.id}));  // as a death: the lab does not request it
        reselect_after_death(lab, dead);
        keep_selection(lab);
    }
};

TEST(LabSelection, MovesToTheNearestOfTheKind) {
    LabWithDyingPrey given;
    Lab& lab = given.lab;
    const VehicleId last = all_of(lab, Role::prey).back(), predator = all_of(lab, Role::predator).front();
    EXPECT_TRUE(apply(lab, MoveVehicle{last, given.dead.x, given.dead.y + 1, 0}));
    EXPECT_TRUE(apply(lab, MoveVehicle{predator, given.dead.x, given.dead.y - 0.6f, 0})) << "nearer, of another kind";
    given.die();
    EXPECT_EQ(lab.view.selection.vehicle, last);
    EXPECT_EQ(lab.notice.more, std::to_string(last + 1));
}

TEST(LabSelection, SelectsNoVehicleIfItsVehicleDiesDuringADrag) {
    LabWithDyingPrey given;
    Lab& lab = given.lab;
    lab.dragging = true;
    given.die();
    EXPECT_EQ(lab.view.selection.vehicle, no_vehicle);
    EXPECT_TRUE(lab.notice.key.ends_with("_prey_alone")) << lab.notice.key;
    lab.dragging = false;
    tick(lab);
    EXPECT_EQ(lab.view.selection.vehicle, no_vehicle) << "nothing is selected by force";
    const VehicleId first = lab.document.session.snapshot().vehicles[0].id;
    handle(lab, SelectRequest{first});
    EXPECT_EQ(lab.view.selection.vehicle, first);
    handle(lab, EditRequest{RemoveVehicle{first}});
    EXPECT_EQ(lab.view.selection.vehicle, lab.document.session.snapshot().vehicles[0].id)
        << "after a removal as before";
}

TEST(LabSelection, ARunThatBeginsAnewSelectsTheKindOfAVehicleThatItDoesNotHave) {
    for (const Role role : {Role::predator, Role::prey}) {
        Lab lab = opened_lab("predator-prey");
        const auto first = all_of(lab, role).front();
        const int kind = find_vehicle(lab.document.session.snapshot(), first)->kind;
        EXPECT_TRUE(apply(lab, AddVehicle{kind, Pose{1, 1, 0}}));
        tick(lab);
        const VehicleId born = lab.document.session.snapshot().vehicles.back().id;
        handle(lab, SelectRequest{born});
        handle(lab, Action::undo);
        ASSERT_FALSE(find_vehicle(lab.document.session.snapshot(), born));
        ASSERT_TRUE(selected_vehicle(lab));
        EXPECT_EQ(selected_vehicle(lab)->role, role) << "an edit would change the other kind";
        handle(lab, Action::reset);
        EXPECT_EQ(selected_vehicle(lab)->role, role);
    }
}

TEST(LabSelection, SelectsNoVehicleOfAnotherRole) {
    LabWithDyingPrey given;
    Lab& lab = given.lab;
    for (const VehicleId id : all_of(lab, Role::prey))
        if (id != given.dead.id) apply(lab, RemoveVehicle{id});
    given.die();
    EXPECT_FALSE(lab.document.session.snapshot().vehicles.empty());
    EXPECT_EQ(lab.view.selection.vehicle, no_vehicle);
    EXPECT_TRUE(lab.notice.key.ends_with("_prey_alone")) << lab.notice.key;
}

}  // namespace
}  // namespace braitenlab::tests::lab_selection_test
