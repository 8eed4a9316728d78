// MicroPython: brain.py in Python 3, and in MicroPython on an emulated micro:bit.
#include "core/export/micropython.h"

#include <cmath>
#include <sstream>

#include "core/brain/four_neurons.h"
#include "core/export/arduino.h"
#include "core/export/sensor_parts.h"
#include "tests/robots/exported.h"

namespace braitenlab::tests::micropython_test {
namespace {

using robots::BrainToExport;
using robots::Target;

Result<std::vector<robots::ExportedFile>> exported(const BrainToExport& brain) {
    return robots::export_brain(brain, Target::micropython, *robots::find_robot("microbit"));
}

struct Compared {
    std::size_t rows = 0;
    double worst = 0;
};

// brain.py in MicroPython on an emulated micro:bit, or in this computer's Python.
Compared compare(const Folder& folder, const BrainToExport& brain, int ticks, bool here) {
    const auto vectors = robots::golden_vectors(brain, 50, ticks);
    const auto plan = robots::make_plan(brain, 50);
    put_text(folder / "brain.py", robots::micropython::brain_py(*plan));
    std::string lines;
    for (const auto& row : vectors->ticks) {
        for (const float value : row.sensed) lines += fmt::format("{} ", std::lround(1000 * value));
        lines += "\n";
    }
    put_text(folder / "lines", lines);
    const Ran ran =
        shell(fmt::format("cd '{}' && python3 '{}/microbit_run.py' brain.py {} < lines", folder.path.string(),
                          BRAITENLAB_SOURCE "/tests/robots/run", here ? "--here" : ""));
    EXPECT_EQ(ran.code, 0) << brain.title << " " << ran.out.substr(0, 500);
    std::istringstream rows(ran.out);
    Compared found;
    for (double left = 0, right = 0; rows >> left >> right && found.rows < vectors->ticks.size(); ++found.rows) {
        const auto& row = vectors->ticks[found.rows];
        found.worst = std::max({found.worst, std::fabs(left / 1e6 - static_cast<double>(row.left)),
                                std::fabs(right / 1e6 - static_cast<double>(row.right))});
    }
    return found;
}

TEST(Micropython, ComputesWhatTheLabComputesInPython) {
    const Folder folder;
    for (const BrainToExport& brain : shipped_brains()) {
        const Compared found = compare(folder, brain, 300, true);
        EXPECT_EQ(found.rows, 300u) << brain.title;
        EXPECT_LE(found.worst, 1e-5) << brain.title;
    }
}

// A ring of threshold units, each with an eye.
BrainToExport ring(int neurons) {
    BrainGraph graph = make_graph({.LM = 0.1f});
    const auto join = [&](NodeId from, NodeId to, float weight) {
        graph.wires.push_back({.from = from, .to = to, .weight = weight});
    };
    for (int i = 0; i < neurons; ++i)
        graph.nodes.push_back({.id = 50 + i,
                               .kind = NodeKind::neuron,
                               .name = "N" + std::to_string(i),
                               .curve = {.response = Response::step, .peak = 0.7f}});
    for (int i = 0; i < neurons; ++i) {
        join(find_node(graph, i % 2 ? "SL" : "SR")->id, 50 + i, 1);
        join(50 + i, 50 + (i + 1) % neurons, 0.4f);
        join(50 + i, find_node(graph, "ML")->id, 0.05f);
    }
    return {"ring", graph, {}};
}

// Neurons of the largest ring that is exported.
int largest_ring() {
    int neurons = 2;
    while (exported(ring(neurons + 1))) ++neurons;
    return neurons;
}

TEST(Micropython, RefusesWhatItCannotHoldByName) {
    const auto values = exported({"", find_preset("3c-values")->brain, {}});
    ASSERT_FALSE(values);
    EXPECT_NE(values.error().what.find("'HR'"), std::string::npos) << values.error().what;
    const auto memory = exported({"", make_graph({.LL = 1}), {{.name = "SL", .channel = Channel::memory}}});
    ASSERT_FALSE(memory);
    EXPECT_NE(memory.error().what.find("'SL'"), std::string::npos) << memory.error().what;
    EXPECT_TRUE(exported({"", find_preset("5-logic")->brain, {}}));
    const auto large = exported(ring(largest_ring() + 1));
    ASSERT_FALSE(large);
    EXPECT_NE(large.error().what.find("bytes"), std::string::npos) << large.error().what;
}

TEST(Micropython, WritesAMainProgramThatPythonReads) {
    const Folder folder;
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files);
    for (const auto& file : *files)
        if (file.name.ends_with(".py")) {
            put_text(folder / file.name, file.text);
            const std::string path = (folder / file.name).string();
            const Ran ran = shell(fmt::format("python3 -c 'compile(open(\"{0}\").read(), \"{0}\", \"exec\")'", path));
            EXPECT_EQ(ran.code, 0) << ran.out;
        }
}

TEST(Micropython, WritesTheWiringOfItsPinsAndTheParts) {
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    ASSERT_TRUE(files);
    const auto text = [&](std::string_view name) {
        for (const auto& file : *files)
            if (file.name == name) return file.text;
        return std::string{};
    };
    const std::string svg = text("wiring.svg"), main = text("main.py");
    for (const int pin : {0, 1, 8, 12, 13, 14, 15, 16}) {
        EXPECT_NE(svg.find(fmt::format(">P{}<", pin)), std::string::npos) << pin;
        EXPECT_NE(main.find(fmt::format("pin{}", pin)), std::string::npos) << pin;
    }
    EXPECT_EQ(svg.find(">P2<"), std::string::npos) << "the brain has two sensors";
    EXPECT_EQ(svg.find("VIN"), std::string::npos) << "the micro:bit has its own battery";
    EXPECT_NE(text("parts.csv").find("for sensors SL, SR"), std::string::npos);
}

const std::string& file_of(const std::vector<robots::ExportedFile>& files, std::string_view name) {
    return std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name == name; })->text;
}

