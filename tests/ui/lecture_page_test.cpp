// The parts of a page of a lecture file in the window: caption, diagram, notes, notice and type.
#include <utility>

#include "lecture_on_desk.h"
#include "ui/widgets/drawn_text.h"

namespace braitenlab::tests::lecture_page_test {

using namespace ui;

namespace {

struct LecturePages : LectureOnDesk {};

}  // namespace

TEST_F(LecturePages, CaptionAndOptionsFitIntoSmallWindowsInEveryLanguage) {
    for (const std::string& code : shipped_codes())
        for (const char* name : {"four-numbers", "wheels-to-neurons"}) {
            if (code != "en") desk.strings = speaking_in_lectures(code);
            pages = opened_lecture(name);
            for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
                show(page, 0);
                SCOPED_TRACE(code + " " + name + " " + std::to_string(page + 1));
                const Rect caption = desk.where("lecture.caption"), window = desk.layout.window;
                EXPECT_TRUE(is_inside(caption, window));
                int lines = 0;
                for (const Written& w : desk.written)
                    if (is_inside(w.rect, caption)) ++lines;
                EXPECT_TRUE(lines == 1 || lines == 2) << lines;
                EXPECT_FALSE(overlap(caption, desk.where("viewport")));
                const std::size_t options = pages.current().question.options.size();
                if (options == 0) continue;
                EXPECT_FALSE(overlap(desk.where("lecture.question"), desk.where("viewport")));
                const std::string last = "lecture.share." + std::to_string(options);
                ASSERT_TRUE(desk.anchors.find(last)) << "the last option is visible without scrolling";
                EXPECT_GT(desk.where(last).h, 15) << "not clipped";
            }
        }
}

namespace {

// Windows with the scale that a lecture has in them.
struct Size {
    float width, height, scale;
};
constexpr Size sizes[]{
    {1280, 800, 1.4f}, {1024, 768, 1.4f}, {1920, 1080, 1.75f}, {2560, 1440, 2.8f}};  // as the lab scales a lecture

// A page of a lecture with all of its steps, with the diagram or the card of the brain.
struct RevealedPage {
    LectureView pages;
    Desk desk;
    RevealedPage(const char* lecture, int page, const Size& size, const std::string& code)
        : pages(opened_lecture(lecture)), desk(size.width, size.height, size.scale, true) {
        pages.page = page, pages.step = static_cast<int>(pages.current().steps.size());
        desk.strings = speaking(code);
        desk.now = first_moment(pages.current());
        desk.view.pages = &pages;
        desk.view.lecture = true;
        desk.view.program.theme = Theme::light;
        desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
        desk.view.settings.watching = pages.shows(PagePart::wiring);
        desk.frame(5);
    }
    bool has_diagram() const { return desk.view.settings.watching; }
};

template <class Check>
void each_revealed_page(const Check& check) {
    for (const Size& size : sizes)
        for (const std::string& code : shipped_codes())
            for (const char* lecture : {"four-numbers", "wheels-to-neurons"}) {
                const int count = static_cast<int>(opened_lecture(lecture).lecture->pages.size());
                for (int page = 0; page < count; ++page) {
                    SCOPED_TRACE(code + " " + lecture + " " + std::to_string(page + 1) + " at " +
                                 std::to_string(size.width));
                    RevealedPage shown(lecture, page, size, code);
                    if (shown.has_diagram() || shown.pages.shows(PagePart::sliders)) check(shown, size);
                }
            }
}

// Calls `check` with the size of the window and the lines of the caption of each page of the shipped lectures.
template <class Check>
void each_caption(Check check) {
    for (const Size& size : sizes)
        for (const std::string& code : shipped_codes())
            for (const char* lecture : {"fitter", "four-numbers", "wheels-to-neurons"}) {
                Desk desk(size.width, size.height, size.scale, true);
                LectureView pages = opened_lecture(lecture);
                if (code != "en") desk.strings = speaking_in_lectures(code);
                desk.view.pages = &pages;
                desk.view.lecture = true;
                for (; pages.page < static_cast<int>(pages.lecture->pages.size()); ++pages.page) {
                    desk.frame(2);
                    SCOPED_TRACE(code + " " + lecture + " " + std::to_string(pages.page + 1) + " at " +
                                 std::to_string(size.width));
                    std::vector<Written> lines;
                    for (const Written& w : desk.written)
                        if (is_inside(w.rect, desk.where("lecture.caption"))) lines.push_back(w);
                    check(size, lines);
                }
            }
}

}  // namespace

