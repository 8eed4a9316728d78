#include "core/export/micropython.h"

#include <cmath>

#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/sensor_parts.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"

namespace braitenlab::robots::micropython {

namespace {

// The response curves, as core/brain/curve.h defines them. An exponent above 80 gives the same float as 80.
struct Function {
    Response response;
    std::string_view text;
};
constexpr Function functions[] = {
    {Response::rectified, "def rectified(x):\n    return x if x > 0 else 0.0\n"},
    {Response::step, "def step(x, threshold):\n    return 1.0 if x >= threshold else 0.0\n"},
    {Response::sigmoid, "def sigmoid(x, centre, width):\n    return 1 / (1 + exp(min(80, -(x - centre) / width)))\n"},
    {Response::hump, "def hump(x, peak, width):\n    t = (x - peak) / width\n    return exp(-min(80, t * t))\n"},
    {Response::inverted, "def inverted(x):\n    return 1 - x\n"},
};

// Floats of the micro:bit have 22 significant bits and are cut, not rounded. What many small steps lose would add up,
// so it is carried to the next step (W. Kahan, Communications of the ACM 8, 1965).
constexpr std::string_view added_text =
    "\n\n# The sum, and what a float is too short for: it is added to the next step.\n"
    "def added(value, step):\n    total = value + step\n    return total, step - (total - value)\n";

std::string through(const Curve& curve, const std::string& x) {
    const ResponseTraits& row = traits(curve.response);
    if (curve.response == Response::linear) return x;
    std::string text = fmt::format("{}({}", row.word, x);
    if (row.has_peak) text += ", " + number(curve.peak);
    if (row.has_width) text += ", " + number(curve.width);
    return text + ")";
}

// Values of the previous step are global; those of this step have "new_" before their name.
std::string reading(const Plan& plan, const PlanTap& tap) {
    const auto index = static_cast<std::size_t>(tap.source);
    if (tap.reads == Reads::sensor) return plan.inputs[index].id;
    return (tap.reads == Reads::now ? "new_" : "") + plan.units[index].id;
}

std::string product(const Plan& plan, const PlanTap& tap) {
    std::string x = reading(plan, tap);
    if (tap.threshold > 0) x = fmt::format("masked({}, {})", x, number(tap.threshold));
    const std::string weight =
        tap.learned_id.empty() ? number(tap.weight) : fmt::format("({} + {})", number(tap.weight), tap.learned_id);
    return fmt::format("    s += {} * {}\n", weight, through(tap.curve, x));
}

std::string lines_of(const Plan& plan, const PlanUnit& unit, bool motor) {
    std::string text = fmt::format("    # {} {}\n    s = {}\n", motor ? "motor" : "neuron", comment_text(unit.name),
                                   number(unit.bias));
    for (const PlanTap& tap : unit.taps) text += product(plan, tap);
    const std::string result = "new_" + unit.id;
    std::string value = through(unit.curve, "s");
    if (unit.follow < 1) {
        text += fmt::format("    {0}, rest_{1} = added({1}, {2} * ({3} - {1}) + rest_{1})\n", result, unit.id,
                            number(unit.follow), value);
        value = result;
    }
    if (unit.value.low <= -largest_value || unit.value.high >= largest_value)
        value = fmt::format("max(-1000.0, min(1000.0, {}))", value);
    return value == result ? text : text + fmt::format("    {} = {}\n", result, value);
}

std::string learning(const Plan& plan) {
    std::string text;
    for (const PlanUnit& unit : plan.units)
        for (const PlanTap& tap : unit.taps) {
            if (tap.learned_id.empty()) continue;
            text += fmt::format(
                "    # learns while both ends are active, and fades\n"
                "    {0}, rest_{0} = added({0}, ({1} * {2} * new_{3} - {4} * {0}) / RATE_HZ + rest_{0})\n"
                "    {0} = max({5}, min({6}, {0}))\n",
                tap.learned_id, number(tap.learning_rate), reading(plan, tap), unit.id, number(tap.decay),
                number(-limits::weight - tap.weight), number(limits::weight - tap.weight));
        }
    return text;
}

std::string eyes_of(const Plan& plan) {
    std::string eyes;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) eyes += fmt::format("{}pin{}", i > 0 ? ", " : "", i);
    return eyes;
}

}  // namespace

std::optional<Error> refusal(const Plan& plan) {
    if (auto fault = pin_fault(plan, "micro:bit", analog_inputs)) return fault;
    const std::size_t bytes = brain_py(plan).size();
    if (bytes > static_cast<std::size_t>(largest_brain)) return too_large(plan, bytes, "micro:bit", largest_brain);
    return std::nullopt;
}

Error too_large(const Plan& plan, std::size_t bytes, std::string_view robot, int largest) {
    std::size_t most = 0;
    const PlanUnit* longest = &plan.units.front();
    for (std::size_t u = 0; u < plan.units.size(); ++u)
        if (const std::size_t part = lines_of(plan, plan.units[u], u >= plan.hidden()).size(); part > most)
            most = part, longest = &plan.units[u];
    return error_of(message_of("program_bytes", bytes, most, in_quotes(longest->name), robot, largest));
}

