#include "core/lesson/warnings.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/brain/brain.h"
#include "core/brain/four_neurons.h"
#include "core/lesson/exercise_file.h"
#include "core/lesson/grade.h"
#include "core/lesson/referee.h"
#include "core/lesson/reference.h"
#include "core/lesson/selection.h"
#include "core/lesson/submission.h"
#include "core/maths/angle.h"
#include "core/messages.h"
#include "core/scene/arena.h"
#include "core/scene/nearest.h"
#include "core/scene/sensor_pairs.h"
#include "core/scene/toml_tree.h"
#include "core/text_parts.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

using maths::vec2;

// The files of an exercise and of its scene, for the lines of values.
class WarningPlaces {
public:
    WarningPlaces(std::string_view toml, const std::filesystem::path& path) {
        if (auto file = parse_toml(toml, path.string())) exercise_ = std::move(*file);
        const TomlNode* scene = exercise_.root.get("scene");
        if (!scene || !scene->as_text()) return;
        const std::filesystem::path scene_path = (path.parent_path() / *scene->as_text()).lexically_normal();
        const auto text = read_text(scene_path);
        if (!text) return;
        if (auto file = parse_toml(*text, scene_path.string())) scene_ = std::move(*file);
    }

    Error at(const std::string& key, Message what) const { return exercise_.fault_at(key, std::move(what)); }
    Error in_scene(const std::string& key, Message what) const {
        return scene_ ? scene_->fault_at(key, std::move(what)) : at("scene." + key, std::move(what));
    }

private:
    TomlFile exercise_;
    std::optional<TomlFile> scene_;
};

// ── Convex polygons, for what stands in what ──

using Corners = std::vector<vec2>;

Corners placed_at(Corners corners, vec2 at, float heading) {
    const float c = std::cos(heading), s = std::sin(heading);
    for (vec2& corner : corners) corner = at + vec2{c * corner.x - s * corner.y, s * corner.x + c * corner.y};
    return corners;
}

// True if a side of `a` has all of `b` on its outer side. Counter-clockwise.
bool side_separates(const Corners& a, const Corners& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const vec2 from = a[i], along = a[(i + 1) % a.size()] - from;
        if (std::all_of(b.begin(), b.end(), [&](vec2 corner) { return maths::cross(along, corner - from) <= 0; }))
            return true;
    }
    return false;
}

bool overlap(const Corners& a, const Corners& b) { return !side_separates(a, b) && !side_separates(b, a); }

Corners chassis_of(const Body& body, const VehicleView& vehicle) {
    const float x = body.length / 2, y = body.width / 2;
    return placed_at({{x, y}, {-x, y}, {-x, -y}, {x, -y}}, {vehicle.x, vehicle.y}, vehicle.heading);
}

Corners corners_of(const Source& post, float radius) {
    Corners corners;
    for (int i = 0; i < 12; ++i) {
        const float angle = static_cast<float>(i) * 2 * maths::pi / 12;
        corners.push_back(vec2{post.x, post.y} + radius * vec2{std::cos(angle), std::sin(angle)});
    }
    return corners;
}

// What the chassis stands in; empty: nothing.
Message stands_in(const Scene& scene, const Corners& chassis) {
    for (const Obstacle& each : scene.obstacles)
        if (overlap(chassis, placed_at(corners_of(each), {each.x, each.y}, each.heading)))
            return message_of("the_obstacle", in_quotes(each.name));
    for (const Source& each : scene.sources)
        if (each.solid && overlap(chassis, corners_of(each, source_radius(scene.arena))))
            return message_of("the_solid", in_quotes(each.name));
    const auto is_in = [&](vec2 corner) { return is_inside(scene.arena, corner); };
    if (has_walls(scene.arena.edge) && !std::all_of(chassis.begin(), chassis.end(), is_in))
        return message_of("the_wall");
    return {};
}

// ── The warnings, one function each ──

