#include "core/insight/study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/insight/run_judge.h"
#include "core/maths/fnv.h"
#include "core/messages.h"
#include "core/scene/nearest.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_tree.h"

namespace braitenlab::insight {

namespace {

std::vector<Setting> settings_of(const Study& study, std::size_t combination) {
    const std::vector<std::size_t> levels = levels_of(study, combination);
    std::vector<Setting> settings;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const StudyValue& value = study.values[i];
        const double level = value.levels[levels[i]];
        for (std::size_t k = 0; k < value.paths.size(); ++k) {
            const std::string& path = value.paths[k];
            const bool is_negative = path.starts_with('-');
            const bool has_line = !study.file.empty() && k < value.lines.size();
            settings.push_back({path.substr(is_negative ? 1 : 0), fmt::format("{:.10g}", is_negative ? -level : level),
                                has_line ? study.file : value.name, has_line ? value.lines[k] : 0});
        }
    }
    return settings;
}

bool is_about_vehicle(const Study& study) {
    return std::any_of(study.measures.begin(), study.measures.end(),
                       [](StudyMeasure measure) { return row_of(measure).of_vehicle; });
}

// What decides the runs and the table, except the scenes.
std::string text_of(const Study& study) {
    std::string text = fmt::format("{} {} {} {}", study.seconds, study.seeds, study.first_seed, study.vehicle);
    for (const StudyValue& value : study.values)
        text += fmt::format(" {} {}", value.name, fmt::join(value.levels, " "));
    return text + fmt::format(" {}", fmt::join(study.measure_words, " "));
}

// The same number of ticks in seconds without the rounding error of single precision: 20, not 20.0000019.
double whole_ticks(float seconds) { return std::round(static_cast<double>(seconds) * 60) / 60; }

}  // namespace

double number_of(StudyMeasure measure, const Snapshot& end, const Outcome& outcome) {
    switch (measure) {
        case StudyMeasure::captures:
            return static_cast<double>(end.events.captures);
        case StudyMeasure::deaths:
            return static_cast<double>(end.events.deaths);
        case StudyMeasure::births:
            return static_cast<double>(end.events.births);
        case StudyMeasure::contacts:
            return static_cast<double>(end.events.contacts);
        case StudyMeasure::falls:
            return static_cast<double>(end.events.falls);
        case StudyMeasure::predators:
            return end.predators;
        case StudyMeasure::prey:
            return end.prey;
        case StudyMeasure::closest:
            return outcome.closest;
        case StudyMeasure::final_distance:
            return outcome.final_distance;
        case StudyMeasure::time_to_touch:
            return whole_ticks(outcome.time_to_touch);
        case StudyMeasure::survival:
            return whole_ticks(outcome.survival);
    }
    return std::numeric_limits<double>::quiet_NaN();
}

std::vector<Error> errors_in_scene(const Study& study, std::string_view scene_text, const std::string& scene_file) {
    const auto file = parse_toml(scene_text, scene_file);
    if (!file) return {file.error()};
    std::vector<Error> errors = read_scene_fully(*file, "", {}).errors;
    for (const StudyValue& value : study.values) {  // each alone, so that one does not hide the errors of another
        Study alone = study;
        alone.values = {value};
        for (std::size_t level = 0; level < value.levels.size(); ++level)
            for (Error& each : read_scene_fully(*file, "", settings_of(alone, level)).errors)
                errors.push_back(std::move(each));
    }
    return in_order(std::move(errors), study.file);
}

Result<std::shared_ptr<const StudyBase>> StudyBase::create(Study study, std::string_view scene_text,
                                                           const std::string& scene_file) {
    auto base = std::make_shared<StudyBase>();
    base->study_ = std::move(study);
    base->fingerprint_ = maths::fnv(text_of(base->study_));
    auto file = parse_toml(scene_text, scene_file);
    if (!file) return file.error();
    for (std::size_t i = 0; i < base->study_.combinations(); ++i) {
        auto scene = read_scene(*file, "", settings_of(base->study_, i));
        if (!scene) return scene.error();
        base->fingerprint_ = maths::fnv(write_scene(*scene), base->fingerprint_);
        base->scenes_.push_back(std::move(*scene));
    }
    const auto first = base->world(0);
    if (!first) return first.error();
    if (is_about_vehicle(base->study_) && base->vehicle(*first) == no_vehicle) {
        if (base->study_.vehicle.empty()) return error_of(message_of("study_without_vehicle"), scene_file);
        const int line = base->study_.vehicle_line;
        return error_of(message_of("no_vehicle_of_scene", in_quotes(base->study_.vehicle)) +
                            nearest_of(base->study_.vehicle, known_names(base->scenes_.front().starts)),
                        line > 0 ? base->study_.file : scene_file, line);
    }
    return std::shared_ptr<const StudyBase>(std::move(base));
}

Result<World> StudyBase::world(std::size_t run) const {
    return World::create(scenes_[combination_of(run)], seed_of(run));
}

VehicleId StudyBase::vehicle(const World& start) const {
    if (!is_about_vehicle(study_)) return no_vehicle;
    const Snapshot now = snapshot_of(start);
    for (const VehicleView& each : now.vehicles) {
        if (study_.vehicle.empty()) return each.id;
        if (each.start >= 0 && now.scene->starts[static_cast<std::size_t>(each.start)].name == study_.vehicle)
            return each.id;
    }
    return no_vehicle;
}

struct StudyRun::Running {
    World world;
    std::optional<RunJudge> judge;  // nullopt: no measure is about a vehicle, or its run has ended
    std::size_t ticks = 0;          // that remain
};

StudyRun::StudyRun(std::shared_ptr<const StudyBase> base, std::size_t run) : base_(std::move(base)) {
    auto world = base_->world(run);
    row_.assign(base_->study().measures.size(), std::numeric_limits<double>::quiet_NaN());
    if (!world) return;
    const auto ticks = static_cast<std::size_t>(std::lround(base_->study().seconds * 60));
    running_ = std::make_unique<Running>(Running{std::move(*world), std::nullopt, ticks});
    if (const VehicleId vehicle = base_->vehicle(running_->world); vehicle != no_vehicle) {
        running_->judge.emplace(running_->world, vehicle);
        judge();
    }
}

StudyRun::~StudyRun() = default;
StudyRun::StudyRun(StudyRun&&) noexcept = default;

bool StudyRun::advance(std::size_t ticks) {
    for (; running_ && ticks > 0; --ticks) {
        if (running_->ticks == 0) {
            finish();
            break;
        }
        running_->world.step();
        --running_->ticks;
        judge();
    }
    return !running_;
}

void StudyRun::judge() {
    if (!running_->judge || running_->judge->add(running_->world)) return;
    outcome_ = running_->judge->outcome(running_->world);
    running_->judge.reset();
}

void StudyRun::finish() {
    if (running_->judge) outcome_ = running_->judge->outcome(running_->world);
    const Snapshot end = snapshot_of(running_->world);
    const std::vector<StudyMeasure>& measures = base_->study().measures;
    std::transform(measures.begin(), measures.end(), row_.begin(),
                   [&](StudyMeasure measure) { return number_of(measure, end, outcome_); });
    running_.reset();
}

StudyRow run_of(const std::shared_ptr<const StudyBase>& base, std::size_t run) {
    StudyRun whole(base, run);
    while (!whole.advance(100'000)) {
    }
    return whole.row();
}

}  // namespace braitenlab::insight
