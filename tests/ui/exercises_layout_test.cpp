// The window with each exercise of the course: what is in sight in a small window, and what stays in its place.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "course_on_desk.h"
#include "ui/panels/cards.h"
#include "ui/panels/course/lesson_text.h"
#include "ui/panels/course/prediction.h"

namespace braitenlab::tests::exercises_layout_test {

using namespace ui;

TEST(ExercisesLayout, NoWidgetMovesWhileTheTextOfTheExerciseGrows) {
    const char* const ids[]{"card.sensors.fold", "exercise.hint",    "exercise.reset",       "exercise.note",
                            "slider.LL",         "bias.LM",          "sensor.names",         "sensor.sides",
                            "sensor.angle",      "button.free_play", "card.information.fold"};
    for (const Exercise& exercise : course())
        for (const bool opens_sensors : {false, true}) {
            if (exercise.hints.empty()) continue;
            if (opens_sensors && !offers(exercise, offer_parts::sensors)) continue;
            Opened it(exercise);
            it.desk.panels.card(Card::sensors).folded = !opens_sensors;
            it.play_after_prediction();
            it.desk.frame(8);
            std::map<std::string, Rect> before;
            for (const char* id : ids)
                if (const Rect* at = it.desk.anchors.find(id)) before[id] = *at;
            EXPECT_TRUE(before.count("exercise.reset")) << exercise.id;
            it.desk.lesson.attempt.answers.hints_shown = std::min(2, static_cast<int>(exercise.hints.size()) - 1);
            it.desk.lesson.by_hand = true;
            it.desk.lesson.attempt.work.outcome_known = true;
            it.desk.frame(8);
            for (const auto& [id, was] : before) {
                const Rect* now = it.desk.anchors.find(id);
                ASSERT_TRUE(now) << exercise.id << ": " << id;
                EXPECT_NEAR(now->y, was.y, 0.5f) << exercise.id << ": " << id;
                EXPECT_NEAR(now->x, was.x, 0.5f) << exercise.id << ": " << id;
            }
        }
}

// Each stop of Tab shows where it is, also in a card that scrolls.
TEST(ExercisesLayout, EachStopOfTabIsInSightInASmallWindow) {
    for (const Exercise& exercise : course()) {
        Opened it(exercise, 800, 600);
        it.play_after_prediction();
        it.desk.lesson.attempt.work.outcome_known = true;
        it.desk.frame(6);
        std::set<std::string> seen;
        for (int stop = 1; stop <= 40; ++stop) {
            it.desk.panels.keyboard.presses.push_back({key::tab});
            it.desk.panels.keyboard.shown = true;
            it.desk.frame(4);
            const std::string focus = it.desk.panels.keyboard.focus;
            if (!seen.insert(focus).second) break;
            const Rect* at = it.desk.anchors.find(focus);
            ASSERT_TRUE(at) << exercise.id << ", stop " << stop << ": " << focus;
            EXPECT_GE(std::min(at->w, at->h), 6) << exercise.id << ", stop " << stop << ": " << focus;
        }
        EXPECT_GT(seen.size(), 5u);
    }
}

namespace {

// Turns the wheel over the card until the widget is in its body.
bool scrolls_to(Desk& desk, const std::string& id) {
    const Rect body = body_of_exercise(desk);
    desk.point(body.x + body.w / 2, body.y + body.h / 2);
    for (int turn = 0; turn < 60; ++turn) {
        if (is_in_body(desk, id)) return true;
        ImGui::GetIO().MouseWheel = turn < 30 ? -1.0f : 1.0f;
        desk.frame(2);
    }
    return false;
}

// Opens the cards that can be beside that of the exercise; those of the map and of the brains take most of the column.
void open_other_cards(Opened& it, const insight::MapCells& cells, bool all) {
    PanelState& panels = it.desk.panels;
    for (const Card card : {Card::sensors, Card::information, Card::brain}) panels.card(card).folded = false;
    for (const Card card : {Card::information, Card::brain}) panels.card(card).opened_by_user = true;
    if (!all) return;
    it.desk.view.settings.values = it.desk.view.settings.map = true;
    it.desk.view.features.map =
        MapView{.cells = &cells, .x = *insight::axis_of("LL=RR"), .y = *insight::axis_of("LR=RL"), .progress = 1};
}

}  // namespace

TEST(ExercisesLayout, AnswersAndStepsAreReachedInASmallWindowWhateverOtherCardsAreOpen) {
    const insight::MapCells cells{8};
    for (const Exercise& exercise : course())
        for (const SmallWindow& w : small_windows)
            for (const int others : {0, 2}) {
                SCOPED_TRACE(exercise.id + " " + std::to_string(w.width) + " " + std::to_string(others));
                Opened it(exercise, w.width, w.height, w.scale);
                if (others > 0) open_other_cards(it, cells, others > 1);
                it.desk.frame(12);
                for (std::size_t i = 0; i < exercise.prediction.options.size(); ++i)
                    EXPECT_TRUE(scrolls_to(it.desk, "exercise.predict." + std::to_string(i + 1))) << i;
                it.play_after_prediction();
                it.desk.frame(8);
                for (std::size_t i = 0; i < exercise.steps.size(); ++i)
                    EXPECT_TRUE(scrolls_to(it.desk, "exercise.step." + std::to_string(i + 1))) << i;
            }
}

TEST(ExercisesLayout, AnswersAndTheFirstStepAreSeenWithoutScrollingInASmallWindow) {
    constexpr float above_foot = 9;  // an anchor ends where the part that scrolls is cut
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course()) {
            SCOPED_TRACE(exercise.id + " " + language);
            Opened it(exercise, 800, 600);
            it.desk.strings = speaking(language);
            if (language != "en") add_translations(it.desk.strings, texts_of(exercise), words_of_course(language));
            for (const bool passed_before : {true, false}) {
                it.desk.lesson.standing.passed_before = passed_before;
                it.desk.frame(12);
                const Rect body = body_of_exercise(it.desk);
                for (std::size_t i = 0; i < exercise.prediction.options.size(); ++i) {
                    const Rect* option = it.desk.anchors.find("exercise.predict." + std::to_string(i + 1));
                    EXPECT_TRUE(option && option->y + option->h <= body.y + body.h - above_foot)
                        << i << " of " << exercise.prediction.options.size() << ", passed before: " << passed_before;
                }
            }
            it.desk.strings = speaking(language);  // in German the goal of exercise 20 leaves its step no room
            it.play_after_prediction();
            it.desk.frame(8);
            const Rect body = body_of_exercise(it.desk), *step = it.desk.anchors.find("exercise.step.1");
            EXPECT_TRUE(step && step->y + step->h <= body.y + body.h + 1) << "with its value";
        }
}

