#include "app/files/archive.h"

#include <gtest/gtest.h>

#include "core/scene/schema.h"
#include "tests/folder.h"
#include "tests/zip.h"

namespace braitenlab::tests::archive_test {
namespace {

// The archive in a file of the folder.
Result<Archive> opened(const Folder& folder, const std::string& content) {
    put_text(folder / "a.zip", content);
    return Archive::open(folder / "a.zip");
}

TEST(Archive, UnpacksStoredAndCompressedFilesInMemory) {
    const Folder folder;
    const std::string many(100'000, 'a');
    auto archive = opened(folder, zip_of({{"one/"}, {"one/a.toml", "x = 1\n"}, {"b.toml", many, true}}));
    ASSERT_TRUE(archive) << archive.error().text();
    ASSERT_EQ(archive->entries().size(), 3u);
    EXPECT_EQ(archive->entries()[0].path, "one");
    EXPECT_TRUE(archive->entries()[0].is_folder);
    EXPECT_EQ(archive->entries()[1].path, "one/a.toml");
    EXPECT_EQ(*archive->read(2), many);
    EXPECT_EQ(*archive->read(1), "x = 1\n") << "in any order";
}

TEST(Archive, AFileIsAZipByItsContent) {
    const Folder folder;
    put_text(folder / "a.toml", zip_of({{"a", "1"}}));
    put_text(folder / "b.zip", "x = 1\n");
    EXPECT_TRUE(is_zip_file(folder / "a.toml"));
    EXPECT_FALSE(is_zip_file(folder / "b.zip"));
    EXPECT_FALSE(is_zip_file(folder / "none.zip"));
    EXPECT_TRUE(is_zip(zip_of({}))) << "an empty one";
}

TEST(Archive, NamesLeadNowhereAndAreUtf8) {
    const Folder folder;
    auto archive = opened(folder, zip_of({{"../../etc/a", "1"}, {"/b", "2"}, {"c\\d", "3"}, {"\x81\x62", "4"}}));
    ASSERT_TRUE(archive);
    EXPECT_EQ(archive->entries()[0].path, "../../etc/a") << "a name only";
    EXPECT_EQ(archive->entries()[1].path, "b");
    EXPECT_EQ(archive->entries()[2].path, "c/d");
    EXPECT_EQ(archive->entries()[3].path, "?b");
    EXPECT_EQ(*archive->read(0), "1");
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(folder.path), {}), 1) << "nothing is written";
}

TEST(Archive, AFileThatUnpacksToMoreThanTheLimitIsNotRead) {
    const Folder folder;
    const std::string large(limits::file_bytes + 1, '\0'), most(limits::file_bytes, '\0');
    auto archive = opened(folder, zip_of({{"large", large, true}, {"most", most, true}}));
    ASSERT_TRUE(archive);
    EXPECT_FALSE(archive->read(0));
    EXPECT_TRUE(archive->read(1));
}

TEST(Archive, AllFilesTogetherHaveALimit) {
    const Folder folder;
    std::vector<Zipped> files(limits::archive_bytes / limits::file_bytes + 1);
    for (std::size_t i = 0; i < files.size(); ++i) files[i] = {"f", std::string(limits::file_bytes, '\0'), true};
    auto archive = opened(folder, zip_of(files));
    ASSERT_TRUE(archive);
    for (std::size_t i = 0; i + 1 < files.size(); ++i) ASSERT_TRUE(archive->read(i)) << i;
    const auto beyond = archive->read(files.size() - 1);
    ASSERT_FALSE(beyond);
    EXPECT_NE(beyond.error().text().find("unpacks to more than 256 MB"), std::string::npos) << beyond.error().text();
}

TEST(Archive, TooManyFilesAreRefused) {
    const Folder folder;
    const auto archive = opened(folder, zip_of(std::vector<Zipped>(limits::archive_entries + 1, Zipped{"a"})));
    ASSERT_FALSE(archive);
    EXPECT_NE(archive.error().text().find("more than 20000 files"), std::string::npos);
}

TEST(Archive, ADamagedOrLockedFileIsAnErrorAndTheOthersAreRead) {
    const Folder folder;
    auto archive =
        opened(folder, zip_of({{"damaged", "1", false, 7}, {"locked", "secret", true, 0, 1}, {"good", "2"}}));
    ASSERT_TRUE(archive);
    EXPECT_FALSE(archive->read(0));
    EXPECT_EQ(*archive->read(2), "2");
}

TEST(Archive, TheBeginningOfAnArchiveIsNone) {
    const Folder folder;
    const std::string whole = zip_of({{"a", "1"}, {"b", "2"}});
    for (std::size_t size : {std::size_t{0}, std::size_t{30}, whole.size() - 30})
        EXPECT_FALSE(opened(folder, whole.substr(0, size))) << size;
    for (std::size_t at = 0; at < whole.size(); ++at) {  // any damage ends in an error or another content, never worse
        std::string damaged = whole;
        damaged[at] = static_cast<char>(~damaged[at]);
        if (auto archive = opened(folder, damaged))
            for (std::size_t i = 0; i < archive->entries().size(); ++i) static_cast<void>(archive->read(i));
    }
}

}  // namespace
}  // namespace braitenlab::tests::archive_test
