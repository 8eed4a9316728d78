// The question of a page of a lecture: counted hands, shares and the answer.
#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "lecture_on_desk.h"
#include "ui/widgets/paint.h"

namespace braitenlab::tests::lecture_hands_test {

using namespace ui;

namespace {

struct LectureHands : LectureOnDesk {};

}  // namespace

TEST_F(LectureHands, CountsHandsByButtonAndByTyping) {
    show(1, 0);
    desk.click("lecture.more.2");
    ASSERT_TRUE(desk.last<HandsRequest>());
    EXPECT_EQ(desk.last<HandsRequest>()->option, 1);
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 1);
    pages.hands[1] = {0, 14, 0};
    desk.frame(2);
    desk.all.clear();
    desk.click("lecture.less.2");
    ASSERT_TRUE(desk.last<HandsRequest>());
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 13);
    desk.all.clear();
    desk.click("lecture.hands.1");
    desk.type("23");
    desk.frame(3);
    ASSERT_TRUE(desk.last<HandsRequest>());
    EXPECT_EQ(desk.last<HandsRequest>()->option, 0);
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 23);
    desk.key({'2'});
    EXPECT_TRUE(desk.actions().empty()) << "digits in the field select no slider";
}

TEST_F(LectureHands, ACountThatIsTypedCanBeSmallerAndPageKeysEndTyping) {
    show(1, 0);
    pages.hands[1] = {30, 0, 0};
    desk.frame(2);
    desk.click("lecture.hands.1");
    desk.type("7");
    desk.frame(3);
    ASSERT_TRUE(desk.last<HandsRequest>());
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 7);
    ASSERT_TRUE(desk.panels.lecture.hands[0].active);
    desk.key({key::page_down});
    EXPECT_EQ(desk.actions(), std::vector{Action::next_page});
    EXPECT_TRUE(desk.panels.keyboard.focus.empty());
    desk.frame(2);
    EXPECT_FALSE(desk.panels.lecture.hands[0].active);
}

TEST_F(LectureHands, TabGoesFromCountToCount) {
    show(1, 0);
    desk.frame(2);
    desk.click("lecture.hands.1");
    desk.type("12");
    desk.frame(3);
    desk.all.clear();
    desk.key({key::tab});
    desk.frame(3);
    desk.type("7");
    desk.frame(3);
    ASSERT_TRUE(desk.last<HandsRequest>());
    EXPECT_EQ(desk.last<HandsRequest>()->option, 1);
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 7);
    desk.key({key::tab, false, true});
    desk.frame(3);
    EXPECT_TRUE(desk.panels.lecture.hands[0].active);
}

TEST_F(LectureHands, EnterEndsTheTypingOfHands) {
    show(1, 0);
    desk.frame(2);
    desk.click("lecture.hands.1");
    desk.type("5");
    desk.key({key::enter});
    desk.frame(3);
    EXPECT_EQ(desk.last<HandsRequest>()->hands, 5);
    EXPECT_FALSE(desk.panels.lecture.hands[0].active);
    EXPECT_EQ(desk.panels.keyboard.focus, "");
}

TEST_F(LectureHands, TheTickOfAnOptionThatFillsItsLineCoversNoLetter) {
    ImGui::GetIO().DisplaySize = {1920, 1080};
    for (const char* name : {"four-numbers", "wheels-to-neurons"}) {
        pages = opened_lecture(name);
        for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
            show(page, 2);
            const Rect* tick = desk.anchors.find("lecture.tick");
            if (!tick) continue;
            for (const Written& w : desk.written) {
                if (w.words.size() != 1) continue;
                EXPECT_FALSE(tick->overlaps(w.rect)) << name << " " << page + 1 << ": " << w.words;
            }
        }
    }
}

TEST_F(LectureHands, TheKeyThatBlanksEndsTheTypingOfHands) {
    show(1, 0);
    desk.frame(2);
    desk.click("lecture.hands.1");
    desk.key({'.'});
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("lecture.blank"));
}

