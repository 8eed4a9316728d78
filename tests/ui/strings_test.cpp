#include "ui/words/strings.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "desk.h"
#include "tests/folder.h"

namespace braitenlab::tests::strings_test {

using namespace ui;

namespace {

fs::path folder() { return fs::path(BRAITENLAB_SOURCE) / "ui" / "strings"; }

// The gaps and the keys in brackets, sorted: a translation may change their order.
std::multiset<std::string> marks(const std::string& words) {
    std::multiset<std::string> found;
    const std::regex mark("\\{\\}|\\[[A-Za-z0-9_]+\\]");
    for (std::sregex_iterator at(words.begin(), words.end(), mark), end; at != end; ++at) found.insert(at->str());
    return found;
}

// A line of ui/strings/unwanted_words.txt.
struct UnwantedWord {
    std::string language, word, instead;
};

std::vector<UnwantedWord> unwanted_words() {
    std::ifstream in(folder() / "unwanted_words.txt");
    std::vector<UnwantedWord> words;
    const std::regex row("(\\w+) \\| (.+) \\| (.+)");
    std::smatch parts;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#')) continue;
        EXPECT_TRUE(std::regex_match(line, parts, row)) << "unwanted_words.txt: " << line;
        words.push_back({parts[1], parts[2], parts[3]});
    }
    return words;
}

std::string in_small_letters(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] >= 'A' && text[i] <= 'Z') text[i] = static_cast<char>(text[i] - 'A' + 'a');
        const bool is_capital = text[i] == '\xC3' && i + 1 < text.size() && text[i + 1] < '\x9F';  // Ä, É, Ñ …
        if (is_capital) text[i + 1] = static_cast<char>(text[i + 1] + 0x20), ++i;
    }
    return text;
}

bool has_word(const std::string& text, const std::string& word) {
    const std::string small = in_small_letters(text);
    for (std::size_t at = small.find(word); at != small.npos; at = small.find(word, at + 1)) {
        const auto before = static_cast<unsigned char>(at == 0 ? ' ' : small[at - 1]);
        if (!(before >= 'a' && before <= 'z') && before < 0x80) return true;
    }
    return false;
}

}  // namespace

TEST(Strings, ListEnglishGermanAndSpanishByTheirNativeNames) {
    std::vector<std::string> codes, names;
    for (const Language& language : languages(folder())) codes.push_back(language.code), names.push_back(language.name);
    EXPECT_EQ(codes, (std::vector<std::string>{"de", "en", "es"}));
    EXPECT_EQ(names, (std::vector<std::string>{"Deutsch", "English", "Español"}));
}

TEST(Strings, HaveTheSameKeysGapsAndShortcutsInEveryLanguage) {
    const Strings strings = english();
    for (const Language& language : languages(folder())) {
        if (language.code == "en") continue;
        const auto other = Strings::load(folder() / (language.code + ".toml"));
        ASSERT_TRUE(other) << other.error().text();
        for (const auto& [key, words] : strings.all()) {
            ASSERT_TRUE(other->all().count(key)) << language.code << " lacks " << key;
            EXPECT_EQ(marks(other->all().at(key)), marks(words)) << language.code << ": " << key;
        }
        for (const auto& [key, words] : other->all())
            EXPECT_TRUE(strings.all().count(key)) << language.code << " only has " << key;
    }
}

TEST(Strings, AreTranslated) {
    const Strings strings = english();
    for (const std::string& code : shipped_codes()) {
        if (code == "en") continue;
        const Strings other = speaking(code);
        int sentences = 0;
        for (const auto& [key, words] : strings.all()) {
            if (std::count(words.begin(), words.end(), ' ') < 3 || marks(words).size() > 2) continue;
            ++sentences;
            EXPECT_NE(other(key), words) << code << ": " << key;
        }
        EXPECT_GT(sentences, 50);
    }
}

TEST(Strings, ListTheLanguagesForAnUnknownOne) {
    const auto klingon = load_language(folder(), "tlh");
    ASSERT_FALSE(klingon);
    EXPECT_NE(klingon.error().text().find("de, en, es"), std::string::npos) << klingon.error().text();
    EXPECT_FALSE(load_language(folder(), "../strings/en")) << "a language is a name, not a path";
}

