// The lecturer's notes as a page for a browser.
#include "app/course/notes_page.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "app/course/lab_lecture.h"
#include "app/files/data.h"
#include "app/files/disk.h"
#include "app/lab_actions.h"
#include "core/lesson/exercise_file.h"
#include "opened_lab.h"
#include "tests/folder.h"
#include "tests/languages.h"
#include "tests/well_formed.h"

namespace braitenlab::tests::notes_page_test {
namespace {

struct NotesPage : testing::Test {
    Folder folder;
    fs::path file = folder / "state" / "notes.html";
    Lab lab = opened_lab("2a-coward");
    Strings strings = english();

    NotesPage() {
        auto lecture = read_whole_lecture(*find_shipped("four-numbers"));
        open_lecture(lab, std::make_shared<const Lecture>(std::move(*lecture)));
    }
    void turn() {
        follow_notes_page(lab, strings, "en", folder / "state", [](const fs::path&) { return true; });
    }
    std::string caption(std::size_t page) const { return lab.pages->lecture->pages[page].caption; }
};

TEST_F(NotesPage, HasTheNotesTheTimeAndTheNextCaption) {
    lab.pages->seconds = 125;
    const std::string page = notes_page(*lab.pages, strings, "en", Theme::dark);
    EXPECT_EQ(xml_fault(page), "");
    for (const std::string& shown : {std::string("2:05"), caption(0), "Next: " + caption(1)})
        EXPECT_NE(page.find(shown), std::string::npos) << shown;
    EXPECT_NE(page.find(lab.pages->current().notes.substr(0, 12)), std::string::npos);
    EXPECT_NE(page.find("reload"), std::string::npos);
}

TEST_F(NotesPage, HasTheThemeOfTheWindow) {
    const auto ground = [&] {
        const std::string page = *read_text(file);
        return page.substr(page.find("--ground: ") + 10, 7);
    };
    const auto follows = [&](Theme theme) {
        lab.preferences.theme = theme;
        turn();
        EXPECT_EQ(ground(), theme == Theme::light ? "#ffffff" : "#14171c");
    };
    handle(lab, Action::notes_page);
    follows(Theme::dark), follows(Theme::light);
    end_lecture(lab);
    follows(Theme::dark), follows(Theme::light);
}

TEST_F(NotesPage, HasTheNotesInTheLanguageOfTheWindow) {
    const std::vector<TranslatableText> texts = texts_of(*lab.pages->lecture);
    const auto notes = std::find_if(texts.begin(), texts.end(), [&](const TranslatableText& each) {
        return each.text == lab.pages->current().notes;
    });
    ASSERT_NE(notes, texts.end());
    strings.add(notes->text, "Laufen lassen");
    EXPECT_NE(notes_page(*lab.pages, strings, "de", Theme::dark).find("<p>Laufen lassen</p>"), std::string::npos);
}

TEST_F(NotesPage, IsWrittenOnRequestAndFollowsTheLecture) {
    turn();
    EXPECT_FALSE(fs::exists(file)) << "not asked for yet";
    handle(lab, Action::notes_page);
    turn();
    ASSERT_TRUE(fs::exists(file));
    EXPECT_FALSE(lab.pages->notes) << "the audience does not see them";
    EXPECT_EQ(lab.notice.key, "notice.notes_page_opened");
    EXPECT_EQ(lab.window.to_copy, file.string()) << "where it is, if no window appears";
    EXPECT_TRUE(lab.notice.words.empty()) << "a path would not fit into the bar";
    show_page(lab, 1);
    turn();
    EXPECT_NE(read_text(file)->find("<h1>" + caption(1)), std::string::npos);
    const std::string last = caption(1);
    end_lecture(lab);
    turn();
    EXPECT_EQ(read_text(file)->find(last), std::string::npos) << "the lecture is over";
    EXPECT_NE(read_text(file)->find(std::string(strings("lecture.is_over"))), std::string::npos);
    EXPECT_EQ(xml_fault(*read_text(file)), "");
    handle(lab, Action::notes_page);
    EXPECT_FALSE(lab.window.opens_notes) << "there is no lecture";
}

TEST_F(NotesPage, TakesTheNotesOutOfTheLabsWindowOnceItIsOpen) {
    const auto ask_and_open = [&](bool (*open)(const fs::path&)) {
        handle(lab, Action::notes_page);
        follow_notes_page(lab, strings, "en", folder / "state", open);
        return lab.pages->notes;
    };
    handle(lab, Action::notes);
    EXPECT_TRUE(ask_and_open([](const fs::path&) { return false; })) << "the browser has refused its window";
    EXPECT_FALSE(ask_and_open([](const fs::path&) { return true; }));
    handle(lab, Action::notes);
    turn();
    EXPECT_TRUE(lab.pages->notes) << "N shows them again";
}

}  // namespace
}  // namespace braitenlab::tests::notes_page_test
