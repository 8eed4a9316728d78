// braitenctl mystery: how nearly a brain drives as the hidden brain of a scene.
#include "core/insight/mystery.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/report.h"
#include "app/jobs/jobs.h"
#include "core/io/checked_json.h"

namespace braitenlab {

namespace {

using insight::MysteryBase;
using insight::MysteryScore;
using insight::MysteryStart;

Result<insight::MysteryQuestion> mystery_question(const MysteryOptions& options) {
    const auto scene = read_scene_with(options.file, {}, "mystery", "a scene");
    if (!scene) return scene.error();
    const auto world = World::create(*scene, options.seed);
    if (!world) return world.error();
    const Snapshot start = snapshot_of(*world);
    const auto hidden = std::find_if(start.vehicles.begin(), start.vehicles.end(), [&](const VehicleView& vehicle) {
        return scene->kinds[static_cast<std::size_t>(vehicle.kind)].hidden;
    });
    if (hidden == start.vehicles.end())
        return Error{"the scene has no vehicle with a hidden brain; hide one in the window", options.file};
    auto brain = brain_of_file(options.brain, {});
    if (!brain) return brain.error();
    insight::MysteryQuestion question{.scene = *scene,
                                      .seed = options.seed,
                                      .vehicle = hidden->id,
                                      .hidden = insight::design_of(start, *hidden),
                                      .starts = static_cast<std::size_t>(options.starts)};
    question.rebuilt = {std::move(brain->brain),
                        brain->sensors.empty() ? question.hidden.sensors : std::move(brain->sensors)};
    for (const VehicleView& each : start.vehicles)
        if (kind_of(start, each).name == "rebuilt") question.removed.push_back(each.id);
    return question;
}

MysteryScore computed(const std::shared_ptr<const MysteryBase>& base, int threads) {
    Jobs jobs(threads_for(threads));
    auto job = jobs.submit(base->question().starts, [base](std::size_t start) {
        insight::MysteryRun run(base, start);
        constexpr std::size_t piece = 1024;
        while (!run.advance(piece)) {
        }
        return run.result();
    });
    jobs.finish();
    return insight::score_of(std::move(**job.take()));
}

std::string mystery_json(const MysteryScore& score) {
    nlohmann::ordered_json json{{"score", score.score},
                                {"gap_m", rounded_json(score.gap)},
                                {"random_gap_m", rounded_json(score.random_gap)},
                                {"still_gap_m", rounded_json(score.still_gap)}};
    json["starts"] = nlohmann::ordered_json::array();
    for (const MysteryStart& start : score.starts) {
        const Pose& at = start.hidden.front();
        json["starts"].push_back({{"x", rounded_json(at.x)},
                                  {"y", rounded_json(at.y)},
                                  {"heading", rounded_json(at.heading)},
                                  {"gap_m", rounded_json(start.gap)},
                                  {"random_gap_m", rounded_json(start.random_gap)},
                                  {"still_gap_m", rounded_json(start.still_gap)}});
    }
    return io::json_text(json) + "\n";
}

}  // namespace

int mystery(const MysteryOptions& options) {
    auto question = mystery_question(options);
    if (!question) return complain(question.error());
    const auto base = MysteryBase::create(std::move(*question));
    if (!base) return complain(base.error());
    const MysteryScore score = computed(*base, options.threads);
    if (options.json)
        std::cout << mystery_json(score);
    else
        std::cout << fmt::format(
            "{} of 100: mean distance {:.2f} m from {} starts, of random brains {:.2f} m, standing still {:.2f} m\n",
            score.score, score.gap, score.starts.size(), score.random_gap, score.still_gap);
    return exit_code::done;
}

}  // namespace braitenlab
