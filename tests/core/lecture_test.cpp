// Lecture files: reading, steps and shown parts, errors with line and nearest name, and the shipped lectures.
#include "core/lesson/lecture.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/lesson/exercise_file.h"

namespace braitenlab::tests::lecture_test {
namespace {

namespace fs = std::filesystem;

const fs::path source = BRAITENLAB_SOURCE;
const fs::path shipped = source / "exercises";

Result<Lecture> read(const std::string& pages) {
    return parse_lecture("format = 1\ntitle = \"T\"\nminutes = 5\n" + pages, "/nowhere/own.toml", shipped);
}

std::string error_of(const std::string& pages) {
    const auto lecture = read(pages);
    return lecture ? "no error" : lecture.error().text();
}

const std::string scene_page = "[[page]]\nscene = \"2a-coward\"\n";

TEST(Lecture, AStepShowsPartsThatAreHiddenUntilThen) {
    const auto lecture =
        read(scene_page + "hide = [\"labels\"]\nshow = [\"sliders\"]\nsteps = [\"caption\", \"brain values\"]\n");
    ASSERT_TRUE(lecture) << lecture.error().text();
    const LecturePage& page = lecture->pages[0];
    ASSERT_EQ(page.reveal.size(), 2u);
    for (const PagePart part : {PagePart::caption, PagePart::brain, PagePart::values, PagePart::labels})
        EXPECT_FALSE(shows(page, part, 0)) << word(part);
    EXPECT_TRUE(shows(page, PagePart::sliders, 0));
    EXPECT_TRUE(shows(page, PagePart::trails, 0));
    EXPECT_TRUE(shows(page, PagePart::caption, 1));
    EXPECT_FALSE(shows(page, PagePart::brain, 1));
    EXPECT_TRUE(shows(page, PagePart::brain, 2));
    EXPECT_TRUE(shows(page, PagePart::values, 2));
    EXPECT_FALSE(shows(page, PagePart::labels, 2));
}

TEST(Lecture, TheAnswerIsTheLastStepUnlessThePageNamesIt) {
    const std::string question = "[page.question]\noptions = [\"left\", \"right\"]\nanswer = \"right\"\n";
    const auto last = read(scene_page + "steps = [\"play\"]\n" + question);
    ASSERT_TRUE(last) << last.error().text();
    EXPECT_EQ(last->pages[0].question.answer, 1);
    EXPECT_FALSE(shows(last->pages[0], PagePart::answer, 1));
    EXPECT_TRUE(shows(last->pages[0], PagePart::answer, 2));
    EXPECT_TRUE(shows(last->pages[0], PagePart::question, 0));
    const auto named = read(scene_page + "steps = [\"answer\", \"play\"]\n" + question);
    ASSERT_TRUE(named);
    EXPECT_EQ(named->pages[0].reveal.size(), 2u);
    EXPECT_TRUE(shows(named->pages[0], PagePart::answer, 1));
    const auto shown = read(scene_page + "show = [\"answer\"]\n" + question);
    ASSERT_TRUE(shown);
    EXPECT_TRUE(shown->pages[0].reveal.empty()) << "nothing is left to show";
    EXPECT_NE(error_of(scene_page + "steps = [\" \"]\n").find("names at least one part"), std::string::npos);
}

TEST(Lecture, ErrorsNameTheLineAndTheNearestWord) {
    EXPECT_EQ(error_of(""), "/nowhere/own.toml: 'page' is missing; a lecture has a title, minutes and [[page]] tables");
    EXPECT_EQ(error_of("[[page]]\nscene = \"2a-cowerd\"\n"),
              "/nowhere/own.toml:5: there is no file and no shipped scene called '2a-cowerd'; the nearest is "
              "'2a-coward'");
    EXPECT_EQ(error_of(scene_page + "steps = [\"play\", \"brian\"]\n"),
              "/nowhere/own.toml:6: 'steps' has no part 'brian'; the nearest is 'brain'");
    EXPECT_EQ(error_of(scene_page + "hides = [\"brain\"]\n"),
              "/nowhere/own.toml:6: no key 'hides' in [page.1]; the nearest is 'hide'");
    EXPECT_EQ(error_of(scene_page + "exercise = \"01-drive\"\n"),
              "/nowhere/own.toml:6: a page has either 'scene' or 'exercise'; give one of them");
    EXPECT_EQ(error_of(scene_page + "[page.question]\noptions = [\"left\", \"right\"]\n"),
              "/nowhere/own.toml:6: 'answer' is missing; give the text of the right option");
    EXPECT_EQ(error_of(scene_page + "minutes = -1\n"), "/nowhere/own.toml:6: 'minutes' is -1, outside 0 .. 240");
}

TEST(Lecture, EveryErrorIsReportedOnceByLine) {
    const auto errors_in = [](const std::string& pages) {
        std::vector<std::string> lines;
        for (const Error& each :
             errors_of_lecture("format = 1\ntitel = \"T\"\nminutes = 5\n" + pages, "/nowhere/own.toml", shipped))
            lines.push_back(each.text());
        return lines;
    };
    const std::vector<std::string> wanted{":2: no key 'titel' at the top of the file; the nearest is 'title'",
                                          ":5: there is no file and no shipped scene called '2a-cowerd'",
                                          ":7: no key 'scen' in [page.2]; the nearest is 'scene'",
                                          ":10: 'hide' has no part 'brian'; the nearest is 'brain'",
                                          ":11: 'select' names 'two'"};
    const auto found = errors_in(
        "[[page]]\nscene = \"2a-cowerd\"\n[[page]]\nscen = \"2a-coward\"\n[[page]]\nscene = \"2a-coward\"\n"
        "hide = [\"brian\"]\n[[page]]\nscene = \"2a-coward\"\nselect = \"two\"\n");
    ASSERT_EQ(found.size(), wanted.size()) << testing::PrintToString(found);
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NE(found[i].find(wanted[i]), std::string::npos) << found[i];
    EXPECT_EQ(errors_in(scene_page).size(), 1u) << "the title only";
    EXPECT_EQ(errors_in("page = 3\n").size(), 2u);
    EXPECT_EQ(errors_in(scene_page + "[page.question]\noptoins = [\"left\", \"right\"]\n").size(), 2u);
    EXPECT_EQ(errors_in(scene_page + "[page.question]\noptions = [\"left\", \"right\"]\nanwser = \"left\"\n").size(),
              2u);
}

TEST(Lecture, EveryWordOfAListThatIsNoPartIsNamedAtItsLine) {
    const std::vector<Error> errors = errors_of_lecture(
        "format = 1\ntitle = \"T\"\nminutes = 5\n[[page]]\nscene = \"2a-coward\"\nshow = [\"brian\", \"plai\"]\n"
        "steps = [\"plai answr\",\n\"play\",\n\"brian\"]\n",
        "/nowhere/own.toml", shipped);
    std::string all;
    for (const Error& each : errors) all += each.text() + "\n";
    const auto line = [](int number, const char* key, const char* word, const char* nearest) {
        return "/nowhere/own.toml:" + std::to_string(number) + ": '" + key + "' has no part '" + word +
               "'; the nearest is '" + nearest + "'\n";
    };
    EXPECT_EQ(all, line(6, "show", "brian", "brain") + line(6, "show", "plai", "play") +
                       line(7, "steps", "plai", "play") + line(7, "steps", "answr", "answer") +
                       line(9, "steps", "brian", "brain"));
}

TEST(Lecture, ACaptionIsMeasuredInCharacters) {
    const auto with_caption = [](std::size_t umlauts) {
        std::string caption;
        for (std::size_t i = 0; i < umlauts; ++i) caption += "ü";
        return scene_page + "caption = \"" + caption + "\"\n";
    };
    EXPECT_EQ(error_of(with_caption(121)),
              "/nowhere/own.toml:6: 'caption' has 121 characters, the most is 120; shorten it");
    EXPECT_EQ(error_of(with_caption(120)), "no error");
}

TEST(Lecture, ChecksThatEveryPageCanBeOpened) {
    const auto page = [](const std::string& more) { return check_pages(*read(scene_page + more)); };
    EXPECT_FALSE(page(""));
    EXPECT_FALSE(page("select = \"one\"\n"));
    EXPECT_FALSE(page("select = \"none\"\n"));
    EXPECT_TRUE(page("select = \"none\"\ncamera = \"follow\"\n")) << "there is nothing to follow";
    const auto unknown = page("select = \"two\"\n");
    ASSERT_TRUE(unknown);
    EXPECT_EQ(unknown->file, "/nowhere/own.toml");
    EXPECT_NE(unknown->text().find("'select' names 'two'"), std::string::npos) << unknown->text();
    EXPECT_NE(unknown->text().find("'one'"), std::string::npos) << unknown->text();
    const auto wrong = page("[page.set]\n\"kind.coward.brain.LL\" = 99\n");
    ASSERT_TRUE(wrong);
    EXPECT_NE(wrong->text().find("LL"), std::string::npos) << wrong->text();
}

TEST(Lecture, ShippedOnesCanBeOpenedAndTheirPagesTakeTheTimeOfTheLecture) {
    std::vector<float> minutes;
    for (const auto& entry : fs::directory_iterator(shipped / "lectures")) {
        const auto lecture = load_lecture(entry.path(), shipped);
        ASSERT_TRUE(lecture) << lecture.error().text();
        const auto error = check_pages(*lecture);
        EXPECT_FALSE(error) << error->text();
        EXPECT_NEAR(minutes_of_pages(*lecture), lecture->minutes, 0.1f * lecture->minutes) << entry.path();
        minutes.push_back(lecture->minutes);
        for (const LecturePage& page : lecture->pages) EXPECT_GE(page.notes.size(), 80u) << page.caption;
    }
    std::sort(minutes.begin(), minutes.end());
    EXPECT_EQ(minutes, (std::vector<float>{8, 20, 45}));
}

TEST(Lecture, TheFormatPageHasTheGeneratedTablesAndAnExampleThatReads) {
    const fs::path path = source / "docs" / "lecture-format.md";
    std::ifstream in(path);
    std::string text((std::istreambuf_iterator<char>(in)), {});
    if (std::getenv("BRAITENLAB_WRITE_DOCS")) {
        text = text.substr(0, text.find("\n## The top of the file")) + describe_lecture_format();
        std::ofstream(path, std::ios::binary) << text;
    }
    EXPECT_NE(text.find(describe_lecture_format()), std::string::npos);
    std::istringstream lines(text);
    std::string example;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("    ") || (line.empty() && !example.empty())) example += line + '\n';
    const auto lecture = parse_lecture(example, "/nowhere/example.toml", shipped);
    ASSERT_TRUE(lecture) << lecture.error().text();
    EXPECT_FALSE(check_pages(*lecture));
    EXPECT_EQ(lecture->pages.size(), 2u);
}

TEST(Lecture, AQuestionHasTwoOrMoreOptions) {
    EXPECT_EQ(error_of(scene_page + "[page.question]\noptions = [\"left\"]\nanswer = \"left\"\n"),
              "/nowhere/own.toml:6: 'options' needs two or more texts");
}

TEST(Lecture, TheOptionsOfAQuestionDiffer) {
    EXPECT_EQ(error_of(scene_page + "[page.question]\noptions = [\"left\", \"right\", \"left\"]\nanswer = \"left\"\n"),
              "/nowhere/own.toml:6: 'left' is offered twice");
}

TEST(Lecture, APageNamesAFileBesideTheLecture) {
    const fs::path folder = fs::temp_directory_path() / ("lecture-test-" + std::to_string(::getpid()));
    fs::create_directories(folder / "scenes");
    fs::copy_file(shipped / "scenes" / "2a-coward.toml", folder / "scenes" / "mine.toml",
                  fs::copy_options::overwrite_existing);
    const auto lecture =
        parse_lecture("format = 1\ntitle = \"T\"\nminutes = 5\n[[page]]\nscene = \"scenes/mine.toml\"\n",
                      folder / "own.toml", shipped);
    ASSERT_TRUE(lecture) << lecture.error().text();
    EXPECT_EQ(lecture->pages[0].file, folder / "scenes" / "mine.toml");
    EXPECT_FALSE(check_pages(*lecture));
    fs::remove_all(folder);
}

TEST(Lecture, AllItsTextsAreTranslated) {
    const auto lecture = read(scene_page +
                              "caption = \"C\"\nnotes = \"N\"\n[page.question]\ntext = \"Q\"\n"
                              "options = [\"left\", \"right\"]\nanswer = \"right\"\nwhy = \"W\"\n");
    ASSERT_TRUE(lecture) << lecture.error().text();
    std::string found;
    for (const TranslatableText& each : texts_of(*lecture)) found += each.id + "=" + each.text + "\n";
    EXPECT_EQ(found,
              "lecture.own.title=T\nlecture.own.page.1.caption=C\nlecture.own.page.1.notes=N\n"
              "lecture.own.page.1.question=Q\n"
              "lecture.own.page.1.option.1=left\nlecture.own.page.1.option.2=right\nlecture.own.page.1.why=W\n");
}

TEST(Lecture, TheValuesThatAPageSetsAreCheckedInAnExerciseToo) {
    const std::string page = "[[page]]\nexercise = \"05-aggressor\"\n";
    EXPECT_FALSE(check_pages(*read(page)));
    const auto wrong = check_pages(*read(page + "[page.set]\n\"vehicle.one.heading_spread\" = 999\n"));
    ASSERT_TRUE(wrong);
    EXPECT_NE(wrong->text().find("heading_spread"), std::string::npos) << wrong->text();
}

}  // namespace
}  // namespace braitenlab::tests::lecture_test
