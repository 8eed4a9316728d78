// Studies: the file, the runs, the table and its summary.
#include "core/insight/study.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/insight/study_table.h"
#include "tests/core/runs.h"
#include "tests/core/scenes.h"

namespace braitenlab::tests::study_test {
namespace {

namespace fs = std::filesystem;
using insight::Study;
using insight::StudyBase;
using insight::StudyMeasure;
using insight::StudyRow;

constexpr double never = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
const fs::path source = BRAITENLAB_SOURCE;

std::string file_text(const std::string& top, const std::string& value) {
    return "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\n" + top + "\n[[value]]\n" + value;
}
constexpr const char* weights =
    "name = \"weight\"\npaths = [\"kind.aggressor.brain.LR\", \"-kind.aggressor.brain.RL\"]\nlevels = [0.5, 1.5]\n";

std::shared_ptr<const StudyBase> base_of(const std::string& toml, const Scene& scene) {
    auto study = insight::parse_study(toml, "study.toml");
    EXPECT_TRUE(study) << study.error().text();
    auto base = StudyBase::create(std::move(*study), write_scene(scene), "scene.toml");
    EXPECT_TRUE(base) << base.error().text();
    return *base;
}
std::string problem(const std::string& toml) {
    const auto study = insight::parse_study(toml, "study.toml");
    return study ? "" : study.error().text();
}

TEST(StudyFile, ThatIsWrittenReadsAsItWas) {
    Study study{.title = "Title \"1\"", .story = "Why?", .scene = "here.toml", .vehicle = "it", .seconds = 12.5f};
    study.seeds = 7, study.first_seed = 42;
    study.values = {{"a, b", "°", {"kind.x.sensor.SL.angle", "-kind.x.sensor.SR.angle"}, {0.1, 45, -90}},
                    {"LL = RR", "", {"kind.x.brain.LL"}, {-2, 2}}};
    study.measure_words = {"touch", "closest"};
    study.axis = {"Angle (°)", ""};
    const std::string text = insight::write_study(study);
    const auto read = insight::parse_study(text, "study.toml");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(insight::write_study(*read), text);
    EXPECT_EQ(read->title, study.title);
    EXPECT_EQ(read->seconds, 12.5f);
    EXPECT_EQ(read->first_seed, 42u);
    EXPECT_EQ(read->axis.x, "Angle (°)");
    EXPECT_EQ(read->axis.y, "");
    ASSERT_EQ(read->values.size(), 2u);
    EXPECT_EQ(read->values[0].paths, study.values[0].paths);
    EXPECT_EQ(read->values[0].levels, study.values[0].levels);
    EXPECT_EQ(read->measures, (std::vector{StudyMeasure::time_to_touch, StudyMeasure::closest}));
}

TEST(Study, RunsAreThoseOfTheSceneWithTheLevelsAndTheSeed) {
    const Scene scene = shipped_scene("2b-aggressor");
    const auto base = base_of(
        file_text("seconds = 20\nseeds = 3\nfirst_seed = 5\nmeasures = [\"final\", \"contacts\"]", weights), scene);
    ASSERT_EQ(base->study().runs(), 6u);
    Scene other = scene;
    FourNeurons dials = read_dials(scene.kinds[0].brain);
    dials.LR = 1.5f, dials.RL = -1.5f;
    other.kinds[0].brain = make_graph(dials);
    World world = make(other, 6);  // run 4: the second level, the second seed
    EXPECT_EQ(base->world(4)->hash(), world.hash());
    const Snapshot end = after(world, 20);
    const StudyRow row = insight::run_of(base, 4);
    ASSERT_EQ(row.size(), 2u);
    const auto& lamp = end.sources[0];
    const auto& vehicle = end.vehicles[0];
    EXPECT_NEAR(row[0], std::hypot(lamp.x - vehicle.x, lamp.y - vehicle.y), 1e-5);
    EXPECT_EQ(row[1], static_cast<double>(end.events.contacts));
}

TEST(Study, CountsTheWholeRunAfterTheMeasuredVehicleIsGone) {
    Scene scene = shipped_scene("predator-prey");
    scene.ecology.drain = 0.2f;
    const auto base = base_of(file_text("seconds = 30\nseeds = 1\nmeasures = [\"survival\", \"deaths\"]",
                                        "name = \"v\"\npaths = [\"kind.prey.body.top_speed\"]\nlevels = [3]\n"),
                              scene);
    const StudyRow row = insight::run_of(base, 0);
    EXPECT_LT(row[0], 20);
    World world = make(*parse_scene(write_scene(scene), "", {{"kind.prey.body.top_speed", "3"}}));
    EXPECT_EQ(row[1], static_cast<double>(after(world, 30).events.deaths));
}

TEST(Study, InPiecesIsTheSameAsAtOnce) {
    const auto base =
        base_of(file_text("seconds = 5\nseeds = 1\nmeasures = [\"closest\"]", weights), shipped_scene("2b-aggressor"));
    insight::StudyRun run(base, 1);
    int pieces = 1;
    while (!run.advance(7)) ++pieces;
    EXPECT_GT(pieces, 40);
    EXPECT_EQ(run.row(), insight::run_of(base, 1));
}

TEST(StudyFile, RefusesWhatIsIncompleteOrUnknownWithLine) {
    const std::string good = "seeds = 2\nmeasures = [\"final\"]";
    EXPECT_EQ(problem(file_text(good, weights)), "");
    EXPECT_NE(problem("format = 1\ntitle = \"T\"\n").find("'scene' is missing"), std::string::npos);
    EXPECT_NE(problem(file_text("measures = [\"finale\"]", weights))
                  .find("study.toml:4: there is no measure 'finale'; the nearest is 'final'"),
              std::string::npos)
        << problem(file_text("measures = [\"finale\"]", weights));
    EXPECT_NE(problem(file_text("measures = []", weights)).find("'measures' is missing"), std::string::npos);
    EXPECT_EQ(problem(file_text(good, "name = \"a\"\nlevels = [1]\n")),
              "study.toml:6: 'paths' is missing; a [[value]] has a name, paths and levels");
    EXPECT_EQ(problem(file_text(good, "paths = [\"x\"]\nlevels = [1]\n")),
              "study.toml:6: 'name' is missing; a [[value]] has a name, paths and levels");
    EXPECT_NE(problem(file_text(good, "name = \"a\"\npaths = [\"x\"]\nlevels = [\"1\"]\n")).find("list of numbers"),
              std::string::npos);
    for (const auto& [levels, written] :
         {std::pair("[0,5, 1,5]", "0.5"), {"[0,1, 0,2, 0,3]", "0.1"}, {"[1, 0,5]", "0.5"}, {"[\n  -1,5, 1,5]", "-1.5"}})
        EXPECT_TRUE(problem(file_text(good, std::string("name = \"a\"\npaths = [\"x\"]\nlevels = ") + levels + "\n"))
                        .ends_with(std::string("; write ") + written + ", with a point"))
            << levels;
    for (const char* levels :
         {"[0,5,1,5]", "[0, 5, 1, 5]", "[1,2, 3,4]", "[4,3, 2,1]", "[0.5,1.5, 1,2]", "[5,1]", "[]"})
        EXPECT_EQ(problem(file_text(good, std::string("name = \"a\"\npaths = [\"x\"]\nlevels = ") + levels + "\n"))
                      .find("with a point"),
                  std::string::npos)
            << levels;
    EXPECT_NE(problem(file_text(good, "name = \"seed\"\npaths = [\"x\"]\nlevels = [1]\n")).find("two columns 'seed'"),
              std::string::npos);
    EXPECT_NE(problem(file_text(good, std::string(weights) + "unti = \"m\"\n")).find("'unti'"), std::string::npos);
    std::string many = "name = \"a\"\npaths = [\"x\"]\nlevels = [1";
    for (int i = 2; i <= 100; ++i) many += "," + std::to_string(i);
    EXPECT_NE(problem(file_text("seeds = 101\nmeasures = [\"final\"]", many + "]\n")).find("10100 runs"),
              std::string::npos);
}

TEST(StudyFile, TwoValuesOfTheSameNameAreRefusedWithLineAlsoWithOtherUnits) {
    for (const char* unit : {"m/s", "cm/s", ""}) {
        const std::string value = std::string("name = \"speed\"\npaths = [\"arena.grip\"]\nlevels = [1]\nunit = \"");
        const auto study = insight::parse_study(
            file_text("measures = [\"final\"]", value + "m/s\"\n[[value]]\n" + value + unit + "\"\n"), "s.toml");
        ASSERT_FALSE(study) << unit;
        EXPECT_EQ(study.error().phrases.front().id, "column_twice") << unit;
        EXPECT_EQ(study.error().line, 11) << study.error().text();
    }
}

TEST(StudyFile, RefusesWhatTheSceneDoesNotHave) {
    const auto fails = [](const std::string& top, const std::string& value) {
        auto study = insight::parse_study(file_text(top, value), "study.toml");
        EXPECT_TRUE(study);
        const auto base =
            StudyBase::create(std::move(*study), write_scene(shipped_scene("2b-aggressor")), "scene.toml");
        return base ? std::string() : base.error().text();
    };
    const std::string good = "measures = [\"final\"]";
    EXPECT_NE(fails(good, "name = \"a\"\npaths = [\"kind.agressor.body.mass\"]\nlevels = [5]\n")
                  .find("'kind.aggressor.body.mass'"),
              std::string::npos);
    EXPECT_NE(fails(good, "name = \"a\"\npaths = [\"kind.aggressor.body.mass\"]\nlevels = [5, 5000]\n").find("1000"),
              std::string::npos);
    const std::string vehicle = fails(good + "\nvehicle = \"x\"", weights);
    EXPECT_NE(vehicle.find("no vehicle called 'x'"), std::string::npos) << vehicle;
    const std::string text = file_text(good + "\nvehicle = \"x\"", weights);
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find("vehicle =")), '\n');
    EXPECT_TRUE(vehicle.starts_with("study.toml:" + std::to_string(line) + ": ")) << vehicle;
}