bool needs_exp(const Plan& plan) { return has_response(plan, Response::sigmoid) || has_response(plan, Response::hump); }

std::string think_py(const Plan& plan) {
    std::string text = fmt::format("RATE_HZ = {:g}\n", plan.rate_hz);
    std::string kept, stored;
    bool any_sum = false;
    const auto keep = [&](const std::string& id) {
        text += id + " = 0.0\n";
        kept += (kept.empty() ? "" : ", ") + id;
    };
    const auto keep_sum = [&](const std::string& id) {
        keep(id), keep("rest_" + id);
        any_sum = true;
    };
    for (const PlanUnit& unit : plan.units) {
        if (!unit.is_kept) continue;
        unit.follow < 1 ? keep_sum(unit.id) : keep(unit.id);
        stored += fmt::format("    {0} = new_{0}\n", unit.id);
    }
    for (const PlanUnit& unit : plan.units)
        for (const PlanTap& tap : unit.taps)
            if (!tap.learned_id.empty()) keep_sum(tap.learned_id);
    if (any_sum) text += added_text;
    if (has_threshold(plan)) text += "\n\ndef masked(x, threshold):\n    return 0.0 if abs(x) < threshold else x\n";
    for (const Function& function : functions)
        if (has_response(plan, function.response)) text += "\n\n" + std::string(function.text);
    std::string parameters;
    for (const Input& input : plan.inputs) parameters += (parameters.empty() ? "" : ", ") + input.id;
    text += fmt::format(
        "\n\n# Sensors 0 to 1; returns the commands of the left and the right wheel, -1 to 1.\n"
        "def think({}):\n",
        parameters);
    if (!kept.empty()) text += fmt::format("    global {}\n", kept);
    for (std::size_t u = 0; u < plan.units.size(); ++u) text += lines_of(plan, plan.units[u], u >= plan.hidden());
    text += learning(plan) + stored;
    return text + fmt::format("    return max(-1, min(1, new_{})), max(-1, min(1, new_{}))\n",
                              plan.units[plan.hidden()].id, plan.units[plan.hidden() + 1].id);
}

std::string brain_py(const Plan& plan) {
    return fmt::format("# The brain \"{}\", exported from Braitenlab. Call think() {:g} times per second.\n{}{}",
                       comment_text(plan.title), plan.rate_hz, needs_exp(plan) ? "from math import exp\n\n" : "",
                       think_py(plan));
}

std::string main_py(const Plan& plan) {
    std::string arguments;
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) arguments += fmt::format("{}eye({})", i > 0 ? ", " : "", i);
    return filled(texts::main_py, {{"TITLE", comment_text(plan.title)},
                                   {"MARK", std::to_string(arduino::calibration_mark(plan))},
                                   {"EYES", eyes_of(plan)},
                                   {"ARGUMENTS", arguments},
                                   {"SMALLEST", number(arduino::smallest_command)}});
}

std::string calibrate_py(const Plan& plan) {
    return filled(texts::calibrate_py, {{"TITLE", comment_text(plan.title)},
                                        {"MARK", std::to_string(arduino::calibration_mark(plan))},
                                        {"EYES", eyes_of(plan)}});
}

std::string readme(const Plan& plan) {
    std::string sensors;
    const std::vector<SensorPart> parts = parts_of(plan, Board::microbit);
    for (std::size_t i = 0; i < parts.size(); ++i)
        sensors += fmt::format("| {} | P{} | {} | {} | 0: {}, 1: {}{} |\n", table_cell(plan.inputs[i].name), i,
                               place_text(plan.inputs[i]), joining_text(parts[i]), parts[i].zero, parts[i].one,
                               doubt_about(plan.inputs[i]));
    const int warm_up = warm_up_of(parts);
    const double load = board_milliamperes(parts);
    return filled(texts::micropython_readme_md,
                  {{"TITLE", comment_text(plan.title)},
                   {"BYTES", std::to_string(brain_py(plan).size())},
                   {"PLACES", places_text(plan, Board::microbit)},
                   {"SENSORS", sensors},
                   {"OWN_SUPPLY", own_supply_text(parts, "micro:bit")},
                   {"WARM_UP", warm_up == 0 ? ""
                                            : fmt::format("\nHeated sensors read steadily after {} minutes only: wait "
                                                          "for that before you calibrate, and before\neach drive.\n",
                                                          warm_up / 60)},
                   {"VERSION_2", load <= version_1_milliamperes
                                     ? ""
                                     : fmt::format("The sensors take up to {:.0f} mA from its 3 V; a micro:bit of "
                                                   "version 1 gives {:.0f} mA by USB: take one of version 2.\n",
                                                   std::ceil(load), version_1_milliamperes)}});
}

}  // namespace braitenlab::robots::micropython
