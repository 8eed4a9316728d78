// The runs of a study: one for each combination of its values and each seed. The result of a run does not depend on
// the order or the number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/insight/behaviour.h"
#include "core/insight/study_file.h"
#include "core/result.h"
#include "core/world/world.h"

namespace braitenlab::insight {

// Every independent error of the scene, and of the study's paths and levels in it.
std::vector<Error> errors_in_scene(const Study&, std::string_view scene_text, const std::string& scene_file);

// What all runs share. Constant, so that threads share it.
class StudyBase {
public:
    // Fails when a combination gives no valid scene, or the scene has no such vehicle. The error names the path.
    static Result<std::shared_ptr<const StudyBase>> create(Study, std::string_view scene_text,
                                                           const std::string& scene_file);

    const Study& study() const { return study_; }
    std::uint64_t seed_of(std::size_t run) const {
        return study_.first_seed + run % static_cast<std::size_t>(study_.seeds);
    }
    std::size_t combination_of(std::size_t run) const { return run / static_cast<std::size_t>(study_.seeds); }

    // Equal for studies whose runs are equal: the values, measures and scenes. It tells whether an unfinished table
    // belongs to the study.
    std::uint64_t fingerprint() const { return fingerprint_; }

    // The world at the start of a run. Runs are numbered from 0; the seed varies fastest.
    Result<World> world(std::size_t run) const;
    // The vehicle that is measured; no_vehicle if no measure is about a vehicle.
    VehicleId vehicle(const World& start) const;

private:
    Study study_;
    std::vector<Scene> scenes_;  // by combination
    std::uint64_t fingerprint_ = 0;
};

// The number of a measure at the end of a run, with the outcome of the vehicle if the measure is about one.
double number_of(StudyMeasure, const Snapshot& end, const Outcome&);

// Measures of one run, in the order of Study::measures. INFINITY: never; NAN: the scene has no such object.
using StudyRow = std::vector<double>;

// One run in pieces.
class StudyRun {
public:
    StudyRun(std::shared_ptr<const StudyBase>, std::size_t run);
    ~StudyRun();
    StudyRun(StudyRun&&) noexcept;

    // Computes at most this many ticks. True once the run is complete.
    bool advance(std::size_t ticks);
    const StudyRow& row() const { return row_; }  // valid once complete

private:
    void judge();
    void finish();

    struct Running;
    std::shared_ptr<const StudyBase> base_;
    std::unique_ptr<Running> running_;  // null: complete
    Outcome outcome_;                   // of the vehicle, once its run has ended
    StudyRow row_;
};
// The whole run.
StudyRow run_of(const std::shared_ptr<const StudyBase>&, std::size_t run);

}  // namespace braitenlab::insight
