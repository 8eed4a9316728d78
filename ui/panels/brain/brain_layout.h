// Layout of the brain picture: positions of a brain's sensors, neurons, motors and wires. No widgets.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/brain/graph.h"
#include "core/scene/scene.h"
#include "core/scene/sensor_pairs.h"
#include "render/view/camera.h"
#include "ui/panels/brain/brain_sketch.h"

namespace braitenlab::ui::sketch {

struct NodeMark {
    const Node* node = nullptr;  // in the brain; null where the brain has no such node
    std::string name;
    std::string anchor;  // "lesion.SL"
    ImVec2 at;           // centre, window pixels
};

struct WireMark {
    int wire = -1;                // index in BrainGraph::wires; −1: a place without a wire
    std::string letters, anchor;  // of a wire between the pair and a motor "LR" and "lesion.LR", else "S3 → N1"
    WirePath path{};
};

struct BrainLayout {
    Rect chassis;
    std::vector<NodeMark> sensors, neurons;  // sensors from left to right
    std::array<NodeMark, 2> motors;          // left, right
    std::vector<WireMark> wires;
    float sensor_radius = 9;  // layout pixels
    float neuron_radius = 0;  // window pixels
};

// The sensors that the brain reads, from the vehicle's left to its right.
std::vector<Sensor> read_sensors(const BrainGraph&, const Kind&);

// True when every wire that has a weight, learns or is cut joins a sensor of the pair and a motor.
bool is_four_wires(const BrainGraph&, const SensorPair&);

// The additional height of a picture that shows the whole brain, layout pixels; in a low card less for one without
// neurons between sensors and motors.
inline constexpr float graph_height = 44, low_graph_height = 10;

// Only the pair, the motors and the four wires between them, also those of weight 0. `scale`: window pixels per layout
// pixel.
BrainLayout lay_out_pair(const BrainGraph&, const SensorPair&, Rect area, float scale);

// The whole brain: the sensors that it reads in a row, by their mounts from left to right; neurons below them in the
// order of the signals, as on the vehicle's deck; motors at the lower end.
BrainLayout lay_out_graph(const BrainGraph&, const Kind&, const SensorPair&, Rect area, float scale);

// The whole brain from left to right, for a low and wide picture: the sensors that it reads from top to bottom at the
// left edge, from the vehicle's left to its right; the left motor above the right one at the right edge.
BrainLayout lay_out_sideways(const BrainGraph&, const Kind&, const SensorPair&, Rect area, float scale);

}  // namespace braitenlab::ui::sketch
