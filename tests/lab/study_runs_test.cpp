// A study in the lab: opened, computed in the background, stopped and continued.
#include "app/insight/study_runs.h"

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/lab_requests.h"
#include "core/insight/study_table.h"
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
