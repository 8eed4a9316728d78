// What a brain costs on an Arduino Uno. The numbers are measured: sketches of 10 and of 20 neurons of one kind,
// compiled by avr-gcc 5.4 as the tests do and run in simavr with random readings, the longest of 60 steps.
#include <algorithm>
#include <array>

#include "core/export/arduino.h"

namespace braitenlab::robots::arduino {

namespace {

constexpr Cost base{2400, 7200}, exponential{0, 620};
constexpr Cost of_sensor{2600, 30}, of_unit{60, 20}, of_wire{280, 36};
constexpr Cost of_threshold{130, 78}, of_memory{460, 92}, of_bound{220, 60}, of_learning{1000, 240};

struct CurveCost {
    Response response;
    Cost cost;
};
constexpr auto curve_costs = std::to_array<CurveCost>({
    {Response::linear, {0, 0}},
    {Response::rectified, {100, 72}},
    {Response::step, {70, 56}},
    {Response::sigmoid, {4200, 34}},
    {Response::hump, {3250, 56}},
    {Response::inverted, {100, 4}},
});
// cost_of() takes the row of a response by its number.
static_assert([] {
    for (std::size_t i = 0; i < curve_costs.size(); ++i)
        if (curve_costs[i].response != responses[i].value) return false;
    return curve_costs.size() == responses.size();
}());

void add(Cost& sum, const Cost& part) { sum.cycles += part.cycles, sum.bytes += part.bytes; }

bool has_exponential(Response response) { return response == Response::sigmoid || response == Response::hump; }

}  // namespace

Cost cost_of(const Plan& plan) {
    Cost sum = base;
    bool needs_exponential = false;
    const auto add_curve = [&](const Curve& curve) {
        add(sum, curve_costs[static_cast<std::size_t>(curve.response)].cost);
        needs_exponential |= has_exponential(curve.response);
    };
    for (std::size_t i = 0; i < plan.inputs.size(); ++i) add(sum, of_sensor);
    for (const PlanUnit& unit : plan.units) {
        add(sum, of_unit);
        add_curve(unit.curve);
        if (unit.follow < 1) add(sum, of_memory);
        if (unit.value.low <= -largest_value || unit.value.high >= largest_value) add(sum, of_bound);
        for (const PlanTap& tap : unit.taps) {
            add(sum, of_wire);
            add_curve(tap.curve);
            if (tap.threshold > 0) add(sum, of_threshold);
            if (tap.learning_rate > 0) add(sum, of_learning);
        }
    }
    if (needs_exponential) add(sum, exponential);
    return sum;
}

std::optional<int> rate_for(const Cost& cost, int robot_rate) {
    constexpr int cycles_per_second = 16'000'000;
    for (const int rate : {robot_rate, 40, 30, 25, 20, 15, lowest_rate})
        if (rate <= robot_rate && cost.cycles <= cycles_per_second / rate) return rate;
    return std::nullopt;
}

}  // namespace braitenlab::robots::arduino
