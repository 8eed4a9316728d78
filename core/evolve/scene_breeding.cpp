#include "core/evolve/scene_breeding.h"

#include <algorithm>
#include <cmath>

#include "core/brain/four_neurons.h"
#include "core/maths/degrees.h"
#include "core/scene/brain_text.h"
#include "core/scene/schema.h"
#include "core/utf8.h"

namespace braitenlab::evolve {

namespace {

// Of a child: weights and biases as in the shipped breedings.
constexpr float weight_error = 0.3F, bias_error = 0.15F, threshold_error = 0.1F, angle_error = 20;

void add_gene(Breed& breed, const std::string& path, float low, float high, float mutation, float now) {
    if (breed.genes.size() == limits::genes) return;
    breed.genes.push_back({.name = utf8_cut(path, braitenlab::limits::name_length),
                           .paths = {path},
                           .low = std::min(low, now),
                           .high = std::max(high, now),
                           .mutation = mutation,
                           .start = now});
}

void add_brain(Breed& breed, const BrainGraph& brain, const MayChange& may) {
    const BrainText text = to_text(brain);
    const auto add_weight = [&](const std::string& path, float now) {
        add_gene(breed, path, -2, 2, weight_error, now);
    };
    const auto add_bias = [&](const std::string& path, float now) { add_gene(breed, path, -1, 1, bias_error, now); };
    const auto add_threshold = [&](const std::string& path, float now) {
        add_gene(breed, path, 0, 1, threshold_error, now);
    };
    if (!text.given.empty())
        for (const Dial dial : all_dials) {
            const std::string path = "brain." + std::string(name(dial));
            const float now = at(text.dials, dial);
            if (is_bias(dial) && may.biases) add_bias(path, now);
            if (is_weight(dial) && may.weights) add_weight(path, now);
            if (!is_bias(dial) && !is_weight(dial) && may.thresholds) add_threshold(path, now);
        }
    for (const WireText& each : text.wires) {
        const std::string path = "brain.wire." + each.from + "-" + each.to + ".";
        if (may.weights) add_weight(path + "weight", each.wire.weight);
        if (may.thresholds) add_threshold(path + "threshold", each.wire.threshold);
    }
    for (const NodeText& each : text.nodes)
        if (may.biases && each.node.kind != NodeKind::sensor)
            add_bias("brain.node." + each.node.name + ".bias", each.node.bias);
}

// The number of degrees that a file reads as this angle, if it has at most three decimals: the first parent is the kind
// as it is.
float degrees_of_eye(float angle) {
    const double degrees = static_cast<double>(angle) * (180 / maths::pi_d);
    for (const double steps : {1.0, 10.0, 100.0, 1000.0}) {
        const double rounded = std::round(degrees * steps) / steps;
        if (maths::from_degrees(rounded) == angle) return static_cast<float>(rounded);
    }
    return static_cast<float>(degrees);
}

bool is_eye(const Sensor& sensor) {
    return row_of(sensor.channel).is_light || sensor.channel == Channel::predator || sensor.channel == Channel::prey;
}

}  // namespace

SceneBreeding breeding_of_scene(Scene scene, const MayChange& may, std::string title) {
    for (Start& start : scene.starts) {
        const int index = find_kind(scene, start.kind);
        if (index < 0 || scene.kinds[static_cast<std::size_t>(index)].role == Role::none) continue;
        Kind& kind = scene.kinds[static_cast<std::size_t>(index)];
        if (start.brain) kind.brain = *start.brain, start.brain.reset();
        if (start.sensors) kind.sensors = *start.sensors, start.sensors.reset();
    }
    Breeding breeding{.id = "scene", .file = "breeding.toml", .title = std::move(title), .scene = "scene.toml"};
    breeding.opponents = Opponents::archive;
    breeding.generations = 30;
    breeding.from_scene = true;
    for (const Role role : {Role::predator, Role::prey}) {
        const auto kind = std::find_if(scene.kinds.begin(), scene.kinds.end(),
                                       [role](const Kind& each) { return each.role == role; });
        if (kind == scene.kinds.end() || kind->hidden) continue;
        Breed breed{.kind = kind->name, .genes = {}};
        add_brain(breed, kind->brain, may);
        for (const Sensor& sensor : kind->sensors)
            if (may.eyes && is_eye(sensor))
                add_gene(breed, "sensor." + sensor.name + ".angle", -180, 180, angle_error,
                         degrees_of_eye(sensor.angle));
        if (!breed.genes.empty()) breeding.breeds.push_back(std::move(breed));
    }
    return {std::move(breeding), std::move(scene)};
}

}  // namespace braitenlab::evolve
