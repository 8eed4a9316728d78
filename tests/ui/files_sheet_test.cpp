#include "desk.h"

namespace braitenlab::tests::files_sheet_test {

using namespace ui;

struct FilesSheet : testing::Test {
    Desk desk;
    std::vector<CatalogueEntry> catalogue{{"05-aggressor", "/x/05-aggressor.toml", "Aggressor", "", 5},
                                          {"2a-coward", "/x/2a-coward.toml", "Coward", "It turns away."}};
    std::vector<RecentFile> recent{{"/y/mine.toml"}, {"/x/2a-coward.toml", "Coward"}};
    FilesView files;

    FilesSheet() {
        files.listing = {"/home/me",
                         {{"pictures", true},
                          {"brain.toml", false, FileKind::brain},
                          {"mine.toml", false, FileKind::scene, true},
                          {"other.toml", false, FileKind::scene}},
                         ""};
        files.suggested = "Coward";
        desk.view.documents.catalogue = &catalogue;
        desk.view.documents.recent = &recent;
        desk.view.documents.files = &files;
        desk.view.documents.opened = "05-aggressor";
        desk.frame(2);
    }
    template <class R>
    Found<std::string> asked() const {
        Found<std::string> paths;
        for (const Request& request : desk.all)
            if (const auto* open = std::get_if<R>(&request)) paths.push_back(open->path);
        return paths;
    }
    Found<std::string> opened() const { return asked<OpenRequest>(); }
    // The number of times the last frame shows the text.
    int said(std::string_view words) const {
        int count = 0;
        for (const Written& w : desk.written) count += w.words.find(words) != std::string::npos;
        return count;
    }
    void press(KeyPress key) {
        desk.key(key);
        desk.frame(3);
    }
    void type(const char* text) {
        desk.type(text);
        desk.frame(3);
    }
};

TEST_F(FilesSheet, TellsNoTitleAndNoStoryWhileALectureAsksFirst) {
    desk.view.lecture = true;
    const auto look = [&](bool asks_first) {
        desk.view.settings.revealed.asks_first = asks_first;
        desk.panels.sheet = Sheet::files;
        desk.frame(4);
        std::string all;
        for (const Written& each : desk.written) all += each.words + "\n";
        return all;
    };
    files.listing.entries.push_back({"2a-Coward.toml", false, FileKind::scene});
    recent.push_back({"/y/2a-coward.toml", "Coward"});  // of the same title: its name would follow
    for (const FilesPlace place : {FilesPlace::shipped, FilesPlace::recent, FilesPlace::folder}) {
        begin_files(desk.panels.sheets.files, false);
        desk.panels.sheets.files.place = place;
        EXPECT_NE(look(false).find("Coward"), std::string::npos);
        const std::string hidden = look(true);
        for (const char* told : {"Coward", "coward", "Aggressor", "aggressor", "It turns away.", "mine", "other"})
            EXPECT_EQ(hidden.find(told), std::string::npos) << told << " in " << hidden;
        EXPECT_NE(hidden.find("Scene 1"), std::string::npos) << hidden;
    }
}

TEST_F(FilesSheet, WhatIsTypedWhileALectureAsksFirstIsNotLegible) {
    desk.view.lecture = true;
    for (const bool asks_first : {false, true}) {
        desk.view.settings.revealed.asks_first = asks_first;
        press({'O', true});
        for (const char c : std::string("COWARD")) press({c});
        EXPECT_EQ(desk.panels.sheets.files.search, "coward");
        EXPECT_EQ(said("coward"), asks_first ? 0 : 1);
        EXPECT_EQ(said("••••••"), asks_first ? 1 : 0);
        desk.click("files.place.3");
        desk.frame(3);
        EXPECT_EQ(desk.panels.sheets.files.typed.is_masked, asks_first);
        press({key::escape});
        desk.panels.sheet = Sheet::none;
        desk.frame(2);
    }
}

TEST_F(FilesSheet, InALectureTheBrowserBeginsWithWhatShips) {
    for (const bool lecture : {false, true}) {
        desk.view.lecture = lecture;
        desk.panels.sheets.files.place = FilesPlace::folder;
        press({'O', true});
        EXPECT_EQ(desk.panels.sheets.files.place, lecture ? FilesPlace::shipped : FilesPlace::folder);
        desk.panels.sheet = Sheet::none;
        desk.frame(2);
    }
}

TEST_F(FilesSheet, AWordThatIsNoFileOfTheFolderIsSearchedForAmongWhatShips) {
    desk.panels.sheets.files.place = FilesPlace::folder;
    press({'O', true});
    type("2a");
    press({key::enter});
    EXPECT_EQ(opened(), std::vector<std::string>{});
    EXPECT_EQ(desk.panels.sheets.files.search, "2a");
    EXPECT_EQ(desk.panels.keyboard.focus, "open.2a-coward");
    press({key::enter});
    EXPECT_EQ(opened(), std::vector<std::string>{"/x/2a-coward.toml"});
    for (const char* typed : {"mine", "x/2a", "zzz"}) {  // a file, a path, a word that is nowhere
        desk.panels.sheet = Sheet::none;
        desk.frame(2);
        desk.panels.sheets.files.place = FilesPlace::folder;
        press({'O', true});
        desk.all.clear();
        type(typed);
        press({key::enter});
        EXPECT_EQ(opened(), std::vector<std::string>{typed});
    }
}

TEST_F(FilesSheet, ASearchWhileALectureAsksFirstFindsWhatIsHidden) {
    desk.view.lecture = true;
    desk.view.settings.revealed = hidden_until_asked;
    begin_files(desk.panels.sheets.files, false);
    desk.panels.sheets.files.place = FilesPlace::shipped;
    desk.panels.sheet = Sheet::files;
    desk.panels.sheets.files.search = "coward";
    desk.frame(4);
    EXPECT_TRUE(desk.anchors.find("open.2a-coward"));
    EXPECT_FALSE(desk.anchors.find("gallery.05-aggressor"));
    EXPECT_FALSE(desk.says("Coward"));
}

TEST_F(FilesSheet, ASearchFindsAnExerciseByTheNameOfItsFile) {
    begin_files(desk.panels.sheets.files, false);
    desk.panels.sheets.files.place = FilesPlace::shipped;
    desk.panels.sheet = Sheet::files;
    for (const char* search : {"05", "05-aggressor"}) {
        desk.panels.sheets.files.search = search;
        desk.frame(4);
        EXPECT_TRUE(desk.anchors.find("gallery.05-aggressor")) << search;
        EXPECT_FALSE(desk.anchors.find("open.2a-coward")) << search;
    }
}

TEST_F(FilesSheet, ASearchFindsAnExerciseByItsSubjects) {
    for (const auto& [code, search] : {std::pair{"en", "crossed wires"}, {"de", "gekreuzt"}, {"es", "cruzados"}}) {
        desk.strings = speaking(code);
        begin_files(desk.panels.sheets.files, false);
        desk.panels.sheets.files.place = FilesPlace::shipped;
        desk.panels.sheet = Sheet::files;
        desk.panels.sheets.files.search = search;
        desk.frame(4);
        EXPECT_TRUE(desk.anchors.find("gallery.05-aggressor")) << search;
        EXPECT_FALSE(desk.anchors.find("open.2a-coward")) << search;
    }
}

TEST(FilesSheetNames, OfScenesAreWholeInTheSmallestWindow) {
    Desk desk(800, 600, 1, true);
    const std::string title = "Vehicle 3c: Four pairs of sensors, and what each of them prefers";
    const std::vector<CatalogueEntry> catalogue{{"05-aggressor", "/x/05-aggressor.toml", "Aggressor", "", 5},
                                                {"3c-values", "/x/3c-values.toml", title, "What it likes."}};
    FilesView files;
    desk.view.documents.catalogue = &catalogue, desk.view.documents.files = &files;
    desk.frame(4);
    const int shortened = desk.shortened;
    desk.key({'O', true});
    desk.frame(4);
    EXPECT_EQ(desk.shortened, shortened);
    EXPECT_TRUE(desk.says("prefers"));
    const Rect row = desk.where("open.3c-values");
    for (const Written& each : desk.written) {
        if (each.words != "What it likes.") continue;
        EXPECT_LE(each.rect.y + each.rect.h, row.y + row.h);
    }
}

TEST_F(FilesSheet, OpensTheClickedFileAndClosesAfterwards) {
    desk.choose("file", "open");
    desk.frame(2);
    desk.click("open.2a-coward");
    EXPECT_EQ(opened(), std::vector<std::string>{"/x/2a-coward.toml"});
    EXPECT_TRUE(desk.anchors.find("card.open")) << "open until the file is loaded";
    files.done = 1;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.open"));
}

TEST_F(FilesSheet, ShowsTheReasonForARefusedFileAndStaysOpen) {
    press({'O', true});
    desk.click("open.2a-coward");
    desk.frame(4);
    const Rect sheet = desk.where("card.open"), row = desk.where("open.2a-coward");
    files.refused = Error{"what is this", "2a-coward.toml", 3};
    desk.frame(4);
    EXPECT_NEAR(desk.where("card.open").h, sheet.h, 1) << "the sheet keeps its size";
    EXPECT_NEAR(desk.where("open.2a-coward").y, row.y, 1);
    EXPECT_EQ(said(files.refused->text()), 1);
}

TEST_F(FilesSheet, OffersAnUploadInABrowserOnly) {
    press({'O', true});
    EXPECT_FALSE(desk.anchors.find("files.upload"));
    desk.view.program.uploads = true;
    desk.frame(2);
    desk.click("files.upload");
    desk.frame(2);
    EXPECT_TRUE(std::any_of(desk.all.begin(), desk.all.end(),
                            [](const Request& request) { return std::holds_alternative<UploadRequest>(request); }));
    EXPECT_FALSE(desk.anchors.find("card.open")) << "the window shows the opened file";
}

TEST_F(FilesSheet, SelectsTheOpenFileAndCanBeUsedByKeysAlone) {
    press({'O', true});
    EXPECT_EQ(desk.panels.keyboard.focus, "gallery.05-aggressor");
    press({key::down});
    EXPECT_EQ(desk.panels.keyboard.focus, "open.2a-coward");
    press({key::enter});
    EXPECT_EQ(opened(), std::vector<std::string>{"/x/2a-coward.toml"});
    for (int i = 0; i < 20; ++i) {
        press({key::tab});
        EXPECT_TRUE(desk.panels.keyboard.focus.starts_with("open.") ||
                    desk.panels.keyboard.focus.starts_with("gallery.") ||
                    desk.panels.keyboard.focus.starts_with("files."));
    }
}

TEST_F(FilesSheet, ClosesOnEscAndOnAClickBesideItWithoutOpeningAFile) {
    press({'O', true});
    press({key::escape});
    EXPECT_FALSE(desk.anchors.find("card.open"));
    desk.choose("file", "open");
    desk.frame(2);
    desk.point(8, 400);
    desk.frame(2);
    desk.button(0, true);
    desk.frame();
    desk.button(0, false);
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.open"));
    EXPECT_TRUE(opened().empty());
}

TEST_F(FilesSheet, ListsRecentFiles) {
    press({'O', true});
    desk.click("files.place.2");
    desk.frame(2);
    desk.click("recent.1");
    EXPECT_EQ(opened(), std::vector<std::string>{"/y/mine.toml"});
}

TEST_F(FilesSheet, ListsRecentFilesByTheirTitle) {
    recent = {{"/y/mine.toml"}, {"/x/2a-coward.toml", "Coward"}, {"/x/a.toml", "Twice"}, {"/x/b.toml", "Twice"}};
    press({'O', true});
    desk.click("files.place.2");
    desk.frame(2);
    EXPECT_EQ(said("Coward"), 1);
    EXPECT_EQ(said("Twice (a.toml)"), 1);
    EXPECT_EQ(said("Twice (b.toml)"), 1);
}

TEST_F(FilesSheet, LeavesATextFieldByAClickBesideIt) {
    begin_files(desk.panels.sheets.files, true, FileKind::scene);
    desk.panels.sheet = Sheet::files;
    desk.frame(4);
    ASSERT_EQ(desk.panels.keyboard.focus, "files.path");
    type("tame");
    const Rect sheet = desk.where("card.open");
    desk.point(sheet.x + 8, sheet.y + sheet.h - 8);
    desk.frame(2);
    desk.button(0, true);
    desk.frame(2);
    desk.button(0, false);
    desk.frame(3);
    EXPECT_EQ(desk.panels.keyboard.focus, "");
    EXPECT_FALSE(desk.panels.sheets.files.typed.active);
    EXPECT_EQ(desk.panels.sheets.files.typed.text, "tame");
    desk.click("files.title");
    EXPECT_EQ(desk.panels.keyboard.focus, "files.title");
}

TEST_F(FilesSheet, TellsRecentFilesOfOneTitleApartInTheMenu) {
    const std::string title = "Arduino robot with two TT motors on a table";
    recent = {{"/x/mine.toml", title}, {"/x/tt2wd-ldr.toml", title}, {"/y/mine.toml", title}};
    desk.click("menu.file");
    desk.frame(2);
    EXPECT_EQ(said("… (x/mine.toml)"), 1);
    EXPECT_EQ(said("… (tt2wd-ldr.toml)"), 1);
    EXPECT_EQ(said("… (y/mine.toml)"), 1);
}

TEST_F(FilesSheet, SaysThatAFolderHasNoFileOfTheKindToSave) {
    files.listing.entries = {{"mine.toml", false, FileKind::scene}};
    begin_files(desk.panels.sheets.files, true, FileKind::brain);
    desk.panels.sheet = Sheet::files;
    desk.frame(3);
    EXPECT_EQ(said("There is no file of this kind here."), 1);
    EXPECT_EQ(said("No file of the lab is saved here yet."), 0);
    files.listing.entries.clear();
    desk.frame(3);
    EXPECT_EQ(said("No file of the lab is saved here yet."), 1);
}

TEST_F(FilesSheet, KeepsThePositionOfItsTabsForEachTab) {
    press({'O', true});
    desk.frame(4);
    const Rect tabs = desk.where("files.place.1"), sheet = desk.where("card.open");
    for (const char* place : {"files.place.2", "files.place.3", "files.place.1"}) {
        desk.click(place);
        desk.frame(4);
        EXPECT_EQ(desk.where("files.place.1").y, tabs.y) << place;
        EXPECT_EQ(desk.where("card.open").h, sheet.h) << place;
    }
}

TEST_F(FilesSheet, StartsEachListAtItsTop) {
    for (int i = 0; i < 40; ++i) recent.push_back({"/y/" + std::to_string(i) + ".toml"});
    for (int i = 0; i < 40; ++i) {
        const std::string name = "s" + std::to_string(i);
        catalogue.push_back({name, "/x/" + name + ".toml", name, "A story."});
    }
    press({'O', true});
    const float row = desk.where("open.2a-coward").y;
    desk.point("open.2a-coward");
    ImGui::GetIO().MouseWheel = -20;
    desk.frame(4);
    EXPECT_FALSE(desk.anchors.find("open.2a-coward")) << "scrolled away";
    desk.click("files.place.2");
    desk.frame(4);
    EXPECT_TRUE(desk.anchors.find("recent.1"));
    desk.click("files.place.1");
    desk.frame(4);
    EXPECT_EQ(desk.where("open.2a-coward").y, row);
}

TEST_F(FilesSheet, ExplainsItsEmptyField) {
    press({'O', true});
    desk.click("files.place.3");
    desk.frame(2);
    EXPECT_EQ(said(desk.strings("files.path")), 1);
    desk.click("files.path");
    type("m");
    EXPECT_EQ(said(desk.strings("files.path")), 0);
}

TEST_F(FilesSheet, DoesNotRepeatVisibleTextInATooltip) {
    press({'O', true});
    desk.point("open.2a-coward");
    desk.frame(60);
    EXPECT_EQ(said("It turns away."), 1);
}

TEST_F(FilesSheet, OpensFoldersAndFiltersByKind) {
    press({'O', true});
    desk.click("files.place.3");
    desk.frame(2);
    desk.click("file.pictures");
    desk.click("file.up");
    EXPECT_EQ(asked<BrowseRequest>(), (std::vector<std::string>{"", "/home/me/pictures", "/home"}));
    desk.click("files.only.4");
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("file.brain.toml"));
    EXPECT_TRUE(desk.anchors.find("file.pictures"));
    EXPECT_FALSE(desk.anchors.find("file.mine.toml"));
    desk.click("file.brain.toml");
    EXPECT_EQ(opened(), std::vector<std::string>{"/home/me/brain.toml"});
}

