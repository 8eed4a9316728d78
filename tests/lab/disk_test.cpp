// Typed paths and the names of files.
#include "app/files/disk.h"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/folder.h"

namespace braitenlab::tests::disk_test {
namespace {

TEST(Disk, ResolvesATypedPathFromTheFolderOrTheHomeFolder) {
    EXPECT_EQ(resolved("~/a.toml", "/f", "/home/me"), "/home/me/a.toml");
    EXPECT_EQ(resolved("~", "/f", "/home/me"), "/home/me/");
    EXPECT_EQ(resolved("a/../b.toml", "/f", "/home/me"), "/f/b.toml");
    EXPECT_EQ(resolved("/b.toml", "/f", "/home/me"), "/b.toml");
}

TEST(Disk, AppendsTheExtensionOfTheKind) {
    EXPECT_EQ(with_extension("/a", FileKind::scene), "/a.toml");
    EXPECT_EQ(with_extension("/a.toml", FileKind::brain), "/a.toml");
    EXPECT_EQ(with_extension("/a.b", FileKind::run), "/a.b.run");
}

TEST(Disk, ListsAFolderWithAFileThatOverflowsTheParser) {
    const Folder folder;
    std::string dots = "a";
    for (int i = 0; i < 400000; ++i) dots += ".a";
    put_text(folder / "deep.toml", dots + " = 1\n");
    put_text(folder / "scene.toml", "format = 1\n");
    const FolderListing listing = list_folder(folder.path);
    ASSERT_EQ(listing.entries.size(), 2u);
    EXPECT_TRUE(listing.entries[0].broken);
    EXPECT_FALSE(listing.entries[1].broken);
}

TEST(Disk, ParsesNoMoreOfAFolderThanAFrameHasTimeFor) {
    const Folder folder;
    std::string text = "format = 1\n";
    for (int i = 0; text.size() < 200000; ++i) text += fmt::format("unknown_key_{} = 1\n", i);
    for (int i = 0; i < 60; ++i) put_text(folder / fmt::format("{}.toml", i), text);
    const auto entries = list_folder(folder.path).entries;
    EXPECT_EQ(entries.size(), 60u);
    const auto broken =
        std::count_if(entries.begin(), entries.end(), [](const FileEntry& each) { return each.broken; });
    EXPECT_GT(broken, 0);
    EXPECT_LT(broken, 60) << "the others count as sound until they are opened";
}

TEST(Disk, ListsALargeFileByItsHead) {
    const Folder folder;
    const std::string filling(2u << 20u, '\n');
    put_text(folder / "1.toml", "format = 1\n[[step]]\n" + filling);
    put_text(folder / "2.toml", "format = 1\n" + filling + "[[step]]\n");
    put_text(folder / "3.toml", filling + "format = 1\n");
    const auto entries = list_folder(folder.path).entries;
    ASSERT_EQ(entries.size(), 2u) << "no line of the head tells that the third one is a file of the lab";
    EXPECT_EQ(entries[0].kind, FileKind::exercise);
    EXPECT_EQ(entries[1].kind, FileKind::scene) << "its table is not read before the file is opened";
}

}  // namespace
}  // namespace braitenlab::tests::disk_test
