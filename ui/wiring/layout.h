// Where a brain's nodes, pins and wires stand on the canvas.
//
// All in canvas units: one unit is one layout pixel at zoom 1; x to the right, y down.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/brain/four_neurons.h"
#include "core/maths/vec.h"
#include "ui/wiring/tidy.h"

namespace braitenlab {

struct NodeShape {
    NodeId id = 0;
    NodeKind kind = NodeKind::neuron;
    maths::vec2 centre, size;
    bool has_in = false, has_out = false;
    float in_spread = 0;   // wires arrive up to half of this above and below the in-pin
    std::size_t node = 0;  // in BrainGraph::nodes
    int unit = 0;          // of a neuron: its place among the neurons by ascending id
    maths::vec2 in_pin() const { return {centre.x - size.x / 2, centre.y}; }
    maths::vec2 out_pin() const { return {centre.x + size.x / 2, centre.y}; }
};

struct WireShape {
    WireEnds ends;
    std::array<maths::vec2, 4> bezier{};  // start, two controls, end
    bool ghost = false;                   // weight 0: a place that waits for a wire
    bool direct = false;                  // one of LL, LR, RL, RR
    maths::vec2 label, label_size;        // centre and size of the weight's label
    maths::vec2 low, high;                // corners of what holds curve and label
    int wire = -1;                        // in BrainGraph::wires; −1: a direct place that the graph has no wire for
    std::size_t from = 0, to = 0;         // in Layout::nodes
    int learner = -1;                     // its place among the learning wires by (from, to); −1: learns nothing
};

struct Layout {
    std::vector<NodeShape> nodes;                       // in drawing order: the last is on top
    std::vector<WireShape> wires;                       // the four direct places first
    maths::vec2 low, high;                              // corners of what holds all nodes; both 0 for no nodes
    std::vector<std::pair<NodeId, std::size_t>> by_id;  // of nodes, ascending
    bool has_neurons = false;
};

// The same graph and places give the same layout. Nodes in the hand stand where it `held` them, others where a person
// has put them, the rest where tidy() puts them.
Layout lay_out(const BrainGraph&, const Places& held);

// The edited brain, its nodes where the layout shows them: an edit moves nobody. Where tidying it would, the places are
// written down.
BrainGraph in_place(BrainGraph edited, const Layout& shown);

// The brain with every node where the layout shows it.
BrainGraph placed(BrainGraph, const Layout& shown);

// The place nearest to the wanted one where a box of this size covers no card and no label.
maths::vec2 free_place(const Layout&, maths::vec2 wanted, maths::vec2 size);

maths::vec2 card_size(NodeKind);

// A layout that is made anew only when the graph or what is held has changed.
class KeptLayout {
public:
    const Layout& of(const std::shared_ptr<const BrainGraph>&, const Places& held);

private:
    std::shared_ptr<const BrainGraph> graph_;  // held, so that no other graph can take its address
    Places held_;
    Layout layout_;
};

const NodeShape* find_shape(const Layout&, NodeId);
const WireShape* find_shape(const Layout&, WireEnds);

// wire_name() for a wire of the layout, without looking its ends up.
std::string name_of(const BrainGraph&, const Layout&, const WireShape&);

// The curve from an out-pin to an in-pin; a wire that runs backwards or to its own node arches over the top.
std::array<maths::vec2, 4> wire_curve(maths::vec2 from, maths::vec2 to);

// The point of a cubic bezier at t in 0..1.
maths::vec2 bezier_point(const std::array<maths::vec2, 4>&, float t);

inline constexpr int wire_segments = 24;  // straight pieces that a wire is hit as, and drawn as at most

// How the canvas lies in the window: pixel = origin + scale · unit.
struct View {
    maths::vec2 origin;
    float scale = 1;  // window pixels per canvas unit
    maths::vec2 to_window(maths::vec2 unit) const { return origin + unit * scale; }
    maths::vec2 to_canvas(maths::vec2 pixel) const { return (pixel - origin) / scale; }
};

}  // namespace braitenlab
