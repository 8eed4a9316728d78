#include "app/reports/lab_record.h"

#include <cstdlib>
#include <fstream>
#include <regex>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "core/lesson/exercise_file.h"
#include "tests/folder.h"
#include "tests/languages.h"
#include "tests/well_formed.h"

namespace braitenlab::tests::lab_record_test {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Exercise> exercise(const std::string& name) {
    const auto loaded = load_exercise(*find_shipped(name));
    EXPECT_TRUE(loaded) << loaded.error().text();
    return std::make_shared<const Exercise>(*loaded);
}

// The record of a student who has passed.
LabRecord record(const std::string& name) {
    LabRecord made{.exercise = exercise(name), .student = "Ana <López> & \"Co\"", .date = "2026-11-22"};
    made.prediction = 1, made.outcome_known = true, made.runs = 7, made.hints = 2;
    made.submission = with_solution(*made.exercise);
    made.last_run = try_start(*made.exercise, made.submission, made.exercise->seed);
    made.grade = grade(*made.exercise, made.submission);
    made.notes = "It turned away first.\n1 < 2 & \x01 \xFF end";
    return made;
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

bool has_chromium() { return std::system("command -v chromium >/dev/null 2>&1") == 0; }

// Opens the page in Chromium without a window, with these arguments. False if Chromium fails.
bool open_page(const std::string& page, const fs::path& folder, const std::string& arguments) {
    std::ofstream(folder / "page.html") << page;
    const std::string command = "HOME=" + folder.string() +
                                " timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage " +
                                arguments + " file://" + (folder / "page.html").string() + " >/dev/null 2>&1";
    return std::system(command.c_str()) == 0;
}

int printed_pages(const std::string& page, const fs::path& folder) {
    const std::string file = (folder / "page.pdf").string();
    EXPECT_TRUE(open_page(page, folder, "--no-pdf-header-footer --print-to-pdf=" + file));
    std::ifstream in(file, std::ios::binary);
    const std::string pdf{std::istreambuf_iterator<char>(in), {}};
    const std::regex page_object("/Type\\s*/Page[^s]");
    return static_cast<int>(std::distance(std::sregex_iterator(pdf.begin(), pdf.end(), page_object), {}));
}

// The percentage of the picture's pixels whose saturation ("G") or brightness ("B") is above the threshold.
double share_of_pixels(const fs::path& picture, const std::string& channel, const std::string& threshold) {
    const std::string file = picture.string() + ".txt";
    const std::string command = "convert '" + picture.string() + "' -colorspace HSB -channel " + channel +
                                " -separate +channel -threshold " + threshold + " -format '%[fx:100*mean]' info: >'" +
                                file + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    double share = -1;
    std::ifstream(file) >> share;
    return share;
}

}  // namespace

TEST(LabRecord, IsWellFormedForEveryExerciseAndLanguage) {
    for (const fs::path& path : shipped_exercises())
        for (const auto& [language, name] : shipped_languages()) {
            LabRecord made{.exercise = exercise(path.stem().string()), .student = "A & B"};
            made.submission = with_solution(*made.exercise);
            const std::string page = lab_record_html(made, speaking(language), language);
            EXPECT_EQ(xml_fault(page), "") << path << " " << language;
            EXPECT_EQ(page.find("report."), page.npos) << "a text is missing in " << language;
            EXPECT_EQ(page.find("{}"), page.npos) << "a gap is left";
        }
}

TEST(LabRecord, ShowsPredictionOutcomeStepsBrainAndStarts) {
    const std::string page = lab_record_html(record("05-aggressor"), speaking("en"), "en");
    EXPECT_EQ(xml_fault(page), "");
    EXPECT_NE(page.find("Ana &lt;López&gt; &amp; &quot;Co&quot;"), page.npos);
    EXPECT_NE(page.find("You predicted: It turns towards the lamp"), page.npos);
    EXPECT_NE(page.find(">wrong<"), page.npos);
    EXPECT_NE(page.find("Its right eye sees more of the lamp"), page.npos);
    EXPECT_NE(page.find("Passed: 10 of 10 starts."), page.npos);
    EXPECT_NE(page.find("goal\u00a0≤\u00a0"), page.npos) << "measured beside needed";
    EXPECT_EQ(count(page, "<svg"), 12u) << "brain, last run, ten starts";
    EXPECT_NE(page.find(">1.50<"), page.npos) << "a weight";
    EXPECT_NE(page.find("1 &lt; 2 &amp;"), page.npos);
    EXPECT_NE(page.find("Does it love the lamp, or hate it?"), page.npos);
    EXPECT_EQ(page.find("http://www.w3.org/2000/svg") == page.npos, false);
    EXPECT_EQ(page.find("src="), page.npos) << "it loads nothing";
}

TEST(LabRecord, HidesABrainThatTheExerciseHides) {
    LabRecord made = record("05-aggressor");
    made.shows_brain = false;
    EXPECT_EQ(count(lab_record_html(made, speaking("en"), "en"), "<svg"), 11u);
}

TEST(LabRecord, PrintsOnTwoPages) {
    if (!has_chromium()) GTEST_SKIP() << "Chromium is not installed";
    const Folder folder;
    LabRecord made = record("05-aggressor");
    made.notes = std::string(40, 'w');
    for (int i = 0; i < 120; ++i) made.notes += " and a sentence";
    EXPECT_EQ(printed_pages(lab_record_html(made, speaking("de"), "de"), folder.path), 2);
}

TEST(LabRecord, PrintsAShortRecordOnOnePage) {
    if (!has_chromium()) GTEST_SKIP() << "Chromium is not installed";
    const Folder folder;
    LabRecord made = record("05-aggressor");
    made.last_run.reset(), made.grade.reset(), made.shows_brain = false;
    EXPECT_EQ(printed_pages(lab_record_html(made, speaking("en"), "en"), folder.path), 1);
}

TEST(LabRecord, AnExerciseWithoutANumberHasNone) {
    LabRecord made = record("05-aggressor");
    Exercise unnumbered = *made.exercise;
    unnumbered.number = 0;
    made.exercise = std::make_shared<const Exercise>(unnumbered);
    EXPECT_NE(lab_record_html(made, speaking("en"), "en").find("<h1>" + unnumbered.title + "</h1>"), std::string::npos);
    made.shows_title = false;
    EXPECT_NE(lab_record_html(made, speaking("en"), "en").find("<h1>EXERCISE</h1>"), std::string::npos);
}

TEST(LabRecord, ShowsTextPathsAndSignedWiresInABrowser) {
    if (!has_chromium()) GTEST_SKIP() << "Chromium is not installed";
    const Folder folder;
    const fs::path picture = folder.path / "page.png";
    const auto draw = [&](const LabRecord& shown) {
        EXPECT_TRUE(open_page(lab_record_html(shown, speaking("en"), "en"), folder.path,
                              "--hide-scrollbars --window-size=400,1200 --screenshot=" + picture.string()));
    };
    LabRecord made = record("05-aggressor");
    draw(made);
    const double bright = share_of_pixels(picture, "B", "45%"), coloured = share_of_pixels(picture, "G", "45%");
    EXPECT_LT(bright, 99) << "there is text";
    EXPECT_GT(bright, 75) << "on white";
    EXPECT_GT(coloured, 0.1) << "wires and paths";
    made.shows_brain = false, made.last_run->path.clear();
    for (StartResult& start : made.grade->starts) start.path.clear();
    draw(made);
    EXPECT_LT(share_of_pixels(picture, "G", "45%"), coloured - 0.05) << "what is coloured is the brain and the paths";
}

}  // namespace braitenlab::tests::lab_record_test
