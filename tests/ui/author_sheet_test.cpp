// The sheet that saves the open scene as an exercise.
#include "core/lesson/author.h"
#include "desk.h"
#include "ui/widgets/drawn_text.h"

namespace braitenlab::tests::author_sheet_test {

using namespace ui;

struct AuthorSheet : ::testing::Test {
    Desk desk;
    FilesView files;
    AuthorSheet() {
        desk.now = shipped_scene("2a-coward");
        desk.view.documents.files = &files;
        desk.frame(3);
        desk.choose("file", "save_exercise");
        desk.frame(3);
    }
    void type(const char* field, const char* text) {
        desk.click(field);
        desk.type(text);
        desk.frame(2);
    }
    void page(int number) { desk.click("author.page." + std::to_string(number)); }
    // Everything that an exercise needs.
    void fill_in() {
        desk.type("Strike");  // the title has the focus, with its text selected
        desk.frame(2);
        type("author.goal", "Touch the lamp.");
        page(3);
    }
    const SaveExerciseRequest& saved() {
        desk.click("author.save");
        const auto* request = desk.last<SaveExerciseRequest>();
        if (!request) throw std::runtime_error("nothing is saved");
        return *request;
    }
};

TEST_F(AuthorSheet, SaysWhatIsMissingUntilItCanBeSaved) {
    ASSERT_TRUE(desk.anchors.find("card.author"));
    EXPECT_FALSE(desk.says("The goal is missing")) << "there was no try to save";
    desk.click("author.save");
    EXPECT_TRUE(desk.says("The goal is missing"));
    EXPECT_FALSE(desk.last<SaveExerciseRequest>());
    type("author.goal", "Touch the lamp.");
    EXPECT_TRUE(desk.says("Look at the steps first"));
    page(3);
    EXPECT_FALSE(desk.says("Look at the steps first"));
    EXPECT_EQ(saved().draft->goal, "Touch the lamp.");
}

TEST_F(AuthorSheet, BeginsWithTheTitleInTheLanguageOfTheWindow) {
    desk.strings.add(desk.now.scene->title, "Feigling");
    ++desk.view.run_id;
    desk.key({key::escape});
    desk.frame(2);
    desk.choose("file", "save_exercise");
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheets.author.title.text, "Feigling");
}

TEST_F(AuthorSheet, BeginsWithTheNearestLampTheDialsAndTheTitleOfTheScene) {
    EXPECT_EQ(desk.panels.sheets.author.title.text, desk.now.scene->title);
    fill_in();
    const SaveExerciseRequest request = saved();
    EXPECT_EQ(request.path, "strike") << "a file name for the title";
    EXPECT_FALSE(request.replace);
    const ExerciseDraft& draft = *request.draft;
    EXPECT_EQ(draft.title, "Strike");
    EXPECT_EQ(draft.offers, (std::vector<std::string>{"LL", "LR", "RL", "RR", "LM", "RM"}));
    ASSERT_EQ(draft.steps.size(), 1u);
    EXPECT_EQ(draft.steps[0].text, "It reaches the lamp");
    const auto* touches = std::get_if<goals::Touches>(&draft.steps[0].check.goal);
    ASSERT_TRUE(touches);
    EXPECT_EQ(touches->source, desk.now.scene->sources[0].name);
    EXPECT_GE(touches->metres, 0.5f);
    EXPECT_TRUE(draft.prediction.question.empty());
}

TEST_F(AuthorSheet, OffersTheControlsThatAreSwitchedOn) {
    fill_in();
    page(2);
    for (const char* dial : {"LL", "RR", "LM", "RM"}) desk.click(std::string("author.dial.") + dial);
    desk.click("author.part.curves");
    EXPECT_EQ(saved().draft->offers, (std::vector<std::string>{"LR", "RL", "curves"}));
    desk.click("author.all");
    EXPECT_TRUE(saved().draft->offers.empty()) << "all controls";
}

TEST_F(AuthorSheet, AStepTakesAnotherGoalWithItsTextAndValues) {
    fill_in();
    desk.click("author.goals");
    desk.frame(3);
    desk.click("author.goal.avoids");
    desk.frame(3);
    desk.type_into("author.value.metres", "2.5");
    desk.type_into("author.hold", "3");
    desk.click("author.step.add");
    desk.frame(2);
    const ExerciseDraft draft = *saved().draft;
    ASSERT_EQ(draft.steps.size(), 2u);
    EXPECT_EQ(draft.steps[0].text, "It never comes near the lamp");
    EXPECT_EQ(std::get<goals::Avoids>(draft.steps[0].check.goal).metres, 2.5f);
    EXPECT_EQ(draft.steps[0].check.hold, 3);
    desk.click("author.step.1");
    desk.click("author.step.remove");
    desk.frame(2);
    EXPECT_EQ(saved().draft->steps.size(), 1u);
    EXPECT_FALSE(desk.anchors.find("author.step.2"));
}

