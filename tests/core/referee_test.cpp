#include "core/lesson/referee.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/maths/angle.h"
#include "core/session/session.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::referee_test {
namespace {

Exercise with(std::vector<Check> checks) {
    Exercise exercise;
    exercise.scene.sources.push_back({"other", Channel::light, 50, 50, 1});
    exercise.scene.sources.push_back({"lamp", Channel::light, 0, 0, 1});
    for (Check& check : checks) exercise.steps.push_back({"", std::move(check)});
    return exercise;
}

const Check touch{goals::Touches{"lamp", 0.5f}};
const Check turn{goals::TurnsTo{"lamp", 20}};
const Check faster{goals::SpeedsUp{"lamp", 0.5f, 1.5f}};
const Check last{goals::Runs{2}};

// The only value of a step.
Measure measure(const Referee& referee, std::size_t step = 0) { return referee.verdicts()[step].measures.at(0); }

// A vehicle at (x, 0).
Snapshot moment(std::uint64_t tick, float x, float degrees = 180, float speed = 1) {
    Snapshot snapshot;
    snapshot.tick = tick;
    snapshot.seconds = static_cast<double>(tick) / 60;
    VehicleView vehicle;
    vehicle.id = 4;
    vehicle.start = 0;
    vehicle.x = x;
    vehicle.heading = maths::wrap_angle(maths::radians(degrees));
    vehicle.speed = speed;
    snapshot.vehicles.push_back(vehicle);
    snapshot.sources = {{0, Channel::light, 50, 50, 1}, {1, Channel::light, 0, 0, 1}};
    snapshot.scene = std::make_shared<const Scene>(with({}).scene);
    return snapshot;
}

TEST(Referee, AStepThatWasDoneStaysDone) {
    Referee referee(with({touch}));
    referee.watch(moment(0, 3));
    EXPECT_FALSE(referee.passed());
    EXPECT_FLOAT_EQ(measure(referee).value, 3);
    EXPECT_FLOAT_EQ(measure(referee).needed, 0.5f);
    EXPECT_EQ(measure(referee).unit, "m");
    referee.watch(moment(1, 0.4f));
    EXPECT_TRUE(referee.passed());
    referee.watch(moment(2, 3));
    EXPECT_TRUE(referee.passed());
    EXPECT_FLOAT_EQ(measure(referee).value, 0.4f);
}

TEST(Referee, ALostStepShowsWhatItWasAtTheEndOfTheExercise) {
    Exercise exercise = with({{goals::AllOf{{{goals::Runs{2}}, {goals::NoneOf{{{goals::Captures{2}}}}}}}}});
    exercise.seconds = 2;
    Referee referee(exercise);
    const auto with_captures = [](std::uint64_t tick, int captures) {
        Snapshot now = moment(tick, 3);
        now.events.captures = captures;
        return now;
    };
    referee.watch(with_captures(0, 0));
    referee.watch(with_captures(60, 3));
    ASSERT_TRUE(referee.lost());
    const auto captures = [&] { return referee.verdicts()[0].measures.back().value; };
    referee.watch(with_captures(120, 5));
    EXPECT_FLOAT_EQ(captures(), 5);
    referee.watch(with_captures(180, 9));
    EXPECT_FLOAT_EQ(captures(), 5);
}

TEST(Referee, ADistanceIsTheSmallestSoFar) {
    Referee referee(with({touch}));
    referee.watch(moment(0, 3));
    referee.watch(moment(1, 1));
    referee.watch(moment(2, 2));
    EXPECT_FLOAT_EQ(measure(referee).value, 1);
}

TEST(Referee, ATurnCountsOnlyIfTheSourceWasOutsideBefore) {
    Referee referee(with({turn}));
    referee.watch(moment(0, 3, 180));  // faces the source already
    EXPECT_FALSE(referee.passed());
    referee.watch(moment(1, 3, 150));
    EXPECT_FALSE(referee.passed());
    referee.watch(moment(2, 3, -165));  // across the discontinuity of angles at 180°
    EXPECT_TRUE(referee.passed());
    EXPECT_NEAR(measure(referee).needed, 20, 1e-4);
}

TEST(Referee, ASpeedUpComparesTheFirstArrivalWithOneSecond) {
    for (const float speed : {1.4f, 1.6f}) {
        Referee referee(with({faster}));
        referee.watch(moment(0, 3, 180, 0));
        referee.watch(moment(60, 3, 180, 1));
        referee.watch(moment(61, 2, 180, 3));  // fast, but too far away
        EXPECT_FALSE(referee.passed());
        EXPECT_FLOAT_EQ(measure(referee).value, 3);
        referee.watch(moment(62, 0.5f, 180, speed));
        EXPECT_EQ(referee.passed(), speed > 1.5f);
        referee.watch(moment(63, 0.4f, 180, 3));  // too late
        EXPECT_EQ(referee.passed(), speed > 1.5f);
        EXPECT_FLOAT_EQ(measure(referee).value, speed);
    }
}

TEST(Referee, AStartFromRestDoesNotCountAsASpeedUp) {
    Referee referee(with({faster}));
    referee.watch(moment(0, 3, 180, 0));
    referee.watch(moment(60, 3, 180, 0));
    referee.watch(moment(61, 0.4f, 180, 0.06f));
    EXPECT_FALSE(referee.passed());
}

TEST(Referee, ARunEndsAfterItsSeconds) {
    Referee referee(with({last}));
    referee.watch(moment(0, 3));
    referee.watch(moment(119, 3));
    EXPECT_FALSE(referee.passed());
    referee.watch(moment(120, 3));
    EXPECT_TRUE(referee.passed());
}

TEST(Referee, ARunPassesWhenEveryStepIsDone) {
    Referee referee(with({touch, last}));
    referee.watch(moment(0, 0.1f));
    EXPECT_TRUE(referee.verdicts()[0].done);
    EXPECT_FALSE(referee.passed());
}

TEST(Referee, ANewRunBeginsAtTickZeroOrAnEarlierTickAndNotAtTheSameTick) {
    Referee referee(with({touch}));
    referee.watch(moment(0, 3));
    referee.watch(moment(1, 0.1f));
    referee.watch(moment(2, 3));
    referee.watch(moment(2, 3));
    EXPECT_TRUE(referee.passed());
    referee.watch(moment(0, 3));
    EXPECT_FALSE(referee.passed());
    EXPECT_FLOAT_EQ(measure(referee).value, 3);
    referee.watch(moment(50, 0.1f));
    referee.watch(moment(20, 3));  // back in time
    EXPECT_FALSE(referee.passed());
}

TEST(Referee, StepsApplyToTheFirstVehicleAtTheStart) {
    Referee referee(with({touch}));
    referee.watch(moment(0, 3));
    Snapshot other = moment(1, 0.1f);
    other.vehicles[0].id = 9;  // the first vehicle is removed
    referee.watch(other);
    EXPECT_FALSE(referee.passed());
}

TEST(Referee, ARunThatIsNotWatchedFromItsStartDoesNotCount) {
    Referee referee(with({touch}));
    referee.watch(moment(5, 0.1f));
    EXPECT_TRUE(referee.by_hand());
    referee.watch(moment(6, 0.1f));
    EXPECT_FALSE(referee.passed());
    referee.watch(moment(0, 0.1f));
    EXPECT_TRUE(referee.passed());
}

TEST(Referee, ADisturbedRunCountsNoFurtherSteps) {
    Referee referee(with({turn, touch}));
    referee.watch(moment(0, 3, 90));
    referee.watch(moment(1, 3, 180));
    referee.watch(moment(1, 3, 180), MoveVehicle{4, 0.1f, 0, 0});
    EXPECT_TRUE(referee.by_hand());
    referee.watch(moment(2, 0.1f));
    EXPECT_TRUE(referee.verdicts()[0].done);
    EXPECT_FALSE(referee.verdicts()[1].done);
    referee.watch(moment(0, 3));
    EXPECT_FALSE(referee.by_hand()) << "the next run starts without help";
    referee.watch(moment(1, 0.1f));
    EXPECT_TRUE(referee.verdicts()[1].done);
}

TEST(Referee, AMovedOrAddedLampMakesARunByHand) {
    for (const bool added : {false, true}) {
        Referee referee(with({touch}));
        Snapshot snapshot = moment(0, 0.1f);
        Scene scene = *snapshot.scene;
        added ? scene.sources.push_back({"bait", Channel::light, 1, 1, 1}) : void(scene.sources[1].x += 1);
        snapshot.scene = std::make_shared<const Scene>(scene);
        referee.watch(snapshot);
        EXPECT_TRUE(referee.by_hand());
        EXPECT_FALSE(referee.passed());
        referee.watch(moment(0, 0.1f));  // moved back
        EXPECT_FALSE(referee.by_hand());
        EXPECT_TRUE(referee.passed());
    }
}

TEST(Referee, AnotherStartOrAManualDriverMakesARunByHand) {
    Exercise exercise = with({touch});
    exercise.scene.kinds.push_back({.name = "vehicle"});
    exercise.scene.starts.push_back({.name = "one", .kind = "vehicle", .x = 3});
    const auto given = [&](const Scene& scene, Driver driver) {
        Referee referee(exercise);
        Snapshot snapshot = moment(0, 0.1f);
        snapshot.scene = std::make_shared<const Scene>(scene);
        snapshot.vehicles[0].driver = driver;
        referee.watch(snapshot);
        EXPECT_EQ(referee.by_hand(), !referee.passed());
        return referee.passed();
    };
    EXPECT_TRUE(given(exercise.scene, Driver::brain));
    EXPECT_FALSE(given(exercise.scene, Driver::manual));
    Scene nearer = exercise.scene;
    nearer.starts[0].x = 1;
    EXPECT_FALSE(given(nearer, Driver::brain));
}

// An exercise with a second vehicle, a second kind, an obstacle and a zone.
Exercise furnished() {
    Exercise exercise = with({touch});
    Scene& scene = exercise.scene;
    scene.kinds.resize(2);
    scene.kinds[0].name = "subject";
    scene.kinds[0].sensors.resize(2);
    scene.kinds[1].name = "other";
    scene.starts.resize(2);
    scene.starts[0].name = "one";
    scene.starts[0].kind = "subject";
    scene.starts[1].name = "two";
    scene.starts[1].kind = "other";
    scene.obstacles.resize(1);
    scene.zones.resize(1);
    return exercise;
}

TEST(Referee, EverythingAddedRemovedOrMovedInTheSceneBeforeTheFirstTickMakesARunByHand) {
    const Exercise exercise = furnished();
    const std::vector<std::pair<const char*, void (*)(Scene&)>> changes{
        {"an obstacle is added", [](Scene& s) { s.obstacles.emplace_back(); }},
        {"a source is removed", [](Scene& s) { s.sources.erase(s.sources.begin()); }},
        {"an obstacle is removed", [](Scene& s) { s.obstacles.clear(); }},
        {"an obstacle is moved", [](Scene& s) { s.obstacles[0].x += 1; }},
        {"a vehicle is added", [](Scene& s) { s.starts.emplace_back().kind = "other"; }},
        {"a vehicle is added at random", [](Scene& s) { s.ecology.population = 1; }},
        {"a vehicle is removed", [](Scene& s) { s.starts.pop_back(); }},
        {"the other vehicle is moved", [](Scene& s) { s.starts[1].x += 1; }},
        {"a source is added", [](Scene& s) { s.sources.emplace_back(); }},
        {"a zone is added", [](Scene& s) { s.zones.emplace_back(); }},
        {"a zone is removed", [](Scene& s) { s.zones.clear(); }},
        {"a zone gets another outline", [](Scene& s) { s.zones[0].corners.resize(3); }},
        {"a zone is changed", [](Scene& s) { s.zones[0].pull = 3; }},
        {"the arena is changed", [](Scene& s) { s.arena.grip = 0.5f; }},
        {"the other kind's sensors are changed", [](Scene& s) { s.kinds[1].sensors.emplace_back(); }},
        {"the other kind's body is changed", [](Scene& s) { s.kinds[1].body.mass = 20; }},
    };
    for (const auto& [what, change] : changes) {
        Snapshot start = moment(0, 3);
        Scene scene = exercise.scene;
        change(scene);
        start.scene = std::make_shared<const Scene>(scene);
        Referee referee(exercise);
        referee.watch(start);
        EXPECT_TRUE(referee.by_hand()) << what;
    }
}

TEST(Referee, EditsOfTheSubjectAndTheTitleAreNotHelp) {
    const Exercise exercise = furnished();
    const std::vector<std::pair<const char*, void (*)(Scene&)>> changes{
        {"nothing", [](Scene&) {}},
        {"the title", [](Scene& s) { s.title = "Mine"; }},
        {"the subject's sensors", [](Scene& s) { s.kinds[0].sensors[0].angle = 1; }},
        {"the subject's body", [](Scene& s) { s.kinds[0].body.mass = 20; }},
    };
    for (const auto& [what, change] : changes) {
        Snapshot start = moment(0, 3);
        Scene scene = exercise.scene;
        change(scene);
        start.scene = std::make_shared<const Scene>(scene);
        Referee referee(exercise);
        referee.watch(start);
        EXPECT_FALSE(referee.by_hand()) << what;
    }
}

TEST(Referee, AnotherKindsChangedBrainMakesARunByHand) {
    const Exercise exercise = furnished();
    const auto by_hand = [&](std::size_t kind) {
        Snapshot start = moment(0, 3);
        start.scene = std::make_shared<const Scene>(exercise.scene);
        start.kind_brains.assign(2, std::make_shared<BrainGraph>());
        start.kind_brains[kind] = std::make_shared<BrainGraph>(make_graph({.LL = 1}));
        Referee referee(exercise);
        referee.watch(start);
        return referee.by_hand();
    };
    EXPECT_FALSE(by_hand(0)) << "the subject's brain is what the student changes";
    EXPECT_TRUE(by_hand(1));
}

TEST(Referee, AVehicleRemovedBeforeTheFirstTickMakesARunByHand) {
    const Exercise exercise = furnished();
    Referee referee(exercise);
    for (const std::uint64_t tick : {0U, 1U}) {
        Snapshot now = moment(tick, 3);
        now.vehicles.clear();
        Scene scene = exercise.scene;
        scene.starts.erase(scene.starts.begin());
        now.scene = std::make_shared<const Scene>(scene);
        referee.watch(now);
        EXPECT_TRUE(referee.by_hand()) << tick;
    }
}

// An exercise whose subject has the id 0. The vehicle 1 has a start, too. Of the population, the vehicles 2 and 4 are
// of the subject's kind; the vehicle 3 has a brain and a driver of its own.
Exercise populated() {
    Exercise exercise = with({touch});
    Scene& scene = exercise.scene;
    scene.arena.width = scene.arena.height = 200;
    scene.kinds = {tests::two_eyed("subject", {}), tests::two_eyed("other", {.LL = 1})};
    scene.kinds[0].share = scene.kinds[1].share = 1;
    scene.starts = {{.name = "one", .kind = "subject", .x = 20},
                    {.name = "two", .kind = "other", .x = 30, .driver = Driver::manual}};
    scene.ecology.population = 3;
    scene.members = {{.name = "1", .kind = "other", .driver = Driver::manual, .brain = make_graph({.RR = 1})},
                     {.name = "2", .kind = "subject"}};
    return exercise;
}

Session opened(const Exercise& exercise) {
    auto session = Session::open(exercise.scene, 3);
    EXPECT_TRUE(session) << session.error().text();
    return std::move(*session);
}

TEST(Referee, AVehicleChangedBeforeTheFirstTickMakesARunByHand) {
    const Exercise exercise = populated();
    const Member member = exercise.scene.members[1];
    const Member placed{.name = "2", .kind = "subject", .placed = true, .x = 1};
    const std::vector<std::pair<const char*, Command>> changes{
        {"the brain of another vehicle with a start", TurnDial{{.vehicle = 1}, Dial::LL, 0}},
        {"the brain of a member", SetBrain{{.vehicle = 3}, exercise.scene.kinds[1].brain}},
        {"the driver of a vehicle with a start", ChooseDriver{1, Driver::brain}},
        {"the driver of a member", ChooseDriver{3, Driver::brain}},
        {"the driver of a vehicle of the population", ChooseDriver{2, Driver::manual}},
        {"the pose of a member", EditMember{2, placed}},
        {"the population", NewPopulation{}},
    };
    for (const auto& [what, command] : changes) {
        Session session = opened(exercise);
        Referee referee(exercise);
        referee.watch(session.snapshot());
        EXPECT_FALSE(referee.by_hand()) << what;
        ASSERT_FALSE(session.apply(command)) << what;
        referee.watch(session.snapshot(), command);
        EXPECT_TRUE(referee.by_hand()) << what;
        session.step();
        referee.watch(session.snapshot());
        EXPECT_TRUE(referee.by_hand()) << what << ", after a tick";
    }
    Session session = opened(exercise);
    ASSERT_FALSE(session.apply(EditMember{1, exercise.scene.members[0]}));  // the same, now last in the list
    Referee referee(exercise);
    referee.watch(session.snapshot());
    EXPECT_FALSE(referee.by_hand()) << "the order of the members is no change";
}

TEST(Referee, TheBrainOfTheSubjectAndTheColourOfAStartAreNoHelp) {
    const Exercise exercise = populated();
    Start tinted = exercise.scene.starts[0];
    tinted.colour = "#3d7cc9";
    for (const Command& command : {Command(TurnDial{{.vehicle = 0}, Dial::LL, 1}),
                                   Command(TurnDial{{.vehicle = 2}, Dial::LL, 1}), Command(EditStart{0, tinted}),
                                   Command(SetLook{2, {"Bob", ""}}), Command(EditMember{1, exercise.scene.members[0]})})
        for (const int ticks : {0, 5}) {
            Session session = opened(exercise);
            Referee referee(exercise);
            referee.watch(session.snapshot());
            for (int i = 0; i < ticks; ++i) session.step(), referee.watch(session.snapshot());
            ASSERT_FALSE(session.apply(command));
            referee.watch(session.snapshot(), command);
            session.step();
            referee.watch(session.snapshot());
            const bool is_help = std::holds_alternative<EditMember>(command) && ticks > 0;
            EXPECT_EQ(referee.by_hand(), is_help) << command.index() << " after " << ticks;
        }
}

TEST(Referee, AStartMovedDuringARunIsHelp) {
    const Exercise exercise = populated();
    Start moved = exercise.scene.starts[0];
    moved.x += 1, moved.colour = "#3d7cc9";
    Session session = opened(exercise);
    Referee referee(exercise);
    referee.watch(session.snapshot());
    session.step();
    referee.watch(session.snapshot());
    ASSERT_FALSE(session.apply(EditStart{0, moved}));
    referee.watch(session.snapshot(), EditStart{0, moved});
    EXPECT_TRUE(referee.by_hand());
}

TEST(Referee, AStateOfAnotherExerciseIsRefused) {
    const std::string state = write_referee_state(Referee(with({turn})).state());
    EXPECT_TRUE(read_referee_state(state, with({turn})));
    EXPECT_FALSE(read_referee_state(state, with({turn, touch})));
    EXPECT_FALSE(read_referee_state(state, with({faster})));
    Referee begun(with({turn}));
    begun.watch(moment(0, 3));
    Exercise of_two = with({turn});
    of_two.scene.starts.resize(2);
    EXPECT_TRUE(read_referee_state(write_referee_state(begun.state()), with({turn})));
    EXPECT_FALSE(read_referee_state(write_referee_state(begun.state()), of_two)) << "the number of starts";
    EXPECT_FALSE(read_referee_state("", with({turn})));
    EXPECT_FALSE(read_referee_state("{}", with({turn})));
    EXPECT_FALSE(read_referee_state("[1", with({turn})));
}

TEST(Referee, TheStateOfACombinationIsWrittenAndReadBack) {
    const Exercise exercise = with({{goals::AllOf{{touch, {goals::AnyOf{{turn, faster}}}}}, "", 3}});
    Referee referee(exercise);
    for (std::uint64_t tick = 0; tick <= 70; ++tick) referee.watch(moment(tick, 0.3f, tick < 30 ? 90 : 180));
    const std::string text = write_referee_state(referee.state());
    const auto state = read_referee_state(text, exercise);
    ASSERT_TRUE(state) << text;
    EXPECT_EQ(write_referee_state(*state), text);
    Referee other(exercise);
    other.restore(*state);
    EXPECT_EQ(other.verdicts()[0].measures, referee.verdicts()[0].measures);
}

TEST(Referee, EveryValueOfAStateIsWrittenAndReadBack) {
    Exercise exercise = with({turn, faster});
    exercise.scene.starts.resize(2);
    RefereeState state = Referee(exercise).state();
    state.tick = 7;
    state.subjects = {4, 5};
    state.begun = state.disturbed = state.by_hand = state.changed = state.was_changed = true;
    state.steps[0] = {{goals::TurnsTo::State{true}, 12, 5, 2}, true};
    state.steps[1] = {{goals::SpeedsUp::State{0.5f, 1.25f, true}, 1.25f, 3, 4}, true};
    const auto read = read_referee_state(write_referee_state(state), exercise);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->tick, 7u);
    EXPECT_EQ(read->subjects, state.subjects);
    EXPECT_TRUE(read->begun);
    EXPECT_TRUE(read->disturbed);
    EXPECT_TRUE(read->by_hand);
    EXPECT_TRUE(read->changed);
    EXPECT_TRUE(read->was_changed);
    ASSERT_EQ(read->steps.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_TRUE(read->steps[i].done);
        EXPECT_EQ(read->steps[i].check.value, state.steps[i].check.value);
        EXPECT_EQ(read->steps[i].check.met_since, state.steps[i].check.met_since);
        EXPECT_EQ(read->steps[i].check.held, state.steps[i].check.held);
    }
    EXPECT_TRUE(std::get<goals::TurnsTo::State>(read->steps[0].check.goal).was_outside);
    const auto& speeds = std::get<goals::SpeedsUp::State>(read->steps[1].check.goal);
    EXPECT_EQ(speeds.first_speed, 0.5f);
    EXPECT_EQ(speeds.ratio, 1.25f);
    EXPECT_TRUE(speeds.decided);
}

TEST(Referee, ContinuesExactlyFromASavedState) {
    const Exercise exercise = with({turn, faster, last});
    Referee referee(exercise);
    const auto watch = [](Referee& each, std::uint64_t tick) {
        const float t = static_cast<float>(tick) / 60;
        each.watch(moment(tick, 3 - t, tick < 30 ? 90 : 180, 0.5f + t));
    };
    for (std::uint64_t tick = 0; tick <= 70; ++tick) watch(referee, tick);
    Referee other(exercise);
    const auto state = read_referee_state(write_referee_state(referee.state()), exercise);
    ASSERT_TRUE(state);
    other.restore(*state);
    for (std::uint64_t tick = 71; tick <= 200; ++tick) watch(referee, tick), watch(other, tick);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(referee.verdicts()[i].done) << i;
        EXPECT_TRUE(other.verdicts()[i].done) << i;
        EXPECT_EQ(referee.verdicts()[i].measures, other.verdicts()[i].measures);
    }
}

}  // namespace
}  // namespace braitenlab::tests::referee_test
