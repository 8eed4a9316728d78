#include "app/files/safe_file.h"

#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "core/messages.h"
#include "tests/folder.h"
#include "tests/full_disk.h"

namespace braitenlab::tests::safe_file_test {
namespace {

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename().string());
    return names;
}

TEST(SafeFile, WritesTheTextAndCreatesMissingFolders) {
    const Folder folder;
    const auto file = folder / "a" / "b" / "scene.toml";
    EXPECT_FALSE(write_whole(file, "one"));
    EXPECT_FALSE(write_whole(file, "two"));
    EXPECT_EQ(text_of(file), "two");
    EXPECT_EQ(names_in(file.parent_path()), std::set<std::string>{"scene.toml"}) << "no temporary file is left";
}

TEST(SafeFile, WritesANameOfEachLengthThatTheSystemAllows) {
    const Folder folder;
    for (const std::size_t length : {199u, 201u, 255u}) {
        const auto file = folder / std::string(length, 'n');
        EXPECT_FALSE(write_whole(file, "text"));
        EXPECT_EQ(text_of(file), "text") << length;
    }
}

TEST(SafeFile, DoesNotChangeTheTextOfAnOpenReader) {
    if (fs::path::preferred_separator == '\\') GTEST_SKIP() << "Windows does not replace files that are open";
    const Folder folder;
    const auto file = folder / "scene.toml";
    ASSERT_FALSE(write_whole(file, "old"));
    std::ifstream reader(file);
    ASSERT_FALSE(write_whole(file, "new"));
    EXPECT_EQ((std::string{std::istreambuf_iterator<char>(reader), {}}), "old");
}

TEST(SafeFile, KeepsTheOldFileIfTheDiskIsFull) {
    if (!can_limit_files) GTEST_SKIP() << "this system has no limit on the size of files";
    const Folder folder;
    const auto file = folder / "scene.toml";
    ASSERT_FALSE(write_whole(file, "old"));
    const auto error = [&] {
        const FullDisk full_disk;
        return write_whole(file, std::string(100000, 'x'));
    }();
    ASSERT_TRUE(error);
    EXPECT_NE(error->what.find("make room"), std::string::npos) << error->text();
    EXPECT_EQ(error->file, file.string());
    EXPECT_EQ(text_of(file), "old");
    EXPECT_EQ(names_in(folder.path), std::set<std::string>{"scene.toml"});
}

TEST(SafeFile, SaysThatTheOldFileIsUnchangedOnlyWhereThereIsOne) {
    const Folder folder;
    const auto says = [](const std::optional<Error>& error) {
        return error && error->what.ends_with(message_of("old_file_stays").text);
    };
    EXPECT_FALSE(says(write_whole(folder.path, "text"))) << "a folder";
    put_text(folder / "file", "old");
    EXPECT_FALSE(says(write_whole(folder / "file" / "below", "text")));
    if (!can_limit_files) return;
    const std::string large(100000, 'x');
    const FullDisk full_disk;
    EXPECT_FALSE(says(write_whole(folder / "new", large)));
    EXPECT_TRUE(says(write_whole(folder / "file", large)));
}

TEST(SafeFile, WritesAllOfSeveralFilesOrNone) {
    if (!can_limit_files) GTEST_SKIP() << "this system has no limit on the size of files";
    const Folder folder;
    const std::string small = "new", large(100000, 'x');
    ASSERT_FALSE(write_whole(folder / "a.ino", "old"));
    const std::vector<NewFile> wanted{
        {folder / "a.ino", small}, {folder / "robot" / "deep" / "b.md", small}, {folder / "c.csv", large}};
    const auto error = [&] {
        const FullDisk full_disk;
        return write_all(wanted);
    }();
    ASSERT_TRUE(error);
    EXPECT_EQ(error->file, (folder / "c.csv").string());
    EXPECT_EQ(text_of(folder / "a.ino"), "old");
    EXPECT_EQ(names_in(folder.path), std::set<std::string>{"a.ino"}) << "no folder is left";
    ASSERT_FALSE(write_all(wanted));
    EXPECT_EQ(text_of(folder / "a.ino"), small);
    EXPECT_EQ(text_of(folder / "robot" / "deep" / "b.md"), small);
    EXPECT_EQ(text_of(folder / "c.csv"), large);
}

TEST(SafeFile, FollowsALinkAndKeepsPermissions) {
    const Folder folder;
    const auto file = folder / "real.toml", link = folder / "link.toml";
    ASSERT_FALSE(write_whole(file, "old"));
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    std::error_code refused;
    fs::create_symlink(file, link, refused);
    if (refused) GTEST_SKIP() << "this system allows no links";
    EXPECT_FALSE(write_whole(link, "new"));
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(text_of(file), "new");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(SafeFile, FollowsLinksToAFileThatDoesNotExist) {
    const Folder folder;
    const auto link = folder / "link.csv", second = folder / "second.csv";
    std::error_code refused;
    fs::create_symlink("new/file.csv", link, refused);  // relative to the link
    if (refused) GTEST_SKIP() << "this system allows no links";
    fs::create_symlink(link, second);
    EXPECT_FALSE(write_whole(second, "one"));
    EXPECT_TRUE(fs::is_symlink(link) && fs::is_symlink(second));
    EXPECT_EQ(text_of(folder / "new" / "file.csv"), "one");
}

TEST(SafeFile, RefusesLinksInACircle) {
    const Folder folder;
    const auto link = folder / "a.csv", back = folder / "b.csv";
    std::error_code refused;
    fs::create_symlink(back, link, refused);
    if (refused) GTEST_SKIP() << "this system allows no links";
    fs::create_symlink(link, back);
    EXPECT_TRUE(write_whole(link, "text"));
    EXPECT_TRUE(FileWriter(back).problem());
    EXPECT_EQ(names_in(folder.path), (std::set<std::string>{"a.csv", "b.csv"}));
    EXPECT_TRUE(fs::is_symlink(link) && fs::is_symlink(back));
}

TEST(SafeFile, RefusesTheFoldersOfTheSystem) {
    if (fs::path::preferred_separator == '\\') GTEST_SKIP() << "Windows has no such folders";
    const Folder folder;
    for (const char* file : {"/dev/x.csv", "/dev/fd/x.csv", "/proc/x.csv", "/sys/x.csv", "/tmp/../dev/x.csv"}) {
        SCOPED_TRACE(file);
        EXPECT_TRUE(replacement_fault(file));  // asked only: no test writes there
        fs::remove(folder / "link.csv");
        fs::create_symlink(file, folder / "link.csv");
        EXPECT_TRUE(replacement_fault(folder / "link.csv"));
    }
    EXPECT_FALSE(replacement_fault("/dev/shm/x.csv"));
    EXPECT_FALSE(replacement_fault(folder / "dev" / "x.csv"));
}

TEST(SafeFile, RefusesAFolderAndAPlaceBelowAFile) {
    const Folder folder;
    ASSERT_FALSE(write_whole(folder / "file", "text"));
    EXPECT_TRUE(write_whole(folder.path, "text"));
    EXPECT_TRUE(write_whole(folder / "file" / "below", "text"));
    EXPECT_EQ(text_of(folder / "file"), "text");
}

TEST(SafeFile, TheNextFreeNameIsNoFileOfTheFolder) {
    const Folder folder;
    EXPECT_EQ(free_name(folder.path, "picture", ".png"), folder / "picture-001.png");
    put_text(folder / "picture-001.png", "");
    EXPECT_EQ(free_name(folder.path, "picture", ".png"), folder / "picture-002.png");
}

}  // namespace
}  // namespace braitenlab::tests::safe_file_test
