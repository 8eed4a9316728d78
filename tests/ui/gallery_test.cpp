// The exercises in the file browser and in the menu: pictures, names that tell no outcome, passed marks.
#include "core/lesson/exercise_file.h"
#include "desk.h"
#include "ui/imgui_compat.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/scene_picture.h"
#include "ui/widgets/paint.h"

namespace braitenlab::tests::gallery_test {

using namespace ui;

namespace {

std::shared_ptr<const Exercise> shipped_exercise(const std::string& id) {
    auto loaded = load_exercise(std::string(BRAITENLAB_SOURCE) + "/exercises/guided/" + id + ".toml");
    if (!loaded) throw std::runtime_error(loaded.error().text());
    return std::make_shared<const Exercise>(std::move(*loaded));
}

CatalogueEntry entry_of(const std::string& id) {
    const auto exercise = shipped_exercise(id);
    return {id, "/x/" + id + ".toml", exercise->title, "", exercise->number, exercise->chapter, exercise};
}

struct Gallery : testing::Test {
    Desk desk{1280, 800, 1, true};
    std::vector<CatalogueEntry> catalogue{entry_of("04-coward"),
                                          entry_of("05-aggressor"),
                                          entry_of("11-threshold"),
                                          {"2a-coward", "/x/2a-coward.toml", "A scene", "It turns away."}};
    StudentBook students;
    FilesView files;
    std::vector<RecentFile> recent{{"/x/05-aggressor.toml", "Aggressor"}};

