// A study in the lab: opened, computed in the background, stopped and continued.
#include "app/features/study_runs.h"

#include <chrono>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/files/file_commands.h"
#include "app/files/reports.h"
#include "app/lab_requests.h"
#include "core/insight/study_table.h"
#include "core/maths/angle.h"
#include "core/scene/file_kind.h"
#include "tests/folder.h"
#include "tests/lab/opened_lab.h"
#include "tests/languages.h"

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
    StudyView view() const { return view_of(lab).features.study; }
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
    // The lab as the next start has it.
    void start_again() {
        const std::string last = lab.study.last;
        lab = opened_lab("2b-aggressor");
        begin_studies(lab.study, folder / "state", last);
    }
    void run_a_part() {
        handle(lab, StudyRequest{StudyEdit::run});
        turn();
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

TEST_F(LabStudy, DrawsItsFigureAsANewFileWithTheLabelsOfTheStudy) {
    put_text(folder / "mine.toml", *read_text(study_file()) + "[axis]\nx = \"Mass (kg)\"\n");
    handle(lab, StudyRequest{StudyEdit::open, (folder / "mine.toml").string()});
    handle(lab, StudyRequest{StudyEdit::run});
    finish();
    for (const char* name : {"braitenlab-mine-001.svg", "braitenlab-mine-002.svg"}) {
        handle(lab, StudyRequest{StudyEdit::figure});
        write_report_files(lab, english(), folder.path, {});
        const auto text = read_text(saved(name));
        ASSERT_TRUE(text) << text.error().text();
        EXPECT_NE(text->find(">Mass (kg)</text>"), std::string::npos);
        EXPECT_NE(text->find(">closest approach (m)</text>"), std::string::npos);
    }
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

TEST_F(LabStudy, ThatIsSavedLeavesAFileOfItsTablesNameThatIsNoTableOfIt) {
    put_text(saved("2b-aggressor-study.csv"), "name,mark\nAnna,9\n");
    build();
    save();
    handle(lab, StudyRequest{StudyEdit::run});
    finish();
    EXPECT_EQ(*read_text(saved("2b-aggressor-study.csv")), "name,mark\nAnna,9\n");
    EXPECT_EQ(view().table, saved("2b-aggressor-study-2.csv").string());
    handle(lab, StudyRequest{StudyEdit::open, saved("2b-aggressor-study.toml").string()});
    EXPECT_EQ(view().rows->size(), view().base->study().runs()) << "the table is found again";
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

TEST_F(LabStudy, ThatShipsGoesOnAtTheNextStart) {
    begin_studies(lab.study, folder / "state", "");
    handle(lab, StudyRequest{StudyEdit::open, "weight-and-mismatch"});
    run_a_part();
    const auto rows = *view().rows;
    ASSERT_FALSE(rows.empty());
    start_again();
    EXPECT_EQ(view().last, "weight-and-mismatch");
    EXPECT_FALSE(view().base) << "its sheet opens it";
    handle(lab, StudyRequest{StudyEdit::open, view().last});
    EXPECT_EQ(lines(*view().base, *view().rows), lines(*view().base, rows)) << "as in the table";
    EXPECT_TRUE(view().table.empty()) << "the user has saved none";
    run_a_part();
    ASSERT_GT(view().rows->size(), rows.size());
    EXPECT_EQ(view().rows->back(), insight::run_of(view().base, view().rows->size() - 1));
}

TEST_F(LabStudy, OfTheOpenSceneGoesOnAtTheNextStartWithoutAFile) {
    begin_studies(lab.study, folder / "state", "");
    handle(lab, EditRequest{MoveSource{0, 5, 2}});
    build(20);
    run_a_part();
    const auto rows = *view().rows;
    ASSERT_FALSE(rows.empty());
    start_again();
    handle(lab, StudyRequest{StudyEdit::open, view().last});
    ASSERT_TRUE(view().base);
    EXPECT_EQ(lines(*view().base, *view().rows), lines(*view().base, rows)) << "as in the table";
    EXPECT_TRUE(view().is_built) << "it can still be saved";
    save();
    EXPECT_EQ(view().last, saved("2b-aggressor-study.toml").string());
    EXPECT_FALSE(std::filesystem::exists(folder / "state" / "built")) << "its copy is not needed any more";
    EXPECT_TRUE(std::filesystem::exists(saved("2b-aggressor-study.csv.part")));
    const auto written = load_study(saved("2b-aggressor-study.toml"));
    ASSERT_TRUE(written);
    EXPECT_EQ(snapshot_of(*(*written)->world(0)).scene->sources[0].x, 5);
}

TEST_F(LabStudy, OfAnotherBuildBeginsAnew) {
    begin_studies(lab.study, folder / "state", "");
    build(20);
    run_a_part();
    ASSERT_FALSE(view().rows->empty());
    handle(lab, EditRequest{MoveSource{0, 5, 2}});
    build(20);
    EXPECT_TRUE(view().rows->empty());
}

TEST_F(LabStudy, ThatIsGoneAtTheNextStartIsForgotten) {
    begin_studies(lab.study, folder / "state", (folder / "gone.toml").string());
    EXPECT_EQ(view().last, "");
}

TEST_F(LabStudy, RunsWhereNothingCanBeKept) {
    put_text(folder / "state", "no folder");
    begin_studies(lab.study, folder / "state", "");
    build();
    handle(lab, StudyRequest{StudyEdit::run});
    finish();
    EXPECT_EQ(view().rows->size(), 8u);
    EXPECT_FALSE(view().error);
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
