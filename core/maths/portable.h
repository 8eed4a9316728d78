// Sine, cosine, arc tangent, exponential function, logarithm and power with the same bits on every platform.
//
// The functions of the C library differ in the last bit between platforms, and a simulation amplifies such differences
// until two runs diverge. The functions here use only +, -, *, / and square roots of doubles, which IEEE 754 defines
// exactly, and integers; the result is rounded to float once. The error is below one unit in the last place of a float
// for |angle| up to 10^5.
#pragma once

#include <cmath>

namespace braitenlab::maths {

inline constexpr double pi_d = 3.14159265358979323846;
inline constexpr float pi = static_cast<float>(pi_d);

namespace detail {

// Taylor polynomials for |x| <= pi/4; the first omitted term is below 3e-12.
constexpr double sine_core(double x) {
    const double s = x * x;
    return x * (1 + s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 + s * (-1.0 / 39916800))))));
}
constexpr double cosine_core(double x) {
    const double s = x * x;
    return 1 + s * (-1.0 / 2 +
                    s * (1.0 / 24 + s * (-1.0 / 720 + s * (1.0 / 40320 + s * (-1.0 / 3628800 + s / 479001600)))));
}

}  // namespace detail

struct SineCosine {
    float sine, cosine;
};

// Sine and cosine of an angle in -10^9..10^9 rad. Without branches, because the quadrant of a rotating body is hard to
// predict.
inline SineCosine sine_cosine(float angle) {
    const double turns = static_cast<double>(angle) * (2 / pi_d) + 0.5;
    const auto towards_zero = static_cast<long long>(turns);
    const long long quarter = towards_zero - (turns < static_cast<double>(towards_zero));
    const double rest = static_cast<double>(angle) - static_cast<double>(quarter) * (pi_d / 2);
    const double core[] = {detail::sine_core(rest), detail::cosine_core(rest)};
    constexpr double sign[] = {1, 1, -1, -1};
    return {static_cast<float>(sign[quarter & 3] * core[quarter & 1]),
            static_cast<float>(sign[(quarter + 1) & 3] * core[(quarter + 1) & 1])};
}

inline float sine(float angle) { return sine_cosine(angle).sine; }
inline float cosine(float angle) { return sine_cosine(angle).cosine; }

// Angle of the point (x, y) in rad, in [-pi, pi]; 0 at the origin.
inline float arctangent2(float y, float x) {
    const double ax = std::fabs(static_cast<double>(x)), ay = std::fabs(static_cast<double>(y));
    if (ax == 0 && ay == 0) return 0;
    double t = ax > ay ? ay / ax : ax / ay;  // in [0, 1]
    // atan t = 2 atan(t / (1 + sqrt(1 + t^2))), applied twice: the argument is then below 0.2 and the series error
    // below 1e-12.
    t = t / (1 + std::sqrt(1 + t * t));
    t = t / (1 + std::sqrt(1 + t * t));
    const double s = t * t;
    double a =
        t * (1 + s * (-1.0 / 3 + s * (1.0 / 5 + s * (-1.0 / 7 + s * (1.0 / 9 + s * (-1.0 / 11 + s * (1.0 / 13)))))));
    a *= 4;
    if (ay >= ax) a = pi_d / 2 - a;
    if (x < 0) a = pi_d - a;
    return static_cast<float>(y < 0 ? -a : a);
}

// The natural logarithm of x; of numbers that are not above 0, that of the smallest normal number.
inline double logarithm(float x) {
    int exponent = 0;
    double m = std::frexp(static_cast<double>(x > 1.17549435e-38f ? x : 1.17549435e-38f), &exponent);  // 0.5 <= m < 1
    if (m < 0.70710678118654752) m *= 2, --exponent;
    // ln m = 2 artanh t with t = (m - 1)/(m + 1), |t| < 0.172; the first omitted term is below 1e-14.
    const double t = (m - 1) / (m + 1), s = t * t;
    const double series =
        1 + s * (1.0 / 3 + s * (1.0 / 5 + s * (1.0 / 7 + s * (1.0 / 9 + s * (1.0 / 11 + s * (1.0 / 13 + s / 15))))));
    return exponent * 0.69314718055994531 + 2 * t * series;
}

// e^x; 0 for x below -87 and 6e37 for x above 87, so that the result is finite.
inline float exponential(float x) {
    if (x < -87.0f) return 0;
    double y = x > 87.0f ? 87.0 : static_cast<double>(x);
    // e^y = (e^(y/1024))^1024: the series needs few terms on the small argument.
    y /= 1024;
    double e = 1 + y * (1 + y / 2 * (1 + y / 3 * (1 + y / 4 * (1 + y / 5 * (1 + y / 6 * (1 + y / 7))))));
    for (int i = 0; i < 10; ++i) e *= e;
    return static_cast<float>(e);
}

// x to the power of p, for x >= 0 and p > 0; finite as exponential() is.
inline float power(float x, float p) {
    return x > 0 ? exponential(static_cast<float>(static_cast<double>(p) * logarithm(x))) : 0.0f;
}

}  // namespace braitenlab::maths
