#include "app/autosave.h"

#include <gtest/gtest.h>

#include "app/data.h"
#include "tests/folder.h"

namespace braitenlab::tests {
namespace {

Lab open(const char* name) {
    auto lab = open_lab(*find_shipped(name), std::nullopt, {});
    return std::move(*lab);
}

FourNeurons dials(const Lab& lab) { return read_dials(*lab.session.snapshot().kind_brains[0]); }

void edit(Lab& lab, float value) { handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, value}}); }

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::exists(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".autosave") files.push_back(entry.path());
    return files;
}

struct Autosaving : testing::Test {
    Folder folder;
    std::vector<Error> complaints;
    Lab lab = open("2a-coward");

    // As a crash leaves it: the file is there, and nobody holds its lock.
    void crash_with(float value) {
        Autosave dying(folder.path, complaints);
        edit(lab, value);
        EXPECT_FALSE(dying.keep(lab, 0, true));
    }
};

TEST_F(Autosaving, WaitsTwentySecondsOfWorkAndNoLonger) {
    Autosave autosave(folder.path, complaints);
    for (double at = 0; at < 60; at += 1) autosave.keep(lab, at);
    EXPECT_TRUE(files_in(folder.path).empty()) << "no work, no file";
    edit(lab, 1);
    autosave.keep(lab, 60);
    autosave.keep(lab, 79);
    EXPECT_TRUE(files_in(folder.path).empty());
    edit(lab, 1.5f);
    autosave.keep(lab, 80);
    EXPECT_FALSE(autosave.settle());
    ASSERT_EQ(files_in(folder.path).size(), 1u);
    const auto kept = open_autosave(text_of(files_in(folder.path)[0]), "a");
    ASSERT_TRUE(kept) << kept.error().text();
    EXPECT_EQ(dials(*kept).LR, 1.5f);
}

TEST_F(Autosaving, WritesAtOnceWhenTheModeChanges) {
    Autosave autosave(folder.path, complaints);
    edit(lab, 1);
    autosave.keep(lab, 0);
    EXPECT_TRUE(files_in(folder.path).empty());
    handle(lab, Action::play_pause);
    autosave.keep(lab, 0.1);
    EXPECT_FALSE(autosave.settle());
    EXPECT_EQ(files_in(folder.path).size(), 1u);
}

TEST_F(Autosaving, KeepsARunThatPlaysEveryTwentySeconds) {
    lab = open("predator-prey");
    Autosave autosave(folder.path, complaints);
    handle(lab, Action::play_pause);
    std::uint64_t on_disk = 0;
    for (int second = 0; second <= 65; ++second) {
        for (int i = 0; i < 6; ++i) tick(lab);
        autosave.keep(lab, second);
        EXPECT_FALSE(autosave.settle());
        ASSERT_EQ(files_in(folder.path).size(), 1u) << "from the moment it was begun";
        if (second % 13 != 0) continue;
        const auto kept = open_autosave(text_of(files_in(folder.path)[0]), "a");
        ASSERT_TRUE(kept) << kept.error().text();
        on_disk = kept->session.snapshot().tick;
        EXPECT_LE(lab.session.snapshot().tick, on_disk + 20 * 6) << "at second " << second;
    }
    EXPECT_GT(on_disk, 200u);
}

TEST_F(Autosaving, GoesOnWithAPlayedRunExactly) {
    lab = open("predator-prey");
    for (int i = 0; i < 500; ++i) tick(lab);
    EXPECT_FALSE(Autosave(folder.path, complaints).keep(lab, 0, true));
    auto kept = Autosave(folder.path, complaints).recover();
    ASSERT_TRUE(kept) << kept.error().text();
    for (int i = 0; i < 400; ++i) tick(lab), tick(*kept);
    EXPECT_EQ(kept->session.hash(), lab.session.hash());
}

