// A breeding in the lab: bred in the background, stopped and continued, its matches watched, opened and taken.
#include "app/features/breeding.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <gtest/gtest.h>

#include "app/files/breeding_files.h"
#include "app/files/data.h"
#include "app/files/file_commands.h"
#include "app/lab_requests.h"
#include "core/evolve/breeding_json.h"
#include "core/evolve/scene_breeding.h"
#include "core/scene/file_kind.h"
#include "tests/folder.h"
#include "tests/lab/opened_lab.h"

namespace braitenlab::tests::breeding_test {
namespace {

using evolve::BreedingState;
using evolve::Side;

struct LabBreeding : testing::Test {
    Folder folder;
    Jobs jobs{0};
    Lab lab = opened_lab("2a-coward");
    FilesView files;
    StoredState stored;

    LabBreeding() {
        const std::filesystem::path shipped = std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "breeding";
        std::string text = *read_text(shipped / "chase.toml");
        const std::string scene = "scenes/chase-arena.toml\"";
        text.replace(text.find(scene), scene.size(),
                     (shipped / "scenes" / "chase-arena.toml").generic_string() +
                         "\"\nseconds = 3\npopulation = 6\nparents = 2\ntrials = 2\ngenerations = 3\npanel = 2\n"
                         "panel_generations = 1");
        put_text(folder / "mine.toml", text);
        handle(lab, BreedingRequest{.path = (folder / "mine.toml").string()});
    }
    BreedingView view() const { return view_of(lab).features.breeding; }
    void ask(BreedingEdit edit, BreedingCell cell = {}) { handle(lab, BreedingRequest{.edit = edit, .cell = cell}); }
    void turn() {
        update_breeding(lab.breeding, jobs, lab.wall_seconds), jobs.finish();
        update_breeding(lab.breeding, jobs, lab.wall_seconds);
    }
    void breed_to_the_end() {
        ask(BreedingEdit::run);
        for (int i = 0; i < 100 && view().runs; ++i) turn();
        ASSERT_FALSE(view().runs);
    }
    void open_what_was_asked() { execute_file_requests(lab, files, stored, {.documents = folder.path}); }