    Gallery() {
        desk.view.documents.catalogue = &catalogue;
        desk.view.documents.students = &students;
        desk.view.documents.files = &files;
        desk.view.documents.recent = &recent;
        desk.frame(2);
    }
    void open_browser() {
        desk.key({'O', true});
        desk.frame(4);
    }
};

}  // namespace

TEST_F(Gallery, HasACardForEachExerciseByChapter) {
    open_browser();
    for (const char* id : {"gallery.04-coward", "gallery.05-aggressor", "gallery.11-threshold"})
        EXPECT_GE(desk.where(id).w, 140) << id;
    EXPECT_EQ(desk.where("gallery.04-coward").y, desk.where("gallery.05-aggressor").y) << "one chapter, one row";
    EXPECT_GT(desk.where("gallery.11-threshold").y, desk.where("gallery.05-aggressor").y);
    desk.click("gallery.05-aggressor");
    ASSERT_TRUE(desk.last<OpenRequest>());
    EXPECT_EQ(desk.last<OpenRequest>()->path, "/x/05-aggressor.toml");
}

TEST_F(Gallery, TheFootOfACardIsAsHighAsTheWordsOfItsRow) {
    for (const char* predicted : {"04-coward", "05-aggressor"})
        students.student().exercises[predicted].prediction = "It turns away from the lamp";  // so titles are shown
    open_browser();
    const Rect row = desk.where("gallery.04-coward");
    EXPECT_EQ(row.h, desk.where("gallery.05-aggressor").h);
    float lowest = 0;  // end of the words in the row
    for (const Written& w : desk.written)
        if (w.rect.y >= row.y && w.rect.y < row.y + row.h && w.rect.x < row.x + 2 * row.w)
            lowest = std::max(lowest, w.rect.y + w.rect.h);
    EXPECT_LT(row.y + row.h - lowest, 16) << "no empty lines";
}

TEST_F(Gallery, TheArrowKeysMoveByRowAndColumn) {
    open_browser();
    const auto& focus = desk.panels.keyboard.focus;
    const auto press = [&](int key) {
        desk.key({key});
        desk.frame(2);
        return focus;
    };
    desk.panels.keyboard.focus = "gallery.05-aggressor";
    EXPECT_EQ(press(key::down), "gallery.11-threshold") << "the next row is shorter";
    EXPECT_EQ(press(key::up), "gallery.04-coward");
    EXPECT_EQ(press(key::left), "gallery.04-coward") << "the end of the row";
    EXPECT_EQ(press(key::right), "gallery.05-aggressor");
    EXPECT_EQ(press(key::right), "open.2a-coward") << "the scenes are to the right";
    EXPECT_EQ(press(key::left), "gallery.04-coward");
    EXPECT_EQ(press(key::up), "files.place.1");
    EXPECT_EQ(press(key::down), "files.place.2") << "elsewhere Down is Tab";
    desk.panels.keyboard.focus = "gallery.11-threshold";
    EXPECT_EQ(press(key::down), "open.2a-coward");
}

TEST_F(Gallery, TheFocusedCardIsFullyInSight) {
    for (int i = 0; i < 20; ++i) {
        CatalogueEntry more = catalogue[2];
        more.name += std::to_string(i);
        catalogue.insert(catalogue.begin() + 3, more);
    }
    open_browser();
    desk.panels.keyboard.focus = "gallery.04-coward";
    const float whole = desk.where("gallery.04-coward").h;
    for (int i = 0; i < 5; ++i) {
        desk.key({key::down});
        desk.frame(3);
        EXPECT_NEAR(desk.where(desk.panels.keyboard.focus).h, whole, 1) << desk.panels.keyboard.focus;
    }
    EXPECT_EQ(desk.panels.keyboard.focus, "gallery.11-threshold4") << "five rows of four cards below";
    for (int i = 0; i < 5; ++i) {
        desk.key({key::up});
        desk.frame(3);
        EXPECT_NEAR(desk.where(desk.panels.keyboard.focus).h, whole, 1) << desk.panels.keyboard.focus;
    }
    EXPECT_EQ(desk.panels.keyboard.focus, "gallery.04-coward");
}

TEST_F(Gallery, TellsExercisesOfOneNumberApartByALetter) {
    const Ui ui{desk.strings, palette(Theme::dark), {}, 1, desk.anchors, desk.asked};
    const std::vector<CatalogueEntry> two{{"14-logic", "a.toml", "Logic", "", 14},
                                          {"14-xor", "b.toml", "Either", "", 14},
                                          {"15-t", "c.toml", "T", "", 15}};
    desk.view.documents.catalogue = &two;
    EXPECT_EQ(entry_words(desk.view, ui, two[0]), "14a  Logic");
    EXPECT_EQ(entry_words(desk.view, ui, two[1]), "14b  Either");
    EXPECT_EQ(entry_words(desk.view, ui, two[2]), "15  T");
}

TEST_F(Gallery, NamesAnExerciseByItsGoalUntilThePredictionIsMade) {
    open_browser();
    EXPECT_FALSE(desk.says("Aggressor"));
    EXPECT_TRUE(desk.says("Make this shy vehicle"));
    EXPECT_EQ(
        entry_words(desk.view,
                    *std::make_unique<Ui>(Ui{desk.strings, palette(Theme::dark), {}, 1, desk.anchors, desk.asked}),
                    catalogue[3]),
        "A scene");
    students.student().exercises["05-aggressor"].prediction = "It turns away from the lamp";
    desk.frame(2);
    EXPECT_TRUE(desk.says("Aggressor"));
    EXPECT_FALSE(desk.says("Coward"));
    students.student().exercises["04-coward"] = {.passed = true, .best = 9, .starts = 10};
    desk.frame(2);
    EXPECT_TRUE(desk.says("Coward"));
    EXPECT_TRUE(desk.says("9/10"));
}

TEST_F(Gallery, TheOpenExerciseHasTheTitleThatItsCardShows) {
    desk.open_exercise();
    desk.view.documents.opened = desk.opened.id;
    open_browser();
    EXPECT_FALSE(desk.says("Aggressor"));
    desk.lesson.attempt.answers.prediction = 0;
    desk.lesson.attempt.work.has_run = true;
    desk.frame(2);
    EXPECT_TRUE(is_title_known(desk.view, catalogue[1]));
}

TEST_F(Gallery, MenuAndRecentFilesTellNoOutcomeEither) {
    desk.click("menu.exercises");
    desk.frame(2);
    EXPECT_FALSE(desk.says("Aggressor"));
    students.student().exercises["05-aggressor"] = {.passed = true, .best = 8, .starts = 10};
    desk.frame(2);
    EXPECT_TRUE(desk.says("Aggressor"));
    EXPECT_TRUE(desk.says("8/10"));
    students.student().exercises.clear();
    desk.key({key::escape});
    desk.frame(2);
    desk.click("menu.file");
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("menu.file.recent.1"));
    EXPECT_FALSE(desk.says("Aggressor"));
}

