#include "core/session/session.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/brain/four_neurons.h"
#include "core/maths/random.h"
#include "core/scene/scene_file.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::session_test {
namespace {

Session open(const Scene& scene) {
    auto session = Session::open(scene, 3);
    EXPECT_TRUE(session);
    return std::move(*session);
}

float dial(const Session& session, Dial which, std::size_t vehicle = 0) {
    const Snapshot& now = session.snapshot();
    return at(read_dials(*now.brains[static_cast<std::size_t>(now.vehicles[vehicle].brain)]), which);
}

TEST(Undo, RevertsAWholeDragInOneStep) {
    Session session = open(tests::crowd(4));
    for (const float value : {0.1f, 0.4f, 0.9f}) ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, value}, 5));
    EXPECT_EQ(session.undo_depth(), 1);
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(dial(session, Dial::LL), 0);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(dial(session, Dial::LL), 0.9f);
    EXPECT_FALSE(session.redo());
}

TEST(Undo, HasNoStepForADragThatEndsWhereItBegan) {
    Session session = open(tests::crowd(4));
    for (const float value : {0.5f, 1.0f, 0.0f}) ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, value}, 5));
    EXPECT_EQ(session.undo_depth(), 0);
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 0.25f}, 5)) << "the gesture may continue";
    EXPECT_EQ(session.undo_depth(), 1);
    session.undo();
    EXPECT_EQ(dial(session, Dial::LL), 0);
}

TEST(Undo, RestoresTheBrainOfEachVehicle) {
    Session session = open(tests::crowd(4));
    const VehicleId own = session.snapshot().vehicles[0].id;
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = own}, Dial::LL, -1}));
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 2}));
    EXPECT_EQ(dial(session, Dial::LL, 0), 2);
    session.undo();
    EXPECT_EQ(dial(session, Dial::LL, 0), -1);
    EXPECT_EQ(dial(session, Dial::LL, 2), 0);
}

// Two vehicles in a row: the rear one drives ahead, the front one stands.
Scene rear_and_front() {
    Scene scene = tests::crowd(0);
    scene.kinds.resize(1);
    scene.kinds[0].brain = make_graph({});
    scene.starts = {{.name = "rear", .kind = scene.kinds[0].name, .x = -3},
                    {.name = "front", .kind = scene.kinds[0].name}};
    return scene;
}

TEST(Undo, PutsARemovedVehicleBesideOneThatHasMovedToItsPose) {
    Session session = open(rear_and_front());
    ASSERT_FALSE(session.apply(RemoveVehicle{1}));
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = 0}, Dial::LM, 1}));
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = 0}, Dial::RM, 1}));
    for (int i = 0; i < 600 && session.snapshot().vehicles[0].x < -0.1f; ++i) session.step();
    ASSERT_GE(session.snapshot().vehicles[0].x, -0.1f) << "it is where the other one was";
    const Bookmark before = session.bookmark();
    for (int i = 0; i < 3; ++i) session.undo();
    const auto apart = [&] {
        const auto& v = session.snapshot().vehicles;
        return maths::distance(maths::vec2{v[0].x, v[0].y}, maths::vec2{v[1].x, v[1].y});
    };
    ASSERT_EQ(session.snapshot().vehicles.size(), 2u);
    EXPECT_GT(apart(), 0.6f);
    EXPECT_LT(apart(), 3.0f) << "the nearest free pose";
    const VehicleView restored = session.snapshot().vehicles[1];
    EXPECT_EQ(restored.heading, 0);
    const auto hash = session.hash();
    EXPECT_EQ(World::restore(session.save().checkpoint).hash(), hash);
    session.go_to(before);
    for (int i = 0; i < 3; ++i) session.undo();
    EXPECT_EQ(session.hash(), hash) << "the same pose each time";
}

