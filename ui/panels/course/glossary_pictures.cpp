// The terms of the glossary and their moving pictures. Each picture is drawn on a stage 1.6 wide and 1 high, y down,
// and repeats after a few seconds.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "core/maths/angle.h"
#include "ui/imgui_compat.h"
#include "ui/panels/course/glossary.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

constexpr float stage_width = 1.6f;

struct StagePoint {
    float x = 0, y = 0;
};

StagePoint between(StagePoint a, StagePoint b, float t) { return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}; }

struct Stage {
    const Ui& ui;
    ImDrawList& draw;
    float unit = 1;  // window pixels
    ImVec2 corner;

    Stage(const Ui& context, Rect r)
        : ui(context),
          draw(*ImGui::GetWindowDrawList()),
          unit(std::min(r.w / stage_width, r.h)),
          corner(r.x + (r.w - stage_width * unit) / 2, r.y + (r.h - unit) / 2) {}

    ImVec2 at(StagePoint p) const { return {corner.x + p.x * unit, corner.y + p.y * unit}; }
    float thick(float of_one) const { return std::max(ui.px(1), of_one * unit); }

    void line(StagePoint a, StagePoint b, Colour colour, float thickness = 0.015f) const {
        draw.AddLine(at(a), at(b), paint(colour), thick(thickness));
    }
    void disc(StagePoint c, float radius, Colour colour) const {
        draw.AddCircleFilled(at(c), radius * unit, paint(colour));
    }
    void ring(StagePoint c, float radius, Colour colour, float thickness = 0.015f) const {
        draw.AddCircle(at(c), radius * unit, paint(colour), 0, thick(thickness));
    }
    void box(StagePoint low, StagePoint high, Colour colour) const {
        draw.AddRectFilled(at(low), at(high), paint(colour), 0.02f * unit);
    }
    void lamp(StagePoint c, float strength) const {
        disc(c, 0.07f + 0.06f * strength, ui.palette.lamp.with_alpha(0.25f));
        disc(c, 0.06f, mix(ui.palette.line, ui.palette.lamp, strength));
        ring(c, 0.06f, ui.palette.second_text, 0.01f);
    }
    // A node: a circle that is filled up to `value`, 0..1.
    void node(StagePoint c, float value, float radius = 0.1f) const {
        disc(c, radius, ui.palette.panel);
        disc(c, radius * std::sqrt(std::clamp(value, 0.0f, 1.0f)), ui.palette.accent);
        ring(c, radius, ui.palette.text);
    }
    // A wire with pulses that run along it; `speed`: wires per second.
    void wire(StagePoint a, StagePoint b, Colour colour, double seconds, float thickness = 0.02f,
              float speed = 0.5f) const {
        line(a, b, colour, thickness);
        for (int i = 0; i < 2; ++i) {
            const double t = seconds * static_cast<double>(speed) + i * 0.5;
            disc(between(a, b, static_cast<float>(t - std::floor(t))), 0.028f, colour);
        }
    }
    // A vehicle seen from above; heading in radians, 0: to the right, clockwise.
    void vehicle(StagePoint c, float heading, float size = 0.2f, float left_eye = 0, float right_eye = 0) const {
        const float cosine = std::cos(heading), sine = std::sin(heading);
        const auto point = [&](float along, float across) {
            return at({c.x + size * (along * cosine - across * sine), c.y + size * (along * sine + across * cosine)});
        };
        const auto box_at = [&](float x, float y, float half_x, float half_y, Colour colour) {
            draw.AddQuadFilled(point(x - half_x, y - half_y), point(x + half_x, y - half_y),
                               point(x + half_x, y + half_y), point(x - half_x, y + half_y), paint(colour));
        };
        box_at(0, 0, 0.55f, 0.36f, mix(ui.palette.raised, ui.palette.text, 0.35f));
        box_at(-0.2f, -0.45f, 0.24f, 0.1f, ui.palette.text);
        box_at(-0.2f, 0.45f, 0.24f, 0.1f, ui.palette.text);
        draw.AddCircleFilled(point(0.5f, -0.24f), 0.14f * size * unit,
                             paint(mix(ui.palette.second_text, ui.palette.lamp, left_eye)));
        draw.AddCircleFilled(point(0.5f, 0.24f), 0.14f * size * unit,
                             paint(mix(ui.palette.second_text, ui.palette.lamp, right_eye)));
    }
    // A wheel seen from the side, turned by an angle in radians.
    void wheel(StagePoint c, float radius, float angle) const {
        ring(c, radius, ui.palette.text, 0.035f);
        for (int i = 0; i < 4; ++i) {
            const float spoke = angle + static_cast<float>(i) * maths::pi / 2;
            line(c, {c.x + radius * std::cos(spoke), c.y + radius * std::sin(spoke)}, ui.palette.second_text);
        }
        disc(c, 0.02f, ui.palette.text);
    }
    // The axes of a plot, and y = f(x) for x and y 0..1.
    template <class F>
    void plot(F f, Colour colour) const {
        line({0.4f, 0.85f}, {1.2f, 0.85f}, ui.palette.second_text);
        line({0.4f, 0.85f}, {0.4f, 0.12f}, ui.palette.second_text);
        constexpr int points = 40;
        for (int i = 0; i <= points; ++i) draw.PathLineTo(at(on_plot(static_cast<float>(i) / points, f)));
        draw.PathStroke(paint(colour), 0, thick(0.02f));
    }
    template <class F>
    static StagePoint on_plot(float x, F f) {
        return {0.4f + 0.8f * x, 0.85f - 0.7f * f(x)};
    }
};

