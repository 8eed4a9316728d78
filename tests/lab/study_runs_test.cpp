// A study in the lab: opened, computed in the background, stopped and continued.
#include "app/insight/study_runs.h"

#include <chrono>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/files/file_commands.h"
#include "app/lab_requests.h"
#include "core/insight/study_table.h"
#include "core/maths/angle.h"
#include "core/scene/file_kind.h"
#include "tests/folder.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::study_runs_test {
namespace {

struct LabStudy : testing::Test {
    Folder folder;
    Jobs jobs{0};
    Lab lab = opened_lab("2b-aggressor");

    std::string study_file() const {
        put_text(folder / "mine.toml",
                 "format = 1\ntitle = \"T\"\nscene = \"2b-aggressor\"\nseconds = 3\nseeds = 20\n"
                 "measures = [\"closest\"]\n[[value]]\nname = \"m\"\n"
                 "paths = [\"kind.aggressor.body.mass\"]\nlevels = [5, 20]\n");
        return (folder / "mine.toml").string();
    }
    void turn() { update_study(lab.study, jobs), jobs.finish(), update_study(lab.study, jobs); }
    StudyView view() const { return view_of(lab).study; }
    void finish() {
        for (int i = 0; i < 20 && view().runs; ++i) turn();
    }
    // A study of the direction of the sensors.
    void build(int seeds = 4) {
        insight::Study study{.title = "T", .seconds = 3, .seeds = seeds};
        study.values = {
            {"direction", "°", {"kind.aggressor.sensor.SL.angle", "-kind.aggressor.sensor.SR.angle"}, {20, 60}}};
        study.measure_words = {"closest"};
        handle(lab, StudyRequest{StudyEdit::build, {}, std::make_shared<const insight::Study>(study)});
    }
    void save() {
        handle(lab, StudyRequest{StudyEdit::save});
        FilesView files;
        StoredState stored;
        execute_file_requests(lab, files, stored, {.documents = folder.path});
    }
    std::filesystem::path saved(const char* name) const { return folder / "Braitenlab" / name; }
    static std::string lines(const insight::StudyBase& base, const std::vector<insight::StudyRow>& rows) {
        std::string text;
        for (std::size_t run = 0; run < rows.size(); ++run) text += study_line(base, run, rows[run]);
        return text;
    }
};

TEST_F(LabStudy, RunsAllItsRunsInOrder) {
    handle(lab, StudyRequest{StudyEdit::open, study_file()});
    ASSERT_TRUE(view().base);
    turn();
    EXPECT_TRUE(view().rows->empty()) << "runs only when asked to";
    handle(lab, StudyRequest{StudyEdit::run, {}});
    for (int i = 0; i < 20 && view().runs; ++i) turn();
    EXPECT_FALSE(view().runs);
    ASSERT_EQ(view().rows->size(), 40u);
    for (const std::size_t run : {0u, 7u, 8u, 39u})
        EXPECT_EQ((*view().rows)[run], insight::run_of(view().base, run)) << run;
}

TEST_F(LabStudy, KeepsItsRunsWhenItIsStoppedAndGoesOn) {
    handle(lab, StudyRequest{StudyEdit::open, study_file()});
    handle(lab, StudyRequest{StudyEdit::run, {}});
    turn();
    const std::size_t kept = view().rows->size();
    EXPECT_GT(kept, 0u);
    EXPECT_LT(kept, 40u);
    handle(lab, StudyRequest{StudyEdit::stop, {}});
    turn();
    EXPECT_EQ(view().rows->size(), kept);
    handle(lab, StudyRequest{StudyEdit::run, {}});
    for (int i = 0; i < 20 && view().runs; ++i) turn();
    ASSERT_EQ(view().rows->size(), 40u);
    EXPECT_EQ((*view().rows)[kept], insight::run_of(view().base, kept));
}

TEST_F(LabStudy, OfTheOpenSceneHasItsEdits) {
    handle(lab, EditRequest{MoveSource{0, 5, 2}});
    build();
    ASSERT_TRUE(view().base) << view().error->text();
    EXPECT_TRUE(view().is_built);
    const Snapshot start = snapshot_of(*view().base->world(4));
    EXPECT_EQ(start.scene->sources[0].x, 5) << "the scene as edited";
    EXPECT_FLOAT_EQ(start.scene->kinds[0].sensors[0].angle, maths::radians(60)) << "the second level";
    EXPECT_FLOAT_EQ(start.scene->kinds[0].sensors[1].angle, maths::radians(-60));
    EXPECT_EQ(view().base->seed_of(0), lab.document.session.seed());
    handle(lab, StudyRequest{StudyEdit::run});
    finish();
    EXPECT_EQ(view().rows->size(), 8u);
    EXPECT_NE((*view().rows)[0], (*view().rows)[4]);
}

TEST_F(LabStudy, OfTheOpenSceneIsSavedAsTheFilesThatTheCommandLineReads) {
    build();
    handle(lab, StudyRequest{StudyEdit::run});
    finish();
    const auto rows = *view().rows;
    save();
    EXPECT_FALSE(view().is_built);
    const auto study = saved("2b-aggressor-study.toml"), table = saved("2b-aggressor-study.csv");
    EXPECT_EQ(view().table, table.string());
    const auto base = load_study(study);
    ASSERT_TRUE(base) << base.error().text();
    EXPECT_EQ((*base)->fingerprint(), view().base->fingerprint());
    EXPECT_EQ(*read_text(table), insight::study_header((*base)->study()) + lines(**base, rows));
    EXPECT_FALSE(std::filesystem::exists(table.string() + ".part"));
    EXPECT_EQ(insight::run_of(*base, 5), rows[5]);
}

TEST_F(LabStudy, ThatIsSavedGoesOnWhereItsFileEnds) {
    build(20);
    save();
    handle(lab, StudyRequest{StudyEdit::run});
    turn();
    const std::size_t kept = view().rows->size();
    ASSERT_GT(kept, 0u);
    ASSERT_LT(kept, 40u);
    handle(lab, StudyRequest{StudyEdit::stop});
    const auto part = saved("2b-aggressor-study.csv.part");
    const std::string before = *read_text(part);
    handle(lab, StudyRequest{StudyEdit::open, (saved("2b-aggressor-study.toml")).string()});
    EXPECT_EQ(view().rows->size(), kept);
    EXPECT_EQ(*read_text(part), before) << "opening writes nothing";
    handle(lab, StudyRequest{StudyEdit::run});
    finish();
    EXPECT_EQ(view().rows->size(), 40u);
    const std::string all = *read_text(saved("2b-aggressor-study.csv"));
    EXPECT_EQ(all, insight::study_header(view().base->study()) + lines(*view().base, *view().rows));
    EXPECT_TRUE(all.starts_with(before.substr(before.find('\n') + 1))) << "the first runs as they were";
    handle(lab, StudyRequest{StudyEdit::open, (saved("2b-aggressor-study.toml")).string()});
    EXPECT_EQ(view().rows->size(), 40u) << "a complete table is taken over";
}

TEST_F(LabStudy, OfTheSameSceneIsWrittenOnceAndOfAnotherBesideIt) {
    build();
    save();
    build();
    save();
    EXPECT_FALSE(std::filesystem::exists(saved("2b-aggressor-study-2.toml")));
    handle(lab, EditRequest{MoveSource{0, 5, 2}});
    build();
    save();
    EXPECT_TRUE(std::filesystem::exists(saved("2b-aggressor-study-2.toml")));
    EXPECT_TRUE(load_study(saved("2b-aggressor-study-2.toml")));
}

TEST_F(LabStudy, WhoseSceneHasChangedDoesNotTakeOverItsTable) {
    build();
    save();
    handle(lab, StudyRequest{StudyEdit::run});
    finish();
    const auto scene = saved("2b-aggressor-study-scene.toml");
    const auto written = std::filesystem::last_write_time(saved("2b-aggressor-study.csv"));
    std::filesystem::last_write_time(scene, written + std::chrono::seconds(5));
    handle(lab, StudyRequest{StudyEdit::open, (saved("2b-aggressor-study.toml")).string()});
    EXPECT_TRUE(view().rows->empty());
}

TEST_F(LabStudy, ShowsWhyItCannotBeOpened) {
    handle(lab, StudyRequest{StudyEdit::open, "prey-eyse"});
    EXPECT_FALSE(view().base);
    ASSERT_TRUE(view().error);
    EXPECT_NE(view().error->text().find("prey-eyes"), std::string::npos);
}

TEST_F(LabStudy, OfAFileIsShown) {
    const int before = view().shown;
    show_study(lab.study, study_file());
    EXPECT_GT(view().shown, before);
    ASSERT_TRUE(view().base);
    EXPECT_EQ(view().base->study().id, "mine");
}

}  // namespace
}  // namespace braitenlab::tests::study_runs_test
