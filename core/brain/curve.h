// Response curves: functions of a node's sum or of a wire's input.
//
// To add a curve: an enumerator at the end of Response, a row in `responses`, and its name under "wiring.kind.<word>"
// in the string files. Reading, writing, menus, plots and tests loop over the table.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/enum_table.h"
#include "core/maths/portable.h"

namespace braitenlab {

enum class Response { linear, rectified, step, sigmoid, hump, inverted };

struct Curve {
    Response response = Response::linear;
    float peak = 0.5f;   // -2..2: position of the step, of the sigmoid's centre or of the hump
    float width = 0.2f;  // 0.001..10
    friend bool operator==(const Curve&, const Curve&) = default;
};

// Properties of one response.
struct ResponseTraits {
    Response value;
    std::string_view word;     // in files; also the end of the string key "wiring.kind.<word>"
    bool has_peak, has_width;  // whether the function reads Curve::peak and Curve::width
    float low, high;           // range of the function for inputs -1..1
    float (*function)(const Curve&, float x);
};

// In the order of Response.
inline constexpr std::array responses{
    ResponseTraits{Response::linear, "linear", false, false, -1, 1, [](const Curve&, float x) { return x; }},
    ResponseTraits{Response::rectified, "rectified", false, false, 0, 1,
                   [](const Curve&, float x) { return x > 0 ? x : 0.0f; }},
    ResponseTraits{Response::step, "step", true, false, 0, 1,
                   [](const Curve& c, float x) { return x >= c.peak ? 1.0f : 0.0f; }},
    ResponseTraits{Response::sigmoid, "sigmoid", true, true, 0, 1,
                   [](const Curve& c, float x) { return 1.0f / (1.0f + maths::exponential(-(x - c.peak) / c.width)); }},
    // Vehicle 4: the response decreases again for inputs above the peak.
    ResponseTraits{Response::hump, "hump", true, true, 0, 1,
                   [](const Curve& c, float x) {
                       const float t = (x - c.peak) / c.width;
                       return maths::exponential(-t * t);
                   }},
    ResponseTraits{Response::inverted, "inverted", false, false, 0, 2, [](const Curve&, float x) { return 1.0f - x; }},
};

constexpr const ResponseTraits& traits(Response response) { return responses[static_cast<std::size_t>(response)]; }

constexpr const auto& table_of(Response) { return responses; }
static_assert(is_complete_table<responses>());

// The curve's value at x.
inline float respond(const Curve& curve, float x) { return traits(curve.response).function(curve, x); }

}  // namespace braitenlab