TEST_F(LectureHands, TheBarOfAnOptionHasTheShareOfAllHands) {
    show(1, 0);
    pages.hands[1] = {3, 12, 1};
    desk.frame(3);
    const Rect bar = desk.where("lecture.share.2");
    float from = 1e9f, to = 0;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int l = 0; l < data.CmdListsCount; ++l)
        for (const ImDrawVert& v : data.CmdLists[l]->VtxBuffer)
            if (bar.contains(v.pos.x, v.pos.y) && v.col == paint(palette(desk.view.program.theme).accent))
                from = std::min(from, v.pos.x), to = std::max(to, v.pos.x);
    EXPECT_NEAR((to - from) / bar.w, 12.0f / 16, 0.02f);
}

TEST_F(LectureHands, AShortBarIsAsLongAsItsShareToo) {
    for (const int step : {0, 2}) {
        show(1, step);
        pages.hands[1] = {2, 45, 3};  // 4 %, 90 %, 6 %
        desk.frame(3);
        std::array<float, 3> lengths{};
        const Palette& p = palette(desk.view.program.theme);
        for (std::size_t option = 0; option < lengths.size(); ++option) {
            const Rect bar = desk.where("lecture.share." + std::to_string(option + 1));
            float from = 1e9f, to = 0;
            const ImDrawData& data = *ImGui::GetDrawData();
            for (int l = 0; l < data.CmdListsCount; ++l)
                for (const ImDrawVert& v : data.CmdLists[l]->VtxBuffer)
                    if (bar.contains(v.pos.x, v.pos.y) &&
                        (v.col == paint(p.accent) || v.col == paint(p.text) || v.col == paint(p.success)))
                        from = std::min(from, v.pos.x), to = std::max(to, v.pos.x);
            lengths[option] = (to - from) / bar.w;
        }
        EXPECT_NEAR(lengths[0], 0.04f, 0.01f) << step;
        EXPECT_NEAR(lengths[1], 0.90f, 0.01f) << step;
        EXPECT_NEAR(lengths[2], 0.06f, 0.01f) << step;
    }
}

TEST_F(LectureHands, TheTallyHasPercentagesBesideTheBarsAlsoOnceTheAnswerIsKnown) {
    const int answer = static_cast<int>(pages.lecture->pages[1].steps.size());
    for (const char* code : {"en", "de"})
        for (const int step : {0, answer}) {
            desk.strings = speaking(code);
            show(1, step);
            EXPECT_FALSE(desk.says("%")) << "nothing is counted";
            pages.hands[1] = {3, 12, 1};
            desk.frame(3);
            for (const auto& [option, words] : {std::pair{1, "19"}, {2, "75"}, {3, "6"}}) {
                const std::string percent = words + std::string(code[0] == 'd' ? " %" : "%");
                const Rect bar = desk.where("lecture.share." + std::to_string(option));
                bool beside = false;
                for (const Written& w : desk.written)
                    beside |= w.words == percent && w.rect.x >= bar.x + bar.w && w.rect.y < bar.y + bar.h &&
                              w.rect.y + w.rect.h > bar.y;
                EXPECT_TRUE(beside) << percent << " at step " << step;
            }
            pages.hands[1] = {0, 0, 0};
        }
}

TEST_F(LectureHands, AnAnswerWithoutCountedHandsHasNoBars) {
    const auto draws_bar = [&] {
        const Rect bar = desk.where("lecture.share.1");
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int l = 0; l < data.CmdListsCount; ++l)
            for (const ImDrawVert& v : data.CmdLists[l]->VtxBuffer)
                if (v.pos.x > bar.x - 2 && v.pos.x < bar.x + bar.w + 2 && v.pos.y > bar.y - 2 &&
                    v.pos.y < bar.y + bar.h + 2)
                    return true;
        return false;
    };
    for (const Theme theme : {Theme::dark, Theme::light}) {
        desk.view.program.theme = theme;
        pages.hands[1] = {0, 0, 0};
        show(1, 1);
        EXPECT_TRUE(draws_bar()) << "hands may be raised";
        show(1, 2);
        ASSERT_TRUE(pages.shows(PagePart::answer));
        EXPECT_TRUE(desk.anchors.find("lecture.right"));
        EXPECT_FALSE(draws_bar()) << "nothing was counted";
        pages.hands[1] = {1, 0, 0};
        desk.frame(2);
        EXPECT_TRUE(draws_bar());
    }
}

