// The sheet of a breeding (ui/panels/breeding/breeding_sheet.cpp).
#include <algorithm>
#include <map>
#include <string>

#include "breeding_on_desk.h"
#include "core/evolve/scene_breeding.h"
#include "core/scene/scene_file.h"
#include "desk.h"

namespace braitenlab::tests::breeding_sheet_test {

using namespace ui;

namespace {

struct BreedingDesk : testing::Test {
    Desk desk;

    const BreedingRequest* asked_for(BreedingEdit edit) const {
        const auto* last = desk.last<BreedingRequest>();
        return last && last->edit == edit ? last : nullptr;
    }
};

TEST_F(BreedingDesk, TheMenuOpensItAndTheFirstBreedingIsOpened) {
    BredOnDesk bred(0);
    desk.view.features.breeding.shipped = &bred.shipped;
    desk.panels.menu_bar.open = "simulation";
    desk.frame(3);
    desk.click("menu.simulation.breeding");
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::breeding);
    ASSERT_TRUE(asked_for(BreedingEdit::open));
    EXPECT_EQ(desk.last<BreedingRequest>()->path, "chase");
}

TEST_F(BreedingDesk, StartStopAndContinueAreRequests) {
    BredOnDesk none(0);
    none.show(desk);
    desk.frame(3);
    EXPECT_TRUE(desk.says("Start"));
    desk.click("breeding.start");
    EXPECT_TRUE(asked_for(BreedingEdit::run));
    desk.view.features.breeding.runs = true;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("breeding.start"));
    desk.click("breeding.stop");
    EXPECT_TRUE(asked_for(BreedingEdit::stop));
    BredOnDesk some(7);
    some.show(desk);
    desk.view.features.breeding.runs = false;
    desk.frame(2);
    EXPECT_TRUE(desk.says("Continue"));
    EXPECT_TRUE(desk.says("Generation 6 of 40"));
    BredOnDesk all(41, 2);
    all.show(desk);
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("breeding.complete"));
}

TEST_F(BreedingDesk, SaysHowMuchTimeIsLeftWhileItRuns) {
    BredOnDesk some(7);
    some.show(desk);
    desk.frame(2);
    EXPECT_FALSE(desk.says("left"));
    desk.view.features.breeding.runs = true;
    desk.view.features.breeding.seconds_left = 38.0f;
    desk.frame(2);
    EXPECT_TRUE(desk.says("about 40 s left"));
    desk.view.features.breeding.seconds_left = 200.0f;
    desk.frame(2);
    EXPECT_TRUE(desk.says("about 4 min left"));
}

TEST(BreedingButtons, StayInTheirPlacesWhateverTheFirstOneSays) {
    for (const std::string& language : shipped_codes()) {
        Desk desk(1280, 800, 1, true);
        desk.strings = speaking(language);
        BredOnDesk none(0), some(7), all(41, 2);
        std::map<std::string, float> x;
        const auto same_places = [&](BredOnDesk& bred, bool runs) {
            bred.show(desk);
            desk.view.features.breeding.runs = runs;
            desk.frame(3);
            for (const char* id : {"breeding.match", "breeding.take", "breeding.close"})
                EXPECT_NEAR(x.try_emplace(id, desk.where(id).x).first->second, desk.where(id).x, 0.5f)
                    << language << id;
        };
        same_places(none, false);
        same_places(none, true);
        same_places(some, false);
        same_places(some, true);
        same_places(all, false);
    }
}

