// The wiring diagram and the paths of a run as SVG files.
#include <gtest/gtest.h>

#include "app/files/data.h"
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
    EXPECT_EQ(count(svg, ">hunter</text>"), 2U) << "at its path and in the legend";
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

// What a browser and Inkscape draw is tried with librsvg where it is installed.
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