TEST(Strings, SayThatAFolderHasNoLanguage) {
    const Folder empty;
    const auto loaded = load_language(empty.path, "en");
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().file, empty.path.string());
    EXPECT_TRUE(loaded.error().what.starts_with("holds no language")) << loaded.error().text();
}

TEST(Strings, RefuseAFileThatOverflowsTheParser) {
    std::string dots = "a";
    for (int i = 0; i < 1000000; ++i) dots += ".a";
    const auto parsed = Strings::parse("format = 1\n" + dots + " = \"x\"\n", "en.toml");
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error().line, 2);
}

TEST(Strings, UseEnglishForMissingWords) {
    const Folder own;
    const fs::path& place = own.path;
    std::ofstream(place / "en.toml") << "format = 1\n[a]\nb = \"words\"\nc = \"more\"\n";
    std::ofstream(place / "xx.toml") << "format = 1\n[a]\nb = \"wxrds\"\n";
    std::ofstream(place / "yy.toml") << "format = 1\n[a]\nb = 3\n";
    const auto half = load_language(place, "xx");
    ASSERT_TRUE(half) << half.error().text();
    EXPECT_EQ((*half)("a.b"), "wxrds");
    EXPECT_EQ((*half)("a.c"), "more");
    const auto broken = load_language(place, "yy");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().line, 3);
}

TEST(Strings, ShowTheKeyForWordsMissingInEveryLanguage) {
    const auto strings = Strings::parse("format = 1\n[a]\nb = \"words\"", "test.toml");
    ASSERT_TRUE(strings);
    EXPECT_EQ((*strings)("a.b"), "words");
    EXPECT_EQ((*strings)("a.c"), "a.c");
    EXPECT_EQ(strings->find("a.c", "else"), "else");
}

TEST(Strings, ReportTheLineOfAnErrorInAFile) {
    const auto number = Strings::parse("format = 1\n[a]\nb = 3", "test.toml");
    ASSERT_FALSE(number);
    EXPECT_EQ(number.error().line, 3);
    EXPECT_EQ(number.error().file, "test.toml");
    EXPECT_FALSE(Strings::parse("[a]\nb = \"c\"", "test.toml")) << "without format = 1";
    EXPECT_FALSE(Strings::parse("format = 1\n[a", "test.toml"));
}

TEST(Strings, FillTheirGapsInOrder) {
    EXPECT_EQ(fill("Passed {} of {} starts", {"8", "10"}), "Passed 8 of 10 starts");
    EXPECT_EQ(fill("{}{}", {"a"}), "a{}");
    EXPECT_EQ(fill("{}", {"{}"}), "{}");
}

TEST(Strings, HaveOneWordForOneConcept) {
    EXPECT_TRUE(has_word("Die Drähte", "drähte"));
    EXPECT_TRUE(has_word("ÄNDERN", "ändern"));
    EXPECT_FALSE(has_word("ausgewählte", "gewählte"));
    const auto unwanted = unwanted_words();
    EXPECT_GT(unwanted.size(), 20u);
    for (const auto& [language, word, instead] : unwanted)
        for (const fs::path& file : {folder() / (language + ".toml"),
                                     fs::path(BRAITENLAB_SOURCE) / "exercises" / "words" / (language + ".toml")}) {
            const bool is_english = file == folder() / "en.toml";  // with the messages of core
            const auto strings = is_english         ? load_language(folder(), "en")
                                 : fs::exists(file) ? Strings::load(file)
                                                    : Result<Strings>(Strings{});
            ASSERT_TRUE(strings) << strings.error().text();
            for (const auto& [key, text] : strings->all())
                EXPECT_FALSE(has_word(text, word))
                    << file.filename() << ": " << key << " has '" << word << "'; use '" << instead << "'";
        }
}

TEST(Strings, HaveTheEllipsisAndMarksOfTheLanguage) {
    const Strings spanish = speaking("es");
    for (const auto& [key, text] : spanish.all()) {
        EXPECT_EQ(text.find(" …"), std::string::npos) << key << ": no space before the ellipsis";
        const auto count = [&](std::string_view mark) {
            std::size_t found = 0;
            for (std::size_t at = text.find(mark); at != text.npos; at = text.find(mark, at + 1)) ++found;
            return found;
        };
        EXPECT_EQ(count("?"), count("¿")) << key << ": " << text;
        EXPECT_EQ(count("!"), count("¡")) << key << ": " << text;
    }
}

}  // namespace braitenlab::tests::strings_test