std::string shortly(float value) { return fmt::format("{}", value); }

void warn_of_sources(const Exercise& exercise, const WarningPlaces& places, std::vector<Error>& found) {
    const Arena& arena = exercise.scene.arena;
    for (const Source& each : exercise.scene.sources)
        if (!is_inside(arena, {each.x, each.y}))
            found.push_back(places.in_scene("source." + each.name,
                                            message_of("source_outside", in_quotes(each.name), shortly(each.x),
                                                       shortly(each.y), shortly(arena.width), shortly(arena.height))));
}

// True if a wire of the brain reads the sensor of this name.
bool is_read(const BrainGraph& brain, const std::string& sensor) {
    const Node* node = find_node(brain, sensor);
    return node &&
           std::any_of(brain.wires.begin(), brain.wires.end(), [&](const Wire& wire) { return wire.from == node->id; });
}

// True if a dial that is offered is a wire of this sensor.
bool has_offered_dial(const Exercise& exercise, const std::vector<Sensor>& sensors, const std::string& sensor) {
    const bool is_left_offered = offers(exercise, Dial::LL) || offers(exercise, Dial::RL);
    const bool is_right_offered = offers(exercise, Dial::LR) || offers(exercise, Dial::RR);
    for (const KindPair& pair : sensor_pairs(sensors))
        if ((pair.sensors.left == sensor && is_left_offered) || (pair.sensors.right == sensor && is_right_offered))
            return true;
    return false;
}

void warn_of_sensors(const Exercise& exercise, const WarningPlaces& places, std::vector<Error>& found) {
    if (offers(exercise, offer_parts::wiring) || offers(exercise, offer_parts::sensors)) return;
    const Submission shipped = as_shipped(exercise);
    const std::string& kind = exercise.scene.starts.front().kind;
    for (const Sensor& each : shipped.sensors)
        if (!is_read(shipped.brain, each.name) && !is_read(exercise.solution.submission.brain, each.name) &&
            !has_offered_dial(exercise, shipped.sensors, each.name))
            found.push_back(places.in_scene(fmt::format("kind.{}.sensor.{}", kind, each.name),
                                            message_of("sensor_unread", in_quotes(each.name))));
}

// At tick 0 and 1 of a start with the shipped brain: vehicles in something, and steps that are done.
void warn_of_start(const Exercise& exercise, const WarningPlaces& places, std::uint64_t seed,
                   std::vector<std::string>& known, std::vector<Error>& found) {
    auto world = World::create(exercise.scene, seed);
    if (!world) return;
    const auto warn_once = [&](const std::string& key, Error error) {
        if (std::find(known.begin(), known.end(), key) != known.end()) return;
        known.push_back(key);
        found.push_back(std::move(error));
    };
    Snapshot now = snapshot_of(*world);
    for (const VehicleView& vehicle : now.vehicles) {
        const Message in = stands_in(exercise.scene, chassis_of(kind_of(now, vehicle).body, vehicle));
        if (in.text.empty() || vehicle.start < 0) continue;
        const std::string key = "vehicle." + exercise.scene.starts[static_cast<std::size_t>(vehicle.start)].name;
        warn_once(key, places.in_scene(key, message_of("starts_in", seed) + in + message_of("starts_in_cure")));
    }
    Referee referee(exercise);
    referee.watch(now);
    world->step();
    world->capture(now);
    referee.watch(now);
    const std::vector<Verdict> verdicts = referee.verdicts();
    for (std::size_t i = 0; i < verdicts.size(); ++i)
        if (const std::string key = fmt::format("step.{}", i + 1); verdicts[i].done)
            warn_once(key, places.at(key, message_of("done_at_start", seed)));
}

