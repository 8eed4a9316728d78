#include "core/export/thymio.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/export/text.h"
#include "core/export/thymio_places.h"
#include "core/messages.h"
#include "core/scene/enums.h"
#include "core/scene/nearest.h"
#include "core/xml_text.h"

namespace braitenlab::robots::thymio {

namespace {

constexpr float largest_integer = 32767;
constexpr int program_words = 1534, weight_unit = 10000, follow_unit = 32767;
constexpr int table_steps = 64;
constexpr float slowest_error = 0.002f;  // at which a slow memory stops short of its target

// ---- Sensors ----

// Reads the raw value into the variable `raw`.
std::string_view expression_of(Place place) {
    constexpr std::string_view front[] = {"math.max(raw, prox.horizontal[0], prox.horizontal[1])",
                                          "math.max(raw, prox.horizontal[4], prox.horizontal[3])",
                                          "math.max(raw, prox.horizontal[2], prox.horizontal[2])"};
    constexpr std::string_view ground[] = {"math.max(raw, prox.ground.reflected[0], prox.ground.reflected[0])",
                                           "math.max(raw, prox.ground.reflected[1], prox.ground.reflected[1])",
                                           "math.max(raw, prox.ground.reflected[0], prox.ground.reflected[1])"};
    static_assert(std::size(front) == side_count && std::size(ground) == side_count);
    return (place.is_ground ? ground : front)[static_cast<std::size_t>(place.side)];
}

// ---- Ranges ----

float size_of(Range range) { return std::max(std::fabs(range.low), std::fabs(range.high)); }

// Largest size of a number on the way through a curve.
float size_in(const Curve& curve, float input) {
    const bool shifts = curve.response == Response::hump || curve.response == Response::sigmoid;
    return curve.response == Response::inverted ? 1 + input : input + (shifts ? std::fabs(curve.peak) : 0);
}

float size_of_source(const Plan& plan, const PlanTap& tap) {
    return tap.reads == Reads::sensor ? 1 : size_of(plan.units[static_cast<std::size_t>(tap.source)].value);
}

// Largest size of any number that the program computes for a unit, in units of 1.0.
float largest_of(const Plan& plan, const PlanUnit& unit) {
    float largest = size_in(unit.curve, size_of(unit.sum));
    for (const PlanTap& tap : unit.taps) {
        const float passed = size_in(tap.curve, size_of_source(plan, tap));
        largest = std::max({largest, passed, passed * std::fabs(tap.weight)});
    }
    // The distance to the target of a memory.
    if (unit.follow < 1) largest = std::max(largest, 2 * size_of(unit.value));
    return largest;
}

// Rounding of each wire adds at most 1.
bool fits(const Plan& plan, const PlanUnit& unit, int one) {
    const auto rounding = static_cast<float>(2 * unit.taps.size() + 4);
    return largest_of(plan, unit) * static_cast<float>(one) * 1.001f + rounding <= largest_integer;
}

int words_of(const Plan& plan) {
    std::size_t words = 60 + 20 * plan.inputs.size();
    const auto of_curve = [](const Curve& curve) {
        return curve.response == Response::hump || curve.response == Response::sigmoid ? 260 : 12;
    };
    for (const PlanUnit& unit : plan.units) {
        words += 14 + static_cast<std::size_t>(of_curve(unit.curve));
        for (const PlanTap& tap : unit.taps)
            words += 13 + (tap.threshold > 0 ? 10 : 0) +
                     (tap.curve.response == Response::linear ? 0 : static_cast<std::size_t>(of_curve(tap.curve)));
    }
    return static_cast<int>(words);
}

// ---- Program ----

struct Writer {
    const Plan& plan;
    int one;
    std::vector<Curve> tables{};  // of hump and sigmoid; equal curves share one

    int scaled(float value) const { return static_cast<int>(std::lround(value * static_cast<float>(one))); }

    std::size_t table_of_curve(const Curve& curve) {
        const auto found = std::find(tables.begin(), tables.end(), curve);
        if (found != tables.end()) return static_cast<std::size_t>(found - tables.begin());
        tables.push_back(curve);
        return tables.size() - 1;
    }

