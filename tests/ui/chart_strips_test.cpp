// The strips of the chart card: choosing signals and removing them.
#include "ui/panels/charts/chart_strips.h"

#include <algorithm>

#include "chart_desk.h"

namespace braitenlab::tests::chart_strips_test {

using namespace ui;

namespace {

using Names = std::vector<std::string>;

// The tab "All".
struct ChartStrips : testing::Test {
    ChartDesk desk{800};
    ChartStrips() {
        desk.panels.charts.shown = Chart::all;
        desk.frame(2);
    }
    bool writes(std::string_view words) const {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& w) { return w.words == words; });
    }
    void show_chosen() {
        desk.panels.charts.shown = Chart::chosen;
        desk.frame(2);
    }
};

}  // namespace

TEST_F(ChartStrips, ThePlusOfARowChoosesItsSignalAndASecondClickRemovesIt) {
    desk.click("charts.add.ML");
    desk.rest();
    desk.click("charts.add.SL");
    EXPECT_EQ(desk.panels.charts.strips, (Names{"ML", "SL"})) << "in the order of the clicks";
    EXPECT_EQ(desk.panels.charts.shown, Chart::all) << "more can be chosen";
    desk.rest();
    desk.click("charts.add.ML");
    EXPECT_EQ(desk.panels.charts.strips, Names{"SL"});
}

TEST_F(ChartStrips, OfChosenSignalsAreBelowEachOther) {
    desk.panels.charts.strips = {"MR", "SL"};
    show_chosen();
    const Rect first = desk.where("charts.strip.MR"), second = desk.where("charts.strip.SL");
    EXPECT_LE(first.y + first.h, second.y);
    EXPECT_FLOAT_EQ(first.x, second.x);
    EXPECT_GT(first.w, 0.6f * desk.where("charts.picture").w) << "one column";
    EXPECT_FALSE(desk.anchors.find("charts.strip.ML"));
}

TEST_F(ChartStrips, TheCrossRemovesASignal) {
    desk.panels.charts.strips = {"MR", "SL"};
    show_chosen();
    desk.click("charts.remove.MR");
    EXPECT_EQ(desk.panels.charts.strips, Names{"SL"});
    EXPECT_FALSE(desk.anchors.find("charts.strip.MR"));
    EXPECT_TRUE(desk.anchors.find("charts.strip.SL"));
}

TEST_F(ChartStrips, ALineTellsHowToChooseWhileNoneIsChosen) {
    show_chosen();
    EXPECT_TRUE(writes(desk.strings("charts.choose_how")));
    desk.panels.charts.strips = {"SL"};
    desk.frame(2);
    EXPECT_FALSE(writes(desk.strings("charts.choose_how")));
}

TEST_F(ChartStrips, OfARemovedSensorDisappears) {
    desk.panels.charts.strips = {"SL", "MR"};
    show_chosen();
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds[0].sensors.erase(scene->kinds[0].sensors.begin());
    desk.now.scene = scene;
    for (std::uint64_t tick = 123; tick <= 180; tick += 3) desk.now.tick = tick, desk.frame();
    EXPECT_FALSE(desk.anchors.find("charts.strip.SL"));
    EXPECT_TRUE(desk.anchors.find("charts.strip.MR"));
    desk.view.settings.selection.vehicle = no_vehicle;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("charts.strip.MR"));
    EXPECT_TRUE(writes(desk.strings("charts.choose_how")));
}

TEST_F(ChartStrips, OfManyChosenSignalsStayWithinTheCard) {
    for (const Signal& signal : all_signals(desk.panels.charts.history)) choose_strip(desk.panels, signal.name);
    ASSERT_GT(desk.panels.charts.strips.size(), 8u);
    show_chosen();
    const Rect picture = desk.where("charts.picture");
    std::size_t shown = 0;
    for (const std::string& name : desk.panels.charts.strips) {
        const Rect* strip = desk.anchors.find("charts.strip." + name);
        if (!strip) continue;
        ++shown;
        EXPECT_LE(strip->y + strip->h, picture.y + picture.h) << name;
    }
    EXPECT_TRUE(shown == desk.panels.charts.strips.size() ||
                writes(fill(desk.strings("info.more"), {std::to_string(desk.panels.charts.strips.size() - shown)})));
}

TEST(ChooseStrip, AddsANameOnceAndAtMostThirtyTwo) {
    PanelState state;
    choose_strip(state, "SL");
    choose_strip(state, "SL");
    EXPECT_EQ(state.charts.strips, Names{"SL"});
    for (int i = 0; i < 40; ++i) choose_strip(state, "N" + std::to_string(i));
    EXPECT_EQ(state.charts.strips.size(), most_strips);
}

}  // namespace braitenlab::tests::chart_strips_test
