#include "core/scene/toml_tree.h"

#include <algorithm>
#include <ctime>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/lesson/exercise_file.h"
#include "core/utf8.h"

namespace braitenlab::tests::toml_tree_test {
namespace {

// The whole message for a file, as a person sees it.
std::string complaint(const std::string& text) {
    const auto file = parse_toml(text, "f.toml");
    return file ? "" : file.error().text();
}

TEST(TomlTree, FindsADeepKeyAfterATextThatEndsWithQuotes) {
    std::string deep = "a";
    for (int i = 0; i < 1000000; ++i) deep += ".a";
    for (const char* text : {R"("""a"""")", R"("""a""""")", "'''a''''", "'''a'''''", R"("""a\"""")"}) {
        SCOPED_TRACE(text);
        const std::string line = std::string("x = [") + text + ", {" + deep + " = 1}]\n";
        EXPECT_EQ(complaint("format = 1\n" + line),
                  "f.toml:2: a key has too many dots; the longest is like "
                  "kind.NAME.body.wheel");
        EXPECT_EQ(complaint(std::string("x = ") + text + "\n"), "") << "the text alone";
    }
}

TEST(TomlTree, CutsAQuotedNameOfTheFileWithASign) {
    const std::string key(1500, 'a'), accented = "\"" + std::string(119, 'x') + "\u00e9\u00e9" + key + "\"";
    for (const std::string& name : {key, accented}) {
        const std::string said = complaint(name + " = 1\n" + name + " = 2\n");
        const std::size_t sign = said.find("…");
        ASSERT_NE(sign, said.npos) << said;
        EXPECT_LT(sign, 300u);
        EXPECT_TRUE(is_utf8(said));
        EXPECT_NE(said.find("twice"), said.npos) << "the advice follows";
    }
}

TEST(TomlTree, NamesTheFormatOfAFileOfAnotherProgram) {
    const std::string tar = "scene.toml" + std::string(247, '\0') + "ustar" + std::string(243, '\0') + "format = 1\n";
    for (const auto& [bytes, format] : std::vector<std::pair<std::string, std::string>>{
             {"PK\x03\x04rest", "ZIP"},
             {"%PDF-1.7\n", "PDF"},
             {"\uFEFF%PDF-1.7\n", "PDF"},
             {"\x89PNG\r\n", "PNG"},
             {"{\"other\": 1}", "JSON"},
             {"\n  <!DOCTYPE html>\n", "HTML"},
             {"\uFEFF<!DocType HTML><title>T</title>", "HTML"},
             {"<!-- saved -->\n<HTML lang=\"de\">", "HTML"},
             {"<?xml version=\"1.0\"?><!-- c --> <svg width=\"1\">", "SVG"},
             {"<svg xmlns=\"http://www.w3.org/2000/svg\">", "SVG"},
             {"<network>\n", "XML"},
             {"<!DOCTYPE aesl-source>\n", "XML"},
             {std::string("SQLite format 3\0\x10", 17), "SQLite"},
             {tar, "tar"},
             {"\xD0\xCF\x11\xE0", "Office"}})
        EXPECT_EQ(complaint(bytes),
                  "f.toml: this is a file of the format " + format + "; give a file of the lab, .toml or .run");
}

// The text in 2 or 4 bytes a character, the lowest first or last.
std::string widened(std::string_view text, std::size_t bytes, bool lowest_first) {
    std::string wide;
    for (const char c : text) {
        const std::string zeros(bytes - 1, '\0');
        wide += lowest_first ? c + zeros : zeros + c;
    }
    return wide;
}

TEST(TomlTree, NamesAnEncodingOtherThanUtf8) {
    const std::string text = "format = 1\n\n[arena]\nwidth = 20\n";
    for (const std::size_t bytes : {2u, 4u})
        for (const bool lowest_first : {true, false})
            for (const bool has_mark : {true, false}) {
                std::string mark = bytes == 2 ? "\xFE\xFF" : std::string("\0\0\xFE\xFF", 4);
                if (lowest_first) std::reverse(mark.begin(), mark.end());
                EXPECT_EQ(complaint((has_mark ? mark : "") + widened(text, bytes, lowest_first)),
                          bytes == 2 ? "f.toml: the text is in UTF-16; save the file as UTF-8"
                                     : "f.toml: the text is in UTF-32; save the file as UTF-8")
                    << bytes << lowest_first << has_mark;
            }
    EXPECT_EQ(complaint("\uFEFF" + text), "");
}

TEST(TomlTree, NamesAFileThatIsNoText) {
    EXPECT_EQ(complaint(std::string(5000, '\0')), "f.toml: " + message_of("only_zeros").text);
    EXPECT_EQ(complaint("\x02\xFF\x80\r\x03rest"), "f.toml: " + message_of("not_text").text);
    EXPECT_EQ(complaint("# \xFC"
                        "ber\rx = 1")
                  .substr(0, 9),
              "f.toml:1:")
        << "Latin-1 is a text";
    EXPECT_EQ(complaint("a = \"\x1B\u00e4\"").substr(0, 9), "f.toml:1:") << "a control character in UTF-8";
}

TEST(TomlTree, NamesASavedRunWithTheExtensionOfAScene) {
    EXPECT_EQ(complaint("{\"braitenlab_run\": 1}"), "f.toml: this is a saved run; end its name with .run");
}

TEST(TomlTree, LooksForNoErrorThatIsNotKept) {
    std::string text = "format = 1\n";
    for (int i = 0; i < 60000; ++i) text += "k" + std::to_string(i) + " = 1\n";
    text += "[[step]]\n";
    const auto seconds_of = [](const auto& work) {
        const std::clock_t began = std::clock();
        work();
        return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
    };
    double parse = 1e9, all = 1e9;
    for (int i = 0; i < 3; ++i) {
        parse = std::min(parse, seconds_of([&] { EXPECT_TRUE(parse_toml(text, "f.toml")); }));
        all = std::min(all, seconds_of([&] { EXPECT_EQ(errors_of_exercise(text, "f.toml").size(), 200u); }));
    }
    EXPECT_LT(all, 5 * parse) << all << " s, the text alone " << parse;
}

TEST(TomlTree, FindsTheCauseOfALargeFileInAboutTheTimeOfReadingIt) {
    std::string rows;
    for (int i = 0; i < 60000; ++i) rows += "  \"ab\",\n";
    const auto seconds_of = [](const std::string& text) {
        double least = 1e9;
        for (int i = 0; i < 3; ++i) {
            const std::clock_t began = std::clock();
            (void)complaint(text);
            least = std::min(least, static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC);
        }
        return least;
    };
    EXPECT_EQ(complaint("x = [\n" + rows + "[kind.a]\n").substr(0, 9), "f.toml:1:");
    const double closed = seconds_of("x = [\n" + rows + "]\n"), open = seconds_of("x = [\n" + rows + "[kind.a]\n");
    EXPECT_LT(open, 5 * closed) << open << " s, the list that is closed " << closed;
}

TEST(TomlTree, NamesALineThatEndsWithACarriageReturnAlone) {
    EXPECT_EQ(complaint("# a scene\r\nformat = 1\r[arena]\r"),
              "f.toml:2: the line ends with a carriage return alone; save the "
              "file with the line ends of Unix or "
              "Windows (LF or CRLF)");
    EXPECT_EQ(complaint("# a scene\rformat = 1\r").substr(0, 9), "f.toml:1:") << "the whole file is no comment";
    EXPECT_EQ(complaint("format = 1\r\n"), "");
}

TEST(TomlTree, AsksForAWholeFormatNumberAndForAnotherProgramOnlyWhereThatHelps) {
    const auto fault = [](const std::string& text) {
        auto file = parse_toml(text, "f.toml");
        check_format(*file);
        return file->failed() ? file->error().text() : "";
    };
    for (const char* value : {"1.0", "\"1\"", "true"})
        EXPECT_EQ(fault(std::string("format = ") + value),
                  "f.toml:1: 'format' should be the whole number 1; write format = 1");
    EXPECT_NE(fault("format = 2").find("may be from a newer one"), std::string::npos);
    EXPECT_NE(fault("format = -1").find("write format = 1"), std::string::npos);
    EXPECT_EQ(fault("format = 1"), "");
}

TEST(TomlTree, TellsTheSyntaxErrorsOfAllLines) {
    const auto lines_of = [](const std::string& text) {
        std::vector<int> lines;
        for (const Error& each : syntax_errors(text, "f.toml")) {
            EXPECT_EQ(each.file, "f.toml");
            lines.push_back(each.line);
        }
        return lines;
    };
    EXPECT_EQ(lines_of("format = 1\n"), std::vector<int>{});
    EXPECT_EQ(lines_of("format =\ntitle = \"T\"\nx = 0,5\n[a]\ny = lamp\n"), (std::vector{1, 3, 5}));
    // Lines that can be wrong because of another one are not told.
    EXPECT_EQ(lines_of("a =\n[b\nc = 1\nd =\n"), (std::vector{1, 2}));
    EXPECT_EQ(lines_of("a =\nb = [1, 2\nc = x\n"), (std::vector{1, 2}));
    EXPECT_EQ(lines_of("a = \"\"\"open\nb = x\nc =\n"), std::vector{1});
    std::string many, large;
    for (int i = 0; i < 100; ++i) many += "k" + std::to_string(i) + " =\n";
    EXPECT_EQ(lines_of(many).size(), 20u);
    while (large.size() < 300000) large += "# words\n";
    EXPECT_EQ(lines_of(many + large).size(), 1u);
}

TEST(TomlTree, KeepsAsManyErrorsAsAPersonReads) {
    TomlFile file{.name = "f.toml"};
    for (int i = 0; i < 100000; ++i) file.add("k" + std::to_string(i), Error{"no such key"});
    EXPECT_EQ(file.faults.size(), 200u);
    EXPECT_EQ(file.faults.front().path, "k0");
}

}  // namespace
}  // namespace braitenlab::tests::toml_tree_test
