#include "core/io/csv.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace braitenlab::tests::csv_test {
namespace {

std::string cell(const io::CsvValue& value) {
    std::string line;
    io::add_csv_cell(line, value);
    return line;
}

TEST(Csv, WritesNumbersWithADecimalPointAndNothingForNaN) {
    EXPECT_EQ(cell(0.5), "0.50000");
    EXPECT_EQ(cell(-2.0f / 3), "-0.66667");
    EXPECT_EQ(cell(std::int64_t{-12}), "-12");
    EXPECT_EQ(cell(std::nan("")), "");
}

TEST(Csv, QuotesATextWithASeparator) {
    EXPECT_EQ(cell(std::string_view("plain text")), "plain text");
    EXPECT_EQ(cell(std::string_view("a,b")), "\"a,b\"");
    EXPECT_EQ(cell(std::string_view("a\nb")), "\"a\nb\"");
    EXPECT_EQ(cell(std::string_view("a \"shy\" one")), "\"a \"\"shy\"\" one\"");
}

TEST(Csv, SeparatesCellsByCommasAndEndsEachLine) {
    const std::array<io::CsvColumn<int>, 2> columns{{
        {"count", [](int row) -> io::CsvValue { return std::int64_t{row}; }},
        {"length_m", [](int row) -> io::CsvValue { return row * 0.5; }},
    }};
    std::string text = io::csv_header(columns);
    io::add_csv_row(text, columns, 1);
    io::add_csv_row(text, columns, 3);
    EXPECT_EQ(text, "count,length_m\n1,0.50000\n3,1.50000\n");
}

TEST(Csv, PutsAnApostropheBeforeATextThatASpreadsheetCalculates) {
    using namespace std::string_view_literals;
    for (const std::string_view text :
         {"=1+1"sv,      "+cmd"sv,     "-1+cmd"sv,   "@SUM(A1)"sv, " =1"sv,      "\t=1"sv,     "\r=1"sv,
          "\n=1"sv,      "\v=1"sv,     "\0=1"sv,     "\x7F=1"sv,   "\u0085=1"sv, "\u00A0=1"sv, "\uFEFF=1"sv,
          "\u3000 =1"sv, "\uFF1D1"sv,  "\uFF0B1"sv,  "\uFF0D1"sv,  "\uFF20A"sv,  "-"sv,        "\u202E=1"sv,
          "\u2066=1"sv,  "\u00AD=1"sv, "\u034F=1"sv, "\u115F=1"sv, "\u2800=1"sv, "\uFE66=1"sv, "\uFE62"sv,
          "\uFE63"sv,    "\u22121"sv,  "-1-1"sv}) {
        SCOPED_TRACE(std::string(text));
        const std::string inert = io::spreadsheet_text(text);
        EXPECT_EQ(inert, "'" + std::string(text));
        EXPECT_EQ(io::spreadsheet_text(inert), inert) << "once is enough";
    }
    EXPECT_EQ(cell(std::string_view("=1+1")), "'=1+1");
    EXPECT_EQ(cell(std::string_view("=A1,B1")), "\"'=A1,B1\"");
    EXPECT_EQ(cell(std::string_view("a\t=1")), "\"a\t=1\"") << "a tab separates cells, too";
}

TEST(Csv, LeavesNumbersAndHarmlessTextsAsTheyAre) {
    for (const std::string_view text : {"", "a=b", "-2", "+0.25", "-1e-3", ".5", "LR-RL", "\u00E4=1", "'=1"})
        EXPECT_EQ(io::spreadsheet_text(text), text);
}

TEST(Csv, ATextOfACellIsUtf8WithoutControlCharacters) {
    EXPECT_EQ(cell(std::string_view("a\xFF\x1B[2Jb\u009Bc\u00E4\u202Ed\u2028")),
              "a\uFFFD\uFFFD[2Jb\uFFFDc\u00E4\uFFFDd\uFFFD")
        << "nothing that turns the order of a row";
    EXPECT_EQ(cell(std::string_view("\x1B=1")), "'\uFFFD=1");
    EXPECT_EQ(cell(std::string_view("a\tb\r\nc")), "\"a\tb\r\nc\"");
}

TEST(Csv, ATextWithASemicolonIsInQuotes) {
    EXPECT_EQ(cell(std::string_view("LR; RL")), "\"LR; RL\"") << "a semicolon separates cells in other styles";
}

TEST(Csv, AnotherStyleChangesSeparatorsAndNumbersOnly) {
    const io::CsvStyle german{';', ','};
    EXPECT_EQ(io::in_style("a,\"b, \"\"c\"\", d\",e\n1,2.50,-1e-3\n", german),
              "a;\"b, \"\"c\"\", d\";e\n1;2,50;-1e-3\n");
    EXPECT_EQ(io::in_style("1.5,1.5.2,v1.5,\"1.5, 2\",,\n", german), "1,5;1.5.2;v1.5;\"1.5, 2\";;\n");
    EXPECT_EQ(io::in_style("a,1.5\n", {}), "a,1.5\n");
}

TEST(Csv, ARealNumberHasAPointAlsoWhereItIsWhole) {
    EXPECT_EQ(io::real_text(12), "12.0");
    EXPECT_EQ(io::real_text(0), "0.0");
    EXPECT_EQ(io::real_text(-0.25), "-0.25");
    EXPECT_EQ(io::real_text(1e20), "1e+20");
    EXPECT_EQ(io::real_text(1.0 / 3, 3), "0.333");
    EXPECT_EQ(io::real_text(std::nan("")), "");
    EXPECT_EQ(io::real_text(INFINITY), "");
}

TEST(Csv, ReadsTablesOfOtherPrograms) {
    const io::CsvTable table = io::parse_csv("\xEF\xBB\xBFID;Name;Mark\r\n\r\nP 1;\"Lee; \"\"Kim\"\"\nx\";\r\nP 2");
    EXPECT_EQ(table.separator, ';');
    ASSERT_EQ(table.rows.size(), 3u);
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"ID", "Name", "Mark"}));
    EXPECT_EQ(table.rows[1], (std::vector<std::string>{"P 1", "Lee; \"Kim\"\nx", ""}));
    EXPECT_EQ(table.rows[2], (std::vector<std::string>{"P 2", "", ""})) << "as wide as the first one";
    EXPECT_TRUE(io::parse_csv("").rows.empty());
    EXPECT_EQ(io::parse_csv("a\tb,c\td\n").rows[0][1], "b,c");
}

TEST(Csv, WritesACellOfAnotherProgramAsItWas) {
    const auto copy = [](std::string_view text, char separator) {
        std::string line;
        io::add_csv_copy(line, text, separator);
        return line;
    };
    EXPECT_EQ(copy("-", ','), "-");
    EXPECT_EQ(copy("=1", ','), "=1");
    EXPECT_EQ(copy("a,b", ';'), "a,b");
    EXPECT_EQ(copy("a,b", ','), "\"a,b\"");
    EXPECT_EQ(copy("a \"b\"", ','), "\"a \"\"b\"\"\"");
}

}  // namespace
}  // namespace braitenlab::tests::csv_test