// In a low window Start folds the choices; the figures then take their room.
TEST(BreedingRows, StayInTheirPlacesFromStartToEnd) {
    struct Size {
        float width, height;
    };
    for (const Size size : {Size{800, 600}, {1024, 768}, {1280, 1000}})
        for (const std::string& language : shipped_codes()) {
            SCOPED_TRACE(language + " " + std::to_string(size.width));
            Desk desk(size.width, size.height, 1, true);
            desk.strings = speaking(language);
            BredOnDesk none(0), some(7), all(41, 2);
            none.show(desk);
            desk.frame(5);
            const Rect sheet = desk.where("card.breeding");
            desk.click("breeding.start");
            BreedingView& view = desk.view.features.breeding;
            std::map<std::string, Rect> before;
            const auto same_places = [&](const char* when) {
                desk.frame(5);
                EXPECT_NEAR(desk.where("card.breeding").h, sheet.h, 1) << when;
                EXPECT_NEAR(desk.where("card.breeding").y, sheet.y, 1) << when;
                for (const char* id : {"breeding.curves", "breeding.matrix", "breeding.words", "breeding.close"}) {
                    const Rect now = desk.where(id), was = before.try_emplace(id, now).first->second;
                    EXPECT_NEAR(now.y, was.y, 0.5f) << when << id;
                    EXPECT_NEAR(now.h, was.h, 0.5f) << when << id;
                }
            };
            view.runs = true;
            same_places("the panel is bred: ");
            some.show(desk);
            view.seconds_left = 115.0f;
            same_places("it runs: ");
            all.show(desk);
            view.runs = false, view.seconds_left.reset();
            same_places("the end: ");
            for (evolve::Verdict& verdict : view.verdicts)
                verdict = {evolve::Course::circles, {100, 199}, {100, 199}, -0.3f};
            same_places("round in circles: ");
            for (evolve::Verdict& verdict : view.verdicts) verdict.course = evolve::Course::unclear;
            same_places("no clear change: ");
        }
}

// In an exercise that is solved by breeding.
void open_bred_exercise(Desk& desk) {
    desk.opened.offers = {"LL", "breeding:chase"};
    desk.open_exercise();
}

TEST(BreedingInAnExercise, ShowsWhatItsStepsNeedAndUnfoldsTheRest) {
    constexpr const char* of_steps[]{"breeding.hint",           "breeding.against.best_of_last",
                                     "breeding.against.random", "breeding.matrix",
                                     "breeding.duel.1",         "breeding.start",
                                     "breeding.take",           "breeding.close"};
    constexpr const char* of_rest[]{"breeding.against.generalist",
                                    "breeding.open.flee",
                                    "breeding.open_scene",
                                    "breeding.seed",
                                    "breeding.curves",
                                    "breeding.words",
                                    "breeding.match"};
    for (const auto& [width, height] : {std::pair{800.0f, 600.0f}, {1280.0f, 800.0f}})
        for (const std::string& language : shipped_codes()) {
            SCOPED_TRACE(language + " " + std::to_string(width));
            Desk desk(width, height, 1, true);
            desk.strings = speaking(language);
            open_bred_exercise(desk);
            desk.frame(5);
            const int shortened = desk.shortened;
            BredOnDesk bred(21);
            bred.show(desk), bred.watch(desk, {18, 16}, {20, 10});
            desk.frame(5);
            for (const char* id : of_steps) EXPECT_TRUE(desk.anchors.find(id)) << id;
            for (const char* id : of_rest) EXPECT_FALSE(desk.anchors.find(id)) << id;
            EXPECT_TRUE(desk.says(desk.strings("breeding.score_1"))) << "the legend is seen without scrolling";
            EXPECT_LT(desk.where("breeding.matrix").y + desk.where("breeding.matrix").h,
                      desk.where("breeding.close").y);
            EXPECT_EQ(desk.shortened, shortened) << "no text is cut";
            desk.click("breeding.choices");
            desk.frame(3);
            for (const char* id : {"breeding.against.generalist", "breeding.open.flee", "breeding.match"})
                EXPECT_TRUE(desk.anchors.find(id)) << id;
        }
}

TEST(BreedingInAnExercise, NothingMovesFromStartToEnd) {
    Desk desk(800, 600, 1, true);
    open_bred_exercise(desk);
    BredOnDesk none(0), some(7), all(41, 2);
    std::map<std::string, Rect> before;
    const auto same_places = [&](BredOnDesk& bred, bool runs) {
        bred.show(desk);
        desk.view.features.breeding.runs = runs;
        desk.frame(5);
        for (const char* id : {"breeding.hint", "breeding.matrix", "breeding.close"}) {
            const Rect now = desk.where(id), was = before.try_emplace(id, now).first->second;
            EXPECT_NEAR(now.y, was.y, 0.5f) << id;
            EXPECT_NEAR(now.h, was.h, 0.5f) << id;
        }
    };
    same_places(none, false);
    same_places(some, true);
    EXPECT_TRUE(desk.says(desk.strings("breeding.while_it_runs").substr(0, 20))) << "how the matrix is read";
    same_places(all, false);
}

