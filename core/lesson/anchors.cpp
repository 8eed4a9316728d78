#include "core/lesson/anchors.h"

#include <string_view>

#include <fmt/format.h>

namespace braitenlab {

namespace {

constexpr std::string_view fixed_anchors[]{
    // the brain's sliders
    "slider.LL", "slider.LR", "slider.RL", "slider.RR", "threshold.LL", "threshold.LR", "threshold.RL", "threshold.RR",
    "bias.LM", "bias.RM", "button.mirror", "button.cross", "button.thresholds", "button.presets", "button.drive",
    "button.why", "button.map", "button.reality", "curve.peak", "curve.width",
    // the map of behaviour
    "card.map", "card.map.fold", "map", "map.dot", "map.x", "map.y", "map.measure", "map.x.low", "map.x.high",
    "map.y.low", "map.y.high",
    // slots A and B
    "card.slots", "card.slots.fold", "slot.a", "slot.b", "slot.a.store", "slot.b.store", "slots.close",
    "button.compare",
    // the trial with real robots
    "card.reality", "card.reality.fold", "reality.slider", "reality.try", "reality.dots", "reality.weakest",
    "reality.all", "reality.cancel",
    // its picture, with what a lesion can be set to
    "brain.character", "brain.picture", "equations", "lesion.SL", "lesion.SR", "lesion.ML", "lesion.MR", "lesion.LL",
    "lesion.LR", "lesion.RL", "lesion.RR",
    // the wiring editor
    "canvas", "canvas.arrange", "canvas.fit", "wire.LL", "wire.LR", "wire.RL", "wire.RR", "curve.LL", "curve.LR",
    "curve.RL", "curve.RR",
    // the toolbar
    "button.play", "button.step", "button.reset", "button.slower", "button.faster", "button.follow", "button.wiring",
    "button.watch", "button.undo", "button.save", "button.charts", "mode", "speed", "time",
    // the menu bar
    "menu.file", "menu.edit", "menu.view", "menu.simulation", "menu.exercises", "menu.lecture", "menu.help",
    // the timeline
    "timeline.track", "timeline.rewind", "timeline.bookmark", "timeline.behind",
    // the exercise
    "selection.open", "exercise.breeding", "exercise.predict", "exercise.draw", "exercise.compare", "exercise.hint",
    "exercise.goal", "exercise.grade", "exercise.show_me", "exercise.reset", "exercise.why", "exercise.note",
    "exercise.hand_in", "exercise.lab_record", "exercise.medians", "button.free_play", "button.open_wiring",
    // cards and the arena
    "card.exercise", "card.exercise.fold", "card.brain", "card.brain.fold", "card.information", "card.information.fold",
    "card.sensors", "card.sensors.fold", "card.inspector", "card.inspector.fold", "info.figures", "info.signals",
    "hint.bar", "viewport"};

}  // namespace

std::vector<std::string> anchors_of(const Exercise& exercise) {
    std::vector<std::string> anchors(std::begin(fixed_anchors), std::end(fixed_anchors));
    for (std::size_t i = 0; i < exercise.steps.size(); ++i) anchors.push_back(fmt::format("exercise.step.{}", i + 1));
    for (std::size_t i = 0; i < exercise.prediction.options.size(); ++i)
        anchors.push_back(fmt::format("exercise.predict.{}", i + 1));
    for (int i = 1; i <= exercise.starts; ++i) anchors.push_back(fmt::format("exercise.start.{}", i));
    if (exercise.scene.starts.empty()) return anchors;
    for (const Node& node : exercise.scene.kinds[static_cast<std::size_t>(subject_kind(exercise.scene))].brain.nodes) {
        anchors.push_back("node." + node.name);
        if (node.kind != NodeKind::sensor) anchors.push_back("pin." + node.name + ".in");
        if (node.kind != NodeKind::motor) anchors.push_back("pin." + node.name + ".out");
    }
    return anchors;
}

std::string describe_anchors() {
    std::string text =
        "\n## Anchors\n\nA hint's `anchor` is one of these ids. NODE is the name of a node of the vehicle's brain, N a "
        "number "
        "from 1.\n\n";
    std::string line;
    const auto add = [&](std::string_view anchor) {
        if (line.size() + anchor.size() > 110) text += line + "\n", line.clear();
        line += fmt::format("{}`{}`", line.empty() ? "" : " ", anchor);
    };
    for (const std::string_view anchor : fixed_anchors) add(anchor);
    for (const char* anchor :
         {"exercise.step.N", "exercise.predict.N", "exercise.start.N", "node.NODE", "pin.NODE.in", "pin.NODE.out"})
        add(anchor);
    return text + line + "\n";
}

}  // namespace braitenlab
