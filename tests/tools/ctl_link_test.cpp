// braitenctl link: there and back.
#include <string>

#include <gtest/gtest.h>

#include "core/io/link.h"
#include "core/scene/scene_file.h"
#include "tests/folder.h"
#include "tests/shell.h"

namespace braitenlab::tests::ctl_link_test {
namespace {

Ran ctl_link(const std::string& arguments) { return ctl("link " + arguments); }

TEST(CtlLink, PrintsALinkAndWritesItsSceneAgain) {
    const Folder folder;
    const auto [printed, link] = ctl_link("3a-love --base https://lab.example/");
    EXPECT_EQ(printed, 0);
    EXPECT_TRUE(link.starts_with("https://lab.example/#b1.")) << link;
    const fs::path file = folder / "love.toml";
    EXPECT_EQ(ctl_link("'" + link + "' --out " + file.string()).code, 0);
    const Scene shipped = *load_scene(BRAITENLAB_SOURCE "/exercises/scenes/3a-love.toml");
    EXPECT_EQ(*load_scene(file), shipped);
    EXPECT_EQ(ctl_link("'" + link + "'").out, text_of(file)) << "without --out to standard output";
}

TEST(CtlLink, NamesAShippedExercise) { EXPECT_EQ(ctl_link("05-aggressor").out, "#e1.05-aggressor\n"); }

TEST(CtlLink, RefusesBadInputWithCodeTwo) {
    for (const char* bad : {"no-such-scene", "'#b1.eNp'", "'#b9.abc'", "'#e1.05-aggressor'", ""})
        EXPECT_EQ(ctl_link(std::string(bad)).code, 2) << bad;
}

}  // namespace
}  // namespace braitenlab::tests::ctl_link_test
