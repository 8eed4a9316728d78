// Mystery brain: how nearly a rebuilt brain drives as a hidden one does, in the same body, on starts that the student
// has not seen. The result depends on the question only.
//
//     score = 100 · max(0, 1 − d / r)
//
// d is the mean over the starts of path_gap() between the runs of the hidden and the rebuilt brain. r is the smaller of
// two means: of path_gap() between the runs of the hidden and of random brains, and of that between the runs of the
// hidden brain and of one without wires. A brain that drives as the hidden one has 100; one that is no better than
// chance, or than to stand still, has 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/insight/compare.h"
#include "core/insight/predict.h"
#include "core/result.h"
#include "core/scene/scene.h"
#include "core/world/world.h"

namespace braitenlab::insight {

struct MysteryQuestion {
    Scene scene;
    std::uint64_t seed = 1;
    VehicleId vehicle = no_vehicle;    // of the hidden brain, in a world of the scene; its body drives every run
    std::vector<VehicleId> removed{};  // vehicles that are not there in the runs: those with the rebuilt brain
    Design hidden, rebuilt;
    std::size_t starts = 10, random_brains = 12;
    std::size_t ticks = 900;  // of a run: 15 s
};

// Mean distance in m of the positions at the same tick, in a torus across the seam if that is shorter. A path that has
// ended stays at its last position. 0 if a path is empty.
float path_gap(const Path&, const Path&, const Arena&);

// A brain of wires from each sensor to each motor: weights uniform in −2..2, biases of the motors in 0..1. number: from
// 0.
BrainGraph random_brain(const std::vector<Sensor>&, std::uint64_t seed, std::uint64_t number);

// The runs from one start.
struct MysteryStart {
    Path hidden, rebuilt;
    float gap = 0;         // m, between both
    float random_gap = 0;  // m, between the hidden and the random brains, mean
    float still_gap = 0;   // m, between the hidden brain and one without wires
};

struct MysteryScore {
    int score = 0;  // 0..100, rounded down: 100 is a perfect match only
    float gap = 0, random_gap = 0, still_gap = 0;
    std::vector<MysteryStart> starts;
};

// What is common to all runs. Constant, so that threads share it.
class MysteryBase {
public:
    // Fails when the scene is invalid, has no such vehicle, or refuses one of the two designs.
    static Result<std::shared_ptr<const MysteryBase>> create(MysteryQuestion);

    const MysteryQuestion& question() const { return question_; }
    // A random free pose in the arena. Its heading is within 90° of the direction to the nearest source, where there is
    // one: eyes look forwards. start: from 0.
    const Checkpoint& start(std::size_t start) const { return starts_[start]; }
    Question run(std::size_t start, const Design&) const;

private:
    MysteryQuestion question_;
    std::vector<Checkpoint> starts_;
};

// All runs from one start in pieces, for a time slice or a thread.
class MysteryRun {
public:
    MysteryRun(std::shared_ptr<const MysteryBase>, std::size_t start);

    // Computes at most this many ticks. True once all runs are complete.
    bool advance(std::size_t ticks);
    const MysteryStart& result() const { return result_; }  // valid once complete
    float progress() const;

private:
    void begin_run();
    void end_run(Path);

    std::shared_ptr<const MysteryBase> base_;
    std::size_t start_, number_ = 0;  // of the run: 0 hidden, 1 rebuilt, 2 without wires, then random brains
    std::optional<Prediction> run_;   // nullopt: complete
    MysteryStart result_;
};

MysteryScore score_of(std::vector<MysteryStart>);

}  // namespace braitenlab::insight
