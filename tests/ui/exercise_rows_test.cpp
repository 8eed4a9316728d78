// The rows at which the card of the exercise stops when it scrolls by itself.
#include "ui/panels/course/exercise_rows.h"

#include <algorithm>
#include <cmath>

#include "desk.h"
#include "ui/widgets/theme.h"

namespace braitenlab::tests::exercise_rows_test {

using namespace ui;

namespace {

// The text of the last frame; null: it has not been written.
const Written* text_of(const Desk& desk, std::string_view words) {
    for (const Written& each : desk.written)
        if (each.words == words) return &each;
    return nullptr;
}

bool is_in_sight(const Written* text) {
    return text && text->rect.y >= text->clip.y && text->rect.y + text->rect.h <= text->clip.y + text->clip.h;
}

// The texts of the card's body that its upper edge cuts.
std::string cut_above(const Desk& desk) {
    const Rect card = desk.where("card.exercise");
    std::string cut;
    for (const Written& each : desk.written)
        if (each.scrolls && card.contains(each.rect.x, each.clip.y) && each.rect.y < each.clip.y &&
            each.rect.y + each.rect.h > each.clip.y)
            cut += each.words + "\n";
    return cut;
}

std::string sentences(const char* sentence, int count) {
    std::string all;
    for (; count > 0; --count) all += sentence;
    return all;
}

// An exercise with more words than a window of 1024x768 has room for, while its first run is under way.
struct LongExercise : ::testing::Test {
    static void begin(Desk& desk, std::size_t done) {
        desk.open_exercise();
        desk.opened.prediction.outcome = sentences("It turned away from the lamp and left it behind. ", 7);
        for (Step& step : desk.opened.steps) step.text += ", wherever the vehicle starts and however far away it is";
        desk.lesson.attempt.answers.prediction = 0;
        desk.lesson.attempt.work.has_run = true;
        for (std::size_t i = 0; i < done; ++i) desk.lesson.verdicts[i].done = true;
        desk.frame(6);
    }
    static void end_run(Desk& desk) {
        desk.lesson.attempt.work.outcome_known = true;
        desk.frame(6);
    }
};

}  // namespace

TEST(ExerciseRows, TheCardStopsAtTheFirstRowThatShowsThePart) {
    const std::vector<float> tops{100, 160, 220};
    EXPECT_EQ(row_to_stop_at(tops, -20, 220), 0) << "the part is in sight";
    EXPECT_EQ(row_to_stop_at(tops, 30, 220), 100);
    EXPECT_EQ(row_to_stop_at(tops, 160, 220), 160);
    EXPECT_EQ(row_to_stop_at(tops, 170, 220), 220);
    EXPECT_EQ(row_to_stop_at(tops, 400, 220), 220) << "no further than the last row";
    EXPECT_EQ(row_to_stop_at(tops, 400, 200), 160) << "the next row is too far down";
    EXPECT_EQ(row_to_stop_at(tops, 400, 50), 0);
    EXPECT_EQ(row_to_stop_at({}, 400, 500), 0);
}

TEST_F(LongExercise, TheFirstOpenStepStaysInSightWhenTheOutcomeAppears) {
    for (const std::string& language : shipped_codes())
        for (const std::size_t done : {0u, 1u, 2u}) {
            Desk desk(1024, 768, 1, true);
            desk.strings = speaking(language);
            begin(desk, done);
            end_run(desk);
            const std::string& open = desk.opened.steps[done].text;
            EXPECT_TRUE(is_in_sight(text_of(desk, open))) << language << done;
            EXPECT_EQ(cut_above(desk), "") << language << done;
            if (done == 2) {
                EXPECT_FALSE(is_in_sight(text_of(desk, desk.opened.steps[0].text))) << "the outcome needs its room";
                EXPECT_TRUE(desk.anchors.find("exercise.came_true")) << language;
            }
        }
}

TEST_F(LongExercise, AnotherExerciseBeginsAtItsTop) {
    Desk desk(800, 600, 1, true);
    begin(desk, 2);
    end_run(desk);
    ASSERT_FALSE(is_in_sight(text_of(desk, desk.opened.steps[0].text))) << "the card has scrolled";
    desk.opened.id = "99-another";
    desk.opened.prediction.question = "Where?";
    desk.lesson.attempt = {};
    desk.lesson.as_given = true;
    desk.show_lesson();
    desk.frame(6);
    EXPECT_TRUE(is_in_sight(text_of(desk, "Where?")));
    EXPECT_EQ(cut_above(desk), "");
}

TEST_F(LongExercise, AnotherExerciseBeginsWithoutTheCardOfTheSensors) {
    Desk desk(800, 600, 1, true);
    desk.opened.offers.push_back("sensors");
    begin(desk, 0);
    desk.click("card.sensors.fold");
    desk.frame(4);
    ASSERT_FALSE(desk.panels.card(Card::sensors).folded);
    desk.opened.id = "99-another";
    desk.show_lesson();
    desk.frame(6);
    EXPECT_TRUE(desk.panels.card(Card::sensors).folded);
}

TEST_F(LongExercise, NoLineIsCutAboveTheOutcomeOnceEveryStepIsDone) {
    for (const std::string& language : shipped_codes())
        for (const float height : {640.0f, 700.0f, 730.0f, 768.0f}) {
            Desk desk(1024, height, 1, true);
            desk.strings = speaking(language);
            begin(desk, 3);
            end_run(desk);
            EXPECT_EQ(cut_above(desk), "") << language << height;
            EXPECT_TRUE(desk.anchors.find("exercise.came_true")) << language << height;
        }
}

// Whether an edge of the card cuts letters of a paragraph of its body. Its lines are as high as its face.
bool cuts_letters(const Written& w) {
    constexpr float above = 0.2f, below = 0.04f, rounding = 1;  // of the height of a line; window pixels
    const float line = w.size * line_height_em;
    const auto cuts = [&](float edge) {
        if (edge <= w.rect.y || edge >= w.rect.y + w.rect.h) return false;
        const float into = std::fmod(edge - w.rect.y, line);
        return into > above * line + rounding && into < line - below * line - rounding;
    };
    return cuts(w.clip.y) || cuts(w.clip.y + w.clip.h);
}

TEST_F(LongExercise, NoLetterIsCutWhereverTheCardIsScrolledAndHoweverLowItIs) {
    int left_out = 0;
    for (const float height : {620.0f, 653.0f, 701.0f, 768.0f}) {
        Desk desk(1024, height, 1, true);
        begin(desk, 1);
        end_run(desk);
        desk.lesson.attempt.answers.hints_shown = 2;
        desk.frame(6);
        const Rect card = desk.where("card.exercise");
        desk.point(card.x + card.w / 2, card.y + card.h / 2);
        for (int step = 0; step < 12; ++step) {
            ImGui::GetIO().MouseWheel = -0.23f;
            desk.frame(2);
            for (const Written& each : desk.written) {
                if (!each.scrolls || !card.contains(each.rect.x, each.rect.y)) continue;
                EXPECT_FALSE(cuts_letters(each)) << height << ": " << each.words;
                left_out += each.clip.h <= 0;
            }
        }
    }
    EXPECT_GT(left_out, 0) << "lines at an edge are left out";
}

TEST_F(LongExercise, NoHeadingIsAloneAtTheEndOfTheCard) {
    int visible = 0, left_out = 0;
    for (float height = 600; height <= 1100; height += 7) {
        Desk desk(1024, height, 1, true);
        begin(desk, 1);
        desk.lesson.at_start = false;  // the steps are above the prediction
        desk.frame(4);
        const std::string heading(desk.strings("exercise.predict")), question = desk.opened.prediction.question;
        const auto first_line_of = [&](std::string_view words) {
            const auto found = std::find_if(desk.written.begin(), desk.written.end(),
                                            [&](const Written& each) { return each.words == words; });
            return found != desk.written.end() && found->clip.h > 0 &&
                   found->rect.y + found->size * line_height_em <= found->clip.y + found->clip.h + 1;
        };
        if (!first_line_of(heading)) {
            ++left_out;
            continue;
        }
        ++visible;
        EXPECT_TRUE(first_line_of(question)) << height;
    }
    EXPECT_GT(visible, 0);
    EXPECT_GT(left_out, 0);
}

TEST_F(LongExercise, NoLineIsCutAboveANewHint) {
    for (const std::string& language : shipped_codes())
        for (const float height : {600.0f, 640.0f, 700.0f, 768.0f}) {
            Desk desk(1024, height, 1, true);
            desk.strings = speaking(language);
            begin(desk, 1);
            end_run(desk);
            for (int hint = 1; hint <= 3; ++hint) {
                desk.lesson.attempt.answers.hints_shown = hint;
                desk.frame(6);
                const std::string& newest = desk.opened.hints[static_cast<std::size_t>(hint - 1)].text;
                EXPECT_TRUE(is_in_sight(text_of(desk, newest))) << language << height << ": hint " << hint;
                EXPECT_EQ(cut_above(desk), "") << language << height << ": hint " << hint;
            }
        }
}

TEST_F(LongExercise, AHintThatIsAskedForBeforeThePredictionIsInSight) {
    for (const std::string& language : shipped_codes())
        for (const float height : {560.0f, 600.0f, 640.0f}) {
            Desk desk(800, height, 1, true);
            desk.strings = speaking(language);
            desk.open_exercise();
            desk.opened.prediction.question = sentences("The lamp is on its right. What will it do? ", 2);
            desk.frame(6);
            desk.lesson.attempt.answers.hints_shown = 1;
            desk.frame(6);
            EXPECT_TRUE(is_in_sight(text_of(desk, desk.opened.hints[0].text))) << language << height;
        }
}

}  // namespace braitenlab::tests::exercise_rows_test