TEST_F(AuthorSheet, APredictionHasItsTrueAnswer) {
    fill_in();
    page(4);
    type("author.question", "Where does it drive?");
    desk.click("author.save");
    EXPECT_TRUE(desk.says("The question needs two answers"));
    type("author.option.2", "To the lamp");
    type("author.option.3", "To the lamp");
    EXPECT_TRUE(desk.says("Two answers are the same"));
    type("author.option.4", "Away");
    EXPECT_TRUE(desk.says("Two answers are the same"));
    desk.panels.sheets.author.options[2].text.clear();  // its field is no longer active and keeps no text of its own
    desk.frame(2);
    EXPECT_TRUE(desk.says("The true answer is empty"));
    desk.click("author.option.4.answer");
    const Prediction asked = saved().draft->prediction;
    EXPECT_EQ(asked.options, (std::vector<std::string>{"To the lamp", "Away"}));
    EXPECT_EQ(asked.answer, 1);
}

TEST_F(AuthorSheet, ArrowKeysGoOnInAListThatTheMouseHasOpened) {
    fill_in();
    for (const auto& [number, list, rows] :
         {std::tuple{3, "author.goals", "author.goal."}, {4, "author.shows", "author.shows."}}) {
        page(number);
        desk.click(list);
        desk.frame(3);
        const std::string chosen = desk.panels.keyboard.focus;
        EXPECT_TRUE(chosen.starts_with(rows)) << chosen;
        desk.key({key::down});
        desk.frame(3);
        EXPECT_TRUE(desk.panels.keyboard.focus.starts_with(rows)) << desk.panels.keyboard.focus;
        EXPECT_NE(desk.panels.keyboard.focus, chosen);
    }
}

TEST_F(AuthorSheet, TheFieldsOfTheAnswersHaveTheSameEdges) {
    for (const std::string& code : shipped_codes()) {
        desk.strings = speaking(code);
        page(4);
        const Rect first = desk.where("author.option.1");
        for (const char* other : {"author.option.2", "author.option.3", "author.option.4"}) {
            EXPECT_NEAR(desk.where(other).x, first.x, 1) << code;
            EXPECT_NEAR(desk.where(other).w, first.w, 1) << code;
        }
    }
}

TEST_F(AuthorSheet, APredictionCanSayWhatTheRunShows) {
    fill_in();
    page(4);
    type("author.question", "Where does it drive?");
    type("author.option.1", "Away");
    type("author.option.2", "To the lamp");
    EXPECT_TRUE(saved().draft->prediction.shows.empty());
    desk.click("author.shows");
    desk.frame(3);
    desk.click("author.shows.turns_away");
    desk.frame(3);
    desk.type_into("author.shown.degrees", "45");
    desk.type_into("author.after", "6");
    const Prediction asked = saved().draft->prediction;
    ASSERT_EQ(asked.shows.size(), 1u);
    EXPECT_EQ(std::get<goals::TurnsAway>(asked.shows[0].check.goal).degrees, 45);
    EXPECT_EQ(asked.after, 6);
    desk.rest();
    desk.click("author.shows");
    desk.frame(3);
    ASSERT_TRUE(desk.anchors.find("author.shows.nothing"));
    desk.click("author.shows.nothing");
    desk.rest();
    EXPECT_TRUE(desk.panels.sheets.author.draft.prediction.shows.empty());
    EXPECT_TRUE(saved().draft->prediction.shows.empty());
}

TEST_F(AuthorSheet, AShownCheckOfSomeTimeIsSeenAfterThisTime) {
    fill_in();
    page(4);
    desk.click("author.shows");
    desk.frame(3);
    desk.click("author.shows.runs");
    desk.frame(3);
    const Prediction& asked = desk.panels.sheets.author.draft.prediction;
    ASSERT_EQ(asked.shows.size(), 1u);
    EXPECT_GT(asked.after, std::get<goals::Runs>(asked.shows[0].check.goal).seconds);
}

TEST_F(AuthorSheet, SavesItsHints) {
    desk.type("Strike");
    desk.frame(2);
    type("author.goal", "Touch the lamp.");
    type("author.hint.2", "Cross the wires.");
    page(3);
    EXPECT_EQ(saved().draft->hints, std::vector<std::string>{"Cross the wires."});
}