TEST(Undo, PutsARemovedVehicleBackToItsPoseIfThatIsFree) {
    Session session = open(rear_and_front());
    ASSERT_FALSE(session.apply(RemoveVehicle{1}));
    for (int i = 0; i < 60; ++i) session.step();
    session.undo();
    const VehicleView& restored = session.snapshot().vehicles[1];
    EXPECT_EQ(restored.x, 0);
    EXPECT_EQ(restored.y, 0);
    ASSERT_FALSE(session.apply(MoveVehicle{0, -0.3f, 0.1f, 0}));
    ASSERT_FALSE(session.apply(RemoveVehicle{1}));
    session.undo();
    EXPECT_EQ(session.snapshot().vehicles[1].x, 0) << "in the state of the edit the undo is exact, overlap included";
}

TEST(Undo, DoesNotChangeTheDriver) {
    Session session = open(tests::crowd(4));
    ASSERT_FALSE(session.apply(ChooseDriver{0, Driver::manual}));
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 2}));
    ASSERT_FALSE(session.apply(ChooseDriver{0, Driver::brain}));
    EXPECT_EQ(session.undo_depth(), 1);
    session.undo();
    EXPECT_EQ(dial(session, Dial::LL), 0);
    EXPECT_EQ(session.snapshot().vehicles[0].driver, Driver::brain);
}

TEST(Undo, DoesNotChangeTheTime) {
    Session session = open(tests::crowd(4));
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 2});
    for (int i = 0; i < 10; ++i) session.step();
    session.undo();
    EXPECT_EQ(session.snapshot().tick, 10u);
}

TEST(Undo, OfAMoveRestoresThePose) {
    Session session = open(tests::alone({}, 1, 2, 0.5f));
    ASSERT_FALSE(session.apply(MoveVehicle{0, 5, 6, 1}));
    session.undo();
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 1);
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].heading, 0.5f);
}

TEST(Undo, OfAStartMovedInOneGestureRestoresPoseAndStart) {
    Session session = open(tests::alone({}, 1, 2, 0.5f));
    const Start before = session.snapshot().scene->starts[0];
    Start after = before;
    after.x = 5, after.y = 6, after.heading = 1;
    for (const float x : {3.0f, 4.0f, 5.0f}) ASSERT_FALSE(session.apply(MoveVehicle{0, x, 6, 1}, 7));
    ASSERT_FALSE(session.apply(EditStart{0, after}, 7));
    EXPECT_EQ(session.undo_depth(), 1);
    session.reset();
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 5) << "a new run begins at this position";
    session.undo();
    EXPECT_EQ(session.snapshot().scene->starts[0], before);
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 1);
    session.redo();
    EXPECT_EQ(session.snapshot().scene->starts[0], after);
    EXPECT_FLOAT_EQ(session.snapshot().vehicles[0].x, 5);
}

TEST(Undo, DropsRedoStepsOnANewEdit) {
    Session session = open(tests::crowd(2));
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 1});
    session.undo();
    session.apply(TurnDial{{.kind = 0}, Dial::LL, 2});
    EXPECT_EQ(session.redo_depth(), 0);
}

// The edited state of the scene and the poses, without the values that only time changes.
void expect_same(const Session& session, const Scene& scene, const Snapshot& then) {
    EXPECT_EQ(session.edited_scene(), scene);
    const Snapshot& now = session.snapshot();
    ASSERT_EQ(now.vehicles.size(), then.vehicles.size());
    for (std::size_t i = 0; i < then.vehicles.size(); ++i) {
        const VehicleView &a = now.vehicles[i], &b = then.vehicles[i];
        EXPECT_EQ(a.id, b.id);
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.start, b.start);
        EXPECT_EQ(a.driver, b.driver);
        EXPECT_EQ(a.energy, b.energy);
        EXPECT_NEAR(a.x, b.x, 1e-5);
        EXPECT_NEAR(a.y, b.y, 1e-5);
        EXPECT_NEAR(a.heading, b.heading, 1e-5);
        EXPECT_EQ(*now.brains[static_cast<std::size_t>(a.brain)], *then.brains[static_cast<std::size_t>(b.brain)]);
        EXPECT_EQ(kind_of(now, a).sensors, kind_of(then, b).sensors);
    }
    for (std::size_t i = 0; i < then.obstacles.size(); ++i) EXPECT_EQ(now.obstacles[i], then.obstacles[i]);
}