// 0..1 and back within `period` seconds, smoothly; 0 at time 0.
float swing(double seconds, double period) {
    return 0.5f - 0.5f * static_cast<float>(std::cos(2 * static_cast<double>(maths::pi) * seconds / period));
}

// 0..1, then from 0 again.
float saw(double seconds, double period) { return static_cast<float>(seconds / period - std::floor(seconds / period)); }

constexpr StagePoint left_end{0.35f, 0.5f}, right_end{1.25f, 0.5f};

void show_sensor(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float light = swing(t, 4);
    s.lamp({0.25f + 0.45f * light, 0.35f}, 1);
    s.vehicle({1.2f, 0.5f}, maths::pi, 0.36f, light * 0.8f, light);
}

void show_field(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float lamp_y = 0.12f + 0.76f * swing(t, 4);
    const StagePoint eye{0.35f, 0.5f};
    const float off = std::fabs(std::atan2(lamp_y - eye.y, 0.85f));
    const bool seen = off < 0.3f;
    const Colour colour = seen ? ui.palette.lamp : ui.palette.second_text;
    s.draw.PathLineTo(s.at(eye));
    s.draw.PathArcTo(s.at(eye), 1.05f * s.unit, -0.3f, 0.3f, 16);
    s.draw.PathFillConvex(paint(colour.with_alpha(0.25f)));
    s.vehicle({0.25f, 0.5f}, 0, 0.22f, seen ? 1.0f : 0.0f, seen ? 1.0f : 0.0f);
    s.lamp({1.2f, lamp_y}, seen ? 1.0f : 0.3f);
}

void show_channel(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const std::array colours{colour_of(ui.palette, Channel::red), colour_of(ui.palette, Channel::green),
                             colour_of(ui.palette, Channel::blue)};
    const auto active = static_cast<std::size_t>(saw(t, 4.5) * 3) % 3;
    for (std::size_t i = 0; i < 3; ++i) {
        const StagePoint start{0.25f, 0.2f + 0.3f * static_cast<float>(i)}, end{1.15f, start.y};
        s.disc(start, i == active ? 0.09f : 0.05f, colours[i]);
        if (i == active)
            s.wire(start, end, colours[i], t);
        else
            s.line(start, end, ui.palette.line);
        s.node({1.3f, start.y}, i == active ? 1.0f : 0.0f, 0.09f);
    }
}

void show_signal(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float value = swing(t, 4);
    s.wire(left_end, right_end, ui.palette.accent, t, 0.02f, 0.6f);
    s.node(left_end, value, 0.14f), s.node(right_end, swing(t - 0.5, 4), 0.14f);
}

void show_wire(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    s.lamp({0.3f, 0.2f}, 1);
    s.wire({0.45f, 0.3f}, {1.15f, 0.75f}, ui.palette.excites, t);
    s.node({0.45f, 0.3f}, 0.8f);
    s.wheel({1.2f, 0.78f}, 0.16f, static_cast<float>(t) * 2.5f);
}

void show_weight(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float weight = swing(t, 5);
    s.wire(left_end, right_end, ui.palette.excites, t, 0.01f + 0.07f * weight);
    s.node(left_end, 0.6f, 0.13f), s.node(right_end, 0.6f * weight, 0.13f);
}

