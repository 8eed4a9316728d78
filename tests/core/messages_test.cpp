#include "core/messages.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace braitenlab::tests::messages_test {
namespace {

// The words in quotes in the sources of core and app that are ids by their form.
std::set<std::string> ids_in_sources(const std::regex& expression) {
    std::set<std::string> found;
    for (const char* folder : {"core", "app"})
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(std::filesystem::path(BRAITENLAB_SOURCE) / folder)) {
            if (!entry.is_regular_file() || entry.path().filename() == "messages.h") continue;
            std::ifstream in(entry.path());
            const std::string text{std::istreambuf_iterator<char>(in), {}};
            for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
                found.insert((*at)[1]);
        }
    return found;
}

// The compiler refuses an id that is not in the table.
TEST(Messages, AreUsed) {
    const auto quoted = ids_in_sources(std::regex("\"([a-z_0-9]+)\""));
    for (const MessageText& row : message_table)
        EXPECT_TRUE(quoted.count(std::string(row.id))) << row.id << " is unused";
}

TEST(Messages, AreJoinedInEnglishAndByParts) {
    const Message joined = message_of("in_node", "N1") + message_of("out_of_range", "bias", 3, -1, 1) + Message("!");
    EXPECT_EQ(joined.text, "node 'N1': 'bias' is 3, outside -1 .. 1!");
    ASSERT_EQ(joined.phrases.size(), 3u);
    EXPECT_EQ(joined.phrases[1], (Phrase{"out_of_range", {"bias", "3", "-1", "1"}}));
    EXPECT_EQ(joined.phrases[2], (Phrase{"", {"!"}}));
    const Error error = error_of(joined, "a.toml", 4);
    EXPECT_EQ(error.text(), "a.toml:4: node 'N1': 'bias' is 3, outside -1 .. 1!");
    EXPECT_EQ(message_of(error).phrases, joined.phrases);
    EXPECT_EQ(message_of(Error{"odd"}).phrases, (std::vector<Phrase>{{"", {"odd"}}}));
}

TEST(Messages, TellANumberFromTheLimitThatItPasses) {
    for (const auto& [value, limit] :
         {std::pair(1.0000001, 1.0), {40.0000001, 40.0}, {-5.00000004, -5.0}, {0.4999, 0.5}})
        for (const Digits kind : {Digits::in_all, Digits::behind_point}) {
            const auto [shown, passed] = told_apart(value, limit, kind, 2);
            EXPECT_NE(shown, passed);
            EXPECT_EQ(std::stod(shown) > std::stod(passed), value > limit) << shown << " " << passed;
        }
    EXPECT_EQ(told_apart(0.5, 0.52, Digits::behind_point, 2), (std::pair<std::string, std::string>("0.50", "0.52")));
    EXPECT_EQ(told_apart(1, 1, Digits::in_all, 3).first, "1");
}

}  // namespace
}  // namespace braitenlab::tests::messages_test