// A random edit with random numbers.
Command any_edit(const Session& session, maths::Random& chance) {
    const Snapshot& now = session.snapshot();
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : static_cast<int>(chance.next() % n); };
    const auto metres = [&] { return chance.uniform(-4, 4); };
    const VehicleId vehicle =
        now.vehicles.empty() ? 0 : now.vehicles[static_cast<std::size_t>(below(now.vehicles.size()))].id;
    const int source = below(now.sources.size()), obstacle = below(now.obstacles.size());
    const int kind = below(now.scene->kinds.size()), zone = below(now.scene->zones.size());
    const auto kinds = static_cast<int>(now.scene->kinds.size());
    switch (below(31)) {
        case 21:
            return AddZone{{.x = metres(), .length = 2, .surface = Surface::ice, .wind_y = metres()}, below(3) - 1};
        case 22:
            return RemoveZone{zone};
        case 23:
            return MoveZone{zone, metres(), metres(), 1};
        case 24:
            return EditZone{zone, {.x = metres(), .width = 3, .slope = 0.1f}};
        case 25: {
            Arena to = now.scene->arena;
            to.width = chance.uniform(11, 24), to.height = chance.uniform(11, 24), to.ambient = chance.uniform(0, 1);
            return EditArena{to};
        }
        case 26:
            return EditEcology{Ecology{.drain = chance.uniform(0, 0.1f), .inactivity = 9}};
        case 27: {
            Kind copy = now.scene->kinds[static_cast<std::size_t>(kind)];
            copy.brain = *now.kind_brains[static_cast<std::size_t>(kind)];
            copy.share = 0;
            return AddKind{copy, below(3) - 1};
        }
        case 28:
            return RemoveKind{kind};
        case 29: {
            Kind to = now.scene->kinds[static_cast<std::size_t>(kind)];
            to.name = "kind-" + std::to_string(below(9));
            to.driver = below(2) == 0 ? Driver::wander : Driver::brain;
            to.body = resized(to.body, chance.uniform(0.4f, 1.2f), 0.6f);
            to.body.mismatch = 0.1f;
            to.role = below(2) == 0 ? Role::wiring : Role::prey;
            to.colour = "#112233";
            return EditKind{kind, to};
        }
        case 30:
            return SetPopulation{std::min(kind, kinds - 1), below(9)};
        case 18: {
            const int population = now.scene->ecology.population;
            if (population == 0) return AddVehicle{};
            return EditMember{below(static_cast<std::size_t>(population)),
                              Member{.placed = true, .x = metres(), .y = metres()}};
        }
        case 19: {
            if (now.vehicles.empty()) return AddVehicle{};
            auto sensors = kind_of(now, *find_vehicle(now, vehicle)).sensors;
            sensors.push_back({.name = "own" + std::to_string(sensors.size()),
                               .channel = Channel::heat,
                               .angle = chance.uniform(-1, 1),
                               .latency = below(2) == 0 ? 0 : 0.2f});
            return SetSensors{{.vehicle = vehicle}, sensors};
        }
        case 20:
            if (below(2) == 0) return SetSensors{{.vehicle = vehicle}, {}};
            return SetSensors{{.vehicle = vehicle}, now.scene->kinds[static_cast<std::size_t>(kind)].sensors};
        case 0:
            return TurnDial{{.vehicle = vehicle}, Dial::LR, chance.uniform(-2, 2)};
        case 1:
            return TurnDial{{.kind = kind}, Dial::RL, chance.uniform(-2, 2)};
        case 2:
            return AddVehicle{};
        case 3:
            return AddVehicle{kind, Pose{metres(), metres(), 1}};
        case 4:
            return RemoveVehicle{vehicle};
        case 5:
            return MoveVehicle{vehicle, metres(), metres(), 2};
        case 6:
            return TurnDial{{.vehicle = vehicle}, Dial::LL, chance.uniform(-2, 2)};
        case 7: {
            auto sensors = now.scene->kinds[static_cast<std::size_t>(kind)].sensors;
            if (!sensors.empty()) sensors[0].range = chance.uniform(1, 9);
            return SetSensors{{.kind = kind}, sensors};
        }
        case 8:
            return AddSource{{"", Channel::heat, metres(), metres(), 0.5f, below(2) == 0}, below(3) - 1};
        case 9:
            return RemoveSource{source};
        case 10:
            return MoveSource{source, metres(), metres()};
        case 11:
            return AddObstacle{{"", metres(), metres(), 0.3f, 2, 1}, below(3) - 1};
        case 12:
            return RemoveObstacle{obstacle};
        case 13:
            return MoveObstacle{obstacle, metres(), metres(), 1};
        case 14:
            return Retitle{"scene " + std::to_string(below(100))};
        case 15:
            return PlaceNodes{{.kind = kind}, {{below(4), maths::vec2{metres(), metres()}}, {below(4), {}}}};
        case 16:
            return PlaceNodes{{.vehicle = vehicle}, {{below(4), maths::vec2{metres(), metres()}}}};
        default: {
            if (now.sources.empty()) return AddVehicle{};
            Source to = now.scene->sources[static_cast<std::size_t>(source)];
            to.strength = chance.uniform(0.1f, 1);
            return EditSource{source, to};
        }
    }
}

