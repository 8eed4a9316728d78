// The C99 header brain.h: the brain as one structure and one function. It is valid C++11, too, for Arduino.
#include <string_view>

#include <fmt/format.h>

#include "core/export/curve_tables.h"
#include "core/export/export.h"
#include "core/export/text.h"
#include "core/export/texts.h"
#include "core/scene/enums.h"

namespace braitenlab::robots {

namespace {

struct Helper {
    Response response;
    std::string_view text;
};

// The response curves, as core/brain/curve.h defines them.
constexpr Helper helpers[] = {
    {Response::rectified,
     "/* Rectified: negative values become 0. */\n"
     "static inline float brain_rectified(float x) { return x > 0.0f ? x : 0.0f; }\n"},
    {Response::step,
     "/* Step: 1 from the threshold on, else 0. */\n"
     "static inline float brain_step(float x, float threshold) { return x >= threshold ? 1.0f : 0.0f; }\n"},
    {Response::sigmoid,
     "/* Sigmoid: rises smoothly from 0 to 1; 0.5 at the centre. */\n"
     "static inline float brain_sigmoid(float x, float centre, float width) {\n"
     "    return 1.0f / (1.0f + expf(-(x - centre) / width));\n"
     "}\n"},
    {Response::hump,
     "/* Hump: 1 at the peak, less on both sides. */\n"
     "static inline float brain_hump(float x, float peak, float width) {\n"
     "    float t = (x - peak) / width;\n"
     "    return expf(-t * t);\n"
     "}\n"},
    {Response::inverted,
     "/* Inverted: large for a small input. */\n"
     "static inline float brain_inverted(float x) { return 1.0f - x; }\n"},
};

// The plan, and how its header is written.
struct Header {
    const Plan& plan;
    Curves curves;
};

std::string curved(const Header& header, const Curve& curve, const std::string& x) {
    const bool is_looked_up = header.curves == Curves::looked_up;
    const auto width = [&] { return c_number(is_looked_up ? table_scale(curve) : curve.width); };
    switch (curve.response) {
        case Response::linear:
            return x;
        case Response::rectified:
            return "brain_rectified(" + x + ")";
        case Response::step:
            return fmt::format("brain_step({}, {})", x, c_number(curve.peak));
        case Response::sigmoid:
            return fmt::format("brain_sigmoid({}, {}, {})", x, c_number(curve.peak), width());
        case Response::hump:
            return fmt::format("brain_hump({}, {}, {})", x, c_number(curve.peak), width());
        case Response::inverted:
            return "brain_inverted(" + x + ")";
    }
    return x;
}

const std::string& name_of_source(const Plan& plan, const PlanTap& tap) {
    const auto source = static_cast<std::size_t>(tap.source);
    return tap.reads == Reads::sensor ? plan.inputs[source].name : plan.units[source].name;
}

std::string source(const Plan& plan, const PlanTap& tap) {
    const auto index = static_cast<std::size_t>(tap.source);
    if (tap.reads == Reads::sensor) return "b->" + plan.inputs[index].id;
    return (tap.reads == Reads::now ? "" : "b->") + plan.units[index].id;
}

bool is_clamped(const PlanUnit& unit) { return unit.value.low <= -largest_value || unit.value.high >= largest_value; }

std::string passed(const Header& header, const PlanTap& tap) {
    std::string x = source(header.plan, tap);
    if (tap.threshold > 0) x = fmt::format("brain_masked({}, {})", x, c_number(tap.threshold));
    return curved(header, tap.curve, x);
}

std::string tap_line(const Header& header, const PlanTap& tap) {
    const std::string weight = tap.learned_id.empty()
                                   ? c_number(tap.weight)
                                   : fmt::format("({} + b->{})", c_number(tap.weight), tap.learned_id);
    return fmt::format("    sum += {} * {};  /* from {} */\n", weight, passed(header, tap),
                       comment_text(name_of_source(header.plan, tap)));
}

std::string unit_comment(const PlanUnit& unit, bool motor) {
    std::string text =
        motor ? fmt::format("{} motor", unit.name == "ML" ? "Left" : "Right") : "Neuron " + comment_text(unit.name);
    if (unit.curve.response != Response::linear) text += fmt::format(": {} of its sum", word(unit.curve.response));
    if (unit.time_constant > 0)
        text += fmt::format(", follows slowly with a time constant of {:g} s", unit.time_constant);
    return text;
}

std::string unit_code(const Header& header, std::size_t index) {
    const PlanUnit& unit = header.plan.units[index];
    const bool motor = index >= header.plan.hidden();
    std::string text = fmt::format("\n    /* {}. */\n", unit_comment(unit, motor));
    text += fmt::format("    sum = {};\n", c_number(unit.bias));
    for (const PlanTap& tap : unit.taps) text += tap_line(header, tap);
    std::string value = curved(header, unit.curve, "sum");
    if (unit.follow < 1) value = fmt::format("b->{0} + {1} * ({2} - b->{0})", unit.id, c_number(unit.follow), value);
    if (is_clamped(unit)) value = fmt::format("brain_clamp({}, -1000.0f, 1000.0f)", value);
    return text + fmt::format("    const float {} = {};\n", unit.id, value);
}

std::string learning_code(const Plan& plan) {
    std::string text;
    for (const PlanUnit& unit : plan.units)
        for (const PlanTap& tap : unit.taps) {
            if (tap.learning_rate <= 0) continue;
            text += fmt::format(
                "\n    /* The wire from {} to {} learns: it grows while both are active, and fades. */\n"
                "    b->{} += BRAIN_PERIOD * ({} * {} * {} - {} * b->{});\n"
                "    b->{} = brain_clamp(b->{}, {}, {});\n",
                comment_text(name_of_source(plan, tap)), comment_text(unit.name), tap.learned_id,
                c_number(tap.learning_rate), source(plan, tap), unit.id, c_number(tap.decay), tap.learned_id,
                tap.learned_id, tap.learned_id, c_number(-limits::weight - tap.weight),
                c_number(limits::weight - tap.weight));
        }
    return text;
}

std::string structure(const Plan& plan) {
    std::string text = "typedef struct {\n    /* Sensors, 0 to 1: set them before brain_think(). */\n";
    for (const Input& input : plan.inputs) {
        const std::string senses = input.channel ? fmt::format("senses {}", word(*input.channel)) : "";
        const std::string renamed = "sensor_" + input.name == input.id ? "" : comment_text(input.name);
        const char* between = senses.empty() || renamed.empty() ? "" : "; ";
        const std::string both = fmt::format("{}{}{}", senses, between, renamed);
        text += fmt::format("    float {};", input.id);
        if (!both.empty()) text += fmt::format("  /* {} */", both);
        text += "\n";
    }
    text +=
        "    /* Commands of the wheels, -1 (backwards) to 1 (forwards): read them after brain_think(). */\n"
        "    float left, right;\n";
    std::string inner;
    for (const PlanUnit& unit : plan.units)
        if (unit.is_kept) inner += fmt::format("    float {};\n", unit.id);
    for (const PlanUnit& unit : plan.units)
        for (const PlanTap& tap : unit.taps)
            if (!tap.learned_id.empty()) inner += fmt::format("    float {};\n", tap.learned_id);
    if (!inner.empty()) text += "    /* What the brain remembers from call to call: do not change it. */\n" + inner;
    return text + "} Brain;\n";
}

std::string think_function(const Header& header) {
    const Plan& plan = header.plan;
    std::string text = fmt::format(
        "/* One step: from the sensors to the commands. Call it {:g} times per second. */\n"
        "static inline void brain_think(Brain *b) {{\n    float sum;\n",
        plan.rate_hz);
    if (plan.hidden() > 0)
        text +=
            "\n    /* Neurons read the sensors and the previous step's neurons (b->neuron_...), motors this step's. "
            "*/\n";
    for (std::size_t u = 0; u < plan.units.size(); ++u) text += unit_code(header, u);
    text += learning_code(plan);
    text += "\n";
    for (const PlanUnit& unit : plan.units)
        if (unit.is_kept) text += fmt::format("    b->{} = {};\n", unit.id, unit.id);
    const std::size_t left = plan.hidden();
    text += fmt::format("    b->left = brain_clamp({}, -1.0f, 1.0f);\n    b->right = brain_clamp({}, -1.0f, 1.0f);\n",
                        plan.units[left].id, plan.units[left + 1].id);
    return text + "}\n";
}

// What the curves of this brain need, before the functions that use it.
std::string functions(const Plan& plan, Curves curves, bool is_looked_up) {
    std::string text;
    if (has_threshold(plan)) text += texts::brain_masked_h;
    if (is_looked_up) text += table_lookup();
    for (const Helper& helper : helpers) {
        if (!has_response(plan, helper.response)) continue;
        const auto table = curves == Curves::looked_up ? table_function(helper.response) : std::nullopt;
        text += table.value_or(std::string(helper.text)) + "\n";
    }
    return text;
}

}  // namespace

std::string c_header(const Plan& plan, Curves curves) {
    std::string sensors, includes, period;
    for (const Input& input : plan.inputs)
        sensors += fmt::format(" *         brain.{} = ...;  // {}0 to 1\n", input.id,
                               input.channel ? fmt::format("{}, ", word(*input.channel)) : "");
    const bool needs_exponential = has_response(plan, Response::sigmoid) || has_response(plan, Response::hump);
    const bool is_looked_up = needs_exponential && curves == Curves::looked_up;
    if (is_looked_up)
        includes = "#include <avr/pgmspace.h>\n#include <stdint.h>\n\n";
    else if (needs_exponential)
        includes = "#include <math.h>  /* expf */\n\n";
    if (has_wire(plan, [](const PlanTap& tap) { return tap.learning_rate > 0; }))
        period = fmt::format("#define BRAIN_PERIOD {}  /* s */\n", c_number(plan.period()));
    return filled(texts::brain_h, {{"TITLE", comment_text(plan.title)},
                                   {"RATE", fmt::format("{:g}", plan.rate_hz)},
                                   {"SENSORS", sensors},
                                   {"INCLUDES", includes},
                                   {"PERIOD", period},
                                   {"STRUCTURE", structure(plan)},
                                   {"CURVES", functions(plan, curves, is_looked_up)},
                                   {"THINK", think_function({plan, curves})}});
}

}  // namespace braitenlab::robots
