// The wiring diagram and the paths of a run as SVG files.
#include <sstream>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/reports/axes.h"
#include "app/reports/brain_drawing.h"
#include "app/reports/paths_file.h"
#include "core/scene/scene_file.h"
#include "core/session/session.h"
#include "tests/folder.h"
#include "tests/languages.h"
#include "tests/well_formed.h"

namespace braitenlab::tests::drawings_test {
namespace {

Session shipped(const char* name) {
    auto scene = load_scene(find_shipped(name)->string());
    EXPECT_TRUE(scene);
    auto session = Session::open(*scene, 1);
    EXPECT_TRUE(session);
    return std::move(*session);
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(PathsFile, HasAPathANameAndALegendRowForEachOfAFewVehicles) {
    const Session session = shipped("moth-and-hunter");
    const std::string svg = paths_file(session.recording(), 0, 600, "Moths & <hunter>", speaking("en"));
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_NE(svg.find("Moths &amp; &lt;hunter&gt;"), std::string::npos);
    const std::size_t vehicles = session.snapshot().vehicles.size();
    EXPECT_EQ(count(svg, "stroke-linejoin"), vehicles);
    EXPECT_EQ(count(svg, ">hunter</text>"), 3U) << "at its path, below that its outline, and in the legend";
    EXPECT_NE(svg.find("0.0 s to 10.0 s"), std::string::npos);
    EXPECT_NE(svg.find("2 m</text>"), std::string::npos) << "the scale bar";
    EXPECT_NE(svg.find(">lantern</text>"), std::string::npos);
    EXPECT_EQ(svg.find("<image"), std::string::npos);
}

TEST(PathsFile, HasARowForEachKindOfManyVehicles) {
    const Session session = shipped("predator-prey");
    const std::string svg = paths_file(session.recording(), 0, 120, "hunt", speaking("de"));
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_EQ(count(svg, "stroke-linejoin"), session.snapshot().vehicles.size());
    EXPECT_EQ(count(svg, "stroke-width=\"3\"/>"), 3U) << "two kinds in the legend, and the wall";
    EXPECT_NE(svg.find("0,0 s bis 2,0 s"), std::string::npos);
}

TEST(PathsFile, BeginsAndEndsAtItsTicks) {
    Session session = shipped("3a-love");
    for (int i = 0; i < 300; ++i) session.step();
    const std::string early = paths_file(session.recording(), 0, 120, "a", speaking("en"));
    const std::string late = paths_file(session.recording(), 120, 240, "a", speaking("en"));
    const auto start_of = [](const std::string& svg) {
        return svg.substr(svg.find("<circle cx", svg.find("linejoin")), 40);
    };
    EXPECT_NE(start_of(early), start_of(late));
}

// Scenes with every form of arena: text only, no fault.
TEST(PathsFile, IsWellFormedForEveryShippedScene) {
    for (const auto& path : shipped_scenes()) {
        const auto scene = load_scene(path.string());
        ASSERT_TRUE(scene) << path;
        const auto session = Session::open(*scene, 1);
        ASSERT_TRUE(session) << path;
        EXPECT_EQ(xml_fault(paths_file(session->recording(), 0, 12, scene->title, speaking("es"))), "") << path;
    }
}

TEST(BrainFile, IsAFileOfItsOwnWithHeadingAndText) {
    const Session session = shipped("moth-and-hunter");
    const Kind& moth = session.scene().kinds.front();
    const std::string svg = brain_file(moth.brain, moth.sensors, "moth & co", speaking("en"));
    EXPECT_EQ(xml_fault(svg), "");
    EXPECT_TRUE(svg.starts_with("<?xml"));
    EXPECT_NE(svg.find("moth &amp; co</text>"), std::string::npos);
    for (const Sensor& sensor : moth.sensors) EXPECT_NE(svg.find(">" + sensor.name + "<"), std::string::npos);
    EXPECT_NE(svg.find("xmlns"), std::string::npos);
}

TEST(BrainFile, IsHeadedByTheSceneAndByTheKindWhereThereAreSeveral) {
    const Session one = shipped("2b-aggressor"), two = shipped("moth-and-hunter");
    EXPECT_EQ(brain_heading(one.scene(), one.scene().kinds.front()), "Vehicle 2b: Aggressor");
    EXPECT_EQ(brain_heading(two.scene(), two.scene().kinds.front()), two.scene().title + ": moth");
}

TEST(BrainFile, IsWideEnoughForManySensors) {
    const Session session = shipped("moth-and-hunter");
    const Kind& moth = session.scene().kinds.front();
    const auto width = [](const std::string& svg) { return std::stof(svg.substr(svg.find("viewBox=\"0 0 ") + 13)); };
    EXPECT_FLOAT_EQ(width(brain_drawing(moth.brain, moth.sensors, speaking("en"))), 360)
        << "on the page of a lab record";
    EXPECT_GT(width(brain_file(moth.brain, moth.sensors, "", speaking("en"))), 1.5f * 8 * 90);
}

TEST(BrainFile, AnOutlineIsATextOfItsOwnBelowItsText) {
    const Session session = shipped("2b-aggressor");
    const Kind& kind = session.scene().kinds.front();
    const std::string svg = brain_file(kind.brain, kind.sensors, "", speaking("en"));
    EXPECT_EQ(svg.find("paint-order"), svg.npos) << "LibreOffice and CairoSVG ignore it";
    const std::size_t outline = svg.find("stroke=\"#fff\" stroke-width=\"3\" aria-hidden=\"true\">1.50</text>");
    ASSERT_NE(outline, svg.npos) << svg;
    EXPECT_NE(svg.find("fill=\"#1c1c1a\">1.50</text>", outline), svg.npos);
}

namespace {

// The rooms of the texts that have an outline.
std::vector<LabelBox> outlined_boxes(const std::string& svg) {
    std::vector<LabelBox> boxes;
    for (std::size_t at = 0; (at = svg.find("aria-hidden", at)) != svg.npos; ++at) {
        const std::string text = svg.substr(svg.rfind("<text", at), svg.find("</text>", at) - svg.rfind("<text", at));
        const auto value = [&](const std::string& key) {
            const std::size_t from = text.find(" " + key + "=\"") + key.size() + 3;
            return text.substr(from, text.find('"', from) - from);
        };
        boxes.push_back(label_box(std::stof(value("x")), std::stof(value("y")), value("text-anchor"),
                                  text.substr(text.rfind('>') + 1)));
    }
    return boxes;
}

}  // namespace

TEST(BrainFile, WeightsDoNotOverlap) {
    std::size_t labels = 0;
    for (const auto& path : shipped_scenes()) {
        const auto scene = load_scene(path.string());
        ASSERT_TRUE(scene) << path;
        for (const Kind& kind : scene->kinds) {
            const auto boxes = outlined_boxes(brain_file(kind.brain, kind.sensors, "", speaking("en")));
            labels += boxes.size();
            for (std::size_t i = 0; i < boxes.size(); ++i)
                EXPECT_TRUE(is_free(boxes[i], {boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(i)}))
                    << path << " " << kind.name << " " << i;
        }
    }
    EXPECT_GT(labels, 50U);
}

TEST(PathsFile, NamesDoNotOverlap) {
    const Session session = shipped("3a-love");
    auto scene = session.scene();
    scene.starts.resize(6, scene.starts.front());
    for (std::size_t i = 0; i < scene.starts.size(); ++i) {
        scene.starts[i].name = "vehicle_" + std::to_string(i + 1);
        scene.starts[i].y = 0.3f * static_cast<float>(i);
    }
    const auto near = Session::open(scene, 1);
    ASSERT_TRUE(near) << near.error().text();
    const auto boxes = outlined_boxes(paths_file(near->recording(), 0, 6, "", speaking("en")));
    ASSERT_EQ(boxes.size(), 6U);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        EXPECT_TRUE(is_free(boxes[i], {boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(i)})) << i;
}

TEST(PathsFile, ANameKeepsClearOfThePathsWhereThereIsRoom) {
    for (const char* name : {"3a-love", "2b-aggressor", "moth-and-hunter", "3b-explorer"}) {
        const Session session = shipped(name);
        const std::string svg = paths_file(session.recording(), 0, 900, "", speaking("en"));
        std::vector<maths::vec2> points;
        for (std::size_t at = 0; (at = svg.find("stroke-linejoin", at)) != svg.npos; ++at) {
            std::istringstream data(svg.substr(svg.rfind("d=\"M", at) + 4));
            for (maths::vec2 p{}; data >> p.x >> p.y; data.get()) points.push_back(p);
        }
        ASSERT_GT(points.size(), 50U) << name;
        for (const LabelBox& box : outlined_boxes(svg))
            for (const maths::vec2 p : points)
                EXPECT_FALSE(p.x > box.left && p.x < box.right && p.y > box.top && p.y < box.bottom)
                    << name << " " << p.x << " " << p.y;
    }
}

TEST(BrainFile, WiresAndBiasesAreAsInTheWindow) {
    const Session session = shipped("2b-aggressor");
    const Kind& kind = session.scene().kinds.front();
    BrainGraph brain = kind.brain;
    for (Wire& wire : brain.wires) wire.weight = -1;
    for (Node& node : brain.nodes) node.bias = node.kind == NodeKind::motor ? 0.5f : 0;
    for (const Language& language : shipped_languages()) {
        const Strings& strings = speaking(language.code);
        const std::string svg = brain_file(brain, kind.sensors, "", strings);
        EXPECT_NE(svg.find("stroke=\"#0072b2\""), svg.npos) << "blue inhibits";
        EXPECT_EQ(svg.find("#b3261e"), svg.npos) << "red is a fault";
        EXPECT_EQ(strings("report.bias"), strings("lecture.bias")) << language.code;
    }
}

// What a browser and Inkscape draw is tried with librsvg where it is installed.
TEST(PlotFrame, TicksOfCellsAreAtTheirMiddlesAndOnlyWhereThereIsACell) {
    PlotFrame frame{400, 400, {0, 5, 1}, {0, 5, 1}, 50};
    frame.x.cells = {0, 1, 3, 5};  // cells of 100 px
    EXPECT_EQ(frame.x_of(0), 50);
    EXPECT_EQ(frame.x_of(3), 250);
    EXPECT_EQ(frame.x_of(5), 350);
    const std::string svg = frame_svg(frame, "x", "y", speaking("en"));
    EXPECT_NE(svg.find("M250.0 400"), std::string::npos);
    EXPECT_EQ(count(svg, ">2</text>"), 1U) << "on the other axis only";
}

TEST(PathsFile, IsDrawnByLibrsvg) {
    if (std::system("rsvg-convert --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "rsvg-convert is not installed";
    const Folder folder;
    const Session session = shipped("moth-and-hunter");
    put_text(folder / "a.svg", paths_file(session.recording(), 0, 600, "a", speaking("en")));
    const std::string line = "rsvg-convert " + (folder / "a.svg").string() + " -o " + (folder / "a.png").string();
    EXPECT_EQ(std::system(line.c_str()), 0);
    EXPECT_GT(fs::file_size(folder / "a.png"), 10000U);
}

}  // namespace
}  // namespace braitenlab::tests::drawings_test
