// The map of behaviour in the lab: computed in the background, kept while the dot is dragged, begun anew otherwise.
#include "app/features/behaviour_map.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/lab_requests.h"
#include "app/playback.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::behaviour_map_test {
namespace {

using insight::Behaviour;
using insight::MapPlace;

struct LabMap : testing::Test {
    Jobs jobs{0};
    Lab lab = opened_lab("2b-aggressor");

    void turn() { update_map(lab.map, lab, jobs), jobs.finish(), update_map(lab.map, lab, jobs); }
    void finish() {
        for (int i = 0; i < 40 && (!shown() || shown()->progress < 1); ++i) turn();
    }
    std::optional<MapView> shown() const { return view_of(lab).features.map; }
    std::size_t known() const {
        return static_cast<std::size_t>(std::count_if(lab.map.cells.cells.begin(), lab.map.cells.cells.end(),
                                                      [](const auto& cell) { return cell.has_value(); }));
    }
    void set(Dial dial, float value, std::uint64_t gesture = 7) {
        handle(lab, EditRequest{TurnDial{{no_vehicle, 0}, dial, value}, gesture});
    }
};

TEST_F(LabMap, IsShownFromCoarseToFineWhileItIsWanted) {
    turn();
    EXPECT_FALSE(shown());
    handle(lab, Action::map);
    update_map(lab.map, lab, jobs);
    ASSERT_TRUE(shown());
    EXPECT_EQ(shown()->progress, 0);
    turn();
    EXPECT_GE(known(), 16u);
    for (int x = 0; x < 32; ++x) EXPECT_TRUE(shown()->cells->shown({x, x})) << x;
    finish();
    EXPECT_EQ(known(), 1024u);
    EXPECT_FALSE(is_computing(lab.map));
    EXPECT_EQ(shown()->cells->at({16, 27})->outcome.behaviour, Behaviour::touches);
    EXPECT_EQ(shown()->cells->at({27, 4})->outcome.behaviour, Behaviour::flees);
    handle(lab, Action::map);
    update_map(lab.map, lab, jobs);
    EXPECT_FALSE(shown());
}

TEST_F(LabMap, LeavesWorkForTheTimeBetweenTwoFramesUntilAllCellsAreBegun) {
    handle(lab, Action::map);
    update_map(lab.map, lab, jobs);
    while (lab.map.begun < lab.map.order.size()) {
        for (int step = 0; step < 800; ++step)
            ASSERT_TRUE(jobs.work(std::chrono::nanoseconds(0))) << known() << " cells";
        jobs.deliver(std::chrono::nanoseconds(0));
        update_map(lab.map, lab, jobs);
    }
    finish();
    EXPECT_EQ(known(), 1024u);
}

TEST_F(LabMap, ShowsEachCellAsItComesAndAShareThatGrowsWithEachStep) {
    lab = opened_lab("predator-prey");
    handle(lab, Action::map);
    update_map(lab.map, lab, jobs);
    ASSERT_TRUE(shown());
    float share = shown()->progress;
    int growing = 0, steps = 0;
    for (; known() < 2 && steps < 20; ++steps) {
        jobs.deliver(std::chrono::nanoseconds(0));
        update_map(lab.map, lab, jobs);
        EXPECT_GE(shown()->progress, share);
        growing += shown()->progress > share;
        share = shown()->progress;
    }
    EXPECT_EQ(growing, steps);
    EXPECT_EQ(known(), 2u) << "of the " << insight::map_levels(32).front().size() << " of the first job";
    EXPECT_LT(share, 3.0f / 1024);
}

TEST_F(LabMap, IsTheSameWithThreads) {
    handle(lab, Action::map);
    finish();
    Lab other = opened_lab("2b-aggressor");
    Jobs threads(2);
    handle(other, Action::map);
    for (int i = 0; i < 40 && (i == 0 || is_computing(other.map)); ++i)
        update_map(other.map, other, threads), threads.finish(), update_map(other.map, other, threads);
    for (std::size_t i = 0; i < lab.map.cells.cells.size(); ++i) {
        ASSERT_TRUE(other.map.cells.cells[i]);
        ASSERT_EQ(lab.map.cells.cells[i]->outcome.closest, other.map.cells.cells[i]->outcome.closest);
    }
}

TEST_F(LabMap, StaysWhileValuesOfItsAxesChangeAndBeginsAnewForOthers) {
    handle(lab, Action::map);
    turn();
    const std::size_t before = known();
    set(Dial::LL, 0.3f), set(Dial::RR, 0.3f), set(Dial::LR, -0.4f);
    update_map(lab.map, lab, jobs);
    EXPECT_GE(known(), before);
    finish();
    set(Dial::LM, 0.5f);
    update_map(lab.map, lab, jobs);
    EXPECT_EQ(known(), 0u);
    finish();
    handle(lab, SeedRequest{5});
    update_map(lab.map, lab, jobs);
    EXPECT_EQ(known(), 0u) << "another start";
}

TEST_F(LabMap, TheCellOfTheBrainIsWhatAResetThenDrives) {
    handle(lab, Action::map);
    finish();
    const auto x = *insight::axis_of("LL=RR"), y = *insight::axis_of("LR=RL");
    const MapPlace place{20, 25};
    for (const Dial dial : x.dials) set(dial, insight::value_at(x, place.x, 32));
    for (const Dial dial : y.dials) set(dial, insight::value_at(y, place.y, 32));
    lab.map.hovered = place;
    turn();
    ASSERT_TRUE(shown()->path);
    for (int i = 0; i < 30; ++i) tick(lab);
    handle(lab, Action::reset);
    for (int i = 0; i < 600; ++i) tick(lab);
    const VehicleView& vehicle = lab.document.session.snapshot().vehicles[0];
    EXPECT_EQ((*shown()->path)[600], (Pose{vehicle.x, vehicle.y, vehicle.heading}));
    lab.map.hovered.reset();
    update_map(lab.map, lab, jobs);
    EXPECT_FALSE(shown()->path);
}

TEST_F(LabMap, AClickOnACellIsOneUndoStep) {
    const FourNeurons before = read_dials(*lab.document.session.snapshot().kind_brains[0], {});
    for (const Dial dial : {Dial::LL, Dial::RR, Dial::LR, Dial::RL}) set(dial, -0.7f, gestures::panels + 3);
    EXPECT_EQ(lab.document.session.undo_depth(), 1);
    handle(lab, Action::undo);
    EXPECT_EQ(read_dials(*lab.document.session.snapshot().kind_brains[0], {}), before);
}

TEST_F(LabMap, AxesThatShareAValueExchange) {
    handle(lab, MapRequest{.x = "LR=RL"});
    EXPECT_EQ(lab.map.x.id, "LR=RL");
    EXPECT_EQ(lab.map.y.id, "LL=RR");
    handle(lab, MapRequest{.y = "LR"});
    EXPECT_EQ(lab.map.y.id, "LR");
    EXPECT_EQ(lab.map.x.id, "LL=RR");
    handle(lab, MapRequest{.measure = insight::MapMeasure::closest, .seeds = 1000});
    EXPECT_EQ(lab.map.measure, insight::MapMeasure::closest);
    EXPECT_EQ(lab.map.seeds, insight::limits::map_seeds);
}

TEST_F(LabMap, OfSensorAndLampIsWhatAResetThenDrivesAndStaysWhileTheDotIsDragged) {
    handle(lab, Action::map);
    turn();
    handle(lab, MapRequest{.x = "sensor.angle"}), handle(lab, MapRequest{.y = "source.lamp.y"});
    handle(lab, MapRequest{.x_range = MapRange{5, 75}});
    finish();
    ASSERT_TRUE(shown());
    EXPECT_EQ(shown()->x.path, "sensor.angle");
    EXPECT_EQ(shown()->x.from, 5);
    const MapPlace place{9, 21};
    const auto drag = [&](MapPlace to) {
        const VehicleView vehicle = lab.document.session.snapshot().vehicles[0];
        for (const bool is_x : {true, false}) {
            const insight::MapAxis axis = is_x ? shown()->x : shown()->y;
            const insight::ValueSubject subject{lab.document.session.snapshot(), vehicle, {no_vehicle, 0}, {}};
            const auto values = axis_values(subject);
            for (const Command& command : commands_that_set(subject, *find_value(values, axis.path),
                                                            insight::value_at(axis, is_x ? to.x : to.y, 32)))
                handle(lab, EditRequest{command, 9});
        }
    };
    drag({3, 4}), drag(place);
    EXPECT_EQ(lab.document.session.undo_depth(), 1);
    update_map(lab.map, lab, jobs);
    EXPECT_EQ(known(), 1024u) << "dragging keeps the map";
    lab.map.hovered = place;
    turn();
    ASSERT_TRUE(shown()->path);
    handle(lab, Action::reset);
    for (int i = 0; i < 600; ++i) tick(lab);
    const VehicleView& vehicle = lab.document.session.snapshot().vehicles[0];
    EXPECT_EQ((*shown()->path)[600], (Pose{vehicle.x, vehicle.y, vehicle.heading}));
}

TEST_F(LabMap, ShowsTheFirstAxesWhereTheSceneHasNoSuchValue) {
    handle(lab, Action::map);
    turn();
    handle(lab, MapRequest{.x = "source.lamp.x"});
    turn();
    EXPECT_EQ(shown()->x.path, "source.lamp.x");
    handle(lab, EditRequest{RemoveSource{0}});
    turn();
    ASSERT_TRUE(shown());
    EXPECT_EQ(shown()->x.path, "LL=RR");
    EXPECT_EQ(shown()->y.path, "LR=RL");
}

TEST_F(LabMap, IsRefusedWhereAnExerciseAsksForTheBrain) {
    Lab exercise = opened_lab("05-aggressor");
    handle(exercise, Action::map);
    EXPECT_FALSE(exercise.view.map);
    EXPECT_EQ(exercise.notice.key, "unavailable.map");
}

}  // namespace
}  // namespace braitenlab::tests::behaviour_map_test
