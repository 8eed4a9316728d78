// The order in which the file browser gets its pictures.
#include <gtest/gtest.h>

#include "app/files/data.h"
#include "ui/lab_view.h"

namespace braitenlab::tests::files_by_turns_test {

TEST(FilesByTurns, ShowTheBeginningOfBothListsFirst) {
    const auto entry = [](const char* path, int number) {
        CatalogueEntry made;
        made.path = path, made.number = number;
        return made;
    };
    const std::vector<CatalogueEntry> catalogue{entry("1", 1), entry("2", 2), entry("3", 3), entry("a", 0),
                                                entry("b", 0)};
    EXPECT_EQ(files_by_turns(catalogue), (std::vector<std::string>{"1", "a", "2", "b", "3"}));
    EXPECT_TRUE(files_by_turns({}).empty());
}

TEST(FindShipped, NamesTheNearestOfAllAndListsNone) {
    const auto missing = find_shipped("nonsense");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().text().find("; the nearest is '"), std::string::npos) << missing.error().text();
    EXPECT_EQ(missing.error().text().find("', '"), std::string::npos) << missing.error().text();
}

TEST(Catalogue, ListsTheScenesOfRobotsByTheNameOfTheirFile) {
    const std::vector<CatalogueEntry> catalogue = read_catalogue();
    for (const auto& path : shipped_robots())
        EXPECT_EQ(std::count_if(catalogue.begin(), catalogue.end(),
                                [&](const CatalogueEntry& entry) {
                                    return entry.name == path.stem().string() && entry.number == 0 &&
                                           !entry.title.empty();
                                }),
                  1)
            << path;
    EXPECT_GE(shipped_robots().size(), 4u);
}

}  // namespace braitenlab::tests::files_by_turns_test