// Runs a program whose clock is simulated: the brain takes 7 ms of each step, and sleep() 1.4 ms more than it is told.
// The clock goes back to 0 at the step 250, as it does after 2^30 ms (the module `utime` of the firmware 1.0.1). The
// step 500 waits for 600 ms. Prints the mean time of a step before that, the steps in the 400 ms after it, and the
// periods of the PWM pins, in ms.
constexpr const char* with_clock = R"py(
import sys, types
period = 1 << 30
clock = [period - 5000.0]
steps = []
periods = []
class Pin:
    def read_analog(self): return 300
    def write_analog(self, value): pass
    def write_digital(self, value): pass
    def set_analog_period(self, ms): periods.append(ms)
class Button:
    def was_pressed(self): return False
    def is_pressed(self): return False
class Display:
    def show(self, image): pass
class Image: HAPPY = "happy"
class Done(Exception): pass
def sleep(ms):
    clock[0] += ms + (1.4 if ms > 0 else 0)
class Motors:
    def set_speed(self, left, right): pass
class Sensor:
    def __init__(self, i): pass
    def value(self): return 300
class Buttons:
    def get_status(self): return [0, 0, 0, 1, 0]
def think(*sensors):
    steps.append(clock[0])
    if len(steps) > 1000: raise Done
    clock[0] += 7 + len(steps) % 3
    if len(steps) == 500: clock[0] += 600
    return 0.5, 0.5
