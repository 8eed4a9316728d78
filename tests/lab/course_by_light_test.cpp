// The course for a student who knows nothing but what pulses: each action is the one that the prompt points at. At a
// slider the student finds the value that brings most, so that the test is about what the light points at. A breeding
// is not run: its champions are those that the exercise has as answers for the same opponents.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "app/course/lab_children.h"
#include "app/course/lab_lesson.h"
#include "app/lab_requests.h"
#include "app/playback.h"
#include "core/lesson/gain.h"
#include "core/lesson/grade.h"
#include "core/lesson/selection.h"
#include "core/lesson/submission.h"
#include "core/scene/file_kind.h"
#include "tests/lab/opened_lab.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompts.h"

namespace braitenlab::tests::course_by_light_test {
namespace {

using namespace std::chrono_literals;
using ui::Prompt;

// What the submission lacks of passing, from some starts.
float lacking(const Exercise& exercise, const Submission& submission) {
    const StartResult first = try_start(exercise, submission, exercise.seed);
    if (!first.passed) return lacking(first);
    const Grade all = grade(exercise, submission);
    return -static_cast<float>(all.count) / static_cast<float>(all.starts.size());
}

// The numbers that the answer of the exercise has for the genes of its prey.
evolve::Genome genome_of(const evolve::Breed& breed, const Answer& answer) {
    evolve::Genome genome;
    for (const evolve::Gene& gene : breed.genes)
        for (const Setting& setting : answer.settings)
            if (setting.path == "kind.prey." + gene.paths.front()) genome.push_back(std::stof(setting.value));
    EXPECT_EQ(genome.size(), breed.genes.size()) << answer.name;
    return genome;
}

const Answer& answer_against(const Exercise& exercise, evolve::Opponents opponents) {
    if (opponents == evolve::Opponents::random) return exercise.solution;
    return *std::find_if(exercise.wrong.begin(), exercise.wrong.end(),
                         [](const Answer& each) { return each.name == "The last champions as opponents"; });
}

// A complete breeding: of every generation the prey with these numbers, and predators of the first generation.
void breed_at_once(BreedingRuns& runs, const Exercise& exercise) {
    const evolve::Breeding& breeding = runs.base->breeding();
    evolve::BreedingState state = begin_breeding(*runs.base);
    for (const evolve::Side side : evolve::both_sides) {
        const bool is_prey = side == evolve::Side::prey;
        const evolve::Genome champion =
            is_prey ? genome_of(*runs.base->breed(side), answer_against(exercise, breeding.opponents))
                    : at(state.main.population, side).front().genome;
        at(state.panel.generations, side)
            .assign(static_cast<std::size_t>(breeding.panel_generations) + 1, {.champion = champion});
        at(state.main.generations, side)
            .assign(static_cast<std::size_t>(breeding.generations) + 1, {.champion = champion, .panel = 0.5f});
    }
    Bred& bred = runs.bred.at(runs.base->fingerprint());
    bred.state = std::make_shared<const evolve::BreedingState>(std::move(state));
    const auto generations = matrix_generations(breeding.generations + 1, breeding.generations);
    for (const int predator : generations)
        for (const int prey : generations) bred.scores[{predator, prey}] = 0.01f * static_cast<float>(prey);
}

struct Student {
    explicit Student(const std::string& exercise) : lab(opened_lab(exercise.c_str())) {
        const auto file = find_shipped("chase-ten", Shipped::breeding);
        shipped.push_back(*evolve::parse_breeding(*read_text(*file), file->string()));
        look();
    }

    const Exercise& exercise() const { return *lab.document.lesson->exercise; }
    bool has_passed() const { return grade_of(*lab.document.lesson) && grade_of(*lab.document.lesson)->good; }

    Prompt look() {
        update_grading(lab, jobs), update_gains(lab, jobs);
        update_children(lab, jobs);
        jobs.deliver(1ms);
        if (!view_of(lab).lesson->gains) jobs.finish(), update_gains(lab, jobs);
        return ui::next_prompt(memory, view());
    }

    LabView view() const {
        LabView view = view_of(lab);
        view.features.breeding.shipped = &shipped;
        return view;
    }