TEST_F(AuthorSheet, ItsTabsStayWhereTheyAreWhenAListOpens) {
    ImGui::GetIO().DisplaySize = {1920, 1080};
    fill_in();
    page(4);
    desk.frame(3);
    const Rect before = desk.where("author.page.4");
    desk.click("author.shows");
    desk.frame(4);
    ASSERT_TRUE(desk.anchors.find("author.shows.nothing"));
    EXPECT_EQ(desk.where("author.page.4").y, before.y);
}

TEST_F(AuthorSheet, HasOneHeightOnEveryPageAndStaysAfterAClickBesideIt) {
    for (const ImVec2 size : {ImVec2{1024, 768}, ImVec2{1280, 800}, ImVec2{1920, 1080}}) {
        ImGui::GetIO().DisplaySize = size;
        page(3);
        desk.frame(4);
        const Rect before = desk.where("card.author");
        for (int i = 1; i <= 5; ++i) {
            page(i);
            desk.frame(4);
            const Rect now = desk.where("card.author");
            EXPECT_EQ(now.y, before.y) << i << " at " << size.x;
            EXPECT_EQ(now.h, before.h) << i << " at " << size.x;
        }
        desk.point(before.x - 10, before.y + 10);
        desk.frame(2);
        desk.button(0, true);
        desk.frame(2);
        desk.button(0, false);
        desk.frame(2);
        ASSERT_TRUE(desk.anchors.find("card.author")) << "what is typed stays in sight";
    }
}

TEST_F(AuthorSheet, TheAnswerIsVisibleWithinTheRun) {
    fill_in();
    page(4);
    type("author.question", "Where to?");
    type("author.option.1", "Left");
    type("author.option.2", "Right");
    desk.panels.sheets.author.draft.seconds = 5;
    desk.panels.sheets.author.draft.prediction.after = 30;
    EXPECT_EQ(saved().draft->prediction.after, 5);
}

TEST_F(AuthorSheet, TakesThePresentBrainAsAWrongAnswerOnce) {
    fill_in();
    page(5);
    desk.click("author.wrong.add");
    desk.frame(2);
    desk.click("author.wrong.add");
    ASSERT_EQ(desk.panels.sheets.author.draft.wrong.size(), 1u) << "the same brain is not taken twice";
    EXPECT_EQ(saved().draft->wrong[0].name, "Wrong answer 1");
    EXPECT_EQ(saved().draft->wrong[0].brain, *brain_of(desk.now, desk.now.vehicles[0]));
    desk.now.brains[0] = std::make_shared<BrainGraph>(make_graph({.LL = 2}));
    for (auto& brain : desk.now.kind_brains) brain = desk.now.brains[0];
    desk.frame(2);
    desk.click("author.wrong.add");
    desk.frame(2);
    desk.panels.sheets.author.wrong_names[1].text = "second";
    desk.click("author.wrong.1.remove");
    desk.frame(2);
    ASSERT_EQ(saved().draft->wrong.size(), 1u);
    EXPECT_EQ(saved().draft->wrong[0].name, "second") << "the name goes with its brain";
    desk.panels.sheets.author.wrong_names[0].text.clear();
    desk.click("author.save");
    EXPECT_TRUE(desk.says("A wrong answer has no name"));
}

TEST_F(AuthorSheet, ShowsARefusalAndReplacesAfterASecondPress) {
    fill_in();
    (void)saved();
    files.refused = Error{"there is a file of this name"};
    desk.frame(2);
    EXPECT_TRUE(desk.says("here is a file of this name"));
    EXPECT_TRUE(saved().replace);
    files.refused.reset(), ++files.done;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.author"));
}

TEST_F(AuthorSheet, KeepsTheDraftWhileTheSceneIsOpen) {
    type("author.goal", "Touch the lamp.");
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.author"));
    desk.choose("file", "save_exercise");
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheets.author.goal.text, "Touch the lamp.");
    desk.key({key::escape});
    ++desk.view.run_id;
    desk.frame(2);
    desk.choose("file", "save_exercise");
    EXPECT_EQ(desk.panels.sheets.author.goal.text, "");
}

TEST_F(AuthorSheet, AStepNeedsAText) {
    fill_in();
    desk.panels.sheets.author.step_texts[0].text.clear();
    desk.click("author.save");
    EXPECT_TRUE(desk.says("A step has no text"));
    EXPECT_FALSE(desk.last<SaveExerciseRequest>());
}

TEST_F(AuthorSheet, ARemovedStepTakesItsTextWithIt) {
    fill_in();
    desk.click("author.step.add");
    desk.frame(2);
    desk.panels.sheets.author.step_texts[0].text = "first", desk.panels.sheets.author.step_texts[1].text = "second";
    desk.click("author.step.1");
    desk.click("author.step.remove");
    desk.frame(2);
    const ExerciseDraft draft = *saved().draft;
    ASSERT_EQ(draft.steps.size(), 1u);
    EXPECT_EQ(draft.steps[0].text, "second");
}

