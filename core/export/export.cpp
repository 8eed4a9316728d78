#include "core/export/export.h"

#include <optional>

#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/micropython.h"
#include "core/export/opamp.h"
#include "core/export/sensor_parts.h"
#include "core/export/thymio.h"
#include "core/export/thymio3.h"
#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"

namespace braitenlab::robots {

namespace {

using Refusal = std::optional<Error>;

Error refused(std::string what) { return Error{std::move(what), {}, 0, {}}; }

Refusal check_robot(Target target, const Robot& robot) {
    if (robot.target == target) return std::nullopt;
    return refused(fmt::format("the target {} is not for the robot {}; its target is {}", word(target),
                               in_quotes(std::string(robot.name)), word(robot.target)));
}

// A brain alone has no sensors; that of a vehicle reads those of the vehicle.
Refusal check_sensors(const Plan& plan, const std::vector<Sensor>& sensors) {
    for (const Input& input : plan.inputs)
        if (!sensors.empty() && !input.channel) return error_of(message_of("no_such_sensor", in_quotes(input.name)));
    return std::nullopt;
}

Refusal check_arduino(const Plan& plan, int robot_rate) {
    const std::string_view board = "Arduino Uno";
    if (auto fault = pin_fault(plan, board, arduino::analog_inputs)) return fault;
    if (plan.hidden() > static_cast<std::size_t>(arduino::most_neurons))
        return error_of(message_of("program_neurons", plan.hidden(), board, arduino::most_neurons));
    const arduino::Cost cost = arduino::cost_of(plan);
    if (cost.bytes > arduino::largest_program)
        return error_of(message_of("program_flash", cost.bytes, board, arduino::largest_program));
    if (!arduino::rate_for(cost, robot_rate))
        return error_of(message_of("program_time", (cost.cycles + 15999) / 16000, board, 1000 / arduino::lowest_rate));
    return std::nullopt;
}

Result<std::vector<ExportedFile>> arduino_files(const BrainToExport& given, const Plan& fast, int robot_rate) {
    if (const auto refusal = check_arduino(fast, robot_rate)) return *refusal;
    // Memories follow the rate.
    const auto slow = make_plan(given, static_cast<float>(*arduino::rate_for(arduino::cost_of(fast), robot_rate)));
    if (!slow) return slow.error();
    const Plan& plan = *slow;
    return std::vector<ExportedFile>{{"braitenberg/braitenberg.ino", arduino::sketch(plan)},
                                     {"braitenberg/brain.h", c_header(plan, Curves::looked_up)},
                                     {"README.md", arduino::readme(plan, robot_rate)},
                                     {"parts.csv", arduino::parts_csv(plan)},
                                     {"wiring.svg", arduino::wiring_svg(plan)}};
}

Result<std::vector<ExportedFile>> micropython_files(const Plan& plan, const Robot& robot) {
    if (robot.is_thymio) {
        if (const auto refusal = thymio3::refusal(plan)) return *refusal;
        return std::vector<ExportedFile>{{"brain.py", thymio3::program(plan)}, {"README.md", thymio3::readme(plan)}};
    }
    if (const auto refusal = micropython::refusal(plan)) return *refusal;
    return std::vector<ExportedFile>{
        {"brain.py", micropython::brain_py(plan)},         {"main.py", micropython::main_py(plan)},
        {"calibrate.py", micropython::calibrate_py(plan)}, {"README.md", micropython::readme(plan)},
        {"parts.csv", micropython::parts_csv(plan)},       {"wiring.svg", micropython::wiring_svg(plan)}};
}

std::vector<ExportedFile> opamp_files(const Plan& plan) {
    std::vector<ExportedFile> files{{"brain.cir", opamp::netlist(plan, false)},
                                    {"brain-exact.cir", opamp::netlist(plan, true)},
                                    {"brain.net", opamp::kicad_netlist(plan)},
                                    {"README.md", opamp::readme(plan)},
                                    {"parts.csv", opamp::parts_csv(plan)}};
    files.push_back({"robot.svg", opamp::robot_svg(plan)});
    const std::vector<std::string> sheets = opamp::wiring_sheets(plan);
    for (std::size_t i = 0; i < sheets.size(); ++i)
        files.push_back({i == 0 ? "wiring.svg" : fmt::format("wiring-{}.svg", i + 1), sheets[i]});
    return files;
}

}  // namespace

Result<std::vector<ExportedFile>> export_brain(const BrainToExport& given, Target target, const Robot& robot) {
    if (const auto refusal = check_robot(target, robot)) return *refusal;
    const auto plan = make_plan(given, static_cast<float>(robot.rate_hz));
    if (!plan) return plan.error();
    if (const auto refusal = check_sensors(*plan, given.sensors)) return *refusal;
    switch (target) {
        case Target::c:
            return std::vector<ExportedFile>{{"brain.h", c_header(*plan)}, {"README.md", c_readme(*plan)}};
        case Target::arduino:
            return arduino_files(given, *plan, robot.rate_hz);
        case Target::thymio:
            if (const auto refusal = thymio::refusal(*plan)) return *refusal;
            return std::vector<ExportedFile>{{"brain.aesl", thymio::program(*plan)},
                                             {"README.md", thymio::readme(*plan)}};
        case Target::micropython:
            return micropython_files(*plan, robot);
        case Target::opamp:
            if (const auto refusal = opamp::refusal(*plan)) return *refusal;
            return opamp_files(*plan);
    }
    return refused("unknown target");
}

std::vector<Error> export_warnings(const BrainToExport& given, const Robot& robot) {
    if (robot.target == Target::c || robot.is_thymio) return {};  // these have no list of parts
    const auto plan = make_plan(given, static_cast<float>(robot.rate_hz));
    if (!plan) return {};
    if (robot.target != Target::opamp)
        return place_warnings(*plan, robot.target == Target::arduino ? Board::uno : Board::microbit);
    std::vector<Error> found = opamp::warnings(*plan);
    for (Error& warning : place_warnings(*plan, Board::circuit)) found.push_back(std::move(warning));
    return found;
}

}  // namespace braitenlab::robots
