// What a brain costs on an Arduino Uno. The numbers are measured: sketches of 10 and of 20 neurons of one kind,
// compiled by avr-gcc 5.4 as the tests do and run in simavr with random readings, the longest of 60 steps.
#include <array>
#include <map>
#include <string>

#include <fmt/format.h>

#include "core/export/arduino.h"
#include "core/export/sensor_parts.h"

namespace braitenlab::robots::arduino {

namespace {

constexpr Cost base{2400, 7570};
constexpr Cost of_warm_up{0, 240};
constexpr Cost of_sensor{2600, 44}, of_unit{60, 20}, of_product{150, 20}, of_sum{130, 16};
constexpr Cost of_threshold{130, 78}, of_memory{460, 92}, of_bound{220, 60}, of_learning{1000, 240};

void add(Cost& sum, const Cost& part) { sum.cycles += part.cycles, sum.bytes += part.bytes; }

struct CurveCost {
    Response response;
    Cost cost;
    Cost once{};  // of its table and functions
};
constexpr auto curve_costs = std::to_array<CurveCost>({
    {Response::linear, {0, 0}},
    {Response::rectified, {100, 72}},
    {Response::step, {70, 56}},
    {Response::sigmoid, {1050, 35}, {0, 1100}},
    {Response::hump, {880, 35}, {0, 1150}},
    {Response::inverted, {100, 4}},
});
// cost_of() takes the row of a response by its number.
static_assert([] {
    for (std::size_t i = 0; i < curve_costs.size(); ++i)
        if (curve_costs[i].response != responses[i].value) return false;
    return curve_costs.size() == responses.size();
}());

// Adds the costs of terms. The compiler computes equal terms once, unless they branch.
class Terms {
public:
    explicit Terms(Cost& sum) : sum_(sum) {}

    // The number of a term, the same for equal ones. A new one has this cost.
    std::size_t number(const std::string& term, const Cost& cost) {
        const auto [known, is_new] = numbers_.try_emplace(term, next_);
        return is_new ? number(cost) : known->second;
    }
    // The number of a term that branches.
    std::size_t number(const Cost& cost) {
        add(sum_, cost);
        return next_++;
    }
    std::size_t curved(const Curve& curve, std::size_t of) {
        if (curve.response == Response::linear) return of;
        const CurveCost& row = curve_costs[static_cast<std::size_t>(curve.response)];
        (void)number(fmt::format("table {}", static_cast<int>(curve.response)), row.once);
        if (curve.response == Response::rectified || curve.response == Response::step) return number(row.cost);
        return number(fmt::format("{} {} {} of {}", static_cast<int>(curve.response), curve.peak, curve.width, of),
                      row.cost);
    }

private:
    Cost& sum_;
    std::size_t next_ = 0;
    std::map<std::string, std::size_t> numbers_;
};

}  // namespace

Cost cost_of(const Plan& plan) {
    Cost sum = base;
    for (const Input& input : plan.inputs) {
        add(sum, of_sensor);
        const SensorPart part = part_of(input, Board::uno);
        sum.bytes += static_cast<int>(part.zero.size() + part.one.size()) + 2;  // the texts of its calibration
    }
    if (warm_up_of(parts_of(plan, Board::uno)) > 0) add(sum, of_warm_up);
    Terms terms(sum);
    std::vector<std::size_t> values;  // of the units of this step
    for (const PlanUnit& unit : plan.units) {
        add(sum, of_unit);
        std::size_t total = terms.number(fmt::format("bias {}", unit.bias), {});
        for (const PlanTap& tap : unit.taps) {
            std::size_t x = tap.reads == Reads::now
                                ? values[static_cast<std::size_t>(tap.source)]
                                : terms.number(fmt::format("{} {}", static_cast<int>(tap.reads), tap.source), {});
            if (tap.threshold > 0) x = terms.number(of_threshold);
            x = terms.number(fmt::format("{} {} times {}", tap.weight, tap.learned_id, terms.curved(tap.curve, x)),
                             of_product);
            if (tap.learning_rate > 0) add(sum, of_learning);
            total = terms.number(fmt::format("{} plus {}", total, x), of_sum);
        }
        total = terms.curved(unit.curve, total);
        if (unit.follow < 1) total = terms.number(fmt::format("memory {} of {}", unit.id, total), of_memory);
        if (unit.value.low <= -largest_value || unit.value.high >= largest_value)
            total = terms.number(fmt::format("bounded {}", total), of_bound);
        values.push_back(total);
    }
    return sum;
}

std::optional<int> rate_for(const Cost& cost, int robot_rate) {
    constexpr int cycles_per_second = 16'000'000;
    for (const int rate : {robot_rate, 40, 30, 25, 20, 15, lowest_rate})
        if (rate <= robot_rate && cost.cycles <= cycles_per_second / rate) return rate;
    return std::nullopt;
}

}  // namespace braitenlab::robots::arduino
