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

TEST(Csv, SemicolonsReplaceTheCommasBetweenCellsOnly) {
    EXPECT_EQ(io::with_semicolons("a,\"b, \"\"c\"\", d\",e\n1,2,3\n"), "a;\"b, \"\"c\"\", d\";e\n1;2;3\n");
    std::string line;
    io::add_csv_cell(line, std::string_view("LR; RL"));
    EXPECT_EQ(line, "\"LR; RL\"");
}

}  // namespace
}  // namespace braitenlab::tests::csv_test
