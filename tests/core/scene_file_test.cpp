#include "core/scene/scene_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/maths/angle.h"
#include "core/maths/random.h"
#include "core/scene/nearest.h"
#include "core/scene/schema.h"
#include "core/world/world.h"
#include "tests/core/scenes.h"
#include "tests/tells.h"

namespace braitenlab::tests::scene_file_test {
namespace {

namespace fs = std::filesystem;

const fs::path source = BRAITENLAB_SOURCE;

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

Scene read(const std::string& text, const std::vector<Setting>& settings = {}) {
    auto scene = parse_scene(text, "test.toml", settings);
    EXPECT_TRUE(scene) << scene.error().text();
    return scene ? *scene : Scene{};
}

std::string complaint(const std::string& text, const std::vector<Setting>& settings = {}) {
    const auto scene = parse_scene(text, "test.toml", settings);
    EXPECT_FALSE(scene) << "accepted:\n" << text;
    return scene ? "" : scene.error().text();
}

void expect_in(const std::string& part, const std::string& whole) {
    EXPECT_NE(whole.find(part), std::string::npos) << "expected \"" << part << "\" in \"" << whole << '"';
}

// A scene with one object of each type. No value has its default.
Scene everything() {
    Scene scene;
    scene.name = "all-of_it";
    scene.title = "Quotes \" and \\ and umlauts äöü";
    scene.story = "Two lines\nand a tab\t and a bell\a";
    scene.arena = {33.3f, 44.4f, Boundary::open, true, 12.5f, 0.1f, 0.4f, 0.05f};
    scene.ecology = {12, 0.0125f, 0.3f, 7};
    scene.goal = {Role::predator, 4, 30};
    Kind kind;
    kind.name = "z-first";
    kind.role = Role::predator;
    kind.driver = Driver::parked;
    kind.share = 0.7f;
    kind.body = {1.1f,
                 0.6f,
                 7.7f,
                 2.2f,
                 19.5f,
                 0.15f,
                 0.05f,
                 {{0.1f, 0.2f, 0.3f, 0.4f, Motor::left, 0.5f, 0.6f, 0.07f},
                  {0.9f, 0.8f, 0.2f, 0.1f, Motor::right, 0.3f, 0.4f, 0.05f}}};
    kind.sensors.push_back({"SR", Channel::smell, SensorShape::triangle, SensorResponse::boolean, 0.1f, -0.2f, -1.1f,
                            2.2f, 9, 1.5f, 0.02f, 0.3f});
    kind.sensors.push_back(
        {"A", Channel::prey, SensorShape::omni, SensorResponse::graded, 0.4f, 0.2f, 0.7f, maths::radians(360), 5, 2});
    kind.memory = {7, 33, 0.4f};
    kind.lamps = {{"tail", Channel::red, -0.4f, 0.1f, 0.6f}};
    kind.waypoints = {{1, 2}, {-3.5f, 0}};
    kind.brain.nodes = {{.id = 7, .kind = NodeKind::sensor, .name = "SR"},
                        {.id = 3,
                         .kind = NodeKind::neuron,
                         .name = "N",
                         .curve = {Response::hump, 0.3f, 0.15f},
                         .bias = -0.25f,
                         .time_constant = 1.5f,
                         .silenced = true,
                         .place = maths::vec2{256, -40.5f}},
                        {.id = 8, .kind = NodeKind::motor, .name = "ML", .curve = {Response::sigmoid, 0.1f, 0.9f}}};
    kind.brain.wires = {
        {.from = 7, .to = 3, .weight = -1.75f, .threshold = 0.125f, .curve = {Response::step, 0.4f, 0.3f}},
        {.from = 3, .to = 8, .cut = true, .learning_rate = 1.5f, .decay = 0.01f},
        {.from = 3, .to = 3, .weight = 0.5f, .threshold = 0, .curve = {Response::inverted}}};
    scene.kinds.push_back(kind);
    Kind plain;
    plain.name = "a-second";
    plain.brain = make_graph({.LL = 0.1f, .LR = -0.2f, .threshold_RL = 0.3f, .LM = 0.4f});
    plain.brain.nodes[0].place = {-12, 150};
    plain.brain.nodes[3].place = {520, 0};
    scene.kinds.push_back(plain);
    Kind zeros;
    zeros.name = "m-third";
    zeros.brain = make_graph({});
    scene.kinds.push_back(zeros);
    Kind more = plain;  // four neurons and further nodes
    more.name = "fourth";
    more.brain.nodes.push_back({.id = 20, .kind = NodeKind::neuron, .name = "N"});
    more.brain.nodes.push_back({.id = 21, .kind = NodeKind::neuron, .name = "M"});
    more.brain.wires.push_back({.from = 0, .to = 20, .weight = 0.3f});
    scene.kinds.push_back(more);
    scene.sources = {{"lamp", Channel::heat, 1.5f, -2.5f, 0.75f}, {"another", Channel::light, 0, 0, 1, true}};
    scene.starts = {{"two", "a-second", 1, 2, -3.1f, "lamp", 0.5f, 0.25f}, {"one", "z-first", 0, 0, 0, "", 0, 0}};
    scene.obstacles = {{"wall", 3, 4, 0.7853982f, 5, 0.25f},
                       {"wedge", -3, 4, 0.1f, 1, 1, {{-0.5f, -0.5f}, {0.75f, 0}, {0, 0.6f}}, 2.5f}};
    scene.zones = {{"pond", 1, -2, 0.5f, 3, 2, true, Surface::ice, 0.1f, 2, -3, 0.1f, 4},
                   {.name = "ramp", .slope = 0.2f, .corners = {{-0.5f, -0.5f}, {0.75f, 0}, {0, 0.6f}}}};
    return scene;
}

TEST(SceneFile, ReadsBackEveryShippedScene) {
    ASSERT_FALSE(tests::shipped_scenes().empty());
    for (const fs::path& path : tests::shipped_scenes()) {
        const auto scene = load_scene(path);
        ASSERT_TRUE(scene) << scene.error().text();
        EXPECT_EQ(scene->name, path.stem().string());
        EXPECT_FALSE(scene->title.empty()) << path;
        EXPECT_FALSE(scene->story.empty()) << path;
        const auto again = parse_scene(write_scene(*scene), "again.toml");
        ASSERT_TRUE(again) << again.error().text();
        EXPECT_EQ(*again, *scene) << path;
    }
}

TEST(SceneFile, ReadsBackASceneWithEveryValueSet) {
    const Scene scene = everything();
    const auto fault = check_scene(scene);
    ASSERT_FALSE(fault) << fault->text();
    EXPECT_EQ(read(write_scene(scene)), scene) << write_scene(scene);
}

TEST(SceneFile, ReadsBackAnyFloatAndAnyAngle) {
    maths::Random chance(1, 1);
    Scene scene;
    scene.name = "numbers";
    scene.sources.push_back({"lamp", Channel::light, 0, 0, 1});
    scene.obstacles.push_back({"wall", 0, 0, 0, 1, 1});
    for (int i = 0; i < 2000; ++i) {
        scene.sources[0].x = chance.uniform(-1000, 1000);
        scene.sources[0].strength = chance.uniform(0, 1) * chance.uniform(0, 1e-6f);
        scene.obstacles[0].heading = chance.uniform(-6.2f, 6.2f);
        ASSERT_EQ(read(write_scene(scene)), scene) << write_scene(scene);
    }
}

TEST(SceneFile, WritesShortDegreesAndOmitsDefaults) {
    Scene scene;
    scene.name = "s";
    scene.obstacles.push_back({"wall", 1.1f, 0, maths::radians(35), 1, 1});
    EXPECT_EQ(write_scene(scene), "format = 1\nname = \"s\"\n\n[obstacle.wall]\nx = 1.1\nheading = 35\n");
}

TEST(SceneFile, WritesAFourNeuronBrainInItsShortFormForAnyOrder) {
    Scene scene;
    scene.kinds.emplace_back().name = "k";
    scene.kinds[0].brain = make_graph({.LR = 1.5f, .RM = 0.1f});
    std::swap(scene.kinds[0].brain.wires[0], scene.kinds[0].brain.wires[3]);
    expect_in("[kind.k.brain]\nLR = 1.5\nRM = 0.1\n", write_scene(scene));
    EXPECT_EQ(read(write_scene(scene)).kinds[0].brain, make_graph({.LR = 1.5f, .RM = 0.1f}));
}

TEST(SceneFile, KeepsTheShortFormOfABrainWhoseNodesWereMoved) {
    BrainGraph brain = make_graph({.LR = 1.5f});
    find_node(brain, "SR")->place = {-20, 180.5f};
    EXPECT_EQ(write_brain(brain), "format = 1\n\n[brain]\nLR = 1.5\nplace_SR = [-20, 180.5]\n");
    const auto again = parse_brain(write_brain(brain), "brain.toml");
    ASSERT_TRUE(again);
    EXPECT_EQ(*again, brain);
}

TEST(SceneFile, SetsThePositionOfADeclaredNodeByEitherKey) {
    const auto brain = parse_brain(
        "format = 1\n[brain]\nLL = 1\nplace_SL = [1, 2]\n"
        "[[brain.node]]\nname = 'SL'\nkind = 'sensor'\n[[brain.node]]\nname = 'ML'\nkind = 'motor'\nplace = [3.5, "
        "-4]\n",
        "brain.toml");
    ASSERT_TRUE(brain) << brain.error().text();
    EXPECT_EQ(find_node(*brain, std::string("SL"))->place, (maths::vec2{1, 2}));
    EXPECT_EQ(find_node(*brain, std::string("ML"))->place, (maths::vec2{3.5f, -4}));
}

TEST(SceneFile, RefusesPositionsThatAreNotTwoNumbers) {
    const auto refusal = [](const std::string& line) {
        return parse_brain("format = 1\n[brain]\nLL = 1\n" + line, "brain.toml").error().text();
    };
    expect_in("brain.toml:4: 'place_SL' should be two numbers, [x, y]", refusal("place_SL = [1]"));
    expect_in("should be two numbers", refusal("place_SL = 3"));
    expect_in("should be two numbers", refusal("place_SL = ['a', 2]"));
    expect_in("'place_SL' is 100001, outside", refusal("place_SL = [0, 100001]"));
    expect_in("outside", refusal("place_SL = [nan, 0]"));
    expect_in("brain.toml:4: the brain lacks the node ML",
              refusal("place_ML = [0, 0]\n[[brain.node]]\nname = 'SL'\nkind = 'sensor'"));
    BrainGraph brain = make_graph({});
    brain.nodes[0].place = {0, std::numeric_limits<float>::infinity()};
    expect_in("'place' is inf, outside", check_graph(brain)->text());
}

TEST(SceneFile, KeepsTheOrderOfTheFileNotOfTheAlphabet) {
    const Scene scene =
        read("format = 1\n[source.z]\n[source.a]\n[kind.y]\n[kind.b.body]\nmass = 5\n[kind.a]\n[kind.b]\n");
    ASSERT_EQ(scene.sources.size(), 2u);
    EXPECT_EQ(scene.sources[0].name, "z");
    ASSERT_EQ(scene.kinds.size(), 3u);
    EXPECT_EQ(scene.kinds[0].name, "y");
    EXPECT_EQ(scene.kinds[1].name, "b");
}

TEST(SceneFile, TakesItsNameFromTheFileUnlessItHasATitle) {
    EXPECT_EQ(parse_scene("format = 1", "some/where/garden.toml")->name, "garden");
    EXPECT_EQ(parse_scene("format = 1\nname = \"other\"", "garden.toml")->name, "other");
}

TEST(SceneFile, ReadsAnglesAsDegrees) {
    const Scene scene = read("format = 1\n[obstacle.o]\nheading = 90\n");
    EXPECT_FLOAT_EQ(scene.obstacles[0].heading, maths::pi / 2);
    EXPECT_EQ(Sensor{}.fov, read("format=1\n[kind.k.sensor.S]\nfield = 100\n").kinds[0].sensors[0].fov);
}

struct Mistake {
    const char* text;
    std::vector<std::string> told;  // parts that the message must have
};

TEST(SceneFile, NamesTheLineAndTheNearestWordForEveryKindOfError) {
    const std::vector<Mistake> mistakes{
        {"title = \"x\"\n", {"test.toml:1: ", "format = 1"}},
        {"\nformat = 2\n", {"test.toml:2: ", "format = 1 only"}},
        {"format = 1\n[arena\n", {"test.toml:2: ", "not TOML"}},
        {"format = 1\ntitel = \"x\"\n", {"test.toml:2: ", "'titel'", "nearest is 'title'"}},
        {"format = 1\n[ecology]\npopulaton = 3\n",
         {"test.toml:3: ", "'populaton'", "[ecology]", "nearest is 'population'"}},
        {"format = 1\n[sauce.x]\n", {"test.toml:2: ", "'sauce'", "nearest is 'source'"}},
        {"format = 1\n[kind.k]\nrole = \"pray\"\n", {"test.toml:3: ", "'pray'", "nearest is 'prey'"}},
        {"format = 1\n[kind.k]\nrole = \"xxxxxxxx\"\n", {"test.toml:3: ", "known are 'none', 'predator', 'prey'"}},
        {"format = 1\n[arena]\nwidth = \"20\"\n", {"test.toml:3: ", "'width' should be a number, not text"}},
        {"format = 1\n[ecology]\npopulation = 1.5\n", {"test.toml:3: ", "a whole number"}},
        {"format = 1\n[arena]\nwidth = 0.4\n", {"test.toml:3: ", "'width' is 0.4, outside 0.5 .. 2000"}},
        {"format = 1\n[arena]\nwidth = nan\n", {"test.toml:3: ", "'width' is nan, outside"}},
        {"format = 1\n[arena]\nwidth = 1e300\n", {"test.toml:3: ", "outside"}},
        {"format = 1\n[kind.k.brain]\n\nLL = -2.5\n", {"test.toml:4: ", "'LL' is -2.5, outside -2 .. 2"}},
        {"format = 1\n[kind.k.brain]\nthreshold_LL = 1.5\n", {"test.toml:3: ", "outside 0 .. 1"}},
        {"format = 1\n[kind.k.brain]\nLX = 1\n", {"test.toml:3: ", "'LX'", "[kind.k.brain]", "nearest is 'LL'"}},
        {"format = 1\n[arena]\narena = { width = 3 }\n", {"test.toml:3: ", "'arena'"}},
        {"format = 1\narena = 3\n", {"test.toml:2: ", "should be a table", "[arena]"}},
        {"format = 1\n[source]\nx = 3\n", {"test.toml:3: ", "[source.one]"}},
        {"format = 1\n[source.\"a b\"]\n", {"test.toml:2: ", "'a b' cannot be a name"}},
        {"format = 1\n[kind.k]\n[vehicle.v]\nx = 1\n", {"test.toml:3: ", "needs a kind"}},
        {"format = 1\n[kind.fox]\n[vehicle.v]\nkind = \"fax\"\n", {"test.toml:4: ", "'fax'", "nearest is 'fox'"}},
        {"format = 1\n[kind.k]\n[source.lamp]\n[vehicle.v]\nkind = \"k\"\nfacing = \"lump\"\n",
         {"test.toml:6: ", "nearest is 'lamp'"}},
        {"format = 1\n[kind.k]\n[vehicle.v]\nkind = \"k\"\nx = 11\n", {"test.toml:5: ", "outside the arena"}},
        {"format = 1\n[kind.k.body]\nwheel = [{ load = 0.5 }]\n", {"test.toml:3: ", "loads add up to 0.5"}},
        {"format = 1\n[kind.k.body]\nwheel = [1]\n", {"test.toml:3: ", "[[kind.k.body.wheel]]"}},
        {"format = 1\n[kind.k.brain]\n[[kind.k.brain.node]]\n", {"test.toml:3: ", "needs a name"}},
        {"format = 1\n[[kind.k.brain.node]]\nname = \"N\"\n[[kind.k.brain.wire]]\nfrom = \"N\"\nto = \"M\"\n",
         {"test.toml:6: ", "no node is called 'M'", "'N'"}},
        {"format = 1\n[[kind.k.brain.node]]\nname = \"N\"\n[[kind.k.brain.node]]\nname = \"N\"\n",
         {"test.toml:2: ", "two nodes are called 'N'"}},
        {"format = 1\n[ecology]\npopulation = 3\n", {"test.toml:3: ", "no [kind.NAME]"}},
        {"format = 1\n[goal]\nrole = \"wiring\"\n", {"test.toml:3: ", "predators or prey"}},
        {"format = 1\n[obstacle.o]\ncorner = [{ x = 1 }, { y = 1 }]\n", {"test.toml:3: ", "at least 3 corners"}},
        {"format = 1\n[obstacle.o]\ncorner = [{ x = 1 }, { x = 1 }, { y = 1 }]\n",
         {"test.toml:3: ", "corners 1 and 2 stand less than"}},
        {"format = 1\n[obstacle.o]\ncorner = [{ x = 1 }, { y = -1 }, { y = 1 }]\n",
         {"test.toml:3: ", "does not lie left", "counter-clockwise"}},
        {"format = 1\n[zone.z]\ncorner = [{ x = 1 }, { y = 1 }]\n",
         {"test.toml:3: ", "at least 3 corners", "a rectangle"}},
        {"format = 1\n[zone.z]\ncorner = [{ x = 1 }, { y = -1 }, { y = 1 }]\n",
         {"test.toml:3: ", "does not lie left", "counter-clockwise"}},
        {"format = 1\n[arena]\nwidth = 2\nwidth = 3\n", {"test.toml:4: ", "not TOML"}},
    };
    for (const Mistake& mistake : mistakes) {
        SCOPED_TRACE(mistake.text);
        const std::string told = complaint(mistake.text);
        for (const std::string& part : mistake.told) expect_in(part, told);
        EXPECT_EQ(told.find('\n'), std::string::npos);
    }
}

TEST(SceneFile, ReportsAnAbsentFileAndAFolder) {
    expect_in("no such file", load_scene("/nowhere/at/all.toml").error().text());
    expect_in("not a file", load_scene(source).error().text());
}

TEST(SceneFile, SplitsASettingAtTheFirstEqualsSign) {
    const auto setting = parse_setting(" source.lamp.x = 3=4");
    ASSERT_TRUE(setting);
    EXPECT_EQ(setting->path, "source.lamp.x");
    EXPECT_EQ(setting->value, "3=4");
    expect_in("PATH=VALUE", parse_setting("source.lamp.x").error().text());
    EXPECT_FALSE(parse_setting("=3"));
}

const char* const small_scene =
    "format = 1\n[kind.prey.sensor.SL]\n[kind.prey.brain]\nLL = 1\n[source.lamp]\n[vehicle.one]\nkind = \"prey\"\n";

TEST(SceneFile, SetsNumbersWordsAndTextsByTheirPath) {
    const Scene scene = read(small_scene, {{"kind.prey.brain.LL", "0.5"},
                                           {"kind.prey.role", "prey"},
                                           {"kind.prey.body.mass", "3"},
                                           {"kind.prey.sensor.SL.angle", "90"},
                                           {"source.lamp.x", "-2"},
                                           {"vehicle.one.facing", "lamp"},
                                           {"ecology.population", "500"},
                                           {"title", "\"in quotes\""}});
    EXPECT_EQ(read_dials(scene.kinds[0].brain).LL, 0.5f);
    EXPECT_EQ(scene.kinds[0].role, Role::prey);
    EXPECT_EQ(scene.kinds[0].body.mass, 3);
    EXPECT_FLOAT_EQ(scene.kinds[0].sensors[0].angle, maths::pi / 2);
    EXPECT_EQ(scene.sources[0].x, -2);
    EXPECT_EQ(scene.starts[0].facing, "lamp");
    EXPECT_EQ(scene.ecology.population, 500);
    EXPECT_EQ(scene.title, "in quotes");
}

TEST(SceneFile, KeepsTheOrderOfTablesWithSettings) {
    const Scene scene = read("format = 1\n[source.b]\n[source.a]\n", {{"source.a.x", "1"}});
    EXPECT_EQ(scene.sources[0].name, "b");
}

TEST(SceneFile, SetsTheDialsOfABrainWithFurtherNodes) {
    const Scene before = everything();
    const auto scene = parse_scene(write_scene(before), "t", {{"kind.fourth.brain.LR", "0.9"}});
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(read_dials(scene->kinds[3].brain).LR, 0.9f);
    EXPECT_EQ(read_dials(scene->kinds[3].brain).LL, 0.1f);
    EXPECT_EQ(scene->kinds[3].brain.nodes.size(), 6u);
    expect_in("lacks the node", parse_scene(write_scene(before), "t", {{"kind.z-first.brain.RR", "1"}}).error().text());
}

TEST(SceneFile, NamesTheNearestPathForAnUnknownSetting) {
    expect_in("--set: no such value 'kind.prey.brain.LX'; the nearest is 'kind.prey.brain.LL'",
              complaint(small_scene, {{"kind.prey.brain.LX", "1"}}));
    expect_in("the nearest is 'source.lamp.x'", complaint(small_scene, {{"source.lump.x", "1"}}));
    expect_in("the nearest is 'kind.prey.brain.LL'", complaint(small_scene, {{"brain.LL", "1"}}));
    for (const char* path : {"kind.prey.brain.wire.SL-ML.weight", "kind.pray.brain.node.N.bias"}) {
        const auto scene = parse_scene(small_scene, "s.toml", {{path, "1"}});
        ASSERT_FALSE(scene) << path;
        EXPECT_TRUE(tells(scene.error(), message_of("no_such_value", in_quotes(path))));
    }
    complaint(small_scene, {{"kind.prey.brain", "1"}});
    complaint(small_scene, {{"", "1"}});
    complaint(small_scene, {{"...", "1"}});
}

TEST(SceneFile, ADialAloneIsThatOfTheFirstVehicle) {
    const auto scene = parse_scene(small_scene, "s.toml", {{"LR", "0.75"}});
    ASSERT_TRUE(scene) << scene.error().text();
    const Kind& first = scene->kinds[static_cast<std::size_t>(find_kind(*scene, scene->starts.front().kind))];
    EXPECT_EQ(read_dials(first.brain).LR, 0.75f);
    const std::string own = std::string(small_scene) + "[vehicle.one.brain]\nLR = 0.5\n";
    const auto with_own = parse_scene(own, "s.toml", {{"LR", "0.25"}});
    ASSERT_TRUE(with_own) << with_own.error().text();
    EXPECT_EQ(read_dials(*with_own->starts.front().brain).LR, 0.25f);
}

TEST(SceneFile, NamesTheSettingWhoseValueIsWrong) {
    expect_in("--set: 'LL' is 3, outside", complaint(small_scene, {{"kind.prey.brain.LL", "3"}}));
    expect_in("--set: 'LL' should be a number", complaint(small_scene, {{"kind.prey.brain.LL", "much"}}));
    expect_in("--set: 'LL' should be a number, not a list", complaint(small_scene, {{"kind.prey.brain.LL", "[1]"}}));
    expect_in("--set: no source is called 'lump'", complaint(small_scene, {{"vehicle.one.facing", "lump"}}));
    expect_in("--set: ", complaint(small_scene, {{"kind.prey.brain.LL", "1\ntitle = \"smuggled\""}}));
    expect_in("other.toml:7: ", complaint(small_scene, {{"kind.prey.brain.LL", "3", "other.toml", 7}}));
}

TEST(SceneFile, ReadsBackABrainFileAndRefusesOtherFiles) {
    for (const Kind& kind : everything().kinds) {
        const auto brain = parse_brain(write_brain(kind.brain), "brain.toml");
        ASSERT_TRUE(brain) << brain.error().text();
        EXPECT_EQ(*brain, kind.brain);
    }
    expect_in("brain.toml:3: 'LL' is 3", parse_brain("format = 1\n[brain]\nLL = 3", "brain.toml").error().text());
    expect_in("no [brain]", parse_brain("format = 1\n", "brain.toml").error().text());
    expect_in("this is a whole scene", parse_brain("format = 1\n[kind.one]\n", "brain.toml").error().text());
    expect_in("'brian'", parse_brain("format = 1\n[brian]\n", "brain.toml").error().text());
}

TEST(Check, FindsTheErrorsOfAnEditedScene) {
    EXPECT_FALSE(check_scene(everything()));
    Scene scene = everything();
    scene.kinds[1].name = scene.kinds[0].name;
    expect_in("called 'z-first'", check_scene(scene)->text());
    scene = everything();
    scene.sources[0].strength = 2;
    expect_in("source.lamp.strength", check_scene(scene)->text());
    scene = everything();
    scene.obstacles[0].heading = NAN;
    expect_in("obstacle.wall.heading", check_scene(scene)->text());
    scene = everything();
    scene.kinds[0].brain.wires[0].weight = 5;
    expect_in("'weight' is 5", check_scene(scene)->text());
    scene = everything();
    scene.kinds[0].brain.wires.push_back({.from = 7, .to = 99});
    EXPECT_TRUE(check_scene(scene));
    scene = everything();
    scene.ecology.population = limits::vehicles;
    scene.arena.width = scene.arena.height = 2000;  // m: so many need much room
    EXPECT_FALSE(check_scene(scene));
    for (int i = 0; i < 60; ++i) {
        scene.kinds[1].sensors.push_back(
            {.name = fmt::format("s{}", i), .channel = Channel::energy, .range = 1, .latency = 1});
        if (i == 10) {
            const auto fault = check_scene(scene);
            EXPECT_FALSE(fault) << "eleven slow sensors each fit: " << fault->text();
        }
    }
    expect_in("ecology.population: 20002 vehicles", check_scene(scene)->text());
}

TEST(Nearest, CountsAddedRemovedAndReplacedLetters) {
    EXPECT_EQ(edit_distance("prey", "pray"), 1);
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(Nearest, ListsAWordOnce) {
    const std::string text = name_nearest("quite another", std::array<std::string_view, 3>{"left", "right", "left"});
    EXPECT_NE(text.find("'left'"), std::string::npos) << text;
    EXPECT_EQ(text.find("'left'"), text.rfind("'left'")) << text;
}

TEST(Nearest, PrefersAWordThatIsAbbreviated) {
    const std::vector<std::string_view> known{"set", "starts", "seconds", "seed"};
    EXPECT_EQ(nearest_word("secs", known), "seconds");
    EXPECT_EQ(name_nearest("secs", known), "; the nearest is 'seconds'");
    EXPECT_EQ(nearest_word("sets", known), "set");
    EXPECT_FALSE(is_abbreviation("se", "seconds"));
    EXPECT_FALSE(is_abbreviation("seconds", "seconds"));
}

// Robustness only: for any bytes, the reader returns a scene or an error, and an accepted scene can be written and read
// again.
void survive(const std::string& text) {
    const auto scene = parse_scene(text, "hostile.toml");
    if (!scene) {
        EXPECT_FALSE(scene.error().what.empty());
        return;
    }
    const auto again = parse_scene(write_scene(*scene), "hostile.toml");
    ASSERT_TRUE(again) << again.error().text() << '\n' << text;
    EXPECT_EQ(*again, *scene);
}

TEST(SceneFile, RefusesOrAcceptsAFileTruncatedAtAnyByteWithoutACrash) {
    for (const fs::path& path : tests::shipped_scenes()) {
        const std::string text = content(path);
        for (std::size_t end = 0; end < text.size(); end += 13) survive(text.substr(0, end));
    }
}

TEST(SceneFile, RefusesOrAcceptsAFileChangedAtAnyByteWithoutACrash) {
    const std::string bits = "\"'[]{}=.,#\\\n-+0919eE_xyzLR\x01\xff\xc3 \t";
    maths::Random chance(7, 7);
    for (const fs::path& path : tests::shipped_scenes()) {
        const std::string text = content(path);
        for (int i = 0; i < 400; ++i) {
            std::string changed = text;
            for (std::uint32_t n = chance.next() % 3 + 1; n > 0; --n) {
                const std::size_t at = chance.next() % changed.size();
                const char with = bits[chance.next() % bits.size()];
                if (chance.next() % 3 == 0)
                    changed.insert(at, 1, with);
                else if (chance.next() % 3 == 0)
                    changed.erase(at, chance.next() % 40);
                else
                    changed[at] = with;
            }
            survive(changed);
        }
    }
}

TEST(SceneFile, RefusesFilesThatAreTooDeepOrTooLarge) {
    std::string dots = "format = 1\na";
    for (int i = 0; i < 500000; ++i) dots += ".a";
    expect_in("test.toml:2: a key has too many dots", complaint(dots + " = 1\n"));
    complaint("format = 1\n[" + dots.substr(11) + "]\n");
    complaint("format = 1\na = " + std::string(500000, '['));
    std::string tables = "a = ";
    for (int i = 0; i < 100000; ++i) tables += "{a = ";
    complaint("format = 1\n" + tables);
    expect_in("larger than", complaint(std::string(limits::file_bytes + 1, '\n')));
    std::string kinds = "format = 1\n";
    for (int i = 0; i < 65; ++i) kinds += "[kind.k" + std::to_string(i) + "]\n";
    expect_in("the most is 64", complaint(kinds));
    complaint("format = 1\n" + std::string(1000000, 'k') + " = 1\n");
    read("format = 1\nstory = \"" + std::string(100, '.') + "\"  # " + std::string(100, '.') + "\n");
    read("format = 1\nstory = '''\n" + std::string(100, '.') + "\"'''\n");
}

TEST(SceneFile, RefusesMoreVehiclesThanTheFloorHasRoomFor) {
    const auto crowd = [](int population, int side) {
        return "format = 1\n[kind.k]\n[ecology]\npopulation = " + std::to_string(population) +
               "\n[arena]\nwidth = " + std::to_string(side) + "\nheight = " + std::to_string(side) + "\n";
    };
    expect_in("test.toml:4: 20000 vehicles cover 14000 m², and the arena has 400 m²; take at most 571",
              complaint(crowd(20000, 20)));
    read(crowd(571, 20));
    read(crowd(8000, 80));
    read(crowd(100, 1));  // too few to be slow
    std::string pile = crowd(0, 20);
    for (int i = 0; i < 33; ++i) pile += "[vehicle.v" + std::to_string(i) + "]\nkind = \"k\"\nx = 3\n";
    expect_in("more than 32 vehicles are placed within 1 m", complaint(pile));
    read(pile.substr(0, pile.rfind("[vehicle")));
}

TEST(SceneFile, RefusesAWorldWhoseTickTakesTooLong) {
    const auto crowd = [](int population, const std::string& channel, int range) {
        return "format = 1\n[arena]\nwidth = 400\nheight = 400\n[ecology]\npopulation = " + std::to_string(population) +
               "\n[kind.k.sensor.S]\nchannel = \"" + channel + "\"\nrange = " + std::to_string(range) + "\n";
    };
    expect_in("test.toml:6: a tick of 20000 vehicles may take as long as 41", complaint(crowd(20000, "vehicle", 100)));
    expect_in(" million comparisons, and the most are 40 million", complaint(crowd(20000, "vehicle", 100)));
    read(crowd(20000, "vehicle", 12));
    read(crowd(5900, "vehicle", 100));
    std::string lamps = crowd(5000, "light", 10);
    for (int i = 0; i < 100; ++i) lamps += "[source.s" + std::to_string(i) + "]\n";
    std::string zones;
    const auto boxes = [](int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += "[obstacle.o" + std::to_string(i) + "]\n";
        return text;
    };
    for (int i = 0; i < 400; ++i) zones += "[zone.z" + std::to_string(i) + "]\nlength = 99\nwidth = 99\n";
    read(lamps);
    complaint(lamps + boxes(250));
    read(crowd(5000, "energy", 10));
    complaint(crowd(5000, "energy", 10) + zones);
    read(crowd(20000, "obstacle", 10) + boxes(10));
    complaint(crowd(20000, "obstacle", 10) + boxes(60));
    complaint(crowd(20000, "light", 100) + "[kind.k.lamp.l]\n");
}

TEST(SceneFile, ReadsTheTableOfASensorAndRefusesOneThatIsNoTable) {
    const std::string head = "format = 1\n[kind.k.sensor.S]\nresponse = \"table\"\n";
    const std::string first = "[[kind.k.sensor.S.point]]\ndistance = 0.01\nreading = 0.9\n";
    const auto second = [](const char* distance) {
        return std::string("[[kind.k.sensor.S.point]]\ndistance = ") + distance + "\nreading = 0.2\n";
    };
    const Scene scene = read(head + first + second("0.05"));
    EXPECT_EQ(scene.kinds[0].sensors[0].points, (std::vector<ResponsePoint>{{0.01f, 0.9f}, {0.05f, 0.2f}}));
    EXPECT_EQ(read(write_scene(scene)), scene);
    expect_in("test.toml:3: a table needs two points or more", complaint(head));
    expect_in("test.toml:3: a table needs two points or more", complaint(head + first));
    expect_in("test.toml:8: point 2 is at 0.01 m, and the one before it at 0.01 m",
              complaint(head + first + second("0.01")));
    expect_in("test.toml:6: 'reading' is 2, outside 0 .. 1",
              complaint(head + "[[kind.k.sensor.S.point]]\ndistance = 0\nreading = 2\n" + second("1")));
    expect_in("test.toml:3: points belong to the response", complaint("format = 1\n[kind.k.sensor.S]\n" + first));
    expect_in("test.toml:3: 'gamma' is 0, outside 0.2 .. 3", complaint("format = 1\n[kind.k.sensor.S]\ngamma = 0\n"));
}

TEST(SceneFile, VehiclesAreInTheOrderOfTheirKeyAndElseOfTheFile) {
    const auto names = [](const Scene& scene) {
        std::string all;
        for (const Start& start : scene.starts) all += start.name;
        return all;
    };
    const std::string head = "format = 1\n[kind.k]\n";
    const auto vehicle = [](const std::string& name, const std::string& order) {
        return "[vehicle." + name + "]\nkind = \"k\"\n" + (order.empty() ? "" : "order = " + order + "\n");
    };
    EXPECT_EQ(names(read(head + vehicle("b", "") + vehicle("a", "") + vehicle("c", ""))), "bac");
    const std::string ordered = head + vehicle("a", "2") + vehicle("b", "1") + vehicle("d", "") + vehicle("c", "1");
    EXPECT_EQ(names(read(ordered)), "dbca");
    EXPECT_EQ(write_scene(read(ordered)).find("order"), std::string::npos) << "the tables are in this order";
    EXPECT_EQ(names(read(write_scene(read(ordered)))), "dbca");
    expect_in("test.toml:5: 'order' should be a whole number", complaint(head + vehicle("a", "1.5")));
    expect_in("test.toml:5: 'order' is 2e+06, outside", complaint(head + vehicle("a", "2000000")));
    for (const char* other : {"[source.s]", "[kind.vehicle.brain]", "[vehicle.a.sensor.S]"})
        expect_in("'order'", complaint("format = 1\n" + std::string(other) + "\norder = 1\n"));
}

TEST(SceneFile, ABrainWithoutNodesIsReadAgain) {
    const auto again = parse_brain(write_brain({}), "brain.toml");
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(*again, BrainGraph{});
}

TEST(SceneFile, MinusZeroGivesTheRunOfZero) {
    const auto hash = [](const std::string& zero) {
        const Scene scene = read("format = 1\n[kind.k]\n[kind.k.sensor.S]\nx = " + zero + "\nangle = " + zero +
                                 "\n[vehicle.one]\nkind = \"k\"\nx = " + zero + "\nheading = " + zero +
                                 "\n[source.lamp]\nx = 3\ny = " + zero + "\n");
        return World::create(scene, 1)->hash();
    };
    EXPECT_EQ(hash("-0.0"), hash("0.0"));
    EXPECT_NE(hash("-0.1"), hash("0.0"));
}

// Set BRAITENLAB_WRITE_DOCS=1 to write the tables again after a change of the fields.
TEST(SceneFile, FormatTableIsUpToDateInTheSceneFormatPage) {
    const fs::path page = source / "docs" / "scene-format.md";
    std::string text = content(page);
    if (std::getenv("BRAITENLAB_WRITE_DOCS")) {
        text = text.substr(0, text.find("\n## The top of the file")) + describe_scene_format();
        std::ofstream(page, std::ios::binary) << text;
    }
    expect_in(describe_scene_format(), text);
}

TEST(SceneFile, AnExampleReadsInTheSceneFormatPage) {
    std::istringstream lines(content(source / "docs" / "scene-format.md"));
    std::string example;
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("    ", 0) == 0 || (line.empty() && !example.empty())) example += line + '\n';
    const Scene scene = read(example);
    EXPECT_EQ(scene.starts.size(), 1u);
}

}  // namespace
}  // namespace braitenlab::tests::scene_file_test
