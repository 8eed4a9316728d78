#include "core/scene/toml_advice.h"

#include <string>

#include <gtest/gtest.h>

#include "core/scene/toml_tree.h"

namespace braitenlab::tests::toml_advice_test {

struct Fault {
    std::string text, advice;
};

// The whole message for a file, as a person sees it.
std::string complaint(const std::string& text) {
    const auto file = parse_toml(text, "f.toml");
    return file ? "" : file.error().text();
}

TEST(TomlAdvice, SaysWhatToDoAboutAMistakeOfTheLine) {
    for (const auto& [text, advice] :
         std::vector<Fault>{{"x = 0,6", "; write 0.6, with a point"},
                            {"x = -1,25 # half", "; write -1.25, with a point"},
                            {"kind = coward", "; put text in quotes \", not bare as 'coward'"},
                            {"name = Käfer", "; put text in quotes \", not bare as 'Käfer'"},
                            {"blocks = True", "; write true, in small letters"},
                            {"title = \"My scene", "; a quote \" is missing at the end of a text"},
                            {"offers = [\"LL, \"RR\"]", "; a quote \" is missing at the end of a text"},
                            {"title = „My scene“", "; write straight quotes \" instead of „"},
                            {"title = ”My scene”", "; write straight quotes \" instead of ”"},
                            {"heading = 35°", "; write the number without its unit: 35"},
                            {"x = 2 m", "; write the number without its unit: 2"},
                            {"x = -2.5m # metres", "; write the number without its unit: -2.5"},
                            {"strength = 50%", "; write the number without its unit: 50"},
                            {"x =", "; write a value after x ="},
                            {"x =\u00A03", "; write a plain space in place of the special space U+00A0"},
                            {"x = 3\u202Fm", "; write a plain space in place of the special space U+202F"},
                            {"x\u1680= 3", "; write a plain space in place of the special space U+1680"},
                            {"x =\u20033", "; write a plain space in place of the special space U+2003"},
                            {"x = 3\u205F", "; write a plain space in place of the special space U+205F"},
                            {"\u3000x = 3", "; write a plain space in place of the special space U+3000"},
                            {"x = \u200B16", "; remove the invisible character U+200B"},
                            {"x = \u200E16", "; remove the invisible character U+200E"},
                            {"x = 16\u2028", "; remove the invisible character U+2028"},
                            {"x = \u22123", "; write a plain minus - instead of \u2212"},
                            {"x: 3", "; write a key and its value, like x = 1.5"},
                            {"[arena", "; a bracket ] is missing"},
                            {"[[step]", "; a bracket ] is missing"},
                            {"title = \"\xE4rger\"", "; save the file as UTF-8"}}) {
        SCOPED_TRACE(text);
        const std::string told = complaint("format = 1\n" + text + "\n");
        EXPECT_TRUE(told.starts_with("f.toml:2: not TOML: ")) << told;
        EXPECT_TRUE(told.ends_with(advice)) << told;
    }
}

TEST(TomlAdvice, NamesAHeadingOrAKeyThatStandsTwice) {
    EXPECT_TRUE(complaint("[step]\ngoal = \"runs\"\n[step]\n")
                    .ends_with("; [step] stands twice: write [[step]] where there are several, or join them"));
    EXPECT_TRUE(complaint("[step]\n[[step]]\n")
                    .ends_with("; [step] stands twice: write [[step]] where there are "
                               "several, or join them"));
    EXPECT_TRUE(complaint("[a]\nx = 1\n[b]\nx = 2\nx = 3\n").ends_with("; x stands twice: remove one"));
    EXPECT_EQ(toml_advice("[a]\nx = 1\n[b]\nx = 1.2.3", 4).text, "") << "the other x is in another table";
}

TEST(TomlAdvice, KnowsANumberThatIsTooLargeAndAZeroByte) {
    EXPECT_TRUE(complaint("width = 1e400\n").ends_with("could not be interpreted as a value"));
    EXPECT_TRUE(complaint(std::string("width = 1\0\n", 11)).ends_with(message_of("advice_no_zero").text));
    const std::string cut = complaint("a = 1\nb = 2" + std::string(2000, '\0'));
    EXPECT_TRUE(cut.starts_with("f.toml:2:") && cut.ends_with(message_of("advice_no_zero").text)) << cut;
}

TEST(TomlAdvice, ATextOfSeveralLinesThatIsNotClosedIsToldAtItsLine) {
    for (const std::string quotes : {"\"\"\"", "'''"}) {
        const std::string text = "# '''\na = 1\ntitle = " + quotes + "A \"quote\"\nsolid = true\nx = 1,5\n";
        const std::string told = complaint(text);
        EXPECT_TRUE(told.starts_with("f.toml:3: not TOML: ")) << told;
        EXPECT_TRUE(told.ends_with("; the text that begins here has no end; write " + quotes + " after it")) << told;
        EXPECT_FALSE(open_text("title = " + quotes + "A\n\\\nB" + quotes + "\nx = \"'''\"\n"));
    }
    EXPECT_FALSE(open_text("a = \"\\\"\"\nb = 1,5\n")) << "a quote that is closed";
}

TEST(TomlAdvice, AListThatIsNotClosedIsToldAtItsLine) {
    for (const char* text :
         {"a = 1\noptions = [\"x\", \"y\"\nb = 2\n", "a = 1\noptions = [\n  \"x\",\n  \"y\"\n\nb = 2\n",
          "a = 1\noptions = [\"x\", \"[y]\"  # why\n[next]\nb = 2\n"}) {
        const std::string told = complaint(text);
        EXPECT_TRUE(told.starts_with("f.toml:2: not TOML: ")) << told;
        EXPECT_TRUE(told.ends_with("; a bracket ] is missing")) << told;
    }
    EXPECT_EQ(line_of_open_list("a = [1]\nb = 1.2.3\n", 2), 0);
    EXPECT_EQ(line_of_open_list("a = \"[\"\nb = 1.2.3\n", 2), 0) << "a bracket of a text";
}

TEST(TomlAdvice, AsksForUtf8InAFileOfUtf16) {
    const std::string text(
        "\xFF\xFE"
        "f\0o\0",
        6);
    EXPECT_TRUE(complaint(text).ends_with("; save the file as UTF-8")) << complaint(text);
}

TEST(TomlAdvice, IsEmptyForAnUnknownCause) {
    for (const char* line : {"x = 1", "x = 1.5.2", "a = \"b\" \"c\"", "x = [1, 2", "\"a b\" = 3", "", "# 0,6"})
        EXPECT_EQ(toml_advice(line, 1).text, "") << line;
    EXPECT_EQ(toml_advice("x = 0,6", 7).text, toml_advice("x = 0,6", 1).text);
}

}  // namespace braitenlab::tests::toml_advice_test