TEST_F(FilesSheet, MarksUnreadableFilesAndReportsTheReasonOnOpening) {
    files.listing.entries.push_back({"torn.toml", false, FileKind::scene, false, true});
    press({'O', true});
    desk.click("files.place.3");
    desk.frame(2);
    EXPECT_EQ(said(desk.strings("files.broken")), 1);
    desk.click("file.torn.toml");
    EXPECT_EQ(opened(), std::vector<std::string>{"/home/me/torn.toml"});
}

TEST_F(FilesSheet, SaysInTheChosenLanguageThatAFolderCannotBeListed) {
    desk.strings = speaking("de");
    files.listing = {"/root", {}, "Permission denied"};
    press({'O', true});
    desk.click("files.place.3");
    desk.frame(2);
    EXPECT_EQ(said("lässt sich nicht öffnen: Permission denied"), 1);
}

TEST_F(FilesSheet, AcceptsATypedPathWithSpacesAndDots) {
    press({'O', true});
    desk.click("files.place.3");
    desk.click("files.path");
    type("~/my ");
    press({' '});  // a character here, not Play
    type("scene.toml");
    press({key::enter});
    EXPECT_EQ(opened(), std::vector<std::string>{"~/my scene.toml"});
    EXPECT_TRUE(desk.actions().empty());
}

