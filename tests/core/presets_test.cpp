#include "core/brain/presets.h"

#include <string>

#include <gtest/gtest.h>

#include "core/brain/brain.h"
#include "core/brain/four_neurons.h"

namespace braitenlab::tests::presets_test {
namespace {

// An aggressor with two feelers, one of them wired through a neuron, and a neuron that an eye feeds.
BrainGraph with_feelers() {
    BrainGraph brain = make_graph({.LR = 1, .RL = 1});
    brain.nodes.push_back({.id = 4, .kind = NodeKind::sensor, .name = "QL"});
    brain.nodes.push_back({.id = 5, .kind = NodeKind::sensor, .name = "QR"});
    brain.nodes.push_back({.id = 6, .kind = NodeKind::neuron, .name = "N1"});
    brain.nodes.push_back({.id = 7, .kind = NodeKind::neuron, .name = "N2"});
    brain.wires.push_back({.from = 4, .to = 3, .weight = -0.5f});
    brain.wires.push_back({.from = 5, .to = 6, .weight = 0.7f});
    brain.wires.push_back({.from = 6, .to = 2, .weight = -0.6f});
    brain.wires.push_back({.from = 0, .to = 7, .weight = 0.3f});
    brain.wires.push_back({.from = 7, .to = 2, .weight = 0.2f});
    return brain;
}

float between(const BrainGraph& brain, const char* from, const char* to) {
    const Wire* wire = find_wire(brain, find_node(brain, std::string(from))->id, find_node(brain, std::string(to))->id);
    return wire ? wire->weight : 0;
}

TEST(Presets, GraftReplacesTheWiresOfTheEyesAndKeepsThoseOfTheFeelers) {
    const BrainGraph& coward = find_preset("2a-coward")->brain;
    const BrainGraph made = graft(with_feelers(), coward);
    EXPECT_EQ(read_dials(made), read_dials(coward));
    EXPECT_FLOAT_EQ(between(made, "QL", "MR"), -0.5f);
    EXPECT_FLOAT_EQ(between(made, "QR", "N1"), 0.7f);
    EXPECT_FLOAT_EQ(between(made, "N1", "ML"), -0.6f);
    EXPECT_EQ(find_node(made, std::string("N2")), nullptr) << "a neuron fed by an eye is removed";
    BrainGraph both = with_feelers();  // a feeler feeds N2 too
    both.wires.push_back({.from = 4, .to = 7, .weight = 1});
    EXPECT_EQ(find_node(graft(both, coward), std::string("N2")), nullptr)
        << "a neuron that an eye also feeds is removed";
    BrainGraph more = with_feelers();
    more.nodes.push_back({.id = 8, .kind = NodeKind::sensor, .name = "EN"});
    EXPECT_EQ(kept_by_graft(more, coward), (std::vector<std::string>{"QL", "QR"}))
        << "a sensor without wires is not listed";
}

TEST(Presets, GraftEqualsThePresetWithoutKeptNodesAndIsIdempotent) {
    for (const Preset& preset : presets()) {
        EXPECT_EQ(graft(make_graph({.LL = 1}), preset.brain), preset.brain) << preset.name;
        const BrainGraph once = graft(with_feelers(), preset.brain);
        const auto brain = compile(once, std::vector<std::string>{"SL", "SR", "QL", "QR"});
        EXPECT_TRUE(brain) << preset.name;
        EXPECT_EQ(graft(once, preset.brain), once) << preset.name;
    }
}

TEST(Presets, GraftKeepsPositionsUnlessThePresetHasNeurons) {
    BrainGraph brain = with_feelers(), preset = make_graph({.LL = 1});
    find_node(brain, "SL")->place = {1, 2};
    find_node(brain, "QR")->place = {3, 4};
    BrainGraph made = graft(brain, preset);
    EXPECT_EQ(find_node(made, "SL")->place, (maths::vec2{1, 2}));
    EXPECT_EQ(find_node(made, "QR")->place, (maths::vec2{3, 4}));
    preset.nodes.push_back({.id = 4, .kind = NodeKind::neuron, .name = "X"});
    made = graft(brain, preset);
    EXPECT_EQ(made, without_places(made));
}

TEST(Presets, GraftRenamesAKeptNodeWhoseNameIsUsed) {
    BrainGraph preset = make_graph({.LL = 1});
    preset.nodes.push_back({.id = 4, .kind = NodeKind::neuron, .name = "N1"});
    const BrainGraph made = graft(with_feelers(), preset);
    ASSERT_TRUE(find_node(made, std::string("N1-2")));
    EXPECT_FLOAT_EQ(between(made, "QR", "N1-2"), 0.7f);
}

}  // namespace
}  // namespace braitenlab::tests::presets_test
