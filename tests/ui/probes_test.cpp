// Probes of the diagram: the last seconds of a node beside it.
#include <gtest/gtest.h>

#include "desk.h"
#include "ui/panels/charts/chart_data.h"

namespace braitenlab::tests::probes_test {

using namespace ui;
namespace {

bool overlap(Rect a, Rect b) { return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h; }

struct Probes : testing::Test {
    Desk desk{1280, 800, 1, true};
    Probes() {
        desk.now = shipped_scene("5-logic");
        desk.view.settings.selection.vehicle = 0;
        for (std::uint64_t tick = 0; tick <= 120; tick += 3) {
            desk.now.tick = tick, desk.now.seconds = static_cast<double>(tick) / 60;
            desk.now.sensed[0] = tick >= 60 ? 0.75f : 0.0f;
            desk.frame();
        }
        desk.view.mode = Mode::wiring;
        desk.frame(3);
    }
    bool writes_in(Rect area, std::string_view words) const {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& w) { return w.words == words && area.contains(w.rect.x, w.rect.y); });
    }
};

TEST_F(Probes, TheKeyShowsAndRemovesTheSignalOfTheSelectedNode) {
    EXPECT_FALSE(desk.anchors.find("probe.SL"));
    desk.click("node.SL");
    desk.key({'P'});
    desk.frame(3);
    EXPECT_TRUE(writes_in(desk.where("probe.SL"), "0.75")) << "the reading now";
    EXPECT_FALSE(desk.anchors.find("probe.SR"));
    EXPECT_TRUE(desk.edits().empty()) << "the brain is not changed";
    desk.key({'P'});
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("probe.SL"));
}

TEST_F(Probes, OfAllNodesCoverNoNodeAndNoOtherProbe) {
    for (const Node& node : desk.now.brains[0]->nodes) desk.panels.canvas.probes.insert(node.name);
    desk.frame(2);
    std::vector<Rect> taken;
    for (const Node& node : desk.now.brains[0]->nodes) taken.push_back(desk.where("node." + node.name));
    std::size_t covered = 0;
    for (const Node& node : desk.now.brains[0]->nodes) {
        const Rect probe = desk.where("probe." + node.name);
        covered += std::any_of(taken.begin(), taken.end(), [&](Rect r) { return overlap(r, probe); });
        taken.push_back(probe);
    }
    EXPECT_EQ(covered, 0u);
}

// Where the nodes are drawn smaller.
TEST(ProbesInALowWindow, CoverNoNode) {
    for (const float scale : {1.0f, 2.0f}) {
        Desk desk{1024 * scale, 768 * scale, scale, true};
        desk.now = shipped_scene("5-logic");
        desk.view.settings.selection.vehicle = 0;
        desk.frame(2);
        desk.view.mode = Mode::wiring;
        for (const Node& node : desk.now.brains[0]->nodes) desk.panels.canvas.probes.insert(node.name);
        desk.frame(4);
        for (const Node& node : desk.now.brains[0]->nodes)
            for (const Node& other : desk.now.brains[0]->nodes)
                EXPECT_FALSE(overlap(desk.where("probe." + node.name), desk.where("node." + other.name)))
                    << node.name << " over " << other.name << " at scale " << scale;
    }
}

TEST_F(Probes, TellNothingOfAHiddenBrain) {
    desk.panels.canvas.probes = {"SL"};
    desk.view.settings.revealed.brain = false;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("probe.SL"));
}

TEST(Signal, IsFoundByTheNameOfASensorAMotorOrANeuron) {
    History history;
    history.sensors = {"SL", "SR"};
    history.brain_values = {"N1", "SL>N1"};
    History::Signals sample{1.0, {0.25f, 0.5f}, {-0.5f, 0.75f}, {2.0f, -0.125f}};
    history.signals = {sample};
    EXPECT_EQ(all_signals(history).size(), 6u);
    EXPECT_EQ(signal_named(history, "SR")->value(sample), 0.5f);
    EXPECT_EQ(signal_named(history, "MR")->value(sample), 0.75f);
    EXPECT_EQ(signal_named(history, "N1")->value(sample), 2.0f);
    EXPECT_EQ(signal_named(history, "SL>N1")->value(sample), -0.125f);
    EXPECT_FALSE(signal_named(history, "N2"));
    EXPECT_EQ(range_of(history, *signal_named(history, "N1")).high, 2.0f);
    EXPECT_EQ(range_of(history, *signal_named(history, "SL")).low, 0.0f);
    EXPECT_EQ(range_of(history, *signal_named(history, "SL>N1")).low, -1.0f);
}

}  // namespace
}  // namespace braitenlab::tests::probes_test