TEST_F(FilesSheet, ASearchThatIsAPathGoesOnInTheFieldOfThePath) {
    for (const std::string path : {"/home/x/My y.toml", "~/a.toml", "../b.toml", "Sub/ä.toml", "c:\\d.toml"}) {
        press({'O', true});
        desk.all.clear();
        const std::size_t slash = path.find_first_of("/\\");
        for (const char c : path.substr(0, slash + 1)) {
            const bool is_letter = c >= 'a' && c <= 'z', is_capital = c >= 'A' && c <= 'Z';
            press({is_letter ? c - 'a' + 'A' : c, false, is_capital});
        }
        EXPECT_EQ(desk.panels.sheets.files.place, FilesPlace::folder) << path;
        EXPECT_EQ(desk.panels.keyboard.focus, "files.path") << path;
        EXPECT_TRUE(desk.last<BrowseRequest>()) << "the folder is listed: " << path;
        type(path.substr(slash + 1).c_str());
        press({key::enter});
        EXPECT_EQ(opened(), std::vector{path});
        EXPECT_TRUE(desk.panels.sheets.files.search.empty()) << path;
        desk.panels.sheets.files.place = FilesPlace::shipped;
        press({key::escape});
        ASSERT_EQ(desk.panels.sheet, Sheet::none) << path;
    }
}

