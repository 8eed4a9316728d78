// The sheet of a study (ui/panels/study/study_sheet.cpp).
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
        desk.view.features.study.shipped = &studies;
        desk.panels.sheet = Sheet::study;
    }
    void open(std::size_t count) {
        const auto scene = read_text(shipped / "scenes" / "predator-prey.toml");
        desk.view.features.study.base = *insight::StudyBase::create(studies.front(), *scene, "scene");
        rows.clear();
        for (std::size_t run = 0; run < count; ++run)
            rows.push_back({static_cast<double>(run % 40 + 10 * (run / 40)), INFINITY});
        desk.view.features.study.rows = &rows;
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

TEST_F(StudyDesk, OpensTheStudyOfTheLastStart) {
    desk.view.features.study.last = "/home/mine.toml";
    desk.frame(2);
    ASSERT_TRUE(desk.last<StudyRequest>());
    EXPECT_EQ(desk.last<StudyRequest>()->path, "/home/mine.toml");
}

TEST_F(StudyDesk, RunStopAndAnotherStudyAreRequests) {
    open(0);
    desk.click("study.run");
    ASSERT_TRUE(desk.last<StudyRequest>());
    EXPECT_EQ(desk.last<StudyRequest>()->edit, StudyEdit::run);
    desk.view.features.study.runs = true;
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("study.run"));
    desk.click("study.stop");
    EXPECT_EQ(desk.last<StudyRequest>()->edit, StudyEdit::stop);
    desk.click("study.open.weight-and-mismatch");
    EXPECT_EQ(desk.last<StudyRequest>()->edit, StudyEdit::open);
    EXPECT_EQ(desk.last<StudyRequest>()->path, "weight-and-mismatch");
}

TEST_F(StudyDesk, OtherButtonsStayInPlaceWhenTheLastRunEnds) {
    open(239);
    desk.view.features.study.runs = true;
    desk.frame(2);
    const Rect stop = desk.where("study.stop"), close = desk.where("study.close");
    open(240);
    desk.view.features.study.runs = false;
    desk.frame(2);
    EXPECT_EQ(desk.where("study.complete").x, stop.x);
    EXPECT_GT(desk.where("study.save").x, stop.x + 0.5f * stop.w) << "not under a pointer on Stop";
    EXPECT_GT(desk.where("study.close").x, close.x - stop.w);
}

TEST_F(StudyDesk, ShowsMediansAndTheComparisonWithTheFirstRow) {
    open(80);
    EXPECT_TRUE(is_written("80 of 240 runs"));
    EXPECT_TRUE(is_written("eyes 80°, speed 3.9 m/s"));
    EXPECT_TRUE(is_written("19.5")) << "median of 0 to 39";
    EXPECT_TRUE(is_written("29.5")) << "median of 10 to 49";
    EXPECT_TRUE(is_written("40 more, 0 equal, 0 less"));
    desk.click("study.measure.prey");
    EXPECT_TRUE(is_written("never"));
    EXPECT_FALSE(is_written("19.5"));
}

TEST_F(StudyDesk, TheComparisonCountsEqualRunsToo) {
    open(80);
    for (std::size_t run = 40; run < 80; ++run) rows[run] = rows[run - 40];
    for (std::size_t run = 40; run < 44; ++run) rows[run][0] += 1;
    rows[79][0] -= 1;
    for (const Language& language : shipped_languages()) {
        desk.strings = speaking(language.code);
        desk.frame(3);
        EXPECT_TRUE(is_written(fill(desk.strings("study.compared"), {"4", "35", "1"}))) << language.code;
    }
}

TEST_F(StudyDesk, SavesTheTableOfTheCompleteRuns) {
    open(2);
    desk.click("study.save");
    ASSERT_TRUE(desk.last<ExportRequest>());
    EXPECT_EQ(desk.last<ExportRequest>()->name, "prey-eyes");
    EXPECT_EQ(desk.last<ExportRequest>()->text,
              "run,seed,eyes_deg,speed_m_s,captures,prey\n1,1,80,3.0,0,\n2,2,80,3.0,1,\n");
}

TEST_F(StudyDesk, SavesTheFigureOfACompleteStudy) {
    open(2);
    const std::size_t before = desk.all.size();
    desk.click("study.figure");
    EXPECT_EQ(desk.all.size(), before) << "runs are missing";
    open(240);
    desk.click("study.figure");
    ASSERT_TRUE(desk.last<StudyRequest>());
    EXPECT_EQ(desk.last<StudyRequest>()->edit, StudyEdit::figure);
}