TEST_F(BreedingDesk, TheButtonNamesTheChampionsThatItTakes) {
    BredOnDesk none(0), bred(5), flee(5, 1, "flee");
    none.show(desk);
    desk.frame(3);
    EXPECT_TRUE(desk.says("Take predator … and prey …"));
    bred.show(desk);
    desk.frame(2);
    EXPECT_TRUE(desk.says("Take predator 4 and prey 4"));
    bred.watch(desk, {3, 1}, {0, 0});
    desk.frame(2);
    EXPECT_TRUE(desk.says("Take predator 3 and prey 1"));
    flee.show(desk);
    desk.frame(2);
    EXPECT_TRUE(desk.says("Take prey 1")) << "the predators do not evolve";
    bred.show(desk);
    const auto scene = desk.now.scene;
    desk.open_exercise();
    desk.now.scene = scene;  // its first start is a predator's
    auto started = std::make_shared<Scene>(*scene);
    Start& start = started->starts.emplace_back();
    start.kind = "predator";
    desk.now.scene = started;
    desk.frame(2);
    EXPECT_TRUE(desk.says("Take predator 3")) << "an exercise takes its vehicle's only";
    EXPECT_FALSE(desk.says("Take predator 3 and"));
}

TEST_F(BreedingDesk, SaysWhatTheChosenOpponentsAre) {
    BredOnDesk bred(3);
    bred.show(desk);
    desk.frame(3);
    EXPECT_TRUE(desk.says(desk.strings("breeding.opponents_best_of_last_how")));
    EXPECT_FALSE(desk.says(desk.strings("breeding.opponents_random_how")));
}

TEST_F(BreedingDesk, SaysWhatTheTwoCurvesMeasure) {
    BredOnDesk bred(9);
    bred.show(desk);
    desk.frame(3);
    desk.point("breeding.score_panel");
    desk.frame(60);
    EXPECT_TRUE(desk.says("stay the same for every generation"));
    desk.point("breeding.score_opponents");
    desk.frame(60);
    EXPECT_TRUE(desk.says("They change, too"));
}

// The sheet's body is between its heading and its buttons; what is beyond would have to be scrolled to.
void expect_figures_to_be_seen(const Desk& desk, int shortened_without, const std::string& where) {
    const Rect sheet = desk.where("card.breeding"), fold = desk.where("breeding.choices");
    const float end = desk.where("breeding.close").y;
    std::vector<Rect> figures;
    for (const char* id : {"breeding.curves", "breeding.matrix", "breeding.duel.1", "breeding.duel.2"}) {
        const Rect r = desk.where(id);
        EXPECT_GT(r.y, fold.y) << where << id;
        EXPECT_LT(r.y + r.h, end) << where << id;
        EXPECT_GT(r.x, sheet.x) << where << id;
        EXPECT_LT(r.x + r.w, sheet.x + sheet.w) << where << id;
        for (const Rect& other : figures)
            EXPECT_TRUE(r.x >= other.x + other.w || other.x >= r.x + r.w) << where << id << " is beside the others";
        figures.push_back(r);
    }
    EXPECT_GT(figures[1].w, 150) << where;
    EXPECT_GT(figures[2].w, 80) << where;
    EXPECT_TRUE(desk.says(desk.strings("breeding.score_1"))) << where << "the legend of the matrix";
    EXPECT_EQ(desk.shortened, shortened_without) << where << "no text is cut";
}

TEST(BreedingFigures, AreSeenWithoutScrollingWhileItRuns) {
    struct Size {
        float width, height;
    };
    for (const Size size : {Size{800, 600}, {1024, 768}, {1280, 800}})
        for (const Language& language : shipped_languages()) {
            Desk desk(size.width, size.height, 1, true);
            desk.strings = speaking(language.code);
            desk.frame(5);
            const int shortened = desk.shortened;
            BredOnDesk bred(21);
            bred.show(desk), bred.watch(desk, {18, 16}, {20, 10});
            desk.frame(5);
            desk.click("breeding.start");
            desk.view.features.breeding.runs = true, desk.view.features.breeding.seconds_left = 38.0f;
            desk.frame(5);
            EXPECT_FALSE(desk.anchors.find("breeding.seed")) << "Start folds the choices";
            expect_figures_to_be_seen(desk, shortened, language.code + " " + std::to_string(size.width) + " ");
            desk.click("breeding.choices");
            desk.frame(2);
            EXPECT_TRUE(desk.anchors.find("breeding.seed")) << "and they can be unfolded";
        }
}

