// Files of clips. MP4 and WebM are tried where ffmpeg is installed.
#include "app/pictures/clip_file.h"

#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/platform/platform.h"
#include "tests/folder.h"

namespace braitenlab::tests::clip_file_test {
namespace {

std::vector<unsigned char> grey(int level) {
    return std::vector<unsigned char>(16 * 8 * 3, static_cast<unsigned char>(level));
}

// The names in the folder, hidden ones too.
std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

TEST(ClipFile, IsOfTheFormatOfItsName) {
    EXPECT_EQ(*clip_format_of("a/b.gif"), ClipFormat::gif);
    EXPECT_EQ(*clip_format_of("A.MP4"), ClipFormat::mp4);
    EXPECT_EQ(*clip_format_of("a.webm"), ClipFormat::webm);
    const auto none = clip_format_of("a.png");
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().text().find(".webm"), std::string::npos);
}

TEST(ClipFile, IsWrittenWhenItIsFinished) {
    const Folder folder;
    auto file = ClipFile::begin(folder / "a.gif", ClipFormat::gif, 16, 8, {{0, 0, 0}, {99, 99, 99}});
    ASSERT_TRUE(file) << file.error().text();
    EXPECT_TRUE(file->add(grey(0)));
    EXPECT_TRUE(file->add(grey(99)));
    EXPECT_FALSE(fs::exists(folder / "a.gif"));
    EXPECT_FALSE(file->finish());
    EXPECT_EQ(text_of(folder / "a.gif").substr(0, 3), "GIF");
    EXPECT_EQ(files_in(folder.path), 1U);
}

TEST(ClipFile, LeavesTheOldFileIfItIsNotFinished) {
    const Folder folder;
    put_text(folder / "a.gif", "old");
    {
        auto file = ClipFile::begin(folder / "a.gif", ClipFormat::gif, 16, 8, {{0, 0, 0}});
        ASSERT_TRUE(file);
        file->add(grey(0));
    }
    EXPECT_EQ(text_of(folder / "a.gif"), "old");
    EXPECT_EQ(files_in(folder.path), 1U);
}

TEST(ClipFile, RefusesAFolderThatDoesNotExist) {
    const Folder folder;
    EXPECT_FALSE(ClipFile::begin(folder / "none" / "a.gif", ClipFormat::gif, 16, 8, {{0, 0, 0}}));
}

#if __has_include(<spawn.h>)  // where a script in place of ffmpeg can be run

// Another value of a variable of the environment, until the end of the test.
class Variable {
public:
    Variable(const char* name, const std::string& value) : name_(name), before_(std::getenv(name)) {
        setenv(name, value.c_str(), 1);
    }
    ~Variable() { setenv(name_, before_.c_str(), 1); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

private:
    const char* name_;
    std::string before_;
};

void put_program(const fs::path& file, const std::string& lines) {
    put_text(file, "#!/bin/sh\n" + lines + "\n");
    fs::permissions(file, fs::perms::owner_all);
}

TEST(ClipFile, SaysThatFfmpegIsMissing) {
    const Folder folder;
    const Variable path("PATH", folder.path.string());
    const auto file = ClipFile::begin(folder / "a.mp4", ClipFormat::mp4, 16, 8, {});
    ASSERT_FALSE(file);
    EXPECT_NE(file.error().text().find("ffmpeg"), std::string::npos) << file.error().text();
    EXPECT_NE(file.error().text().find("a.mp4"), std::string::npos) << file.error().text();
}

TEST(ClipFile, PassesPicturesAndTheNameToFfmpegWithoutAShell) {
    const Folder folder;
    put_program(folder / "bin" / "ffmpeg", "for last; do :; done\ncat > \"${last#file:}\"");
    const Variable path("PATH", (folder / "bin").string() + ":" + std::getenv("PATH"));
    const fs::path wanted = folder / "-a b; touch $(x) 'ä.mp4";
    auto file = ClipFile::begin(wanted, ClipFormat::mp4, 16, 8, {});
    ASSERT_TRUE(file) << file.error().text();
    EXPECT_TRUE(file->add(grey(7)));
    EXPECT_TRUE(file->add(grey(9)));
    EXPECT_FALSE(fs::exists(wanted));
    EXPECT_FALSE(file->finish());
    EXPECT_EQ(text_of(wanted), std::string(16 * 8 * 3, '\x07') + std::string(16 * 8 * 3, '\x09'));
    EXPECT_EQ(files_in(folder.path), 2U);
}

TEST(ClipFile, RepeatsWhatFfmpegComplainsAbout) {
    const Folder folder;
    put_program(folder / "bin" / "ffmpeg", "echo first >&2; echo 'Unknown encoder libx264' >&2; exit 1");
    put_text(folder / "a.mp4", "old");
    const Variable path("PATH", (folder / "bin").string() + ":" + std::getenv("PATH"));
    auto file = ClipFile::begin(folder / "a.mp4", ClipFormat::mp4, 16, 8, {});
    ASSERT_TRUE(file);
    for (int i = 0; i < 2000 && file->add(grey(7)); ++i) {  // its input is closed: a write fails
    }
    const auto error = file->finish();
    ASSERT_TRUE(error);
    EXPECT_NE(error->text().find("Unknown encoder libx264"), std::string::npos) << error->text();
    EXPECT_EQ(text_of(folder / "a.mp4"), "old");
    EXPECT_EQ(files_in(folder.path), 2U);
}

TEST(ClipFile, EndsFfmpegIfItIsNotFinished) {
    const Folder folder;
    put_program(folder / "bin" / "ffmpeg", "for last; do :; done\necho part > \"${last#file:}\"; exec sleep 60");
    const Variable path("PATH", (folder / "bin").string() + ":" + std::getenv("PATH"));
    {
        auto file = ClipFile::begin(folder / "a.mp4", ClipFormat::mp4, 16, 8, {});
        ASSERT_TRUE(file);
        EXPECT_TRUE(file->add(grey(7)));
    }
    EXPECT_EQ(files_in(folder.path), 1U) << "the folder of the program";
}

#endif

TEST(ClipFile, IsAVideoByTheInstalledFfmpeg) {
    if (!can_write(ClipFormat::mp4)) GTEST_SKIP() << "ffmpeg is not installed";
    const Folder folder;
    for (const ClipFormat format : {ClipFormat::mp4, ClipFormat::webm}) {
        const fs::path wanted = folder / ("a" + std::string(row_of(format).extension));
        auto file = ClipFile::begin(wanted, format, 33, 17, {});  // odd sizes
        ASSERT_TRUE(file) << file.error().text();
        const std::vector<unsigned char> rgb(33 * 17 * 3, 90);
        for (int i = 0; i < 15; ++i) EXPECT_TRUE(file->add(rgb));
        const auto error = file->finish();
        EXPECT_FALSE(error) << error->text();
        EXPECT_GT(fs::file_size(wanted), 300U);
    }
}

}  // namespace
}  // namespace braitenlab::tests::clip_file_test