TEST_F(Gallery, TheMenuShowsTheFirstSentenceOfAGoal) {
    ASSERT_NE(catalogue[2].exercise->goal.find(". "), std::string::npos);
    desk.click("menu.exercises");
    desk.frame(2);
    EXPECT_TRUE(desk.says("Ignore the dim lamp, strike the bright one."));
    EXPECT_FALSE(desk.says("threshold of both wires"));
}

TEST_F(Gallery, TheCheckMarkInTheMenuSaysPassedOnly) {
    desk.view.documents.opened = "05-aggressor";
    desk.click("menu.exercises");
    desk.frame(2);
    EXPECT_FALSE(desk.says(icon::check)) << "the open exercise has another sign";
    students.student().exercises["05-aggressor"] = {.passed = true, .best = 8, .starts = 10};
    desk.frame(2);
    EXPECT_TRUE(desk.says(icon::check));
}

TEST_F(Gallery, TypingSearchesAndEnterOpensTheFirstMatch) {
    open_browser();
    for (const char c : std::string("SCENE TURNS")) desk.key({c});
    desk.frame(3);
    EXPECT_TRUE(desk.says("scene turns"));
    EXPECT_FALSE(desk.anchors.find("gallery.04-coward"));
    ASSERT_TRUE(desk.anchors.find("open.2a-coward"));
    EXPECT_EQ(desk.panels.keyboard.focus, "open.2a-coward");
    desk.key({key::enter});
    desk.frame(2);
    ASSERT_TRUE(desk.last<OpenRequest>());
    EXPECT_EQ(desk.last<OpenRequest>()->path, "/x/2a-coward.toml");
}

TEST_F(Gallery, EnterOpensTheBestHitBeItASceneOrALecture) {
    catalogue.push_back({"further", "/x/further.toml", "Further", "A coward that drives further than 4 m."});
    catalogue.push_back({"moth", "/x/moth.toml", "The cowardly moth", ""});
    const std::vector<CatalogueEntry> lectures{{"numbers", "/x/numbers.toml", "Moth numbers", ""}};
    desk.view.documents.lectures = &lectures;
    for (const auto& [typed, best] : {std::pair{"FURTHER", "open.further"},
                                      {"MOTH", "open.numbers"},
                                      {"COWARDLY", "open.moth"},
                                      {"4", "gallery.04-coward"}}) {
        open_browser();
        for (const char c : std::string(typed)) desk.key({c});
        desk.frame(3);
        EXPECT_EQ(desk.panels.keyboard.focus, best) << typed;
        desk.all.clear();
        desk.key({key::enter});
        desk.frame(2);
        EXPECT_TRUE(desk.last<OpenRequest>()) << typed;
        desk.panels.sheet = Sheet::none;
        desk.frame(2);
    }
}

TEST_F(Gallery, InALectureASearchFindsTheSceneFirstAlsoWhileItAsksFirst) {
    catalogue.back().title = "Vehicle 2a: Coward";
    catalogue.push_back({"2b-aggressor", "/x/2b-aggressor.toml", "Vehicle 2b: Aggressor", "It hits the lamp."});
    students.student().exercises["05-aggressor"] = {.passed = true, .best = 8, .starts = 10};
    students.student().exercises["04-coward"] = {.passed = true, .best = 8, .starts = 10};
    desk.view.lecture = true;
    for (const bool asks_first : {false, true})
        for (const auto& [typed, best] : {std::pair{"AGGRESSOR", "open.2b-aggressor"},
                                          {"COWARD", "open.2a-coward"},
                                          {"GGR", "open.2b-aggressor"},
                                          {"5", "gallery.05-aggressor"}}) {
            if (asks_first) desk.view.settings.revealed = hidden_until_asked;
            open_browser();
            for (const char c : std::string(typed)) desk.key({c});
            desk.frame(3);
            EXPECT_EQ(desk.panels.keyboard.focus, best) << typed << asks_first;
            desk.panels.sheet = Sheet::none;
            desk.frame(2);
        }
}

