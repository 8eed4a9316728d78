#include "core/scene/file_kind.h"

#include <gtest/gtest.h>

#include "core/result.h"
#include "tests/folder.h"

namespace braitenlab::tests::file_kind_test {
namespace {

TEST(FileKind, IsDetectedByTheTables) {
    EXPECT_EQ(detect_kind("a.toml", "format = 1\n[arena]\n"), FileKind::scene);
    EXPECT_EQ(detect_kind("a.toml", "format = 1\n[kind.one.brain]\n"), FileKind::scene);
    EXPECT_EQ(detect_kind("a.toml", "format = 1\n[brain]\nLL = 1\n"), FileKind::brain);
    EXPECT_EQ(detect_kind("a.toml", "format = 1\n[set]\n[[step]]\n"), FileKind::exercise);
    EXPECT_EQ(detect_kind("a.toml", "  [[step]]\n"), FileKind::exercise) << "indented";
    EXPECT_EQ(detect_kind("a.toml", "scene = \"x\"\n[[page]]\n"), FileKind::lecture);
    EXPECT_EQ(detect_kind("a.toml", "scene = \"x\"\n[[value]]\n"), FileKind::study);
    EXPECT_EQ(detect_kind("a.toml", "scene = \"x\"\n[[breed]]\n[[breed.gene]]\n"), FileKind::breeding);
    EXPECT_EQ(detect_kind("a.toml", ""), FileKind::scene);
}

TEST(FileKind, IsARunByTheExtensionAlone) { EXPECT_EQ(detect_kind("a.run", "[[step]]"), FileKind::run); }

TEST(FileKind, IsDetectedInMalformedText) {
    EXPECT_EQ(detect_kind("a.toml", "[[step]]\ngoal = \"\n"), FileKind::exercise);
    EXPECT_EQ(detect_kind("a.toml", "[brain\nLL = "), FileKind::brain);
    EXPECT_EQ(detect_kind("a.toml", "[step]\n"), FileKind::exercise);
    EXPECT_EQ(detect_kind("a.toml", "[value]\n"), FileKind::study);
}

TEST(FileKind, KnowsFilesOfOtherProgramsByTheirFirstBytes) {
    EXPECT_EQ(foreign_format("PK\x03\x04"), "ZIP");
    EXPECT_EQ(foreign_format("\x7F"
                             "ELF"),
              "ELF");
    EXPECT_EQ(foreign_format("<?xml version=\"1.0\"?>"), "XML");
    for (const char* text : {"", "P", "<<<<<<< HEAD\n", "PK = 1\n", "# %PDF-\n", "format = 1\n", "[arena]\n"})
        EXPECT_EQ(foreign_format(text), "") << text;
}

TEST(FileKind, ReadTextFailsForAnAbsentFileAndForAFolder) {
    const Folder folder;
    put_text(folder / "a.toml", "format = 1\n");
    EXPECT_EQ(*read_text(folder / "a.toml"), "format = 1\n");
    EXPECT_FALSE(read_text(folder / "b.toml"));
    EXPECT_FALSE(read_text(folder.path));
}

}  // namespace
}  // namespace braitenlab::tests::file_kind_test
