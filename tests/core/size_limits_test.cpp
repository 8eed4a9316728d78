#include "core/scene/size_limits.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/io/run_file.h"
#include "core/scene/check.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "tests/core/sessions.h"

namespace braitenlab::tests::size_limits_test {
namespace {

Scene crowd_of(int population, float side, std::vector<Sensor> sensors = {}) {
    Scene scene;
    scene.arena.width = scene.arena.height = side;
    scene.kinds = {two_eyed("k", {.LM = 0.9f, .RM = 1})};
    scene.kinds[0].sensors = std::move(sensors);
    scene.kinds[0].brain = make_graph({.LM = 0.9f, .RM = 1});
    scene.ecology.population = population;
    return scene;
}

std::vector<Sensor> eyes(int count, Channel channel, SensorResponse response = SensorResponse::graded) {
    std::vector<Sensor> all;
    for (int i = 0; i < count; ++i)
        all.push_back({.name = fmt::format("S{}", i),
                       .channel = channel,
                       .response = response,
                       .fov = 2 * maths::pi,
                       .range = 100});
    return all;
}

std::vector<PolygonCorner> octagon(float radius) {
    std::vector<PolygonCorner> corners;
    for (int i = 0; i < 8; ++i) {
        const maths::vec2 at = maths::from_polar(radius, maths::pi / 4 * static_cast<float>(i));
        corners.push_back({at.x, at.y});
    }
    return corners;
}

Scene with_lamps(Scene scene, int count, Channel channel = Channel::light, bool solid = false) {
    for (int i = 0; i < count; ++i)
        scene.sources.push_back({.name = fmt::format("s{}", i),
                                 .channel = channel,
                                 .x = static_cast<float>(i % 30),
                                 .y = static_cast<float>(i / 30),
                                 .solid = solid});
    return scene;
}

// On a circle around the middle; all in one place if its radius is 0.
Scene with_obstacles(Scene scene, int count, float circle, float radius, float mass = 0) {
    for (int i = 0; i < count; ++i) {
        const maths::vec2 at = maths::from_polar(circle, static_cast<float>(i));
        scene.obstacles.push_back(
            {.name = fmt::format("o{}", i), .x = at.x, .y = at.y, .corners = octagon(radius), .mass = mass});
    }
    return scene;
}

// Boxes that vehicles can push, apart from each other.
Scene with_boxes(Scene scene, int count, float side) {
    for (int i = 0; i < count; ++i)
        scene.obstacles.push_back({.name = fmt::format("box{}", i),
                                   .x = static_cast<float>(i % 40) * 2 - 40,
                                   .y = static_cast<float>(i / 40) * 2 - 40,
                                   .length = side,
                                   .width = side,
                                   .mass = 1});
    return scene;
}

Scene with_zones(Scene scene, int count) {
    for (int i = 0; i < count; ++i)
        scene.zones.push_back({.name = fmt::format("z{}", i),
                               .surface = Surface::ice,
                               .recharge = 0.1f,
                               .slope = 0.1f,
                               .corners = octagon(300)});
    return scene;
}

Scene with_neurons(Scene scene, int count, int wires_each) {
    BrainGraph& brain = scene.kinds[0].brain;
    const auto first = static_cast<NodeId>(brain.nodes.size());
    for (int i = 0; i < count; ++i)
        brain.nodes.push_back({.id = first + i,
                               .kind = NodeKind::neuron,
                               .name = fmt::format("n{}", i),
                               .curve = {.response = Response::sigmoid}});
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < wires_each; ++j)
            brain.wires.push_back({.from = first + i, .to = first + j, .weight = 0.1f});
    return scene;
}

Scene on_torus(Scene scene) {
    scene.arena.edge = Boundary::torus;
    return scene;
}

Scene with_wide_wheels(Scene scene) {
    Body& body = scene.kinds[0].body;
    body.length = body.width = 0.1f;
    for (Wheel& wheel : body.wheels) wheel.x *= 20, wheel.y *= 20, wheel.radius = wheel.width = 2;
    return scene;
}

Scene of_small_robots(Scene scene) {
    scene.kinds[0].body = resized(scene.kinds[0].body, 0.05f, 0.05f);
    return scene;
}

Scene with_new_generations(Scene scene, float inactivity) {
    scene.ecology.inactivity = inactivity;
    return scene;
}

// So many on each square metre.
Scene placed_in_each_other(Scene scene, int of_square) {
    const int squares = static_cast<int>(std::sqrt(scene.ecology.population / of_square));
    for (int i = 0; i < scene.ecology.population; ++i) {
        Member& member = scene.members.emplace_back(Member{.name = std::to_string(i), .placed = true});
        member.x = static_cast<float>(i / of_square % squares), member.y = static_cast<float>(i / of_square / squares);
    }
    return scene;
}

// Scenes that consist of one kind of work.
std::map<std::string, Scene> costly_scenes() {
    return {{"vehicles", crowd_of(3000, 200)},
            {"new generations", with_new_generations(crowd_of(3000, 200), 0.01f)},
            {"a full floor", crowd_of(2000, 38)},
            {"a full floor of small robots", of_small_robots(crowd_of(400, 1.3f))},
            {"wheels over other vehicles", with_wide_wheels(crowd_of(200, 20))},
            {"eyes across seams", on_torus(crowd_of(1000, 200, eyes(1, Channel::vehicle)))},
            {"photocells", with_lamps(crowd_of(500, 100, eyes(1, Channel::light, SensorResponse::photocell)), 1000)},
            {"obstacles", with_obstacles(crowd_of(1000, 100, eyes(1, Channel::obstacle)), 60, 40, 1)},
            {"posts", with_lamps(crowd_of(200, 100, eyes(1, Channel::obstacle)), 300, Channel::light, true)},
            {"the floor", with_zones(crowd_of(200, 100, eyes(16, Channel::floor)), 60)},
            {"zones", with_zones(crowd_of(500, 100), 60)},
            {"neurons", with_neurons(crowd_of(500, 200), 200, 0)},
            {"wires", with_neurons(crowd_of(500, 200), 40, 40)},
            {"vehicles in obstacles", with_obstacles(crowd_of(150, 60), 60, 0, 40)},
            {"obstacles in each other", with_obstacles(crowd_of(1, 60), 120, 0, 5, 1)},
            {"fixed obstacles in each other", with_obstacles(crowd_of(1, 60), 2000, 20, 1)},
            {"wheels in obstacles", with_obstacles(with_wide_wheels(crowd_of(1, 60)), 1000, 0, 20)},
            {"vehicles in each other", placed_in_each_other(crowd_of(500, 200), 8)},
            {"many vehicles in each other", placed_in_each_other(crowd_of(300, 200), 30)}};
}

// Processor time of the first ticks for the work of one comparison; the least of two worlds.
double time_of_a_comparison(const Scene& scene) {
    constexpr int ticks = 3;
    double least = 1e30;
    for (int attempt = 0; attempt < 2; ++attempt) {
        auto world = World::create(scene, 1);
        EXPECT_TRUE(world) << world.error().text();
        if (!world) return 0;
        const auto began = std::clock();
        for (int i = 0; i < ticks; ++i) world->step();
        least = std::min(least, static_cast<double>(std::clock() - began) / ticks);
    }
    return least / work_of_a_tick(scene);
}

TEST(SizeLimits, CountWhatATickCosts) {
#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
    GTEST_SKIP() << "a sanitizer slows some work more than other";
#endif
#endif
    // That of a sensor and a stimulus, which most crowds consist of. Functions of headers are not optimised here.
    constexpr double most = 2.5;
    const Scene usual = crowd_of(2000, 200, eyes(1, Channel::vehicle));
    for (const auto& [name, scene] : costly_scenes()) {
        double ratio = 0;
        for (int attempt = 0; attempt < 3 && (attempt == 0 || ratio > most); ++attempt)
            ratio = time_of_a_comparison(scene) / time_of_a_comparison(usual);
        EXPECT_LT(ratio, most) << name;
    }
}

TEST(SizeLimits, AreFarFromTheWorkOfShippedScenes) {
    for (const auto& path : shipped_scenes()) {
        const auto scene = load_scene(path);
        ASSERT_TRUE(scene) << scene.error().text();
        EXPECT_LT(work_of_a_tick(*scene), 4e6) << path;
    }
}

TEST(SizeLimits, AllowLargeCrowds) {
    Scene scene = crowd(20000);  // as the benchmark: constant density, two eyes
    scene.arena.width = scene.arena.height = 283;
    for (Kind& kind : scene.kinds)
        for (Sensor& sensor : kind.sensors) sensor.range = 6, sensor.fov = maths::radians(60);
    EXPECT_EQ(find_fault(scene), std::nullopt);
    EXPECT_EQ(find_fault(with_lamps(crowd_of(2000, 120, eyes(2, Channel::light)), 1)), std::nullopt);
}

TEST(SizeLimits, RefuseScenesThatFreezeTheWindow) {
    const auto is_refused = [](const Scene& scene) { return find_fault(scene).has_value(); };
    EXPECT_TRUE(is_refused(crowd_of(20000, 400, eyes(1, Channel::vehicle))));
    EXPECT_TRUE(is_refused(crowd_of(20000, 119))) << "a full floor";
    EXPECT_FALSE(is_refused(with_obstacles(crowd_of(1, 60), 2500, 0, 1)));
    EXPECT_TRUE(is_refused(with_obstacles(crowd_of(1, 60), 4000, 0, 1))) << "4,000 in one place: 0.2 s";
    EXPECT_FALSE(is_refused(with_obstacles(crowd_of(1, 60), 4000, 1e3f, 1)));
    EXPECT_FALSE(is_refused(with_new_generations(crowd_of(18000, 200), 5)));
    EXPECT_TRUE(is_refused(with_new_generations(crowd_of(18000, 200), 0.01f)))
        << "18,000 vehicles are made in each tick";
    Scene wheels = with_wide_wheels(crowd_of(1, 60));
    EXPECT_FALSE(is_refused(with_obstacles(wheels, 1000, 0, 20)));
    wheels.kinds[0].body.wheels.resize(16, wheels.kinds[0].body.wheels[0]);
    EXPECT_TRUE(is_refused(with_obstacles(wheels, 1000, 0, 20))) << "16 wheels in 1,000 obstacles: 0.4 s";
    EXPECT_FALSE(is_refused(placed_in_each_other(crowd_of(8000, 200), 2)));
    EXPECT_TRUE(is_refused(placed_in_each_other(crowd_of(8000, 200), 8))) << "0.3 s";
    EXPECT_FALSE(is_refused(placed_in_each_other(crowd_of(200, 200), 30)));
    EXPECT_FALSE(is_refused(with_lamps(placed_in_each_other(crowd_of(300, 200), 2), 900, Channel::light, true)));
    EXPECT_TRUE(is_refused(with_lamps(placed_in_each_other(crowd_of(300, 200), 30), 900, Channel::light, true)));
    EXPECT_TRUE(is_refused(with_obstacles(crowd_of(1000, 60), 4000, 0, 30))) << "vehicles in 4,000 obstacles";
    EXPECT_TRUE(is_refused(with_obstacles(crowd_of(1, 60), 4000, 0, 1, 1))) << "4,000 obstacles that push each other";
    EXPECT_FALSE(is_refused(crowd_of(8000, 400, eyes(1, Channel::obstacle)))) << "four walls";
    EXPECT_TRUE(is_refused(with_lamps(crowd_of(8000, 400, eyes(1, Channel::obstacle)), 900, Channel::light, true)));
    EXPECT_TRUE(is_refused(with_neurons(crowd_of(10000, 400), 800, 0))) << "brains";
    Scene marks = crowd_of(1000, 400, eyes(64, Channel::memory));
    EXPECT_FALSE(is_refused(marks));
    marks.kinds[0].memory.marks = 64;
    EXPECT_TRUE(is_refused(marks));
    Scene blown = crowd_of(1000, 6);
    blown.kinds[0].body = resized(blown.kinds[0].body, 0.05f, 0.05f);
    EXPECT_FALSE(is_refused(blown));
    blown.zones.push_back({.name = "z", .pull = 200});
    EXPECT_TRUE(is_refused(blown)) << "a force that presses them together";
}

TEST(SizeLimits, HoldWhereverObstaclesArePushed) {
    const auto is_refused = [](const Scene& scene) { return find_fault(scene).has_value(); };
    const Scene floor = crowd_of(1, 100);
    EXPECT_FALSE(is_refused(with_boxes(floor, 1000, 0.3f)));
    EXPECT_TRUE(is_refused(with_boxes(floor, 2000, 0.1f))) << "small ones that would be pushed into one heap";
    Scene mixed = with_boxes(floor, 1000, 0.3f);
    mixed.obstacles[7].length = mixed.obstacles[7].width = 0.05f;
    EXPECT_FALSE(is_refused(mixed)) << "a small one does not make room for the others";
    EXPECT_FALSE(is_refused(with_boxes(with_obstacles(floor, 2000, 0, 1), 5, 0.3f)));
    EXPECT_TRUE(is_refused(with_boxes(with_obstacles(floor, 2000, 0, 1), 20, 0.3f))) << "pushed among 2,000 others";
    EXPECT_FALSE(is_refused(with_boxes(with_obstacles(floor, 2000, 1e3f, 1), 20, 0.3f))) << "which are apart";
}

TEST(SizeLimits, NameANumberThatIsMoreThanTheLimit) {
    const auto values = [](const Message& message) { return message.phrases.front().values; };
    EXPECT_EQ(values(too_much_work(1, 40e6 + 1, 40e6)), (std::vector<std::string>{"1", "41", "40"}));
    EXPECT_NE(values(outside("x", 1.0000001, {0, 1}))[1], "1");
    Scene full = crowd_of(200, 10);
    const Body& body = full.kinds[0].body;
    full.arena.width = full.arena.height = std::sqrt(200 * body.length * body.width) * 0.9999f;
    const auto fault = find_fault(full);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->what.phrases.front().id, "too_dense");
    const auto numbers = values(fault->what);
    EXPECT_GT(std::stod(numbers[1]), std::stod(numbers[2])) << fault->what.text;
    Scene heavy = crowd_of(1, 10);
    heavy.kinds[0].body.wheels[0].load += 0.002f;
    EXPECT_EQ(find_fault(heavy)->what.text.find("add up to 1;"), std::string::npos);
}

