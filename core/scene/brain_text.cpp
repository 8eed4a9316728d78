#include "core/scene/brain_text.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "core/scene/nearest.h"

namespace braitenlab {

namespace {

// The four nodes of the dials with the key and member of their canvas position.
struct DialledNode {
    const char* name;
    std::optional<maths::vec2> BrainText::*place;
    const char* key;
};
constexpr std::array<DialledNode, 4> dialled_nodes{{{"SL", &BrainText::place_SL, "place_SL"},
                                                    {"SR", &BrainText::place_SR, "place_SR"},
                                                    {"ML", &BrainText::place_ML, "place_ML"},
                                                    {"MR", &BrainText::place_MR, "place_MR"}}};

bool is_dialled(const std::string& node) {
    return std::any_of(dialled_nodes.begin(), dialled_nodes.end(),
                       [&](const auto& entry) { return entry.name == node; });
}

std::optional<Fault> append_nodes(const std::vector<NodeText>& nodes, BrainGraph& graph) {
    NodeId next = 0;
    for (const Node& node : graph.nodes) next = std::max(next, node.id + 1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        Node node = nodes[i].node;
        if (node.name.empty()) return Fault{fmt::format("node.{}", i + 1), message_of("node_without_name")};
        if (node.id < 0) node.id = next;
        next = std::max(next, node.id + 1);
        graph.nodes.push_back(node);
    }
    return std::nullopt;
}

std::optional<Fault> append_wires(const std::vector<WireText>& wires, BrainGraph& graph) {
    std::map<std::string, NodeId, std::less<>> ids;
    for (const Node& node : graph.nodes) ids.emplace(node.name, node.id);
    std::vector<std::string_view> names;
    for (const auto& [name, id] : ids) names.push_back(name);
    for (std::size_t i = 0; i < wires.size(); ++i) {
        Wire wire = wires[i].wire;
        for (const bool start : {true, false}) {
            const std::string& end = start ? wires[i].from : wires[i].to;
            const auto found = ids.find(end);
            if (found == ids.end())
                return Fault{fmt::format("wire.{}{}", i + 1,
                                         end.empty() ? ""
                                         : start     ? ".from"
                                                     : ".to"),
                             end.empty() ? message_of("wire_without_names")
                                         : message_of("no_node_called", in_quotes(end)) + nearest_of(end, names)};
            (start ? wire.from : wire.to) = found->second;
        }
        graph.wires.push_back(wire);
    }
    return std::nullopt;
}

std::optional<Fault> put_dialled_nodes(const BrainText& text, BrainGraph& graph) {
    for (const DialledNode& entry : dialled_nodes) {
        if (!(text.*entry.place)) continue;
        Node* node = find_node(graph, entry.name);
        if (!node) return Fault{entry.key, message_of("node_of_key", entry.name)};
        node->place = text.*entry.place;
    }
    return std::nullopt;
}

void take_dialled_places(const BrainGraph& graph, BrainText& text) {
    for (const DialledNode& entry : dialled_nodes) text.*entry.place = find_node(graph, entry.name)->place;
}

// The dials of the four neurons with which the graph begins, canvas positions ignored; nullopt when it begins
// otherwise.
std::optional<FourNeurons> leading_four(const BrainGraph& placed) {
    const BrainGraph graph = without_places(placed);
    const FourNeurons dials = read_dials(graph);
    const BrainGraph four = make_graph(dials);
    if (graph.nodes.size() < four.nodes.size() || graph.wires.size() < four.wires.size()) return std::nullopt;
    const bool same = std::equal(four.nodes.begin(), four.nodes.end(), graph.nodes.begin()) &&
                      std::equal(four.wires.begin(), four.wires.end(), graph.wires.begin());
    return same ? std::optional(dials) : std::nullopt;
}

// The dials other than 0; LL when all are 0, because a text without dials has no four neurons.
std::vector<Dial> dials_to_write(const FourNeurons& dials) {
    std::vector<Dial> given;
    for (const Dial dial : all_dials)
        if (at(dials, dial) != 0) given.push_back(dial);
    if (given.empty()) given.push_back(Dial::LL);
    return given;
}

}  // namespace

std::optional<Fault> to_graph(const BrainText& text, BrainGraph& graph) {
    const bool declared = std::any_of(text.nodes.begin(), text.nodes.end(),
                                      [](const NodeText& entry) { return is_dialled(entry.node.name); });
    graph = !text.given.empty() && !declared ? make_graph(text.dials) : BrainGraph{};
    if (auto fault = append_nodes(text.nodes, graph)) return fault;
    if (auto fault = append_wires(text.wires, graph)) return fault;
    if (auto fault = put_dialled_nodes(text, graph)) return fault;
    if (!declared) return std::nullopt;
    for (const Dial dial : text.given) {
        turn(graph, dial, at(text.dials, dial));
        if (at(read_dials(graph), dial) != at(text.dials, dial))
            return Fault{std::string(name(dial)), message_of("nodes_of_dial")};
    }
    return std::nullopt;
}

BrainText to_text(const BrainGraph& graph) {
    BrainText text;
    if (is_four_neurons(graph)) {
        text.dials = read_dials(graph);
        text.given = dials_to_write(text.dials);
        take_dialled_places(graph, text);
        return text;
    }
    const std::optional<FourNeurons> four = leading_four(graph);
    if (four) {
        text.dials = *four;
        text.given = dials_to_write(*four);
        take_dialled_places(graph, text);
    }
    NodeId next = 0;
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
        NodeText entry{graph.nodes[i]};
        if (entry.node.id == next) entry.node.id = -1;
        next = std::max(next, graph.nodes[i].id + 1);
        if (!four || i >= 4) text.nodes.push_back(entry);
    }
    for (std::size_t i = four ? 4 : 0; i < graph.wires.size(); ++i) {
        const Wire& wire = graph.wires[i];
        const Node* from = find_node(graph, wire.from);
        const Node* to = find_node(graph, wire.to);
        text.wires.push_back({from ? from->name : "", to ? to->name : "", wire});
    }
    return text;
}

}  // namespace braitenlab