Scene furnished() {
    Scene scene = tests::crowd(5);
    scene.sources = {{"lamp", Channel::light, 1, 1, 1, false}, {"stove", Channel::heat, -3, 2, 1, true}};
    scene.obstacles = {{"box", 4, -4, 0.5f, 1, 2}};
    scene.zones = {{.name = "pond", .x = -2, .surface = Surface::ice}};
    scene.starts = {{"first", scene.kinds[0].name, -5, -5, 0, "lamp"}, {"second", scene.kinds[1].name, 5, 5, 1, ""}};
    return scene;
}

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
        Session session = open(furnished());
        maths::Random chance{seed, 9};
        if (seed % 2 == 0) session.step();
        for (int i = 0; i < 12; ++i) (void)session.apply(any_edit(session, chance));
        if (const auto& all = session.snapshot().vehicles; !all.empty()) {  // no edit: it cannot be undone
            ASSERT_FALSE(session.apply(ChooseDriver{all[chance.next() % all.size()].id, Driver::wander}));
        }
        const std::string text = write_scene(session.edited_scene());
        const auto saved = parse_scene(text, "saved.toml");
        ASSERT_TRUE(saved) << saved.error().text() << "\n" << text;
        Session opened = open(*saved);
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
    Session session = open(furnished());
    const VehicleId one = session.snapshot().vehicles.back().id, other = session.snapshot().vehicles.front().id;
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = one}, Dial::LR, 1.25f}));
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = other}, Dial::LR, -0.75f}));
    const Session opened = open(*parse_scene(write_scene(session.edited_scene()), "saved.toml"));
    const Snapshot& now = opened.snapshot();
    EXPECT_EQ(read_dials(*brain_of(now, *find_vehicle(now, one))).LR, 1.25f);
    EXPECT_EQ(read_dials(*brain_of(now, *find_vehicle(now, other))).LR, -0.75f);
}

TEST(Undo, RevertsAndRepeatsEveryCommand) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Session session = open(furnished());
        maths::Random chance{seed, 4};
        for (int i = 0; i < 40; ++i) session.step();
        const Scene scene = session.edited_scene();
        const Snapshot before = session.snapshot();
        for (int i = 0; i < 25; ++i) (void)session.apply(any_edit(session, chance));
        ASSERT_GT(session.undo_depth(), 10);
        const Scene edited = session.edited_scene();
        const Snapshot after = session.snapshot();
        while (session.undo()) {
        }
        expect_same(session, scene, before);
        while (session.redo()) {
        }
        expect_same(session, edited, after);
    }
}

TEST(Session, GoesBackToAnyTickOfTheLastMinuteAndReplaysExactly) {
    Session session = open(furnished());
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
        for (int more = 1; more < 90 && tick + more < hashes.size(); ++more) {
            session.step();
            ASSERT_EQ(session.hash(), hashes[tick + static_cast<std::uint64_t>(more)]);
        }
        EXPECT_EQ(session.latest(), end);
    }
}

