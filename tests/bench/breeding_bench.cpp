// What a breeding adds to its trials. A generation of the shipped breeding "chase", bred to its tenth one: the bare
// trials, the generation with all that a breeding does but its checkpoint, and the checkpoint.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "app/files/breeding_files.h"
#include "app/platform/memory.h"
#include "core/evolve/breeding.h"

namespace braitenlab::bench {
namespace {

struct Bred {
    std::shared_ptr<const evolve::BreedingBase> base;
    evolve::BreedingState state;
};
constexpr int bred_generations = 10;

std::string text_of(const std::filesystem::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<float> numbers_of(const Bred& bred, const std::vector<evolve::Trial>& trials) {
    std::vector<float> numbers;
    for (const evolve::Trial& trial : trials) numbers.push_back(run_of(*bred.base, trial));
    return numbers;
}

const Bred& tenth_generation() {
    static const Bred bred = [] {
        keep_freed_memory();  // as braitenctl
        const std::filesystem::path folder = BRAITENLAB_SOURCE "/exercises/breeding";
        auto breeding = evolve::parse_breeding(text_of(folder / "chase.toml"), "chase.toml");
        breeding->panel = 0;  // each generation is one list of trials
        const std::string scene = text_of(folder / breeding->scene);
        Bred made{*evolve::BreedingBase::create(std::move(*breeding), scene, "scene.toml"), {}};
        made.state = begin_breeding(*made.base);
        while (complete_generations(*made.base, made.state) < bred_generations)
            advance(*made.base, made.state, numbers_of(made, next_trials(*made.base, made.state, bred_generations)));
        return made;
    }();
    return bred;
}

void BM_BareTrials(benchmark::State& state) {
    const Bred& bred = tenth_generation();
    std::vector<Scene> scenes;
    const auto trials = next_trials(*bred.base, bred.state, bred_generations);
    for (const evolve::Trial& trial : trials) scenes.push_back(scene_of(*bred.base, trial));
    const auto ticks = static_cast<std::uint64_t>(bred.base->breeding().seconds * 60);
    while (state.KeepRunning())
        for (std::size_t i = 0; i < trials.size(); ++i) {
            auto world = World::create(scenes[i], trials[i].seed);
            while (world->tick() < ticks && world->events().captures == 0) world->step();
            benchmark::DoNotOptimize(world->tick());
        }
}
BENCHMARK(BM_BareTrials)->Unit(benchmark::kMillisecond);

void BM_Generation(benchmark::State& state) {
    const Bred& bred = tenth_generation();
    while (state.KeepRunning()) {
        evolve::BreedingState next = bred.state;
        advance(*bred.base, next, numbers_of(bred, next_trials(*bred.base, next, bred_generations)));
        benchmark::DoNotOptimize(next);
    }
}
BENCHMARK(BM_Generation)->Unit(benchmark::kMillisecond);

// With its wait for the disk, in real time.
void BM_Checkpoint(benchmark::State& state) {
    const Bred& bred = tenth_generation();
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "braitenlab-bench-breeding";
    std::filesystem::create_directory(folder);
    while (state.KeepRunning())
        if (write_breeding_state(*bred.base, bred.state, folder)) return state.SkipWithError("cannot be written");
    std::filesystem::remove_all(folder);
}
BENCHMARK(BM_Checkpoint)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace braitenlab::bench