TEST(StudyTable, ReadsItsOwnLinesAndNoOthers) {
    const auto base =
        base_of(file_text("seeds = 2\nmeasures = [\"final\", \"touch\"]", weights), shipped_scene("2b-aggressor"));
    EXPECT_EQ(insight::study_header(base->study()), "run,seed,weight,final_m,touch_s\n");
    const std::string line = insight::study_line(*base, 3, {0.25, never});
    EXPECT_EQ(line, "4,2,1.5,0.25,\n");
    const auto row = insight::read_study_line(*base, 3, line);
    ASSERT_TRUE(row);
    EXPECT_EQ((*row)[0], 0.25);
    EXPECT_EQ((*row)[1], never);
    for (const char* wrong :
         {"4,2,1.5,0.25\n", "4,2,1.5,0.25,,\n", "4,2,0.5,0.25,\n", "4,2,1.5,0.2x,\n", "4,2,1.5,0.25,", ""})
        EXPECT_FALSE(insight::read_study_line(*base, 3, wrong)) << wrong;
}

TEST(StudyTable, AColumnOfRealNumbersHasAPointInEachCell) {
    const auto base = base_of(
        file_text(
            "seeds = 1\nmeasures = [\"contacts\", \"final\"]",
            "name = \"w\"\npaths = [\"kind.aggressor.brain.LR\"]\nlevels = [0, 0.5]\n[[value]]\nname = \"v\"\npaths = "
            "[\"kind.aggressor.brain.RL\"]\nlevels = [0, 1]\n"),
        shipped_scene("2b-aggressor"));
    EXPECT_EQ(insight::study_line(*base, 0, {3, 2}), "1,1,0.0,0,3,2.0\n");
    EXPECT_EQ(insight::study_line(*base, 3, {12345678, never}), "4,1,0.5,1,12345678,\n");
    EXPECT_TRUE(insight::read_study_line(*base, 0, "1,1,0.0,0,3,2.0\n"));
}