TEST_F(LectureHands, ACountWithoutAPageGivesWayToAComparisonAndToASum) {
    Lecture lecture;
    lecture.pages.resize(1);
    lecture.pages[0].question.options.resize(4);
    LectureView tally{.lecture = std::make_shared<const Lecture>(lecture), .hands = {{1, 0, 0, 3}}};
    const auto logic = load_scene(shipped_exercises() / "scenes" / "5-logic.toml");
    ASSERT_TRUE(logic);
    desk.now = first_moment_of(*logic);
    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    desk.view.pages = nullptr;
    desk.view.tally = &tally;
    const auto counts = [&] { return desk.layout.question.w > 0; };
    desk.frame(4);
    ASSERT_TRUE(counts());

    insight::Design design{.brain = *desk.now.brains[0]};
    insight::CompareNumbers numbers{0.4f, 5.3f, 0.5f, 7, 3};
    SlotsView& slots = desk.view.features.slots;
    for (SlotView& slot : slots.slots) slot = {.design = &design, .kind = "vehicle", .numbers = &numbers};
    slots.seconds = 30;
    desk.frame(4);
    EXPECT_FALSE(counts());
    EXPECT_TRUE(is_inside(desk.where("card.slots"), desk.layout.window));
    slots = {};
    desk.frame(4);
    EXPECT_TRUE(counts()) << "after the comparison";

    desk.view.settings.watching = true;
    desk.frame(4);
    EXPECT_TRUE(counts());
    for (int i = 0; i < 3; ++i) {
        desk.key({'X'});
        desk.frame(4);
        EXPECT_FALSE(counts());
        EXPECT_TRUE(desk.anchors.find("canvas.sum")) << i;
    }
    desk.view.tally = nullptr;
    desk.frame(2);
    desk.view.tally = &tally;
    desk.frame(4);
    EXPECT_TRUE(counts()) << "a count that begins";
    EXPECT_FALSE(desk.anchors.find("canvas.sum"));
}

TEST_F(LectureHands, AQuestionWithoutAPageHasATallyOfLettersBesideTheScene) {
    Lecture lecture;
    lecture.pages.resize(1);
    lecture.pages[0].question.options.resize(4);
    LectureView tally{.lecture = std::make_shared<const Lecture>(lecture), .hands = {{0, 0, 0, 0}}};
    desk.view.pages = nullptr;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("lecture.question"));
    desk.key({'V', false, true});
    EXPECT_EQ(desk.actions(), std::vector{Action::tally});
    for (const auto& [width, height] : {std::pair{1024.0f, 768.0f}, std::pair{1280.0f, 800.0f}}) {
        ImGui::GetIO().DisplaySize = {width, height};
        desk.view.tally = &tally;
        tally.hands = {{0, 0, 0, 0}};
        desk.frame(4);
        EXPECT_EQ(switched_on(desk.view, desk.panels, Action::tally), true);
        const Rect card = desk.where("lecture.question");
        EXPECT_TRUE(is_inside(card, desk.layout.window));
        EXPECT_FALSE(overlap(card, desk.where("viewport")));
        EXPECT_GE(desk.where("viewport").w, 0.5f * width);
        for (const char* letter : {"A", "B", "C", "D"}) EXPECT_TRUE(desk.says(letter));
        EXPECT_LE(desk.where("tally.more").y + desk.where("tally.more").h, card.y + card.h - 4) << "whole";
        EXPECT_GE(desk.where("tally.more").h, desk.where("lecture.more.4").h - 1) << "not clipped";
        desk.all.clear();
        desk.click("lecture.more.4");
        ASSERT_TRUE(desk.last<HandsRequest>());
        EXPECT_EQ(desk.last<HandsRequest>()->option, 3);
        EXPECT_EQ(desk.last<HandsRequest>()->hands, 1);
        desk.click("tally.fewer");
        ASSERT_TRUE(desk.last<TallyRequest>());
        EXPECT_EQ(desk.last<TallyRequest>()->options, 3u) << "a question with three options";
        desk.click("tally.more");
        EXPECT_EQ(desk.last<TallyRequest>()->options, 5u);
        tally.hands = {{1, 0, 0, 3}};
        desk.frame(2);
        EXPECT_TRUE(desk.says("75%"));
        desk.rest();
    }
}