TEST(Session, AnEditInThePastChangesTheRun) {
    Session session = open(furnished());
    for (int i = 0; i < 700; ++i) session.step();
    const auto hash = session.hash();
    session.seek(350);
    ASSERT_FALSE(session.apply(TurnDial{{.kind = 0}, Dial::LL, 2}));
    EXPECT_EQ(session.latest(), 350u);
    while (session.snapshot().tick < 700) session.step();
    EXPECT_NE(session.hash(), hash);
}

std::optional<maths::vec2> place_of(const Session& session, NodeId node, std::size_t vehicle = 0) {
    const Snapshot& now = session.snapshot();
    return find_node(*now.brains[static_cast<std::size_t>(now.vehicles[vehicle].brain)], node)->place;
}

TEST(CosmeticEdits, OfNodesAreUndoneLikeOtherEdits) {
    Session session = open(tests::crowd(4));
    const int kind = session.snapshot().vehicles[0].kind;
    ASSERT_FALSE(session.apply(PlaceNodes{{.vehicle = session.snapshot().vehicles[0].id}, {{1, maths::vec2{5, 6}}}}));
    ASSERT_FALSE(session.apply(PlaceNodes{{.kind = kind}, {{0, maths::vec2{1, 2}}, {99, maths::vec2{}}}}));
    EXPECT_EQ(session.undo_depth(), 2);
    EXPECT_EQ(place_of(session, 0), (maths::vec2{1, 2}));
    EXPECT_EQ(place_of(session, 1), (maths::vec2{5, 6})) << "the position in the brain of the vehicle is kept";
    EXPECT_EQ(session.edited_scene().kinds[static_cast<std::size_t>(kind)].brain.nodes[0].place, (maths::vec2{1, 2}));
    session.undo();
    EXPECT_EQ(place_of(session, 0), std::nullopt);
    EXPECT_EQ(place_of(session, 1), (maths::vec2{5, 6}));
    session.undo();
    EXPECT_EQ(place_of(session, 1), std::nullopt);
    session.redo(), session.redo();
    EXPECT_EQ(place_of(session, 0), (maths::vec2{1, 2}));
    session.reset();
    EXPECT_EQ(place_of(session, 0), (maths::vec2{1, 2})) << "a reset keeps it like every edit";
}

TEST(CosmeticEdits, OutsideTheCanvasAndForAMissingVehicleAreRefused) {
    Session session = open(tests::crowd(2));
    EXPECT_TRUE(session.apply(PlaceNodes{{.kind = 0}, {{0, maths::vec2{0, 100001}}}}));
    EXPECT_TRUE(session.apply(PlaceNodes{{.kind = 0}, {{0, maths::vec2{std::nanf(""), 0}}}}));
    EXPECT_TRUE(session.apply(PlaceNodes{{.kind = 99}, {}}));
    EXPECT_TRUE(session.apply(PlaceNodes{{.vehicle = 99}, {}}));
    EXPECT_EQ(session.undo_depth(), 0);
}

TEST(CosmeticEdits, OfNodesDoNotChangeTheRun) {
    Scene scene = furnished();
    scene.kinds[0].brain.nodes.push_back({.id = 9, .name = "N", .time_constant = 2});
    scene.kinds[0].brain.wires.push_back({.from = 0, .to = 9});
    Session plain = open(scene), moved = open(scene);
    const auto run = [&](int ticks) {
        for (int i = 0; i < ticks; ++i) plain.step(), moved.step();
    };
    run(140);
    const auto neurons = moved.snapshot().neurons;
    for (std::size_t i = 0; i < 2 * keyframe_commands; ++i)
        ASSERT_FALSE(moved.apply(PlaceNodes{{.kind = 0}, {{9, maths::vec2{static_cast<float>(i), 3}}}}));
    EXPECT_EQ(moved.hash(), plain.hash());
    EXPECT_EQ(moved.snapshot().neurons.size(), neurons.size());
    for (Session* session : {&plain, &moved}) ASSERT_FALSE(session->apply(TurnDial{{.kind = 0}, Dial::LL, 1}));
    EXPECT_EQ(moved.bookmark().checkpoint.keyframe_tick, 0u) << "the edits make no keyframe: the world is not rebuilt";
    run(500);
    EXPECT_EQ(moved.hash(), plain.hash());
    moved.seek(200);
    EXPECT_EQ(place_of(moved, 9), (maths::vec2{2 * keyframe_commands - 1, 3}));
}