TEST_F(Gallery, CtrlASelectsWhatIsSearchedAndTheNextLetterReplacesIt) {
    open_browser();
    for (const char c : std::string("AGGR")) desk.key({c});
    desk.frame(3);
    desk.key({'A', true});
    desk.frame(2);
    desk.key({'T'});
    desk.frame(3);
    EXPECT_EQ(desk.panels.sheets.files.search, "t");
    desk.key({'U'});
    desk.key({'A', true});
    desk.key({key::backspace});
    desk.frame(3);
    EXPECT_EQ(desk.panels.sheets.files.search, "");
}

TEST_F(Gallery, ASearchShowsNoHeadingOfAnEmptyList) {
    open_browser();
    const float narrow = desk.where("gallery.05-aggressor").x;
    EXPECT_TRUE(desk.says("SCENES"));
    desk.panels.sheets.files.search = "shy";
    desk.frame(3);
    EXPECT_TRUE(desk.says("EXERCISES"));
    EXPECT_FALSE(desk.says("SCENES"));
    EXPECT_LT(desk.where("gallery.05-aggressor").x, narrow) << "it is the first one";
    desk.panels.sheets.files.search = "it turns away";
    desk.frame(3);
    EXPECT_TRUE(desk.says("SCENES"));
    EXPECT_FALSE(desk.says("EXERCISES"));
}

TEST_F(Gallery, ATileHasTheLetterOfItsExerciseAlsoInASearch) {
    catalogue = {entry_of("14-logic"), entry_of("14-xor")};
    open_browser();
    EXPECT_TRUE(desk.says("14a"));
    EXPECT_TRUE(desk.says("14b"));
    desk.panels.sheets.files.search = "exactly";
    desk.frame(3);
    EXPECT_FALSE(desk.says("14a"));
    EXPECT_TRUE(desk.says("14b")) << "it keeps its letter";
}

TEST_F(Gallery, TheSearchFindsWordsWithAccentsByPlainLetters) {
    catalogue.back().title = "Über die große Brücke, mañana";
    for (const char* typed : {"UBER", "GROSSE", "BRUCKE", "MANANA"}) {
        open_browser();
        for (const char c : std::string(typed)) desk.key({c});
        desk.frame(3);
        EXPECT_TRUE(desk.anchors.find("open.2a-coward")) << typed;
        EXPECT_FALSE(desk.anchors.find("gallery.04-coward")) << typed;
        desk.key({key::escape}), desk.key({key::escape});
    }
}

TEST_F(Gallery, ListsTheLecturesThatShipAndFindsThem) {
    const std::vector<CatalogueEntry> lectures{{"numbers", "/x/numbers.toml", "Four numbers", ""}};
    desk.view.documents.lectures = &lectures;
    open_browser();
    EXPECT_TRUE(desk.says(desk.strings("open.lectures")));
    EXPECT_GT(desk.where("open.numbers").y, desk.where("open.2a-coward").y);
    for (const char c : std::string("NUMBERS")) desk.key({c});
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("open.2a-coward"));
    EXPECT_EQ(desk.panels.keyboard.focus, "open.numbers");
    for (int i = 0; i < 7; ++i) desk.key({key::backspace});
    catalogue.pop_back();  // the scene
    desk.frame(3);
    desk.panels.keyboard.focus = "gallery.05-aggressor";
    desk.key({key::right});
    desk.frame(2);
    EXPECT_EQ(desk.panels.keyboard.focus, "open.numbers") << "lectures are to the right of the exercises, too";
    desk.click("open.numbers");
    ASSERT_TRUE(desk.last<OpenRequest>());
    EXPECT_EQ(desk.last<OpenRequest>()->path, "/x/numbers.toml");
}

TEST_F(Gallery, EscapeEmptiesTheSearchBeforeItCloses) {
    open_browser();
    desk.key({'Q'});
    desk.key({'7'});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("gallery.04-coward"));
    EXPECT_TRUE(desk.says(fill(desk.strings("files.no_match"), {std::string(desk.strings("files.folder"))})));
    desk.key({key::backspace});
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("gallery.04-coward"));
    EXPECT_EQ(desk.panels.sheet, Sheet::files);
    desk.key({key::escape});
    EXPECT_EQ(desk.panels.sheet, Sheet::none);
}

TEST_F(Gallery, TheSearchTellsNoOutcome) {
    open_browser();
    for (const char c : std::string("AGGRESSOR")) desk.key({c});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("gallery.05-aggressor"));
    students.student().exercises["05-aggressor"] = {.passed = true, .best = 8, .starts = 10};
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("gallery.05-aggressor"));
}