    // Distance between two entries of a table, and their number.
    std::pair<int, int> spacing(const Curve& curve) const {
        const float span = (curve.response == Response::hump ? 3.0f : 8.0f) * curve.width * static_cast<float>(one);
        const int longest = static_cast<int>(std::min(span, largest_integer));
        const int step = std::max(1, (longest + table_steps - 1) / table_steps);
        return {step, longest / step + 1};
    }

    std::string table(std::size_t index) const {
        const Curve& curve = tables[index];
        const auto [step, entries] = spacing(curve);
        std::string values;
        for (int i = 0; i < entries; ++i) {
            const float x = curve.peak + static_cast<float>(i * step) / static_cast<float>(one);
            values += fmt::format("{}{}", i == 0 ? "" : i % 12 == 0 ? ",\n  " : ", ", scaled(respond(curve, x)));
        }
        return fmt::format(
            "# {} with peak {} and width {}: values at distances of {} from the peak\nvar table{}[{}] = [{}]\n",
            word(curve.response), number(curve.peak), number(curve.width), step, index, entries, values);
    }

    // Applies a curve to the variable `x`.
    std::string curved(const Curve& curve, std::string_view x) {
        switch (curve.response) {
            case Response::linear:
                return "";
            case Response::rectified:
                return fmt::format("if {0} < 0 then {0} = 0 end\n", x);
            case Response::step:
                return fmt::format("if {0} >= {1} then {0} = {2} else {0} = 0 end\n", x, scaled(curve.peak), one);
            case Response::inverted:
                return fmt::format("{0} = {1} - {0}\n", x, one);
            case Response::hump:
            case Response::sigmoid:
                return looked_up(curve, x);
        }
        return "";
    }

    std::string looked_up(const Curve& curve, std::string_view x) {
        const std::size_t index = table_of_curve(curve);
        const auto [step, entries] = spacing(curve);
        const bool hump = curve.response == Response::hump;
        std::string text = fmt::format(
            "distance = {0} - {1}\n"
            "place = abs(distance) / {2}\n"
            "if place >= {3} then\n"
            "  {0} = {4}\n"
            "else\n"
            "  rest = abs(distance) % {2}\n"
            "  call math.muldiv(rest, table{5}[place + 1] - table{5}[place], rest, {2})\n"
            "  {0} = table{5}[place] + rest\n"
            "end\n",
            x, scaled(curve.peak), step, entries - 1, hump ? 0 : one, index);
        if (!hump) text += fmt::format("if distance < 0 then {0} = {1} - {0} end\n", x, one);
        return text;
    }

    std::string source(const PlanTap& tap) const {
        const auto index = static_cast<std::size_t>(tap.source);
        if (tap.reads == Reads::sensor) return plan.inputs[index].id;
        return (tap.reads == Reads::now ? "new_" : "") + plan.units[index].id;
    }

    std::string tap(const PlanTap& tap) {
        const int weight = static_cast<int>(std::lround(tap.weight * weight_unit));
        if (tap.threshold <= 0 && tap.curve.response == Response::linear)
            return fmt::format("call math.muldiv(part, {}, {}, {})\nsum = sum + part\n", source(tap), weight,
                               weight_unit);
        std::string text = fmt::format("part = {}\n", source(tap));
        if (tap.threshold > 0) text += fmt::format("if abs(part) < {} then part = 0 end\n", scaled(tap.threshold));
        text += curved(tap.curve, "part");
        return text + fmt::format("call math.muldiv(part, part, {}, {})\nsum = sum + part\n", weight, weight_unit);
    }

    std::string unit(std::size_t index) {
        const PlanUnit& unit = plan.units[index];
        const bool motor = index >= plan.hidden();
        std::string text = fmt::format("\n# {} {}\nsum = {}\n", motor ? "motor" : "neuron", comment_text(unit.name),
                                       scaled(unit.bias));
        for (const PlanTap& each : unit.taps) text += tap(each);
        text += curved(unit.curve, "sum");
        if (unit.follow >= 1) return text + fmt::format("new_{} = sum\n", unit.id);
        return text + fmt::format(
                          "# follows slowly: time constant {0:g} s\n"
                          "call math.muldiv(part, sum - {1}, {2}, {3})\nnew_{1} = {1} + part\n",
                          unit.time_constant, unit.id, std::lround(unit.follow * follow_unit), follow_unit);
    }