TEST(LecturePageType, TheCaptionsOfALectureHaveTheSizeOfCaptionsAndAtMostTwoLines) {
    each_caption([](const Size& size, const std::vector<Written>& lines) {
        for (const Written& w : lines) EXPECT_NEAR(w.size, 28 * size.scale, 1) << w.words;
        EXPECT_GE(lines.size(), 1u);
        EXPECT_LE(lines.size(), 2u);
    });
}

TEST(LecturePageType, NoCaptionLeavesOneWordAloneOnALine) {
    int broken = 0;
    each_caption([&](const Size&, const std::vector<Written>& lines) {
        if (lines.size() < 2) return;
        ++broken;
        EXPECT_NE(lines.back().words.find(' '), std::string::npos) << lines.back().words;
        EXPECT_GT(lines.back().rect.w, 0.5f * lines.front().rect.w) << lines.back().words;
    });
    EXPECT_GT(broken, 5);
}

TEST_F(LecturePages, ALongCaptionOfAnyPageMakesAllOfThemSmaller) {
    auto lecture = std::make_shared<Lecture>(*pages.lecture);
    lecture->pages[4].caption.clear();
    for (int word = 0; word < 13; ++word) lecture->pages[4].caption += "mmmmmmmm ";
    pages.lecture = lecture;
    for (const int page : {1, 4}) {
        show(page, 0);
        for (const Written& w : desk.written)
            if (is_inside(w.rect, desk.where("lecture.caption"))) {
                EXPECT_NEAR(w.size, 20 * 1.4f, 1) << page;
            }
    }
}

TEST(LecturePageType, ThreeLongOptionsFitBesideTheScene) {
    for (const Size& size : sizes)
        for (const int step : {0, 1}) {
            Desk desk(size.width, size.height, size.scale, true);
            LectureView pages = opened_lecture("four-numbers");
            auto lecture = std::make_shared<Lecture>(*pages.lecture);
            LecturePage& page = lecture->pages[3];
            page.question.text = "What happens once the middle lamp goes out?";
            page.question.options = {"It keeps its last curve for the rest of the run",
                                     "It drives straight ahead at its base speed",
                                     "It stops, because no light drives the wheels"};
            page.question.why = "Both eyes read 0, so both wheels get the same bias: it drives straight ahead.";
            page.steps = {"answer"}, page.reveal = {PageParts{}};
            page.reveal[0][static_cast<std::size_t>(PagePart::answer)] = true;
            pages.lecture = lecture, pages.page = 3, pages.step = step;
            pages.hands[3] = {80, 100, 20};
            desk.view.pages = &pages;
            desk.view.lecture = true;
            desk.frame(5);
            SCOPED_TRACE(std::to_string(size.width) + (step > 0 ? ", answered" : ""));
            const Rect card = desk.where("lecture.question");
            EXPECT_LE(card.y + card.h, size.height);
            int seen = 0;
            for (const Written& w : desk.written) {
                if (!overlap(w.rect, card)) continue;
                EXPECT_FALSE(w.scrolls) << w.words;
                EXPECT_TRUE(is_inside(w.rect, card)) << w.words;
                for (const std::string& option : page.question.options) seen += w.words.ends_with(option);
            }
            EXPECT_EQ(seen, 3);
            EXPECT_TRUE(desk.anchors.find("lecture.share.3"));
        }
}

