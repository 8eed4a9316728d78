// Opening scenes, exercises and saved runs.
#include "app/document.h"

#include <gtest/gtest.h>

#include "app/files/safe_file.h"
#include "core/io/run_file.h"
#include "tests/folder.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::document_test {
namespace {

TEST(Document, HasNoContentWhereItsFileHasBecomeADevice) {
    if (!std::filesystem::exists("/dev/null")) GTEST_SKIP() << "a system without devices in its folders";
    const Folder folder;
    put_text(folder / "a.toml", "");
    EXPECT_TRUE(content_of(folder / "a.toml"));
    std::filesystem::create_symlink("/dev/null", folder / "b.toml");
    EXPECT_FALSE(content_of(folder / "b.toml"));
}

TEST(Document, OpensASavedRunAtItsTick) {
    Lab lab = opened_lab("predator-prey");
    for (int i = 0; i < 400; ++i) tick(lab);
    const tests::Folder folder;
    const auto file = folder / "hunt.run";
    ASSERT_FALSE(write_whole(file, io::write_run(lab.document.session.save())));
    auto again = open_lab(file, std::nullopt, {});
    ASSERT_TRUE(again) << again.error().text();
    EXPECT_EQ(again->document.session.hash(), lab.document.session.hash());
    EXPECT_NE(again->view.selection.vehicle, no_vehicle);
}

}  // namespace
}  // namespace braitenlab::tests::document_test