TEST_F(Autosaving, KeepsNothingOfARunThatIsBackAtItsStart) {
    Autosave autosave(folder.path, complaints);
    tick(lab);
    autosave.keep(lab, 0, true);
    EXPECT_EQ(files_in(folder.path).size(), 1u);
    handle(lab, Action::reset);
    autosave.keep(lab, 1);
    EXPECT_TRUE(files_in(folder.path).empty());
}

TEST_F(Autosaving, LeavesNothingBehindAtAProperEndOrAfterSaving) {
    Autosave autosave(folder.path, complaints);
    edit(lab, 1);
    autosave.keep(lab, 0, true);
    EXPECT_EQ(files_in(folder.path).size(), 1u);
    lab.saved_work = lab.work;
    autosave.keep(lab, 1);
    EXPECT_TRUE(files_in(folder.path).empty());
    edit(lab, 2);
    autosave.keep(lab, 2, true);
    autosave.finish();
    EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST_F(Autosaving, OffersWhatACrashedLabHasLeft) {
    for (int i = 0; i < 500; ++i) tick(lab);
    crash_with(1.25f);
    Autosave next(folder.path, complaints);
    ASSERT_TRUE(next.leftover());
    EXPECT_EQ(next.leftover()->offer.name, "2a-coward");
    EXPECT_EQ(next.leftover()->offer.when.size(), 19u);
    const auto recovered = next.recover();
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_EQ(dials(*recovered).LR, 1.25f);
    EXPECT_EQ(recovered->path, lab.path);
    EXPECT_EQ(recovered->session.hash(), lab.session.hash());
    EXPECT_TRUE(Autosave(folder.path, complaints).leftover()) << "it stays until it is taken or refused";
    next.forget();
    EXPECT_FALSE(Autosave(folder.path, complaints).leftover());
    EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST_F(Autosaving, DoesNotOfferWhatARunningLabKeeps) {
    Autosave running(folder.path, complaints);
    edit(lab, 1);
    running.keep(lab, 0, true);
    EXPECT_FALSE(Autosave(folder.path, complaints).leftover());
}

TEST_F(Autosaving, BringsAnExerciseBackToWhereItWas) {
    lab = open("05-aggressor");
    handle(lab, PredictRequest{2});
    tick(lab);
    handle(lab, Action::hint);
    crash_with(1.75f);
    const auto recovered = Autosave(folder.path, complaints).recover();
    ASSERT_TRUE(recovered) << recovered.error().text();
    ASSERT_TRUE(recovered->lesson);
    EXPECT_EQ(recovered->lesson->view.prediction, 2);
    EXPECT_EQ(recovered->lesson->view.hints_shown, 1);
    EXPECT_TRUE(recovered->lesson->view.has_run);
    EXPECT_EQ(dials(*recovered).LR, 1.75f);
    EXPECT_EQ(read_dials(recovered->lesson->exercise->scene.kinds[0].brain).LR, 0) << "reset still means as shipped";
}

TEST_F(Autosaving, SetsABrokenFileAsideAndSaysSo) {
    crash_with(1);
    const auto file = files_in(folder.path)[0];
    const std::string whole = text_of(file);
    for (const std::string& broken : {whole.substr(0, whole.size() / 2), std::string("\x00\xff[[", 4), std::string(),
                                      std::string("format = 1\n")}) {
        put_text(file, broken);
        complaints.clear();
        Autosave next(folder.path, complaints);
        EXPECT_FALSE(next.leftover());
        ASSERT_EQ(complaints.size(), 1u);
        EXPECT_EQ(complaints[0].file, file.string());
        EXPECT_EQ(text_of(file.string() + ".broken"), broken);
    }
}

TEST_F(Autosaving, SaysOnceThatItCannotWrite) {
    put_text(folder / "taken", "a file where the folder should be");
    Autosave autosave(folder / "taken" / "here", complaints);
    edit(lab, 1);
    EXPECT_TRUE(autosave.keep(lab, 0, true));
    edit(lab, 2);
    EXPECT_FALSE(autosave.keep(lab, 1, true));
}

}  // namespace
}  // namespace braitenlab::tests