// The command is refused because of the work of a tick, and the world stays as it is.
void expect_too_much_work(Session& session, const Command& command) {
    const auto hash = session.hash();
    const auto error = session.apply(command);
    ASSERT_TRUE(error);
    EXPECT_NE(error->text().find("a tick of "), std::string::npos) << error->text();
    EXPECT_EQ(session.hash(), hash);
    EXPECT_EQ(find_fault(session.edited_scene()), std::nullopt) << "the scene can be saved";
}

TEST(SizeLimits, RefuseThePopulationThatGrowsOneByOne) {
    const auto of = [](int population) {
        Scene scene = crowd_of(population, 400, eyes(64, Channel::memory));
        scene.kinds[0].memory.marks = 64;
        return scene;
    };
    int most = 0;
    while (!find_fault(of(most + 1))) ++most;
    ASSERT_GT(most, 100);
    Session session = open_session(of(most - 2));
    EXPECT_FALSE(session.apply(AddVehicle{}));
    EXPECT_FALSE(session.apply(AddVehicle{0, Pose{5, 5, 0}}));
    expect_too_much_work(session, AddVehicle{});
    expect_too_much_work(session, AddVehicle{0, Pose{-5, 5, 0}});
    expect_too_much_work(session, SetPopulation{0, most + 1});
    ASSERT_FALSE(session.apply(RemoveVehicle{}));
    EXPECT_TRUE(session.undo()) << "one that is brought back was there before";
    EXPECT_TRUE(io::read_run(io::write_run(session.save()), "a.run"));
}