TEST(CosmeticEdits, InThePastKeepTheRecordedFuture) {
    Session session = open(furnished());
    for (int i = 0; i < 500; ++i) session.step();
    BrainGraph rewired = *session.snapshot().kind_brains[0];
    rewired.wires[0].weight = -1;
    ASSERT_FALSE(session.apply(SetBrain{{.kind = 0}, rewired}));
    for (int i = 500; i < 700; ++i) session.step();
    const auto hash = session.hash();
    session.seek(350);
    const PlaceNodes move{{.kind = 0}, {{2, maths::vec2{70, 80}}}};
    ASSERT_FALSE(session.apply(move));
    EXPECT_EQ(session.latest(), 700u);
    EXPECT_FALSE(session.undo_brings_time_back());
    while (session.snapshot().tick < 700) {
        session.step();
        ASSERT_EQ(place_of(session, 2), (maths::vec2{70, 80})) << session.snapshot().tick;
    }
    EXPECT_EQ(session.hash(), hash);
    EXPECT_EQ(session.undo_depth(), 2);
    session.seek(340);
    EXPECT_EQ(place_of(session, 2), std::nullopt);
    EXPECT_EQ(session.undo_depth(), 0);
    session.seek(650);
    EXPECT_EQ(place_of(session, 2), (maths::vec2{70, 80})) << "later keyframes have it too";
    session.seek(350);
    EXPECT_EQ(session.undo_depth(), 1);
    session.undo();
    EXPECT_EQ(place_of(session, 2), std::nullopt);
    session.seek(700);
    EXPECT_EQ(session.hash(), hash);
    EXPECT_EQ(place_of(session, 2), std::nullopt);
    EXPECT_EQ(session.undo_depth(), 1);
    session.seek(350);
    session.redo();
    session.seek(700);
    EXPECT_EQ(place_of(session, 2), (maths::vec2{70, 80}));
    EXPECT_EQ(session.undo_depth(), 2);
}