// A wire that makes its wheel faster or slower while the lamp is bright.
void show_effect(const Ui& ui, Rect r, double t, bool excites) {
    const Stage s(ui, r);
    constexpr double period = 5, turn = 2 * static_cast<double>(maths::pi);
    const float light = swing(t, period);
    // The integral of a speed that swings between 0.4 and 3.6 rad/s.
    const double swung = period / turn * std::sin(turn * t / period);
    const double angle = excites ? 2 * t - 1.6 * swung : 2 * t + 1.6 * swung;
    s.lamp({0.3f, 0.35f}, light);
    s.wire({0.45f, 0.42f}, {1.0f, 0.62f}, excites ? ui.palette.excites : ui.palette.inhibits, t,
           0.015f + 0.03f * light);
    s.node({0.45f, 0.42f}, light, 0.09f);
    s.wheel({1.15f, 0.65f}, 0.22f, static_cast<float>(std::fmod(angle, turn)));
}
void show_excites(const Ui& ui, Rect r, double t) { show_effect(ui, r, t, true); }
void show_inhibits(const Ui& ui, Rect r, double t) { show_effect(ui, r, t, false); }

void show_threshold(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float in = swing(t, 5), out = in < 0.5f ? 0 : in;
    s.box({0.3f, 0.9f - 0.7f * in}, {0.5f, 0.9f}, ui.palette.accent);
    s.line({0.2f, 0.55f}, {0.6f, 0.55f}, ui.palette.text);
    s.line({0.7f, 0.5f}, {0.95f, 0.5f}, ui.palette.second_text);
    s.line({0.95f, 0.5f}, {0.88f, 0.44f}, ui.palette.second_text);
    s.line({0.95f, 0.5f}, {0.88f, 0.56f}, ui.palette.second_text);
    s.line({1.02f, 0.9f}, {1.38f, 0.9f}, ui.palette.second_text);
    if (out > 0) s.box({1.1f, 0.9f - 0.7f * out}, {1.3f, 0.9f}, ui.palette.accent);
}

void show_neuron(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float one = swing(t, 4), two = swing(t, 6);
    const StagePoint middle{0.85f, 0.5f};
    s.wire({0.25f, 0.2f}, middle, ui.palette.excites, t), s.wire({0.25f, 0.8f}, middle, ui.palette.excites, t);
    s.wire(middle, {1.4f, 0.5f}, ui.palette.excites, t);
    s.node({0.25f, 0.2f}, one), s.node({0.25f, 0.8f}, two), s.node(middle, (one + two) / 2, 0.18f);
}

void show_curve(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const auto hump = [](float x) { return std::exp(-25 * (x - 0.55f) * (x - 0.55f)); };
    s.plot(hump, ui.palette.accent);
    s.disc(Stage::on_plot(swing(t, 5), hump), 0.045f, ui.palette.text);
}

void show_motor(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    s.wire({0.2f, 0.5f}, {0.55f, 0.5f}, ui.palette.excites, t, 0.02f, 1);
    s.box({0.5f, 0.32f}, {0.85f, 0.68f}, mix(ui.palette.raised, ui.palette.text, 0.4f));
    s.line({0.85f, 0.5f}, {1.15f, 0.5f}, ui.palette.text, 0.05f);
    s.wheel({1.15f, 0.5f}, 0.26f, static_cast<float>(t) * 2.5f);
}

void show_wheel(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float x = 0.3f + swing(t, 6);
    s.line({0.1f, 0.82f}, {1.5f, 0.82f}, ui.palette.second_text);
    s.wheel({x, 0.56f}, 0.25f, (x - 0.3f) / 0.25f);
}

void show_bias(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    s.box({0.05f, 0.05f}, {1.55f, 0.95f}, mix(ui.palette.ground, ui.palette.text, 0.06f));
    s.ring({0.35f, 0.2f}, 0.06f, ui.palette.second_text);
    s.vehicle({0.25f + 1.1f * saw(t, 4), 0.6f}, 0, 0.3f);
}

void show_feedback(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const StagePoint middle{0.8f, 0.5f};
    constexpr float radius = 0.34f;
    s.ring(middle, radius, ui.palette.second_text);
    for (int i = 0; i < 3; ++i) {
        const float turn = 2 * maths::pi * (saw(t, 3) + static_cast<float>(i) / 3);
        s.disc({middle.x + radius * std::cos(turn), middle.y + radius * std::sin(turn)}, 0.03f, ui.palette.accent);
    }
    s.lamp({middle.x - radius, 0.5f}, 1);
    s.vehicle({middle.x + radius, 0.5f}, -maths::pi / 2 + 0.3f * std::sin(static_cast<float>(t) * 2), 0.24f);
}