    // The run goes on until something pulses, for as long as a run of the exercise lasts and a second longer.
    Prompt watch() {
        Prompt prompt = look();
        const auto last = static_cast<int>(60 * (exercise().seconds + 1));
        for (int i = 0; i < last && lab.playback.mode == Mode::playing; ++i) {
            lab.wall_seconds += tick_length;
            tick(lab);
            if (i % 6 == 0) prompt = look();
            if (!prompt.anchor.empty() && prompt.anchor != "button.play" && prompt.anchor != useless) return prompt;
        }
        for (int i = 0; i < 100000 && lab.document.lesson->grading; ++i) prompt = look();
        return look();
    }

    // What pulses, or else a hint, or else another run.
    void follow(const Prompt& prompt) {
        const std::string at(prompt.anchor);
        log += at + " (" + std::string(prompt.hint) + ") ";
        const bool is_done = act(at);
        useless = is_done ? std::string() : at;
        if (is_done) return;
        const Attempt::Answers& answers = lab.document.lesson->attempt.answers;
        const bool has_hint = answers.hint_ready && answers.hints_shown < static_cast<int>(exercise().hints.size());
        if (has_hint) return handle(lab, Action::hint);
        if (is_over()) run_again();
    }

    bool is_over() const {
        const bool is_at_end = lab.document.session.snapshot().seconds >= static_cast<double>(exercise().seconds);
        return is_at_end || lab.playback.mode != Mode::playing;
    }
    void run_again() {
        if (lab.document.session.snapshot().tick > 0) handle(lab, Action::reset);
        if (lab.playback.mode != Mode::playing) handle(lab, Action::play_pause);
    }

    // False if there is nothing to do there, or no value of it is better.
    bool act(const std::string& at) {
        const Target target{.kind = subject_kind(exercise().scene)};
        const Submission now = submission_of(exercise(), lab.document.session.snapshot());
        const Submission solution = with_solution(exercise());
        if (at == "exercise.predict") return handle(lab, PredictRequest{exercise().prediction.answer}), true;
        if (at == "button.play") return handle(lab, Action::play_pause), true;
        if (at == "button.reset") return handle(lab, Action::reset), true;
        if (at == "exercise.hint") return handle(lab, Action::hint), true;
        if (at == "exercise.show_me") return handle(lab, ShowMeRequest{}), has_seen_solution = true;
        if (at == "selection.open") return choose_best_child(), true;
        if (at.starts_with("breeding.")) return breed(at), true;
        if (at == "card.sensors" && now.sensors != solution.sensors)
            return handle(lab, EditRequest{SetSensors{target, solution.sensors}}), true;
        const bool is_of_brain = at == "curve.peak" || at == "button.wiring";
        if (is_of_brain && now.brain != solution.brain)
            return handle(lab, EditRequest{SetBrain{target, solution.brain}}), true;
        return turn(at, target, now);
    }

    // Of those that stay longest, the one that stays at most other starts; the parent if it stays longer than each.
    void choose_best_child() {
        for (int runs = 0; runs < 3; ++runs) update_children(lab, jobs), jobs.finish();
        const SelectionView now = view().lesson->selection.value();
        const auto merit = [&](std::size_t i) {
            return std::pair{seconds_survived(now.children[i]), i < now.stays.size() ? now.stays[i] : 0};
        };
        std::size_t best = 0;
        for (std::size_t i = 1; i < now.children.size(); ++i)
            if (merit(i) > merit(best)) best = i;
        const bool keeps_parent = now.parent && seconds_survived(*now.parent) > merit(best).first;
        handle(lab, ChooseChildRequest{keeps_parent ? -1 : static_cast<int>(best)});
    }

    // Opens the breeding if none is open, then does what the anchor on its sheet is for.
    void breed(const std::string& at) {
        if (!lab.breeding.base)
            handle(lab, BreedingRequest{.edit = BreedingEdit::open, .path = std::string(offered_breeding(exercise()))});
        const BreedingView bred = view().features.breeding;
        const auto choose = [&](const evolve::Breeding& choice) {
            handle(lab, BreedingRequest{.edit = BreedingEdit::choose,
                                        .choice = std::make_shared<const evolve::Breeding>(choice)});
        };
        evolve::Breeding choice = bred.base->breeding();
        if (at == "breeding.start") return breed_at_once(lab.breeding, exercise()), choose(choice);
        if (at == "breeding.against.random") return choice.opponents = evolve::Opponents::random, choose(choice);
        if (at == "breeding.take")
            return handle(lab, BreedingRequest{.edit = BreedingEdit::take, .cell = chosen_cell(bred)});
        BreedingCell cell;
        ASSERT_EQ(std::sscanf(at.c_str(), "breeding.cell.%d.%d", &cell.predator, &cell.prey), 2) << at;
        handle(lab, BreedingRequest{.edit = BreedingEdit::watch, .cell = cell});
        update_breeding(lab.breeding, jobs, lab.wall_seconds);
    }