TEST_F(FilesSheet, ASearchIgnoresCapitalsAndNamesTheTabOfOtherFiles) {
    for (const std::string& code : shipped_codes()) {
        desk.strings = speaking(code);
        press({'O', true});
        for (const char c : std::string("COW")) press({c, false, true});
        EXPECT_TRUE(desk.anchors.find("open.2a-coward")) << code;
        for (const char c : std::string("ZZ")) press({c});
        EXPECT_FALSE(desk.anchors.find("open.2a-coward")) << code;
        const std::string told = fill(desk.strings("files.no_match"), {std::string(desk.strings("files.folder"))});
        EXPECT_TRUE(desk.says(told)) << code << told;
        press({key::escape}), press({key::escape});
    }
}

TEST_F(FilesSheet, SavesUnderTheSuggestedOrATypedName) {
    press({'S', true});
    EXPECT_EQ(desk.panels.keyboard.focus, "files.path");
    press({key::enter});
    EXPECT_EQ(asked<SaveRequest>(), std::vector<std::string>{"Coward"});
}

TEST_F(FilesSheet, ReplacesTheSuggestedNameByTypingEachTimeItIsOpened) {
    for (int time = 0; time < 3; ++time) {
        press({'S', true});
        type("foo");
        press({key::enter});
        EXPECT_EQ(asked<SaveRequest>().back(), "foo") << time;
        press({key::escape});
        ASSERT_EQ(desk.panels.sheet, Sheet::none);
    }
}