// All open steps of a running exercise, and the outcome once it arrives.
TEST(ExercisesLayout, NoTextOfAStepIsCutInASmallWindow) {
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course())
            for (const auto& [width, has_outcome] :
                 {std::pair{800.0f, false}, {800.0f, true}, {1024.0f, false}, {1024.0f, true}}) {
                SCOPED_TRACE(exercise.id + " " + language + " " + std::to_string(width));
                Opened it(exercise, width, 0.75f * width);
                it.desk.strings = speaking(language);
                if (language != "en") add_translations(it.desk.strings, texts_of(exercise), words_of_course(language));
                it.play_after_prediction();
                it.desk.frame(8);
                it.desk.lesson.attempt.work.outcome_known = has_outcome;
                it.desk.frame(8);
                const Rect body = body_of_exercise(it.desk);
                for (std::size_t i = 0; i < exercise.steps.size(); ++i) {
                    const Rect* step = it.desk.anchors.find("exercise.step." + std::to_string(i + 1));
                    ASSERT_TRUE(step) << i;
                    EXPECT_LE(step->y + step->h, body.y + body.h + 1) << i;
                    for (const Written& each : it.desk.written)
                        if (step->contains(each.rect.x + 1, each.rect.y + each.rect.h / 2)) {
                            EXPECT_LE(each.rect.y + each.rect.h, each.clip.y + each.clip.h + 3) << each.words;
                        }
                }
                // The four long steps of 9 leave the outcome no room in German and Spanish.
                const bool has_room = exercise.id != "09-explorer" || language == "en";
                if (has_outcome && has_room && is_asked(exercise.prediction)) {
                    const Rect* outcome = it.desk.anchors.find("exercise.came_true");
                    EXPECT_TRUE(!outcome || outcome->h > 18) << "the outcome is in sight";
                    EXPECT_TRUE(outcome || exercise.prediction.options.empty());
                }
            }
}

namespace {

// The lines that the verdict on the answer and the outcome take on the card of the exercise.
std::size_t lines_of_outcome(const Desk& desk, bool came_true) {
    Anchors anchors;
    Outbox asked;
    const Ui ui{desk.strings, palette(Theme::dark), test_fonts(1).loaded.fonts, 1, anchors, asked, {}, 1};
    const float width = card_width(ui, desk.where("card.exercise")), beside_sign = 26;
    const std::string words = fill(desk.strings("exercise.outcome"), {translated(ui, desk.opened.prediction.outcome)});
    const std::string_view verdict = desk.strings(came_true ? "exercise.came_true" : "exercise.not_true");
    return lines_of_words(ui, words, Face::text, width).size() +
           lines_of_words(ui, verdict, Face::strong, width - beside_sign).size();
}

}  // namespace

