#include "core/export/export.h"

#include <optional>

#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/micropython.h"
#include "core/export/opamp.h"
#include "core/export/thymio.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"

namespace braitenlab::robots {

namespace {

using Refusal = std::optional<Error>;

Error refused(std::string what) { return Error{std::move(what), {}, 0, {}}; }

std::size_t wires_of(const Plan& plan) {
    std::size_t wires = 0;
    for (const PlanUnit& unit : plan.units) wires += unit.taps.size();
    return wires;
}

Refusal check_robot(Target target, const Robot& robot) {
    if (row_of(target).robot == robot.name) return std::nullopt;
    return refused(fmt::format("the target {} is for the robot {}, not for {}; choose --to for this robot",
                               word(target), in_quotes(std::string(row_of(target).robot)),
                               in_quotes(std::string(robot.name))));
}

Refusal check_arduino(const Plan& plan) {
    for (const Input& input : plan.inputs)
        if (arduino::part_of(input).part.empty())
            return refused(fmt::format("the sensor {} senses {}, for which the robot has no part; cut its wires",
                                       in_quotes(input.name), word(*input.channel)));
    if (plan.inputs.size() > static_cast<std::size_t>(arduino::analog_inputs))
        return refused(
            fmt::format("the sensor {} has no pin: an Arduino Uno has {} analog inputs and the brain uses {} "
                        "sensors; cut the wires of some",
                        in_quotes(plan.inputs[static_cast<std::size_t>(arduino::analog_inputs)].name),
                        arduino::analog_inputs, plan.inputs.size()));
    if (plan.hidden() > static_cast<std::size_t>(arduino::most_neurons))
        return refused(fmt::format("{} neurons do not fit into the memory of an Arduino Uno, which holds {}",
                                   plan.hidden(), arduino::most_neurons));
    if (wires_of(plan) > static_cast<std::size_t>(arduino::most_wires))
        return refused(fmt::format("{} wires do not fit into the program memory of an Arduino Uno, which holds {}",
                                   wires_of(plan), arduino::most_wires));
    return std::nullopt;
}

std::vector<ExportedFile> arduino_files(const Plan& plan) {
    return {{"braitenberg/braitenberg.ino", arduino::sketch(plan)},
            {"braitenberg/brain.h", c_header(plan)},
            {"README.md", arduino::readme(plan)},
            {"parts.csv", arduino::parts_csv(plan)},
            {"wiring.svg", arduino::wiring_svg(plan)}};
}

}  // namespace

Result<std::vector<ExportedFile>> export_brain(const BrainToExport& given, Target target, const Robot& robot) {
    if (const auto refusal = check_robot(target, robot)) return *refusal;
    const auto plan = make_plan(given, static_cast<float>(robot.rate_hz));
    if (!plan) return plan.error();
    switch (target) {
        case Target::c:
            return std::vector<ExportedFile>{{"brain.h", c_header(*plan)}};
        case Target::arduino:
            if (const auto refusal = check_arduino(*plan)) return *refusal;
            return arduino_files(*plan);
        case Target::thymio:
            if (const auto refusal = thymio::refusal(*plan)) return *refusal;
            return std::vector<ExportedFile>{{"brain.aesl", thymio::program(*plan)}};
        case Target::micropython:
            if (const auto refusal = micropython::refusal(*plan)) return *refusal;
            return std::vector<ExportedFile>{{"brain.py", micropython::brain_py(*plan)},
                                             {"main.py", micropython::main_py(*plan)},
                                             {"README.md", micropython::readme(*plan)}};
        case Target::opamp:
            if (const auto refusal = opamp::refusal(*plan)) return *refusal;
            return std::vector<ExportedFile>{{"brain.cir", opamp::netlist(*plan, false)},
                                             {"brain-exact.cir", opamp::netlist(*plan, true)},
                                             {"brain.net", opamp::kicad_netlist(*plan)},
                                             {"README.md", opamp::readme(*plan)},
                                             {"parts.csv", opamp::parts_csv(*plan)}};
    }
    return refused("unknown target");
}

}  // namespace braitenlab::robots
