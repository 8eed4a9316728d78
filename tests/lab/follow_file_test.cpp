// An opened file that another program has written.
#include <gtest/gtest.h>

#include "tests/lab/lab_files.h"
#include "tests/lab/other_program.h"

namespace braitenlab::tests::follow_file_test {
namespace {

struct FollowFile : LabFiles {
    const fs::path file = folder / "mine.toml";
    FollowFile() {
        ask(SaveRequest{"mine", FileKind::scene});
        ask(OpenRequest{"mine.toml"});
    }
    void write(const std::string& text) { other.write(file, text); }
    void look() { follow_file(lab, files); }
    OtherProgram other{lab, files};
};

TEST_F(FollowFile, ReloadsAFileThatAnotherProgramHasWritten) {
    handle(lab, Action::play_pause);
    ask(SaveRequest{"mine", FileKind::scene});
    for (int i = 0; i < 50; ++i) tick(lab);
    look(), look();
    EXPECT_EQ(lab.document.session.snapshot().tick, 50u) << "a save by the lab is not a change";
    write(with(text_of(file), "LL = 1.5", "LL = 0.25"));
    EXPECT_EQ(dials().LL, 0.25f);
    EXPECT_EQ(lab.playback.mode, Mode::playing);
    EXPECT_EQ(lab.notice.words, "Vehicle 2a: Coward");
}

TEST_F(FollowFile, KeepsTheRunIfTheFileIsBroken) {
    for (int i = 0; i < 50; ++i) tick(lab);
    const auto before = lab.document.session.hash();
    write(with(text_of(file), "LL = 1.5", "LL = 77"));
    EXPECT_EQ(lab.document.session.hash(), before);
    EXPECT_NE(lab.notice.words.find("mine.toml:"), std::string::npos) << lab.notice.words;
    write(with(text_of(file), "LL = 77", "LL = 0.5"));
    EXPECT_EQ(dials().LL, 0.5f) << "reloaded once it is valid";
}

TEST_F(FollowFile, KeepsUnsavedEdits) {
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    write(with(text_of(file), "LL = 1.5", "LL = 0.25"));
    EXPECT_EQ(dials().LR, 1.25f);
    EXPECT_EQ(dials().LL, 1.5f);
    EXPECT_EQ(lab.notice.words, "Vehicle 2a: Coward");
}

TEST_F(FollowFile, KeepsTheRunIfTheFileSaysTheSame) {
    for (int i = 0; i < 50; ++i) tick(lab);
    write(text_of(file));
    write(text_of(file) + "# a comment\n");
    EXPECT_EQ(lab.document.session.snapshot().tick, 50u) << "the run is not reset";
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_FALSE(files.refused) << "there is nothing to ask about";
}

TEST_F(FollowFile, TellsOnceThatTheFileIsGone) {
    for (int i = 0; i < 50; ++i) tick(lab);
    fs::remove(file);
    look();
    EXPECT_EQ(lab.notice.key, "files.deleted");
    EXPECT_EQ(lab.document.session.snapshot().tick, 50u);
    lab.notice = {};
    look(), look();
    EXPECT_TRUE(lab.notice.empty());
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_TRUE(fs::exists(file));
}

TEST_F(FollowFile, AsksBeforeItReplacesTheWorkOfAnotherWindow) {
    for (const bool was_seen : {false, true}) {
        handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, was_seen ? 1.25f : 0.75f}});
        const std::string others = with(text_of(file), "LL = ", "LM = 0.5\nLL = ");
        if (was_seen)
            write(others);
        else
            put_text(file, others);
        const std::string theirs = text_of(file);
        ask(SaveRequest{"mine", FileKind::scene});
        ASSERT_TRUE(files.refused);
        EXPECT_EQ(files.refused->phrases.front().id, "changed_outside");
        EXPECT_EQ(text_of(file), theirs);
        ask(SaveRequest{"mine", FileKind::scene});
        EXPECT_FALSE(files.refused) << "the second time the user has been asked";
        EXPECT_EQ(text_of(file).find("LM = 0.5"), std::string::npos);
    }
}

TEST_F(FollowFile, AsksBeforeItReplacesAnEditThatKeepsSizeAndTime) {
    const auto time = fs::last_write_time(file);
    put_text(file, with(text_of(file), "LL = 1.5", "LL = 0.5"));
    fs::last_write_time(file, time);
    const std::string theirs = text_of(file);
    look(), look();
    ask(SaveRequest{"mine", FileKind::scene});
    ASSERT_TRUE(files.refused);
    EXPECT_EQ(files.refused->phrases.front().id, "changed_outside");
    EXPECT_EQ(text_of(file), theirs);
}

TEST_F(FollowFile, TwoWindowsThatSaveAtTheSameTimeNoticeEachOther) {
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    ask(SaveRequest{"mine", FileKind::scene});
    auto opened = open_lab(file, std::nullopt, {});
    ASSERT_TRUE(opened);
    Lab second = std::move(*opened);
    const auto time = fs::last_write_time(file);
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 0.25f}});
    handle(second, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 0.75f}});
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_FALSE(files.refused);
    fs::last_write_time(file, time);
    std::swap(lab, second);
    ask(SaveRequest{"mine", FileKind::scene});
    ASSERT_TRUE(files.refused);
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_FALSE(files.refused) << "the second time the user has been asked";
    fs::last_write_time(file, time);
    std::swap(lab, second);
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_TRUE(files.refused) << "the first one notices the second one, too";
}

TEST_F(FollowFile, DoesNotAskWhenOnlyTheTimeOfTheFileChanges) {
    handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, 1.25f}});
    write(text_of(file));
    EXPECT_TRUE(lab.notice.empty()) << lab.notice.key;
    ask(SaveRequest{"mine", FileKind::scene});
    EXPECT_FALSE(files.refused);
}

TEST_F(FollowFile, AsksBeforeASavedRunReplacesAnotherOne) {
    ask(SaveRequest{"mine", FileKind::run});
    ask(OpenRequest{"mine.run"});
    tick(lab);
    ask(SaveRequest{"mine", FileKind::run});
    EXPECT_FALSE(files.refused) << "its own run";
    put_text(folder / "mine.run", "another");
    ask(SaveRequest{"mine", FileKind::run});
    EXPECT_TRUE(files.refused);
}

}  // namespace
}  // namespace braitenlab::tests::follow_file_test