void warn_of_equal_starts(const Exercise& exercise, const WarningPlaces& places, std::vector<Error>& found) {
    const Scene& scene = exercise.scene;
    const auto varies = [](const Start& each) { return each.place_spread > 0 || each.heading_spread > 0; };
    if (exercise.starts < 2 || scene.ecology.population > 0) return;
    if (std::any_of(scene.starts.begin(), scene.starts.end(), varies)) return;
    found.push_back(
        places.in_scene("vehicle." + scene.starts.front().name, message_of("equal_starts", exercise.starts)));
}

ReferencePath path_before_answer(const Exercise& exercise, const Submission& submission) {
    Reference run(exercise, submission, 0, exercise.seed);
    return run.until(static_cast<std::uint64_t>(exercise.prediction.after / tick_seconds));
}

// What the first vehicle does until the answer is visible, so that the author can compare it with the answer.
Message run_before_answer(const Exercise& exercise) {
    const ReferencePath path = path_before_answer(exercise, as_shipped(exercise));
    if (path.empty()) return {};
    const Pose &first = path.front(), &last = path.back();
    float driven = 0, turned = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        driven += std::hypot(path[i].x - path[i - 1].x, path[i].y - path[i - 1].y);
        turned += maths::wrap_angle(path[i].heading - path[i - 1].heading);
    }
    Message said = message_of("run_before_answer", shortly(exercise.prediction.after), exercise.seed,
                              fmt::format("{:.1f}", driven));
    const float degrees = std::fabs(maths::degrees(turned));
    const std::string angle = fmt::format("{:.0f}", degrees);
    said = said + (degrees < 1  ? message_of("straight_before_answer")
                   : turned > 0 ? message_of("left_before_answer", angle)
                                : message_of("right_before_answer", angle));
    const Source* nearest = nullptr;
    const auto away = [](const Source& source, const Pose& pose) {
        return std::hypot(source.x - pose.x, source.y - pose.y);
    };
    for (const Source& each : exercise.scene.sources)
        if (!nearest || away(each, first) < away(*nearest, first)) nearest = &each;
    if (nearest)
        said = said + message_of("source_before_answer", in_quotes(nearest->name),
                                 fmt::format("{:.1f}", away(*nearest, first)),
                                 fmt::format("{:.1f}", away(*nearest, last)));
    return said;
}

bool drives_elsewhere(const ReferencePath& a, const ReferencePath& b) {
    constexpr float apart = 0.25f;  // m
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (std::hypot(a[i].x - b[i].x, a[i].y - b[i].y) > apart) return true;
    return a.size() != b.size();
}

// The solution, the shipped brain with crossed wires and the wrong answers, without those that drive as the shipped
// brain does until the answer is visible.
std::vector<Submission> brains_that_differ(const Exercise& exercise) {
    std::vector<Submission> others{exercise.solution.submission,
                                   with_brain(exercise, crossed(as_shipped(exercise).brain))};
    for (const Answer& wrong : exercise.wrong) others.push_back(wrong.submission);
    const ReferencePath shipped = path_before_answer(exercise, as_shipped(exercise));
    std::erase_if(
        others, [&](const Submission& each) { return !drives_elsewhere(path_before_answer(exercise, each), shipped); });
    return others;
}

// Checks of the answer that any brain meets, such as "it drives" for "straight on", fit other options as well. Says
// nothing of checks about another vehicle, and of a brain that is selected by hand.
void warn_of_weak_checks(const Exercise& exercise, const WarningPlaces& places, std::vector<Error>& found) {
    const Prediction& asked = exercise.prediction;
    const auto answer = static_cast<std::size_t>(asked.answer);
    const std::vector<std::size_t> checks = checks_of_option(asked, answer);
    if (!is_asked(asked) || checks.empty() || offers_selection(exercise)) return;
    const auto is_of_another = [&](std::size_t i) { return !asked.shows[i].check.vehicle.empty(); };
    if (std::any_of(checks.begin(), checks.end(), is_of_another)) return;
    const std::vector<Submission> others = brains_that_differ(exercise);
    const auto meets = [&](const Submission& each) { return shown_run(exercise, each, answer).passed; };
    if (!others.empty() && std::all_of(others.begin(), others.end(), meets))
        found.push_back(
            places.at(fmt::format("predict.shows.{}", checks.front() + 1), message_of("answer_of_any_brain")));
}