TEST_F(FilesSheet, RequestsATitleOfASceneAndSendsOnlyAChangedTitle) {
    const auto titles = [&] {
        Found<std::optional<std::string>> found;
        for (const Request& request : desk.all)
            if (const auto* save = std::get_if<SaveRequest>(&request)) found.push_back(save->title);
        return found;
    };
    press({'S', true});
    EXPECT_EQ(desk.panels.sheets.files.title.text, desk.now.scene->title);
    press({key::enter});
    EXPECT_EQ(titles().back(), std::nullopt);
    press({key::tab});
    EXPECT_EQ(desk.panels.keyboard.focus, "files.title");
    type(" of my own");
    press({' '});  // a character here, not Play
    press({key::enter});
    ASSERT_TRUE(titles().back());
    EXPECT_NE(titles().back()->find("of my own"), std::string::npos) << *titles().back();
    EXPECT_TRUE(desk.actions().empty());
    desk.click("files.kind.2");
    desk.click("files.path");
    EXPECT_FALSE(desk.anchors.find("files.title")) << "runs have no title";
    press({key::enter});
    EXPECT_EQ(titles().back(), std::nullopt);
}

TEST_F(FilesSheet, RequestsAStoryOfASceneAndSendsOnlyAChangedStory) {
    const auto last = [&] {
        SaveRequest found;
        for (const Request& request : desk.all)
            if (const auto* save = std::get_if<SaveRequest>(&request)) found = *save;
        return found;
    };
    files.save_to = "/home/me/own.toml";
    press({'S', true, true});
    EXPECT_EQ(desk.panels.sheets.files.story.text, desk.now.scene->story);
    press({key::enter});
    EXPECT_EQ(last().story, std::nullopt);
    press({key::tab}), press({key::tab});
    EXPECT_EQ(desk.panels.keyboard.focus, "files.story");
    type(" It turns,");
    press({' '});  // a character here, not Play
    press({key::enter});
    ASSERT_TRUE(last().story);
    EXPECT_NE(last().story->find("It turns,"), std::string::npos) << *last().story;
    EXPECT_EQ(last().title, std::nullopt);
    EXPECT_TRUE(desk.actions().empty());
    desk.click("files.kind.3");
    EXPECT_FALSE(desk.anchors.find("files.story")) << "brains have no story";
    desk.click("files.path");
    press({key::enter});
    EXPECT_EQ(last().story, std::nullopt);
}

