#include "core/lesson/author.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/lesson/exercise_schema.h"
#include "core/maths/angle.h"
#include "core/messages.h"
#include "core/scene/brain_text.h"

namespace braitenlab {

namespace {

const Start* start_named(const Scene& scene, std::string_view name) {
    for (const Start& each : scene.starts)
        if (each.name == name) return &each;
    return scene.starts.empty() ? nullptr : &scene.starts.front();
}

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& each : all) names.push_back(each.name);
    return names;
}

// The visitor of core/scene/schema.h that lists the parameters of a goal.
template <class G>
struct GoalValues {
    G& goal;
    std::vector<GoalValue>& found;

    void number(const char* key, float G::*member, const char* unit, Range range, const char*) {
        found.push_back({key, unit, range, &(goal.*member)});
    }
    void number(const char* key, int G::*member, const char* unit, Range range, const char*) {
        found.push_back({key, unit, range, nullptr, &(goal.*member)});
    }
    void text(const char* key, std::string G::*member, std::size_t, const char*) {
        found.push_back({key, "", {0, 0}, nullptr, nullptr, &(goal.*member)});
    }
    template <class Element>
    void list(const char*, std::vector<Element> G::*, std::size_t, const char*) {}
};

// The usual value of a parameter; that of a distance depends on the goal.
float usual_value(std::string_view goal, std::string_view key) {
    if (key == "metres")
        return goal == "avoids" ? 1.5f : goal == "follows_line" ? 0.3f : goal == "follows" ? 2.0f : 0.5f;
    if (key == "degrees") return goal == "turns_away" ? 90.0f : 15.0f;
    if (key == "speed") return goal == "drives" ? 0.5f : 0.05f;
    if (key == "seconds") return goal == "keeps_moving" ? 1.0f : 5.0f;
    if (key == "from") return goal == "keeps_speed" ? 0.2f : 1.0f;
    if (key == "to") return goal == "keeps_speed" ? 1.0f : 3.0f;
    if (key == "percent") return 20;
    if (key == "factor") return 1.5f;
    if (key == "correlation") return 0.5f;
    if (key == "low") return 0.3f;
    if (key == "high") return 0.8f;
    return 1;  // rounds, laps
}

std::string nearest_source(const Scene& scene, std::string_view vehicle) {
    const Start* start = start_named(scene, vehicle);
    std::string nearest;
    float least = std::numeric_limits<float>::infinity();
    for (const Source& each : scene.sources) {
        const float distance = start ? std::hypot(each.x - start->x, each.y - start->y) : 0;
        if (distance < least) least = distance, nearest = each.name;
    }
    return nearest;
}

// The distance (m) at which the vehicle has reached the source: half a metre, or for a solid one that of the touching
// chassis with some margin.
float reach(const Scene& scene, std::string_view vehicle, const std::string& source) {
    const int found = find_source(scene, source);
    const Start* start = start_named(scene, vehicle);
    const int kind = start ? find_kind(scene, start->kind) : -1;
    if (found < 0 || kind < 0 || !scene.sources[static_cast<std::size_t>(found)].solid) return 0.5f;
    const Body& body = scene.kinds[static_cast<std::size_t>(kind)].body;
    return std::ceil((source_radius(scene.arena) + body.length / 2 + 0.15f) * 10) / 10;
}

bool has_role(const Scene& scene, Role role) {
    return std::any_of(scene.kinds.begin(), scene.kinds.end(), [&](const Kind& kind) { return kind.role == role; });
}

bool has_zone(const Scene& scene, bool (*is_wanted)(const Zone&)) {
    return std::any_of(scene.zones.begin(), scene.zones.end(), is_wanted);
}

// False for a goal that nothing in the scene can meet, although it names no object.
bool is_possible(const Scene& scene, std::string_view goal) {
    if (goal == "captures") return has_role(scene, Role::predator) && has_role(scene, Role::prey);
    if (goal == "follows_line") return has_zone(scene, [](const Zone& zone) { return zone.surface == Surface::tape; });
    if (goal == "recharges") return has_zone(scene, [](const Zone& zone) { return zone.recharge > 0; });
    if (goal == "visits") return !scene.sources.empty();
    return goal != "population";
}