// True if the prediction has an answer that no check tests.
bool is_answer_untested(const Exercise& exercise) {
    const Prediction& asked = exercise.prediction;
    return is_asked(asked) && checks_of_option(asked, static_cast<std::size_t>(asked.answer)).empty();
}

void warn_of_prediction(const Exercise& exercise, const WarningPlaces& places, std::vector<Error>& found) {
    const Prediction& asked = exercise.prediction;
    if (asked.question.empty()) return;
    if (is_answer_untested(exercise))
        found.push_back(places.at("predict.answer", message_of("answer_untested") + run_before_answer(exercise)));
    if (asked.after > exercise.seconds)
        found.push_back(places.at("predict.after",
                                  message_of("answer_after_the_run", shortly(asked.after), shortly(exercise.seconds))));
    for (std::size_t i = 0; i < asked.shows.size() && !asked.options.empty(); ++i)
        if (asked.shows[i].option.empty())
            found.push_back(
                places.at(fmt::format("predict.shows.{}", i + 1),
                          message_of("check_without_option", asked.options[static_cast<std::size_t>(asked.answer)])));
    for (std::size_t i = 0; i < asked.options.size(); ++i)
        if (std::find(asked.options.begin(), asked.options.begin() + static_cast<std::ptrdiff_t>(i),
                      asked.options[i]) != asked.options.begin() + static_cast<std::ptrdiff_t>(i))
            found.push_back(places.at("predict.options", message_of("offered_twice", in_quotes(asked.options[i]))));
    if (asked.outcome.empty()) found.push_back(places.at("predict", message_of("no_outcome")));
}

void warn_of_words(const Exercise& exercise, const WarningPlaces& places, std::vector<Error>& found) {
    int words = word_count(exercise.goal) + word_count(exercise.prediction.question);
    for (const std::string& option : exercise.prediction.options) words += word_count(option);
    if (words > most_first_words) found.push_back(places.at("goal", message_of("many_words", words, most_first_words)));
}

void warn_of_wrong_answers(const Exercise& exercise, const WarningPlaces& places, std::vector<Error>& found) {
    for (std::size_t i = 0; i < exercise.wrong.size(); ++i) {
        const Answer& wrong = exercise.wrong[i];
        const std::string key = fmt::format("wrong.{}", i + 1);
        if (wrong.submission == exercise.solution.submission)
            found.push_back(places.at(key, message_of("wrong_is_solution")));
        if (wrong.text.empty()) found.push_back(places.at(key, message_of("wrong_without_text")));
        if (const auto outside = outside_offers(exercise, wrong.submission); !outside.empty())
            found.push_back(places.at(key, message_of("wrong_outside", outside.front())));
    }
}

// What the step needs must be what the rule says, within a tenth.
void warn_of_median(const Exercise& exercise, const WarningPlaces& places, std::vector<Error>& found) {
    constexpr float tolerance = 0.1f;
    const MedianRule& rule = exercise.median;
    if (rule.step == 0) return;
    const Grade shipped = grade(exercise, as_shipped(exercise));
    const auto& verdicts = shipped.starts.front().verdicts;
    if (verdicts.empty()) return;
    const float needed = verdicts[static_cast<std::size_t>(rule.step) - 1].measures.front().needed;
    const float wanted = rule.factor * median(measured_values(rule, shipped.starts));
    if (std::fabs(needed - wanted) <= tolerance * std::fabs(wanted)) return;
    const auto [has, should] =
        told_apart(static_cast<double>(needed), static_cast<double>(wanted), Digits::behind_point, 2);
    found.push_back(places.at(fmt::format("step.{}", rule.step),
                              message_of("median_differs", rule.step, has, rule.factor, should)));
}

