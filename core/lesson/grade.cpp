#include "core/lesson/grade.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/brain/brain.h"

namespace braitenlab {

Trial::Trial(const Exercise& exercise, const Submission& submission, std::uint64_t seed) : referee_(exercise) {
    result_.seed = seed;
    auto world = World::create(scene_with(exercise, submission), seed);
    if (!world) return;
    world_ = std::move(*world);
    world_->capture(snapshot_);
    referee_.watch(snapshot_);
    add_to_path();
    ticks_left_ = std::lround(exercise.seconds / tick_seconds);
}

void Trial::add_to_path() {
    if (snapshot_.tick % path_ticks != 0) return;
    for (const VehicleView& vehicle : snapshot_.vehicles)
        if (vehicle.start == 0) result_.path.push_back({vehicle.x, vehicle.y});
}

namespace {

// Of the first vehicle; (0, 0) if it is gone.
maths::vec2 position_of_subject(const Snapshot& now) {
    for (const VehicleView& vehicle : now.vehicles)
        if (vehicle.start == 0) return {vehicle.x, vehicle.y};
    return {};
}

bool subject_fell(const Snapshot& now) {
    return std::any_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& vehicle) {
        return vehicle.start == 0 && std::binary_search(now.fallen.begin(), now.fallen.end(), vehicle.id);
    });
}

}  // namespace

// A path ends at the last position before a fall: after it the vehicle stands at another place.
std::optional<StartResult> Trial::run(int ticks) {
    const auto decided = [&] { return ticks_left_ == 0 || referee_.passed() || referee_.lost(); };
    for (; ticks > 0 && !decided(); --ticks, --ticks_left_) {
        const maths::vec2 before = position_of_subject(snapshot_);
        world_->step();
        world_->capture(snapshot_);
        referee_.watch(snapshot_);
        if (subject_fell(snapshot_))
            result_.path.push_back(before);
        else
            add_to_path();
    }
    if (!decided()) return std::nullopt;
    result_.seconds = static_cast<float>(snapshot_.seconds);
    if (world_) result_.passed = referee_.passed(), result_.verdicts = referee_.verdicts();
    return result_;
}

std::size_t failed_step(const StartResult& start) {
    const auto first = [&](auto fails) {
        return static_cast<std::size_t>(std::find_if(start.verdicts.begin(), start.verdicts.end(), fails) -
                                        start.verdicts.begin());
    };
    const std::size_t lost = first([](const Verdict& verdict) { return verdict.lost; });
    return lost < start.verdicts.size() ? lost : first([](const Verdict& verdict) { return !verdict.done; });
}

StartResult try_start(const Exercise& exercise, const Submission& submission, std::uint64_t seed) {
    Trial trial(exercise, submission, seed);
    return *trial.run(std::numeric_limits<int>::max());
}

std::vector<std::size_t> checks_of_option(const Prediction& prediction, std::size_t option) {
    const bool is_answer = option == static_cast<std::size_t>(prediction.answer);
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < prediction.shows.size(); ++i) {
        const std::string& of = prediction.shows[i].option;
        const bool is_named = option < prediction.options.size() && of == prediction.options[option];
        if (is_named || (of.empty() && is_answer)) indices.push_back(i);
    }
    return indices;
}

StartResult shown_run(const Exercise& exercise, const Submission& submission, std::size_t option) {
    Exercise shown = exercise;
    shown.seconds = exercise.prediction.after;
    shown.steps.clear();
    for (const std::size_t i : checks_of_option(exercise.prediction, option))
        shown.steps.push_back({"", exercise.prediction.shows[i].check});
    return try_start(shown, submission, exercise.seed);
}

StartResult shown_run(const Exercise& exercise, std::size_t option) {
    return shown_run(exercise, as_shipped(exercise), option);
}

std::optional<std::size_t> other_option_shown(const Exercise& exercise) {
    const Prediction& prediction = exercise.prediction;
    for (std::size_t option = 0; option < prediction.options.size(); ++option)
        if (option != static_cast<std::size_t>(prediction.answer) && !checks_of_option(prediction, option).empty() &&
            shown_run(exercise, option).passed)
            return option;
    return std::nullopt;
}

std::vector<bool> passed_starts(const Grade& grade) {
    std::vector<bool> passed;
    for (const StartResult& start : grade.starts) passed.push_back(start.passed);
    return passed;
}

std::vector<float> measured_values(const MedianRule& rule, const std::vector<StartResult>& starts) {
    const auto step = static_cast<std::size_t>(rule.step) - 1;
    std::vector<float> values;
    for (const StartResult& start : starts)
        values.push_back(step < start.verdicts.size() ? start.verdicts[step].measures.front().value : 0);
    return values;
}

float median(std::vector<float> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 != 0) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

Grade grade_of(const Exercise& exercise, std::vector<StartResult> starts) {
    Grade grade{std::move(starts)};
    grade.count = static_cast<int>(
        std::count_if(grade.starts.begin(), grade.starts.end(), [](const StartResult& start) { return start.passed; }));
    grade.good = grade.count >= exercise.needed;
    return grade;
}

Grade grade(const Exercise& exercise, const Submission& submission, std::uint64_t first_seed) {
    std::vector<StartResult> starts;
    for (int i = 0; i < exercise.starts; ++i)
        starts.push_back(try_start(exercise, submission, first_seed + static_cast<std::uint64_t>(i)));
    return grade_of(exercise, std::move(starts));
}

}  // namespace braitenlab
