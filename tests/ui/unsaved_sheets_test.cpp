// The sheets for unsaved edits before closing, and for recovery after a crash.
#include <algorithm>

#include "desk.h"

namespace braitenlab::tests::unsaved_sheets_test {

using namespace ui;

struct UnsavedSheets : ::testing::Test {
    Desk desk;
    FilesView files;
    UnsavedSheets() {
        files.suggested = "2a-coward";
        desk.view.documents.files = &files;
        desk.frame(3);
    }
    void ask(const char* next = "/home/me/other.toml") {
        files.leaving = Leaving{"Coward", next, "Values"};
        desk.frame(3);
    }
    std::vector<Leave> answers() const {
        std::vector<Leave> found;
        for (const Request& request : desk.all)
            if (const auto* leave = std::get_if<LeaveRequest>(&request)) found.push_back(leave->answer);
        return found;
    }
};

TEST_F(UnsavedSheets, NamesTheUnsavedDocumentAndTheNextOne) {
    EXPECT_FALSE(desk.anchors.find("card.leaving"));
    ask();
    EXPECT_TRUE(desk.anchors.find("card.leaving"));
    EXPECT_TRUE(desk.says("Coward"));
    EXPECT_TRUE(desk.says("Values"));
    EXPECT_FALSE(desk.says("other.toml")) << "a title, not the name of a file";
    files.leaving.reset();
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.leaving"));
}

TEST_F(UnsavedSheets, SayThatAPassedExerciseIsKept) {
    files.leaving = Leaving{.title = "Coward", .next = "/home/me/other.toml", .next_title = "Values", .passed = true};
    desk.frame(3);
    EXPECT_TRUE(desk.says("The exercise is passed"));
    EXPECT_FALSE(desk.says("has unsaved changes"));
}

TEST_F(UnsavedSheets, SayOfAnExerciseWhatItsProgressKeeps) {
    const std::string rule(desk.strings("leaving.of_exercise"));
    ask();
    EXPECT_FALSE(desk.says(rule)) << "a scene";
    desk.open_exercise();
    desk.frame(3);
    EXPECT_TRUE(desk.says(rule.substr(0, rule.find(' ', 20))));
}

TEST_F(UnsavedSheets, TellTheTimeOfTheKeptWorkAndItsFile) {
    ui::Ui ui{desk.strings, palette(Theme::dark), {}, 1, desk.anchors, desk.asked, {}, 1};
    EXPECT_EQ(time_words(ui, "2026-03-01 14:05:42", "2026-03-01"), "today at 14:05");
    EXPECT_EQ(time_words(ui, "2026-02-28 14:05:42", "2026-03-01"), "on 2026-02-28 at 14:05");
    const RecoveryOffer offer{"Drive", "/home/me/exercises/drive.toml", "2026-02-28 14:05:42"};
    desk.view.documents.recovery = &offer;
    desk.frame(3);
    EXPECT_TRUE(desk.says("drive.toml"));
    EXPECT_FALSE(desk.says("/home/me"));
    desk.point("recovery.file");
    desk.frame(60);
    EXPECT_TRUE(desk.says("/home/me/exercises"));
}

TEST_F(UnsavedSheets, SavesOnEnterIfTheSceneHasAFile) {
    files.save_to = "/home/me/mine.toml";
    ask();
    desk.key({key::enter});
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::save});
}

TEST_F(UnsavedSheets, CanBeUsedByKeysAlone) {
    ask("");
    desk.key({key::tab});
    desk.frame();
    desk.key({key::enter});
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::discard});
}

TEST_F(UnsavedSheets, SpacePressesTheButtonThatHasTheRing) {
    ask("");
    desk.key({' '});
    desk.frame(2);
    EXPECT_TRUE(answers().empty()) << "no ring is shown: Space is for Play";
    desk.key({key::tab});
    desk.frame();
    desk.key({' '});
    EXPECT_TRUE(desk.panels.keyboard.shown);
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::discard});
}

TEST_F(UnsavedSheets, KeepsTheDocumentOnEscape) {
    ask();
    desk.key({key::escape});
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::stay});
}

TEST_F(UnsavedSheets, KeepsTheDocumentOnAClickBesideIt) {
    ask();
    desk.point(20, 700);
    desk.button(0, true);
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::stay});
}

