// The sheet of a study (ui/panels/study_sheet.cpp).
#include <algorithm>
#include <cmath>
#include <string>

#include "core/insight/study_table.h"
#include "core/scene/file_kind.h"
#include "core/scene/scene_file.h"
#include "desk.h"

namespace braitenlab::tests::study_sheet_test {

using namespace ui;

namespace {

const std::filesystem::path shipped = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises";

// The shipped study of prey; run r has captures r % 40 + 10 times its row.
struct StudyDesk : testing::Test {
    Desk desk;
    std::vector<insight::Study> studies;
    std::vector<insight::StudyRow> rows;

    StudyDesk() {
        for (const char* id : {"prey-eyes", "weight-and-mismatch"}) {
            const auto path = shipped / "studies" / (std::string(id) + ".toml");
            studies.push_back(*insight::parse_study(*read_text(path), path.string()));
        }
        desk.view.study.shipped = &studies;
        desk.panels.sheet = Sheet::study;
    }
    void open(std::size_t count) {
        const auto scene = read_text(shipped / "scenes" / "predator-prey.toml");
        desk.view.study.base = *insight::StudyBase::create(studies.front(), *scene, "scene");
        rows.clear();
        for (std::size_t run = 0; run < count; ++run)
            rows.push_back({static_cast<double>(run % 40 + 10 * (run / 40)), INFINITY});
        desk.view.study.rows = &rows;
        desk.frame(3);
    }
    bool is_written(const std::string& words) const {
        return std::any_of(desk.written.begin(), desk.written.end(),
                           [&](const Written& each) { return each.words.find(words) != std::string::npos; });
    }
};

TEST_F(StudyDesk, TheMenuOpensItAndTheFirstStudyIsOpened) {
    desk.panels.sheet = Sheet::none;
    desk.panels.menu_bar.open = "simulation";
    desk.frame(3);
    desk.click("menu.simulation.studies");
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::study);
    ASSERT_TRUE(desk.last<StudyRequest>());
    EXPECT_EQ(desk.last<StudyRequest>()->path, "prey-eyes");
}

TEST_F(StudyDesk, RunStopAndAnotherStudyAreRequests) {
    open(0);
    desk.click("study.run");
    ASSERT_TRUE(desk.last<StudyRequest>());
    EXPECT_EQ(desk.last<StudyRequest>()->edit, StudyEdit::run);
    desk.view.study.runs = true;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("study.run"));
    desk.click("study.stop");
    EXPECT_EQ(desk.last<StudyRequest>()->edit, StudyEdit::stop);
    desk.click("study.open.weight-and-mismatch");
    EXPECT_EQ(desk.last<StudyRequest>()->edit, StudyEdit::open);
    EXPECT_EQ(desk.last<StudyRequest>()->path, "weight-and-mismatch");
}

TEST_F(StudyDesk, ShowsMediansAndTheComparisonWithTheFirstRow) {
    open(80);
    EXPECT_TRUE(is_written("80 of 240 runs"));
    EXPECT_TRUE(is_written("eyes 80°, speed 3.9 m/s"));
    EXPECT_TRUE(is_written("19.5")) << "median of 0 to 39";
    EXPECT_TRUE(is_written("29.5")) << "median of 10 to 49";
    EXPECT_TRUE(is_written("40 of 40 more"));
    desk.click("study.measure.prey");
    EXPECT_TRUE(is_written("never"));
    EXPECT_FALSE(is_written("19.5"));
}

TEST_F(StudyDesk, SavesTheTableOfTheCompleteRuns) {
    open(2);
    desk.click("study.save");
    ASSERT_TRUE(desk.last<ExportRequest>());
    EXPECT_EQ(desk.last<ExportRequest>()->name, "prey-eyes");
    EXPECT_EQ(desk.last<ExportRequest>()->text, "run,seed,eyes,speed,captures,prey\n1,1,80,3,0,\n2,2,80,3,1,\n");
}

TEST_F(StudyDesk, AFileThatIsOpenedShowsIt) {
    desk.panels.sheet = Sheet::none;
    open(0);
    EXPECT_EQ(desk.panels.sheet, Sheet::none);
    ++desk.view.study.shown;
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::study);
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::none);
}

}  // namespace

}  // namespace braitenlab::tests::study_sheet_test
