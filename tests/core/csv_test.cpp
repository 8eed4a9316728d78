#include "core/io/csv.h"

#include <array>
#include <cmath>

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
         {"=1+1"sv,      "+cmd"sv,    "-1+cmd"sv,  "@SUM(A1)"sv, " =1"sv,      "\t=1"sv,     "\r=1"sv,
          "\n=1"sv,      "\v=1"sv,    "\0=1"sv,    "\x7F=1"sv,   "\u0085=1"sv, "\u00A0=1"sv, "\uFEFF=1"sv,
          "\u3000 =1"sv, "\uFF1D1"sv, "\uFF0B1"sv, "\uFF0D1"sv,  "\uFF20A"sv,  "-"sv,        "-1-1"sv}) {
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

TEST(Csv, SemicolonsReplaceTheCommasBetweenCellsOnly) {
    EXPECT_EQ(io::with_semicolons("a,\"b, \"\"c\"\", d\",e\n1,2,3\n"), "a;\"b, \"\"c\"\", d\";e\n1;2;3\n");
    std::string line;
    io::add_csv_cell(line, std::string_view("LR; RL"));
    EXPECT_EQ(line, "\"LR; RL\"");
}

}  // namespace
}  // namespace braitenlab::tests::csv_test
