// braitenctl robustness: how many robots of a design do what the ideal robot does.
#include "core/insight/robustness.h"

#include <cmath>
#include <iostream>

#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "app/ctl/exercises.h"
#include "app/ctl/report.h"
#include "app/ctl/table_file.h"
#include "app/files/data.h"
#include "app/jobs/robots.h"
#include "app/platform/platform.h"
#include "core/io/checked_json.h"
#include "core/lesson/submission.h"
#include "core/scene/file_kind.h"

namespace braitenlab {

namespace {

using insight::Reality;
using insight::RobotResult;
using insight::RobotsReport;

// What is tried: a scene, or an exercise with a submission in its scene.
struct Tried {
    std::string name;
    Scene scene;
    SharedExercise exercise{};  // null: a scene
};

// An exercise with the brain of --brain, else with its solution.
Result<Tried> tried_exercise(const std::filesystem::path& path, const RobustnessOptions& options) {
    auto exercise = read_exercise(path);
    if (!exercise) return exercise.error();
    if (options.brain.empty())
        return Tried{(*exercise)->id, scene_with(**exercise, with_solution(**exercise)), *exercise};
    auto found = brain_of_file(options.brain, {});
    if (!found) return found.error();
    return Tried{(*exercise)->id, scene_with(**exercise, submission_with(**exercise, std::move(*found))), *exercise};
}

Result<Tried> tried_scene(const RobustnessOptions& options) {
    const auto path = find_shipped(options.file);
    if (!path) return path.error();
    const auto text = read_text(*path);
    if (text && detect_kind(*path, *text) == FileKind::exercise) {
        if (!options.settings.empty())
            return Error{"sets values of a scene, and this is an exercise; leave it out", "--set"};
        return tried_exercise(*path, options);
    }
    if (!options.brain.empty()) return Error{"needs an exercise; in a scene write the brain into the file", "--brain"};
    auto scene = read_scene_with(options.file, options.settings, "robustness", "a scene or an exercise");
    if (!scene) return scene.error();
    return Tried{scene->name, std::move(*scene), nullptr};
}

nlohmann::ordered_json robot_json(const RobotResult& robot) {
    nlohmann::ordered_json json{{"seed", robot.seed}, {"works", robot.works}, {"kind", word(robot.outcome.behaviour)}};
    json["failed_step"] = nullptr;
    if (robot.failed_step >= 0) json["failed_step"] = robot.failed_step + 1;
    json["seconds"] = rounded_json(robot.seconds);
    json["closest_m"] = rounded_json(robot.outcome.closest);
    json["final_m"] = rounded_json(robot.outcome.final_distance);
    return json;
}

std::string json_text(const Tried& tried, const insight::Robots& robots, const RobotsReport& report) {
    const insight::RobotsQuestion& question = robots.question();
    const Reality used = insight::reality_of(robots.scene().kinds[static_cast<std::size_t>(robots.kind())]);
    nlohmann::ordered_json json{{tried.exercise ? "exercise" : "scene", tried.name},
                                {"reality", rounded_json(question.reality)},
                                {"robots", question.robots},
                                {"working", report.working},
                                {"share", rounded_json(report.share())},
                                {"weakest", report.weakest + 1}};
    json["figures"] = {
        {"mismatch", rounded_json(used.mismatch)},   {"gain_spread", rounded_json(used.gain_spread)},
        {"noise", rounded_json(used.noise)},         {"latency", rounded_json(used.latency)},
        {"dead_band", rounded_json(used.dead_band)}, {"friction_spread", rounded_json(used.friction_spread)},
        {"interval", rounded_json(used.interval)},   {"bits", used.bits}};
    json["ideal"] = robot_json(report.ideal);
    json["each"] = nlohmann::ordered_json::array();
    for (const RobotResult& robot : report.robots) json["each"].push_back(robot_json(robot));
    return io::json_text(json, 2) + "\n";
}

std::string table_text(const RobotsReport& report) {
    std::string text = "robot,seed,works,kind,failed_step,seconds,closest_m,final_m\n";
    const auto number = [](float value) { return std::isfinite(value) ? fmt::format("{:.5f}", value) : std::string(); };
    int count = 0;
    for (const RobotResult& robot : report.robots)
        text += fmt::format("{},{},{},{},{},{:.5f},{},{}\n", ++count, robot.seed, robot.works ? 1 : 0,
                            word(robot.outcome.behaviour),
                            robot.failed_step < 0 ? std::string() : std::to_string(robot.failed_step + 1),
                            robot.seconds, number(robot.outcome.closest), number(robot.outcome.final_distance));
    return text;
}

std::string outcome_text(const Tried& tried, const RobotResult& robot) {
    std::string text(word(robot.outcome.behaviour));
    if (tried.exercise)
        text += robot.works ? fmt::format(", passes after {:.1f} s", robot.seconds)
                            : fmt::format(", fails step {}", robot.failed_step + 1);
    if (std::isfinite(robot.outcome.closest)) text += fmt::format(", closest {:.2f} m", robot.outcome.closest);
    return text;
}

// "a sample every 0.02 s of 10 bit, "; empty without interval and converter.
std::string sampling(const Reality& used) {
    std::string text = used.interval > 0 ? fmt::format("a sample every {:g} s", used.interval) : "";
    if (used.bits > 0) text += fmt::format("{}{} bit", text.empty() ? "readings of " : " of ", used.bits);
    return text.empty() ? text : text + ", ";
}

std::string plain_text(const Tried& tried, const insight::Robots& robots, const RobotsReport& report) {
    const Kind& kind = tried.scene.kinds[static_cast<std::size_t>(robots.kind())];
    const Reality used = insight::reality_of(robots.scene().kinds[static_cast<std::size_t>(robots.kind())]);
    std::string text = fmt::format(
        "reality {:g}{}: motors ±{:g} %, sensors ±{:g} %, noise {:g}, latency {:g} s, {}dead band {:g}, wheels ±{:g} "
        "%\n",
        robots.question().reality,
        insight::is_ideal(kind)
            ? fmt::format(" (the kind {} has no figures: those of a typical small robot)", kind.name)
            : "",
        100 * used.mismatch, 100 * used.gain_spread, used.noise, used.latency, sampling(used), used.dead_band,
        100 * used.friction_spread);
    text += fmt::format("{} of {} robots {}\n", report.working, report.robots.size(),
                        tried.exercise ? "pass the exercise" : "do what the ideal robot does");
    text += fmt::format("ideal robot: {}\n", outcome_text(tried, report.ideal));
    text += fmt::format("weakest, robot {}: {}\n", report.weakest + 1,
                        outcome_text(tried, report.robots[static_cast<std::size_t>(report.weakest)]));
    return text;
}

}  // namespace

int robustness(const RobustnessOptions& options) {
    if (const auto error = json_beside_csv(options.csv, options.json)) return complain(*error);
    const auto style = style_of(options.table);
    if (!style) return complain(style.error());
    auto tried = tried_scene(options);
    if (!tried) return complain(tried.error());
    const std::uint64_t seed = options.seed.value_or(tried->exercise ? tried->exercise->seed : 1);
    const auto world = World::create(tried->scene, seed);
    if (!world) return complain(world.error());
    const auto vehicle = vehicle_at_start(snapshot_of(*world), options.vehicle, options.file);
    if (!vehicle) return complain(vehicle.error());
    const double seconds =
        options.seconds.value_or(tried->exercise ? static_cast<double>(tried->exercise->seconds) : 20.0);
    const auto robots = insight::Robots::create({.scene = tried->scene,
                                                 .seed = seed,
                                                 .vehicle = *vehicle,
                                                 .reality = static_cast<float>(options.reality),
                                                 .robots = options.robots,
                                                 .ticks = static_cast<std::size_t>(std::llround(seconds * 60))});
    if (!robots) return complain(robots.error());
    Jobs jobs(threads_for(options.threads));
    auto job = submit_robots(jobs, *robots, tried->exercise);
    jobs.finish();
    if (is_told_to_end()) return interrupted();
    const auto report = *job.take();
    if (!report) return complain(report.error());
    if (const auto error = write_table(options.csv, *style, table_text(*report))) return complain(*error);
    if (options.json) std::cout << json_text(*tried, **robots, *report);
    if (!options.json && options.csv != standard_output) std::cout << plain_text(*tried, **robots, *report);
    return exit_code::done;
}

}  // namespace braitenlab