    std::string eye(const Input& input) const {
        const Place place = *place_of(input);
        const std::string scale =
            place.is_ground ? fmt::format("raw, {}, 1000", one) : fmt::format("raw - 1000, {}, 3300", one);
        return fmt::format(
            "call {0}\ncall math.muldiv({1}, {2})\n"
            "if {1} < 0 then {1} = 0 end\nif {1} > {3} then {1} = {3} end\n",
            expression_of(place), input.id, scale, one);
    }

    std::string motor(std::string_view side, const PlanUnit& unit) const {
        return fmt::format(
            "sum = new_{0}\nif sum > {1} then sum = {1} end\nif sum < -{1} then sum = -{1} end\n"
            "call math.muldiv(motor.{2}.target, sum, 500, {1})\n",
            unit.id, one, side);
    }

    std::string code() {
        std::string body = "\n# ---- Eyes ----\n";
        for (const Input& input : plan.inputs) body += eye(input);
        body += "\n# ---- Brain ----\n";
        for (std::size_t u = 0; u < plan.units.size(); ++u) body += unit(u);
        body += "\n";
        for (const PlanUnit& unit : plan.units)
            if (unit.is_kept) body += fmt::format("{0} = new_{0}\n", unit.id);
        body += "\n# ---- Motors ----\n" + motor("left", plan.units[plan.hidden()]) +
                motor("right", plan.units[plan.hidden() + 1]);

        std::string text = fmt::format(
            "# The brain \"{}\" for a Thymio II, exported from Braitenlab.\n"
            "# {} stands for 1.0. No number of this program can leave -32767 to 32767.\n"
            "# A Thymio sees obstacles, not lamps: an obstacle in front takes the place of the lamp.\n"
            "# Motors: 500 is the command 1. It waits for the forward button. Centre button: stop.\n\n",
            comment_text(plan.title), one);
        for (const Input& input : plan.inputs) text += fmt::format("var {}\n", input.id);
        for (const PlanUnit& unit : plan.units) {
            text += fmt::format("var new_{}\n", unit.id);
            if (unit.is_kept) text += fmt::format("var {} = 0\n", unit.id);
        }
        text += "var raw\nvar part\nvar sum\nvar running = 0\n";
        if (!tables.empty()) text += "var distance\nvar place\nvar rest\n";
        for (std::size_t i = 0; i < tables.size(); ++i) text += table(i);
        return text + "\n# Ten times per second\nonevent prox\nif running == 0 then return end\n" + body +
               "\nonevent button.forward\nrunning = 1\n"
               "\nonevent button.center\nrunning = 0\nmotor.left.target = 0\nmotor.right.target = 0\n";
    }
};

}  // namespace

int unit_of(const Plan& plan) {
    for (const int one : {8000, 4000, 2000, 1000})
        if (std::all_of(plan.units.begin(), plan.units.end(), [&](const PlanUnit& u) { return fits(plan, u, one); }))
            return one;
    return 0;
}

std::optional<Error> refusal(const Plan& plan) {
    if (auto error = sensor_refusal(plan)) return error;
    for (const PlanUnit& unit : plan.units) {
        const std::string name = in_quotes(unit.name);
        for (const PlanTap& tap : unit.taps)
            if (tap.learning_rate > 0) return error_of(message_of("thymio_learns", name));
        if (!fits(plan, unit, 1000))
            return error_of(
                message_of("thymio_numbers", name,
                           told_apart(static_cast<double>(largest_of(plan, unit)), 32, Digits::in_all, 4).first));
    }
    const int one = unit_of(plan);
    for (const PlanUnit& unit : plan.units)
        if (unit.follow < 1 && 1 / (unit.follow * static_cast<float>(one)) > slowest_error)
            return error_of(message_of("thymio_slow", in_quotes(unit.name), fmt::format("{:g}", unit.time_constant)));
    if (words_of(plan) > program_words) return error_of(message_of("thymio_words", words_of(plan), program_words));
    return std::nullopt;
}

std::string program(const Plan& plan) {
    Writer writer{plan, unit_of(plan)};
    return "<!DOCTYPE aesl-source>\n<network>\n<keywords flag=\"true\"/>\n<node nodeId=\"1\" name=\"thymio-II\">" +
           xml_text(writer.code()) + "</node>\n</network>\n";
}

}  // namespace braitenlab::robots::thymio