TEST_F(BreedingDesk, OtherOpponentsAndNumbersAreAChoice) {
    BredOnDesk bred(3);
    bred.show(desk);
    desk.frame(3);
    desk.click("breeding.against.best_of_last");
    EXPECT_FALSE(asked_for(BreedingEdit::choose)) << "those of the file";
    desk.click("breeding.against.archive");
    ASSERT_TRUE(asked_for(BreedingEdit::choose));
    EXPECT_EQ(desk.last<BreedingRequest>()->choice->opponents, evolve::Opponents::archive);
    desk.type_into("breeding.generations", "60");
    EXPECT_EQ(desk.last<BreedingRequest>()->choice->generations, 60);
    EXPECT_EQ(desk.last<BreedingRequest>()->choice->opponents, evolve::Opponents::best_of_last) << "of the open one";
    desk.type_into("breeding.seed", "7");
    EXPECT_EQ(desk.last<BreedingRequest>()->choice->seed, 7u);
    desk.type_into("breeding.population", "12");
    EXPECT_EQ(desk.last<BreedingRequest>()->choice->population, 12);
    desk.click("breeding.open.flee");
    ASSERT_TRUE(asked_for(BreedingEdit::open));
    EXPECT_EQ(desk.last<BreedingRequest>()->path, "flee");
}

TEST_F(BreedingDesk, ADraggedNumberIsAChoiceWhenTheMouseIsReleased) {
    BredOnDesk bred(3);
    bred.show(desk);
    desk.frame(3);
    const std::size_t before = desk.all.size();
    desk.point("breeding.seed", 0.6f);
    desk.frame(2);
    desk.button(0, true);
    for (const float at : {0.6f, 0.65f, 0.7f}) desk.point("breeding.seed", at), desk.frame(2);
    EXPECT_EQ(desk.all.size(), before) << "no breeding for each number on the way";
    desk.button(0, false);
    desk.frame(2);
    ASSERT_EQ(desk.all.size(), before + 1);
    ASSERT_TRUE(asked_for(BreedingEdit::choose));
    EXPECT_GT(desk.last<BreedingRequest>()->choice->seed, 5u);
}

TEST_F(BreedingDesk, TheOpenSceneIsBredWithWhatMayChange) {
    BredOnDesk bred(3);
    bred.show(desk);
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("breeding.may_eyes"));
    desk.click("breeding.open_scene");
    ASSERT_TRUE(asked_for(BreedingEdit::scene));
    EXPECT_EQ(*desk.last<BreedingRequest>()->may, evolve::MayChange{});
    auto own = evolve::breeding_of_scene(bred.base->scene(), {}, desk.now.scene->title);
    auto read = evolve::parse_breeding(write_breeding(own.breeding), "scene.toml");
    ASSERT_TRUE(read) << read.error().text();
    bred.base = *evolve::BreedingBase::create(std::move(*read), write_scene(own.scene), "scene");
    bred.state = begin_breeding(*bred.base), bred.matrix = {};
    bred.show(desk);
    desk.frame(2);
    desk.click("breeding.may_eyes");
    ASSERT_TRUE(asked_for(BreedingEdit::scene));
    EXPECT_FALSE(desk.last<BreedingRequest>()->may->eyes);
    EXPECT_TRUE(desk.last<BreedingRequest>()->may->weights);
}

TEST_F(BreedingDesk, TheOneOfTheLastStartIsOpenedFirst) {
    BredOnDesk bred(0);
    desk.view.features.breeding.shipped = &bred.shipped;
    desk.view.features.breeding.last = "/kept/breeding.toml";
    desk.panels.sheet = Sheet::breeding;
    desk.frame(2);
    ASSERT_TRUE(asked_for(BreedingEdit::open));
    EXPECT_EQ(desk.last<BreedingRequest>()->path, "/kept/breeding.toml");
}

TEST_F(BreedingDesk, AClickOnACellWatchesItsMatchInEveryLanguage) {
    BredOnDesk bred(41, 2);
    bred.show(desk);
    for (const Language& language : shipped_languages()) {
        SCOPED_TRACE(language.code);
        desk.strings = speaking(language.code);
        desk.frame(4);
        EXPECT_FALSE(desk.anchors.find("breeding.cell.1.0")) << "every second generation";
        for (const BreedingCell cell : {BreedingCell{0, 0}, {40, 0}, {0, 40}, {18, 6}, {40, 40}}) {
            desk.click("breeding.cell." + std::to_string(cell.predator) + "." + std::to_string(cell.prey));
            ASSERT_TRUE(asked_for(BreedingEdit::watch));
            EXPECT_EQ(desk.last<BreedingRequest>()->cell, cell);
        }
    }
}

