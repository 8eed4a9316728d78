// The large charts: opening, sorting by a click, and export as text.
#include <algorithm>

#include "desk.h"
#include "ui/panels/charts/chart_data.h"

namespace braitenlab::tests::chart_card_test {

using namespace ui;

namespace {

Snapshot unequal() {
    Snapshot now = snapshot(2);  // six vehicles: kinds 0 1 1 0 1 1
    const float energies[]{0.5f, 0.9f, 0.1f, 0.7f, 0.1f, 0.3f};
    for (std::size_t i = 0; i < 6; ++i) now.vehicles[i].energy = energies[i];
    return now;
}

std::vector<std::size_t> sorted(EnergyOrder order) {
    std::vector<std::size_t> rows;
    sort(unequal(), order, rows);
    return rows;
}

// A desk with open charts and ten recorded seconds.
class ChartDesk : public Desk {
public:
    explicit ChartDesk(float width = 1280, float height = 800, bool fonts = false) : Desk(width, height, 1, fonts) {
        now = unequal();
        for (std::uint64_t tick = 0; tick <= 600; tick += 3)
            now.tick = tick, now.seconds = static_cast<double>(tick) / 60, frame();
        key({'C'});
        frame(4);
    }
};

ExportRequest exported(const Desk& desk) {
    for (const Request& request : desk.all)
        if (const auto* found = std::get_if<ExportRequest>(&request)) return *found;
    throw std::runtime_error("nothing was exported");
}

}  // namespace

TEST(ChartData, EnergyOrderSortsByNumberEnergyAndKindInBothDirections) {
    using By = EnergyOrder::By;
    using Rows = std::vector<std::size_t>;
    EXPECT_EQ(sorted({By::number, false}), (Rows{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(sorted({By::number, true}), (Rows{5, 4, 3, 2, 1, 0}));
    EXPECT_EQ(sorted({By::energy, true}), (Rows{1, 3, 0, 5, 2, 4}));
    EXPECT_EQ(sorted({By::energy, false}), (Rows{2, 4, 5, 0, 3, 1}));
    EXPECT_EQ(sorted({By::kind, false}), (Rows{0, 3, 1, 2, 4, 5}));
}

TEST(ChartCard, OpensByKeyOrButtonAndClosesByItsHeading) {
    ChartDesk desk;
    EXPECT_TRUE(desk.anchors.find("card.charts"));
    desk.click("card.charts.fold", 0, 0.2f);
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.charts"));
    desk.panels.card(Card::information).folded = false;
    desk.frame(2);
    desk.click("button.charts");
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("card.charts"));
}

TEST(ChartCard, ItsTabsHaveOneSizeOfType) {
    for (const std::string& language : shipped_codes()) {
        ChartDesk desk(1280, 800, true);
        desk.strings = speaking(language);
        desk.frame(3);
        std::vector<float> heights;
        for (const Written& each : desk.written)
            for (const char* key : {"charts.signals", "charts.all", "charts.population", "charts.energy"})
                if (each.words == desk.strings(key) && each.rect.y < desk.where("card.charts").y + 70)
                    heights.push_back(each.rect.h);
        ASSERT_GE(heights.size(), 4U) << language;
        for (const float height : heights) EXPECT_EQ(height, heights.front()) << language;
    }
}

TEST(ChartCard, LiesBelowTheScene) {
    ChartDesk desk(1024, 768);
    const Rect card = desk.where("card.charts"), scene = desk.where("viewport");
    EXPECT_GE(card.y, scene.y + scene.h);
    EXPECT_GE(scene.h, 200);
    EXPECT_FLOAT_EQ(card.x, scene.x);
    EXPECT_FLOAT_EQ(card.w, scene.w);
}

TEST(ChartCard, KeepsTheToolsAboveTheScene) {
    Desk desk;
    const CameraView camera_view =
        look(Camera{}, desk.now.scene->arena, nullptr, {0, 0, 1280, 800}, {300, 60, 600, 600});
    desk.view.camera_view = &camera_view;
    desk.panels.charts.open = true;
    desk.frame(3);
    const Rect tools = desk.where("tool.hand"), scene = desk.where("viewport");
    EXPECT_LE(tools.y + tools.h, scene.y) << "the tools do not cover a vehicle";
}

TEST(ChartCard, ShowsOneTooltipAtATime) {
    Desk desk(1280, 800, 1, true);
    desk.panels.charts.open = true;
    desk.frame(3);
    desk.point("charts.csv");
    desk.frame(60);
    bool told = false;
    for (const Written& w : desk.written) {
        told |= w.words == desk.strings("tooltip.csv");
        EXPECT_NE(w.words, desk.strings("card.fold"));
    }
    EXPECT_TRUE(told);
}

TEST(ChartCard, KeepsTheNumbersOfTwoChartsApart) {
    Desk desk(1280, 800, 1, true);
    desk.panels.charts.open = true;
    for (std::uint64_t tick = 0; tick <= 600; tick += 3) desk.now.tick = tick, desk.frame();
    std::vector<Rect> numbers;
    for (const Written& w : desk.written)
        if (w.words == "0.0" || w.words == "1.0")
            if (desk.layout.charts.contains(w.rect.x, w.rect.y)) numbers.push_back(w.rect);
    ASSERT_GE(numbers.size(), 4u);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_GE(std::abs(numbers[i].y - numbers[j].y), numbers[i].h - 0.5f);
}

TEST(ChartCard, KeepsTheWordsOfItsTabsApartInANarrowWindow) {
    for (const Language& language : shipped_languages()) {
        Desk desk(1024, 768, 1, true);
        desk.strings = speaking(language.code);
        desk.panels.charts.open = true;
        desk.frame(3);
        std::vector<Rect> words;
        for (int tab = 1; tab <= 6; ++tab) {
            const Rect r = desk.where("charts.tab." + std::to_string(tab));
            for (const Written& w : desk.written)
                if (r.contains(w.rect.x + w.rect.w / 2, w.rect.y + w.rect.h / 2)) words.push_back(w.rect);
        }
        ASSERT_EQ(words.size(), 6u);
        for (std::size_t i = 1; i < words.size(); ++i)
            EXPECT_GE(words[i].x - (words[i - 1].x + words[i - 1].w), 6) << language.code << ", tab " << i + 1;
    }
}

TEST(ChartCard, ExportsTheShownValues) {
    ChartDesk desk;
    const char* names[]{"signals", "signals", "signals", "population", "population", "energies"};
    const char* starts[]{"seconds,sensor_SL,", "seconds,sensor_SL,", "seconds,sensor_SL,",
                         "seconds,predators,", "seconds,predators,", "id,kind,"};
    for (int i = 0; i < 6; ++i) {
        if (i > 0) desk.click("charts.tab." + std::to_string(i + 1));
        desk.all.clear();
        desk.click("charts.csv");
        const ExportRequest file = exported(desk);
        EXPECT_EQ(file.name, names[i]);
        EXPECT_TRUE(file.text.starts_with(starts[i])) << i;
        EXPECT_GT(std::count(file.text.begin(), file.text.end(), '\n'), 5) << i;
    }
}

TEST(ChartCard, ShowsNeuronsAndLearnedWeightsByName) {
    Desk desk(1280, 800, 1, true);
    desk.now = shipped_scene("7-mnemotrix");
    desk.panels.charts.open = true;
    desk.panels.charts.shown = Chart::all;
    for (std::uint64_t tick = 0; tick <= 60; tick += 3) desk.now.tick = tick, desk.frame();
    const auto writes_in_card = [&](const std::string& words) {
        return std::any_of(desk.written.begin(), desk.written.end(), [&](const Written& w) {
            return w.words == words && desk.layout.charts.contains(w.rect.x, w.rect.y);
        });
    };
    for (const Node& node : desk.now.brains[0]->nodes) {
        if (node.kind != NodeKind::neuron) continue;
        EXPECT_TRUE(writes_in_card(node.name)) << node.name;
    }
    ASSERT_FALSE(desk.panels.charts.history.brain_values.empty());
    EXPECT_NE(desk.panels.charts.history.brain_values.back().find('>'), std::string::npos) << "a learned weight";
    EXPECT_TRUE(writes_in_card("0.00"));
}

TEST(ChartCard, ShowsEverySensorAndBothWheelsAsStrips) {
    Desk desk(1280, 800, 1, true);
    desk.now = shipped_scene("3c-values");
    desk.view.settings.selection.vehicle = 0;
    desk.panels.charts.open = true;
    desk.panels.charts.shown = Chart::all;
    for (std::uint64_t tick = 0; tick <= 60; tick += 3) desk.now.tick = tick, desk.frame();
    for (const Sensor& sensor : desk.now.scene->kinds[0].sensors) {
        const Rect strip = desk.where("charts.strip." + sensor.name);
        EXPECT_LE(strip.y + strip.h, desk.layout.charts.y + desk.layout.charts.h) << sensor.name;
    }
    EXPECT_LT(desk.where("charts.strip.ML").x, desk.where("charts.strip.MR").x);
}

TEST(ChartCard, SelectsTheVehicleOfTheClickedBarInAnyOrder) {
    ChartDesk desk;
    desk.click("charts.tab.6");
    desk.frame(2);
    const auto first_bar = [&] {
        desk.all.clear();
        desk.rest();
        const Rect r = desk.where("charts.bars");
        desk.point(r.x + 4, r.y + r.h / 2);
        desk.frame(2);
        desk.button(0, true);
        desk.frame();
        desk.button(0, false);
        desk.frame();
        for (const Request& request : desk.all)
            if (const auto* select = std::get_if<SelectRequest>(&request)) return select->vehicle;
        return no_vehicle;
    };
    EXPECT_EQ(first_bar(), 0);
    desk.click("charts.sort.energy");
    EXPECT_EQ(first_bar(), 1) << "the highest energy first";
    desk.rest();
    desk.click("charts.sort.energy");
    EXPECT_EQ(first_bar(), 2) << "the lowest energy first";
}

TEST(ChartCard, ShowsTheValueUnderThePointer) {
    ChartDesk desk(1280, 800, true);
    desk.click("charts.tab.5");
    desk.frame(2);
    const Rect r = desk.where("charts.picture");
    const auto shapes = [&] {
        desk.frame(2);
        int vertices = 0;
        const ImDrawData* data = ImGui::GetDrawData();
        for (int i = 0; i < data->CmdListsCount; ++i) vertices += data->CmdLists[i]->VtxBuffer.Size;
        return vertices;
    };
    desk.point(5, 5);
    const int without = shapes();
    desk.point(r.x + r.w / 2, r.y + r.h / 2);
    EXPECT_GT(shapes(), without + 40) << "a line and its text";
}

TEST(ChartCard, ShowsTheNumberOfBarsThatDoNotFit) {
    Desk desk(1280, 800, 1, true);
    desk.now = snapshot(200);
    desk.panels.charts.open = true;
    desk.panels.charts.shown = Chart::bars;
    desk.frame(4);
    const Rect bars = desk.where("charts.bars");
    int counts = 0;
    for (const Written& w : desk.written) {
        if (w.words.find(" more") == std::string::npos) continue;
        if (!desk.where("card.charts").contains(w.rect.x, w.rect.y)) continue;  // the small bars have text too
        ++counts;
        EXPECT_LE(w.rect.y + w.rect.h, bars.y) << "no bar covers it";
    }
    EXPECT_EQ(counts, 1);
}

}  // namespace braitenlab::tests::chart_card_test
