// Edits of a brain's graph as pure functions: each returns the edited graph or the reason of a refusal.
//
// A result passes check_graph() when the input does.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "core/brain/graph.h"

namespace braitenlab {

// Why an edit is refused.
enum class Refusal {
    missing,            // a node or wire that the graph does not have
    into_sensor,        // a wire that would end at a sensor
    duplicate,          // a wire that the graph already has
    too_many_neurons,   // more than limits::neurons
    too_many_wires,     // more than limits::wires
    own_wire,           // a neuron cannot be inserted into a wire that it is an end of
    no_wires,           // the nodes have no wires to detach
    nothing_to_lesion,  // the lesion would change nothing
    empty_fragment,     // nothing to paste
    nothing_to_remove,  // no neuron and no wire with a weight
    fixed_node,         // sensors and motors belong to the vehicle and cannot be removed
};

struct RefusalName {
    Refusal value;
    std::string_view word;  // a stable key, not a translated word
};
inline constexpr std::array refusals{RefusalName{Refusal::missing, "gone"},
                                     RefusalName{Refusal::into_sensor, "into_sensor"},
                                     RefusalName{Refusal::duplicate, "duplicate"},
                                     RefusalName{Refusal::too_many_neurons, "neurons"},
                                     RefusalName{Refusal::too_many_wires, "wires"},
                                     RefusalName{Refusal::own_wire, "own_wire"},
                                     RefusalName{Refusal::no_wires, "no_wires"},
                                     RefusalName{Refusal::nothing_to_lesion, "nothing_to_cut"},
                                     RefusalName{Refusal::empty_fragment, "nothing_copied"},
                                     RefusalName{Refusal::nothing_to_remove, "nothing"},
                                     RefusalName{Refusal::fixed_node, "fixed"}};

// The refusal's word in `refusals`.
std::string_view name(Refusal);

// The edited graph, or the reason of the refusal.
struct [[nodiscard]] Edit {
    std::optional<BrainGraph> graph{};
    Refusal refusal{};  // valid only without a graph

    Edit(BrainGraph edited) : graph(std::move(edited)) {}
    Edit(Refusal reason) : refusal(reason) {}
    explicit operator bool() const { return graph.has_value(); }
};

// A neuron that can be added: a curve and a leaky memory.
struct NeuronKind {
    std::string_view word;  // the end of the string key "wiring.kind.<word>"
    Curve curve{};
    float time_constant = 0;  // s
};

// One neuron for every response, in the order of `responses`, then a leaky one.
inline constexpr auto neuron_kinds = [] {
    std::array<NeuronKind, responses.size() + 1> kinds{};
    for (std::size_t i = 0; i < responses.size(); ++i) kinds[i] = {responses[i].word, {responses[i].value}};
    kinds.back() = {"leaky", {}, 0.5f};
    return kinds;
}();

// A neuron of this kind with neither id nor name.
Node make_neuron(const NeuronKind&);

// The id of the next node: one above the largest.
NodeId fresh_id(const BrainGraph&);

// Adds a neuron like `model` with the id fresh_id(). It keeps the model's name if that is free, else it gets the first
// free name of N1, N2 …. Refused: too_many_neurons.
Edit add_neuron(const BrainGraph&, const Node& model = {});

// Adds a wire of weight 1. If there is a wire of weight 0 that does not learn, sets its weight to 1 and keeps its
// threshold and curve. Refused: missing, into_sensor, duplicate, too_many_wires.
Edit connect(const BrainGraph&, WireEnds);

// Sets a wire's weight, or adds a wire with this weight. Clamps to -2..2; a weight that is not finite changes
// nothing. Refused: missing, into_sensor, too_many_wires.
Edit set_weight(const BrainGraph&, WireEnds, float weight);

// Sets the parameters of the node of this id, or of the wire with these ends. Each is clamped to its range; one that is
// not finite keeps its old value. A node's id, name, kind and position do not change. Refused: missing.
Edit set_parameters(const BrainGraph&, const Node&);
Edit set_parameters(const BrainGraph&, const Wire&);

// Moves a wire with all its parameters to other ends. Refused: missing, and as connect() refuses.
Edit reconnect(const BrainGraph&, WireEnds wire, WireEnds to);

// Inserts a neuron into a wire: the wire with all its parameters ends at the neuron, and a wire of weight 1 joins the
// neuron to the old end. Refused: own_wire, and as reconnect() refuses.
Edit insert_neuron(const BrainGraph&, NodeId neuron, WireEnds into);

// Removes neurons with their wires, and wires. A wire of the four-neuron brain stays as a wire of weight 0 without
// threshold and curve. Sensors and motors stay. Refused: nothing_to_remove, fixed_node.
Edit remove(const BrainGraph&, const std::set<NodeId>& nodes, const std::set<WireEnds>& wires);

// Removes all wires of these nodes. Refused: no_wires, nothing_to_remove.
Edit detach(const BrainGraph&, const std::set<NodeId>&);

// Silences nodes and cuts wires, or restores them; they keep their parameters. Refused: nothing_to_lesion.
Edit set_lesion(const BrainGraph&, const std::set<NodeId>&, const std::set<WireEnds>&, bool lesioned);

// True when there is at least one of these nodes and wires and all of them are silenced or cut.
bool all_lesioned(const BrainGraph&, const std::set<NodeId>&, const std::set<WireEnds>&);

// True when a wire with a weight other than 0 begins or ends at the node.
bool is_wired(const BrainGraph&, NodeId);

// The wire's weight; 0 without a wire.
float weight_of(const BrainGraph&, WireEnds);

}  // namespace braitenlab