TEST(Session, TimeDroppedByAnEditInThePastIsRestoredByUndo) {
    Session session = open(furnished());
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
    Session session = open(furnished());
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
    Session session = open(furnished());
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
    Session session = open(furnished());
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
    Session session = open(scene);
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

TEST(Undo, LeavesOutCommandsForVehiclesThatHaveDiedWithoutAnError) {
    Scene scene = tests::alone({});
    scene.ecology.drain = 1;
    Session session = open(scene);
    ASSERT_FALSE(session.apply(TurnDial{{.vehicle = 0}, Dial::LL, 1.5f}));
    for (int i = 0; i < 70; ++i) session.step();
    ASSERT_FALSE(find_vehicle(session.snapshot(), 0));
    const UndoResult undone = session.undo(), redone = session.redo();
    EXPECT_TRUE(undone.done && redone.done);
    EXPECT_FALSE(undone.error) << undone.error->text();
    EXPECT_FALSE(redone.error);
}

int count_of(const Session& session, int kind) {
    const auto& all = session.snapshot().vehicles;
    return static_cast<int>(
        std::count_if(all.begin(), all.end(), [kind](const VehicleView& v) { return v.kind == kind; }));
}

TEST(Undo, OfAPopulationRestoresItAfterAResetThatRenumbersItsVehicles) {
    Session session = open(tests::crowd(4));
    ASSERT_FALSE(session.apply(AddVehicle{0, Pose{3, -2, 1}}));
    ASSERT_FALSE(session.apply(SetPopulation{0, 5}));
    session.reset();
    ASSERT_EQ(session.snapshot().vehicles.front().start, 0) << "the vehicle with a start has the smallest id now";
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(count_of(session, 0), 3);
    EXPECT_EQ(count_of(session, 1), 2);
}

// One hunted vehicle with id 1 and one hunter with id 2, which has a brain of its own.
Session with_own_brain_of_last() {
    Session session = open(tests::crowd(2));
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
    Session session = open(furnished());
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
    Session session = open(furnished());
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
    Session session = open(furnished());
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
    Session session = open(tests::crowd(6)), fresh = open(tests::crowd(6));
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

TEST(CosmeticEdits, OfATitleInThePastKeepTheRecordedFuture) {
    Session session = open(furnished());
    for (int i = 0; i < 650; ++i) session.step();
    const auto hash = session.hash();
    session.seek(310);
    ASSERT_FALSE(session.apply(Retitle{"renamed"}));
    EXPECT_EQ(session.latest(), 650u);
    EXPECT_FALSE(session.undo_brings_time_back());
    while (session.snapshot().tick < 650) {
        session.step();
        ASSERT_EQ(session.snapshot().scene->title, "renamed") << session.snapshot().tick;
    }
    EXPECT_EQ(session.hash(), hash);
    session.seek(620);
    EXPECT_EQ(session.snapshot().scene->title, "renamed");
    EXPECT_TRUE(session.undo());
    EXPECT_NE(session.snapshot().scene->title, "renamed");
    EXPECT_EQ(session.latest(), 650u);
}

TEST(CosmeticEdits, OfATitleInThePastReplaceALaterTitle) {
    Session session = open(furnished());
    for (int i = 0; i < 100; ++i) session.step();
    ASSERT_FALSE(session.apply(Retitle{"later"}));
    for (int i = 0; i < 100; ++i) session.step();
    session.seek(50);
    ASSERT_FALSE(session.apply(Retitle{"renamed"}));
    session.seek(200);
    EXPECT_EQ(session.snapshot().scene->title, "renamed");
}

TEST(CosmeticEdits, OfAStoryKeepTheTitleAndTheRecordedFuture) {
    Session session = open(furnished());
    const auto texts = [&] { return Retitle{session.snapshot().scene->title, session.snapshot().scene->story}; };
    const Retitle first = texts();
    for (int i = 0; i < 650; ++i) session.step();
    const auto hash = session.hash();
    session.seek(310);
    ASSERT_FALSE(session.apply(Retitle{.story = "It turns."}));
    const Retitle told{first.title, "It turns."};
    EXPECT_EQ(texts(), told);
    EXPECT_EQ(session.latest(), 650u);
    session.seek(650);
    EXPECT_EQ(texts(), told);
    EXPECT_EQ(session.hash(), hash);
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(texts(), first);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(texts(), told);
}

TEST(CosmeticEdits, OfAStoryInThePastReplaceALaterStoryButNoLaterTitle) {
    Session session = open(furnished());
    for (int i = 0; i < 100; ++i) session.step();
    ASSERT_FALSE(session.apply(Retitle{"later", "Later."}));
    for (int i = 0; i < 10; ++i) session.step();
    session.seek(50);
    ASSERT_FALSE(session.apply(Retitle{.story = "It turns."}));
    session.seek(110);
    EXPECT_EQ(session.snapshot().scene->story, "It turns.");
    EXPECT_EQ(session.snapshot().scene->title, "later");
}

TEST(CosmeticEdits, OfTitleAndStoryInOneGestureAreUndoneTogether) {
    Session session = open(furnished());
    const Scene before = *session.snapshot().scene;
    ASSERT_FALSE(session.apply(Retitle{"renamed"}, 7));
    ASSERT_FALSE(session.apply(Retitle{.story = "It turns."}, 7));
    EXPECT_TRUE(session.undo());
    EXPECT_EQ(*session.snapshot().scene, before);
    EXPECT_TRUE(session.redo());
    EXPECT_EQ(session.snapshot().scene->title, "renamed");
    EXPECT_EQ(session.snapshot().scene->story, "It turns.");
}

TEST(Session, ReplayVisitsTheRecordedTicksWithoutChangingTheSession) {
    Session session = open(furnished());
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
