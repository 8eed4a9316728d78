#include "core/messages.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include <gtest/gtest.h>

namespace braitenlab::tests::messages_test {
namespace {

// The ids in the sources of core and app: message_of("id" …), and the words that are ids by their form.
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

bool is_in_table(const std::string& id) {
    return std::any_of(message_table.begin(), message_table.end(), [&](const auto& row) { return row.id == id; });
}

TEST(Messages, AreInTheTableAndEachIsUsed) {
    const auto asked = ids_in_sources(std::regex("message_of\\(\\s*\"([a-z_0-9]+)\""));
    EXPECT_GT(asked.size(), 40u);
    for (const std::string& id : asked) EXPECT_TRUE(is_in_table(id)) << id;
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