// The key in the file of a text's id: "predict.option.2" is the second of the options.
std::string key_of_text(const std::string& id, const Exercise& exercise) {
    std::string key = id.substr(exercise.id.size() + 1);
    if (key.starts_with("predict.option.")) key = "predict.options";
    return key;
}

}  // namespace

int word_count(std::string_view text) {
    int count = 0;
    bool in_word = false;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isspace(byte)) {
            in_word = false;
        } else if (!in_word && (std::isalnum(byte) || byte >= 0xc3)) {
            in_word = byte < 0xe2;  // signs such as → and … are no words
            count += in_word;
        }
    }
    return count;
}

std::vector<Error> warnings_of(const Exercise& exercise, std::string_view toml, const std::filesystem::path& path) {
    const WarningPlaces places(toml, path);
    std::vector<Error> found;
    warn_of_sources(exercise, places, found);
    warn_of_sensors(exercise, places, found);
    warn_of_equal_starts(exercise, places, found);
    warn_of_median(exercise, places, found);
    std::vector<std::string> known;
    for (int i = 0; i < exercise.starts; ++i)
        warn_of_start(exercise, places, static_cast<std::uint64_t>(i) + 1, known, found);
    warn_of_prediction(exercise, places, found);
    warn_of_weak_checks(exercise, places, found);
    warn_of_words(exercise, places, found);
    warn_of_wrong_answers(exercise, places, found);
    std::stable_sort(found.begin(), found.end(), [](const Error& a, const Error& b) { return a.line < b.line; });
    return found;
}

bool doubt_answer(const std::vector<Error>& warnings) {
    constexpr std::array<std::string_view, 3> doubts{"answer_untested", "check_without_option", "answer_of_any_brain"};
    return std::any_of(warnings.begin(), warnings.end(), [&](const Error& each) {
        return !each.phrases.empty() &&
               std::find(doubts.begin(), doubts.end(), each.phrases.front().id) != doubts.end();
    });
}

std::optional<Error> prediction_fault(const Exercise& exercise, std::string_view toml,
                                      const std::filesystem::path& path) {
    const Prediction& asked = exercise.prediction;
    const auto answer = static_cast<std::size_t>(asked.answer);
    if (const auto other = other_option_shown(exercise))
        return WarningPlaces(toml, path)
            .at("predict.answer",
                message_of("other_option_shown", exercise.seed, asked.options[*other], asked.options[answer]));
    const std::vector<std::size_t> checks = checks_of_option(asked, answer);
    if (checks.empty()) return std::nullopt;
    const StartResult run = shown_run(exercise, answer);
    if (run.passed) return std::nullopt;
    const std::size_t failed = std::min(failed_step(run), checks.size() - 1);
    return WarningPlaces(toml, path)
        .at(fmt::format("predict.shows.{}", checks[failed] + 1),
            message_of("answer_contradicted", exercise.seed, shortly(asked.after)));
}

std::vector<Error> missing_translations(const Exercise& exercise, std::string_view toml,
                                        const std::filesystem::path& path, const std::filesystem::path& translations) {
    const auto text = read_text(translations);
    if (!text) return {text.error()};
    const auto words = parse_toml(*text, translations.string());
    if (!words) return {words.error()};
    const WarningPlaces places(toml, path);
    std::vector<Error> found;
    for (const TranslatableText& each : texts_of(exercise)) {
        const TomlNode* node = &words->root;
        for (const std::string& part : parts_of(each.id, '.')) node = node ? node->get(part) : nullptr;
        if (!node || !node->as_text())
            found.push_back(places.at(key_of_text(each.id, exercise),
                                      message_of("not_translated", translations.string(), in_quotes(each.id))));
    }
    return found;
}

}  // namespace braitenlab