TEST(LecturePageType, QuestionsAndAnswersAreLegibleFromTheLastRowAndOptionsHaveOneSize) {
    constexpr float line_by_letters = 1.362f;
    for (const Size& size : sizes)
        for (const char* lecture : {"four-numbers", "wheels-to-neurons"}) {
            Desk desk(size.width, size.height, size.scale, true);
            LectureView pages = opened_lecture(lecture);
            desk.strings = speaking_in_lectures("de");
            desk.view.pages = &pages;
            desk.view.lecture = true;
            float of_options = 0;
            for (; pages.page < static_cast<int>(pages.lecture->pages.size()); ++pages.page)
                for (pages.step = 0; pages.step <= 2; ++pages.step) {
                    const LectureQuestion& asked = pages.current().question;
                    desk.frame(4);
                    if (asked.options.empty() || !desk.anchors.find("lecture.question")) continue;
                    SCOPED_TRACE(std::string(lecture) + " " + std::to_string(pages.page + 1) + "." +
                                 std::to_string(pages.step) + " at " + std::to_string(size.width));
                    for (const Written& w : desk.written) {
                        if (!is_inside(w.rect, desk.where("lecture.question"))) continue;
                        EXPECT_GE(w.rect.h, 0.022f * line_by_letters * size.height - 0.6f) << w.words;
                        if (w.words != "A" || pages.shows(PagePart::answer)) continue;
                        if (of_options == 0) of_options = w.size;
                        EXPECT_EQ(w.size, of_options);
                    }
                }
            EXPECT_GE(of_options, 20 * size.scale - 1);
        }
}

TEST(LecturePageType, AMapHasNoAnchorsOfLabels) {
    RevealedPage page("wheels-to-neurons", 12, sizes[1], "en");
    int nodes = 0;
    for (const auto& [id, rect] : page.desk.anchors.all()) {
        nodes += id.starts_with("node.");
        EXPECT_FALSE(id.starts_with("wire.") || id.starts_with("curve.")) << id << " is not drawn";
    }
    EXPECT_GT(nodes, 8);
}

// What the lecturer points at is legible from the last row: without the space between lines letters have 2.2 % of the
// height of the window.
TEST(LecturePageType, WeightsNamesAndEquationsAreNotSmallerThanAFiftiethOfTheWindow) {
    constexpr float line_by_letters = 1.362f;  // of the font
    int pages = 0;
    each_revealed_page([&](RevealedPage& page, const Size& size) {
        ++pages;
        for (const Written& w : page.desk.written)
            if (is_visible(w)) {
                EXPECT_GE(w.rect.h, 0.022f * line_by_letters * size.height - 0.6f) << w.words;
            }
    });
    EXPECT_GE(pages, 6 * 10);
}

TEST(LecturePageType, EveryTextOfEveryPageAndStepIsAtLeastAFiftiethOfTheWindow) {
    constexpr float line_by_letters = 1.362f;                               // of the font
    constexpr Size projectors[]{{1024, 768, 1.375f}, {1920, 1080, 1.75f}};  // as the lab scales a lecture
    for (const Size& size : projectors)
        for (const char* lecture : {"fitter", "four-numbers", "wheels-to-neurons"}) {
            const int count = static_cast<int>(opened_lecture(lecture).lecture->pages.size());
            for (int page = 0; page < count; ++page) {
                RevealedPage shown(lecture, page, size, "de");
                const int steps = shown.pages.step;
                for (int step = 0; step <= steps; ++step)
                    for (const bool notes : {false, true}) {
                        shown.pages.step = step, shown.pages.notes = notes;
                        shown.desk.view.settings.watching = shown.pages.shows(PagePart::wiring);
                        shown.desk.frame(4);
                        SCOPED_TRACE(std::string(lecture) + " " + std::to_string(page + 1) + "." +
                                     std::to_string(step) + " at " + std::to_string(size.width));
                        for (const Written& w : shown.desk.written)
                            if (is_visible(w)) {
                                EXPECT_GE(w.rect.h, 0.022f * line_by_letters * size.height - 0.6f) << w.words;
                            }
                    }
            }
        }
}

TEST(LecturePageType, ADiagramHasTheNameOfEveryNodeAndTheNumbersOfAFewAndNothingIsPale) {
    each_revealed_page([&](RevealedPage& page, const Size&) {
        if (!page.has_diagram()) return;
        const Rect canvas = page.desk.where("canvas");
        const BrainGraph& brain = *page.desk.now.brains[0];
        for (const Node& node : brain.nodes)
            EXPECT_GT(page.desk.where("name." + node.name).w, 0) << node.name << " has no name";
        EXPECT_EQ(page.desk.shortened, 0);
        std::vector<Rect> texts;
        int numbers = 0;
        for (const Written& w : page.desk.written) {
            if (!is_inside(w.rect, canvas)) continue;
            for (const Rect& other : texts) EXPECT_FALSE(overlap(other, w.rect)) << w.words;
            texts.push_back(w.rect);
            numbers += w.words.find("0.") != std::string::npos || w.words.find("0,") != std::string::npos ||
                       w.words.find("1.") != std::string::npos || w.words.find("1,") != std::string::npos;
        }
        if (brain.nodes.size() <= 4) {
            EXPECT_GE(numbers, 8) << "four nodes and four weights";
        }
    });
}