TEST(StudyTable, AColumnEndsWithTheUnitOfItsValue) {
    struct Named {
        const char *name, *unit, *column;
    };
    for (const Named& each : {Named{"mass", "kg", "mass_kg"},
                              {"eyes", "°", "eyes_deg"},
                              {"speed", "m/s", "speed_m_s"},
                              {"a", "m/s²", "a_m_s2"},
                              {"drag", "N·s/m", "drag_N_s_m"},
                              {"share", "%", "share_percent"},
                              {"mass_kg", "kg", "mass_kg"},
                              {"weight", "", "weight"}})
        EXPECT_EQ(insight::column_name(insight::StudyValue{each.name, each.unit, {}, {}}), each.column);
    const auto base = base_of(file_text("measures = [\"contacts\"]",
                                        "name = \"mass\"\nunit = \"kg\"\npaths = [\"kind.aggressor.body.mass\"]\n"
                                        "levels = [5, 20]\n"),
                              shipped_scene("2b-aggressor"));
    EXPECT_EQ(insight::study_header(base->study()), "run,seed,mass_kg,contacts\n");
    const std::string value = "name = \"final\"\nunit = \"m\"\npaths = [\"arena.grip\"]\nlevels = [1]\n";
    const auto study = insight::parse_study(file_text("measures = [\"final\"]", value), "s.toml");
    ASSERT_FALSE(study) << "with its unit it is the column of a measure";
    EXPECT_NE(study.error().text().find("two columns 'final_m'"), std::string::npos) << study.error().text();
}