ticks = {"ticks_ms": lambda: int(clock[0]) % period, "sleep_ms": sleep,
         "ticks_diff": lambda a, b: (a - b + period // 2) % period - period // 2}
for name, content in {
        "microbit": dict({"pin%d" % i: Pin() for i in range(17)}, button_a=Button(), button_b=Button(), display=Display(),
                         Image=Image, sleep=sleep, running_time=ticks["ticks_ms"]),
        "brain": {"RATE_HZ": 50, "think": think},
        "thymio": {"BUTTONS": Buttons, "MOTORS": Motors, "PROXIMITY": Sensor, "GROUND": Sensor},
        "time": ticks, "utime": ticks}.items():
    sys.modules[name] = types.ModuleType(name)
    sys.modules[name].__dict__.update(content)
source = open(sys.argv[1]).read()
if "def think" in source: source = source.replace("buttons = ", "think = THINK\nbuttons = ", 1)
try:
    exec(source, {"THINK": think})
except Done:
    pass
after = steps[500]
print((steps[499] - steps[0]) / 499, sum(after <= s < after + 400 for s in steps), sorted(set(periods)))
)py";

TEST(Micropython, KeepsItsRateForWeeksThoughSleepTakesLongerAndSetsThePeriodOfItsMotors) {
    const Folder folder;
    put_text(folder / "clock.py", with_clock);
    for (const char* robot : {"microbit", "thymio3"}) {
        const auto files = robots::export_brain({"2a-coward", find_preset("2a-coward")->brain, {}}, Target::micropython,
                                                *robots::find_robot(robot));
        ASSERT_TRUE(files);
        const bool pins = std::string_view(robot) == "microbit";
        put_text(folder / "program.py", file_of(*files, pins ? "main.py" : "brain.py"));
        const auto plan = robots::make_plan({"", find_preset("2a-coward")->brain, {}}, 50);
        put_text(folder / "calibration.txt",
                 fmt::format("{} 0 0 1000 1000 180 180 1023 1023", robots::arduino::calibration_mark(*plan)));
        const Ran ran = shell(fmt::format("cd '{}' && python3 clock.py program.py", folder.path.string()));
        ASSERT_EQ(ran.code, 0) << ran.out;
        std::istringstream numbers(ran.out);
        double step = 0;
        int after_a_wait = 0;
        numbers >> step >> after_a_wait;
        EXPECT_NEAR(step, 20, 0.05) << robot << ran.out;
        EXPECT_LE(after_a_wait, 24) << robot << " makes up for the steps of a wait of 600 ms: " << ran.out;
        EXPECT_NE(ran.out.find(pins ? "[4]" : "[]"), std::string::npos) << ran.out;
    }
}

// Runs main.py on a board of stand-ins. The words after it say what happens at each moment at which the program looks
// at a button: a, b, both or none of them is pressed, and a number is what all eyes read from then on. Prints what the
// display scrolls, "reset", the largest PWM of each wheel while it drives, and whether both turned at once.
constexpr const char* with_buttons = R"py(
import sys, types
class Done(BaseException): pass
class Reset(BaseException): pass
moments = sys.argv[2:]
state = {"a": False, "b": False, "eye": 300}
largest = {8: 0, 16: 0}
now = {8: 0, 16: 0}
both = [False]
def look():
    while moments and moments[0].isdigit(): state["eye"] = int(moments.pop(0))
    if not moments: raise Done
    word = moments.pop(0)
    state["a"] = word in ("a", "both")
    state["b"] = word in ("b", "both")
class Pin:
    def __init__(self, i): self.i = i
    def read_analog(self): return state["eye"]
    def write_analog(self, value):
        largest[self.i] = max(largest[self.i], value)
        now[self.i] = value
        both[0] = both[0] or (now[8] > 0 and now[16] > 0)
    def write_digital(self, value): pass
    def set_analog_period(self, ms): pass
class Button:
    def __init__(self, name): self.name = name
    def was_pressed(self):
        if self.name == "a": look()
        return state[self.name]
    def is_pressed(self): return state[self.name]
class Display:
    def show(self, image): print(image, end=" ")
    def clear(self): pass
    def scroll(self, text, delay=150): print(text, end=" ")
class Image: HAPPY = ":)"
def sleep(ms):
    if ms == 20: look()
def reset(): raise Reset
module = types.ModuleType("microbit")
module.__dict__.update({"pin%d" % i: Pin(i) for i in range(17)}, button_a=Button("a"), button_b=Button("b"),
                       display=Display(), Image=Image, sleep=sleep, reset=reset)
sys.modules["microbit"] = module
for name, content in {"brain": {"RATE_HZ": 1000, "think": lambda *sensors: (1, 1)},
                      "utime": {"ticks_ms": lambda: 0, "ticks_diff": lambda a, b: 0}}.items():
    sys.modules[name] = types.ModuleType(name)
    sys.modules[name].__dict__.update(content)
sys.path.insert(0, ".")
try:
    exec(open(sys.argv[1]).read(), {})
except Done:
    print("end", end=" ")
except Reset:
    print("reset", end=" ")
print(largest[8], largest[16], "both" if both[0] else "")
)py";

TEST(Micropython, CalibratesByItsButtonsKeepsTheValuesAndDrivesWithThem) {
    const Folder folder;
    put_text(folder / "buttons.py", with_buttons);
    const auto files = exported({"2a-coward", find_preset("2a-coward")->brain, {}});
    for (const char* name : {"main.py", "calibrate.py"}) put_text(folder / name, file_of(*files, name));
    const auto printed = [&](const std::string& moments) {
        const Ran ran =
            shell(fmt::format("cd '{}' && python3 -B buttons.py main.py {}", folder.path.string(), moments));
        EXPECT_EQ(ran.code, 0) << ran.out;
        return ran.out;
    };
    // The press before is forgotten.
    const std::string asked = "none a ";
    const std::string sensors = "100 " + asked + "110 " + asked + "100 " + asked + "900 " + asked + "90 " + asked +
                                "800 " + asked,
                      wheels = asked + "none none a " + asked + "none none none a ",
                      run = asked + "none a a " + asked + "none both both none";
    EXPECT_EQ(printed(sensors + wheels + run),
              "P0: 0 P0: 1 P0: 0 = 1 P0: 0 P0: 1 P1: 0 P1: 1 L R GO ? GO ? reset 617 618 both\n");
    const auto numbers = text_of(folder / "calibration.txt");
    EXPECT_TRUE(numbers.ends_with(" 100 90 900 800 8 12 1023 1003")) << numbers;
    EXPECT_EQ(printed("none none"), ":) end 0 0 \n") << "the kept values";
    EXPECT_EQ(printed("none a none"), ":) :) end 1023 1003 both\n") << "button A";
    EXPECT_EQ(printed("b none"), ":) [300, 300]\nend 0 0 \n") << "button B";
    put_text(folder / "calibration.txt", numbers.substr(0, 12));
    EXPECT_EQ(printed("none a"), "P0: 0 end 0 0 \n") << "a file that was cut";
}

