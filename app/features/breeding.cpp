#include "app/features/breeding.h"

#include <algorithm>
#include <cmath>

#include "app/files/breeding_files.h"
#include "app/files/data.h"
#include "app/lab_edits.h"
#include "app/workspace.h"
#include "core/evolve/champions.h"
#include "core/evolve/scene_breeding.h"
#include "core/io/link.h"
#include "core/scene/scene_file.h"
#include "ui/breeding_view.h"

namespace braitenlab {

namespace {

using evolve::BySide;
using evolve::Duel;
using evolve::Side;
using evolve::Tournament;

constexpr std::size_t ticks_per_piece = 300;  // about half a millisecond
constexpr std::size_t most_kept = 20;         // breedings; a state has about 1 kB a generation

Bred& bred_of(BreedingRuns& runs) { return runs.bred.at(runs.base->fingerprint()); }
const Bred& bred_of(const BreedingRuns& runs) { return runs.bred.at(runs.base->fingerprint()); }

int complete(const BreedingRuns& runs) { return complete_generations(*runs.base, *bred_of(runs).state); }

// The score of one cell of the matrix as a part of a job: a run a step.
class CellOfBreeding {
public:
    CellOfBreeding(BreedingBasePtr base, std::vector<evolve::Trial> trials)
        : base_(std::move(base)), trials_(std::move(trials)) {}
    std::optional<float> operator()() {
        seconds_.push_back(evolve::run_of(*base_, trials_[seconds_.size()]));
        if (seconds_.size() < trials_.size()) return std::nullopt;
        return evolve::score_of_match(*base_, seconds_);
    }

private:
    BreedingBasePtr base_;
    std::vector<evolve::Trial> trials_;
    std::vector<float> seconds_;
};

// One of the runs of watched matches as a part of a job.
struct WatchedRun {
    evolve::Trial trial;
    Duel duel{};
    float number = 0;
};

class RunToWatch {
public:
    RunToWatch(BreedingBasePtr base, evolve::Trial trial)
        : base_(std::move(base)), trial_(std::move(trial)), run_(*base_, trial_) {}
    std::optional<WatchedRun> operator()() {
        if (!run_.advance(ticks_per_piece)) return std::nullopt;
        return WatchedRun{trial_, run_.duel(), number_of(*base_, trial_, run_.duel())};
    }

private:
    BreedingBasePtr base_;
    evolve::Trial trial_;
    evolve::DuelRun run_;
};

// `all`: of trials_at_all_starts().
WatchedDuels nearest_duels(const evolve::BreedingBase& base, std::vector<WatchedRun> all, std::size_t matches) {
    std::vector<float> numbers;
    for (const WatchedRun& each : all) numbers.push_back(each.number);
    WatchedDuels watched{.duels = {}, .start = nearest_start(base, matches, numbers)};
    const std::size_t first = (watched.start.match * evolve::tournament_trials + watched.start.run) * matches;
    watched.seed = all[first].trial.seed;
    for (std::size_t i = 0; i < matches; ++i) watched.duels.push_back(std::move(all[first + i].duel));
    return watched;
}

void stop_breeding(BreedingRuns& runs) {
    runs.runs = runs.fills = false;
    runs.trials = {}, runs.generation = {}, runs.scores = {};
}

// The run of a match that is watched, else its first one.
evolve::Trial shown_trial(const BreedingRuns& runs, BreedingCell cell) {
    evolve::Trial trial = trials_of_match(*runs.base, *bred_of(runs).state, cell.predator, cell.prey).front();
    const DuelsQuestion* watched = runs.duels.answered();
    if (watched && !watched->is_of_panel &&
        std::find(watched->cells.begin(), watched->cells.end(), cell) != watched->cells.end())
        trial.seed = runs.duels.answer()->seed;
    return trial;
}

// Its first generations, as many as have all of their scores: the words about it do not change while a row is computed.
Tournament known_part(const Tournament& matrix) {
    const auto is_known = [&](std::size_t size) {
        for (std::size_t i = 0; i < size; ++i)
            if (std::isnan(matrix.score(Side::predator, i, size - 1)) ||
                std::isnan(matrix.score(Side::predator, size - 1, i)))
                return false;
        return true;
    };
    std::size_t size = 0;
    while (size < matrix.size() && is_known(size + 1)) ++size;
    Tournament known{{matrix.generations.begin(), matrix.generations.begin() + static_cast<std::ptrdiff_t>(size)}, {}};
    for (std::size_t predator = 0; predator < size; ++predator)
        for (std::size_t prey = 0; prey < size; ++prey)
            known.scores.push_back(matrix.score(Side::predator, predator, prey));
    return known;
}

void fill_matrix(BreedingRuns& runs) {
    const Bred& bred = bred_of(runs);
    Tournament& matrix = runs.matrix;
    matrix = {.generations = matrix_generations(complete(runs), runs.base->breeding().generations), .scores = {}};
    for (const int predator : matrix.generations)
        for (const int prey : matrix.generations) {
            const auto found = bred.scores.find({predator, prey});
            matrix.scores.push_back(found == bred.scores.end() ? NAN : found->second);
        }
    const Tournament known = known_part(matrix);
    for (const Side side : evolve::both_sides) at(runs.verdicts, side) = evolve::verdict_of(known, side);
}

bool has_begun(const evolve::BreedingState& state) {
    return !state.panel.generations.front().empty() || !state.main.generations.front().empty();
}

int generations_in(const evolve::BreedingState& state) {
    return static_cast<int>(state.panel.generations.front().size() + state.main.generations.front().size());
}

// Takes over what was bred in a folder, if it is more than what is known. Its matrix is computed anew.
void take_state(BreedingRuns& runs, const std::filesystem::path& folder) {
    if (!holds_breeding(folder)) return;
    auto state = read_breeding_state(*runs.base, folder);
    if (!state) return void(runs.error = state.error());
    Bred& bred = bred_of(runs);
    if (generations_in(*state) <= generations_in(*bred.state)) return;
    bred.state = std::make_shared<const evolve::BreedingState>(std::move(*state));
    runs.fills = true;
}

void take_kept_state(BreedingRuns& runs) {
    if (!runs.kept_in.empty()) take_state(runs, kept_breeding(runs.kept_in, *runs.base));
}

// Writes what is bred for the next start of the lab. If another window breeds the same, the one that writes last is
// kept: its generations are the first ones of the other, or go on from them. The folder may be gone, because another
// window has removed the oldest.
void keep_breeding(BreedingRuns& runs) {
    if (runs.kept_in.empty()) return;
    const std::filesystem::path folder = kept_breeding(runs.kept_in, *runs.base);
    const int generations = runs.base->breeding().generations;
    const bool is_first = runs.kept_for != generations || !holds_breeding(folder);
    runs.not_kept.reset();
    if (is_first) runs.not_kept = write_breeding_files(*runs.base, folder);
    if (!runs.not_kept) runs.not_kept = write_breeding_state(*runs.base, *bred_of(runs).state, folder);
    drop_oldest_breedings(runs.kept_in, most_kept, runs.most_bytes);
    if (runs.not_kept || !is_first) return;
    runs.kept_for = generations;
    runs.last = breeding_in(folder).string();
}

void begin_breeding_of(BreedingRuns& runs, BreedingBasePtr base) {
    // More generations of the same breeding: what is known stays, and a breeding that runs goes on.
    const bool is_same = runs.base && runs.base->fingerprint() == base->fingerprint();
    const bool goes_on = is_same && runs.runs;
    stop_breeding(runs);
    runs.runs = goes_on;
    runs.error.reset();
    if (runs.base && !is_same && !has_begun(*bred_of(runs).state)) runs.bred.erase(runs.base->fingerprint());
    runs.base = std::move(base);
    if (!is_same) runs.duels.forget(), runs.has_choice = false, runs.not_kept.reset(), runs.kept_for = 0;
    if (!runs.bred.contains(runs.base->fingerprint())) {
        runs.bred[runs.base->fingerprint()].state =
            std::make_shared<const evolve::BreedingState>(evolve::begin_breeding(*runs.base));
        take_kept_state(runs);
    }
    fill_matrix(runs);
}

// The choice is read from the text of a file, so that its checks are those of a file.
void choose_breeding(BreedingRuns& runs, const evolve::Breeding& choice) {
    auto read = evolve::parse_breeding(evolve::write_breeding(choice), choice.file);
    auto base = read ? evolve::BreedingBase::create(std::move(*read), write_scene(runs.base->scene()), choice.scene)
                     : read.error();
    base ? begin_breeding_of(runs, std::move(*base)) : void(runs.error = base.error());
}

void open_breeding(BreedingRuns& runs, const std::string& path_or_name) {
    const auto path = find_shipped(path_or_name, Shipped::breeding);
    auto base = path ? load_breeding(*path) : path.error();
    if (!base) {
        stop_breeding(runs);
        runs.error = base.error();
        return;
    }
    begin_breeding_of(runs, std::move(*base));
    if (*path == breeding_in(path->parent_path())) take_state(runs, path->parent_path()), fill_matrix(runs);
    runs.last = ships(*path) ? runs.base->breeding().id : std::filesystem::absolute(*path).string();
}

// It is read from the text of a file, as a choice is.
void breed_scene(BreedingRuns& runs, const Workspace& space, const BreedingRequest& wanted) {
    const auto [breeding, scene] =
        evolve::breeding_of_scene(space.document.session.edited_scene(), *wanted.may, wanted.title);
    auto read = evolve::parse_breeding(evolve::write_breeding(breeding), breeding.file);
    auto base =
        read ? evolve::BreedingBase::create(std::move(*read), write_scene(scene), breeding.scene) : read.error();
    if (base) return begin_breeding_of(runs, std::move(*base));
    stop_breeding(runs);
    runs.error = base.error();
}

bool is_complete(const BreedingRuns& runs, BreedingCell cell) {
    return std::min(cell.predator, cell.prey) >= 0 && std::max(cell.predator, cell.prey) < complete(runs);
}

void ask_for_duels(BreedingRuns& runs, DuelsQuestion question) {
    if (!runs.duels.is_about(question)) runs.duels.forget(), runs.duels.ask(std::move(question));
}

void watch_match(BreedingRuns& runs, BreedingCell cell) {
    DuelsQuestion question{runs.base->fingerprint(), {cell}};
    if (const DuelsQuestion* last = runs.duels.question(); last && runs.has_choice)
        for (const BreedingCell& each : last->cells)
            if (each != cell && question.cells.size() < 2) question.cells.push_back(each);
    runs.has_choice = true;
    ask_for_duels(runs, std::move(question));
}

// While it runs and until the last champions have been watched, those of the panel before the first ones. They change
// only after a match was shown to its end.
void watch_last_champions(BreedingRuns& runs, double now) {
    const bool is_of_panel = complete(runs) == 0;
    const int of_panel = static_cast<int>(bred_of(runs).state->panel.generations.front().size());
    const int last = (is_of_panel ? of_panel : complete(runs)) - 1;
    const DuelsQuestion* before = runs.duels.question();
    const bool begins = !before || before->is_of_panel != is_of_panel;
    if (runs.has_choice || last < 0 || (begins && !runs.runs) || (!begins && runs.duels.is_computing())) return;
    float longest = 0;
    if (const auto* watched = runs.duels.answer())
        for (const Duel& each : watched->duels) longest = std::max(longest, each.seconds());
    if (!begins && now < runs.duels_asked + static_cast<double>(longest) + rest_after_match) return;
    runs.duels_asked = now;
    DuelsQuestion question{runs.base->fingerprint(), {{last, last}}, is_of_panel};
    if (last > 0) question.cells.push_back({0, 0});
    ask_for_duels(runs, std::move(question));
}

OpenRequest scene_of_match(const BreedingRuns& runs, const BreedingRequest& wanted) {
    const evolve::Trial trial = shown_trial(runs, wanted.cell);
    Scene scene = scene_of(*runs.base, trial);
    if (!wanted.title.empty()) scene.title = wanted.title;
    if (!wanted.story.empty()) scene.story = wanted.story;
    return {.path = io::encode_link(scene), .seed = trial.seed};
}

// True if predator and prey of the open scene have got body, sensors and brain of the champions; in an exercise only
// what the student may change has got sensors and brain.
bool take_champions(const BreedingRuns& runs, Workspace& space, BreedingCell cell) {
    if (space.pages) return false;
    const bool is_lesson = space.document.lesson.has_value();
    const auto kinds = evolve::kinds_for_champions(*runs.base, *space.document.session.snapshot().scene, is_lesson);
    if (!kinds) return false;
    const evolve::Trial trial = shown_trial(runs, cell);
    const std::uint64_t gesture = new_gesture(space);
    for (const Side side : evolve::both_sides) {
        const int index = at(*kinds, side);
        if (index < 0) continue;
        const Kind& champion = *at(trial.kinds, side);
        Kind kind = space.document.session.snapshot().scene->kinds[static_cast<std::size_t>(index)];
        kind.body = champion.body;
        if (!is_lesson && !apply(space, EditKind{index, kind}, gesture)) return true;
        if (!apply(space, SetSensors{{no_vehicle, index}, champion.sensors}, gesture)) return true;
        if (!apply(space, SetBrain{{no_vehicle, index}, champion.brain}, gesture)) return true;
    }
    const std::string predator = std::to_string(cell.predator), prey = std::to_string(cell.prey);
    if (at(*kinds, Side::prey) < 0)
        say(space, {NoticeKind::done, "notice.champion_predator", predator});
    else if (at(*kinds, Side::predator) < 0)
        say(space, {NoticeKind::done, "notice.champion_prey", prey});
    else
        say(space, {NoticeKind::done, "notice.champions", predator, prey});
    return true;
}

// Of the generation that has ended now.
void measure_pace(BreedingRuns& runs, double now) {
    constexpr float newest = 0.3f;  // share of the newest generation
    const auto seconds = static_cast<float>(now - std::exchange(runs.generation_began, now));
    const float before = runs.generation_seconds.value_or(seconds);
    runs.generation_seconds = before + newest * (seconds - before);
}

// Nothing until a part of the first generation tells the pace.
std::optional<float> seconds_left(const BreedingRuns& runs, double now) {
    constexpr float telling = 0.1f;  // of a generation
    const evolve::Breeding& breeding = runs.base->breeding();
    const int of_panel = breeding.panel > 0 ? breeding.panel_generations + 1 : 0;
    const int left = of_panel + breeding.generations + 1 - generations_in(*bred_of(runs).state);
    if (!runs.runs || left <= 0) return std::nullopt;
    const float bred = runs.generation.progress().fraction, elapsed = static_cast<float>(now - runs.generation_began);
    if (!runs.generation_seconds && bred < telling) return std::nullopt;
    const float seconds = runs.generation_seconds.value_or(elapsed / bred);
    return seconds * (static_cast<float>(left) - bred);
}

void take_generation(BreedingRuns& runs, Jobs& jobs, double now) {
    if (auto ended = runs.generation.take()) {
        if (!*ended) return runs.error = ended->error(), stop_breeding(runs);
        measure_pace(runs, now);
        bred_of(runs).state = std::move(**ended);
        keep_breeding(runs);
        fill_matrix(runs);
    }
    auto trials = runs.trials.take();
    if (!trials) return;
    if (!*trials) return runs.error = trials->error(), stop_breeding(runs);
    if ((**trials)->empty()) return;
    runs.generation = jobs.submit(
        (**trials)->size(),
        [base = runs.base, all = **trials](std::size_t part) { return evolve::run_of(*base, (*all)[part]); },
        [base = runs.base, state = bred_of(runs).state](const std::vector<float>& seconds) {
            evolve::BreedingState next = *state;
            advance(*base, next, seconds);
            return BreedingStatePtr(std::make_shared<const evolve::BreedingState>(std::move(next)));
        });
}

void take_scores(BreedingRuns& runs) {
    const auto done = runs.scores.take();
    if (!done) return;
    if (!*done) return runs.error = done->error(), stop_breeding(runs);
    for (std::size_t i = 0; i < runs.cells.size(); ++i)
        bred_of(runs).scores[{runs.cells[i].predator, runs.cells[i].prey}] = (**done)[i];
    fill_matrix(runs);
}

// False if the matrix has a score for each of its cells.
bool submit_scores(BreedingRuns& runs, Jobs& jobs) {
    if (runs.scores.active()) return true;
    runs.cells.clear();
    const Tournament& matrix = runs.matrix;
    for (std::size_t predator = 0; predator < matrix.size(); ++predator)
        for (std::size_t prey = 0; prey < matrix.size(); ++prey)
            if (std::isnan(matrix.score(Side::predator, predator, prey)))
                runs.cells.push_back({matrix.generations[predator], matrix.generations[prey]});
    if (runs.cells.empty()) return false;
    runs.scores = jobs.submit(
        runs.cells.size(), [base = runs.base, state = bred_of(runs).state, cells = runs.cells](std::size_t part) {
            return CellOfBreeding(base, trials_of_match(*base, *state, cells[part].predator, cells[part].prey));
        });
    return true;
}

// False if no generation is missing.
bool submit_generation(BreedingRuns& runs, Jobs& jobs) {
    if (runs.trials.active() || runs.generation.active()) return true;
    const int last = runs.base->breeding().generations;
    if (complete(runs) > last) return false;
    runs.trials = jobs.submit([base = runs.base, state = bred_of(runs).state, last]() -> std::optional<TrialsPtr> {
        return std::make_shared<const std::vector<evolve::Trial>>(next_trials(*base, *state, last));
    });
    return true;
}

}  // namespace

std::vector<int> matrix_generations(int complete, int last) {
    int distance = 1;
    while ((complete - 1) / distance + 1 > most_in_matrix) distance *= 2;
    std::vector<int> generations;
    for (int generation = 0; generation < complete; generation += distance) generations.push_back(generation);
    if (last < complete && !generations.empty() && generations.back() != last && last == complete - 1)
        generations.push_back(last);
    return generations;
}

void begin_breedings(BreedingRuns& runs, std::filesystem::path kept_in, const std::string& last) {
    runs.kept_in = std::move(kept_in);
    if (runs.base) return take_kept_state(runs), fill_matrix(runs);  // of the command line
    if (!last.empty() && find_shipped(last, Shipped::breeding)) runs.last = last;
}

void show_breeding(BreedingRuns& runs, const std::filesystem::path& path) {
    open_breeding(runs, path.string());
    ++runs.shown;
}

std::optional<OpenRequest> handle_breeding(BreedingRuns& runs, Workspace& space, const BreedingRequest& wanted) {
    if (wanted.edit == BreedingEdit::open) open_breeding(runs, wanted.path);
    if (wanted.edit == BreedingEdit::scene && wanted.may) breed_scene(runs, space, wanted);
    if (!runs.base) return std::nullopt;
    switch (wanted.edit) {
        case BreedingEdit::open:
        case BreedingEdit::scene:
            return std::nullopt;
        case BreedingEdit::choose:
            if (wanted.choice) choose_breeding(runs, *wanted.choice);
            return std::nullopt;
        case BreedingEdit::run:
            runs.runs = true;
            runs.generation_began = space.wall_seconds;
            runs.generation_seconds.reset();
            return std::nullopt;
        case BreedingEdit::stop:
            stop_breeding(runs);
            return std::nullopt;
        case BreedingEdit::watch:
            if (is_complete(runs, wanted.cell)) watch_match(runs, wanted.cell);
            return std::nullopt;
        case BreedingEdit::take:
            if (!is_complete(runs, wanted.cell) || take_champions(runs, space, wanted.cell)) return std::nullopt;
            return scene_of_match(runs, wanted);
        case BreedingEdit::match:
            if (!is_complete(runs, wanted.cell)) return std::nullopt;
            return scene_of_match(runs, wanted);
    }
    return std::nullopt;
}

void update_breeding(BreedingRuns& runs, Jobs& jobs, double now) {
    if (!runs.base) return;
    take_generation(runs, jobs, now);
    take_scores(runs);
    if (runs.runs) {
        const bool breeds = submit_generation(runs, jobs), compares = submit_scores(runs, jobs);
        runs.runs = breeds || compares;
    } else if (runs.fills) {
        runs.fills = submit_scores(runs, jobs);
    }
    watch_last_champions(runs, now);
    runs.duels.follow([&](const DuelsQuestion& question) -> Result<Job<WatchedDuels>> {
        const evolve::BreedingState& state = *bred_of(runs).state;
        std::vector<std::vector<evolve::Trial>> matches;
        for (const BreedingCell& cell : question.cells)
            matches.push_back(question.is_of_panel ? trials_of_panel_match(*runs.base, state, cell.prey)
                                                   : trials_of_match(*runs.base, state, cell.predator, cell.prey));
        std::vector<evolve::Trial> trials = trials_at_all_starts(matches);
        const std::size_t parts = trials.size();
        return jobs.submit(
            parts,
            [base = runs.base, all = std::move(trials)](std::size_t part) { return RunToWatch(base, all[part]); },
            [base = runs.base, count = matches.size()](std::vector<WatchedRun> all) {
                return nearest_duels(*base, std::move(all), count);
            });
    });
}

bool is_computing(const BreedingRuns& runs) { return runs.runs || runs.fills || runs.duels.is_computing(); }

BreedingView breeding_of(const BreedingRuns& runs, double now) {
    BreedingView view{.error = runs.error ? runs.error : runs.not_kept, .last = runs.last, .shown = runs.shown};
    if (!runs.base) return view;
    view.base = runs.base;
    view.state = bred_of(runs).state.get();
    view.runs = runs.runs;
    view.progress = runs.generation.progress().fraction;
    view.seconds_left = seconds_left(runs, now);
    view.matrix = &runs.matrix;
    view.verdicts = runs.verdicts;
    view.watches_by_itself = !runs.has_choice;
    if (const DuelsQuestion* asked = runs.duels.question())
        view.watched = asked->cells, view.watches_panel = asked->is_of_panel;
    if (const WatchedDuels* watched = runs.duels.answer()) view.duels = &watched->duels, view.start = watched->start;
    return view;
}

}  // namespace braitenlab