// The verdict on the answer and the first lines of what happened, also after a run that has failed and with hints.
TEST(ExercisesLayout, TheOutcomeIsInSightAsSoonAsItIsKnownInASmallWindow) {
    constexpr float line = 22;
    int shown = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course())
            for (const bool came_true : {true, false})
                for (const int hints : {0, 2}) {
                    if (exercise.prediction.options.empty()) continue;
                    SCOPED_TRACE(exercise.id + " " + language + (came_true ? " true " : " false ") +
                                 std::to_string(hints));
                    Opened it(exercise, 800, 600);
                    it.desk.strings = speaking(language);
                    if (language != "en")
                        add_translations(it.desk.strings, texts_of(exercise), words_of_course(language));
                    it.play_after_prediction();
                    if (!came_true) it.desk.lesson.attempt.answers.prediction = exercise.prediction.answer == 0 ? 1 : 0;
                    it.desk.lesson.attempt.answers.hints_shown =
                        std::min(hints, static_cast<int>(exercise.hints.size()));
                    it.desk.lesson.as_given = !is_about_end(exercise);
                    it.desk.lesson.verdicts[0].lost = true;
                    it.desk.frame(8);
                    it.desk.lesson.attempt.work.outcome_known = true;
                    it.desk.frame(8);
                    const Rect* outcome = it.desk.anchors.find("exercise.outcome");
                    ASSERT_TRUE(outcome);
                    const std::size_t first_lines = exercise.steps.size() > 3 ? 4 : 5;
                    const std::size_t lines = std::min(lines_of_outcome(it.desk, came_true), first_lines);
                    EXPECT_GE(outcome->h, line * static_cast<float>(lines) - 1);
                    ++shown;
                }
    EXPECT_GT(shown, 200);
}

TEST(ExercisesLayout, WhatExplainsTheWheelsIsSeenWithoutScrollingInASmallWindow) {
    int sums = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course()) {
            SCOPED_TRACE(exercise.id + " " + language);
            Opened it(exercise, 800, 600);
            it.desk.strings = speaking(language);
            it.play_after_prediction();
            it.desk.lesson.attempt.work.outcome_known = true;
            it.desk.frame(8);
            it.desk.click("card.brain.fold");
            it.desk.frame(8);
            const Rect* equations = it.desk.anchors.find("equations");
            if (!equations) continue;
            ++sums;
            EXPECT_GE(equations->h, 70) << "an anchor is what is in sight";
            EXPECT_LE(equations->y + equations->h + 16, it.desk.where("card.brain").y + it.desk.where("card.brain").h);
        }
    EXPECT_GT(sums, 30);
}

namespace {

constexpr std::pair<float, float> common_windows[]{{800.0f, 600.0f}, {1280.0f, 800.0f}};

// The exercise in this language, as it is after so many ticks of the run as given.
struct Played : Opened {
    Played(const Exercise& exercise, const std::string& language, std::pair<float, float> window, int ticks)
        : Opened(exercise, window.first, window.second) {
        desk.strings = speaking(language);
        if (language != "en") add_translations(desk.strings, texts_of(exercise), words_of_course(language));
        play_after_prediction();
        for (int i = 0; i < ticks; ++i) world.step();
        show();
    }
    void open_brain() {
        desk.frame(8);
        if (desk.panels.card(Card::brain).folded) desk.click("card.brain.fold");
        desk.frame(8);
    }
};

bool is_cut_off(const Written& text) { return text.rect.y + text.rect.h > text.clip.y + text.clip.h + 1; }

// The texts of each row of the sums that has an equals sign, from left to right.
std::vector<std::vector<Written>> rows_of_sums(const Desk& desk) {
    const Rect* sums = desk.anchors.find("equations");
    std::vector<std::vector<Written>> rows;
    if (!sums) return rows;
    std::map<int, std::vector<Written>> by_height;
    for (const Written& each : desk.written)
        if (sums->contains(each.rect.x + 1, each.rect.y + each.rect.h / 2))
            by_height[static_cast<int>(std::lround((each.rect.y + each.rect.h / 2) / 4))].push_back(each);
    for (auto& [height, row] : by_height) {
        std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.rect.x < b.rect.x; });
        if (std::any_of(row.begin(), row.end(), [](const Written& w) { return w.words == "="; })) rows.push_back(row);
    }
    return rows;
}

// "+0,30", or "0,42·(−1,50)"; 0 for what is masked or cut.
double shown_value(std::string words) {
    const auto replace = [&](std::string_view what, std::string_view by) {
        for (auto at = words.find(what); at != words.npos; at = words.find(what)) words.replace(at, what.size(), by);
    };
    replace("−", "-"), replace(",", "."), replace("(", ""), replace(")", "");
    if (words.find("θ") != words.npos) return 0;
    const auto dot = words.find("·");
    if (dot == words.npos) return std::strtod(words.c_str(), nullptr);
    return std::strtod(words.c_str(), nullptr) *
           std::strtod(words.c_str() + dot + std::string_view("·").size(), nullptr);
}

}  // namespace

