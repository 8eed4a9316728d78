#include "app/files/autosave.h"

#include <gtest/gtest.h>

#include "app/course/lab_lesson.h"
#include "app/course/lesson_view.h"
#include "app/files/data.h"
#include "app/files/file_commands.h"
#include "app/lab_requests.h"
#include "app/playback.h"
#include "core/io/run_file.h"
#include "tests/folder.h"

namespace braitenlab::tests::autosave_test {
namespace {

Lab open(const std::string& name) {
    auto lab = open_lab(*find_shipped(name), std::nullopt, {});
    return std::move(*lab);
}

FourNeurons dials(const Document& document) { return read_dials(*document.session.snapshot().kind_brains[0]); }

void edit(Lab& lab, float value) { handle(lab, EditRequest{TurnDial{{.kind = 0}, Dial::LR, value}}); }

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::exists(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".autosave") files.push_back(entry.path());
    return files;
}

struct AutosaveTest : testing::Test {
    Folder folder;
    std::vector<Error> complaints;
    Lab lab = open("2a-coward");

    // Leaves the file with a free lock, as a crash does.
    void crash_with(float value) {
        Autosave dying(folder.path, complaints);
        edit(lab, value);
        EXPECT_FALSE(dying.keep(lab, 0, Autosave::Occasion::now));
    }

