#include "core/session/session.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/scene/scene_file.h"
#include "tests/core/sessions.h"

namespace braitenlab::tests::session_test {
namespace {

// What a scene says about a vehicle at its start.
struct Begin {
    VehicleId id;
    std::string kind;
    Pose pose;
    Driver driver;
    BrainGraph brain;
    std::vector<Sensor> sensors;
    friend bool operator==(const Begin&, const Begin&) = default;
};
std::vector<Begin> begins(const Snapshot& now) {
    std::vector<Begin> all;
    for (const VehicleView& v : now.vehicles)
        all.push_back({v.id,
                       now.scene->kinds[static_cast<std::size_t>(v.kind)].name,
                       {v.x, v.y, v.heading},
                       v.driver,
                       *brain_of(now, v),
                       kind_of(now, v).sensors});
    return all;
}

TEST(Session, OpensTheSavedSceneAsARestartBeginsIt) {
    int own_brains = 0, own_sensors = 0, no_sensors = 0, own_drivers = 0, placed = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        Session session = open_session(furnished());
        maths::Random chance{seed, 9};
        if (seed % 2 == 0) session.step();
        for (int i = 0; i < 12; ++i) (void)session.apply(any_edit(session, chance));
        if (const auto& all = session.snapshot().vehicles; !all.empty()) {  // no edit: it cannot be undone
            ASSERT_FALSE(session.apply(ChooseDriver{all[chance.next() % all.size()].id, Driver::wander}));
        }
        const std::string text = write_scene(session.edited_scene());
        const auto saved = parse_scene(text, "saved.toml");
        ASSERT_TRUE(saved) << saved.error().text() << "\n" << text;
        Session opened = open_session(*saved);
        session.reset();
        ASSERT_EQ(begins(opened.snapshot()), begins(session.snapshot())) << text;
        ASSERT_EQ(opened.hash(), session.hash()) << text;
        EXPECT_EQ(opened.edited_scene(), *saved) << "opening is no edit\n" << text;
        const auto count_sensors = [&](const auto& own) {
            own_sensors += own.sensors && !own.sensors->empty();
            no_sensors += own.sensors && own.sensors->empty();
        };
        for (const Start& start : saved->starts) count_sensors(start);
        for (const Member& member : saved->members) count_sensors(member);
        for (const Start& start : saved->starts)
            own_brains += start.brain.has_value(), own_drivers += start.driver.has_value();
        for (const Member& member : saved->members)
            own_brains += member.brain.has_value(), own_drivers += member.driver.has_value(), placed += member.placed;
    }
    EXPECT_GT(own_brains, 300);
    EXPECT_GT(own_drivers, 100);
    EXPECT_GT(placed, 100);
    EXPECT_GT(own_sensors, 100);
    EXPECT_GT(no_sensors, 30);
}

TEST(Session, SavesTheBrainOfOneVehicle) {
    Session session = open_session(furnished());
    const VehicleId one = session.snapshot().vehicles.back().id, other = session.snapshot().vehicles.front().id;
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = one}, Dial::LR, 1.25f}));
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = other}, Dial::LR, -0.75f}));
    const Session opened = open_session(*parse_scene(write_scene(session.edited_scene()), "saved.toml"));
    const Snapshot& now = opened.snapshot();
    EXPECT_EQ(read_dials(*brain_of(now, *find_vehicle(now, one))).LR, 1.25f);
    EXPECT_EQ(read_dials(*brain_of(now, *find_vehicle(now, other))).LR, -0.75f);
}