TEST(LecturePageType, TheNeuronsOfAShippedBrainHaveNamesInWords) {
    for (const auto& [code, name] : {std::pair{"en", "hungry"}, {"de", "hungrig"}, {"es", "hambre"}}) {
        RevealedPage page("wheels-to-neurons", 12, sizes[1], code);
        EXPECT_TRUE(page.desk.says(name)) << code;
        EXPECT_FALSE(page.desk.says("HUNGRY")) << code;
        for (const Node& node : page.desk.now.brains[0]->nodes)
            if (node.kind == NodeKind::neuron) {
                EXPECT_TRUE(page.desk.strings.all().contains("neuron." + node.name)) << node.name;
            }
    }
}

TEST_F(LecturePages, NotesLeaveTheOptionsOfTheQuestionInSightAndScroll) {
    for (const std::string& code : shipped_codes())
        for (const char* name : {"four-numbers", "wheels-to-neurons"}) {
            if (code != "en") desk.strings = speaking_in_lectures(code);
            pages = opened_lecture(name);
            pages.notes = true;
            for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
                show(page, 0);
                SCOPED_TRACE(code + " " + name + " " + std::to_string(page + 1));
                const std::size_t options = pages.current().question.options.size();
                const Rect notes = desk.where("lecture.notes");
                EXPECT_TRUE(is_inside(notes, desk.layout.window));
                EXPECT_GT(notes.h, 90) << "three lines";
                for (std::size_t i = 1; i <= options; ++i) {
                    const Rect bar = desk.where("lecture.share." + std::to_string(i));
                    EXPECT_GT(bar.h, 15) << "not clipped";
                    EXPECT_LE(bar.y + bar.h, notes.y) << i;
                    EXPECT_TRUE(desk.says(std::string(1, static_cast<char>('A' + i - 1)))) << "its letter";
                }
            }
        }
}

TEST_F(LecturePages, TheDiagramTakesThePlaceOfAnAnsweredQuestion) {
    desk.now = shipped_scene("2b-aggressor");
    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    show(3, 2);
    EXPECT_TRUE(desk.anchors.find("lecture.question"));
    desk.view.settings.watching = true;
    show(3, 3);
    EXPECT_FALSE(desk.anchors.find("lecture.question"));
    EXPECT_FALSE(overlap(desk.where("canvas"), desk.where("viewport")));
    for (const char* node : {"name.SL", "name.SR", "name.ML", "name.MR"})
        EXPECT_TRUE(is_inside(desk.where(node), desk.where("canvas"))) << node;
    desk.view.settings.watching = false;
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("lecture.question")) << "the lecturer has hidden the diagram";
}

TEST_F(LecturePages, TheWiringEditorHasTheRoomOfValuesThatThePageDoesNotShow) {
    desk.view.mode = Mode::wiring;
    show(2, 0);
    ASSERT_FALSE(pages.shows(PagePart::values));
    const auto below = [&] {
        const Rect inspector = desk.where("card.inspector");
        return desk.layout.window.h - inspector.y - inspector.h;
    };
    EXPECT_LT(below(), 0.05f * desk.layout.window.h);
    show(2, 2);
    ASSERT_TRUE(pages.shows(PagePart::values));
    EXPECT_GT(below(), 0.1f * desk.layout.window.h);
}

TEST_F(LecturePages, ShowsThePageNumberAndTheTitleOfTheLecture) {
    show(1, 0);
    EXPECT_TRUE(desk.says("2/10"));
    EXPECT_TRUE(desk.says("Four numbers"));
    EXPECT_FALSE(desk.says("A scene")) << "the title of the scene could tell the answer";
}

TEST_F(LecturePages, ATitleThatOneLineHasNoRoomForIsWholeInTwo) {
    auto lecture = std::make_shared<Lecture>(*pages.lecture);
    lecture->title = "From two wheels to neurons and to what they learn";
    pages.lecture = lecture;
    show(1, 0);
    EXPECT_TRUE(desk.says("From two wheels"));
    EXPECT_TRUE(desk.says("they learn")) << "the end of the second line";
    for (const Written& w : desk.written) EXPECT_EQ(w.words.find("…"), std::string::npos) << w.words;
}