    // As the command line breeds.
    BreedingState bred(int generations) const {
        const evolve::BreedingBase& base = *view().base;
        BreedingState state = begin_breeding(base);
        for (auto trials = next_trials(base, state, generations); !trials.empty();
             trials = next_trials(base, state, generations)) {
            std::vector<float> seconds;
            for (const evolve::Trial& trial : trials) seconds.push_back(run_of(base, trial));
            advance(base, state, seconds);
        }
        return state;
    }
    evolve::Trial first_trial(BreedingCell cell) const {
        return trials_of_match(*view().base, *view().state, cell.predator, cell.prey).front();
    }
    // The match in the run that is watched.
    evolve::Trial shown_trial(BreedingCell cell) const {
        const BreedingCell start = view().watched[view().start.match];
        evolve::Trial trial = first_trial(cell);
        trial.seed = trials_of_match(*view().base, *view().state, start.predator, start.prey)[view().start.run].seed;
        return trial;
    }
    float result_of(BreedingCell cell, std::uint64_t seed) const {
        evolve::Trial trial = first_trial(cell);
        trial.seed = seed;
        return score_of(view().base->breeding(), Side::predator, run_of(*view().base, trial));
    }
    // The open run is that of the trial, bit for bit.
    void expect_run_of(const evolve::Trial& trial) {
        auto world = World::create(scene_of(*view().base, trial), trial.seed);
        for (int i = 0; i < 90; ++i) world->step(), lab.document.session.step();
        EXPECT_EQ(lab.document.session.hash(), world->hash());
        EXPECT_EQ(lab.document.session.seed(), trial.seed);
    }
};

TEST_F(LabBreeding, TheTimeLeftFollowsFromThePaceOfTheGenerations) {
    EXPECT_FALSE(view().seconds_left);
    lab.wall_seconds = 1000;
    ask(BreedingEdit::run);
    EXPECT_FALSE(view().seconds_left) << "the pace is not known yet";
    std::vector<float> left;
    for (int i = 0; i < 40 && view().runs; ++i) {
        lab.wall_seconds += 5;
        turn();
        if (view().seconds_left) left.push_back(*view().seconds_left);
    }
    ASSERT_GT(left.size(), 3u);
    EXPECT_GT(left.front(), 15);
    EXPECT_TRUE(std::is_sorted(left.rbegin(), left.rend())) << "at an even pace it only falls";
    EXPECT_LE(left.back(), 15);
    breed_to_the_end();
    EXPECT_FALSE(view().seconds_left);
}

TEST_F(LabBreeding, BreedsAsTheCommandLineDoes) {
    ASSERT_TRUE(view().base) << view().error->text();
    turn();
    EXPECT_EQ(last_generation(view()), -1) << "runs only when asked to";
    breed_to_the_end();
    EXPECT_EQ(last_generation(view()), 3);
    EXPECT_EQ(write_state(*view().base, *view().state), write_state(*view().base, bred(3)));
    const auto again = load_breeding(folder / "mine.toml");
    ASSERT_TRUE(again);
    EXPECT_TRUE(evolve::read_state(**again, write_state(*view().base, *view().state), "state.json"))
        << "the command line can go on with it";
}

TEST_F(LabBreeding, BreedsTheSameInTimeSlices) {
    ask(BreedingEdit::run);
    int turns = 0;
    for (; view().runs && turns < 10'000; ++turns)
        jobs.deliver(std::chrono::nanoseconds(1)), update_breeding(lab.breeding, jobs, 0);
    EXPECT_GT(turns, 100) << "no turn computes a generation";
    EXPECT_EQ(*view().state, bred(view().base->breeding().generations));
    EXPECT_FALSE(view().runs);
}

TEST_F(LabBreeding, TheMatrixGrowsToThatOfTheTournament) {
    ask(BreedingEdit::run);
    std::vector<std::size_t> sizes;
    for (int i = 0; i < 100 && view().runs; ++i) {
        turn();
        if (sizes.empty() || sizes.back() != view().matrix->size()) sizes.push_back(view().matrix->size());
    }
    EXPECT_EQ(sizes, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    const evolve::BreedingBase& base = *view().base;
    std::vector<float> seconds;
    for (const evolve::Trial& trial : trials_of_tournament(base, *view().state, 40))
        seconds.push_back(run_of(base, trial));
    const evolve::Tournament all = tournament_of(base, *view().state, 40, seconds);
    EXPECT_EQ(view().matrix->generations, all.generations);
    EXPECT_EQ(view().matrix->scores, all.scores);
}

TEST_F(LabBreeding, AnotherChoiceKeepsWhatWasBred) {
    breed_to_the_end();
    const BreedingState before = *view().state;
    const auto choose = [&](const auto& change) {
        evolve::Breeding choice = view().base->breeding();
        change(choice);
        handle(lab, BreedingRequest{.edit = BreedingEdit::choose,
                                    .choice = std::make_shared<const evolve::Breeding>(choice)});
    };
    choose([](evolve::Breeding& b) { b.opponents = evolve::Opponents::archive; });
    EXPECT_EQ(last_generation(view()), -1);
    EXPECT_EQ(view().matrix->size(), 0u);
    choose([](evolve::Breeding& b) { b.opponents = evolve::Opponents::best_of_last, b.generations = 4; });
    EXPECT_EQ(*view().state, before);
    EXPECT_EQ(view().matrix->size(), 4u);
    breed_to_the_end();
    EXPECT_EQ(*view().state, bred(4)) << "one more generation";
    choose([](evolve::Breeding& b) { b.population = b.parents, b.parents = b.population + 1; });
    EXPECT_EQ(last_generation(view()), 4) << "fewer individuals than parents";
    ASSERT_TRUE(view().error);
    EXPECT_NE(view().error->text().find("parents"), std::string::npos);
}

TEST_F(LabBreeding, MoreGenerationsDoNotStopIt) {
    ask(BreedingEdit::run);
    turn();
    evolve::Breeding choice = view().base->breeding();
    choice.generations = 2;
    handle(lab,
           BreedingRequest{.edit = BreedingEdit::choose, .choice = std::make_shared<const evolve::Breeding>(choice)});
    EXPECT_TRUE(view().runs);
    for (int i = 0; i < 100 && view().runs; ++i) turn();
    EXPECT_EQ(last_generation(view()), 2);
    EXPECT_EQ(*view().state, bred(2));
}

TEST_F(LabBreeding, TwoMatchesAreWatchedFromTheSameStart) {
    breed_to_the_end();
    ask(BreedingEdit::watch, {0, 3});
    ask(BreedingEdit::watch, {9, 9});
    EXPECT_EQ(view().watched, (std::vector<BreedingCell>{{0, 3}})) << "there is no generation 9";
    ask(BreedingEdit::watch, {3, 1});
    turn();
    EXPECT_EQ(view().watched, (std::vector<BreedingCell>{{3, 1}, {0, 3}}));
    ASSERT_TRUE(view().duels);
    ASSERT_EQ(view().duels->size(), 2u);
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_EQ((*view().duels)[i].seconds(), run_of(*view().base, shown_trial(view().watched[i])));
    const auto& newest = (*view().duels)[0];
    for (const Side side : {Side::predator, Side::prey})
        EXPECT_EQ(at(newest.paths, side)[0], at((*view().duels)[1].paths, side)[0]);
}

// A cell is the mean of its four runs: what is watched must not contradict its colour.
TEST_F(LabBreeding, NoOtherStartIsNearerToTheScoresOfWhatIsWatched) {
    breed_to_the_end();
    const auto score = [&](BreedingCell c) {
        return view().matrix->score(Side::predator, static_cast<std::size_t>(c.predator),
                                    static_cast<std::size_t>(c.prey));
    };
    // Of each result, and of their difference.
    const auto error_from = [&](std::uint64_t seed) {
        std::vector<float> errors;
        for (const BreedingCell& cell : view().watched) errors.push_back(result_of(cell, seed) - score(cell));
        if (errors.size() > 1) errors.push_back(errors[0] - errors[1]);
        float sum = 0;
        for (const float each : errors) sum += std::abs(each);
        return sum;
    };
    int better_than_first = 0;
    for (int predator = 0; predator < 4; ++predator)
        for (int prey = 0; prey < 4; ++prey) {
            ask(BreedingEdit::watch, {predator, prey});
            turn();
            ASSERT_TRUE(view().duels);
            const float shown = error_from(shown_trial(view().watched.front()).seed);
            better_than_first += shown < error_from(first_trial(view().watched.front()).seed) - 1e-4f ? 1 : 0;
            for (const BreedingCell& start : view().watched)
                for (const auto& trial : trials_of_match(*view().base, *view().state, start.predator, start.prey))
                    EXPECT_GE(error_from(trial.seed), shown - 1e-4f) << predator << " " << prey;
        }
    EXPECT_GT(better_than_first, 0) << "the first run of a cell often contradicts its score";
}

TEST_F(LabBreeding, TheMatchThatIsWatchedOpensInItsRun) {
    breed_to_the_end();
    const auto shows_another_than_the_first = [&](BreedingCell cell) {
        ask(BreedingEdit::watch, cell);
        turn();
        return shown_trial(cell).seed != first_trial(cell).seed;
    };
    BreedingCell cell{0, 0};
    while (!shows_another_than_the_first(cell)) {
        if (++cell.prey > 3) cell = {cell.predator + 1, 0};
        ASSERT_LT(cell.predator, 4);
    }
    const evolve::Trial shown = shown_trial(cell);
    ask(BreedingEdit::match, cell);
    open_what_was_asked();
    expect_run_of(shown);
}

TEST_F(LabBreeding, WhileThePanelIsBredItsChampionsDrive) {
    evolve::Breeding choice = view().base->breeding();
    choice.panel_generations = 9;
    handle(lab,
           BreedingRequest{.edit = BreedingEdit::choose, .choice = std::make_shared<const evolve::Breeding>(choice)});
    lab.wall_seconds = 1000;
    ask(BreedingEdit::run);
    for (int i = 0; i < 20 && !view().duels; ++i) turn();
    ASSERT_TRUE(view().duels);
    EXPECT_TRUE(view().watches_panel);
    EXPECT_EQ(view().watched, (std::vector<BreedingCell>{{0, 0}}));
    for (int i = 0; i < 4; ++i) turn();
    lab.wall_seconds += 5;
    turn();
    ASSERT_EQ(last_generation(view()), -1);
    EXPECT_GT(view().watched.front().prey, 0) << "the present ones";
    for (int i = 0; i < 100 && last_generation(view()) < 0; ++i) turn();
    EXPECT_FALSE(view().watches_panel) << "at once, the panel is done";
    EXPECT_EQ(view().watched, (std::vector<BreedingCell>{{0, 0}}));
}

TEST_F(LabBreeding, WhileItRunsTheLastChampionsDriveBesideTheFirstOnes) {
    using Cells = std::vector<BreedingCell>;
    lab.wall_seconds = 1000;
    ask(BreedingEdit::run);
    for (int i = 0; i < 100 && last_generation(view()) < 0; ++i) turn();
    EXPECT_EQ(view().watched, (Cells{{0, 0}}));
    for (int i = 0; i < 100 && last_generation(view()) < 2; ++i) turn();
    EXPECT_EQ(view().watched, (Cells{{0, 0}})) << "a match is shown to its end";
    EXPECT_TRUE(view().duels);
    lab.wall_seconds += 5;
    turn();
    const int last = last_generation(view());
    EXPECT_EQ(view().watched, (Cells{{last, last}, {0, 0}}));
    breed_to_the_end();
    lab.wall_seconds += 5;
    turn();
    EXPECT_EQ(view().watched, (Cells{{3, 3}, {0, 0}})) << "also those of the last generation";
    ask(BreedingEdit::watch, {1, 0});
    lab.wall_seconds += 5;
    turn();
    EXPECT_EQ(view().watched, (Cells{{1, 0}})) << "a choice stays";
}

TEST_F(LabBreeding, AMatchOpensAndDrivesAsItWasBred) {
    breed_to_the_end();
    handle(lab, BreedingRequest{.edit = BreedingEdit::match, .cell = {2, 1}, .title = "A match"});
    open_what_was_asked();
    EXPECT_EQ(title_of(lab.document), "A match");
    expect_run_of(first_trial({2, 1}));
}

TEST_F(LabBreeding, UnsavedWorkIsAskedAboutBeforeAMatchOpens) {
    breed_to_the_end();
    handle(lab, EditRequest{MoveSource{0, 5, 2}});
    ask(BreedingEdit::match, {1, 3});
    open_what_was_asked();
    ASSERT_TRUE(files.leaving);
    EXPECT_EQ(lab.document.name, "2a-coward");
    handle(lab, LeaveRequest{Leave::discard});
    open_what_was_asked();
    EXPECT_NE(lab.document.name, "2a-coward");
    expect_run_of(first_trial({1, 3}));
}

TEST_F(LabBreeding, ChampionsAreTakenIntoASceneWithPredatorAndPrey) {
    breed_to_the_end();
    auto hunt = open_document(*find_shipped("predator-prey"), std::nullopt, {});
    ASSERT_TRUE(hunt);
    replace_document(lab, std::move(*hunt));
    const auto kinds = [&] { return lab.document.session.edited_scene().kinds; };
    const std::vector<Kind> before = kinds();
    ask(BreedingEdit::take, {3, 2});
    EXPECT_TRUE(lab.window.files.empty());
    const evolve::Trial trial = first_trial({3, 2});
    int taken = 0;
    for (const Kind& kind : kinds())
        for (const Side side : {Side::predator, Side::prey}) {
            const Kind& champion = *at(trial.kinds, side);
            if (kind.role != champion.role) continue;
            ++taken;
            EXPECT_EQ(kind.sensors, champion.sensors);
            EXPECT_EQ(kind.body, champion.body);
            EXPECT_EQ(read_dials(kind.brain), read_dials(champion.brain));
        }
    EXPECT_EQ(taken, 2);
    handle(lab, Action::undo);
    EXPECT_EQ(kinds(), before) << "one step of undo";
}

TEST_F(LabBreeding, ARunThatPlaysPausesWhenChampionsAreTaken) {
    breed_to_the_end();
    auto hunt = open_document(*find_shipped("predator-prey"), std::nullopt, {});
    ASSERT_TRUE(hunt);
    replace_document(lab, std::move(*hunt));
    handle(lab, Action::play_pause);
    ASSERT_EQ(lab.playback.mode, Mode::playing);
    handle(lab, BreedingRequest{.edit = BreedingEdit::take, .cell = {3, 2}});
    EXPECT_EQ(lab.playback.mode, Mode::paused);
}

TEST_F(LabBreeding, ASceneWithoutRolesGetsTheMatchInstead) {
    breed_to_the_end();
    ask(BreedingEdit::take, {3, 2});
    ASSERT_EQ(lab.window.files.size(), 1u);
    open_what_was_asked();
    expect_run_of(first_trial({3, 2}));
}

TEST_F(LabBreeding, InAnExerciseOnlyItsVehicleGetsSensorsAndBrain) {
    breed_to_the_end();
    auto exercise = open_document(*find_shipped("18-prey"), std::nullopt, {});
    ASSERT_TRUE(exercise);
    replace_document(lab, std::move(*exercise));
    const std::vector<Kind> before = lab.document.session.edited_scene().kinds;
    ask(BreedingEdit::take, {3, 2});
    EXPECT_TRUE(lab.window.files.empty());
    const evolve::Trial trial = first_trial({3, 2});
    const Kind& champion = *at(trial.kinds, Side::prey);
    for (const Kind& kind : lab.document.session.edited_scene().kinds) {
        const Kind& given =
            *std::find_if(before.begin(), before.end(), [&](const Kind& k) { return k.name == kind.name; });
        if (kind.role != Role::prey) {
            EXPECT_EQ(kind, given);
            continue;
        }
        EXPECT_EQ(kind.sensors, champion.sensors);
        EXPECT_EQ(read_dials(kind.brain), read_dials(champion.brain));
        EXPECT_EQ(kind.body, given.body);
    }
}

TEST_F(LabBreeding, InAnExerciseTheRunBeginsAgainWithTheChampion) {
    breed_to_the_end();
    auto exercise = open_document(*find_shipped("18-prey"), std::nullopt, {});
    ASSERT_TRUE(exercise);
    replace_document(lab, std::move(*exercise));
    set_mode(lab, Mode::playing);
    for (int i = 0; i < 60; ++i) lab.document.session.step();
    ask(BreedingEdit::take, {3, 2});
    EXPECT_EQ(lab.document.session.snapshot().tick, 0u);
    EXPECT_EQ(lab.playback.mode, Mode::paused);
    const std::uint64_t with_champion = lab.document.session.hash();
    handle(lab, Action::undo);
    EXPECT_NE(lab.document.session.hash(), with_champion);
}

TEST_F(LabBreeding, AnotherStartOfTheLabGoesOnWithWhatWasBred) {
    begin_breedings(lab.breeding, folder / "kept", "");
    ask(BreedingEdit::run);
    for (int i = 0; i < 100 && last_generation(view()) < 1; ++i) turn();
    ask(BreedingEdit::stop);
    const BreedingState before = *view().state;
    const std::string last = view().last;

    Lab next = opened_lab("2a-coward");
    begin_breedings(next.breeding, folder / "kept", last);
    const auto now = [&] { return view_of(next).features.breeding; };
    EXPECT_EQ(now().last, last);
    handle(next, BreedingRequest{.path = now().last});
    ASSERT_TRUE(now().base) << now().error->text();
    EXPECT_EQ(*now().state, before);
    for (int i = 0; i < 5; ++i)
        update_breeding(next.breeding, jobs, 0), jobs.finish(), update_breeding(next.breeding, jobs, 0);
    EXPECT_EQ(*now().state, before) << "goes on only when asked to";
    EXPECT_EQ(now().matrix->size(), 2u);
    for (const float score : now().matrix->scores) EXPECT_GE(score, 0) << "the matrix is complete";
    handle(next, BreedingRequest{.edit = BreedingEdit::run});
    for (int i = 0; i < 100 && now().runs; ++i)
        update_breeding(next.breeding, jobs, 0), jobs.finish(), update_breeding(next.breeding, jobs, 0);
    EXPECT_EQ(*now().state, bred(3));
}

TEST_F(LabBreeding, OpensAFolderOfTheCommandLineAndLeavesItAsItIs) {
    const std::filesystem::path written = folder / "results";
    ASSERT_FALSE(write_breeding_files(*view().base, written));
    ASSERT_FALSE(write_breeding_state(*view().base, bred(2), written));
    const std::string text = *read_text(written / "state.json");
    Lab next = opened_lab("2a-coward");
    begin_breedings(next.breeding, folder / "kept", "");
    const auto now = [&] { return view_of(next).features.breeding; };
    handle(next, OpenRequest{.path = written.string(), .dropped = true});
    execute_file_requests(next, files, stored, {.documents = folder.path});
    ASSERT_TRUE(now().base);
    EXPECT_EQ(now().shown, 1) << "its sheet opens";
    EXPECT_EQ(last_generation(now()), 2);
    handle(next, BreedingRequest{.edit = BreedingEdit::run});
    for (int i = 0; i < 100 && now().runs; ++i)
        update_breeding(next.breeding, jobs, 0), jobs.finish(), update_breeding(next.breeding, jobs, 0);
    EXPECT_EQ(*now().state, bred(3));
    EXPECT_EQ(*read_text(written / "state.json"), text);
    handle(next, BreedingRequest{.path = (written / "breeding.toml").string()});
    EXPECT_EQ(last_generation(now()), 3) << "more is kept than the folder has";
    put_text(written / "state.json", "{}");
    handle(next, BreedingRequest{.path = (written / "breeding.toml").string()});
    ASSERT_TRUE(now().error);
    EXPECT_NE(now().error->text().find("state.json"), std::string::npos);
    EXPECT_EQ(last_generation(now()), 3) << "what is known stays";
    std::filesystem::resize_file(written / "state.json", 65U << 20U);
    handle(next, BreedingRequest{.path = (written / "breeding.toml").string()});
    ASSERT_TRUE(now().error);
    EXPECT_NE(now().error->text().find("larger than 64 MiB"), std::string::npos);
}

TEST_F(LabBreeding, GoesOnWhileItCannotBeKept) {
    put_text(folder / "kept", "no folder");
    begin_breedings(lab.breeding, folder / "kept", "");
    ask(BreedingEdit::run);
    for (int i = 0; i < 100 && last_generation(view()) < 1; ++i) turn();
    EXPECT_TRUE(view().error);
    std::filesystem::remove(folder / "kept");
    for (int i = 0; i < 100 && view().runs; ++i) turn();
    EXPECT_EQ(*view().state, bred(3));
    EXPECT_FALSE(view().error) << view().error->text();
    EXPECT_EQ(*read_breeding_state(*view().base, kept_breeding(folder / "kept", *view().base)), bred(3));
}

TEST_F(LabBreeding, ADamagedKeptStateIsReportedAndReplaced) {
    const std::filesystem::path kept = kept_breeding(folder / "kept", *view().base);
    ASSERT_FALSE(write_breeding_files(*view().base, kept));
    put_text(kept / "state.json", "{");
    begin_breedings(lab.breeding, folder / "kept", "");
    ASSERT_TRUE(view().error);
    EXPECT_NE(view().error->text().find("state.json"), std::string::npos);
    breed_to_the_end();
    EXPECT_EQ(*read_breeding_state(*view().base, kept), bred(3));
}

TEST(KeptBreedings, TheOldestAreRemoved) {
    const Folder folder;
    const auto base = load_breeding(*find_shipped("flee", Shipped::breeding));
    for (int i = 0; i < 4; ++i) {
        const std::filesystem::path each = folder / ("b" + std::to_string(i));
        ASSERT_FALSE(write_breeding_files(**base, each));
        ASSERT_FALSE(write_breeding_state(**base, begin_breeding(**base), each));
        std::filesystem::last_write_time(each / "state.json",
                                         std::filesystem::file_time_type::clock::now() - std::chrono::hours(9 - i));
    }
    std::filesystem::create_directories(folder / "other");
    drop_oldest_breedings(folder.path, 2, 1U << 20U);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(holds_breeding(folder / ("b" + std::to_string(i))), i >= 2);
    EXPECT_TRUE(std::filesystem::exists(folder / "other"));
    drop_oldest_breedings(folder.path, 2, std::filesystem::file_size(folder / "b3" / "state.json"));
    EXPECT_FALSE(holds_breeding(folder / "b2")) << "more bytes than asked for";
    EXPECT_TRUE(holds_breeding(folder / "b3"));
    drop_oldest_breedings(folder.path, 2, 1);
    EXPECT_TRUE(holds_breeding(folder / "b3")) << "the last one stays";
}

TEST_F(LabBreeding, AnEmptyBreedingIsNotKept) {
    for (const std::uint64_t seed : {5u, 6u, 7u}) {
        evolve::Breeding choice = view().base->breeding();
        choice.seed = seed;
        handle(lab, BreedingRequest{.edit = BreedingEdit::choose,
                                    .choice = std::make_shared<const evolve::Breeding>(choice)});
    }
    EXPECT_EQ(lab.breeding.bred.size(), 1u);
}

TEST_F(LabBreeding, TheOpenSceneIsBredFromWhatItIs) {
    const std::filesystem::path arena =
        std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "breeding" / "scenes" / "chase-arena.toml";
    auto duel = open_document(arena, std::nullopt, {});
    ASSERT_TRUE(duel);
    replace_document(lab, std::move(*duel));
    const auto breed = [&](evolve::MayChange may) {
        handle(lab, BreedingRequest{.edit = BreedingEdit::scene,
                                    .title = "Mine",
                                    .may = std::make_shared<const evolve::MayChange>(may)});
    };
    breed({});
    ASSERT_FALSE(view().error) << view().error->text();
    EXPECT_EQ(view().base->breeding().title, "Mine");
    for (const Side side : {Side::predator, Side::prey}) {
        const evolve::Individual& first = at(view().state->main.population, side).front();
        EXPECT_EQ(view().base->kind_of(side, first.genome), view().base->kind(side))
            << "the first one is as in the scene";
        EXPECT_NE(at(view().state->main.population, side)[1].genome, first.genome);
    }
    breed({.weights = false, .biases = false, .thresholds = false, .eyes = false});
    EXPECT_TRUE(view().error) << "nothing may change";
    replace_document(lab, std::move(*open_document(*find_shipped("2a-coward"), std::nullopt, {})));
    breed({});
    ASSERT_TRUE(view().error) << "it has no roles";
}

TEST_F(LabBreeding, OfAnUnknownNameSaysWhichThereAre) {
    handle(lab, BreedingRequest{.path = "chaes"});
    ASSERT_TRUE(view().error);
    EXPECT_NE(view().error->text().find("chase"), std::string::npos);
    handle(lab, BreedingRequest{.path = "flee"});
    EXPECT_FALSE(view().error);
    EXPECT_EQ(view().base->breed(Side::predator), nullptr);
}

TEST(MatrixGenerations, AreAtMost21AtDistancesOf1Or2Or4) {
    EXPECT_TRUE(matrix_generations(0, 40).empty());
    EXPECT_EQ(matrix_generations(3, 40), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(matrix_generations(21, 40).size(), 21u);
    EXPECT_EQ(matrix_generations(22, 40).size(), 11u);
    EXPECT_EQ(matrix_generations(41, 40).size(), 21u);
    EXPECT_EQ(matrix_generations(41, 40).back(), 40);
    EXPECT_EQ(matrix_generations(26, 25).back(), 25) << "the last one is always among them";
    for (int complete = 1; complete < 300; ++complete)
        EXPECT_LE(matrix_generations(complete, complete - 1).size(), 22u);
}

}  // namespace
}  // namespace braitenlab::tests::breeding_test
