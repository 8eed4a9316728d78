#include "core/lesson/submitter.h"

#include <gtest/gtest.h>

namespace braitenlab::tests::submitter_test {
namespace {

TEST(Submitter, MoodleNamesAFolderForEachPerson) {
    const Submitter expected{"Müller Anna_12345_assignsubmission_file_", "12345", "Müller Anna", "Müller Anna_12345"};
    EXPECT_EQ(submitter_of("Müller Anna_12345_assignsubmission_file_/a.toml"), expected);
    EXPECT_EQ(submitter_of("Class/Müller Anna_12345_assignsubmission_file_/sub/a.toml"), expected);
    EXPECT_EQ(submitter_of("Müller Anna_12345_assignsubmission_onlinetext_/onlinetext.txt").person, expected.person)
        << "a text of the same person";
}

TEST(Submitter, MoodleWithoutFoldersBeginsTheNameOfTheFile) {
    const Submitter found = submitter_of("Müller Anna_12345_assignsubmission_file_05-aggressor.toml");
    EXPECT_EQ(found, (Submitter{"", "12345", "Müller Anna", "Müller Anna_12345"}));
}

TEST(Submitter, IliasNamesAFolderByNameLoginAndNumber) {
    EXPECT_EQ(submitter_of("Sheet 1/Mueller_Anna_amueller_2711/20261122_a.toml"),
              (Submitter{"Mueller_Anna_amueller_2711", "2711", "Mueller Anna", "Mueller_Anna_amueller_2711", "Mueller",
                         "Anna", "amueller"}));
    const Submitter two = submitter_of("Mueller_Anna_Maria_am_7/a.toml");
    EXPECT_EQ(two.name, "Mueller Anna Maria");
    EXPECT_EQ(two.last_name + "," + two.first_name + "," + two.login, "Mueller,Anna Maria,am");
    EXPECT_EQ(submitter_of("Mueller_Anna_amueller_2711").person, "") << "a file, not a folder";
}

TEST(Submitter, CanvasBeginsTheNameOfTheFile) {
    EXPECT_EQ(submitter_of("muelleranna_4711_99001_05-aggressor-anna.braiten-handin-1.toml"),
              (Submitter{"", "4711", "muelleranna", "muelleranna_4711"}));
    EXPECT_EQ(submitter_of("muelleranna_LATE_4711_99001_a.toml").id, "4711");
}

TEST(Submitter, OtherPathsTellTheFirstFolderOnly) {
    EXPECT_EQ(submitter_of("anna/second try/a.toml"), (Submitter{"anna", "", "", ""}));
    EXPECT_EQ(submitter_of("05-aggressor-ana-lopez.braiten-handin.toml"), Submitter{});
    EXPECT_EQ(submitter_of("my_second_try.toml"), Submitter{});
    EXPECT_EQ(submitter_of(""), Submitter{});
}

TEST(Submitter, FoldersAroundTheWholeClassAreNoPerson) {
    const std::vector<std::string> wrapped{"Sheet/hand-ins/anna/a.toml", "Sheet/hand-ins/ben/b.toml"};
    EXPECT_EQ(wrapped[0].substr(folders_around(wrapped)), "anna/a.toml");
    EXPECT_EQ(folders_around({"a.toml", "anna/b.toml"}), 0u);
    EXPECT_EQ(folders_around({"Müller Anna_12345_assignsubmission_file_/a.toml"}), 0u) << "the only student";
    EXPECT_EQ(folders_around({}), 0u);
}

}  // namespace
}  // namespace braitenlab::tests::submitter_test