TEST_F(LecturePages, ALongTitleIsShortenedInTheBar) {
    Lecture lecture = *pages.lecture;
    lecture.title = "A coward, and what it is made of, with a title that is much longer than the bar of a lecture";
    pages.lecture = std::make_shared<const Lecture>(lecture);
    for (const auto& [width, height] : {std::pair{1024.0f, 768.0f}, {800.0f, 600.0f}}) {
        ImGui::GetIO().DisplaySize = {width, height};
        show(1, 0);
        EXPECT_TRUE(desk.says("A coward")) << width;
        for (const Written& w : desk.written)
            if (w.words.starts_with("A coward")) {
                EXPECT_LT(w.rect.x + w.rect.w, desk.where("lecture.previous").x);
            }
    }
}

TEST_F(LecturePages, AnExerciseThatAsksHasTheRoomOfTheSlidersUntilThePredictionIsMade) {
    const auto exercise = load_exercise(shipped_exercises() / "guided/05-aggressor.toml");
    Lecture lecture = *pages.lecture;
    LecturePage page;
    page.caption = "Your turn: make it attack";
    page.at_first[static_cast<std::size_t>(PagePart::exercise)] = true;
    page.at_first[static_cast<std::size_t>(PagePart::sliders)] = true;
    page.at_first[static_cast<std::size_t>(PagePart::caption)] = true;
    page.at_first[static_cast<std::size_t>(PagePart::brain)] = true;
    lecture.pages = {page};
    pages.lecture = std::make_shared<const Lecture>(lecture), pages.hands = {{}};
    desk.open_exercise();
    desk.lesson.exercise = &*exercise;
    desk.lesson.at_start = desk.lesson.as_given = true;
    desk.now = first_moment_of(exercise->scene);
    for (const std::string& code : shipped_codes()) {
        desk.strings = speaking(code);
        desk.lesson.attempt.answers.prediction = -1;
        desk.panels.exercise.id.clear();
        pages.page = 0;
        desk.view.pages = nullptr;
        desk.frame(2);
        desk.view.pages = &pages;
        show(0, 0);
        desk.frame(6);
        EXPECT_TRUE(desk.panels.card(Card::brain).folded);
        for (std::size_t i = 1; i <= exercise->prediction.options.size(); ++i) {
            const Rect option = desk.where("exercise.predict." + std::to_string(i));
            EXPECT_GT(option.h, 20) << code << " option " << i;
            EXPECT_TRUE(is_inside(option, desk.where("card.exercise")));
        }
        desk.lesson.attempt.answers.prediction = 0;
        desk.frame(4);
        EXPECT_FALSE(desk.panels.card(Card::brain).folded);
    }
}

TEST_F(LecturePages, OptionsThatAreNotLongNeedNoScrolling) {
    int fitting = 0;
    for (const int options : {2, 3, 4, 5, 6})
        for (const int words : {1, 4, 8, 12}) {
            Lecture lecture = *pages.lecture;
            LectureQuestion& asked = lecture.pages[1].question;
            std::string text = "It";
            for (int i = 0; i < words; ++i) text += " turns";
            asked.options.assign(static_cast<std::size_t>(options), text);
            pages.lecture = std::make_shared<const Lecture>(lecture);
            pages.hands[1].assign(static_cast<std::size_t>(options), 0);
            if (is_long(asked)) continue;
            show(1, 0);
            ++fitting;
            const Rect* bar = desk.anchors.find("lecture.share." + std::to_string(options));
            EXPECT_TRUE(bar && bar->h > 15) << options << " options of " << words + 1 << " words";
        }
    EXPECT_GT(fitting, 8);
}

TEST_F(LecturePages, ShowsNotesAndTheTimeOnRequestOnly) {
    show(2, 0);
    EXPECT_FALSE(desk.anchors.find("lecture.notes"));
    pages.notes = true, pages.seconds = 245;
    desk.frame(3);
    ASSERT_TRUE(desk.anchors.find("lecture.notes"));
    EXPECT_TRUE(desk.says("4:05"));
    EXPECT_TRUE(desk.says("7:00")) << "the planned end of page 3";
    EXPECT_TRUE(desk.says("Page Down shows the diagram"));
    for (int page = 0; page < 9; ++page) {
        show(page, 0);
        const Rect notes = desk.where("lecture.notes");
        EXPECT_TRUE(is_inside(notes, desk.layout.window));
        EXPECT_FALSE(overlap(notes, desk.where("viewport"))) << "they cover nothing";
        if (desk.anchors.find("lecture.question")) {
            EXPECT_FALSE(overlap(notes, desk.where("lecture.question")));
        }
        for (const Written& w : desk.written) {
            if (!overlap(w.rect, notes) || !is_visible(w)) continue;
            EXPECT_TRUE(is_inside(w.rect, notes)) << w.words;
        }
    }
}

