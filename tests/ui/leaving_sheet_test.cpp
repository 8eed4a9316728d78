// The sheet that asks before unsaved edits are left.
#include <algorithm>

#include "desk.h"

namespace braitenlab::tests::leaving_sheet_test {

namespace {

struct LeavingSheet : ::testing::Test {
    Desk desk;
    FilesView files;
    LeavingSheet() {
        files.suggested = "2a-coward";
        desk.view.files = &files;
        desk.frame(3);
    }
    void ask(const char* next = "/home/me/other.toml") {
        files.leaving = Leaving{"2a-coward", next};
        desk.frame(3);
    }
    std::vector<Leave> answers() const {
        std::vector<Leave> found;
        for (const Request& request : desk.all)
            if (const auto* leave = std::get_if<LeaveRequest>(&request)) found.push_back(leave->answer);
        return found;
    }
    bool says(std::string_view words) const {
        for (const Written& written : desk.written)
            if (written.words.find(words) != std::string::npos) return true;
        return false;
    }
};

}  // namespace

TEST_F(LeavingSheet, NamesWhatIsLostAndWhatOpensInstead) {
    EXPECT_FALSE(desk.anchors.find("card.leaving"));
    ask();
    EXPECT_TRUE(desk.anchors.find("card.leaving"));
    EXPECT_TRUE(says("2a-coward"));
    EXPECT_TRUE(says("other.toml"));
    files.leaving.reset();
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.leaving"));
}

TEST_F(LeavingSheet, SavesByEnterWhereTheSceneHasAFile) {
    files.save_to = "/home/me/mine.toml";
    ask();
    desk.key({key::enter});
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::save});
}

TEST_F(LeavingSheet, IsAnsweredByTheKeyboardAlone) {
    ask("");
    desk.key({key::tab});
    desk.frame();
    desk.key({key::enter});
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::discard});
}

TEST_F(LeavingSheet, StaysByEscape) {
    ask();
    desk.key({key::escape});
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::stay});
}

TEST_F(LeavingSheet, StaysByAClickBesideIt) {
    ask();
    desk.point(20, 700);
    desk.button(0, true);
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::stay});
}

TEST_F(LeavingSheet, AsksForANameWhereThereIsNoneAndGoesOnOnceItIsSaved) {
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

TEST_F(LeavingSheet, StaysWhenTheNameIsCancelled) {
    ask();
    desk.click("leaving.save");
    desk.frame(2);
    desk.key({key::escape});
    desk.frame();
    EXPECT_EQ(answers(), std::vector{Leave::stay});
}

TEST_F(LeavingSheet, IsAskedForByCtrlQWhateverIsOpenOrTyped) {
    const auto exits = [&] {
        const auto asked = desk.actions();
        return std::count(asked.begin(), asked.end(), Action::exit);
    };
    for (const Sheet sheet : {Sheet::keys, Sheet::settings, Sheet::files}) {
        const auto before = exits();
        if (sheet == Sheet::files) begin_files(desk.panels.files, true);
        desk.panels.sheet = sheet;
        desk.frame(4);
        EXPECT_EQ(desk.panels.files.typed.active, sheet == Sheet::files);
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

}  // namespace braitenlab::tests::leaving_sheet_test
