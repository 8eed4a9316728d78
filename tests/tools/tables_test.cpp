// The tables of braitenctl as other programs read them: the types of columns, and values that are not taken as missing.
#include <cmath>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/folder.h"
#include "tests/shell.h"

namespace braitenlab::tests::tables_test {
namespace {

// A program that prints the sum of the column `value` and the number of rows whose column `role` is "other", of t.csv.
struct Reader {
    const char* name;
    std::vector<std::pair<const char*, const char*>>
        ways;  // a command that succeeds where it is installed; the command
};

const std::vector<Reader>& readers() {
    static const std::vector<Reader> all{
        {"pandas",
         {{"/usr/bin/python3 -c 'import pandas'",
           R"(/usr/bin/python3 -c 'import pandas as p; t = p.read_csv("t.csv"); print(t["value"].sum(), (t["role"] == "other").sum())')"}}},
        {"R",
         {{"Rscript --version", R"(Rscript -e 't <- read.csv("t.csv"); cat(sum(t$value), sum(t$role == "other"))')"}}},
        {"csvkit",
         {{"csvstat --version",
           R"(echo $(csvstat --sum -c value t.csv 2>/dev/null) $(csvgrep -c role -m other t.csv 2>/dev/null | csvcut -c role 2>/dev/null | csvjson 2>/dev/null | grep -o '"other"' | wc -l))"}}},
        {"DuckDB",
         {{"python3 -c 'import duckdb'",
           R"(python3 -c 'import duckdb; print(*duckdb.sql("select sum(value), count(*) filter (where role = '"'other'"') from '"'t.csv'"'").fetchone())')"},
          {"node -e 'require(\"@duckdb/node-api\")'",
           R"(node -e 'require("@duckdb/node-api").DuckDBInstance.create().then(d => d.connect()).then(c => c.runAndReadAll("select sum(value), count(*) filter (where role = \u0027other\u0027) from \u0027t.csv\u0027")).then(r => console.log(r.getRows()[0].join(" ")))')"}}},
        {"Polars",
         {{"python3 -c 'import polars'",
           R"(python3 -c 'import polars as p; t = p.read_csv("t.csv"); print(t["value"].sum(), (t["role"] == "other").sum())')"},
          {"node -e 'require(\"nodejs-polars\")'",
           R"(node -e 'const t = require("nodejs-polars").readCSV("t.csv"); console.log(t.getColumn("value").sum(), t.getColumn("role").toArray().filter(r => r == "other").length)')"}}},
    };
    return all;
}

// The command of the reader; empty if it is not installed.
std::string command_of(const Reader& reader) {
    for (const auto& [probe, command] : reader.ways)
        if (shell(probe).code == 0) return command;
    return "";
}

class TableReaders : public testing::TestWithParam<Reader> {};

void expect_numbers(const Folder& folder, const std::string& command, double sum, int others) {
    const Ran ran = shell("cd " + folder.path.string() + " && " + command);
    ASSERT_EQ(ran.code, 0) << ran.out;
    std::size_t end = 0;
    const double read = std::stod(ran.out, &end);
    EXPECT_NEAR(read, sum, 1e-6 * std::fabs(sum)) << ran.out;
    EXPECT_EQ(std::stoi(ran.out.substr(end)), others) << ran.out;
}

// 0, 0.1 … 1: the first 30,010 rows have whole numbers only, more than these programs look at. csvkit reads all rows,
// slowly.
TEST_P(TableReaders, TakeASweptValueForARealNumber) {
    const std::string command = command_of(GetParam());
    if (command.empty()) GTEST_SKIP() << GetParam().name << " is not installed";
    const Folder folder;
    const int seconds = GetParam().name == std::string("csvkit") ? 3 : 300, rows = 10 * seconds + 1;
    const Ran ran = ctl("run 2b-aggressor --seconds " + std::to_string(seconds) +
                        " --seed 1:10 --set kind.aggressor.brain.LR=0:1:0.1 --csv " + (folder / "a.csv").string());
    ASSERT_EQ(ran.code, 0) << ran.out;
    std::string table = text_of(folder / "a.csv");
    const std::string name = "kind.aggressor.brain.LR";
    table.replace(table.find(name), name.size(), "value");
    put_text(folder / "t.csv", table);
    expect_numbers(folder, command, 5.5 * 10 * rows, 11 * 10 * rows);
}

TEST_P(TableReaders, TakeTheMeasuresOfAStudyForRealNumbers) {
    const std::string command = command_of(GetParam());
    if (command.empty()) GTEST_SKIP() << GetParam().name << " is not installed";
    const Folder folder;
    put_text(folder / "s.toml",
             "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nseconds = 2\nseeds = 2\nmeasures = [\"survival\"]\n"
             "[[value]]\nname = \"value\"\npaths = [\"kind.aggressor.brain.LR\"]\nlevels = [0, 1, 0.25]\n");
    ASSERT_EQ(ctl("study " + (folder / "s.toml").string() + " --csv " + (folder / "a.csv").string()).code, 0);
    std::string table = text_of(folder / "a.csv");
    EXPECT_EQ(table,
              "run,seed,value,survival_s\n1,1,0.0,2.0\n2,2,0.0,2.0\n3,1,1.0,2.0\n4,2,1.0,2.0\n5,1,0.25,2.0\n"
              "6,2,0.25,2.0\n");
    for (std::size_t end = 0; (end = table.find('\n', end)) != table.npos; end += 7)
        table.insert(end, end < 30 ? ",role" : ",other");
    put_text(folder / "t.csv", table);
    expect_numbers(folder, command, 2.5, 6);
}

INSTANTIATE_TEST_SUITE_P(Installed, TableReaders, testing::ValuesIn(readers()),
                         [](const auto& tried) { return std::string(tried.param.name); });

}  // namespace
}  // namespace braitenlab::tests::tables_test
