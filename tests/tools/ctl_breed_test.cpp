// braitenctl breed: folders, interruption, matrices, champions, messages.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/tools/ctl.h"

namespace braitenlab::tests::ctl_breed_test {
namespace {

namespace fs = std::filesystem;
using namespace ctl_runs;

std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The shipped breeding, small.
std::string small_breeding() {
    const fs::path shipped = fs::path(BRAITENLAB_SOURCE) / "exercises" / "breeding";
    const std::string file = scratch("breeding.toml");
    std::string text = content(shipped / "chase.toml");
    text.replace(text.find("scenes/"), 0, shipped.generic_string() + "/");
    const std::string small =
        "seconds = 4\ngenerations = 2\npopulation = 4\nparents = 2\ntrials = 2\npanel = 2\npanel_generations = 2\n";
    text.insert(text.find("[[breed]]"), small);
    std::ofstream(file) << text;
    return file;
}

struct Folder {
    explicit Folder(const char* name) : path(scratch(name)) { fs::remove_all(path); }
    ~Folder() { fs::remove_all(path); }
    std::string path;
};

TEST(CtlBreed, AFolderDependsNeitherOnThreadsNorOnAPause) {
    const std::string file = small_breeding();
    const Folder one("breed-one"), three("breed-three"), paused("breed-paused");
    const Ran first = ctl("breed " + file + " --threads 1 --json --out " + one.path);
    ASSERT_EQ(first.code, 0) << first.out;
    EXPECT_EQ(ctl("breed " + file + " --threads 3 --out " + three.path).code, 0);
    EXPECT_EQ(ctl("breed " + file + " --generations 1 --out " + paused.path).code, 0);
    EXPECT_NE(content(fs::path(paused.path) / "state.json"), content(fs::path(one.path) / "state.json"));
    EXPECT_EQ(ctl("breed " + paused.path + " --continue").code, 0);
    for (const char* name : {"state.json", "breeding.toml", "scene.toml"}) {
        const std::string wanted = content(fs::path(one.path) / name);
        EXPECT_FALSE(wanted.empty()) << name;
        EXPECT_EQ(content(fs::path(three.path) / name), wanted) << name;
        EXPECT_EQ(content(fs::path(paused.path) / name), wanted) << name;
    }
    const Json last = Json::parse(first.out);
    EXPECT_EQ(last["generation"], 2);
    EXPECT_EQ(last["trials"], 2 * 3 * 4 * 2 + 2 * 3 * 4 * 2 + 3 * 2 * 2 * 4);  // panel, generations, scores
    for (const char* side : {"predator", "prey"}) {
        EXPECT_GE(last["panel"][side].get<double>(), 0) << side;
        EXPECT_LE(last["best"][side].get<double>(), 1) << side;
    }
    fs::remove(file);
}

TEST(CtlBreed, AStateThatCannotBeWrittenEndsIt) {
    const std::string file = small_breeding();
    const Folder folder("breed-unwritten");
    fs::create_directories(folder.path);
    fs::create_symlink("state.json", fs::path(folder.path) / "state.json");  // a link to itself
    const Ran ran = ctl("breed " + file + " --out " + folder.path);
    EXPECT_EQ(ran.code, 2) << ran.out;
    EXPECT_NE(ran.out.find("state.json"), std::string::npos) << ran.out;
    EXPECT_EQ(ran.out.find("against the panel"), std::string::npos) << ran.out;
    fs::remove(file);
}

TEST(CtlBreed, NamesEveryErrorOfABreedingByLine) {
    const std::string file = scratch("errors-breeding.toml");
    std::ofstream(file)
        << "format = 1\ntitel = \"T\"\nscene = \"" << BRAITENLAB_SOURCE
        << "/exercises/breeding/scenes/chase-arena.toml\"\nparents = 30\nfitness = \"tuch\"\n"
           "[[breed]]\nkind = \"preyy\"\n[[breed.gene]]\nname = \"g\"\npaths = [\"brain.LL\"]\nlow = 2\n"
           "[[breed]]\nkind = \"predator\"\n[[breed.gene]]\nnmae = \"g\"\npaths = [\"brain.LX\"]\n";
    const Ran ran = ctl("breed " + file + " --out " + scratch("errors-breeding"));
    EXPECT_EQ(ran.code, 2);
    for (const char* part : {":2: no key 'titel'", ":4: ", ":5: there is no measure 'tuch'",
                             ":7: ", ":8: ", ":15: no key 'nmae'", ":16: no such value 'kind.predator.brain.LX'"})
        EXPECT_NE(ran.out.find("errors-breeding.toml" + std::string(part)), std::string::npos) << part << "\n"
                                                                                               << ran.out;
    EXPECT_EQ(std::count(ran.out.begin(), ran.out.end(), '\n'), 7) << ran.out;
    fs::remove(file);
}

TEST(CtlBreed, AFolderGivesItsMatrixItsChampionsAndTheirMatches) {
    const std::string file = small_breeding();
    const Folder folder("breed-asked");
    ASSERT_EQ(ctl("breed " + file + " --out " + folder.path).code, 0);
    const std::string master = ctl("breed " + folder.path + " --matrix master --csv -").out;
    EXPECT_EQ(std::count(master.begin(), master.end(), '\n'), 1 + 2 * 3 * 3) << master;
    const std::string ciao = ctl("breed " + folder.path + " --matrix ciao --csv -").out;
    EXPECT_EQ(std::count(ciao.begin(), ciao.end(), '\n'), 1 + 2 * (1 + 2 + 3)) << ciao;
    const std::string brain = scratch("champion.toml"), scene = scratch("match.toml");
    EXPECT_EQ(ctl("breed " + folder.path + " --champion prey:2 --out " + brain).code, 0);
    EXPECT_EQ(ctl("show " + brain).code, 0);
    EXPECT_EQ(ctl("breed " + folder.path + " --match 2:0 --out " + scene).code, 0);
    EXPECT_EQ(ctl("run " + scene + " --seconds 2").code, 0);
    for (const char* wrong : {"--champion prey:3", "--champion hare:1", "--match 1", "--match 1:x", "--matrix all"}) {
        const Ran ran = ctl("breed " + folder.path + " " + wrong + " --out " + brain);
        EXPECT_EQ(ran.code, 2) << wrong << ran.out;
    }
    fs::remove(file), fs::remove(brain), fs::remove(scene);
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
    return count;
}

TEST(CtlBreed, DrawsCurvesAndMatricesWithNamedAxes) {
    const std::string file = small_breeding(), svg = scratch("breeding.svg");
    const Folder folder("breed-drawn");
    ASSERT_EQ(ctl("breed " + file + " --out " + folder.path).code, 0);
    const std::string command = "breed " + folder.path + " --svg " + svg;
    ASSERT_EQ(ctl(command).code, 0);
    std::string text = content(svg);
    for (const char* part :
         {">Chase, against the last champions</text>", ">Predator</text>", ">Prey</text>", ">generation</text>",
          ">score (0 to 1)</text>", ">best against the panel</text>", ">0.4</text>", ">2</text>"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_EQ(count_of(text, "fill=\"none\" stroke=\"#0072b2\""), 3U) << "a curve of each side, and the legend";
    EXPECT_EQ(text.find(">1.5</text>"), std::string::npos) << "generations are whole numbers";
    EXPECT_EQ(text.find("nan"), std::string::npos);
    const auto is_xml = [&] {
        return shell("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])' " + svg).code == 0;
    };
    EXPECT_TRUE(is_xml());
    // A square for each pair; the number of each on an outline.
    ASSERT_EQ(ctl(command + " --matrix ciao").code, 0);
    text = content(svg);
    EXPECT_EQ(count_of(text, "z\" fill="), 2U * (1 + 2 + 3));
    EXPECT_EQ(count_of(text, "stroke=\"#fff\""), 2U * (1 + 2 + 3));
    for (const char* part :
         {">generation of the prey</text>", ">generation of the predator</text>",
          ">Score: of the prey the share of 4 s until it is bitten, of the predator the rest.</text>"})
        EXPECT_NE(text.find(part), std::string::npos) << part << text;
    ASSERT_EQ(ctl(command + " --lang de").code, 0);
    EXPECT_NE(content(svg).find(">Jagd, gegen die letzten Sieger</text>"), std::string::npos);
    ASSERT_EQ(ctl(command + " --matrix master --lang de --title Mine --x-label 'g (1)'").code, 0);
    text = content(svg);
    EXPECT_EQ(count_of(text, "z\" fill="), 2U * 9);
    for (const char* part : {">Mine</text>", ">g (1)</text>", ">Generation des Räubers</text>", ">0,4</text>"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    EXPECT_TRUE(is_xml());
    expect_refused("breed " + folder.path + " --svg a.png", ".svg");
    expect_refused("breed chase --svg a.svg", "folder of a breeding");
    fs::remove(file), fs::remove(svg);
}

std::size_t rows_with(const std::string& table, const std::string& begin) { return count_of(table, "\n" + begin); }

TEST(CtlBreed, OneCommandWritesAllTablesAndDrawings) {
    const std::string file = small_breeding();
    const Folder folder("breed-report"), report("breed-figures");
    ASSERT_EQ(ctl("breed " + file + " --out " + folder.path).code, 0);
    const Ran reported = ctl("breed " + folder.path + " --report " + report.path);
    ASSERT_EQ(reported.code, 0);
    EXPECT_NE(reported.out.find("Report the word with its gain"), std::string::npos) << reported.out;
    EXPECT_NE(reported.out.find("\"Against the panel\" has other opponents"), std::string::npos) << reported.out;
    EXPECT_EQ(content(fs::path(report.path) / "breeding.txt"), reported.out);
    const std::string table = content(fs::path(report.path) / "breeding.csv");
    EXPECT_TRUE(table.starts_with("measure,side,generation,of,value\n")) << table;
    for (const char* side : {"predator", "prey"}) {
        for (const char* measure : {"best", "median", "diversity", "panel", "champion"})
            EXPECT_EQ(rows_with(table, std::string(measure) + "," + side + ","), 3U) << measure << side;
        EXPECT_EQ(rows_with(table, std::string("parent,") + side + ","), 2U * 4);
        EXPECT_EQ(rows_with(table, std::string("score,") + side + ","), 3U * 3);
    }
    const Json json = Json::parse(content(fs::path(report.path) / "breeding.json"));
    EXPECT_EQ(json["generation"], 2);
    EXPECT_EQ(json["prey"]["generations"].size(), 3U);
    EXPECT_EQ(json["prey"]["generations"][1]["parents"].size(), 4U);
    EXPECT_EQ(json["predator"]["verdict"]["course"], "too_early");
    EXPECT_EQ(json["tournament"]["predator_scores"][2].size(), 3U);
    EXPECT_EQ(json["prey"]["panel"]["generations"], 3);
    EXPECT_TRUE(json["prey"]["panel"]["interval"].is_null()) << "too few generations";
    for (const char* name : {"scores.svg", "ciao.svg", "master.svg"})
        EXPECT_TRUE(content(fs::path(report.path) / name).starts_with("<?xml")) << name;
    const std::string scores = ctl("breed " + folder.path + " --csv -").out;
    EXPECT_EQ(rows_with(scores, "score,"), 0U) << "without the matches";
    EXPECT_EQ(rows_with(scores, "parent,"), 2U * 2 * 4);
    expect_refused("breed chase --csv -", "folder of a breeding");
    fs::remove(file);
}

TEST(CtlBreed, AFolderThatIsThereIsNotReplaced) {
    const std::string file = small_breeding();
    const Folder folder("breed-kept");
    EXPECT_EQ(ctl("breed " + file).code, 2);
    ASSERT_EQ(ctl("breed " + file + " --out " + folder.path).code, 0);
    const Ran again = ctl("breed " + file + " --out " + folder.path);
    EXPECT_EQ(again.code, 2);
    EXPECT_NE(again.out.find("--continue"), std::string::npos) << again.out;
    std::ofstream(file, std::ios::app) << "mutation = 0.25\n";  // of the last gene
    const Ran other = ctl("breed " + file + " --continue --out " + folder.path);
    EXPECT_EQ(other.code, 2) << other.out;
    EXPECT_NE(ctl("breed chas --out x").out.find("'chase'"), std::string::npos);
    fs::remove(file);
}

}  // namespace
}  // namespace braitenlab::tests::ctl_breed_test