TEST_F(StudyDesk, AStudyOfTheSceneIsPutTogetherAndRun) {
    desk.now = snapshot(0);
    open(0);
    desk.click("study.new");
    desk.frame(2);
    EXPECT_FALSE(desk.anchors.find("study.run")) << "the draft takes the place of the study";
    ASSERT_TRUE(desk.anchors.find("study.build"));
    desk.click("study.value.2");
    desk.frame(2);
    desk.click("study.value.2.group.1");
    desk.frame(2);
    desk.click("study.value.2.LL=RR");
    desk.frame(2);
    desk.type_into("study.value.2.levels", "2");
    desk.type_into("study.value.1.from", "20");
    desk.type_into("study.value.1.to", "60");
    desk.type_into("study.seeds", "5");
    desk.click("study.measured.touch");
    desk.frame(2);
    EXPECT_TRUE(is_written("30 runs of 20 s"));
    desk.click("study.build");
    const insight::Study* made = nullptr;
    for (const Request& request : desk.all)
        if (const auto* wanted = std::get_if<StudyRequest>(&request); wanted && wanted->edit == StudyEdit::build)
            made = wanted->study.get();
    ASSERT_TRUE(made);
    EXPECT_EQ(desk.last<StudyRequest>()->edit, StudyEdit::run);
    ASSERT_EQ(made->values.size(), 2u);
    EXPECT_EQ(made->values[0].levels, (std::vector<double>{20, 40, 60}));
    EXPECT_EQ(made->values[0].paths,
              (std::vector<std::string>{"kind.vehicle.sensor.SL.angle", "-kind.vehicle.sensor.SR.angle"}));
    EXPECT_EQ(made->values[1].levels, (std::vector<double>{-2, 2}));
    EXPECT_EQ(made->seeds, 5);
    EXPECT_EQ(made->measure_words, std::vector<std::string>{"closest"});
    EXPECT_TRUE(insight::parse_study("format = 1\nscene = \"s\"\n" + insight::write_study(*made).substr(11), "s.toml"));
    desk.frame(2);
    EXPECT_TRUE(desk.anchors.find("study.run")) << "the study is shown";
}

TEST_F(StudyDesk, MeasuresThatTheSceneCannotHaveAreNotOffered) {
    desk.now = snapshot(0);
    ASSERT_EQ(desk.now.predators + desk.now.prey, 0);
    open(0);
    desk.click("study.new");
    const auto show = [&](Boundary edge) {
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->ecology.drain = 0;
        scene->arena.edge = edge;
        desk.now.scene = scene;
        desk.frame(2);
    };
    show(Boundary::wall);
    EXPECT_TRUE(desk.anchors.find("study.measured.contacts"));
    for (const char* measure : {"captures", "deaths", "births", "falls", "predators", "prey"})
        EXPECT_FALSE(desk.anchors.find(std::string("study.measured.") + measure)) << measure;
    show(Boundary::open);
    EXPECT_TRUE(desk.anchors.find("study.measured.falls"));
    EXPECT_TRUE(desk.anchors.find("study.measured.deaths"));
}

TEST_F(StudyDesk, AStudyWithoutAMeasureCannotBeRun) {
    desk.now = snapshot(0);
    open(0);
    desk.click("study.new");
    desk.frame(2);
    for (const char* measure : {"study.measured.closest", "study.measured.touch"}) desk.click(measure), desk.frame(2);
    const auto asks = [&] {
        const std::size_t before = desk.all.size();
        desk.click("study.build");
        return desk.all.size() > before;
    };
    EXPECT_FALSE(asks());
    desk.click("study.measured.closest");
    desk.frame(2);
    EXPECT_TRUE(asks());
}

TEST_F(StudyDesk, SavesAStudyOfItsOwnOnce) {
    open(2);
    desk.view.features.study.is_built = true;
    desk.frame(2);
    desk.click("study.save");
    ASSERT_TRUE(desk.last<StudyRequest>());
    EXPECT_EQ(desk.last<StudyRequest>()->edit, StudyEdit::save);
    EXPECT_FALSE(desk.last<ExportRequest>());
    desk.view.features.study.is_built = false, desk.view.features.study.has_file = true,
    desk.view.features.study.table = "/home/study.csv";
    desk.frame(2);
    EXPECT_TRUE(is_written("/home/study.csv"));
    const std::size_t before = desk.all.size();
    desk.click("study.save");
    EXPECT_EQ(desk.all.size(), before) << "nothing is written twice";
}

TEST_F(StudyDesk, AFileThatIsOpenedShowsIt) {
    desk.panels.sheet = Sheet::none;
    open(0);
    EXPECT_EQ(desk.panels.sheet, Sheet::none);
    ++desk.view.features.study.shown;
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::study);
    desk.key({key::escape});
    desk.frame(2);
    EXPECT_EQ(desk.panels.sheet, Sheet::none);
}

}  // namespace

}  // namespace braitenlab::tests::study_sheet_test
