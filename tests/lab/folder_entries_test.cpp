#include "app/files/folder_entries.h"

#include <csignal>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
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

// The folder of a process disappears with it; reading on fails in the middle.
TEST(FolderEntries, EndWithoutAnExceptionWhereAFolderCanNoLongerBeRead) {
    const pid_t child = fork();
    if (child == 0) {
        pause();
        _exit(0);
    }
    int visited = 0;
    EXPECT_NO_THROW(for_each_entry("/proc/" + std::to_string(child) + "/fd", [&](const fs::directory_entry&) {
        if (visited++ > 0) return;
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
    }));
    EXPECT_GT(visited, 0);
}

}  // namespace
}  // namespace braitenlab::tests::folder_entries_test
