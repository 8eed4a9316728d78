// Simulators of robots: simavr for the Arduino, Aseba's virtual machine for the Thymio II. Tests use them after
// has_tool() only.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/robots/exported.h"

namespace braitenlab::tests {

// The firmware of exported sketches. Arduino's core is compiled once.
class Simulator {
public:
    Simulator() {
        const std::string source = BRAITENLAB_SOURCE "/tests/robots/run/";
        const Ran ran =
            shell(fmt::format("cd '{0}' && mkdir -p core && cd core && "
                              "for f in {1}/cores/arduino/*.c; do avr-gcc -std=gnu11 {2} -c $f || exit 1; done && "
                              "for f in {1}/cores/arduino/*.cpp; do avr-g++ -std=gnu++11 -fno-exceptions "
                              "-fno-threadsafe-statics {2} -c $f || exit 1; done && "
                              "avr-gcc-ar rcs ../core.a *.o && cd .. && "
                              "gcc -std=gnu11 -O2 -Wall -Werror '{3}simavr_run.c' -o simavr_run -lsimavr -lelf",
                              folder.path.string(), arduino, flags, source));
        EXPECT_EQ(ran.code, 0) << ran.out;
    }

    // Compiles the sketch without warnings of its own; false and a failure if that is impossible.
    bool compile(const std::vector<robots::ExportedFile>& files) {
        for (const auto& file : files) put_text(folder / file.name, file.text);
        put_text(folder / "sketch.cpp", "#include <Arduino.h>\n#include \"braitenberg/braitenberg.ino\"\n");
        const Ran ran =
            shell(fmt::format("cd '{}' && avr-g++ -std=gnu++11 {} -Wall -Wextra -Werror -I {}/libraries/EEPROM/src -I "
                              "braitenberg -c sketch.cpp && "
                              "avr-g++ -mmcu=atmega328p -Os -Wl,--gc-sections -o sketch.elf sketch.o core.a -lm && "
                              "avr-size sketch.elf | tail -1",
                              folder.path.string(), flags, arduino));
        EXPECT_EQ(ran.code, 0) << ran.out;
        size = ran.out;
        return ran.code == 0;
    }

    // `step_ms`: the time between two steps of the sketch.
    Ran run(std::size_t inputs, const std::string& lines, const std::string& mode = "", double step_ms = 20) {
        put_text(folder / "lines", lines);
        Ran ran = shell(fmt::format("cd '{}' && STEP_MS={} ./simavr_run sketch.elf {} results {} < lines",
                                    folder.path.string(), step_ms, inputs, mode));
        if (ran.code == 0) ran.out = text_of(folder / "results");
        return ran;
    }

    // Program memory of the sketch in bytes.
    int program_bytes() const {
        std::istringstream words(size);
        int text = 0, data = 0;
        words >> text >> data;
        return text + data;
    }

    std::string size;
    Folder folder;

private:
    const std::string arduino = "/usr/share/arduino/hardware/arduino/avr";
    const std::string flags =
        "-mmcu=atmega328p -DF_CPU=16000000L -DARDUINO=10819 -DARDUINO_AVR_UNO -DARDUINO_ARCH_AVR "
        "-DDECIMAL_DIG=__DECIMAL_DIG__ -Os -ffunction-sections -fdata-sections -I " +
        arduino + "/cores/arduino -I " + arduino + "/variants/standard";
};

struct Calibrated {
    int dark = 0, bright = 1000;  // of every sensor
    int minimum[2] = {0, 0}, fastest[2] = {255, 255};
};

// The bytes that a calibration leaves in the EEPROM. `mark`: that of the sketch.
inline std::string eeprom(const Calibrated& c, std::size_t inputs, unsigned mark) {
    const auto word16 = [](int value) { return fmt::format("{:02x}{:02x}", value & 255, value >> 8 & 255); };
    std::string bytes = word16(static_cast<int>(mark));
    for (std::size_t i = 0; i < inputs; ++i) bytes += word16(c.dark);
    for (std::size_t i = 0; i < inputs; ++i) bytes += word16(c.bright);
    for (const int value : {c.minimum[0], c.minimum[1], c.fastest[0], c.fastest[1]})
        bytes += fmt::format("{:02x}", value);
    return bytes + fmt::format("{:02x}", inputs + 3);  // steps that are done: all
}

class VirtualMachine {
public:
    VirtualMachine() {
        // Aseba's compiler asks for this locale.
        const Ran ran =
            shell(fmt::format("cd '{0}' && mkdir locale && localedef -i en_US -f UTF-8 locale/en_US.UTF-8 && "
                              "g++ -std=c++17 -O1 -Wall -Werror -I/usr/include/aseba '{1}/aseba_run.cpp' "
                              "-o aseba_run -lasebacompiler -lasebavm -lasebacommon",
                              folder.path.string(), BRAITENLAB_SOURCE "/tests/robots/run"));
        EXPECT_EQ(ran.code, 0) << ran.out;
    }
    Ran run(const std::string& aesl, const std::string& lines) {
        put_text(folder / "program", code_of(aesl));
        put_text(folder / "lines", lines);
        return shell(fmt::format("cd '{}' && LOCPATH=$PWD/locale ./aseba_run program < lines", folder.path.string()));
    }

    Folder folder;

    static std::string code_of(const std::string& aesl) {
        const std::size_t node = aesl.find("<node "), start = aesl.find('>', node) + 1;
        std::string code = aesl.substr(start, aesl.find("</node>") - start);
        const std::pair<const char*, const char*> entities[] = {
            {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}};
        for (const auto& [entity, character] : entities)
            for (std::size_t at = 0; (at = code.find(entity, at)) != std::string::npos; ++at)
                code.replace(at, std::string(entity).size(), character);
        return code;
    }
};

// Raw proximity values and reflectances for the readings of the brain's sensors.
inline std::string raw_line(const robots::Plan& plan, const std::vector<float>& sensed) {
    long prox[7] = {}, ground[2] = {};
    for (std::size_t i = 0; i < sensed.size(); ++i) {
        const std::string& name = plan.inputs[i].name;
        const bool left = name.back() == 'L', right = name.back() == 'R';
        const double value = sensed[i];
        if (plan.inputs[i].channel == Channel::floor)
            ground[right ? 1 : 0] = std::lround(1000 * value);
        else
            prox[left ? 0 : right ? 4 : 2] = std::lround(1000 + 3300 * value);
    }
    std::string line;
    for (const long value : prox) line += fmt::format("{} ", value);
    return line + fmt::format("{} {}\n", ground[0], ground[1]);
}

}  // namespace braitenlab::tests
