// The brain on the deck, and the wheel speeds.
#include <algorithm>
#include <cmath>

#include "core/maths/angle.h"
#include "render/view/deck.h"
#include "render/view/drawing.h"

namespace braitenlab::render {

using maths::vec2;
using maths::vec4;

namespace {

constexpr float crossed_out = -1;  // in place of a neuron's value

// On the deck below a cable, away from the sun.
void add_cable_shadow(Drawing& drawing, const Subject& s, const DeckWire& run, float thin) {
    constexpr float width = 0.05f, above = 0.03f;  // m
    if (s.pixels < least_part_shadow) return;
    const vec2 offset = away_from_sun(above) * s.height_scale;
    const vec2 a = s.to_world(run.from) + offset, b = s.to_world(run.to) + offset, c = s.to_world(run.bend) + offset;
    const float height = (deck_height + 0.0045f) * s.height_scale;  // above the inlay, below the ends of cables
    drawing.list.wires.push_back({{a.x, a.y, b.x, b.y},
                                  {c.x, c.y, height, width * thin * s.height_scale},
                                  rgb_with(drawing.colours.wheel, 0),
                                  {}});
}

void add_wire(Drawing& drawing, const Subject& s, const DeckWire& run, int layer, float thin) {
    const Wire& wire = s.brain->wires[run.wire];
    const float more = learns(wire) ? learned(drawing.now, s.view, wire.from, wire.to) : 0;
    const float weight = std::clamp(wire.weight + more, -limits::weight, limits::weight);
    const float now = std::min(1.0f, std::fabs(signal(wire, node_value(drawing.now, s.view, wire.from), more)));
    const vec2 a = s.to_world(run.from), b = s.to_world(run.to), c = s.to_world(run.bend);
    // Different heights keep crossing wires from flickering.
    const float height = (deck_height + 0.010f) * s.height_scale + 0.003f * static_cast<float>(layer % 8);
    const float thinnest = s.fine ? 0.052f : 0.028f;  // m; cables are visible from farther away
    const bool excites = weight > 0;
    const Colour colour = excites ? drawing.colours.excites : drawing.colours.inhibits;
    if (s.fine && !wire.cut) add_cable_shadow(drawing, s, run, thin);
    drawing.list.wires.push_back(
        {{a.x, a.y, b.x, b.y},
         {c.x, c.y, height, (thinnest + 0.05f * std::fabs(weight) / limits::weight) * thin * s.height_scale * s.detail},
         rgb_with(wire.cut ? mix(colour, drawing.colours.wheel, 0.6f) : colour, excites ? 1.0f : -1.0f),
         {now, wire.cut ? 1.0f : 0.0f, s.fine ? 0.05f * s.height_scale : 0.0f, 0}});
}

void add_neuron(Drawing& drawing, const Subject& s, const DeckNeuron& neuron, float radius) {
    const float value = std::clamp(node_value(drawing.now, s.view, neuron.id), -1.0f, 1.0f);
    const vec2 at = s.to_world(neuron.place);
    const Colour colour = value < 0 ? drawing.colours.inhibits : drawing.colours.excites;
    drawing.list.neurons.push_back(
        {{at.x, at.y, (deck_height + 0.036f) * s.height_scale, radius * s.height_scale * s.detail},
         rgb_with(colour, neuron.silenced ? crossed_out : std::fabs(value))});
}

}  // namespace

const DeckPlan& DeckPlans::of(const std::shared_ptr<const BrainGraph>& brain, std::size_t kind, const Kind& design) {
    Entry& entry = entries_[{brain, kind}];
    // A plan used before in this picture is valid: sensors and body do not change within a picture.
    if (!entry.used && !(entry.planned && entry.sensors == design.sensors && entry.body == design.body))
        entry = {design.sensors, design.body, plan_deck(*brain, design), true};
    entry.used = true;
    return entry.plan;
}

void DeckPlans::forget_unused() {
    std::erase_if(entries_, [](const auto& entry) { return !entry.second.used; });
    for (auto& [brain, entry] : entries_) entry.used = false;
}

const DeckPlan* plan_of(Drawing& drawing, const Subject& s) {
    if (!s.brain || s.view.driver != Driver::brain) return nullptr;
    const auto brain = static_cast<std::size_t>(s.view.brain), kind = static_cast<std::size_t>(s.view.kind);
    return &drawing.list.decks.of(drawing.now.brains[brain], kind, s.kind);
}

void add_wires(Drawing& drawing, const Subject& s) {
    if (!s.plan || s.detail == 0 || s.driven) return;
    const DeckPlan& plan = *s.plan;
    // Wires get thinner with their number.
    const float thin =
        std::clamp(std::sqrt(8.0f / static_cast<float>(std::max<std::size_t>(plan.wires.size(), 1))), 0.3f, 1.0f);
    int layer = 0;
    for (const DeckWire& run : plan.wires) add_wire(drawing, s, run, layer++, thin);
    for (const DeckNeuron& neuron : plan.neurons) add_neuron(drawing, s, neuron, plan.neuron_radius);
}

void add_stopped_wheels(Drawing& drawing, const Subject& s) {
    if (!s.plan) return;
    for (const Wheel& wheel : s.kind.body.wheels) {
        if (wheel.motor == Motor::none || !s.plan->stopped[wheel.motor == Motor::right]) continue;
        // Above the wheel and slightly outside, beside the hull.
        const vec2 at = s.to_world({wheel.x, wheel.y + (wheel.y < 0 ? -0.04f : 0.04f) * around(drawing, s)});
        drawing.list.neurons.push_back(
            {{at.x, at.y, 2 * wheel.radius + 0.02f * around(drawing, s), 0.15f * s.height_scale},
             rgb_with(drawing.colours.excites, crossed_out)});
    }
}

void add_wheel_arrows(Drawing& drawing, const Subject& s) {
    if (!s.selected || s.driven) return;
    constexpr float longest = 0.9f, least = 0.03f;  // lengths of the body at full speed; no arrow below `least`
    const float scale = around(drawing, s);
    const float widest = 0.085f * scale;  // m, half; a short arrow is not wider than long
    for (const Wheel& wheel : s.kind.body.wheels) {
        if (wheel.motor == Motor::none) continue;
        const float speed = std::clamp(s.view.motor[wheel.motor == Motor::right], -1.0f, 1.0f);
        if (std::fabs(speed) < least) continue;
        const float half = 0.5f * longest * std::fabs(speed) * s.kind.body.length, way = speed < 0 ? -1.0f : 1.0f;
        const float beside = wheel.y + (wheel.y < 0 ? -0.19f : 0.19f) * scale;
        const vec2 middle = s.to_world({wheel.x + way * half, beside});
        drawing.list.rings.push_back(
            {{middle.x, middle.y, way * s.ahead.x, way * s.ahead.y},
             {half, std::min(widest, half), 0.012f * scale, static_cast<float>(MarkKind::arrow)},
             rgb_with(drawing.colours.text, 1)});
    }
}

}  // namespace braitenlab::render
