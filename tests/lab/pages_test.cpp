// Pages of the manual: opened by the system's program, else their path is copied.
#include "app/files/pages.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/lab_requests.h"
#include "tests/folder.h"

namespace braitenlab::tests::pages_test {
namespace {

#ifndef _WIN32
// PATH with one folder, and the former one again at the end.
struct Pages : testing::Test {
    Folder folder;
    std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
    Lab lab = std::move(*open_lab(*find_shipped("21-reality"), std::nullopt, {}));

    Pages() { setenv("PATH", folder.path.c_str(), 1); }
    ~Pages() override { setenv("PATH", path.c_str(), 1); }
};

TEST_F(Pages, OpenWithTheProgramOfTheSystem) {
    const auto opener = folder / "xdg-open", told = folder / "told";
    std::ofstream(opener) << "#!/bin/sh\necho \"$1\" > " << told.string() << "\n";
    std::filesystem::permissions(opener, std::filesystem::perms::owner_all);
    handle(lab, PageRequest{"docs/robots.md"});
    EXPECT_TRUE(lab.window.to_copy.empty());
    std::string line;
    for (int i = 0; i < 500 && line.empty(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        std::ifstream file(told);
        std::getline(file, line);
    }
    EXPECT_EQ(line, (*data_folder() / "docs/robots.md").string());
}

TEST_F(Pages, OfAnExportAreAFolderThatIsOpenedOrItsPathIsCopied) {
    const auto opener = folder / "xdg-open", file = folder / "brain.h";
    handle(lab, OpenFolderRequest{folder.path.string()});
    EXPECT_EQ(lab.window.to_copy, folder.path.string()) << "there is no program";
    std::ofstream(opener) << "#!/bin/sh\nexit 0\n";
    std::filesystem::permissions(opener, std::filesystem::perms::owner_all);
    std::ofstream(file) << "a file";
    for (const auto& each : {folder.path, file}) {
        lab.window.to_copy.clear();
        handle(lab, OpenFolderRequest{each.string()});
        EXPECT_EQ(lab.window.to_copy.empty(), each == folder.path) << each << ": a file is not run";
    }
}

TEST_F(Pages, CopyTheirPathWithoutAProgramAndDoNothingForOtherFiles) {
    handle(lab, PageRequest{"docs/robots.md"});
    EXPECT_EQ(lab.window.to_copy, (*data_folder() / "docs/robots.md").string());
    lab.window.to_copy.clear();
    handle(lab, PageRequest{"docs/no-such-page.md"});
    EXPECT_EQ(lab.window.to_copy, "docs/no-such-page.md");
    lab.window.to_copy.clear();
    for (const char* other : {"/etc/passwd", "docs/../README.md", "see docs/robots.md"}) {
        handle(lab, PageRequest{other});
        EXPECT_TRUE(lab.window.to_copy.empty()) << other;
    }
}
TEST_F(Pages, AreNotOpenedByAProgramThatFindsNone) {
    const auto opener = folder / "xdg-open", file = folder / "page.html";
    for (const auto& [ending, opens] : {std::pair{"exit 0", true}, {"exit 3", false}, {"exec /bin/sleep 5", true}}) {
        std::ofstream(opener) << "#!/bin/sh\n" << ending << "\n";
        std::filesystem::permissions(opener, std::filesystem::perms::owner_all);
        EXPECT_EQ(open_with_system(file), opens) << ending;
    }
}
#endif

}  // namespace
}  // namespace braitenlab::tests::pages_test
