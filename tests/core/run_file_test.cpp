#include "core/io/run_file.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "core/io/json.h"
#include "core/maths/random.h"
#include "core/scene/scene_file.h"
#include "core/session/session.h"
#include "core/world/state.h"
#include "core/world/world.h"
#include "tests/core/scenes.h"
#include "tests/tells.h"

namespace braitenlab::tests::run_file_test {
namespace {

void steps(World& world, int count) {
    for (int i = 0; i < count; ++i) world.step();
}

// A run with every type of command.
Session busy_session(const Scene& scene, int ticks) {
    Session session = std::move(*Session::open(scene, 3));
    for (int i = 0; i < ticks; ++i) session.step();
    Source stove{"", Channel::heat, 2, 2, 1, true};
    (void)session.apply(TurnDial{{.kind = 0}, Dial::LL, 1.5f});
    (void)session.apply(AddVehicle{});
    (void)session.apply(AddVehicle{0, Pose{1, 2, 3}});
    (void)session.apply(RemoveVehicle{0});
    session.undo();
    (void)session.apply(MoveVehicle{1, 1, 2, 0.5f});
    (void)session.apply(ChooseDriver{1, Driver::manual});
    (void)session.apply(Steer{1, 0.5f, 1});
    (void)session.apply(AddSource{stove});
    stove.strength = 0.5f;
    (void)session.apply(EditSource{0, stove});
    (void)session.apply(MoveSource{0, 1, 3});
    (void)session.apply(AddObstacle{{"", -2, -2, 0.3f, 2, 1}});
    (void)session.apply(MoveObstacle{0, -3, -2, 0.3f});
    (void)session.apply(EditObstacle{0, {"", -3, -2, 0, 1, 1, {{-1, -1}, {1, -1}, {0, 1}}, 5}});
    const Zone pond{.x = 2, .surface = Surface::ice, .wind_x = 3, .corners = {{-1, -1}, {1, -1}, {0, 1}}};
    (void)session.apply(AddZone{pond});
    (void)session.apply(AddZone{{.length = 9}, 0});
    (void)session.apply(MoveZone{1, 1, 2, 0.5f});
    (void)session.apply(EditZone{1, pond});
    (void)session.apply(RemoveZone{0});
    (void)session.apply(SetSensors{{.kind = 0}, session.snapshot().scene->kinds[0].sensors});
    (void)session.apply(SetSensors{{.vehicle = 1}, {{.name = "own", .channel = Channel::heat, .latency = 0.1f}}});
    (void)session.apply(SetBrain{{.kind = 0}, *session.snapshot().kind_brains[0]});
    (void)session.apply(PlaceNodes{{.kind = 0}, {{0, maths::vec2{1, 2.5f}}, {1, {}}}});
    for (int i = 0; i < 40; ++i) session.step();
    (void)session.apply(RemoveSource{0});
    (void)session.apply(RemoveObstacle{0});
    (void)session.apply(NewPopulation{});
    for (int i = 0; i < 30; ++i) session.step();
    return session;
}

TEST(RunFile, KeepsCommandsThatChangeOnlyTheTitleOrOnlyTheStory) {
    Session session = std::move(*Session::open(*load_scene(tests::shipped_scenes().front()), 3));
    const Scene before = session.scene();
    for (const Retitle& texts : {Retitle{"Mine"}, Retitle{.story = "It turns."}}) {
        ASSERT_FALSE(session.apply(texts));
        const auto run = io::read_run(io::write_run(session.save()), "a.run");
        ASSERT_TRUE(run) << run.error().text();
        const Scene after = *Session::resume(*run).snapshot().scene;
        EXPECT_EQ(after.title, "Mine");
        EXPECT_EQ(after.story, texts.story.value_or(before.story));
    }
}

TEST(RunFile, ContinuesTheSavedRunExactlyInEveryShippedScene) {
    for (const auto& path : tests::shipped_scenes()) {
        for (const int ticks : {10, 290, 777}) {
            Session session = busy_session(*load_scene(path), ticks);
            auto run = io::read_run(io::write_run(session.save()), "a.run");
            ASSERT_TRUE(run) << path << ": " << run.error().text();
            Session resumed = Session::resume(std::move(*run));
            EXPECT_EQ(resumed.hash(), session.hash()) << path;
            for (int i = 0; i < 700; ++i) session.step(), resumed.step();
            EXPECT_EQ(resumed.hash(), session.hash()) << path;
            session.reset();
            resumed.reset();
            EXPECT_EQ(resumed.hash(), session.hash()) << path;
        }
    }
}

TEST(RunFile, KeepsARunOfHours) {
    const Scene scene = tests::alone({.LM = -0.7f, .RM = 0.7f});
    Session young = std::move(*Session::open(scene, 3));
    for (int i = 0; i < 1000; ++i) young.step();
    SavedRun aged = young.save();
    auto state = std::make_shared<world::State>(*aged.checkpoint.keyframe);
    state->tick = aged.checkpoint.keyframe_tick = 10'000'200, aged.checkpoint.tick = 10'000'300;
    state->vehicles.motion[0] = mechanics::at_rest({}, 1e6f);
    aged.checkpoint.keyframe = std::move(state);
    Session session = Session::resume(aged);
    for (int i = 0; i < 700; ++i) session.step();
    const auto run = io::read_run(io::write_run(session.save()), "a.run");
    ASSERT_TRUE(run) << run.error().text();
    Session resumed = Session::resume(*run);
    for (int i = 0; i < 700; ++i) session.step(), resumed.step();
    EXPECT_EQ(resumed.hash(), session.hash());
}

TEST(RunFile, KeepsTheBuffersOfSlowSensors) {
    Scene scene = tests::crowd(12);
    for (Kind& kind : scene.kinds) kind.sensors[0].latency = 0.5f, kind.sensors[1].noise = 0.1f;
    Session session = std::move(*Session::open(scene, 3));
    for (int i = 0; i < 400; ++i) session.step();
    auto run = io::read_run(io::write_run(session.save()), "a.run");
    ASSERT_TRUE(run) << run.error().text();
    Session resumed = Session::resume(std::move(*run));
    for (int i = 0; i < 100; ++i) session.step(), resumed.step();
    EXPECT_EQ(resumed.hash(), session.hash());
}

TEST(RunFile, WritesTheSameTextAgain) {
    const std::string text = io::write_run(busy_session(tests::crowd(6), 400).save());
    EXPECT_EQ(io::write_run(*io::read_run(text, "a.run")), text);
}

TEST(RunFile, KeepsStrikes) {
    Scene scene = tests::alone({.LM = 1, .RM = 1});
    scene.arena.width = scene.arena.height = 4;
    Session session = std::move(*Session::open(scene, 3));
    for (int i = 0; i < 600 && session.snapshot().strikes.empty(); ++i) session.step();
    ASSERT_FALSE(session.snapshot().strikes.empty());
    const auto kept = io::read_run(io::write_run(session.save()), "a.run");
    ASSERT_TRUE(kept) << kept.error().text();
    EXPECT_EQ(Session::resume(*kept).snapshot().strikes.size(), session.snapshot().strikes.size());
    EXPECT_EQ(Session::resume(*kept).hash(), session.hash());
}

TEST(RunFile, ReadsANumberOfAKindWithoutASizeOfThePopulation) {
    Json json = Command(SetPopulation{0, 3, {}, {1, 1}, 9});
    EXPECT_EQ(std::get<SetPopulation>(json.get<Command>()), (SetPopulation{0, 3, {}, {1, 1}, 9}));
    json["SetPopulation"].erase("population");
    const auto command = json.get<Command>();
    Session session = std::move(*Session::open(tests::crowd(6), 1));
    ASSERT_FALSE(session.apply(command));
    EXPECT_EQ(session.snapshot().scene->ecology.population, 6);
}

TEST(RunFile, ASceneWithAHiddenBrainIsSealedAndComesBack) {
    Scene scene = tests::alone({.LL = 1.2345f});
    scene.kinds[0].hidden = true;
    Session session = std::move(*Session::open(scene, 3));
    for (int i = 0; i < 400; ++i) session.step();
    std::string text = io::write_run(session.save());
    EXPECT_EQ(text.find("1.2345"), std::string::npos);
    EXPECT_EQ(text.find("wires"), std::string::npos);
    const auto read = io::read_run(text, "a.run");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(Session::resume(*read).hash(), session.hash());
    EXPECT_TRUE(read->opened.kinds[0].hidden) << "a run that is opened hides it, too";
    EXPECT_TRUE(read->checkpoint.keyframe->scene->kinds[0].hidden);
    const std::size_t letter = text.find("sealed") + 40;
    text[letter] = text[letter] == 'a' ? 'b' : 'a';
    const auto damaged = io::read_run(text, "a.run");
    ASSERT_FALSE(damaged);
    EXPECT_TRUE(tells(damaged.error(), message_of("sealed_damaged")));
}

TEST(RunFile, RefusesVehiclesAndObstaclesThatAreAllInOnePlace) {
    Scene scene = crowd(120);
    scene.arena.width = scene.arena.height = 60;
    for (Kind& kind : scene.kinds)
        for (Sensor& sensor : kind.sensors) sensor.range = 1;
    for (int i = 0; i < 400; ++i)
        scene.obstacles.push_back({.name = "o" + std::to_string(i),
                                   .x = static_cast<float>(i % 20) * 2 - 20,
                                   .y = static_cast<float>(i / 20) * 2 - 20,
                                   .length = 0.1f,
                                   .width = 0.1f,
                                   .mass = 1});
    const std::string text = io::write_run(Session::open(scene, 3)->save());
    ASSERT_TRUE(io::read_run(text, "a.run"));
    const auto piled = [&](auto change) {
        auto file = io::Json::parse(text);
        change(file["keyframe"]);
        const auto run = io::read_run(file.dump(), "a.run");
        return run ? "read" : run.error().text();
    };
    const auto in_one_place = [](auto& motions) {
        for (auto& motion : motions) motion["place"] = {0, 0};
    };
    EXPECT_NE(piled([&](auto& state) { in_one_place(state["vehicles"]["motion"]); }).find("vehicles"),
              std::string::npos);
    EXPECT_NE(piled([&](auto& state) { in_one_place(state["obstacles"]); }).find("obstacles"), std::string::npos);
}

TEST(RunFile, RefusesAStateWhoseTickWouldTakeTooLong) {
    Scene scene = crowd(7000);
    scene.arena.width = scene.arena.height = 300;
    for (Kind& kind : scene.kinds)
        for (Sensor& sensor : kind.sensors) sensor.channel = Channel::vehicle, sensor.range = 1;
    const SavedRun sound = Session::open(scene, 3)->save();
    const auto refusal = [&](auto change) {
        SavedRun run = sound;
        world::State state = *run.checkpoint.keyframe;
        change(state);
        run.checkpoint.keyframe = std::make_shared<const world::State>(std::move(state));
        const auto read = io::read_run(io::write_run(run), "a.run");
        return read ? "read" : read.error().text();
    };
    EXPECT_EQ(refusal([](world::State&) {}), "read");
    const auto far_sight_of_few = [&](world::State& state) {
        Scene few = scene;
        few.ecology.population = 1;
        for (Kind& kind : few.kinds)
            for (Sensor& sensor : kind.sensors) sensor.range = 100;
        state.scene = std::make_shared<const Scene>(few);
    };
    EXPECT_NE(refusal(far_sight_of_few).find("a tick of 7000 vehicles"), std::string::npos);
    const auto large_brains = [](world::State& state) {
        const Kind& kind = state.scene->kinds[0];
        BrainGraph brain = kind.brain;
        for (NodeId id = 100; id < 1100; ++id)
            brain.nodes.push_back({.id = id, .kind = NodeKind::neuron, .name = "n" + std::to_string(id)}),
                brain.wires.push_back({.from = id, .to = id});
        state.kind_brains[0] = *world::compile_brain(brain, kind);
    };
    EXPECT_NE(refusal(large_brains).find("a tick of 7000 vehicles"), std::string::npos);
}

TEST(RunFile, RefusesAFileOfAnotherKind) {
    for (const char* text :
         {"", "format = 1", "{}", "[]", "{\"braitenlab_run\": 2}", "{\"braitenlab_run\": 1}", "\xff"}) {
        const auto run = io::read_run(text, "a.run");
        ASSERT_FALSE(run) << text;
        EXPECT_EQ(run.error().text().rfind("a.run: is no saved run", 0), 0u) << run.error().text();
    }
    EXPECT_FALSE(io::load_run("/nowhere/a.run"));
}

TEST(RunFile, NamesTheFormatOfAFileOfAnotherProgram) {
    const auto run = io::read_run("PK\x03\x04", "a.run");
    ASSERT_FALSE(run);
    EXPECT_NE(run.error().what.find("this is a file of the format ZIP"), std::string::npos) << run.error().text();
}

TEST(RunFile, RefusesNumbersThatOneMoreStepWouldOverflow) {
    const auto good = io::Json::parse(io::write_run(busy_session(tests::crowd(4), 20).save()));
    ASSERT_TRUE(io::read_run(good.dump(), "a.run"));
    for (const char* place :
         {"/keyframe/generation", "/keyframe/next_id", "/keyframe/events/captures", "/keyframe/events/falls"}) {
        io::Json file = good;
        auto& number = file[io::Json::json_pointer(place)];
        ASSERT_TRUE(number.is_number_integer()) << place;
        number = std::string(place).find("events") == std::string::npos ? std::numeric_limits<std::int32_t>::max()
                                                                        : std::numeric_limits<std::int64_t>::max();
        EXPECT_FALSE(io::read_run(file.dump(), "a.run")) << place;
    }
}

TEST(RunFile, RefusesDeepNestingAndLargeNumbers) {
    EXPECT_FALSE(io::read_run(std::string(1000000, '['), "a.run"));
    EXPECT_FALSE(io::read_run("{\"braitenlab_run\": 1, \"tick\": 1e300}", "a.run"));
}

// Swaps, removes and repeats parts and digits of a valid file: the reader refuses the result, or it runs.
TEST(RunFile, RefusesOrAcceptsMutatedFilesWithoutACrash) {
    const std::string good = io::write_run(busy_session(tests::crowd(4), 20).save());
    maths::Random chance{5, 1};
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(chance.next()) % n; };
    int accepted = 0;
    for (int round = 0; round < 1000; ++round) {
        std::string text = good;
        const std::size_t at = below(text.size());
        switch (below(5)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, below(40));
                break;
            case 2:
                text.insert(at, text.substr(below(text.size()), below(40)));
                break;
            case 3: {
                const std::size_t digit = text.find_first_of("0123456789", at);
                if (digit != std::string::npos) text[digit] = static_cast<char>('0' + below(10));
                break;
            }
            default: {
                const std::size_t digit = text.find_first_of("0123456789", at);
                if (digit != std::string::npos) text.insert(digit, "-");
            }
        }
        auto run = io::read_run(text, "a.run");
        if (!run) continue;
        ++accepted;
        World world = World::restore(run->checkpoint);
        steps(world, 5);
    }
    EXPECT_GT(accepted, 20);
}

}  // namespace
}  // namespace braitenlab::tests::run_file_test