    // The lab from its autosave, with the same run; the file names no wire.
    std::optional<Autosaved> kept_without_wires() {
        Autosave dying(folder.path, complaints);
        EXPECT_FALSE(dying.keep(lab, 0, Autosave::Occasion::now));
        const auto files = files_in(folder.path);
        EXPECT_EQ(files.size(), 1u);
        if (files.size() != 1) return std::nullopt;
        const std::string text = text_of(files[0]);
        EXPECT_EQ(text.find("wires"), std::string::npos);
        auto kept = open_autosave(text, "a");
        EXPECT_TRUE(kept) << kept.error().text();
        if (!kept) return std::nullopt;
        EXPECT_EQ(kept->document.session.hash(), lab.document.session.hash());
        return std::move(*kept);
    }
};

// LR in the autosave; nullopt if there is none.
std::optional<float> kept_in(const fs::path& folder) {
    const auto files = files_in(folder);
    if (files.empty()) return std::nullopt;
    const auto kept = open_autosave(text_of(files[0]), "a");
    if (kept) return dials(kept->document).LR;
    ADD_FAILURE() << kept.error().text();
    return std::nullopt;
}

TEST_F(AutosaveTest, KeepsWhatCanBeUndone) {
    for (const char* name : {"2a-coward", "05-aggressor"}) {
        Folder own;
        lab = open(name);
        Autosave dying(own.path, complaints);
        const float before = dials(lab.document).LR;
        edit(lab, before + 0.5f), edit(lab, before + 0.25f);
        handle(lab, Action::undo);
        ASSERT_FALSE(dying.keep(lab, 0, Autosave::Occasion::now));
        const auto files = files_in(own.path);
        ASSERT_EQ(files.size(), 1u);
        auto kept = open_autosave(text_of(files[0]), "a");
        ASSERT_TRUE(kept) << kept.error().text();
        EXPECT_EQ(dials(kept->document).LR, before + 0.5f);
        EXPECT_TRUE(kept->document.session.redo());
        EXPECT_EQ(dials(kept->document).LR, before + 0.25f);
        EXPECT_TRUE(kept->document.session.undo() && kept->document.session.undo());
        EXPECT_EQ(dials(kept->document).LR, before) << name;
    }
}

TEST_F(AutosaveTest, WritesAnEditAtOnceAndFurtherOnesSoonAfterTheLastWrite) {
    Autosave autosave(folder.path, complaints);
    const auto at = [&](double second) {
        EXPECT_FALSE(autosave.keep(lab, second));
        EXPECT_FALSE(autosave.settle());
        return kept_in(folder.path);
    };
    for (double second = 0; second < 60; second += 1) EXPECT_EQ(at(second), std::nullopt) << "without edits, no file";
    edit(lab, 1);
    EXPECT_EQ(at(60), 1.0f) << "the lab may be killed now";
    edit(lab, 1.5f);
    EXPECT_EQ(at(60.1), 1.0f);
    edit(lab, 1.75f);
    EXPECT_EQ(at(60.4), 1.0f) << "the file is not written all the time";
    EXPECT_EQ(at(60.6), 1.75f) << "edits that go on do not put the write off";
    handle(lab, Action::play_pause);
    at(62);
    tick(lab);
    EXPECT_EQ(at(63), 1.75f);
    edit(lab, 0.5f);
    EXPECT_EQ(at(64), 0.5f) << "also in a run that plays";
    lab.document.saved_edits = lab.document.edits, lab.document.saved_tick = lab.document.session.snapshot().tick;
    EXPECT_EQ(at(66), std::nullopt);
    edit(lab, 0.75f);
    EXPECT_EQ(at(67), 0.75f) << "also after a save";
}

// The runs that are compared are those of stored brains. What a crash leaves is the work before.
TEST_F(AutosaveTest, KeepsThePersonsOwnBrainDuringAComparison) {
    for (const char* name : {"2a-coward", "05-aggressor"}) {
        SCOPED_TRACE(name);
        Folder own;
        lab = open(name);
        if (lab.document.lesson) {
            lab.document.lesson->attempt.answers.prediction = 0;
            lab.document.lesson->attempt.work.has_run = lab.document.lesson->attempt.work.outcome_known = true;
        }
        for (const float stored : {0.25f, 0.5f}) {
            edit(lab, stored);
            handle(lab, Action::slot);
        }
        edit(lab, 0.75f);
        Autosave dying(own.path, complaints);
        handle(lab, Action::compare);
        ASSERT_FLOAT_EQ(dials(lab.document).LR, 0.25f) << "A drives";
        const auto hash = lab.document.session.hash();
        for (const Autosave::Occasion occasion : {Autosave::Occasion::frame, Autosave::Occasion::now}) {
            for (int i = 0; i < 90; ++i) tick(lab);
            EXPECT_FALSE(dying.keep(lab, 30.0 * (1 + static_cast<int>(occasion)), occasion));
            EXPECT_FALSE(dying.keep(lab, 30.0 * (1 + static_cast<int>(occasion)), Autosave::Occasion::now));
            EXPECT_FLOAT_EQ(kept_in(own.path).value_or(-1), 0.75f);
        }
        EXPECT_FLOAT_EQ(dials(lab.document).LR, 0.25f) << "the run on the screen goes on";
        EXPECT_NE(lab.document.session.hash(), hash);
        edit(lab, 0.9f);
        EXPECT_FALSE(dying.keep(lab, 100, Autosave::Occasion::now));
        EXPECT_FLOAT_EQ(kept_in(own.path).value_or(-1), 0.9f) << "an edit of the person during the comparison";
    }
}

TEST_F(AutosaveTest, DistinguishesAProperEndFromACrash) {
    crash_with(1);
    EXPECT_FALSE(Autosave(folder.path, complaints).leftover()->offer.ended);
    Autosave(folder.path, complaints).forget();
    {
        Autosave ending(folder.path, complaints);
        EXPECT_FALSE(ending.keep(lab, 0, Autosave::Occasion::now));
        EXPECT_FALSE(ending.keep(lab, 1, Autosave::Occasion::end));
    }
    const Autosave next(folder.path, complaints);
    ASSERT_TRUE(next.leftover());
    EXPECT_TRUE(next.leftover()->offer.ended);
    EXPECT_EQ(dials(*next.recover()).LR, 1.0f);
}

TEST_F(AutosaveTest, DoesNotShowAHiddenBrain) {
    handle(lab, MysteryRequest{MysteryEdit::hide});
    tick(lab);
    EXPECT_TRUE(kept_without_wires());
}

TEST_F(AutosaveTest, DoesNotShowTheBrainThatAnExerciseHides) {
    lab = open("19-mystery");
    tick(lab);
    const auto kept = kept_without_wires();
    ASSERT_TRUE(kept && kept->document.lesson);
    EXPECT_EQ(*kept->document.session.snapshot().scene, *lab.document.session.snapshot().scene)
        << "the referee compares it with the exercise's";
}

TEST_F(AutosaveTest, WritesWithoutADelayWhenTheModeChanges) {
    Autosave autosave(folder.path, complaints);
    edit(lab, 1);
    autosave.keep(lab, 0);
    EXPECT_TRUE(files_in(folder.path).empty());
    handle(lab, Action::play_pause);
    autosave.keep(lab, 0.1);
    EXPECT_FALSE(autosave.settle());
    EXPECT_EQ(files_in(folder.path).size(), 1u);
}

TEST_F(AutosaveTest, WritesAPlayingRunEveryTwentySeconds) {
    lab = open("predator-prey");
    Autosave autosave(folder.path, complaints);
    handle(lab, Action::play_pause);
    std::uint64_t on_disk = 0;
    for (int second = 0; second <= 65; ++second) {
        for (int i = 0; i < 6; ++i) tick(lab);
        autosave.keep(lab, second);
        EXPECT_FALSE(autosave.settle());
        ASSERT_EQ(files_in(folder.path).size(), 1u) << "from the first write on";
        if (second % 13 != 0) continue;
        const auto kept = open_autosave(text_of(files_in(folder.path)[0]), "a");
        ASSERT_TRUE(kept) << kept.error().text();
        on_disk = kept->document.session.snapshot().tick;
        EXPECT_LE(lab.document.session.snapshot().tick, on_disk + 20 * 6) << "at second " << second;
    }
    EXPECT_GT(on_disk, 200u);
}

TEST_F(AutosaveTest, ContinuesARecoveredRunExactly) {
    lab = open("predator-prey");
    for (int i = 0; i < 500; ++i) tick(lab);
    EXPECT_FALSE(Autosave(folder.path, complaints).keep(lab, 0, Autosave::Occasion::now));
    auto kept = Autosave(folder.path, complaints).recover();
    ASSERT_TRUE(kept) << kept.error().text();
    for (int i = 0; i < 400; ++i) tick(lab), kept->session.step();
    EXPECT_EQ(kept->session.hash(), lab.document.session.hash());
}

TEST_F(AutosaveTest, RemovesTheFileOfARunThatIsResetWithoutEdits) {
    Autosave autosave(folder.path, complaints);
    tick(lab);
    autosave.keep(lab, 0, Autosave::Occasion::now);
    EXPECT_EQ(files_in(folder.path).size(), 1u);
    handle(lab, Action::reset);
    autosave.keep(lab, 1);
    EXPECT_TRUE(files_in(folder.path).empty());
}

TEST_F(AutosaveTest, RemovesTheFileAtAProperEndAndAfterSaving) {
    Autosave autosave(folder.path, complaints);
    edit(lab, 1);
    autosave.keep(lab, 0, Autosave::Occasion::now);
    EXPECT_EQ(files_in(folder.path).size(), 1u);
    lab.document.saved_edits = lab.document.edits;
    autosave.keep(lab, 1);
    EXPECT_TRUE(files_in(folder.path).empty());
    edit(lab, 2);
    autosave.keep(lab, 2, Autosave::Occasion::now);
    autosave.finish();
    EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST_F(AutosaveTest, OffersTheWorkOfACrashedLab) {
    for (int i = 0; i < 500; ++i) tick(lab);
    crash_with(1.25f);
    Autosave next(folder.path, complaints);
    ASSERT_TRUE(next.leftover());
    EXPECT_EQ(next.leftover()->offer.title, "Vehicle 2a: Coward");
    EXPECT_EQ(next.leftover()->offer.when.size(), 19u);
    const auto recovered = next.recover();
    ASSERT_TRUE(recovered) << recovered.error().text();
    EXPECT_EQ(dials(*recovered).LR, 1.25f);
    EXPECT_EQ(recovered->path, lab.document.path);
    EXPECT_EQ(recovered->session.hash(), lab.document.session.hash());
    EXPECT_TRUE(Autosave(folder.path, complaints).leftover()) << "it stays until the user accepts or rejects it";
    next.forget();
    EXPECT_FALSE(Autosave(folder.path, complaints).leftover());
    EXPECT_TRUE(fs::is_empty(folder.path));
}

TEST_F(AutosaveTest, OffersTheWorkOfEachCrashedLabTheNewestFirst) {
    for (const auto& [name, when] : {std::pair("a", "2026-11-30 10:00:00"), std::pair("b", "2026-11-30 12:00:00"),
                                     std::pair("c", "2026-11-30 11:00:00")})
        put_text(folder / (std::string(name) + ".autosave"), write_autosave(draft_of(lab.document), when));
    Autosave next(folder.path, complaints);
    const auto offered = [&] { return next.leftover() ? next.leftover()->file.stem().string() : std::string(); };
    EXPECT_EQ(offered(), "b");
    next.pass_over();
    EXPECT_EQ(offered(), "c");
    next.forget();
    EXPECT_EQ(offered(), "a");
    next.pass_over();
    EXPECT_EQ(offered(), "");
    EXPECT_EQ(files_in(folder.path).size(), 2u) << "what was passed over is offered at the next start";
    Autosave after(folder.path, complaints);
    after.offer_no_more();
    after.forget();
    EXPECT_FALSE(after.leftover());
}

TEST_F(AutosaveTest, AsksForEditsAndNotForARunWithoutThem) {
    const auto leave = [&](const char* name, bool edits) {
        lab = open(name);
        for (int i = 0; i < 100; ++i) tick(lab);
        if (edits) edit(lab, 1.25f);
        Autosave(folder.path, complaints).keep(lab, 0, Autosave::Occasion::now);
    };
    for (const char* name : {"2a-coward", "05-aggressor"}) {
        leave(name, false);
        ASSERT_TRUE(Autosave(folder.path, complaints).leftover()) << name;
        EXPECT_FALSE(Autosave(folder.path, complaints).leftover()->offer.has_work) << name;
        const auto unedited = files_in(folder.path);
        ASSERT_EQ(unedited.size(), 1u);
        fs::rename(unedited[0], folder / "1-2.autosave");  // of another process
        leave(name, true);
        ASSERT_TRUE(Autosave(folder.path, complaints).leftover()) << name;
        EXPECT_TRUE(Autosave(folder.path, complaints).leftover()->offer.has_work) << name;
        EXPECT_NE(Autosave(folder.path, complaints).leftover()->file, folder / "1-2.autosave") << name;
        for (const fs::path& file : files_in(folder.path)) fs::remove(file);
    }
}

TEST_F(AutosaveTest, AsksForAnUneditedPopulationAfterACrashOnly) {
    lab = open("predator-prey");
    for (int i = 0; i < 100; ++i) tick(lab);
    const auto asks_after = [&](Autosave::Occasion last, bool edits) {
        if (edits) handle(lab, EditRequest{SetPopulation{.kind = 0, .count = 5}});
        EXPECT_FALSE(Autosave(folder.path, complaints).keep(lab, 0, last));
        Autosave next(folder.path, complaints);
        EXPECT_TRUE(next.leftover());
        const bool asks = next.leftover() && next.leftover()->offer.has_work;
        next.forget();
        return asks;
    };
    EXPECT_TRUE(asks_after(Autosave::Occasion::now, false)) << "a crash";
    EXPECT_FALSE(asks_after(Autosave::Occasion::end, false)) << "the person has left it";
    EXPECT_TRUE(asks_after(Autosave::Occasion::end, true)) << "with an edit";
}

TEST_F(AutosaveTest, KeepsNothingAfterThePersonDiscardsItAndLeaves) {
    for (const char* name : {"2a-coward", "05-aggressor"}) {
        for (const bool recovered : {false, true}) {
            lab = open(name);
            edit(lab, 1.25f);
            for (int i = 0; i < 100; ++i) tick(lab);
            if (recovered) {
                EXPECT_FALSE(Autosave(folder.path, complaints).keep(lab, 0, Autosave::Occasion::end));
                Autosave next(folder.path, complaints);
                auto document = next.recover();
                ASSERT_TRUE(document) << document.error().text();
                document->edits = 1;
                replace_document(lab, std::move(*document));
                next.forget();
            }
            Autosave autosave(folder.path, complaints);
            EXPECT_FALSE(autosave.keep(lab, 0, Autosave::Occasion::now));
            EXPECT_EQ(files_in(folder.path).size(), 1u) << name;
            FilesView files;
            StoredState state;
            EXPECT_FALSE(may_leave(lab, files)) << name;
            handle(lab, LeaveRequest{Leave::discard});
            execute_file_requests(lab, files, state, {.home = folder.path});
            EXPECT_TRUE(lab.window.exit) << name;
            autosave.finish();
            EXPECT_FALSE(autosave.keep(lab, 1, Autosave::Occasion::end));
            EXPECT_TRUE(files_in(folder.path).empty()) << name << ", recovered: " << recovered;
        }
    }
}

TEST_F(AutosaveTest, KeepsNoFileForEditsThatAreUndone) {
    Autosave autosave(folder.path, complaints);
    const auto at = [&](double second) {
        EXPECT_FALSE(autosave.keep(lab, second));
        EXPECT_FALSE(autosave.settle());
        return files_in(folder.path).size();
    };
    edit(lab, 1);
    EXPECT_EQ(at(0), 1u);
    handle(lab, Action::undo);
    EXPECT_EQ(at(0.2), 1u);
    EXPECT_EQ(at(0.6), 0u) << "removed when the next write is due";
    EXPECT_EQ(at(60), 0u);
    edit(lab, 1.5f);
    EXPECT_EQ(at(61), 1u);
    handle(lab, Action::undo);
    EXPECT_FALSE(autosave.keep(lab, 64, Autosave::Occasion::end));
    EXPECT_FALSE(Autosave(folder.path, complaints).leftover());
}

TEST_F(AutosaveTest, NamesTheFileByItsAbsolutePath) {
    const fs::path shipped = lab.document.path;
    const fs::path relative = fs::relative(shipped);
    if (relative.empty()) GTEST_SKIP() << "the files are on another drive";
    lab = open(relative.string());
    crash_with(1);
    const Autosave next(folder.path, complaints);
    ASSERT_TRUE(next.leftover());
    EXPECT_EQ(next.leftover()->offer.file, shipped.string());
    EXPECT_EQ(next.recover()->path, shipped) << "the next lab may start in another folder";
}

TEST_F(AutosaveTest, RemovesLeftoversOlderThanThirtyDays) {
    const auto age = [](const fs::path& file, int days) {
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(24 * days));
    };
    crash_with(1);
    age(files_in(folder.path)[0], 29);
    EXPECT_TRUE(Autosave(folder.path, complaints).leftover());
    age(files_in(folder.path)[0], 31);
    put_text(folder / "1-2.autosave.broken", "{");
    put_text(folder / "1-3.autosave.broken", "{");
    age(folder / "1-2.autosave.broken", 31);
    EXPECT_FALSE(Autosave(folder.path, complaints).leftover());
    EXPECT_TRUE(files_in(folder.path).empty());
    EXPECT_FALSE(fs::exists(folder / "1-2.autosave.broken"));
    EXPECT_TRUE(fs::exists(folder / "1-3.autosave.broken"));
    Autosave running(folder.path, complaints);
    running.keep(lab, 0, Autosave::Occasion::now);
    age(files_in(folder.path)[0], 31);
    EXPECT_FALSE(Autosave(folder.path, complaints).leftover());
    EXPECT_EQ(files_in(folder.path).size(), 1u) << "of a running lab";
}

TEST_F(AutosaveTest, RemovesLeftoversOfASceneThatIsSaved) {
    lab.document.path = folder / "mine.toml";
    crash_with(1);
    fs::rename(files_in(folder.path)[0], folder / "1-2.autosave");  // of another process
    Autosave next(folder.path, complaints);
    next.forget_work_on(folder / "other.toml");
    EXPECT_TRUE(next.leftover());
    EXPECT_EQ(files_in(folder.path).size(), 1u);
    next.keep(lab, 0, Autosave::Occasion::now);
    next.forget_work_on(folder / "mine.toml");
    EXPECT_FALSE(next.leftover());
    EXPECT_EQ(files_in(folder.path).size(), 1u) << "the file of this lab stays";
}

TEST_F(AutosaveTest, ComparesRecoveredWorkWithTheFileOnTheDisk) {
    const Scene opened = lab.document.session.edited_scene();
    edit(lab, 1);
    lab.document.path = folder / "mine.toml";
    put_text(lab.document.path, write_scene(lab.document.session.edited_scene()));
    handle(lab, Action::undo);
    tick(lab);
    crash_with(FourNeurons{read_dials(opened.kinds[0].brain)}.LR);
    auto recovered = Autosave(folder.path, complaints).recover();
    ASSERT_TRUE(recovered) << recovered.error().text();
    recovered->edits = 1;
    EXPECT_TRUE(has_unsaved_edits(make_lab(std::move(*recovered)))) << "the scene as opened differs from the file";
}

TEST_F(AutosaveTest, KnowsThatACopyWithoutANameOfItsOwnIsSaved) {
    edit(lab, 1);
    handle(lab, SaveRequest{(folder / "mine.toml").string(), FileKind::scene});
    FilesView files;
    StoredState state;
    execute_file_requests(lab, files, state, {.home = folder.path});
    ASSERT_EQ(lab.document.name, "mine");
    tick(lab);
    EXPECT_FALSE(Autosave(folder.path, complaints).keep(lab, 0, Autosave::Occasion::end));
    const Autosave next(folder.path, complaints);
    ASSERT_TRUE(next.leftover());
    EXPECT_FALSE(next.leftover()->offer.has_work);
    auto recovered = next.recover();
    ASSERT_TRUE(recovered) << recovered.error().text();
    recovered->edits = 1;
    EXPECT_FALSE(has_unsaved_edits(make_lab(std::move(*recovered))));
}

TEST_F(AutosaveTest, RecoveredWorkKnowsTheContentOfItsFile) {
    lab.document.path = folder / "mine.toml";
    lab.document.content = 7;
    crash_with(1);
    EXPECT_EQ(Autosave(folder.path, complaints).recover()->content, 7u);
}

TEST_F(AutosaveTest, WritesASavedRun) {
    crash_with(1.25f);
    const auto run = io::read_run(text_of(files_in(folder.path)[0]), "a");
    ASSERT_TRUE(run) << run.error().text();
    EXPECT_EQ(Session::resume(*run).hash(), lab.document.session.hash());
}

TEST_F(AutosaveTest, RunsTheTaskItselfIfNoThreadCanBeStarted) {
    const auto task = []() -> std::optional<Error> { return Error{"done here"}; };
    auto result = start_or_run(task, [](const auto&) -> std::future<std::optional<Error>> {
        throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
    });
    EXPECT_EQ(result.get()->what, "done here");
}

TEST_F(AutosaveTest, DoesNotOfferTheFileOfARunningLab) {
    Autosave running(folder.path, complaints);
    edit(lab, 1);
    running.keep(lab, 0, Autosave::Occasion::now);
    EXPECT_FALSE(Autosave(folder.path, complaints).leftover());
}

TEST_F(AutosaveTest, OffersTheWorkOfALabThatIsStillEndingAtTheStart) {
    edit(lab, 1);
    put_text(folder / "earlier.autosave", write_autosave(draft_of(lab.document), "2026-01-01 10:00:00"));
    std::optional<Autosave> dying(std::in_place, folder.path, complaints);
    edit(lab, 2);
    EXPECT_FALSE(dying->keep(lab, 0, Autosave::Occasion::now));
    Autosave next(folder.path, complaints);
    const auto offered = [&](double second) {
        next.follow_ending_labs(second, complaints);
        return next.leftover() ? dials(*next.recover()).LR : 0.0f;
    };
    EXPECT_EQ(offered(0.5), 1.0f);
    dying.reset();
    EXPECT_EQ(offered(1), 2.0f) << "the newest first, although its lock became free after the start";
    next.pass_over();
    EXPECT_EQ(offered(1.5), 1.0f);
    next.pass_over();
    EXPECT_EQ(offered(2), 0.0f) << "each is offered once";
    EXPECT_TRUE(complaints.empty());
}

TEST_F(AutosaveTest, DoesNotOfferTheWorkOfALabThatRunsOnAfterTheStart) {
    std::optional<Autosave> other(std::in_place, folder.path, complaints);
    edit(lab, 2);
    EXPECT_FALSE(other->keep(lab, 0, Autosave::Occasion::now));
    Autosave next(folder.path, complaints);
    next.follow_ending_labs(Autosave::still_ending + 1, complaints);
    other.reset();
    next.follow_ending_labs(Autosave::still_ending + 2, complaints);
    EXPECT_FALSE(next.leftover()) << "a window that crashes later is no reason to interrupt this one";
}

TEST_F(AutosaveTest, RestoresTheProgressOfAnExercise) {
    lab = open("05-aggressor");
    handle(lab, PredictRequest{2});
    tick(lab);
    handle(lab, Action::hint);
    crash_with(1.75f);
    const auto recovered = Autosave(folder.path, complaints).recover();
    ASSERT_TRUE(recovered) << recovered.error().text();
    ASSERT_TRUE(recovered->lesson);
    EXPECT_EQ(recovered->lesson->attempt.answers.prediction, 2);
    EXPECT_EQ(recovered->lesson->attempt.answers.hints_shown, 1);
    EXPECT_TRUE(recovered->lesson->attempt.work.has_run);
    EXPECT_EQ(dials(*recovered).LR, 1.75f);
    EXPECT_EQ(read_dials(recovered->lesson->exercise->scene.kinds[0].brain).LR, 0)
        << "reset still restores the shipped brain";
}

TEST_F(AutosaveTest, KeepsAPredictionAtOnceAndItsRunsWithoutAnEdit) {
    Request by_option = PredictRequest{0}, by_path = PredictPathRequest{{{0, 0}, {0.5f, 0.25f}}};
    for (const auto& [name, answer] : {std::pair("01-drive", by_option), std::pair("02-circle", by_path)}) {
        Folder own;
        lab = open(name);
        const auto drawn = [](const Document& of) { return of.lesson->attempt.answers.drawn_path; };
        std::optional<Autosave> autosave(std::in_place, own.path, complaints);
        EXPECT_FALSE(autosave->keep(lab, 0));
        EXPECT_TRUE(files_in(own.path).empty()) << name << ": nothing is answered yet";
        handle(lab, answer);
        ASSERT_TRUE(has_predicted(lab.document.lesson->attempt.answers)) << name;
        EXPECT_FALSE(autosave->keep(lab, 0.1));
        EXPECT_FALSE(autosave->settle());
        ASSERT_EQ(files_in(own.path).size(), 1u) << name;
        for (int run = 0; run < 2; ++run) {
            handle(lab, Action::reset);
            for (int i = 0; i < 10; ++i) tick(lab);
        }
        EXPECT_FALSE(autosave->keep(lab, 1.6, Autosave::Occasion::end));
        autosave.reset();
        Autosave next(own.path, complaints);
        ASSERT_TRUE(next.leftover()) << name;
        EXPECT_TRUE(next.leftover()->offer.has_work) << name;
        const auto recovered = next.recover();
        ASSERT_TRUE(recovered && recovered->lesson) << name;
        const Attempt &kept = recovered->lesson->attempt, &given = lab.document.lesson->attempt;
        EXPECT_EQ(kept.answers.prediction, given.answers.prediction) << name;
        EXPECT_EQ(drawn(*recovered), drawn(lab.document)) << name;
        EXPECT_EQ(kept.answers.drawn_seed, given.answers.drawn_seed) << name;
        EXPECT_EQ(kept.work.runs, 2) << name;
    }
}

TEST_F(AutosaveTest, TheRefereeOfARecoveredExerciseContinuesAsIfTheLabHadNotCrashed) {
    lab = open("05-aggressor");
    handle(lab, EditRequest{SetBrain{{.kind = 0}, lab.document.lesson->exercise->solution.submission.brain}});
    while (!lesson_view_of(lab).verdicts[0].done) tick(lab);
    const std::uint64_t done_at = lab.document.session.snapshot().tick;
    while (lab.document.session.keyframe_before(lab.document.session.snapshot().tick) < done_at) tick(lab);
    for (int i = 0; i < 20; ++i) tick(lab);
    const Draft draft = draft_of(lab.document);
    ASSERT_GT(draft.run.checkpoint.keyframe_tick, done_at) << "a replay from the keyframe does not show the step again";
    auto recovered = open_autosave(write_autosave(draft, "now"), "x.autosave");
    ASSERT_TRUE(recovered) << recovered.error().text();
    Lab again = make_lab(std::move(recovered->document));
    const auto compare = [&](const char* when) {
        EXPECT_EQ(again.document.session.hash(), lab.document.session.hash()) << when;
        const auto ours = lesson_view_of(again).verdicts, theirs = lesson_view_of(lab).verdicts;
        ASSERT_EQ(ours.size(), theirs.size()) << when;
        for (std::size_t i = 0; i < ours.size(); ++i) {
            EXPECT_EQ(ours[i].done, theirs[i].done) << when << ", step " << i;
            EXPECT_EQ(ours[i].measures, theirs[i].measures) << when << ", step " << i;
        }
    };
    watch(again);
    compare("at once");
    for (int i = 0; i < 200; ++i) tick(lab), tick(again);
    compare("later");
    handle(lab, SeekRequest{draft.run.checkpoint.keyframe_tick});
    handle(again, SeekRequest{draft.run.checkpoint.keyframe_tick});
    compare("back in time");
}

TEST_F(AutosaveTest, RenamesABrokenFileAndReportsIt) {
    crash_with(1);
    const auto file = files_in(folder.path)[0];
    const std::string whole = text_of(file);
    for (const std::string& broken : {whole.substr(0, whole.size() / 2), std::string("\x00\xff[[", 4), std::string(),
                                      std::string("format = 1\n")}) {
        put_text(file, broken);
        complaints.clear();
        Autosave next(folder.path, complaints);
        EXPECT_FALSE(next.leftover());
        ASSERT_EQ(complaints.size(), 1u);
        EXPECT_EQ(complaints[0].file, file.string());
        EXPECT_EQ(text_of(file.string() + ".broken"), broken);
    }
}

TEST_F(AutosaveTest, SetsAsideWhatIsNoFile) {
    if (!fs::exists("/dev/null")) GTEST_SKIP() << "a system without devices in its folders";
    fs::create_symlink("/dev/null", folder.path / "1-1.autosave");
    const Autosave next(folder.path, complaints);
    EXPECT_FALSE(next.leftover());
    ASSERT_EQ(complaints.size(), 1u);
    EXPECT_NE(complaints[0].text().find(message_of("not_a_file").text), std::string::npos) << complaints[0].text();
    EXPECT_TRUE(fs::is_symlink(folder.path / "1-1.autosave.broken"));
}

TEST_F(AutosaveTest, OffersALargeFileBeforeItReadsTheRun) {
    crash_with(1);
    const auto file = files_in(folder.path)[0];
    const std::string whole = text_of(file);
    put_text(file, whole.substr(0, whole.size() / 2) + std::string(Autosave::most_at_start, ' '));
    Autosave next(folder.path, complaints);
    EXPECT_TRUE(complaints.empty()) << complaints.front().text();
    ASSERT_TRUE(next.leftover());
    EXPECT_EQ(next.leftover()->offer.title, title_of(lab.document));
    EXPECT_FALSE(next.recover()) << "the run is not whole";
    next.set_aside();
    EXPECT_FALSE(next.leftover());
    EXPECT_TRUE(fs::exists(file.string() + ".broken"));
}

TEST_F(AutosaveTest, RefusesAFileThatIsTooDeep) {
    const std::string deep = std::string(1000000, '[') + std::string(1000000, ']');
    const auto opened =
        open_autosave(R"({"autosave": {"when": "", "name": "", "path": "", "ended": false, "exercise": )"
                      R"({"prediction": 0, "hints_shown": 0, "has_run": false, "referee": )" +
                          deep + "}}}",
                      "x.autosave");
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().phrases.front().id, "not_an_autosave");
}

