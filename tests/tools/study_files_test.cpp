// Files of studies: the shipped ones with their scenes, and a table that is interrupted and continued.
#include "app/files/study_files.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "app/files/breeding_files.h"
#include "app/files/data.h"
#include "tests/folder.h"
#include "tests/tells.h"

namespace braitenlab::tests::study_files_test {
namespace {

using insight::StudyBase;
using insight::StudyRow;

std::shared_ptr<const StudyBase> study_in(const fs::path& folder, const std::string& levels) {
    const fs::path path = folder / "study.toml";
    std::ofstream(path)
        << "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nseconds = 1\nseeds = 2\n"
           "measures = [\"final\"]\n[[value]]\nname = \"mass\"\npaths = [\"kind.aggressor.body.mass\"]\n"
           "levels = "
        << levels << "\n";
    const auto base = load_study(path);
    EXPECT_TRUE(base) << base.error().text();
    return *base;
}

std::string whole_table(const std::shared_ptr<const StudyBase>& base) {
    StudyTable table(base, "");
    EXPECT_FALSE(table.begin());
    for (std::size_t run = 0; run < base->study().runs(); ++run) EXPECT_FALSE(table.add({insight::run_of(base, run)}));
    return table.text();
}

TEST(StudyFiles, HaveTheSceneBesideThemOrAShippedOne) {
    const Folder folder;
    study_in(folder.path, "[5]");
    fs::copy_file(*find_shipped("2b-aggressor"), folder.path / "own.toml");
    std::ofstream(folder.path / "b.toml") << "format = 1\ntitle = \"T\"\nscene = \"own.toml\"\nmeasures = [\"final\"]\n"
                                             "[[value]]\nname = \"m\"\npaths = [\"arena.grip\"]\nlevels = [1]\n";
    EXPECT_TRUE(load_study(folder.path / "b.toml"));
    std::ofstream(folder.path / "c.toml")
        << "format = 1\ntitle = \"T\"\nscene = \"2b-agressor\"\nmeasures = [\"final\"]\n"
           "[[value]]\nname = \"m\"\npaths = [\"arena.grip\"]\nlevels = [1]\n";
    const auto wrong = load_study(folder.path / "c.toml");
    ASSERT_FALSE(wrong);
    EXPECT_NE(wrong.error().text().find("2b-aggressor"), std::string::npos) << wrong.error().text();
    const std::string place = (folder.path / "c.toml").string() + ":3: ";
    EXPECT_TRUE(wrong.error().text().starts_with(place)) << wrong.error().text();
    const std::vector<Error> all = errors_of_study(folder.path / "c.toml");
    ASSERT_EQ(all.size(), 1u);
    EXPECT_TRUE(all[0].text().starts_with(place)) << all[0].text();
    std::ofstream(folder.path / "d.toml") << "format = 1\ntitle = \"T\"\nscene = \"chase-arina\"\n";
    bool has_line = false;
    for (const Error& each : errors_of_breeding(folder.path / "d.toml"))
        has_line |= each.text().find("chase-arina") != std::string::npos && each.line == 3;
    EXPECT_TRUE(has_line) << "the scene of a breeding, too";
}

TEST(StudyTable, GoesOnAfterAnInterruptionInTheMiddleOfALine) {
    const Folder folder;
    const auto base = study_in(folder.path, "[5, 10]");
    const std::string path = (folder.path / "t.csv").string(), part = path + ".part";
    {
        StudyTable table(base, path);
        ASSERT_FALSE(table.begin());
        ASSERT_FALSE(table.add({insight::run_of(base, 0), insight::run_of(base, 1)}));
        EXPECT_FALSE(fs::exists(path));
    }
    std::ofstream(part, std::ios::app) << "3,1,10,1.2";
    StudyTable table(base, path);
    ASSERT_FALSE(table.begin());
    EXPECT_EQ(table.rows().size(), 2u);
    ASSERT_FALSE(table.add({insight::run_of(base, 2), insight::run_of(base, 3)}));
    ASSERT_FALSE(table.finish());
    EXPECT_EQ(text_of(path), whole_table(base));
    EXPECT_FALSE(fs::exists(part));
}

TEST(StudyTable, OfAnotherStudyBeginsAnewOnlyWhereItMayMakeRoom) {
    const Folder folder;
    const std::string path = (folder.path / "t.csv").string(), part = path + ".part";
    {
        const auto base = study_in(folder.path, "[5, 10]");
        StudyTable table(base, path);
        ASSERT_FALSE(table.begin());
        ASSERT_FALSE(table.add({insight::run_of(base, 0)}));
    }
    const std::string runs = text_of(part);
    const auto other = study_in(folder.path, "[5, 11]");
    {
        StudyTable table(other, path);
        const auto refused = table.begin();
        ASSERT_TRUE(refused);
        EXPECT_EQ(refused->file, part);
        EXPECT_TRUE(tells(*refused, message_of("unfinished_of_other")));
    }
    EXPECT_EQ(text_of(part), runs);
    StudyTable table(other, path, OtherRuns::make_room);
    ASSERT_FALSE(table.begin());
    EXPECT_TRUE(table.rows().empty());
}

TEST(StudyTable, KeepsAFileOfItsUnfinishedTablesNameThatIsNone) {
    const Folder folder;
    const auto base = study_in(folder.path, "[5]");
    const std::string path = (folder.path / "t.csv").string();
    for (const std::string text : {"mine\n", "# study\n", "# my study\n"}) {
        std::ofstream(path + ".part") << text;
        std::ofstream(path + ".part.lock") << text;
        for (const OtherRuns other : {OtherRuns::stay, OtherRuns::make_room}) {
            StudyTable table(base, path, other);
            const auto refused = table.begin();
            ASSERT_TRUE(refused);
            EXPECT_TRUE(tells(*refused, message_of("not_unfinished")));
        }
        EXPECT_EQ(text_of(path + ".part"), text);
        EXPECT_EQ(text_of(path + ".part.lock"), text);
    }
    std::ofstream(path + ".part").close();
    StudyTable table(base, path);
    EXPECT_FALSE(table.begin()) << "nothing is in it";
}

TEST(StudyTable, OfTwoThatWriteOneFileTheSecondIsRefused) {
    const Folder folder;
    const auto base = study_in(folder.path, "[5, 10]");
    const std::string path = (folder.path / "t.csv").string();
    StudyTable first(base, path), second(base, path);
    ASSERT_FALSE(first.begin());
    ASSERT_FALSE(first.add({{1}}));
    const auto refused = second.begin();
    ASSERT_TRUE(refused);
    EXPECT_NE(refused->text().find("t.csv.part: another study writes this table"), std::string::npos);
    EXPECT_NE(text_of(first.unfinished()).find("\n1,1,"), std::string::npos) << "the runs of the first are kept";
    { const StudyTable ended = std::move(first); }
    EXPECT_FALSE(second.begin());
    EXPECT_EQ(second.rows().size(), 1u);
}

TEST(StudyTable, SaysThatItCannotBeWritten) {
    const Folder folder;
    StudyTable onto_folder(study_in(folder.path, "[5]"), (folder.path / "sub").string());
    fs::create_directories(folder.path / "sub.part");
    EXPECT_TRUE(onto_folder.begin());
}

}  // namespace
}  // namespace braitenlab::tests::study_files_test