TEST_F(LectureHands, RevealsTheAnswerWithItsReasonAtItsStep) {
    show(1, 1);
    const LectureQuestion& asked = pages.current().question;
    EXPECT_FALSE(desk.anchors.find("lecture.right"));
    EXPECT_FALSE(desk.says(asked.why));
    pages.hands[1] = {3, 12, 1};
    show(1, 2);
    EXPECT_TRUE(desk.anchors.find("lecture.right"));
    EXPECT_TRUE(desk.says("A  " + asked.options[0])) << "options keep their letters";
    EXPECT_TRUE(desk.says("B  ✓ " + asked.options[1]));
    EXPECT_TRUE(desk.says(asked.why));
    EXPECT_TRUE(desk.says("12"));
    EXPECT_FALSE(desk.anchors.find("lecture.more.1"));
}

TEST_F(LectureHands, AFoldedQuestionIsAsLowAsItsHeadingAndUnfoldsOnTheNextPageAndWithTheAnswer) {
    show(1, 0);
    const auto fold = [&] {
        desk.panels.lecture.question.folded = true;
        desk.frame(3);
        EXPECT_LT(desk.where("lecture.question").h, 80) << "a heading";
    };
    fold();
    pages.step = 1;
    desk.frame(3);
    EXPECT_TRUE(desk.panels.lecture.question.folded) << "a step that is no answer";
    desk.panels.lecture.question.content = 0;
    desk.frame(3);
    EXPECT_LT(desk.where("lecture.question").h, 80) << "also before it is measured";
    pages.step = 2;
    desk.frame(3);
    EXPECT_FALSE(desk.panels.lecture.question.folded);
    EXPECT_TRUE(desk.says(pages.current().question.why));
    fold();
    show(3, 1);
    EXPECT_FALSE(desk.panels.lecture.question.folded);
    EXPECT_TRUE(desk.anchors.find("lecture.more.1"));
}

TEST_F(LectureHands, TellsThatTheFirstFrameOfAQuestionHasNotItsHeight) {
    show(1, 0);
    desk.panels.lecture.question = {};
    desk.frame();
    EXPECT_TRUE(desk.panels.is_unsettled) << "its height is not known yet";
    desk.frame();
    EXPECT_FALSE(desk.panels.is_unsettled);
}

TEST_F(LectureHands, TheFirstFrameOfTheNextQuestionHasNotItsHeight) {
    show(1, 0);
    ASSERT_FALSE(desk.panels.is_unsettled);
    pages.page = 3, ++desk.view.run_id;
    desk.frame();
    EXPECT_TRUE(desk.panels.is_unsettled) << "the card has the height of the question before";
}

TEST_F(LectureHands, TheTickIsBesideTheRightOptionAndAboveItsBar) {
    for (const auto& [width, height] : {std::pair{1920.0f, 1080.0f}, {1280.0f, 1024.0f}}) {
        ImGui::GetIO().DisplaySize = {width, height};
        show(1, 2);
        const Rect* tick = desk.anchors.find("lecture.tick");
        if (!tick) continue;  // of the tight answer
        const Rect bar = desk.where("lecture.share.2"), option = desk.where("lecture.right");
        EXPECT_TRUE(is_inside(*tick, option)) << width;
        EXPECT_LT(tick->y + tick->h, bar.y + 1) << width;
    }
    ImGui::GetIO().DisplaySize = {1920, 1080};
    show(1, 2);
    EXPECT_TRUE(desk.anchors.find("lecture.tick"));
}

TEST_F(LectureHands, TheAnswerPushesNoOptionOutOfASmallWindow) {
    for (const std::string& code : shipped_codes())
        for (const char* name : {"four-numbers", "wheels-to-neurons"}) {
            if (code != "en") desk.strings = speaking_in_lectures(code);
            pages = opened_lecture(name);
            for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
                show(page, 2);
                const std::size_t options = pages.current().question.options.size();
                if (options == 0) continue;
                SCOPED_TRACE(code + " " + name + " " + std::to_string(page + 1));
                ASSERT_TRUE(pages.shows(PagePart::answer));
                for (int& hands : pages.hands[static_cast<std::size_t>(page)]) hands = 12;
                desk.frame(2);
                const std::string last = "lecture.share." + std::to_string(options);
                ASSERT_TRUE(desk.anchors.find(last)) << "the last option is visible without scrolling";
                EXPECT_GT(desk.where(last).h, 15) << "not clipped";
            }
        }
}