void show_taxis(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float way = saw(t, 4), angle = -maths::pi / 2 * (1 - way);
    s.lamp({1.35f, 0.75f}, 1);
    s.vehicle({0.3f + 0.85f * way, 0.75f - 0.5f * (1 - way) * (1 - way)}, -0.3f * angle * (1 - way), 0.26f, 0.3f, 0.8f);
}

void show_phobia(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float way = saw(t, 4);
    s.lamp({0.8f, 0.8f}, 1);
    s.vehicle({0.25f + 1.05f * way, 0.6f - 0.4f * way * way}, -0.75f * way, 0.26f, 0.1f, 0.8f * (1 - way));
}

void show_memory(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float time = saw(t, 5), lit = time < 0.2f ? 1.0f : 0.0f;
    const float kept = time < 0.2f ? time * 5 : 1 - 0.6f * (time - 0.2f) / 0.8f;
    s.lamp({0.3f, 0.5f}, lit);
    s.line({0.4f, 0.5f}, {0.95f, 0.5f}, lit > 0 ? ui.palette.excites : ui.palette.line, 0.02f);
    s.ring({1.22f, 0.3f}, 0.12f, ui.palette.second_text);
    s.node({1.1f, 0.5f}, kept, 0.18f);
}

void show_learning(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const float time = saw(t, 6);
    const bool both = std::fmod(time * 4, 1.0f) < 0.5f;
    s.line(left_end, right_end, ui.palette.excites, 0.01f + 0.07f * time);
    s.node(left_end, both ? 1.0f : 0.1f, 0.14f), s.node(right_end, both ? 1.0f : 0.1f, 0.14f);
}

void show_noise(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const auto trembling = [t](float x) {
        const float time = x * 20 + static_cast<float>(std::fmod(t, 60.0)) * 6;
        return 0.5f + 0.12f * std::sin(time * 1.7f) + 0.1f * std::sin(time * 3.1f) + 0.06f * std::sin(time * 7.3f);
    };
    s.plot([](float) { return 0.5f; }, ui.palette.line);
    s.plot(trembling, ui.palette.accent);
}

// The bars of a parent and of its copy: the weights of their wires.
void show_mutation(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    constexpr std::array parent{0.5f, 0.3f, 0.7f, 0.4f}, error{0.12f, -0.15f, 0.05f, 0.2f};
    const float grown = swing(t, 5);
    for (std::size_t i = 0; i < parent.size(); ++i) {
        const float x = 0.15f + 0.12f * static_cast<float>(i), copy = parent[i] + error[i] * grown;
        s.box({x, 0.9f - parent[i]}, {x + 0.08f, 0.9f}, ui.palette.second_text);
        s.box({x + 0.85f, 0.9f - copy}, {x + 0.93f, 0.9f}, ui.palette.accent);
    }
    s.line({0.72f, 0.6f}, {0.9f, 0.6f}, ui.palette.text);
    s.line({0.9f, 0.6f}, {0.84f, 0.55f}, ui.palette.text), s.line({0.9f, 0.6f}, {0.84f, 0.65f}, ui.palette.text);
}

void show_selection(const Ui& ui, Rect r, double t) {
    const Stage s(ui, r);
    const auto kept = static_cast<int>(saw(t, 4.5) * 3) % 3;
    for (int i = 0; i < 3; ++i) {
        const StagePoint middle{0.35f + 0.45f * static_cast<float>(i), 0.5f};
        s.vehicle(middle, -maths::pi / 2, 0.26f);
        if (i == kept) s.ring(middle, 0.2f, ui.palette.accent, 0.03f);
    }
}

constexpr GlossaryTerm all_terms[]{
    {"sensor", show_sensor},       {"field", show_field},       {"channel", show_channel},
    {"signal", show_signal},       {"wire", show_wire},         {"weight", show_weight},
    {"excites", show_excites},     {"inhibits", show_inhibits}, {"threshold", show_threshold},
    {"curve", show_curve},         {"neuron", show_neuron},     {"bias", show_bias},
    {"motor", show_motor},         {"wheel", show_wheel},       {"feedback", show_feedback},
    {"taxis", show_taxis},         {"phobia", show_phobia},     {"noise", show_noise},
    {"memory", show_memory},       {"learning", show_learning}, {"mutation", show_mutation},
    {"selection", show_selection},
};

}  // namespace

std::span<const GlossaryTerm> terms() { return all_terms; }

const GlossaryTerm* find_term(std::string_view id) {
    const auto found = std::find_if(std::begin(all_terms), std::end(all_terms),
                                    [id](const GlossaryTerm& term) { return term.id == id; });
    return found == std::end(all_terms) ? nullptr : &*found;
}

}  // namespace braitenlab::ui