TEST_F(BreedingDesk, ThePredatorsAreUpwardsAndThePreyAcross) {
    BredOnDesk bred(5);
    bred.show(desk);
    desk.frame(3);
    const Rect first = desk.where("breeding.cell.0.0"), up = desk.where("breeding.cell.1.0"),
               across = desk.where("breeding.cell.0.1");
    EXPECT_LT(up.y, first.y);
    EXPECT_EQ(up.x, first.x);
    EXPECT_GT(across.x, first.x);
    EXPECT_EQ(across.y, first.y);
    BredOnDesk more(9);
    more.show(desk);
    desk.frame(2);
    EXPECT_EQ(desk.where("breeding.cell.0.0").x, first.x) << "cells keep their size while it grows";
    EXPECT_EQ(desk.where("breeding.cell.0.0").w, first.w);
}

TEST_F(BreedingDesk, ArrowKeysWatchTheNextMatch) {
    BredOnDesk bred(5);
    bred.show(desk);
    bred.watch(desk, {2, 3}, {0, 0});
    desk.frame(3);
    desk.panels.keyboard.focus = "breeding.matrix";
    desk.frame(2);
    desk.panels.keyboard.presses.push_back({key::left});
    desk.frame(1);
    ASSERT_TRUE(asked_for(BreedingEdit::watch));
    EXPECT_EQ(desk.last<BreedingRequest>()->cell, (BreedingCell{2, 2}));
    desk.panels.keyboard.presses.push_back({key::right});
    desk.frame(1);
    EXPECT_EQ(desk.last<BreedingRequest>()->cell, (BreedingCell{2, 4}));
}

TEST_F(BreedingDesk, TheWatchedMatchIsOpenedOrTaken) {
    BredOnDesk bred(5);
    bred.show(desk);
    desk.frame(3);
    desk.click("breeding.match");
    ASSERT_TRUE(asked_for(BreedingEdit::match));
    EXPECT_EQ(desk.last<BreedingRequest>()->cell, (BreedingCell{4, 4})) << "without one that of the last champions";
    EXPECT_EQ(desk.panels.sheet, Sheet::none);
    desk.panels.sheet = Sheet::breeding;
    bred.watch(desk, {3, 1}, {0, 0});
    desk.frame(2);
    EXPECT_TRUE(desk.says("Predator 3 · prey 1"));
    EXPECT_TRUE(desk.says("eaten after 5.0 s"));
    EXPECT_TRUE(desk.says("lives for 5.0 s"));
    desk.click("breeding.take");
    ASSERT_TRUE(asked_for(BreedingEdit::take));
    EXPECT_EQ(desk.last<BreedingRequest>()->cell, (BreedingCell{3, 1}));
    EXPECT_EQ(desk.last<BreedingRequest>()->title, "Chase, against the last champions: predator 3, prey 1");
}

TEST_F(BreedingDesk, NamesTheRunOfTheCellThatIsWatchedInEveryLanguage) {
    BredOnDesk bred(5);
    bred.show(desk), bred.watch(desk, {3, 1}, {0, 0});
    for (const std::string& language : shipped_codes()) {
        SCOPED_TRACE(language);
        desk.strings = speaking(language);
        const std::string seconds = language == "en" ? "5.0" : "5,0";
        const std::string eaten = fill(desk.strings("breeding.eaten"), {seconds}),
                          lives = fill(desk.strings("breeding.lives"), {seconds});
        desk.view.features.breeding.start = {0, 2};
        desk.frame(3);
        EXPECT_TRUE(desk.says(fill(desk.strings("breeding.run_of_match"), {"3", "4", eaten})));
        EXPECT_TRUE(desk.says(fill(desk.strings("breeding.same_start"), {lives})));
        desk.view.features.breeding.start = {1, 0};
        desk.frame(3);
        EXPECT_TRUE(desk.says(fill(desk.strings("breeding.same_start"), {eaten})));
        EXPECT_TRUE(desk.says(fill(desk.strings("breeding.run_of_match"), {"1", "4", lives})));
    }
}

TEST_F(BreedingDesk, AsksForAClickOnceThereIsACell) {
    BredOnDesk none(0), some(3);
    const std::string words(desk.strings("breeding.watch_how").substr(0, 12));
    none.show(desk);
    desk.view.features.breeding.runs = true;
    desk.frame(3);
    EXPECT_FALSE(desk.says(words));
    some.show(desk);
    desk.frame(3);
    EXPECT_TRUE(desk.says(words));
}

