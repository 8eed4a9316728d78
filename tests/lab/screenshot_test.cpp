// Pictures as files.
#include "app/files/screenshot.h"

#include <csignal>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "tests/folder.h"

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

// A limit on the size of files simulates a full disk.
TEST(Screenshot, KeepsTheOldPictureIfTheDiskIsFull) {
    const Folder folder;
    put_text(folder / "a.png", "old");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const auto error = write_png(folder / "a.png", 64, 64, noise(64 * 64 * 3));
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, old_handler);
    EXPECT_TRUE(error);
    EXPECT_EQ(text_of(folder / "a.png"), "old");
}

TEST(Screenshot, ChoosesTheNextFreeName) {
    const Folder folder;
    EXPECT_EQ(next_screenshot_name(folder.path), folder / "braitenlab-001.png");
    put_text(folder / "braitenlab-001.png", "");
    EXPECT_EQ(next_screenshot_name(folder.path), folder / "braitenlab-002.png");
}

}  // namespace
}  // namespace braitenlab::tests::screenshot_test