TEST(MicropythonOnMicrobit, KeepsItsCalibrationInAFileOfTheBoard) {
    if (!has_tool("firmware-microbit-micropython")) GTEST_SKIP() << "./dev robots installs an emulator and MicroPython";
    const Folder folder;
    const BrainToExport brain{"", make_graph({.LL = 1, .RR = 1}), {}};
    const auto files = exported(brain);
    ASSERT_TRUE(files);
    put_text(folder / "calibrate.py", file_of(*files, "calibrate.py"));
    const Ran ran = shell(fmt::format("python3 '{}/microbit_calibrate.py' '{}'", BRAITENLAB_SOURCE "/tests/robots/run",
                                      (folder / "calibrate.py").string()));
    EXPECT_EQ(ran.code, 0) << ran.out;
    const unsigned mark = robots::arduino::calibration_mark(*robots::make_plan(brain, 50));
    EXPECT_EQ(ran.out, fmt::format("{} 100 100 900 900 0 0 1023 1023\n", mark));
}

TEST(Micropython, ListsPartsThatWorkAtThreeVoltsInEveryFile) {
    for (const Channel channel : {Channel::light, Channel::obstacle, Channel::smell, Channel::energy, Channel::touch}) {
        const auto files = exported({"", make_graph({.LL = 1}), {{.name = "SL", .channel = channel}}});
        ASSERT_TRUE(files);
        for (const char* name : {"parts.csv", "README.md", "wiring.svg"}) {
            const std::string& text = file_of(*files, name);
            EXPECT_EQ(text.find("GP2Y0A21"), std::string::npos) << name;
            EXPECT_EQ(text.find("to 5 V"), std::string::npos) << name;
            EXPECT_EQ(text.find("1.5 kΩ") != std::string::npos, channel == Channel::light) << name;
        }
        const robots::SensorPart part = robots::part_of({"SL", "sensor_SL", channel}, robots::Board::microbit);
        if (channel != Channel::energy) {
            EXPECT_NE(file_of(*files, "parts.csv").find(part.part), std::string::npos) << part.part;
        }
    }
}

// A neuron with a memory of this many seconds.
BrainToExport memory_of(float seconds) {
    BrainGraph graph = make_graph({});
    graph.nodes.push_back({.id = 50, .kind = NodeKind::neuron, .name = "N", .time_constant = seconds});
    graph.wires.push_back({.from = find_node(graph, "SL")->id, .to = 50, .weight = 1});
    graph.wires.push_back({.from = 50, .to = find_node(graph, "ML")->id, .weight = 1});
    return {"memory", graph, {}};
}

TEST(MicropythonOnMicrobit, ComputesWhatTheLabComputesForEveryShippedBrainThatItHolds) {
    if (!has_tool("firmware-microbit-micropython")) GTEST_SKIP() << "./dev robots installs an emulator and MicroPython";
    const Folder folder;
    each_exported(Target::micropython, "microbit", [&](const BrainToExport& brain, const auto& files) {
        const Compared found = compare(folder, brain, 150, false);
        EXPECT_EQ(found.rows, 150u) << brain.title;
        EXPECT_LE(found.worst, 1e-4) << brain.title;
        std::printf("%-28s %5zu bytes, worst %.6f\n", brain.title.c_str(), files.front().text.size(), found.worst);
    });
}

// A sum that is cut in each of 2,000 steps loses 0.00004.
TEST(MicropythonOnMicrobit, KeepsASlowMemoryAsExactAsOtherValues) {
    if (!has_tool("firmware-microbit-micropython")) GTEST_SKIP() << "./dev robots installs an emulator and MicroPython";
    const Folder folder;
    BrainToExport learner = memory_of(30);
    learner.brain.wires[0].learning_rate = 0.05f, learner.brain.wires[0].decay = 0.01f;
    for (const BrainToExport& brain : {memory_of(30), learner}) {
        const Compared found = compare(folder, brain, 2000, false);
        EXPECT_EQ(found.rows, 2000u);
        EXPECT_LE(found.worst, 1e-5);
        std::printf("worst %.6f\n", found.worst);
    }
}

TEST(MicropythonOnMicrobit, HoldsABrainOfTheLargestSize) {
    if (!has_tool("firmware-microbit-micropython")) GTEST_SKIP() << "./dev robots installs an emulator and MicroPython";
    const Folder folder;
    const BrainToExport brain = ring(largest_ring());
    EXPECT_GT(exported(brain)->front().text.size(), 2200u);
    const Compared found = compare(folder, brain, 150, false);
    EXPECT_EQ(found.rows, 150u);
    EXPECT_LE(found.worst, 1e-4);
}

}  // namespace
}  // namespace braitenlab::tests::micropython_test
