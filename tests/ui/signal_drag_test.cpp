// Dragging a signal to the chart card, and the row of a node's menu that shows it there.
#include "ui/panels/signal_drag.h"

#include <algorithm>

#include "chart_desk.h"

namespace braitenlab::tests::signal_drag_test {

using namespace ui;

namespace {

using Names = std::vector<std::string>;

struct SignalDrags : testing::Test {
    ChartDesk desk{1000};
    void hold(std::string_view from, std::string_view to) {
        const Rect a = desk.where(from), b = desk.where(to);
        desk.point(from);
        desk.frame(2);
        desk.button(0, true);
        desk.frame(2);
        for (int i = 1; i <= 4; ++i) {
            const float t = static_cast<float>(i) / 4;
            desk.point((a.x + a.w / 2) * (1 - t) + (b.x + b.w / 2) * t,
                       (a.y + a.h / 2) * (1 - t) + (b.y + b.h / 2) * t);
            desk.frame(2);
        }
    }
    void let_go() {
        desk.button(0, false);
        desk.frame(3);
    }
    void drag(std::string_view from, std::string_view to) { hold(from, to), let_go(); }
};

TEST_F(SignalDrags, FromTheBrainCardToTheChartShowsTheStripThere) {
    hold("lesion.SL", "card.charts");
    EXPECT_TRUE(desk.panels.charts.strips.empty()) << "not before the release";
    let_go();
    EXPECT_EQ(desk.panels.charts.strips, Names{"SL"});
    EXPECT_EQ(desk.panels.charts.shown, Chart::chosen);
    EXPECT_TRUE(desk.anchors.find("charts.strip.SL"));
    EXPECT_TRUE(desk.edits().empty()) << "no lesion";
}

TEST_F(SignalDrags, FromTheSensorCardShowTheSensor) {
    desk.panels.card(Card::sensors).folded = false;
    desk.frame(3);
    drag("sensor.SR", "card.charts");
    EXPECT_EQ(desk.panels.charts.strips, Names{"SR"});
}

TEST_F(SignalDrags, AreGivenUpByEsc) {
    hold("lesion.SL", "card.charts");
    desk.key({key::escape});
    desk.frame(2);
    const Rect card = desk.where("card.charts");
    desk.point(card.x + 40, card.y + 60);
    desk.frame(2);
    let_go();
    EXPECT_TRUE(desk.panels.charts.strips.empty());
    EXPECT_TRUE(desk.panels.charts.open) << "Esc did nothing else";
    drag("lesion.SL", "card.charts");
    EXPECT_EQ(desk.panels.charts.strips, Names{"SL"}) << "the next drag";
}

TEST_F(SignalDrags, OfAChosenStripGiveItThePlaceOfAnother) {
    desk.panels.charts.strips = {"SL", "SR", "ML", "MR"};
    desk.panels.charts.shown = Chart::chosen;
    desk.frame(3);
    drag("charts.name.SL", "charts.strip.ML");
    EXPECT_EQ(desk.panels.charts.strips, (Names{"SR", "ML", "SL", "MR"}));
    drag("charts.name.MR", "charts.strip.SR");
    EXPECT_EQ(desk.panels.charts.strips, (Names{"MR", "SR", "ML", "SL"}));
    drag("charts.name.MR", "viewport");
    EXPECT_EQ(desk.panels.charts.strips, (Names{"MR", "SR", "ML", "SL"})) << "outside of the chart";
}

TEST_F(SignalDrags, OutsideOfTheChartChooseNothing) {
    drag("lesion.SL", "viewport");
    EXPECT_TRUE(desk.panels.charts.strips.empty());
    EXPECT_TRUE(desk.panels.charts.drag.name.empty());
    EXPECT_EQ(desk.panels.charts.shown, Chart::signals);
}

TEST_F(SignalDrags, BeginWhenTheMouseMoves) {
    desk.panels.charts.shown = Chart::all;
    desk.frame(2);
    desk.point("charts.name.MR");
    desk.frame(2);
    const auto before = desk.written.size();
    desk.button(0, true);
    desk.frame(2);
    EXPECT_EQ(desk.written.size(), before) << "no name beside the pointer of a click";
    desk.point("charts.strip.MR");
    desk.frame(2);
    EXPECT_GT(desk.written.size(), before);
    let_go();
}

TEST_F(SignalDrags, OfANameGoToTheTab) {
    desk.panels.charts.shown = Chart::all;
    desk.frame(2);
    drag("charts.name.MR", "charts.strip.ML");
    EXPECT_TRUE(desk.panels.charts.strips.empty()) << "the same tab";
    desk.rest();
    drag("charts.name.MR", "charts.tab.3");
    EXPECT_EQ(desk.panels.charts.strips, Names{"MR"});
    EXPECT_EQ(desk.panels.charts.shown, Chart::chosen);
}

TEST_F(SignalDrags, OpenTheClosedChartByItsButton) {
    desk.panels.charts.open = false;
    desk.panels.card(Card::information).folded = false;
    desk.frame(3);
    drag("lesion.SL", "button.charts");
    EXPECT_TRUE(desk.panels.charts.open);
    EXPECT_EQ(desk.panels.charts.strips, Names{"SL"});
}

TEST_F(SignalDrags, OfANodeOfTheDiagramLeaveTheNodeWhereItIs) {
    desk.view.settings.watching = true;
    desk.frame(4);
    const Rect before = desk.where("node.MR");
    const auto names = [&] {
        return std::count_if(desk.written.begin(), desk.written.end(), [&](const Written& w) {
            return w.words == "MR" && desk.where("card.charts").contains(w.rect.x, w.rect.y);
        });
    };
    const auto without = names();
    hold("node.MR", "card.charts");
    EXPECT_EQ(names(), without + 1) << "beside the pointer";
    let_go();
    EXPECT_EQ(desk.panels.charts.strips, Names{"MR"});
    EXPECT_TRUE(desk.edits().empty()) << "the node is not moved";
    EXPECT_EQ(desk.where("node.MR"), before);
}

TEST_F(SignalDrags, TheMenuOfANodeShowsItsSignalInTheChart) {
    desk.panels.charts.open = false;
    desk.view.mode = Mode::wiring;
    desk.frame(4);
    desk.click("node.SL", 1);
    desk.click("menu.chart");
    desk.frame(2);
    EXPECT_EQ(desk.panels.charts.strips, Names{"SL"});
    EXPECT_TRUE(desk.panels.charts.open) << "after the diagram";
    ASSERT_TRUE(desk.last<NoticeRequest>());
    EXPECT_EQ(desk.last<NoticeRequest>()->key, "notice.on_chart");
    EXPECT_EQ(desk.last<NoticeRequest>()->words, "SL");
    EXPECT_TRUE(desk.edits().empty());
}

}  // namespace
}  // namespace braitenlab::tests::signal_drag_test
