// braitenctl show: prints what a file contains.
#include <iostream>

#include "app/ctl/ctl.h"
#include "app/files/data.h"
#include "app/terminal.h"
#include "core/brain/recogniser.h"
#include "core/io/run_file.h"
#include "core/lesson/exercise_file.h"
#include "core/maths/angle.h"
#include "core/scene/enums.h"
#include "core/scene/file_kind.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

std::string node_name(const BrainGraph& brain, NodeId id) {
    const Node* node = find_node(brain, id);
    return node ? node->name : "?";
}

std::string wire_text(const BrainGraph& brain, const Wire& wire) {
    std::string text =
        format_lines("{} → {}  {:+.3g}", node_name(brain, wire.from), node_name(brain, wire.to), wire.weight);
    if (wire.threshold > 0) text += format_lines(", from {:.3g} on", wire.threshold);
    if (wire.curve.response != Response::linear) text += format_lines(", {}", word(wire.curve.response));
    if (learns(wire)) text += ", learns";
    if (wire.cut) text += ", cut";
    return text;
}

void show_brain(const BrainGraph& brain, const std::string& indent) {
    std::cout << format_lines("{}brain: {}, {} nodes, {} wires\n", indent, name(recognise(brain)), brain.nodes.size(),
                              brain.wires.size());
    for (const Wire& wire : brain.wires)
        if (wire.weight != 0 || learns(wire)) std::cout << format_lines("{}  {}\n", indent, wire_text(brain, wire));
    for (const Node& node : brain.nodes)
        if (node.bias != 0) std::cout << format_lines("{}  {} has a bias of {:+.3g}\n", indent, node.name, node.bias);
}

void show_sensors(const std::vector<Sensor>& sensors) {
    for (const Sensor& s : sensors)
        std::cout << format_lines("  sensor {}: {}, {}, at {:.0f}°, {:.0f}° wide, {:g} m\n", s.name, word(s.channel),
                                  word(s.shape), maths::degrees(s.angle), maths::degrees(s.fov), s.range);
}

void show_kind(const Kind& kind) {
    std::cout << format_lines("kind {}: role {}, driver {}\n", kind.name, word(kind.role), word(kind.driver));
    show_sensors(kind.sensors);
    if (kind.hidden)
        std::cout << "  its brain is hidden\n";
    else
        show_brain(kind.brain, "  ");
}

void show_scene(const Scene& scene) {
    std::cout << format_lines("scene {}: {}\n", scene.name, scene.title);
    if (!scene.story.empty()) std::cout << format_lines("{}\n", scene.story);
    std::cout << format_lines("arena {:g} × {:g} m, rim: {}\n", scene.arena.width, scene.arena.height,
                              word(scene.arena.edge));
    std::cout << format_lines("{} vehicles placed, {} at random; {} sources, {} obstacles, {} zones\n",
                              scene.starts.size(), scene.ecology.population, scene.sources.size(),
                              scene.obstacles.size(), scene.zones.size());
    for (const Kind& kind : scene.kinds) show_kind(kind);
    for (const Start& start : scene.starts)
        if (start.sensors) {
            std::cout << format_lines("vehicle {}: {} sensors of its own\n", start.name, start.sensors->size());
            show_sensors(*start.sensors);
        }
}

void show_exercise(const Exercise& exercise) {
    std::cout << format_lines("exercise {}: {} steps, {} hints, {} of {} starts must pass\n", exercise.id,
                              exercise.steps.size(), exercise.hints.size(), exercise.needed, exercise.starts);
    show_scene(exercise.scene);
}

int show_run(const std::string& file) {
    const auto run = io::load_run(file);
    if (!run) return complain(run.error());
    const Snapshot now = snapshot_of(World::restore(run->checkpoint));
    std::cout << format_lines("saved run at {:.1f} s, seed {}: {} vehicles, generation {}\n", now.seconds, now.seed,
                              now.vehicles.size(), now.generation);
    Scene scene = *now.scene;
    for (std::size_t k = 0; k < scene.kinds.size(); ++k) scene.kinds[k].brain = *now.kind_brains[k];
    show_scene(scene);
    return exit_code::done;
}

}  // namespace

int show(const std::string& name) {
    if (name.ends_with(io::run_ending)) return show_run(name);
    const auto path = find_shipped(name);
    if (!path) return complain(path.error());
    const auto text = read_text(*path);
    if (!text) return complain(text.error());
    const FileKind kind = detect_kind(*path, *text);
    if (kind == FileKind::exercise) {
        const auto exercise = parse_exercise(*text, *path);
        if (!exercise) return complain(exercise.error());
        show_exercise(*exercise);
    } else if (kind == FileKind::lecture) {
        return complain({"this is a lecture, which 'show' does not print; use 'check'", path->string()});
    } else if (kind == FileKind::study) {
        return complain({"this is a study, which 'show' does not print; use 'study'", path->string()});
    } else if (kind == FileKind::breeding) {
        return complain({"this is a breeding, which 'show' does not print; use 'breed'", path->string()});
    } else if (kind == FileKind::brain) {
        const auto brain = parse_brain(*text, path->string());
        if (!brain) return complain(brain.error());
        show_brain(*brain, "");
    } else {
        const auto scene = parse_scene(*text, path->string());
        if (!scene) return complain(scene.error());
        show_scene(*scene);
    }
    return exit_code::done;
}

}  // namespace braitenlab
