#include "core/scene/folder_entries.h"

#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/folder.h"

namespace braitenlab::tests::folder_entries_test {
namespace {

TEST(FolderEntries, AreVisitedOnceEach) {
    const Folder folder;
    put_text(folder / "a", ""), put_text(folder / "b", "");
    int visited = 0;
    for_each_entry(folder.path, [&](const fs::directory_entry&) { ++visited; });
    EXPECT_EQ(visited, 2);
    for_each_entry(folder / "absent", [&](const fs::directory_entry&) { ADD_FAILURE(); });
}

// Closes the descriptor by which this process reads a folder, so that reading on fails.
void break_reading(const fs::path& folder) {
    for (int descriptor = 3; descriptor < 256; ++descriptor) {
        std::error_code none;
        if (fs::read_symlink("/proc/self/fd/" + std::to_string(descriptor), none) == folder) close(descriptor);
    }
}

TEST(FolderEntries, EndWithoutAnExceptionIfReadingFails) {
    if (!fs::is_symlink("/proc/self/fd/0")) GTEST_SKIP() << "the system does not show the open files";
    const Folder folder;
    constexpr int files = 3000;  // more than the system reads at once
    for (int i = 0; i < files; ++i) put_text(folder / ("a file with a long name " + std::to_string(i)), "");
    int visited = 0;
    EXPECT_NO_THROW(for_each_entry(folder.path, [&](const fs::directory_entry&) {
        if (visited++ == 0) break_reading(folder.path);
    }));
    EXPECT_GT(visited, 0);
    EXPECT_LT(visited, files);
}

}  // namespace
}  // namespace braitenlab::tests::folder_entries_test