TEST(ExercisesLayout, TheCauseOfATurnIsWholeWithoutScrolling) {
    int shown = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course())
            for (const auto& window : common_windows) {
                SCOPED_TRACE(exercise.id + " " + language + " " + std::to_string(window.first));
                Played it(exercise, language, window, 90);
                it.open_brain();
                if (!it.desk.anchors.find("equations")) continue;
                const auto cause = std::find_if(it.desk.written.begin(), it.desk.written.end(), [&](const Written& w) {
                    constexpr std::string_view begins[]{"sums.right_faster", "sums.left_faster", "sums.straight",
                                                        "sums.stuck",        "sums.still",       "sums.back",
                                                        "why.blocked"};
                    return std::any_of(std::begin(begins), std::end(begins),
                                       [&](auto key) { return w.words.starts_with(it.desk.strings(key)); });
                });
                ASSERT_NE(cause, it.desk.written.end());
                EXPECT_FALSE(is_cut_off(*cause)) << cause->words;
                ++shown;
            }
    EXPECT_GT(shown, 60);
}

TEST(ExercisesLayout, TheNumbersOfASumAreApartAndAddUpToWhatIsAfterTheEqualsSign) {
    constexpr float least_gap = 3;
    int sums = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course())
            for (const auto& window : common_windows) {
                SCOPED_TRACE(exercise.id + " " + language + " " + std::to_string(window.first));
                Played it(exercise, language, window, 90);
                it.open_brain();
                for (const std::vector<Written>& row : rows_of_sums(it.desk)) {
                    std::string all;
                    for (std::size_t i = 0; i < row.size(); ++i) {
                        all += row[i].words + " ";
                        if (i > 0) {
                            EXPECT_GE(row[i].rect.x - row[i - 1].rect.x - row[i - 1].rect.w, least_gap) << all;
                        }
                    }
                    ASSERT_GE(row.size(), 4u) << all;
                    double sum = 0;
                    for (std::size_t i = 2; i + 2 < row.size(); ++i) sum += shown_value(row[i].words);
                    const double total = shown_value(row.back().words);
                    const std::string& sign = row[row.size() - 2].words;
                    const bool adds_up = std::fabs(sum - total) < 0.0051;
                    if (sign != "→") {
                        EXPECT_EQ(sign, adds_up ? "=" : "≈") << all;
                    }
                    ++sums;
                }
            }
    EXPECT_GT(sums, 120);
}

// What a badge of a prompt covers cannot be read: neither the sign of a folded card nor the number beside a pin.
TEST(ExercisesLayout, TheBadgeOfWhatPulsesCoversNoText) {
    int badges = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course())
            for (const auto& window : common_windows)
                for (const char* state : {"asks", "plays", "wires"}) {
                    SCOPED_TRACE(exercise.id + " " + language + " " + std::to_string(window.first) + " " + state);
                    Played it(exercise, language, window, 0);
                    if (state == std::string("asks"))
                        it.desk.lesson.attempt = {}, it.desk.lesson.at_start = true, it.desk.view.mode = Mode::paused;
                    if (state == std::string("wires")) it.desk.view.mode = Mode::wiring;
                    it.desk.frame(8);
                    it.desk.pointed_out = {};
                    it.desk.frame(1);
                    const Rect bulb = it.desk.pointed_out.bulb;
                    if (bulb.w <= 0) continue;
                    ++badges;
                    for (const Written& each : it.desk.written) {
                        const float letters = 0.2f * each.rect.h;  // above and below them the line is empty
                        const Rect seen{each.rect.x, each.rect.y + letters, each.rect.w, each.rect.h - 2 * letters};
                        if (each.words != icon::hint && seen.y < each.clip.y + each.clip.h &&
                            each.clip.overlaps(seen)) {
                            EXPECT_FALSE(bulb.overlaps(seen))
                                << each.words << " by that of " << it.desk.panels.prompts.highlight.anchor;
                        }
                    }
                }
    EXPECT_GT(badges, 100);
}

TEST(ExercisesLayout, WhyTheAnswerIsLockedIsReadWholeOrNotAtAllInASmallWindow) {
    int notes = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course()) {
            SCOPED_TRACE(exercise.id + " " + language);
            Played it(exercise, language, {800.0f, 600.0f}, 0);
            it.desk.frame(8);
            if (!is_asked(exercise.prediction) || is_about_end(exercise)) continue;
            const auto note = std::find_if(it.desk.written.begin(), it.desk.written.end(), [&](const Written& each) {
                return each.words == it.desk.strings("exercise.locked");
            });
            ASSERT_NE(note, it.desk.written.end());
            const float end = std::min(note->rect.y + note->rect.h, note->clip.y + note->clip.h);
            const float seen = end - std::max(note->rect.y, note->clip.y);
            EXPECT_TRUE(seen <= 1 || seen >= note->rect.h - 4) << seen << " of " << note->rect.h;
            ++notes;
        }
    EXPECT_GT(notes, 40);
}