TEST_F(UnsavedSheets, RequestsAMissingNameAndContinuesAfterSaving) {
    ask();
    desk.click("leaving.save");
    ASSERT_EQ(desk.panels.sheet, Sheet::files);
    desk.frame(3);
    EXPECT_TRUE(answers().empty());
    desk.key({key::enter});
    desk.frame(2);
    ++files.done;
    desk.frame(2);
    EXPECT_EQ(answers(), std::vector{Leave::saved});
}

TEST_F(UnsavedSheets, SavesTheBrainOfAnExercise) {
    desk.open_exercise();
    ask();
    desk.click("leaving.save");
    ASSERT_EQ(desk.panels.sheet, Sheet::files);
    EXPECT_EQ(desk.panels.sheets.files.kind, FileKind::brain);
}

TEST_F(UnsavedSheets, KeepsTheDocumentIfTheNameIsCancelled) {
    ask();
    desk.click("leaving.save");
    desk.frame(2);
    desk.key({key::escape});
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::stay});
}

TEST_F(UnsavedSheets, OpensOnCtrlQWithAnySheetOrTextFieldOpen) {
    const auto exits = [&] {
        const auto asked = desk.actions();
        return std::count(asked.begin(), asked.end(), Action::exit);
    };
    for (const Sheet sheet : {Sheet::keys, Sheet::settings, Sheet::files}) {
        const auto before = exits();
        if (sheet == Sheet::files) begin_files(desk.panels.sheets.files, true);
        desk.panels.sheet = sheet;
        desk.frame(4);
        EXPECT_EQ(desk.panels.sheets.files.typed.active, sheet == Sheet::files);
        desk.key({'Q', true});
        EXPECT_EQ(exits(), before + 1) << static_cast<int>(sheet);
        ask("");
        EXPECT_TRUE(desk.anchors.find("card.leaving"));
        files.leaving.reset();
        desk.frame(2);
    }
    desk.key({'2'});
    desk.frame(2);
    desk.key({key::enter});
    desk.frame(3);
    ASSERT_FALSE(desk.panels.sliders.typed.empty());
    const auto before = exits();
    desk.key({'Q', true});
    EXPECT_EQ(exits(), before + 1);
}

TEST(RecoverySheet, DistinguishesACrashFromASignal) {
    for (const bool ended : {false, true}) {
        Desk desk;
        const RecoveryOffer offer{"2a-coward", "/home/me/mine.toml", "2026-03-01 10:42:05", ended};
        desk.view.documents.recovery = &offer;
        desk.frame(3);
        bool crashed = false, kept = false;
        for (const Written& w : desk.written) {
            crashed |= w.words == desk.strings("recovery.heading");
            kept |= w.words == desk.strings("recovery.heading_ended");
        }
        EXPECT_EQ(crashed, !ended);
        EXPECT_EQ(kept, ended);
    }
}

TEST(RecoverySheet, IsShownAfterALectureOnly) {
    Desk desk;
    const RecoveryOffer offer{"2a-coward", "/home/me/mine.toml", "2026-03-01 10:42:05"};
    desk.view.documents.recovery = &offer;
    desk.view.lecture = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("recovery.take"));
    EXPECT_EQ(desk.panels.sheet, Sheet::none) << "keys reach the lecture";
    desk.view.lecture = false;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("recovery.take"));
    desk.view.lecture = true;  // a lecture file that is dropped onto the window
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("recovery.take"));
    desk.view.lecture = false;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("recovery.take"));
}

TEST(RecoverySheet, AClickBesideItDecidesNothing) {
    Desk desk;
    const RecoveryOffer offer{"2a-coward", "/home/me/mine.toml", "2026-03-01 10:42:05"};
    desk.view.documents.recovery = &offer;
    desk.frame(3);
    desk.point(5, 700);
    desk.frame(2);
    desk.button(0, true), desk.frame(2), desk.button(0, false), desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("recovery.take")) << "the work is still offered";
    desk.click("recovery.later");
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("recovery.take"));
}

TEST(RecoverySheet, NamesTitleFileAndTime) {
    Desk desk;
    const RecoveryOffer offer{"Coward", "/home/me/mine.toml", "2026-03-01 10:42:05"};
    desk.view.documents.recovery = &offer;
    desk.frame(3);
    std::string all;
    for (const Written& w : desk.written) all += w.words + "\n";
    for (const std::string& words : {offer.title, std::string("mine.toml"), std::string("2026-03-01 at 10:42")})
        EXPECT_NE(all.find(words), std::string::npos) << words;
}

}  // namespace braitenlab::tests::unsaved_sheets_test
