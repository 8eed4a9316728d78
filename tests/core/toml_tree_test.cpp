#include "core/scene/toml_tree.h"

#include <string>

#include <gtest/gtest.h>

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
                  "f.toml:2: a key has too many dots; the longest is like kind.NAME.body.wheel");
        EXPECT_EQ(complaint(std::string("x = ") + text + "\n"), "") << "the text alone";
    }
}

TEST(TomlTree, KeepsAsManyErrorsAsAPersonReads) {
    TomlFile file{.name = "f.toml"};
    for (int i = 0; i < 100000; ++i) file.add("k" + std::to_string(i), Error{"no such key"});
    EXPECT_EQ(file.faults.size(), 200u);
    EXPECT_EQ(file.faults.front().path, "k0");
}

}  // namespace
}  // namespace braitenlab::tests::toml_tree_test