TEST_F(LecturePages, NotesTakeThePlaceOfTheValues) {
    show(2, 2);
    ASSERT_TRUE(desk.anchors.find("lecture.left"));
    const float before = desk.where("viewport").h;
    pages.notes = true;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("lecture.left"));
    EXPECT_GT(desk.where("viewport").h, 0.6f * before) << "the scene keeps most of its height";
    pages.notes = false;
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("lecture.left"));
}

TEST_F(LecturePages, ANoticeIsInTheBarAndCoversNothing) {
    show(2, 2);
    ASSERT_TRUE(desk.anchors.find("lecture.left"));
    desk.view.notice = {NoticeKind::failure, "",
                        std::string(30, 'a') + std::string(" and more words to read") +
                            " in this long notice that takes two lines of the bar"};
    desk.frame(2);
    EXPECT_TRUE(is_inside(desk.where("hint.bar"), desk.layout.toolbar));
    EXPECT_TRUE(desk.anchors.find("lecture.left")) << "the values stay";
    int lines = 0;
    for (const Written& w : desk.written)
        if (is_inside(w.rect, desk.where("hint.bar"))) ++lines;
    EXPECT_EQ(lines, 2);
}

namespace {

// The words in the bar of a notice, without the space between lines.
std::string words_of_bar(const Desk& desk) {
    std::string all;
    for (const Written& w : desk.written)
        if (is_inside(w.rect, desk.where("hint.bar"))) all += w.words;
    std::erase(all, ' ');
    return all;
}

}  // namespace

TEST(LecturePageType, EveryNoticeIsWholeInTheBarInEveryLanguage) {
    LectureView pages = opened_lecture("four-numbers");
    constexpr Size small[]{{1024, 768, 1.4f}, {800, 600, 1}};
    int notices = 0;
    for (const Size& size : small)
        for (const std::string& code : shipped_codes()) {
            Desk own(size.width, size.height, size.scale, true);
            own.strings = speaking(code);
            own.now = snapshot(0);
            own.view.lecture = own.view.has_moved_camera = true;
            own.view.pages = &pages;
            for (const auto& [key, words] : own.strings.all()) {
                if (!key.starts_with("notice.") && !key.starts_with("unavailable.")) continue;
                own.view.notice = {NoticeKind::notice, key, "0.25", "4"};
                own.panels.lecture.pressed = {{KeyPress{'Q', false, true}, own.view.wall_seconds}};
                own.frame();
                std::string whole = text_of(own.view.notice, own.strings);
                std::erase(whole, ' ');
                EXPECT_EQ(words_of_bar(own), whole) << code << " " << key << " at " << size.width;
                for (const char* beside : {"lecture.page", "lecture.keys", "lecture.leave", "lecture.home"})
                    if (own.anchors.find(beside)) {
                        EXPECT_FALSE(overlap(own.where(beside), own.where("hint.bar"))) << beside << " " << key;
                    }
                ++notices;
            }
        }
    EXPECT_GT(notices, 300);
}

TEST(LecturePageType, AnOpenCardIsBelowAQuestionThatIsNotAnswered) {
    LectureView pages = opened_lecture("four-numbers");
    for (const Size& size : sizes) {
        SCOPED_TRACE(size.width);
        Desk own(size.width, size.height, size.scale, true);
        own.now = snapshot(0);
        own.view.lecture = true;
        own.view.pages = &pages;
        pages.page = 1;
        own.frame(3);
        own.panels.card(Card::brain).folded = false;
        own.frame(6);
        const Rect question = own.where("lecture.question"), brain = own.where("card.brain");
        EXPECT_TRUE(own.anchors.find("lecture.share.1"));
        EXPECT_GT(brain.h, 0.2f * own.layout.window.h);
        for (const Rect& card : {question, brain}) {
            EXPECT_TRUE(is_inside(card, own.layout.window));
            EXPECT_FALSE(overlap(card, own.where("viewport")));
        }
        EXPECT_FALSE(overlap(question, brain));
        EXPECT_GE(own.where("viewport").w, 0.5f * own.layout.window.w);
    }
}