TEST(ExercisesLayout, NoTextIsCutAtTwiceTheScale) {
    const float scale = fitting_scale(2, {0, 0, 1600, 1200}, false);
    int texts = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course())
            for (const bool tells : {false, true}) {
                SCOPED_TRACE(exercise.id + " " + language + (tells ? " tells" : " plays"));
                Opened it(exercise, 1600, 1200, scale);
                it.desk.strings = speaking(language);
                if (language != "en") add_translations(it.desk.strings, texts_of(exercise), words_of_course(language));
                it.play_after_prediction();
                it.desk.lesson.attempt.work.outcome_known = tells;
                it.desk.frame(8);
                EXPECT_EQ(it.desk.shortened, 0);
                for (const Written& each : it.desk.written)
                    if (!each.scrolls) {
                        EXPECT_FALSE(is_cut_off(each)) << each.words;
                    }
                texts += static_cast<int>(it.desk.written.size());
            }
    EXPECT_GT(texts, 2000);
}

TEST(ExercisesLayout, NoTextOfTheInspectorIsCutInASmallWindow) {
    int texts = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course()) {
            SCOPED_TRACE(exercise.id + " " + language);
            Played it(exercise, language, {800.0f, 600.0f}, 0);
            it.desk.view.mode = Mode::wiring;
            it.desk.frame(8);
            const Rect* card = it.desk.anchors.find("card.inspector");
            if (!card) continue;
            for (const Written& each : it.desk.written) {
                if (!card->contains(each.rect.x + 1, each.rect.y + 1)) continue;
                EXPECT_FALSE(is_cut_off(each)) << each.words;
                ++texts;
            }
        }
    EXPECT_GT(texts, 200);
}

TEST(ExercisesLayout, TheStepsAreInSightInTheWiringEditorOfASmallWindow) {
    for (const Exercise& exercise : course())
        for (const SmallWindow& w : small_windows) {
            SCOPED_TRACE(exercise.id + " " + std::to_string(w.width));
            Opened it(exercise, w.width, w.height, w.scale);
            it.play_after_prediction();
            it.desk.frame(6);
            it.desk.view.mode = Mode::wiring;
            it.desk.frame(8);
            EXPECT_TRUE(is_in_body(it.desk, "exercise.step.1"));
            it.desk.view.mode = Mode::paused;
            it.desk.lesson.attempt.answers.hints_shown = static_cast<int>(exercise.hints.size());
            it.desk.lesson.attempt.work.outcome_known = true;
            it.desk.frame(6);
            it.desk.view.mode = Mode::wiring;
            it.desk.frame(8);
            EXPECT_TRUE(is_in_body(it.desk, "exercise.step.1")) << "with hints";
            for (std::size_t i = 0; i < exercise.steps.size(); ++i)
                EXPECT_TRUE(scrolls_to(it.desk, "exercise.step." + std::to_string(i + 1))) << i;
        }
}

TEST(ExercisesLayout, NoWidgetMovesWhenAllStartsAreShownAtOnce) {
    for (const Exercise& exercise : course()) {
        Opened it(exercise);
        it.play_after_prediction();
        for (Verdict& verdict : it.desk.lesson.verdicts) verdict.done = true;
        it.desk.lesson.attempt.work.outcome_known = true;
        it.desk.lesson.grade = graded(std::vector<bool>(static_cast<std::size_t>(exercise.starts), true), true);
        it.desk.frame(12);
        std::map<std::string, Rect> before;
        for (const Shown& each : it.desk.shown)
            if (const Rect* at = it.desk.anchors.find(each.id)) before[each.id] = *at;
        ASSERT_TRUE(before.count("exercise.together")) << exercise.id;
        it.desk.lesson.together = true;
        VehicleView other = *it.subject();  // from another start
        other.id = 1000;
        it.desk.now.vehicles.push_back(other);
        it.desk.frame(12);
        for (const auto& [id, was] : before) {
            const Rect* now = it.desk.anchors.find(id);
            if (!now || id == "exercise.together") continue;
            EXPECT_NEAR(now->y, was.y, 0.5f) << exercise.id << ": " << id;
            EXPECT_NEAR(now->x, was.x, 0.5f) << exercise.id << ": " << id;
        }
        const Rect was = before["exercise.together"];
        EXPECT_NEAR(it.desk.where("exercise.together").y, was.y, 0.5f) << exercise.id;
    }
}