TEST_F(Gallery, DrawsTheRenderedPictureOfAFile) {
    const auto textures = [] {
        std::vector<ImTextureID> found;
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int l = 0; l < data.CmdListsCount; ++l)
            for (const ImDrawCmd& command : data.CmdLists[l]->CmdBuffer) found.push_back(command.GetTexID());
        return found;
    };
    ScenePictures pictures{{"/x/04-coward.toml", 4711}, {"/x/2a-coward.toml", 4712}, {"/x/05-aggressor.toml", 0}};
    desk.view.documents.pictures = &pictures;
    open_browser();
    const auto drawn = textures();
    for (const std::uint64_t id : {4711U, 4712U})
        EXPECT_EQ(std::count(drawn.begin(), drawn.end(), compat::texture(id)), 1) << id;
    EXPECT_TRUE(desk.anchors.find("gallery.05-aggressor")) << "without one, a drawing";
}

TEST(ScenePicture, TheVehicleOfTheSelectionIsLegibleOnItsTable) {
    const Kind kind = shipped_exercise("20-selection")->scene.kinds.at(0);
    const auto colour = colour_of(kind.colour);
    ASSERT_TRUE(colour);
    for (const Theme theme : {Theme::dark, Theme::light})
        EXPECT_GE(contrast(*colour, palette(theme).tape), 3) << word(theme);
    EXPECT_GE(contrast(*colour, palette(Theme::light).floor), 3);
}

TEST(ScenePicture, ShowsThePartOfTheFloorThatIsOccupied) {
    Scene scene;
    scene.arena.width = scene.arena.height = 20;
    EXPECT_FLOAT_EQ(occupied_area(scene).high.x, 10) << "an empty scene: the arena";
    scene.sources.push_back({.name = "lamp", .x = 9.5f, .y = 2});
    const FloorArea area = occupied_area(scene);
    EXPECT_FLOAT_EQ(area.high.x, 10) << "not beyond the arena";
    EXPECT_LT(area.low.x, 7);
    EXPECT_GE(area.high.y - area.low.y, 5.9f);
    const FloorMap map(area, {100, 100, 80, 60});
    const ImVec2 lamp = map({9.5f, 2});
    EXPECT_TRUE((Rect{100, 100, 80, 60}.contains(lamp.x, lamp.y)));
    EXPECT_LT(map({9, 3}).y, lamp.y) << "y is up";
}

TEST(ScenePicture, DiffersBetweenTheFirstExercises) {
    for (const char* id : {"01-drive", "02-circle", "04-coward"}) {
        const Scene scene = shipped_exercise(id)->scene;
        const FloorArea area = occupied_area(scene);
        EXPECT_LT(area.high.x - area.low.x, scene.arena.width + 0.1f) << id;
    }
}

TEST_F(Gallery, NamesAnExerciseWithoutAPredictionByItsTitle) {
    auto plain = std::make_shared<Exercise>(*catalogue[1].exercise);
    plain->prediction = {};
    catalogue[1].exercise = plain;
    open_browser();
    EXPECT_TRUE(desk.says("Aggressor"));
    EXPECT_FALSE(desk.says("Coward"));
}

TEST_F(Gallery, TheMarkOfAnExercisePassedByTheShownSolutionIsARing) {
    open_browser();
    const auto accents = [&](bool shown) {
        students.student().exercises["05-aggressor"] = {.passed = true, .shown = shown};
        desk.point(1, 1);
        desk.frame(60);
        const Rect card = desk.where("gallery.05-aggressor");
        const ImVec2 mark{card.x + card.w - 21, card.y + 21};
        int centre = 0;  // vertices of the sign inside the mark that have the colour of the accent
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int l = 0; l < data.CmdListsCount; ++l)
            for (const ImDrawVert& v : data.CmdLists[l]->VtxBuffer)
                centre +=
                    std::hypot(v.pos.x - mark.x, v.pos.y - mark.y) < 6 && v.col == paint(palette(Theme::dark).accent);
        return centre;
    };
    EXPECT_GT(accents(true), accents(false));
}

}  // namespace braitenlab::tests::gallery_test
