// Closed loop: the exported program in the simulator of its processor drives a vehicle of the lab. Readings go in,
// wheel commands come out, the physics is the lab's.
#include <cmath>
#include <functional>
#include <memory>

#include <unistd.h>

#include "core/export/arduino.h"
#include "core/world/world.h"
#include "tests/robots/exported.h"
#include "tests/robots/simulators.h"

namespace braitenlab::tests::closed_loop_test {
namespace {

// A program that answers each line with one.
class Conversation {
public:
    // The program answers to the file descriptor 3 where `answers` is 3, to standard output where it is 1.
    Conversation(const std::string& command, int answers) {
        int in[2], out[2];
        if (pipe(in) != 0 || pipe(out) != 0) return;
        child_ = fork();
        if (child_ == 0) {
            dup2(in[0], 0);
            dup2(out[1], answers);
            for (const int end : {in[0], in[1], out[0], out[1]})
                if (end != answers) close(end);
            execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
            _exit(127);
        }
        close(in[0]), close(out[1]);
        to_ = fdopen(in[1], "w"), from_ = fdopen(out[0], "r");
    }
    ~Conversation() {
        fclose(to_), fclose(from_);
        waitpid(child_, nullptr, 0);
    }
    Conversation(const Conversation&) = delete;
    Conversation& operator=(const Conversation&) = delete;

    void say(const std::string& line) { fputs((line + "\n").c_str(), to_), fflush(to_); }
    std::string answer() {
        char line[256] = "";
        return fgets(line, sizeof line, from_) ? line : "";
    }

private:
    pid_t child_ = -1;
    FILE *to_ = nullptr, *from_ = nullptr;
};

struct Commands {
    float left = 0, right = 0;
};

// The robot's program: readings of SL and SR in, commands out.
using Program = std::function<Commands(float left_eye, float right_eye)>;

Scene aggressor(bool by_hand) {
    Scene scene = *load_scene(BRAITENLAB_SOURCE "/exercises/scenes/2b-aggressor.toml");
    if (by_hand) scene.kinds[0].driver = Driver::manual;
    return scene;
}

// Whether the vehicle touches the lamp within 15 s. Without a program its own brain drives it.
bool touches(std::uint64_t seed, const Program& program, double rate_hz) {
    auto world = World::create(aggressor(program != nullptr), seed);
    Snapshot now;
    double steps = 0;
    for (int tick = 0; tick < 15 * 60; ++tick) {
        world->capture(now);
        const VehicleView& vehicle = now.vehicles[0];
        const Source& lamp = now.scene->sources[0];
        if (std::hypot(vehicle.x - lamp.x, vehicle.y - lamp.y) < 0.75f) return true;
        const auto eyes = static_cast<std::size_t>(vehicle.first_sensed);
        if (program && steps <= tick * rate_hz / 60) {
            steps += 1;
            const Commands commands = program(now.sensed[eyes], now.sensed[eyes + 1]);
            EXPECT_FALSE(world->apply(Steer{vehicle.id, commands.left, commands.right}));
        }
        world->step();
    }
    return false;
}

int touching_starts(const std::function<Program(std::uint64_t seed)>& program, double rate_hz) {
    int touching = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) touching += touches(seed, program(seed), rate_hz);
    std::printf("%d of 10 starts touch the lamp\n", touching);
    return touching;
}

robots::BrainToExport exported_aggressor() {
    const Kind kind = aggressor(false).kinds[0];
    return {"2b-aggressor", kind.brain, kind.sensors};
}

TEST(ClosedLoop, TheBrainItselfTouchesTheLamp) {
    EXPECT_GE(touching_starts([](std::uint64_t) { return Program(); }, 60), 8);
    // The measure is no formality: the coward touches none.
    EXPECT_EQ(touching_starts([](std::uint64_t) { return [](float l, float r) { return Commands{l, r}; }; }, 60), 0);
}

TEST(ClosedLoop, TheArduinoSketchInSimavrTouchesTheLamp) {
    if (!has_tool("libsimavr-dev")) GTEST_SKIP() << "./dev robots installs avr-gcc and simavr";
    Simulator simulator;
    const auto files =
        robots::export_brain(exported_aggressor(), robots::Target::arduino, *robots::find_robot("tt2wd-ldr"));
    ASSERT_TRUE(files && simulator.compile(*files));
    std::shared_ptr<Conversation> sketch;
    const auto program = [&](std::uint64_t) -> Program {
        sketch.reset();  // ends the process of the start before, which the next one would keep alive
        sketch = std::make_shared<Conversation>(
            "cd '" + simulator.folder.path.string() + "' && exec ./simavr_run sketch.elf 2 /dev/fd/3 live >/dev/null",
            3);
        sketch->say(eeprom({}, 2, robots::arduino::calibration_mark(*robots::make_plan(exported_aggressor(), 50))));
        return [&, first = true](float left, float right) mutable {
            sketch->say(fmt::format("{} {}", std::lround(1000 * left), std::lround(1000 * right)));
            if (std::exchange(first, false)) return Commands{};  // the wheels are known when the next step begins
            int l = 0, r = 0;
            EXPECT_EQ(std::sscanf(sketch->answer().c_str(), "%d %d", &l, &r), 2);
            return Commands{static_cast<float>(l) / 255, static_cast<float>(r) / 255};
        };
    };
    EXPECT_GE(touching_starts(program, 50), 8);
}

TEST(ClosedLoop, TheThymioProgramInAsebaTouchesTheLamp) {
    if (!has_tool("aseba")) GTEST_SKIP() << "./dev robots installs Aseba";
    VirtualMachine machine;
    const robots::BrainToExport brain = exported_aggressor();
    const auto plan = robots::make_plan(brain, 10);
    const auto files = robots::export_brain(brain, robots::Target::thymio, *robots::find_robot("thymio2"));
    ASSERT_TRUE(plan && files);
    put_text(machine.folder / "program", VirtualMachine::code_of(files->front().text));
    std::shared_ptr<Conversation> thymio;
    const auto program = [&](std::uint64_t) -> Program {
        thymio.reset();
        thymio = std::make_shared<Conversation>(
            "cd '" + machine.folder.path.string() + "' && LOCPATH=$PWD/locale exec ./aseba_run program", 1);
        thymio->answer();  // the number of words
        thymio->say("forward");
        return [&](float left, float right) {
            std::string line = raw_line(*plan, {left, right});
            line.pop_back();
            thymio->say(line);
            int l = 0, r = 0;
            EXPECT_EQ(std::sscanf(thymio->answer().c_str(), "%d %d", &l, &r), 2);
            return Commands{static_cast<float>(l) / 500, static_cast<float>(r) / 500};
        };
    };
    EXPECT_GE(touching_starts(program, 10), 8);
}

}  // namespace
}  // namespace braitenlab::tests::closed_loop_test
