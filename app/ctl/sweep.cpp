#include "app/ctl/sweep.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/scene/nearest.h"
#include "core/text_parts.h"

namespace braitenlab {

namespace {

// Splits at each separator that is not inside quotes or brackets.
std::vector<std::string> split(std::string_view text, char separator) {
    std::vector<std::string> parts(1);
    char quote = 0;
    int brackets = 0;
    for (const char c : text) {
        if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else {
            brackets += (c == '[' || c == '{') - (c == ']' || c == '}');
        }
        if (c == separator && quote == 0 && brackets == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

// An error in an argument, e.g. "--set kind.prey.brain.LL=0:1:0: the step is 0; …".
Error wrong(const std::string& option, std::string_view argument, const std::string& what) {
    constexpr std::size_t longest = 120;
    std::string shown(argument.substr(0, longest));
    if (argument.size() > longest) shown += "…";
    return {what, option + " " + shown};
}

std::string too_many(double runs, std::string_view advice) {
    return fmt::format("this gives {:.0f} runs, and the most is {}; take {}", runs, most_runs, advice);
}

// The numbers of a range; `argument` is the whole argument of --set, for messages.
Result<std::vector<std::string>> range(const std::string& text, const std::string& argument) {
    const std::vector<std::string> parts = split(text, ':');
    if (parts.size() != 3)
        return wrong("--set", argument,
                     "a range has three numbers, like 0:1:0.25; put other text with a colon in quotes");
    double numbers[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const auto number = real_number(trimmed(parts[i]));
        if (!number)
            return wrong("--set", argument,
                         in_quotes(parts[i]) + " is not a number; write a range like 0:1:0.25, other text in quotes");
        numbers[i] = *number;
    }
    const auto [from, to, step] = numbers;
    if (step == 0) return wrong("--set", argument, "the step is 0; give another one, like 0:1:0.25");
    const double steps = (to - from) / step;
    if (steps < 0) {
        const std::string turned = fmt::format("{:.10g}:{:.10g}:{:.10g}", from, to, -step);
        return wrong("--set", argument, fmt::format("the step leads away from {:.10g}; write {}", to, turned));
    }
    constexpr double rounding = 1e-6;  // of a step: 0:1:0.1 ends at 1, and -0.3:0:0.1 at 0
    const double count = std::floor(steps + rounding) + 1;
    if (count > static_cast<double>(most_runs)) return wrong("--set", argument, too_many(count, "a larger step"));
    std::vector<std::string> values;
    for (int i = 0; i < count; ++i) {
        const double value = from + i * step;
        values.push_back(fmt::format("{:.10g}", std::fabs(value) < std::fabs(step) * rounding ? 0 : value));
    }
    return values;
}

// The range that was meant by "0..1"; empty for other text.
std::string meant_range(const std::string& text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return "";
    const auto from = real_number(trimmed(text.substr(0, dots))), to = real_number(trimmed(text.substr(dots + 2)));
    return from && to && *from != *to ? fmt::format("{:.10g}:{:.10g}:{:.10g}", *from, *to, (*to - *from) / 10) : "";
}

struct Parsed {
    SweptValue value;
    bool is_several = false;  // a range or a list
};

Result<Parsed> parse_values(const std::string& argument) {
    auto setting = parse_joined_setting(argument);
    if (!setting) return setting.error();
    Parsed parsed{{std::move(setting->paths), {}}, true};
    if (const std::string meant = meant_range(setting->value); !meant.empty())
        return wrong("--set", argument, fmt::format("a range is A:B:STEP; write {}={}", parsed.value.name(), meant));
    std::vector<std::string> list = split(setting->value, ',');
    if (list.size() == 1 && split(setting->value, ':').size() > 1) {
        auto numbers = range(setting->value, argument);
        if (!numbers) return numbers.error();
        parsed.value.values = std::move(*numbers);
        return parsed;
    }
    parsed.is_several = list.size() > 1;
    for (const std::string& part : list) {
        std::string value(trimmed(part));
        if (parsed.is_several && value.empty())
            return wrong("--set", argument, "a value is missing beside a comma; put other text with a comma in quotes");
        if (parsed.is_several && parse_setting(value))
            return wrong("--set", argument,
                         fmt::format("give each path its own --set: --set {}={} --set {}", parsed.value.name(),
                                     trimmed(list.front()), value));
        if (split(value, ':').size() > 1)
            return wrong("--set", argument, "a list has no ranges; write a list or a range, and other text in quotes");
        parsed.value.values.push_back(std::move(value));
    }
    return parsed;
}

std::optional<Error> parse_seeds(const std::string& text, Sweep& sweep) {
    if (text.empty()) return std::nullopt;
    const std::vector<std::string> parts = split(text, ':');
    const auto first = whole_number<std::uint64_t>(parts.front()), last = whole_number<std::uint64_t>(parts.back());
    if (!first || !last || parts.size() > 2)
        return wrong("--seed", text, "a seed is a whole number from 0 up; write 7, or 1:10 for all seeds from 1 to 10");
    if (*last < *first)
        return wrong("--seed", text, fmt::format("the last seed is below the first; write {}:{}", *last, *first));
    if (*last - *first >= most_runs)
        return wrong("--seed", text, too_many(static_cast<double>(*last - *first) + 1, "fewer seeds"));
    sweep.first_seed = *first;
    sweep.seeds = static_cast<std::size_t>(*last - *first) + 1;
    sweep.is_sweep |= parts.size() > 1;
    return std::nullopt;
}

std::optional<Error> check_sweep(const Sweep& sweep) {
    double runs = static_cast<double>(sweep.seeds);
    std::set<std::string> paths;
    for (const SweptValue& value : sweep.values) {
        runs *= static_cast<double>(value.values.size());
        for (const std::string& path : value.paths)
            if (!paths.insert(path).second)
                return wrong("--set", path,
                             "is given twice; give all its values in one --set, like " + path + "=0.5,1");
    }
    if (runs > static_cast<double>(most_runs))
        return Error{too_many(runs, "larger steps, fewer values or fewer seeds"), "--set and --seed"};
    return std::nullopt;
}

}  // namespace

std::string SweptValue::name() const { return fmt::format("{}", fmt::join(paths, "=")); }

std::size_t Sweep::combinations() const {
    std::size_t product = 1;
    for (const SweptValue& value : values) product *= value.values.size();
    return product;
}

Result<Sweep> parse_sweep(const std::vector<std::string>& settings, const std::string& seed) {
    Sweep sweep;
    for (const std::string& argument : settings) {
        auto parsed = parse_values(argument);
        if (!parsed) return parsed.error();
        sweep.is_sweep |= parsed->is_several;
        sweep.values.push_back(std::move(parsed->value));
    }
    if (auto error = parse_seeds(seed, sweep)) return *error;
    if (!sweep.is_sweep) return sweep;
    if (auto error = check_sweep(sweep)) return *error;
    return sweep;
}

std::vector<std::string> values_of(const Sweep& sweep, std::size_t index) {
    std::vector<std::string> values(sweep.values.size());
    for (std::size_t i = values.size(); i-- > 0;) {
        const std::vector<std::string>& all = sweep.values[i].values;
        values[i] = all[index % all.size()];
        index /= all.size();
    }
    return values;
}

std::vector<std::string> cells_of(const Sweep& sweep, std::size_t index) {
    const auto is_number = [](const std::string& text) { return real_number(text).has_value(); };
    const auto has_point = [](const std::string& text) { return text.find_first_of(".eE") != std::string::npos; };
    std::vector<std::string> cells = values_of(sweep, index);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::vector<std::string>& all = sweep.values[i].values;
        const bool are_numbers = std::all_of(all.begin(), all.end(), is_number);
        const bool is_whole = std::none_of(all.begin(), all.end(), has_point);
        if (are_numbers && !is_whole && !has_point(cells[i])) cells[i] += ".0";
    }
    return cells;
}

std::vector<Setting> combination(const Sweep& sweep, std::size_t index) {
    const std::vector<std::string> values = values_of(sweep, index);
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < values.size(); ++i)
        for (const std::string& path : sweep.values[i].paths) settings.push_back({path, values[i]});
    return settings;
}

}  // namespace braitenlab
