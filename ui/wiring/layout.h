// Where a brain's nodes, pins, wires and labels are on the canvas, and the arrangement of nodes: all of a brain
// automatically (tidy.cpp), or selected ones in a column, a row or at even gaps.
//
// No Dear ImGui. All in canvas units: one unit is one layout pixel at zoom 1; x to the right, y down.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/brain/graph.h"
#include "core/maths/vec.h"

namespace braitenlab::wiring {

// A diagram of more nodes is a map in a lecture: it is read by the names of its nodes and of their groups alone.
inline constexpr std::size_t few_nodes = 12;

using Positions = std::map<NodeId, maths::vec2>;  // centres of nodes, canvas units

struct NodeShape {
    NodeId id = 0;
    NodeKind kind = NodeKind::neuron;
    maths::vec2 centre, size;
    bool has_in = false, has_out = false;
    float in_spread = 0;   // wires end up to half of this above and below the in-pin
    std::size_t node = 0;  // index in BrainGraph::nodes
    int unit = 0;          // of a neuron: its rank among the neurons by ascending id
    maths::vec2 in_pin() const { return {centre.x - size.x / 2, centre.y}; }
    maths::vec2 out_pin() const { return {centre.x + size.x / 2, centre.y}; }
};

struct WireShape {
    WireEnds ends;
    std::array<maths::vec2, 4> bezier{};  // start, two controls, end
    bool ghost = false;                   // weight 0 and not learning: drawn as a free place for a wire
    bool direct = false;                  // one of LL, LR, RL, RR
    bool aside = false;                   // pale and without a label; see LetterRoom::aside
    maths::vec2 label, label_size;        // centre and size of the weight's label; size 0: it has none
    maths::vec2 low, high;                // corners of the box around curve and label
    int wire = -1;                        // index in BrainGraph::wires; −1: a direct place without a wire
    std::size_t from = 0, to = 0;         // indices in Layout::nodes
    int learner = -1;                     // rank among the learning wires by (from, to); −1: does not learn
};

// What labels and letters need where they are large in comparison with the cards, at a small zoom and in a lecture, and
// which labels are left out.
struct LetterRoom {
    float label_growth = 1;       // labels are so many times as large
    bool has_free_labels = true;  // free places for a wire have a label, too
    float neuron_width = 150;
    std::vector<NodeId> aside;  // sensors whose wires, other than direct ones, are not the subject: without labels
    friend bool operator==(const LetterRoom&, const LetterRoom&) = default;
};

struct Layout {
    std::vector<NodeShape> nodes;                       // in drawing order: the last is on top
    std::vector<WireShape> wires;                       // the four direct places first
    maths::vec2 low, high;                              // corners of the box around all nodes; both 0 without nodes
    std::vector<std::pair<NodeId, std::size_t>> by_id;  // of nodes, ascending
    bool has_neurons = false;
    LetterRoom room;
};

// Depends on its arguments only, the centres of nodes on the graph and `held`. The position of a node is that in
// `held`, else Node::place, else that of tidy().
Layout lay_out(const BrainGraph&, const Positions& held, const LetterRoom& = {});

// Caches the last layout until one of the arguments changes.
class LayoutCache {
public:
    const Layout& get(const std::shared_ptr<const BrainGraph>&, const Positions& held, const LetterRoom& = {});

private:
    std::shared_ptr<const BrainGraph> graph_;  // shared ownership, so that no other graph can have the same address
    Positions held_;
    Layout layout_;
};

// The brain with every node at its position in the layout.
BrainGraph with_positions(BrainGraph, const Layout&);

// An edited brain whose nodes keep their positions in `shown`. Positions are written only if tidy() would move a node.
BrainGraph keep_positions(BrainGraph edited, const Layout& shown);

// The position nearest to `wanted` where a box of this size covers no card and no label; `wanted` itself when none is
// free within 40 steps of 28 units.
maths::vec2 free_position(const Layout&, maths::vec2 wanted, maths::vec2 size);

maths::vec2 card_size(NodeKind);

// The shape of a node or wire, or null.
const NodeShape* find_shape(const Layout&, NodeId);
const WireShape* find_shape(const Layout&, WireEnds);

// wire_name() of a wire of the layout, without searching its nodes.
std::string name_of(const BrainGraph&, const Layout&, const WireShape&);

// The curve from an out-pin to an in-pin. A wire that runs backwards or to its own node arches over the cards;
// between two nodes one above the other it passes between their cards.
std::array<maths::vec2, 4> wire_curve(maths::vec2 from, maths::vec2 to);

// The point of a cubic bezier at t in 0..1.
maths::vec2 bezier_point(const std::array<maths::vec2, 4>&, float t);

inline constexpr int wire_segments = 24;  // straight pieces that a wire is hit as, and half of those it is drawn as

// Boxes sorted into square cells: the time of a query does not depend on their number.
class OccupiedBoxes {
public:
    void add(maths::vec2 centre, maths::vec2 size);
    bool overlaps(maths::vec2 centre, maths::vec2 size) const;

private:
    struct Box {
        maths::vec2 centre, size;
    };
    std::unordered_map<std::uint64_t, std::vector<Box>> cells_;
};

// A position for every node: sensors left, neurons in columns by their distance from a sensor, motors right; names that
// end in L above names that end in R. Deterministic, and independent of the order of nodes and wires.
Positions tidy(const BrainGraph&);

enum class Arrangement { column, row, even_down, even_across };  // one x; one y; equal vertical or horizontal gaps

// New positions for these nodes. In a column or a row, cards that would overlap are moved apart. With even gaps, the
// two outermost nodes do not move. Empty for fewer than two nodes, or for fewer than three with even gaps.
Positions arranged(const Layout&, const std::set<NodeId>&, Arrangement);

}  // namespace braitenlab::wiring