TEST_F(BreedingDesk, ShowsTheChampionsOfThePanelWhileItIsBred) {
    BredOnDesk none(0);
    none.show(desk), none.watch(desk, {7, 7}, {0, 0});
    BreedingView& view = desk.view.features.breeding;
    view.runs = view.watches_by_itself = view.watches_panel = true;
    desk.frame(3);
    EXPECT_TRUE(desk.says(fill(desk.strings("breeding.panel_duel"), {"7"})));
    EXPECT_TRUE(desk.says(desk.strings("breeding.empty_panel").substr(0, 18))) << "why there is no matrix yet";
    EXPECT_FALSE(desk.says(desk.strings("breeding.nearest_start"))) << "there is no cell";
    const std::size_t before = desk.all.size();
    desk.click("breeding.match");
    EXPECT_EQ(desk.all.size(), before) << "these cannot be opened";
}

TEST_F(BreedingDesk, SaysWhichRunsSelectAndHowManyACellHas) {
    BredOnDesk some(7);
    some.show(desk);
    for (const std::string& language : shipped_codes()) {
        desk.strings = speaking(language);
        desk.frame(3);
        EXPECT_TRUE(desk.says(fill(desk.strings("breeding.progress"), {"6", "40", "10", "15", "4"}))) << language;
    }
}

TEST_F(BreedingDesk, TakesTheLastChampionsUnlessAPersonHasChosenOthers) {
    BredOnDesk bred(5);
    bred.show(desk);
    bred.watch(desk, {3, 3}, {0, 0});
    desk.view.features.breeding.watches_by_itself = true;  // the match of generation 3 is not over yet
    desk.frame(3);
    desk.click("breeding.take");
    ASSERT_TRUE(asked_for(BreedingEdit::take));
    EXPECT_EQ(desk.last<BreedingRequest>()->cell, (BreedingCell{4, 4}));
}

TEST_F(BreedingDesk, WithoutAGenerationNothingCanBeTaken) {
    BredOnDesk none(0);
    none.show(desk);
    desk.frame(3);
    const std::size_t before = desk.all.size();
    desk.click("breeding.take");
    desk.click("breeding.match");
    EXPECT_EQ(desk.all.size(), before);
    EXPECT_EQ(desk.panels.sheet, Sheet::breeding);
}

TEST_F(BreedingDesk, SaysWhatTheMatrixShows) {
    BredOnDesk few(3);
    few.show(desk);
    desk.frame(3);
    EXPECT_TRUE(desk.says("From 8 generations on"));
    BredOnDesk race(41, 2);
    race.show(desk);
    desk.frame(2);
    EXPECT_TRUE(desk.says("The last predators (generations 30–40) do better against all earlier prey"));
    EXPECT_TRUE(desk.says("at least 0.1 of the score"));
    desk.view.features.breeding.verdicts[1] = {evolve::Course::circles, {30, 40}, {10, 18}, -0.3f};
    desk.frame(2);
    EXPECT_TRUE(desk.says("do worse against the predators of generations 10–18"));
    desk.view.features.breeding.verdicts[1].course = evolve::Course::unclear;
    desk.frame(2);
    desk.view.features.breeding.verdicts[1].gain = -0.03f;
    desk.frame(2);
    EXPECT_TRUE(
        desk.says("no clear change against earlier predators (−0.03 of the score against those of generations "
                  "10–18)"));
    EXPECT_TRUE(desk.says("The curve of the prey against opponents bred apart rises by 0.1"))
        << "of quarters of ten generations";
    for (evolve::Generation& each : at(race.state.main.generations, evolve::Side::prey)) each.panel = 0.4f;
    desk.frame(2);
    EXPECT_FALSE(desk.says("rises by"));
    EXPECT_TRUE(desk.says("at least 0.1 of the score"));
}

TEST_F(BreedingDesk, OneSideAloneHasNoPanelAndOneSentence) {
    BredOnDesk flee(21, 1, "flee");
    flee.show(desk);
    desk.frame(3);
    EXPECT_TRUE(desk.says("Best score against its own opponents"));
    EXPECT_FALSE(desk.says("Best score against the panel"));
    EXPECT_FALSE(desk.says("The last predators"));
    EXPECT_TRUE(desk.says("The last prey"));
}

}  // namespace

}  // namespace braitenlab::tests::breeding_sheet_test