TEST(ExercisesLayout, NoStepMovesWhenTheOutcomeArrivesOrAStepIsDone) {
    for (const Exercise& exercise : course()) {
        Opened it(exercise, 1280, 1400);
        it.play_after_prediction();
        it.desk.frame(8);
        const auto tops = [&] {
            std::map<std::string, float> all;
            for (std::size_t i = 0; i < exercise.steps.size(); ++i) {
                const std::string id = "exercise.step." + std::to_string(i + 1);
                if (const Rect* at = it.desk.anchors.find(id)) all[id] = at->y;
            }
            return all;
        };
        const auto before = tops();
        ASSERT_EQ(before.size(), exercise.steps.size()) << exercise.id;
        it.desk.lesson.attempt.work.outcome_known = true;
        it.desk.frame(8);
        EXPECT_EQ(tops(), before) << exercise.id << ": the outcome";
        it.desk.lesson.verdicts[0].done = true;
        it.desk.frame(8);
        EXPECT_EQ(tops(), before) << exercise.id << ": the first step is done";
    }
}

TEST(ExercisesLayout, AProjectorShowsEveryAnswerOfAPrediction) {
    int answers = 0;
    for (const char* language : {"en", "de", "es"})
        for (const Exercise& exercise : course()) {
            SCOPED_TRACE(std::string(language) + " " + exercise.id);
            Opened it(exercise, 1024, 768, 1.375f);
            it.desk.strings = speaking(language);
            if (language != std::string("en"))
                add_translations(it.desk.strings, texts_of(exercise), words_of_course(language));
            it.desk.view.lecture = true;
            it.desk.frame(3);
            it.desk.panels.card(Card::exercise).folded = false;
            it.desk.frame(6);
            for (std::size_t i = 1; i <= exercise.prediction.options.size(); ++i, ++answers)
                EXPECT_TRUE(is_in_body(it.desk, "exercise.predict." + std::to_string(i))) << i;
            EXPECT_GE(it.desk.where("viewport").w, 0.47f * 1024);
        }
    EXPECT_GT(answers, 3 * 50);
}

TEST(ExercisesLayout, ASliderHasATrackThatCanBeUsedInASmallWindow) {
    int sliders = 0;
    for (const char* language : {"en", "de", "es"})
        for (const Exercise& exercise : course())
            for (const SmallWindow& w : small_windows) {
                Opened it(exercise, w.width, w.height, w.scale);
                it.desk.strings = speaking(language);
                it.play_after_prediction();
                it.desk.panels.card(Card::brain).opened_by_user = true;
                it.desk.frame(6);
                for (const Offer& offer : offered_dials(exercise)) {
                    const Rect* at = it.desk.anchors.find(anchor_of(offer.dials.front()));
                    if (!at || at->h < 20 * w.scale) continue;  // scrolled away
                    float words = at->x, number = at->x + at->w;
                    for (const Written& each : it.desk.written) {
                        const float middle = each.rect.y + each.rect.h / 2;
                        if (middle < at->y || middle > at->y + at->h) continue;
                        if (std::fabs(each.rect.x - at->x) < 2) words = std::max(words, each.rect.x + each.rect.w);
                        if (std::fabs(each.rect.x + each.rect.w - at->x - at->w) < 2)
                            number = std::min(number, each.rect.x);
                    }
                    EXPECT_GE(number - words, 100 * w.scale) << exercise.id << " " << offer.text << " " << language;
                    ++sliders;
                }
            }
    EXPECT_GT(sliders, 60);
}

TEST(ExercisesLayout, TheButtonOfTheBrainPictureCoversNoNameInASmallWindow) {
    int pictures = 0;
    for (const Exercise& exercise : course()) {
        Opened it(exercise, 800, 600);
        it.play_after_prediction();
        it.desk.panels.card(Card::information).folded = true;
        it.desk.frame(6);
        it.desk.click("card.brain.fold");
        it.desk.frame(4);
        const Rect *button = it.desk.anchors.find("button.watch"), *picture = it.desk.anchors.find("brain.picture");
        if (!button || !picture || button->h < 20) continue;
        ++pictures;
        for (const Written& each : it.desk.written) {
            const bool is_icon = static_cast<unsigned char>(each.words[0]) == 0xEF;
            if (is_icon || !picture->contains(each.rect.x + 1, each.rect.y + 1)) continue;
            EXPECT_FALSE(button->overlaps(each.rect)) << exercise.id << ": " << each.words;
        }
    }
    EXPECT_GT(pictures, 3);
}

namespace {

// The exercise in the smallest window that the course is made for.
struct SmallOpened : Opened {
    SmallOpened(const Exercise& exercise, const std::string& language) : Opened(exercise, 800, 600) {
        desk.strings = speaking(language);
        if (language != "en") add_translations(desk.strings, texts_of(exercise), words_of_course(language));
    }
};

std::map<std::string, float> tops_of_cards(const Desk& desk) {
    std::map<std::string, float> tops;
    for (const CardTraits& row : cards())
        if (const Rect* at = desk.anchors.find(row.anchor)) tops[std::string(row.anchor)] = at->y;
    return tops;
}

}  // namespace