TEST_F(AutosaveTest, ReportsOnceThatItCannotWriteAndTriesAgain) {
    put_text(folder / "taken", "a file where the folder should be");
    Autosave autosave(folder / "taken" / "here", complaints);
    edit(lab, 1);
    const auto error = autosave.keep(lab, 0, Autosave::Occasion::now);
    ASSERT_TRUE(error);
    EXPECT_NE(error->what.find("save it yourself"), std::string::npos) << error->what;
    edit(lab, 2);
    EXPECT_FALSE(autosave.keep(lab, 1, Autosave::Occasion::now));
    fs::remove(folder / "taken");
    for (double second = 2; second < 30; second += 1) EXPECT_FALSE(autosave.keep(lab, second));
    EXPECT_FALSE(autosave.settle());
    EXPECT_EQ(kept_in(folder / "taken" / "here"), 2.0f) << "without another edit";
}

TEST_F(AutosaveTest, ReportsAFolderThatBecomesUnwritable) {
    const fs::path place = folder / "kept";
    Autosave autosave(place, complaints);
    edit(lab, 1);
    EXPECT_FALSE(autosave.keep(lab, 0, Autosave::Occasion::now));
    if (std::error_code kept; fs::remove_all(place, kept), kept)
        GTEST_SKIP() << "this system keeps files that are open";
    put_text(place, "a file where the folder was");
    edit(lab, 2);
    const auto error = autosave.keep(lab, 40, Autosave::Occasion::now);
    ASSERT_TRUE(error);
    EXPECT_NE(error->what.find("save it yourself"), std::string::npos) << error->what;
}

}  // namespace
}  // namespace braitenlab::tests::autosave_test