TEST_F(LecturePages, AShortNoticeIsInTheSizeOfTheText) {
    show(2, 2);
    const auto size_of_notice = [&](const std::string& words) {
        desk.view.notice = {NoticeKind::failure, "", words};
        desk.frame(2);
        float size = 0;
        for (const Written& w : desk.written)
            if (is_inside(w.rect, desk.where("hint.bar"))) size = w.size;
        return size;
    };
    std::string much;
    for (int i = 0; i < 30; ++i) much += "words to read ";
    EXPECT_GT(size_of_notice("a short one"), 1.1f * size_of_notice(much));
}

TEST_F(LecturePages, AskingFirstHidesTheCaptionUntilTheTitleIsShown) {
    show(0, 0);
    const std::string caption = pages.current().caption;
    ASSERT_FALSE(caption.empty());
    EXPECT_GT(desk.layout.caption.w, 0);
    desk.view.settings.revealed = hidden_until_asked;
    show(0, 0);
    EXPECT_EQ(desk.layout.caption.w, 0);
    EXPECT_FALSE(desk.says(caption.substr(0, caption.find(' ', 8))));
    desk.view.settings.revealed.title = true;
    show(0, 0);
    EXPECT_GT(desk.layout.caption.w, 0);
}

TEST_F(LecturePages, AskingFirstLeavesTheCaptionThatAsksTheQuestion) {
    desk.view.settings.revealed = hidden_until_asked;
    int asked = 0;
    for (int page = 0; page < static_cast<int>(pages.lecture->pages.size()); ++page) {
        const LecturePage& each = pages.lecture->pages[static_cast<std::size_t>(page)];
        show(page, 0);
        const bool asks = !each.question.options.empty() && each.question.text.empty();
        EXPECT_EQ(desk.layout.caption.w > 0, asks && pages.shows(PagePart::caption)) << page;
        asked += asks;
    }
    EXPECT_GT(asked, 0);
}

TEST_F(LecturePages, HidingTheBrainAgainDoesNotBringTheAnsweredQuestionBack) {
    desk.now = shipped_scene("2b-aggressor");
    desk.view.settings.selection.vehicle = desk.now.vehicles.front().id;
    show(3, 3);
    ASSERT_TRUE(pages.shows(PagePart::answer));
    ASSERT_TRUE(pages.shows(PagePart::brain));
    desk.view.settings.watching = true;
    desk.frame(3);
    ASSERT_FALSE(desk.anchors.find("lecture.question"));
    desk.view.settings.revealed = hidden_until_asked;
    desk.frame(3);
    EXPECT_FALSE(desk.anchors.find("lecture.question"));
}

TEST_F(LecturePages, AskingFirstHidesTheNamesOfKindsAndTheStory) {
    desk.view.pages = nullptr;
    auto scene = std::make_shared<Scene>(*desk.now.scene);
    scene->kinds.push_back(scene->kinds[0]);
    scene->kinds[0].name = "coward", scene->kinds[1].name = "lover";
    scene->title = "Vehicle of fear", scene->story = "It flees.";
    desk.now.scene = scene;
    for (const Card card : {Card::brain, Card::scene}) desk.panels.card(card).folded = false;
    desk.frame(6);
    for (const Card card : {Card::brain, Card::scene}) desk.panels.card(card).folded = false;
    desk.frame(6);
    for (const char* told : {"Coward", "Vehicle of fear", "It flees."}) EXPECT_TRUE(desk.says(told)) << told;
    desk.view.settings.revealed = hidden_until_asked;
    desk.frame(6);
    for (const char* told : {"Coward", "Vehicle of fear", "It flees."}) EXPECT_FALSE(desk.says(told)) << told;
    desk.view.settings.revealed.title = desk.view.settings.revealed.character = true;
    desk.frame(6);
    for (const char* told : {"Coward", "Vehicle of fear", "It flees."}) EXPECT_TRUE(desk.says(told)) << told;
}

}  // namespace braitenlab::tests::lecture_page_test