TEST(ExercisesLayout, NoCardMovesByItselfWhileThePointerIsOverTheCardsOfASmallWindow) {
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course()) {
            SCOPED_TRACE(exercise.id + " " + language);
            SmallOpened it(exercise, language);
            it.play_after_prediction();
            it.desk.frame(6);
            it.desk.click("card.brain.fold");  // the pointer stays there
            it.desk.frame(6);
            ASSERT_TRUE(it.desk.panels.card(Card::exercise).folded);
            const auto before = tops_of_cards(it.desk);
            for (Verdict& verdict : it.desk.lesson.verdicts) verdict.done = true;
            it.desk.lesson.attempt.work.outcome_known = true;
            it.desk.lesson.grade = graded(std::vector<bool>(10, true), true);
            it.desk.frame(8);
            EXPECT_EQ(tops_of_cards(it.desk), before);
            it.desk.point(200, 300);
            it.desk.frame(8);
            EXPECT_FALSE(it.desk.panels.card(Card::exercise).folded) << "over the scene";
        }
}

TEST(ExercisesLayout, EnterOpensTheNextExerciseAlsoWhereTheCardIsFolded) {
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course()) {
            SCOPED_TRACE(exercise.id + " " + language);
            SmallOpened it(exercise, language);
            const CatalogueEntry next{
                .name = "next", .path = "/next.toml", .title = "Next", .number = exercise.number + 1};
            CatalogueEntry own{.name = exercise.id, .path = "/own.toml", .title = "Own", .number = exercise.number};
            const std::vector<CatalogueEntry> catalogue{own, next};
            it.desk.view.documents.catalogue = &catalogue;
            it.play_after_prediction();
            it.desk.lesson.attempt.work.outcome_known = true;
            it.desk.frame(6);
            it.desk.click("card.brain.fold");
            it.desk.lesson.grade = graded(std::vector<bool>(10, true), true);
            it.desk.frame(6);
            ASSERT_TRUE(it.desk.panels.card(Card::exercise).folded);
            it.desk.all.clear();
            it.desk.key({key::enter});
            it.desk.frame(4);
            EXPECT_TRUE(it.desk.last<OpenRequest>() || it.desk.panels.sheet == Sheet::files);
        }
}

// A cut goal has no room: below it the card would have to scroll.
TEST(ExercisesLayout, TheGoalIsCutOnlyWhereItsCardHasNoRoom) {
    int cut = 0, whole = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course())
            for (const bool plays : {false, true}) {
                SCOPED_TRACE(exercise.id + " " + language + (plays ? " plays" : " asks"));
                SmallOpened it(exercise, language);
                if (plays) it.play_after_prediction();
                it.desk.frame(12);
                const CardState& card = it.desk.panels.card(Card::exercise);
                ++(it.desk.panels.exercise.is_goal_cut ? cut : whole);
                if (!it.desk.panels.exercise.is_goal_cut) continue;
                const float heading = it.desk.where("card.exercise.fold").h, head = *card.head;
                const float spare = it.desk.where("card.exercise").h - heading - head - card.content - card.footer;
                it.desk.panels.exercise.goal_open = true;
                it.desk.frame(6);
                EXPECT_LT(spare, *card.head - head);
            }
    EXPECT_GT(whole, cut);
}

TEST(ExercisesLayout, TheFirstStepIsWholeAndInSightWhileTheQuestionIsAskedInASmallWindow) {
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course()) {
            SCOPED_TRACE(exercise.id + " " + language);
            SmallOpened it(exercise, language);
            it.desk.frame(12);
            const Rect body = body_of_exercise(it.desk);
            EXPECT_LE(it.desk.where("exercise.step.1").y + it.desk.where("exercise.step.1").h, body.y + body.h);
            for (const Shown& each : it.desk.shown)
                if (each.id == "exercise.step.1") {
                    EXPECT_LE(each.rect.y + each.rect.h, body.y + body.h);
                }
        }
}

TEST(ExercisesLayout, NoTextOfTheDiagramIsLowerThanElevenPixelsInASmallWindow) {
    int texts = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course()) {
            SmallOpened it(exercise, language);
            it.play_after_prediction();
            it.desk.view.mode = Mode::wiring;
            it.desk.frame(8);
            for (const Written& each : it.desk.written) {
                if (!it.desk.layout.canvas.contains(each.rect.x, each.rect.y)) continue;
                EXPECT_GE(each.size, 11) << exercise.id << " " << language << ": " << each.words << " at "
                                         << each.rect.x << ", " << each.rect.y;
                ++texts;
            }
        }
    EXPECT_GT(texts, 300);
}