TEST_F(AuthorSheet, AFileOfAnotherNameIsNotReplacedByTheSecondPress) {
    fill_in();
    (void)saved();
    files.refused = Error{"there is a file of this name"};
    desk.panels.sheets.author.path.text = "other";
    desk.frame(2);
    EXPECT_FALSE(saved().replace);
    EXPECT_EQ(saved().path, "other");
}

TEST_F(AuthorSheet, TheSpreadOfTheSelectedVehicleIsKept) {
    desk.key({key::escape});
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->starts[0].heading_spread = 0.5235988f;
    desk.now.scene = scene;
    ++desk.view.run_id;
    desk.frame(2);
    desk.choose("file", "save_exercise");
    desk.frame(2);
    EXPECT_NEAR(desk.panels.sheets.author.draft.heading_spread, 30, 0.01f);
}

TEST_F(AuthorSheet, OpensAgainAsItWasFilledOnceItsSceneIsRestored) {
    fill_in();
    saved();
    files.done = 1;
    desk.frame(2);
    ASSERT_FALSE(desk.anchors.find("card.author"));
    desk.view.run_id = 7;  // the exercise
    desk.view.documents.has_draft = true;
    desk.frame(2);
    desk.choose("file", "save_exercise");
    desk.frame(2);
    EXPECT_EQ(desk.actions(), std::vector{Action::edit_again}) << "not an exercise made of the exercise";
    EXPECT_FALSE(desk.anchors.find("card.author")) << "its scene is not open yet";
    desk.view.documents.has_draft = false;
    desk.view.run_id = desk.view.documents.draft_run = 8;  // the scene
    desk.frame(3);
    ASSERT_TRUE(desk.anchors.find("card.author"));
    EXPECT_EQ(desk.panels.sheets.author.title.text, "Strike");
    desk.all.clear();
    EXPECT_EQ(saved().draft->goal, "Touch the lamp.");
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("card.author")) << "once";
}

TEST(AuthorSheetProblem, IsWholeAboveTheButtonsInEveryWindow) {
    for (const std::string& code : shipped_codes())
        for (const auto& [width, height] : {std::pair{800.0f, 600.0f}, {1024.0f, 768.0f}, {1280.0f, 800.0f}}) {
            SCOPED_TRACE(code + " " + std::to_string(width));
            Desk desk(width, height, 1, true);
            FilesView files;
            desk.strings = speaking(code);
            desk.now = shipped_scene("2a-coward");
            desk.view.documents.files = &files;
            desk.frame(3);
            desk.choose("file", "save_exercise");
            desk.frame(3);
            const Rect before = desk.where("author.save");
            desk.click("author.save");
            desk.frame(3);
            const Rect save = desk.where("author.save");
            EXPECT_NEAR(save.y, before.y, 1) << "the button stays under the pointer";
            const auto said = std::find_if(desk.written.begin(), desk.written.end(), [&](const Written& each) {
                return each.words == desk.strings("author.no_goal");
            });
            ASSERT_NE(said, desk.written.end());
            EXPECT_FALSE(is_cut(*said));
            EXPECT_TRUE(is_visible(*said));
            EXPECT_LE(said->rect.y + said->rect.h, save.y);
            EXPECT_GE(said->rect.y, save.y - 60) << "beside the button";
        }
}

TEST_F(AuthorSheet, AnEmptyFieldShowsItsHint) {
    EXPECT_TRUE(desk.says(desk.strings("author.goal_how")));
    type("author.goal", "Touch the lamp.");
    EXPECT_FALSE(desk.says(desk.strings("author.goal_how")));
    page(4);
    for (const char* hint : {"author.question_how", "author.option_how", "author.outcome_how"})
        EXPECT_TRUE(desk.says(desk.strings(hint))) << hint;
}

TEST_F(AuthorSheet, ANumberSaysWhatItMeansForItsGoal) {
    fill_in();
    const auto hint_at = [&](const char* slider) {
        desk.point(slider);
        desk.frame(60);
        std::string all;
        for (const Written& each : desk.written) all += each.words + "\n";
        return all;
    };
    EXPECT_NE(hint_at("author.value.metres").find(desk.strings("author.value_how.metres")), std::string::npos);
    desk.click("author.goals");
    desk.frame(3);
    desk.click("author.goal.avoids");
    desk.frame(3);
    EXPECT_NE(hint_at("author.value.metres").find(desk.strings("author.value_how.avoids_metres")), std::string::npos);
}

}  // namespace braitenlab::tests::author_sheet_test