// Sets the usual values. False if the scene lacks an object that the goal names.
bool prefill(Goal& goal, const Scene& scene, std::string_view vehicle) {
    std::size_t posts = 0;
    for (const GoalValue& value : values_of(goal)) {
        if (value.number) *value.number = usual_value(word_of(goal), value.key);
        if (value.count) *value.count = value.key == "count" && word_of(goal) == "collides" ? 0 : 1;
        if (!value.name) continue;
        const std::vector<std::string> names = names_for(value.key, scene, vehicle);
        const std::size_t which = value.key == "right" ? ++posts : 0;  // the two posts of a gate differ
        if (names.size() <= which) return false;
        *value.name = value.key == "source" ? nearest_source(scene, vehicle) : names[which];
    }
    if (auto* touches = std::get_if<goals::Touches>(&goal)) touches->metres = reach(scene, vehicle, touches->source);
    return true;
}

template <std::size_t... Index>
std::vector<Goal> every_goal(std::index_sequence<Index...>) {
    std::vector<Goal> all;
    (all.emplace_back(std::in_place_index<Index>), ...);
    return all;
}

// The first start gives its own brain and sensors to its kind; the others of the kind keep what they had.
void move_to_kind(Scene& scene) {
    Start& first = scene.starts.front();
    Kind& kind = scene.kinds[static_cast<std::size_t>(find_kind(scene, first.kind))];
    const BrainGraph brain = first.brain.value_or(kind.brain);
    const std::vector<Sensor> sensors = first.sensors.value_or(kind.sensors);
    const auto keep = [&](auto& other) {
        if (other.kind != kind.name) return;
        if (!other.brain && brain != kind.brain) other.brain = kind.brain;
        if (!other.sensors && sensors != kind.sensors) other.sensors = kind.sensors;
    };
    first.brain = brain, first.sensors = sensors;
    for (Start& other : scene.starts) keep(other);
    for (Member& other : scene.members) keep(other);
    first.brain.reset(), first.sensors.reset();
    kind.brain = brain, kind.sensors = sensors;
}

// The brain that the start of this name has in the file; that of its kind if there is no such start.
BrainGraph filed_brain(const Scene& file, const Start& start, const BrainGraph& otherwise) {
    for (const Start& each : file.starts)
        if (each.name == start.name && each.brain) return *each.brain;
    const int kind = find_kind(file, start.kind);
    return kind < 0 ? otherwise : file.kinds[static_cast<std::size_t>(kind)].brain;
}

// The drives of the motors stay. The four wires of a four-neuron brain stay, too, with the weight 0, so that its
// sliders do.
BrainGraph without_wires(BrainGraph brain) {
    if (!is_four_neurons(brain)) {
        brain.wires.clear();
        return brain;
    }
    const auto drive = [&](const char* motor) { return find_node(brain, std::string(motor))->bias; };
    return make_graph(FourNeurons{.LM = drive("ML"), .RM = drive("MR")});
}

BrainGraph shipped_brain(const ExerciseDraft& draft, const Scene& file, const Start& start, const BrainGraph& now) {
    return draft.ships == ShippedBrain::without_wires ? without_wires(now) : filed_brain(file, start, now);
}

// The answer with this brain; sensors and body are those of the kind.
Answer answer_of(const std::string& name, const BrainGraph& brain, const Kind& kind) {
    Answer answer{name, "", to_text(brain), {}, {brain, kind.sensors, kind.body}};
    if (answer.brain.given.empty() && answer.brain.nodes.empty())
        answer.brain.given = {Dial::LL};  // a brain without wires is an answer, too
    return answer;
}

}  // namespace

std::string_view word_of(const Goal& goal) {
    return std::visit([]<class G>(const G&) { return G::traits.word; }, goal);
}