// Of the shipped brain and of the solution.
TEST(ExercisesLayout, TheDiagramOfASmallWindowShowsAllNodesAndWeights) {
    constexpr std::size_t many_nodes = 12;
    int weights = 0;
    for (const Exercise& shipped : course())
        for (const bool solved : {false, true}) {
            Exercise exercise = shipped;
            const auto kind = static_cast<std::size_t>(subject_kind(exercise.scene));
            if (solved) exercise.scene.kinds[kind].brain = exercise.solution.submission.brain;
            const BrainGraph brain = exercise.scene.kinds[kind].brain;
            if (brain.nodes.size() > many_nodes) continue;
            SCOPED_TRACE(exercise.id + (solved ? " solved" : ""));
            Opened it(exercise, 800, 600);
            it.play_after_prediction();
            it.desk.view.mode = Mode::wiring;
            it.desk.frame(8);
            for (const bool fitted : {false, true}) {
                if (fitted) it.desk.click("canvas.fit");
                const Rect canvas = it.desk.where("canvas");
                const auto is_whole = [&](const std::string& id) {
                    const Rect* at = it.desk.anchors.find(id);
                    return at && inside(*at, canvas);
                };
                for (const Node& node : brain.nodes) EXPECT_TRUE(is_whole("node." + node.name)) << node.name;
                for (const Wire& wire : brain.wires) {
                    if (wire.weight == 0) continue;
                    EXPECT_TRUE(is_whole("wire." + wire_name(brain, {wire.from, wire.to})))
                        << wire_name(brain, {wire.from, wire.to});
                    ++weights;
                }
            }
        }
    EXPECT_GT(weights, 200);
}

TEST(ExercisesLayout, AWeightIsDraggedInTheDiagramOfASmallWindow) {
    int dragged = 0;
    for (const Exercise& exercise : course()) {
        Opened it(exercise, 800, 600);
        it.play_after_prediction();
        it.desk.view.mode = Mode::wiring;
        it.desk.frame(8);
        const BrainGraph& brain = *it.desk.now.brains[static_cast<std::size_t>(it.subject()->brain)];
        for (const Wire& wire : brain.wires) {
            const std::string label = "wire." + wire_name(brain, {wire.from, wire.to});
            if (wire.weight == 0 || !it.desk.anchors.find(label)) continue;
            const Rect at = it.desk.where(label);
            it.desk.all.clear();
            it.desk.point(label);
            it.desk.frame(2);
            it.desk.button(0, true);
            it.desk.frame(2);
            for (const float moved : {10.0f, 30.0f}) {
                it.desk.point(at.x + at.w / 2 + moved, at.y + at.h / 2);
                it.desk.frame(2);
            }
            it.desk.button(0, false);
            it.desk.frame(2);
            EXPECT_FALSE(it.desk.edits().empty()) << exercise.id << ' ' << label;
            ++dragged;
        }
    }
    EXPECT_GT(dragged, 20);
}

// A click of the person always wins: no outcome and no grade opens another card for it.
TEST(ExercisesLayout, AFoldedCardThatIsClickedIsOpenAndStaysSoInASmallWindow) {
    int clicked = 0;
    for (const Exercise& exercise : course())
        for (const bool passes : {false, true}) {
            Opened it(exercise, 800, 600);
            it.play_after_prediction();
            it.desk.frame(8);
            it.desk.lesson.attempt.work.outcome_known = true;
            if (passes) it.desk.lesson.grade = graded(std::vector<bool>(10, true), true);
            it.desk.frame(8);
            const auto is_open = [&](const CardTraits& row) { return !it.desk.panels.card(row.card).folded; };
            for (int round = 0; round < 2; ++round)
                for (const CardTraits& row : cards()) {
                    if (!it.desk.anchors.find(row.anchor) || is_open(row)) continue;
                    const std::string heading = std::string(row.anchor) + ".fold";
                    SCOPED_TRACE(exercise.id + (passes ? " passed: " : ": ") + heading);
                    it.desk.click(heading);
                    EXPECT_TRUE(is_open(row));
                    it.desk.frame(60);
                    EXPECT_TRUE(is_open(row)) << "a second later";
                    ++clicked;
                }
        }
    EXPECT_GT(clicked, 200);
}

// A telephone of 400 x 800 shows a window of 512 x 1024.
TEST(ExercisesLayout, EachAnswerIsWholeOnAnUprightTelephone) {
    int seen = 0;
    for (const std::string& language : shipped_codes())
        for (const Exercise& exercise : course()) {
            const std::size_t answers = exercise.prediction.options.size();
            if (answers == 0 || !exercise.prediction.path_of.empty()) continue;  // the button that draws has the room
            Opened it(exercise, 512, 1024);
            it.desk.strings = speaking(language);
            if (language != "en") add_translations(it.desk.strings, texts_of(exercise), words_of_course(language));
            it.desk.view.program.touch = true, it.desk.view.program.finger = 57;
            it.desk.frame(8);
            const Rect* last = it.desk.anchors.find("exercise.predict." + std::to_string(answers));
            EXPECT_GE(last ? last->h : 0, 57) << exercise.id << ", " << language;
            ++seen;
        }
    EXPECT_GT(seen, 40);
}

}  // namespace braitenlab::tests::exercises_layout_test
