// Pictures as files.
#include <gtest/gtest.h>

#include "app/files/png.h"
#include "tests/folder.h"
#include "tests/full_disk.h"

namespace braitenlab::tests::screenshot_test {
namespace {

std::vector<unsigned char> noise(std::size_t bytes) {
    std::vector<unsigned char> rgb(bytes);
    unsigned state = 1;
    for (unsigned char& byte : rgb) byte = static_cast<unsigned char>((state = state * 1664525u + 1013904223u) >> 24u);
    return rgb;
}

TEST(Screenshot, WritesAPng) {
    const Folder folder;
    ASSERT_FALSE(write_png(folder / "a.png", 8, 4, noise(8 * 4 * 3)));
    EXPECT_EQ(text_of(folder / "a.png").substr(1, 3), "PNG");
}

TEST(Screenshot, KeepsTheOldPictureIfTheDiskIsFull) {
    if (!can_limit_files) GTEST_SKIP() << "this system has no limit on the size of files";
    const Folder folder;
    put_text(folder / "a.png", "old");
    {
        const FullDisk full_disk;
        EXPECT_TRUE(write_png(folder / "a.png", 64, 64, noise(64 * 64 * 3)));
    }
    EXPECT_EQ(text_of(folder / "a.png"), "old");
}

}  // namespace
}  // namespace braitenlab::tests::screenshot_test
