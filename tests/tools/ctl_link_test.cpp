// braitenctl link: there and back.
#include <cstdio>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "core/io/link.h"
#include "core/scene/scene_file.h"
#include "tests/folder.h"

namespace braitenlab::tests::ctl_link_test {
namespace {

std::pair<int, std::string> ctl_link(const std::string& arguments) {
    FILE* pipe = popen((BRAITENLAB_BINARY "/braitenctl link " + arguments).c_str(), "r");
    std::string out;
    char buffer[4096];
    for (std::size_t n = 0; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) out.append(buffer, n);
    return {WEXITSTATUS(pclose(pipe)), out};
}

TEST(CtlLink, PrintsALinkAndWritesItsSceneAgain) {
    const Folder folder;
    const auto [printed, link] = ctl_link("3a-love --base https://lab.example/");
    EXPECT_EQ(printed, 0);
    EXPECT_TRUE(link.starts_with("https://lab.example/#b1.")) << link;
    const fs::path file = folder / "love.toml";
    EXPECT_EQ(ctl_link("'" + link + "' --out " + file.string()).first, 0);
    const Scene shipped = *load_scene(BRAITENLAB_SOURCE "/exercises/scenes/3a-love.toml");
    EXPECT_EQ(*load_scene(file), shipped);
    EXPECT_EQ(ctl_link("'" + link + "'").second, text_of(file)) << "without --out to standard output";
}

TEST(CtlLink, NamesAShippedExercise) { EXPECT_EQ(ctl_link("05-aggressor").second, "#e1.05-aggressor\n"); }

TEST(CtlLink, RefusesBadInputWithCodeTwo) {
    for (const char* bad : {"no-such-scene", "'#b1.eNp'", "'#b9.abc'", "'#e1.05-aggressor'", ""})
        EXPECT_EQ(ctl_link(std::string(bad) + " 2>/dev/null").first, 2) << bad;
}

}  // namespace
}  // namespace braitenlab::tests::ctl_link_test