TEST(Session, GoesBackToAnyTickOfTheLastMinuteAndReplaysExactly) {
    Session session = open_session(furnished());
    maths::Random chance{3, 4};
    std::vector<std::uint64_t> hashes;
    std::vector<int> depths;
    for (int tick = 0; tick < 4200; ++tick) {
        if (tick % 37 == 5) (void)session.apply(any_edit(session, chance));
        if (tick % 400 == 80) session.undo();
        hashes.push_back(session.hash());
        depths.push_back(session.undo_depth());
        session.step();
    }
    EXPECT_LE(session.earliest(), session.latest() - recorded_ticks);
    EXPECT_GT(session.earliest(), 0u);
    const std::uint64_t end = session.latest();
    for (int i = 0; i < 40; ++i) {
        const auto tick = static_cast<std::uint64_t>(session.earliest() + chance.next() % (end - session.earliest()));
        session.seek(tick);
        ASSERT_EQ(session.snapshot().tick, tick);
        ASSERT_EQ(session.hash(), hashes[tick]);
        ASSERT_EQ(session.undo_depth(), depths[tick]);
        for (int more = 1; more < 90 && tick + static_cast<std::uint64_t>(more) < hashes.size(); ++more) {
            session.step();
            ASSERT_EQ(session.hash(), hashes[tick + static_cast<std::uint64_t>(more)]);
        }
        EXPECT_EQ(session.latest(), end);
    }
}

TEST(Session, AnEditInThePastChangesTheRun) {
    Session session = open_session(furnished());
    for (int i = 0; i < 700; ++i) session.step();
    const auto hash = session.hash();
    session.seek(350);
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 2}));
    EXPECT_EQ(session.latest(), 350u);
    while (session.snapshot().tick < 700) session.step();
    EXPECT_NE(session.hash(), hash);
}

TEST(Session, TimeDroppedByAnEditInThePastIsRestoredByUndo) {
    Session session = open_session(furnished());
    for (int i = 0; i < 200; ++i) session.step();
    session.apply(TurnDial{{.kind = 0}, Dial::RR, 1});
    for (int i = 200; i < 700; ++i) session.step();
    const auto hash = session.hash();
    session.seek(350);
    const auto then = session.hash();
    for (const float value : {0.5f, 1.0f, 2.0f}) ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, value}, 9));
    EXPECT_TRUE(session.undo_brings_time_back());
    ASSERT_FALSE(session.apply(RemoveVehicle{}));
    EXPECT_FALSE(session.undo_brings_time_back()) << "this edit has dropped no recorded time";
    session.undo(), session.undo();
    EXPECT_EQ(session.latest(), 700u);
    EXPECT_EQ(session.snapshot().tick, 350u);
    EXPECT_EQ(session.hash(), then);
    while (session.snapshot().tick < 700) session.step();
    EXPECT_EQ(session.hash(), hash) << "bit for bit";
    session.seek(350);
    EXPECT_EQ(session.undo_depth(), 1);
}

TEST(Session, TimeDroppedByAnEditInThePastStaysDroppedOnceTheRunContinues) {
    Session session = open_session(furnished());
    session.apply(TurnDial{{.kind = 0}, Dial::RR, 1});
    for (int i = 0; i < 700; ++i) session.step();
    session.seek(350);
    session.undo();
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 1});
    EXPECT_FALSE(session.undo_brings_time_back()) << "the recorded run has another RR";
    session.undo();
    EXPECT_EQ(session.latest(), 350u);
    session.step();
    session.seek(350);
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 1});
    session.undo();
    EXPECT_EQ(session.latest(), 351u) << "the one recorded tick is restored";
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 1});
    session.step(), session.step();
    session.undo();
    EXPECT_EQ(session.latest(), 352u);
}

TEST(Session, ABookmarkRestoresItsTickFromAnyOtherRun) {
    Session session = open_session(furnished());
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 1});
    for (int i = 0; i < 450; ++i) session.step();
    const Bookmark here = session.bookmark();
    const auto hash = session.hash();
    for (int i = 0; i < 100; ++i) session.step();
    session.go_to(here);
    EXPECT_EQ(session.hash(), hash);
    EXPECT_EQ(session.latest(), 550u) << "the recorded future is kept";
    session.apply(TurnDial{{.kind = 0}, Dial::LL, -1});
    session.reset();
    for (int i = 0; i < 30; ++i) session.step();
    session.go_to(here);
    EXPECT_EQ(session.hash(), hash);
    EXPECT_EQ(session.undo_depth(), 1);
    EXPECT_EQ(dial(session, Dial::LL), 1);
}