TEST_F(LectureHands, TheAnswerMovesNoOptionWhereTheReasonHasRoom) {
    ImGui::GetIO().DisplaySize = {1920, 1080};
    for (const bool notes : {false, true}) {
        pages.notes = notes;
        std::vector<Rect> before;
        show(1, 1);
        ASSERT_FALSE(pages.shows(PagePart::answer));
        for (const char* id : {"lecture.share.1", "lecture.share.2", "lecture.share.3"})
            before.push_back(desk.where(id));
        show(1, 2);
        ASSERT_TRUE(pages.shows(PagePart::answer));
        for (const Rect& bar : before) {
            const Rect now = desk.where("lecture.share." + std::to_string(&bar - before.data() + 1));
            EXPECT_NEAR(now.x, bar.x, 1);  // sums of rounded widths
            EXPECT_EQ(now.y, bar.y);
        }
    }
}

TEST_F(LectureHands, TheReasonsOfALectureAreBelowAllOptionsAndHaveOneSize) {
    for (const auto& [width, height] : {std::pair{1024.0f, 768.0f}, {800.0f, 600.0f}, {1280.0f, 800.0f}})
        for (const char* name : {"four-numbers", "wheels-to-neurons"}) {
            ImGui::GetIO().DisplaySize = {width, height};
            pages = opened_lecture(name);
            std::set<float> sizes;
            for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
                show(page, 2);
                const LectureQuestion& asked = pages.current().question;
                if (asked.options.empty()) continue;
                SCOPED_TRACE(std::string(name) + " " + std::to_string(page + 1) + " at " + std::to_string(width));
                const Rect last = desk.where("lecture.count." + std::to_string(asked.options.size()));
                const Written* reason = nullptr;  // its first line, of those that begin as it does
                for (const Written& w : desk.written)
                    if (asked.why.starts_with(w.words) && (!reason || w.words.size() > reason->words.size()))
                        reason = &w;
                ASSERT_TRUE(reason);
                EXPECT_GT(reason->rect.y, last.y);
                sizes.insert(reason->size);
            }
            EXPECT_EQ(sizes.size(), 1u) << name << width;
        }
}

TEST_F(LectureHands, TheBarsAreLongAlsoBeforeTheAnswer) {
    show(1, 0);
    const Rect card = desk.where("lecture.question");
    for (const char* bar : {"lecture.share.1", "lecture.share.2", "lecture.share.3"})
        EXPECT_GT(desk.where(bar).w, 0.3f * card.w) << bar;
}

TEST_F(LectureHands, TheReasonIsInALargeSizeWhereItHasRoom) {
    const auto size_of = [&](const std::string& first) {
        float size = 0;
        for (const Written& w : desk.written)
            if (w.words.rfind(first, 0) == 0) size = w.size;
        return size;
    };
    const auto size_of_reason = [&] { return size_of(pages.current().question.why.substr(0, 12)); };
    ImGui::GetIO().DisplaySize = {1920, 1080};
    show(1, 2);
    const float large = size_of_reason();
    ImGui::GetIO().DisplaySize = {1024, 500};
    show(1, 2);
    EXPECT_GT(size_of_reason(), 0);
    EXPECT_GT(large, 1.05f * size_of_reason());
}

TEST_F(LectureHands, TheAnswerOfThePageTellsTheOutcomeOfItsExercise) {
    pages = opened_lecture("wheels-to-neurons");
    desk.open_exercise();
    show(5, 1);
    desk.follow_disclosure();
    EXPECT_TRUE(hides_outcome(desk.view));
    show(5, 2);
    desk.follow_disclosure();
    EXPECT_FALSE(hides_outcome(desk.view));
}

}  // namespace braitenlab::tests::lecture_hands_test