TEST(StudyFile, ANameThatIsAColumnOfAMeasureIsRefused) {
    for (const char* name : {"final_m", "contacts", "run", "seed"}) {
        const std::string value = std::string("name = \"") + name + "\"\npaths = [\"arena.grip\"]\nlevels = [1]\n";
        const auto study = insight::parse_study(file_text("measures = [\"contacts\", \"final\"]", value), "s.toml");
        ASSERT_FALSE(study) << name;
        EXPECT_NE(study.error().text().find(std::string("two columns '") + name + "'"), std::string::npos)
            << study.error().text();
    }
}

TEST(StudyTable, HasNoFormulaAsTheNameOfAColumn) {
    Study study;
    study.values = {{"=HYPERLINK(\"x\")", "", {}, {}}};
    EXPECT_EQ(insight::study_header(study), "run,seed,\"'=HYPERLINK(\"\"x\"\")\"\n");
}

TEST(StudyTable, HasTimesWithoutTheErrorOfSinglePrecision) {
    const char* bias =
        "name = \"bias\"\npaths = [\"kind.aggressor.brain.LM\", \"kind.aggressor.brain.RM\"]\nlevels = [0.2]\n";
    const auto base = base_of(file_text("seconds = 20\nseeds = 1\nmeasures = [\"survival\", \"touch\"]", bias),
                              shipped_scene("2b-aggressor"));
    const StudyRow row = insight::run_of(base, 0);
    EXPECT_EQ(row[0], 20.0);
    ASSERT_TRUE(std::isfinite(row[1]));
    EXPECT_EQ(row[1], std::round(row[1] * 60) / 60) << "a whole number of ticks";
}

TEST(StudyTable, ComparesWithTheSameSeedsOfTheFirstCombination) {
    const auto base = base_of(file_text("seeds = 4\nmeasures = [\"touch\"]", weights), shipped_scene("2b-aggressor"));
    const std::vector<StudyRow> rows{{1}, {2}, {3}, {never}, {2}, {5}, {2}, {4}};
    const auto first = summary_of(base->study(), rows, 0, 0), second = summary_of(base->study(), rows, 1, 0);
    EXPECT_EQ(first.spread.median, 2.5);
    EXPECT_EQ(first.spread.most, never);
    EXPECT_EQ(second.spread.median, 3);
    EXPECT_EQ(second.paired, 1);  // of 1, 3 and −1; the fourth pair is not finite
    EXPECT_EQ(second.more, 2u);
    EXPECT_EQ(second.less, 2u);
    EXPECT_EQ(second.pairs, 4u);
    const std::vector<StudyRow> unknown{{none}, {2}, {none}, {4}};
    EXPECT_EQ(summary_of(base->study(), unknown, 0, 0).spread.count, 2u);
}

TEST(Spread, HasQuartilesByLinearInterpolation) {
    const maths::Spread s = maths::spread_of({4, 1, 3, 2});
    EXPECT_EQ(s.least, 1);
    EXPECT_EQ(s.lower, 1.75);
    EXPECT_EQ(s.median, 2.5);
    EXPECT_EQ(s.upper, 3.25);
    EXPECT_EQ(s.most, 4);
    EXPECT_EQ(maths::spread_of({1, never, never}).median, never);
    EXPECT_EQ(maths::spread_of({}).count, 0u);
}

TEST(StudyFile, ThoseThatShipAreSound) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(source / "exercises" / "studies")) {
        std::ifstream in(entry.path());
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        auto study = insight::parse_study(text, entry.path().string());
        ASSERT_TRUE(study) << study.error().text();
        const Scene scene = shipped_scene(study->scene);
        const auto base = StudyBase::create(std::move(*study), write_scene(scene), "scene.toml");
        EXPECT_TRUE(base) << base.error().text();
        ++count;
    }
    EXPECT_GE(count, 2);
}

TEST(StudyFile, TheFormatPageHasTheGeneratedTablesAndAnExampleThatReads) {
    const fs::path path = source / "docs" / "study-format.md";
    std::ifstream in(path);
    std::string text((std::istreambuf_iterator<char>(in)), {});
    if (std::getenv("BRAITENLAB_WRITE_DOCS")) {
        text = text.substr(0, text.find("\n## The top of the file")) + insight::describe_study_format();
        std::ofstream(path, std::ios::binary) << text;
    }
    EXPECT_NE(text.find(insight::describe_study_format()), std::string::npos);
    std::istringstream lines(text);
    std::string example;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("    ") || (line.empty() && !example.empty())) example += line + '\n';
    EXPECT_EQ(problem(example), "");
}

}  // namespace
}  // namespace braitenlab::tests::study_test