TEST(Session, ResetKeepsAddedMovedAndRemovedObjects) {
    Session session = open_session(furnished());
    for (int i = 0; i < 20; ++i) session.step();
    ASSERT_FALSE(session.apply(RemoveVehicle{0}));
    ASSERT_FALSE(session.apply(AddVehicle{0, Pose{3, -2, 1}}));
    const VehicleId added = session.snapshot().vehicles.back().id;
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = added}, Dial::LL, 1.25f}));
    ASSERT_FALSE(session.apply(RemoveSource{0}));
    for (int i = 0; i < 200; ++i) session.step();
    session.reset();
    const Snapshot& now = session.snapshot();
    EXPECT_EQ(now.tick, 0u);
    EXPECT_EQ(now.vehicles.size(), 7u);
    EXPECT_EQ(now.sources.size(), 1u);
    EXPECT_FLOAT_EQ(now.vehicles[1].x, 3);
    EXPECT_FLOAT_EQ(now.vehicles[1].y, -2);
    EXPECT_EQ(dial(session, Dial::LL, 1), 1.25f) << "the brain stays with its vehicle under its new number";
    while (session.undo()) {
    }
    EXPECT_EQ(session.edited_scene(), furnished());
}

TEST(Session, ResetKeepsTheEditsWhenAnEditedVehicleHasReplacedAStarvedVehicleWithAStart) {
    Scene scene = tests::alone({});
    scene.ecology.drain = 1;
    Session session = open_session(scene);
    for (int i = 0; i < 70; ++i) session.step();
    const VehicleView successor = session.snapshot().vehicles.at(0);
    ASSERT_EQ(successor.start, -1);
    ASSERT_FALSE(session.apply(AddSource{{.name = "lamp", .x = 3}}));
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = successor.id}, Dial::LL, 1.5f}));
    EXPECT_TRUE(parse_scene(write_scene(session.edited_scene()), "saved"));
    session.reset();
    EXPECT_EQ(session.snapshot().sources.size(), 1u);
    EXPECT_EQ(session.snapshot().vehicles.at(0).start, 0);
}

// One hunted vehicle with id 1 and one hunter with id 2, which has a brain of its own.
Session with_own_brain_of_last() {
    Session session = open_session(tests::crowd(2));
    EXPECT_FALSE(session.apply(RemoveVehicle{0}));
    EXPECT_FALSE(session.apply(SetPopulation{0, 1}));
    EXPECT_EQ(session.snapshot().vehicles.at(1).kind, 0);
    EXPECT_FALSE(session.apply(TurnDial{{.vehicle = session.snapshot().vehicles.at(1).id}, Dial::LL, 1.25f}));
    return session;
}

TEST(Session, ResetGivesTheSameNumbersOfEachKindWhenAVehicleHasABrainOfItsOwn) {
    Session session = with_own_brain_of_last();
    session.reset();
    EXPECT_EQ(count_of(session, 0), 1);
    EXPECT_EQ(count_of(session, 1), 1);
    EXPECT_EQ(session.snapshot().vehicles.at(1).kind, 0);
    EXPECT_EQ(dial(session, Dial::LL, 1), 1.25f);
}

TEST(Session, ANewGenerationKeepsTheKindOfAVehicleWithABrainOfItsOwnWhereTheSharesAllowIt) {
    Session session = with_own_brain_of_last();
    ASSERT_FALSE(session.apply(NewPopulation{}));
    EXPECT_EQ(count_of(session, 0), 1);
    EXPECT_EQ(count_of(session, 1), 1);
    EXPECT_EQ(session.snapshot().vehicles.at(1).kind, 0);
    EXPECT_EQ(dial(session, Dial::LL, 1), 1.25f);
}

TEST(Session, ResetOfAnExerciseKeepsTheSensorsAndTheBodyOfTheSubjectWithTheirUndo) {
    Session session = open_session(furnished());
    std::vector<Kind> kinds = furnished().kinds;
    for (Kind& kind : kinds) kind.sensors[0].angle = 1, kind.body.mass = 20;
    Kind coloured = furnished().kinds[0];
    coloured.colour = "#3d7cc9";
    ASSERT_FALSE(session.apply(SetSensors{{.kind = 0}, kinds[0].sensors}));
    ASSERT_FALSE(session.apply(EditKind{0, kinds[0]}));
    ASSERT_FALSE(session.apply(SetSensors{{.kind = 1}, kinds[1].sensors}));
    ASSERT_FALSE(session.apply(EditKind{1, kinds[1]}));
    ASSERT_FALSE(session.apply(EditKind{0, coloured}));
    ASSERT_TRUE(session.undo());
    session.step();
    session.reset(Keep::submission);
    Scene expected = furnished();
    expected.kinds[0].sensors = kinds[0].sensors, expected.kinds[0].body = kinds[0].body;
    EXPECT_EQ(session.edited_scene(), expected);
    EXPECT_EQ(session.undo_depth(), 2) << "only the edits of the subject still apply";
    session.undo(), session.undo();
    EXPECT_EQ(session.edited_scene(), furnished());
}

