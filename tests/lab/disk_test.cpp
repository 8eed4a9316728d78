// Typed paths and the names of files.
#include "app/files/disk.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace braitenlab::tests::disk_test