std::vector<GoalValue> values_of(Goal& goal) {
    std::vector<GoalValue> found;
    std::visit(
        [&]<class G>(G& each) {
            GoalValues<G> values{each, found};
            describe(values, Of<G>{});
        },
        goal);
    return found;
}

std::vector<std::string> names_for(std::string_view key, const Scene& scene, std::string_view vehicle) {
    if (key == "source") return names_of(scene.sources);
    if (key == "zone") return names_of(scene.zones);
    if (key == "left" || key == "right") return names_of(scene.obstacles);
    if (key == "kind") return names_of(scene.kinds);
    const Start* start = start_named(scene, vehicle);
    if (key == "other") {
        std::vector<std::string> names = names_of(scene.starts);
        std::erase(names, start ? start->name : "");
        return names;
    }
    if (!start) return {};
    if (start->sensors) return names_of(*start->sensors);
    const int kind = find_kind(scene, start->kind);
    return kind < 0 ? std::vector<std::string>{} : names_of(scene.kinds[static_cast<std::size_t>(kind)].sensors);
}

std::vector<Goal> goals_for(const Scene& scene, std::string_view vehicle) {
    std::vector<Goal> found;
    for (Goal& goal : every_goal(std::make_index_sequence<std::variant_size_v<Goal>>{})) {
        const bool combines = std::visit(
            []<class G>(const G&) {
                return requires(const G& g) { g.checks; };
            },
            goal);
        if (!combines && is_possible(scene, word_of(goal)) && prefill(goal, scene, vehicle))
            found.push_back(std::move(goal));
    }
    return found;
}

std::size_t subject_start(const ExerciseDraft& draft, const Scene& scene) {
    for (std::size_t i = 0; i < scene.starts.size(); ++i)
        if (scene.starts[i].name == draft.vehicle) return i;
    return 0;
}

Result<Exercise> make_exercise(const ExerciseDraft& draft, const std::string& id, const Scene& now, const Scene& file) {
    if (now.starts.empty()) return error_of(message_of("exercise_without_vehicle"));
    Exercise exercise;
    exercise.id = id;
    exercise.title = draft.title, exercise.goal = draft.goal;
    for (const std::string& hint : draft.hints) exercise.hints.push_back({hint, ""});
    exercise.offers = draft.offers;
    exercise.steps = draft.steps;
    exercise.prediction = draft.prediction;
    for (ShownCheck& shown : exercise.prediction.shows)
        if (!draft.prediction.options.empty())
            shown.option = draft.prediction.options[static_cast<std::size_t>(draft.prediction.answer)];
    exercise.seconds = draft.seconds;
    exercise.starts = draft.starts;
    exercise.needed = std::max(1, draft.starts * 8 / 10);
    Scene& scene = exercise.scene = now;
    scene.name.clear(), scene.title.clear(), scene.story.clear();  // they may tell the outcome
    const auto subject = scene.starts.begin() + static_cast<std::ptrdiff_t>(subject_start(draft, now));
    std::rotate(scene.starts.begin(), subject, subject + 1);
    scene.starts.front().heading_spread = draft.heading_spread * (maths::pi / 180);
    const Start first = scene.starts.front();
    move_to_kind(scene);
    Kind& kind = scene.kinds[static_cast<std::size_t>(find_kind(scene, first.kind))];
    const BrainGraph solution = kind.brain;
    kind.brain = shipped_brain(draft, file, first, solution);
    if (without_places(kind.brain) == without_places(solution)) return error_of(message_of("exercise_solved"));
    exercise.solution = answer_of("", solution, kind);
    for (const WrongDraft& each : draft.wrong) {
        if (without_places(each.brain) == without_places(solution))
            return error_of(message_of("exercise_wrong_is_solution", each.name));
        exercise.wrong.push_back(answer_of(each.name, each.brain, kind));
    }
    return exercise;
}

}  // namespace braitenlab