TEST_F(FilesSheet, ACopyOfAnotherAuthorsSceneBeginsWithoutItsStory) {
    files.ships = true;
    press({'S', true, true});
    EXPECT_EQ(desk.panels.sheets.files.story.text, "");
    press({key::enter});
    const auto* copy = desk.last<SaveRequest>();
    ASSERT_TRUE(copy);
    EXPECT_EQ(copy->story, "") << "the old one is not that of the copy";
    EXPECT_EQ(copy->title, std::nullopt);
}

TEST_F(FilesSheet, AsksBeforeItReplacesAFileAndReportsCommentsThatWouldBeLost) {
    press({'S', true, true});
    desk.click("file.mine.toml");
    desk.click("files.do");
    EXPECT_TRUE(asked<SaveRequest>().empty());
    EXPECT_EQ(said("comments"), 1);
    desk.rest();  // the question pushes the button down
    desk.click("files.do");
    EXPECT_EQ(asked<SaveRequest>(), std::vector<std::string>{"mine.toml"});
}

TEST_F(FilesSheet, AsksBeforeItCreatesAFolder) {
    const auto creates = [&] {
        std::vector<bool> found;
        for (const Request& request : desk.all)
            if (const auto* save = std::get_if<SaveRequest>(&request)) found.push_back(save->create_folder);
        return found;
    };
    press({'S', true, true});
    type("/new/");
    desk.click("files.do");
    EXPECT_EQ(creates(), std::vector{false});
    files.refused = Error{"refused"}, files.new_folder = "/home/me/Coward/new";
    desk.frame(3);
    EXPECT_EQ(said("/home/me/Coward/new"), 1) << "the question names the folder";
    EXPECT_EQ(said("refused"), 0);
    EXPECT_EQ(said(desk.strings("files.create_it")), 1);
    desk.rest();
    desk.click("files.do");
    EXPECT_EQ(creates(), (std::vector{false, true}));
    desk.click("files.path");
    type("x");
    desk.rest();
    desk.click("files.do");
    EXPECT_EQ(creates(), (std::vector{false, true, false})) << "another name, another folder";
}

