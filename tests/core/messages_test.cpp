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

}  // namespace
}  // namespace braitenlab::tests::messages_test