TEST(SizeLimits, CountTheBrainsThatEditsGive) {
    const BrainGraph large = with_neurons(crowd_of(1, 200), 800, 0).kinds[0].brain;
    Session crowd = open_session(crowd_of(6000, 300));
    expect_too_much_work(crowd, SetBrain{{.kind = 0}, large});
    Session few = open_session(crowd_of(10, 300));
    ASSERT_FALSE(few.apply(SetBrain{{.kind = 0}, large}));
    expect_too_much_work(few, SetPopulation{0, 6000});
}

// 40 vehicles in a scene whose obstacles leave little room for more work.
Scene nearly_refused() {
    int count = 200;
    const auto of = [](int obstacles) { return with_obstacles(crowd_of(40, 200), obstacles, 0, 5, 1); };
    while (!find_fault(of(count + 1))) ++count;
    return of(count);
}

// The vehicle whose edit is refused first.
template <class Edit>
VehicleId first_refused(Session& session, Edit edit) {
    VehicleId vehicle = 0;
    while (vehicle < 40 && !session.apply(edit(vehicle))) ++vehicle;
    EXPECT_GT(vehicle, 1);
    EXPECT_LT(vehicle, 40);
    expect_too_much_work(session, edit(vehicle));
    return vehicle;
}

TEST(SizeLimits, CountTheBrainsThatSingleVehiclesGet) {
    const Scene scene = nearly_refused();
    const BrainGraph small = scene.kinds[0].brain, large = with_neurons(scene, 250, 20).kinds[0].brain;
    Session session = open_session(scene);
    const auto give = [&](VehicleId vehicle) { return SetBrain{{.vehicle = vehicle}, large}; };
    const VehicleId refused = first_refused(session, give);
    EXPECT_FALSE(session.apply(SetBrain{{.vehicle = refused}, with_neurons(scene, 1, 1).kinds[0].brain}));
    EXPECT_TRUE(io::read_run(io::write_run(session.save()), "a.run"));
    ASSERT_FALSE(session.apply(SetBrain{{.vehicle = 0}, small}));
    EXPECT_FALSE(session.apply(give(refused))) << "in place of another one";
    session.reset();
    EXPECT_FALSE(session.last_reset_error());
}