TEST_F(FilesSheet, ShowsNoFoldersWhereASaveIsADownload) {
    press({'S', true, true});
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("file.pictures") && desk.anchors.find("file.up"));
    desk.view.program.uploads = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("file.pictures") || desk.anchors.find("file.up"));
    EXPECT_TRUE(desk.anchors.find("file.mine.toml"));
    desk.panels.sheets.files.saving = false;
    desk.panels.sheets.files.place = FilesPlace::folder;
    desk.frame(3);
    EXPECT_TRUE(desk.anchors.find("file.pictures")) << "files are opened from folders";
}

TEST_F(FilesSheet, SavesWithoutAQuestionIfTheSceneHasAFile) {
    files.save_to = "/home/me/mine.toml";
    press({'S', true});
    EXPECT_FALSE(desk.anchors.find("card.open"));
    EXPECT_EQ(desk.actions(), std::vector{Action::save});
}

TEST(PresetsMenu, OpensTheFilesSheetToSaveAndOpenABrain) {
    Desk desk;
    desk.frame(2);
    desk.click("button.presets");
    desk.frame(2);
    desk.click("preset.save");
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::files);
    EXPECT_TRUE(desk.panels.sheets.files.saving);
    EXPECT_EQ(desk.panels.sheets.files.kind, FileKind::brain);
    desk.panels.sheet = Sheet::none;
    desk.frame(2);
    desk.click("button.presets");
    desk.frame(2);
    desk.click("preset.load");
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::files);
    EXPECT_FALSE(desk.panels.sheets.files.saving);
    EXPECT_EQ(desk.panels.sheets.files.only, FileKind::brain);
}

}  // namespace braitenlab::tests::files_sheet_test