TEST(Session, ResetOfAnExerciseKeepsTheSensorsOfTheSubjectAlone) {
    Session session = open_session(furnished());
    std::vector<Sensor> sensors = furnished().kinds[0].sensors;
    sensors[0].angle = 1;
    ASSERT_EQ(session.snapshot().vehicles[0].start, 0);
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 0}, sensors}));
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 1}, sensors}));
    session.reset(Keep::submission);
    const Snapshot& now = session.snapshot();
    EXPECT_EQ(kind_of(now, now.vehicles[0]).sensors, sensors);
    EXPECT_EQ(kind_of(now, now.vehicles[1]).sensors, furnished().kinds[1].sensors) << "of another kind";
}

TEST(Session, ResetOfAnExerciseKeepsOnlyTheBrains) {
    Session session = open_session(furnished());
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 1.25f}));
    ASSERT_FALSE(session.apply(MoveSource{0, 4, 4}));
    ASSERT_FALSE(session.apply(AddObstacle{{"", -2, -2, 0.3f, 2, 1}}));
    session.reset(Keep::submission);
    Scene expected = furnished();
    expected.kinds[0].brain = *session.snapshot().kind_brains[0];
    EXPECT_EQ(session.edited_scene(), expected);
    EXPECT_EQ(dial(session, Dial::LL), 1.25f);
    EXPECT_EQ(session.undo_depth(), 1) << "only the edit of the brain still applies";
}

TEST(Session, ResetRestoresTheExactStartAndKeepsTheEditedBrains) {
    Session session = open_session(tests::crowd(6)), fresh = open_session(tests::crowd(6));
    for (int i = 0; i < 300; ++i) session.step();
    session.reset();
    EXPECT_EQ(session.hash(), fresh.hash());

    session.apply(TurnDial{{.kind = 0}, Dial::LL, 1});
    session.apply(TurnDial{{.vehicle = 1}, Dial::RR, -1});
    const auto edited = session.hash();
    for (int i = 0; i < 300; ++i) session.step();
    session.reset();
    EXPECT_EQ(session.hash(), edited);
    EXPECT_EQ(dial(session, Dial::LL), 1);
}

TEST(Session, ReplayVisitsTheRecordedTicksWithoutChangingTheSession) {
    Session session = open_session(furnished());
    std::vector<Pose> poses;
    const auto pose_in = [](const Snapshot& now) {
        return Pose{now.vehicles[0].x, now.vehicles[0].y, now.vehicles[0].heading};
    };
    for (int i = 0; i < 700; ++i) {
        poses.push_back(pose_in(session.snapshot()));
        session.step();
        if (i == 320) {
            ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 1}));
        }
    }
    poses.push_back(pose_in(session.snapshot()));
    const auto hash = session.hash();
    for (const std::uint64_t from : {0u, 250u, 300u, 321u, 700u}) {
        std::uint64_t tick = from;
        std::vector<std::uint64_t> commands;
        session.replay(from, {[&](const Snapshot& now) {
                                  EXPECT_EQ(now.tick, tick);
                                  EXPECT_EQ(pose_in(now), poses[tick]) << tick;
                                  ++tick;
                              },
                              [&](const Snapshot& now, const Command&) { commands.push_back(now.tick); }});
        EXPECT_EQ(tick, 701u);
        EXPECT_EQ(commands, from <= 321 ? std::vector<std::uint64_t>{321} : std::vector<std::uint64_t>{});
    }
    EXPECT_EQ(session.hash(), hash);
    EXPECT_EQ(session.snapshot().tick, 700u);
}

}  // namespace
}  // namespace braitenlab::tests::session_test