TEST(SizeLimits, CountTheSensorsThatSingleVehiclesGet) {
    Scene scene = with_zones(nearly_refused(), 8);
    while (find_fault(scene)) scene.obstacles.pop_back();
    Session session = open_session(scene);
    const auto give = [&](VehicleId vehicle) {
        return SetSensors{{.vehicle = vehicle}, eyes(vehicle < 20 ? 30 : 31, Channel::floor)};
    };
    const VehicleId refused = first_refused(session, give);
    ASSERT_FALSE(session.apply(SetSensors{{.vehicle = 0}, {}}));
    EXPECT_FALSE(session.apply(give(refused)));
}

// The time of the cheapest of a few calls.
double time_of_work(const Scene& scene) {
    double least = 1e30;
    for (int attempt = 0; attempt < 7; ++attempt) {
        const auto began = std::clock();
        (void)work_of_a_tick(scene);
        least = std::min(least, static_cast<double>(std::clock() - began));
    }
    return least;
}

TEST(SizeLimits, AreFoundQuicklyAmongManyObstacles) {
    const Scene few = with_boxes(crowd_of(1, 200), 1000, 0.3f), many = with_boxes(crowd_of(1, 200), 4000, 0.3f);
    EXPECT_LT(time_of_work(many), 9 * time_of_work(few)) << "16 times if each is compared with each";
}