    bool turn(std::string_view anchor, const Target& target, const Submission& now) {
        const LabView view = view_of(lab);
        const VehicleView* subject = selected_vehicle(view);
        const SensorPair pair = subject ? shown_pair(view, *subject) : SensorPair{};
        const auto offers = offered_dials(exercise());
        const auto offer = std::find_if(offers.begin(), offers.end(), [&](const Offer& each) {
            return std::any_of(each.dials.begin(), each.dials.end(),
                               [&](Dial dial) { return ui::anchor_of(dial) == anchor; });
        });
        if (offer == offers.end()) return false;
        const DialRange limits = range(offer->dials.front());
        const auto turn_to = [&](const auto& value_of) {
            for (const Dial dial : offer->dials) handle(lab, EditRequest{TurnDial{target, dial, value_of(dial), pair}});
        };
        const FourNeurons present = read_dials(now.brain, pair);
        const FourNeurons solved = read_dials(with_solution(exercise()).brain, pair);
        float least = lacking(exercise(), now) - 0.02f;
        std::optional<float> best;
        for (float value = limits.low; value <= limits.high + 0.01f && least > -0.99f; value += 0.1f) {
            Submission tried = now;
            for (const Dial dial : offer->dials) braitenlab::turn(tried.brain, dial, value, pair);
            if (const float lacks = lacking(exercise(), tried); lacks < least) least = lacks, best = value;
        }
        if (best) return turn_to([&](Dial) { return *best; }), true;
        turn_to([&](Dial dial) { return at(present, dial) + 0.1f; });  // a try that shows nothing better
        turn_to([&](Dial dial) { return at(solved, dial); });
        const bool is_put_back = std::all_of(offer->dials.begin(), offer->dials.end(),
                                             [&](Dial dial) { return at(solved, dial) == at(present, dial); });
        if (is_put_back && is_over()) run_again();
        return true;
    }

    Lab lab;
    std::vector<evolve::Breeding> shipped;
    Jobs jobs{0};
    ui::PromptMemory memory;
    std::string log, useless;
    bool has_seen_solution = false;
};

class CourseByTheLight : public testing::TestWithParam<std::string> {};

// In 19 five sliders are to be found at once: the light leads to the solution there.
TEST_P(CourseByTheLight, IsPassed) {
    Student student(GetParam());
    const int most = offers_selection(student.exercise()) ? 60 : 30;
    int actions = 0;
    for (; actions < most && !student.has_passed(); ++actions) student.follow(student.watch());
    RecordProperty("actions", actions);
    EXPECT_TRUE(student.has_passed()) << "after " << actions << " actions: " << student.log;
    EXPECT_TRUE(GetParam() == "19-mystery" || !student.has_seen_solution) << student.log;
}

// Each first step of the breeding leads to the next one, and the first champion fails.
TEST(CourseByTheLightOfBreeding, GoesThroughAFailedBreedingToOneThatPasses) {
    Student student("22-breeding");
    std::vector<std::string> steps;
    for (int actions = 0; actions < 30 && !student.has_passed(); ++actions) {
        const Prompt prompt = student.watch();
        if (const std::string at(prompt.anchor); steps.empty() || steps.back() != at) steps.push_back(at);
        student.follow(prompt);
    }
    const std::vector<std::string> expected{
        "exercise.predict",   "button.play",   "breeding.start", "breeding.cell.0.0",
        "breeding.cell.0.30", "breeding.take", "button.play",    "breeding.against.random",
        "breeding.start",     "breeding.take", "button.play",    "exercise.next"};
    EXPECT_EQ(steps, expected) << student.log;
}

std::vector<std::string> exercises() {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(BRAITENLAB_SOURCE) / "exercises" / "guided"))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

INSTANTIATE_TEST_SUITE_P(Exercises, CourseByTheLight, testing::ValuesIn(exercises()), [](const auto& each) {
    std::string name = each.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace braitenlab::tests::course_by_light_test