// By comparing each with each.
double pairs_of(const std::vector<Obstacle>& obstacles, float between, std::vector<int>* beside = nullptr) {
    const float margin = 0.1f;  // m, of Box2D
    double pairs = 0;
    const auto reach = [&](const Obstacle& o) { return margin + std::hypot(o.length, o.width) / 2; };
    for (std::size_t i = 0; i < obstacles.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Obstacle &a = obstacles[i], &b = obstacles[j];
            if (std::hypot(a.x - b.x, a.y - b.y) >= reach(a) + reach(b) + between) continue;
            ++pairs;
            if (beside) ++(*beside)[i], ++(*beside)[j];
        }
    return pairs;
}

TEST(SizeLimits, CompareEachObstacleWithThoseNearIt) {
    constexpr double cost = 1200;  // of a pair of which one can be pushed
    maths::Random chance{3, 1};
    for (const maths::vec2 sides : {maths::vec2{3, 9}, maths::vec2{9, 3}}) {
        Scene fixed = crowd_of(1, 100);
        for (int i = 0; i < 200; ++i)
            fixed.obstacles.push_back({.name = fmt::format("o{}", i),
                                       .x = chance.uniform(-sides.x, sides.x) / 2,
                                       .y = chance.uniform(-sides.y, sides.y) / 2,
                                       .length = chance.uniform(1, 2),
                                       .width = chance.uniform(1, 2)});
        Scene movable = fixed;
        for (Obstacle& obstacle : movable.obstacles) obstacle.mass = 1;
        const double pairs = pairs_of(fixed.obstacles, 0);
        EXPECT_GT(pairs, 6000);
        EXPECT_NEAR((work_of_a_tick(movable) - work_of_a_tick(fixed)) / cost, pairs, 0.01);

        Scene pushed = fixed;  // one more, that vehicles may push to where most of the others are
        pushed.obstacles.push_back({.name = "box", .x = 40, .y = 40, .length = 0.6f, .width = 0.8f});
        const double without = work_of_a_tick(pushed);
        pushed.obstacles.back().mass = 1;
        std::vector<int> beside(fixed.obstacles.size(), 1);
        (void)pairs_of(fixed.obstacles, 2 * 0.6f, &beside);
        EXPECT_NEAR((work_of_a_tick(pushed) - without) / cost, *std::max_element(beside.begin(), beside.end()), 0.01);
    }
}

TEST(SizeLimits, RefuseObstaclesThatMoveIntoOneCorner) {
    constexpr int count = 400;
    Session session = open_session(with_boxes(crowd_of(1, 100), count, 0.3f));
    MoveObjects all;
    for (int i = 0; i < count; ++i) all.of_obstacles.push_back({i, 49, 49, 0});
    expect_too_much_work(session, all);
    int moved = 0;
    while (moved < count && !session.apply(MoveObstacle{moved, 49, 49, 0})) ++moved;
    EXPECT_GT(moved, 100);
    ASSERT_LT(moved, count);
    expect_too_much_work(session, MoveObstacle{moved, 49, 49, 0});
    EXPECT_FALSE(session.apply(MoveObstacle{moved, -49, 49, 0}));
    EXPECT_TRUE(io::read_run(io::write_run(session.save()), "a.run"));
}

}  // namespace
}  // namespace braitenlab::tests::size_limits_test
