#include "core/lesson/check_exercise.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "core/lesson/anchors.h"
#include "core/lesson/selection.h"
#include "core/lesson/submission.h"

namespace braitenlab {

namespace {

// Ids of the messages about a name of a thing: when there is none of this name, and when the name is empty.
struct NameMessages {
    MessageId<1> unknown;
    MessageId<0> wanted;
};
constexpr NameMessages of_zone{"no_zone_of_scene", "name_zone"};
constexpr NameMessages of_obstacle{"no_obstacle_of_scene", "name_obstacle"};
constexpr NameMessages of_vehicle{"no_vehicle_of_scene", "name_vehicle"};
constexpr NameMessages of_kind{"no_kind_of_scene", "name_kind"};
constexpr NameMessages of_sensor{"no_sensor_of_vehicle", "name_sensor"};

// A part of the exercise file that is checked after reading: where it stands, and the scene that its names refer to.
struct ExercisePart {
    TomlFile& file;
    const TomlNode& table;
    std::string path;
    const Scene& scene;
    std::string vehicle;   // name of the start that the check is about
    std::size_t step = 0;  // index of the check's step

    void fail(const char* key, Message what) const {
        const TomlNode* value = table.get(key);
        file.fail(path + "." + key, value ? value : &table, std::move(what));
    }

    // An error at the part itself, for a key that it lacks.
    void fail_missing(const char* key, Message what) const { file.fail(path + "." + key, &table, std::move(what)); }

    // False if there is nothing of this name.
    template <class Named>
    bool check_name(const char* key, const std::string& name, const std::vector<Named>& known,
                    NameMessages messages) const {
        if (!name.empty()) return check_known(key, name, known, messages.unknown);
        if (table.contains(key)) fail(key, message_of("empty_key", key) + message_of(messages.wanted));
        return false;
    }

    // The same for a name that is not empty.
    template <class Named>
    bool check_known(const char* key, const std::string& name, const std::vector<Named>& known,
                     MessageId<1> unknown) const {
        const std::vector<std::string_view> names = known_names(known);
        if (std::find(names.begin(), names.end(), name) != names.end()) return true;
        fail(key, message_of(unknown, in_quotes(name)) + nearest_of(name, names));
        return false;
    }
};

template <class... Goals>
std::string listed_words(const std::variant<Goals...>&) {
    std::string all;
    ((all += fmt::format("{}\"{}\"", all.empty() ? "" : ", ", Goals::traits.word)), ...);
    return all;
}

template <class G, class... Others>
constexpr bool is_one_of = (std::is_same_v<G, Others> || ...);

// True for a goal that compares values of one source over time: the nearest source can become another one.
template <class G>
constexpr bool needs_one_source =
    is_one_of<G, goals::TurnsTo, goals::TurnsAway, goals::Circles, goals::SteadyDistance, goals::SpeedsUp>;

template <class G>
void check_source(const ExercisePart& part, const G& goal) {
    const std::vector<Source>& sources = part.scene.sources;
    if (!goal.source.empty()) return void(part.check_known("source", goal.source, sources, "no_source_of_scene"));
    if (needs_one_source<G> && sources.size() > 1) part.fail("source", message_of("several_sources", G::traits.word));
}

// The sensors of the vehicle that the check is about.
const std::vector<Sensor>& sensors_of(const ExercisePart& part) {
    const std::vector<Start>& starts = part.scene.starts;
    const auto start =
        std::find_if(starts.begin(), starts.end(), [&](const Start& each) { return each.name == part.vehicle; });
    if (start->sensors) return *start->sensors;
    return part.scene.kinds[static_cast<std::size_t>(find_kind(part.scene, start->kind))].sensors;
}

// The vehicle that the check is about can be the one of the goal.
template <class G>
void check_vehicle(const ExercisePart& part, const G& goal) {
    if constexpr (requires { goal.other; })
        if (goal.other == part.vehicle) part.fail("other", message_of("vehicle_of_check", in_quotes(goal.other)));
    const std::string& first = part.scene.starts.front().name;
    if (std::is_same_v<G, goals::Matches> && part.vehicle != first)
        part.fail("vehicle", message_of("about_first_vehicle", G::traits.word, in_quotes(first)));
}

template <class G>
void check_range(const ExercisePart& part, const G& goal) {
    if (part.file.failed_at(part.path)) return;  // the range may be incomplete
    if constexpr (requires { goal.from, goal.to; })
        if (goal.to < goal.from) part.fail("to", message_of("at_least", "to", "from"));
    if constexpr (requires { goal.low, goal.high; })
        if (goal.high < goal.low) part.fail("high", message_of("at_least", "high", "low"));
}

// The names in a goal's keys exist in the scene.
template <class G>
void check_names(const ExercisePart& part, const G& goal) {
    const Scene& scene = part.scene;
    if constexpr (requires { goal.source; }) check_source(part, goal);
    if constexpr (requires { goal.zone; }) part.check_name("zone", goal.zone, scene.zones, of_zone);
    if constexpr (requires { goal.left; }) part.check_name("left", goal.left, scene.obstacles, of_obstacle);
    if constexpr (requires { goal.right; }) part.check_name("right", goal.right, scene.obstacles, of_obstacle);
    if constexpr (requires { goal.other; }) part.check_name("other", goal.other, scene.starts, of_vehicle);
    if constexpr (requires { goal.kind; }) part.check_name("kind", goal.kind, scene.kinds, of_kind);
    if constexpr (requires { goal.sensor; }) part.check_name("sensor", goal.sensor, sensors_of(part), of_sensor);
}

void check_times(const ExercisePart& part, const Check& check) {
    if (check.after > static_cast<int>(part.step)) part.fail("after", message_of("earlier_step", "after"));
    if (check.latest > 0 && check.latest <= check.earliest)
        part.fail("latest", message_of("more_than", "latest", "earliest"));
}

// The part of the file of a check in the list `key` of a part.
ExercisePart part_of(const ExercisePart& whole, const char* key, std::size_t index) {
    return {whole.file,
            whole.table.get(key)->as_list()->at(index),
            fmt::format("{}.{}.{}", whole.path, key, index + 1),
            whole.scene,
            whole.vehicle,
            whole.step};
}

// What can be said of a check, and of those in its goal, without the scene.
void check_check(const ExercisePart& part, const Check& check) {
    if (!part.table.contains("goal"))
        return part.fail_missing("goal", message_of("goal_missing", listed_words(Goal{})));
    if (part.file.failed_at(part.path + ".goal")) return;
    check_times(part, check);
    const auto check_goal = [&]<class G>(const G& goal) {
        check_range(part, goal);
        if constexpr (requires { goal.checks; }) {
            if (goal.checks.empty()) part.fail_missing("check", message_of("checks_missing", G::traits.word));
            for (std::size_t i = 0; i < goal.checks.size(); ++i) check_check(part_of(part, "check", i), goal.checks[i]);
        }
    };
    std::visit(check_goal, check.goal);
}

// The names in a check and in those in its goal. `part.vehicle` is that of the check around this one.
void check_names_of_check(ExercisePart part, const Check& check) {
    if (part.file.failed_at(part.path + ".goal")) return;
    if (!check.vehicle.empty()) {
        if (!part.check_name("vehicle", check.vehicle, part.scene.starts, of_vehicle)) return;
        part.vehicle = check.vehicle;
    }
    const auto check_goal = [&]<class G>(const G& goal) {
        check_names(part, goal);
        check_vehicle(part, goal);
        if constexpr (requires { goal.checks; })
            for (std::size_t i = 0; i < goal.checks.size(); ++i)
                check_names_of_check(part_of(part, "check", i), goal.checks[i]);
    };
    std::visit(check_goal, check.goal);
}

// The dial, or also the part, that is nearest to the first word of the offer that is none.
Message nearest_control(std::string_view offer) {
    std::vector<std::string_view> known;
    for (const Dial dial : all_dials) known.push_back(name(dial));
    if (offer.find('=') == offer.npos)
        known.insert(known.end(), std::begin(offer_parts::all), std::end(offer_parts::all));
    for (;;) {
        const std::size_t end = std::min(offer.find('='), offer.size());
        const std::string_view word = offer.substr(0, end);
        if (!dial_named(word)) return nearest_of(word, known);
        offer.remove_prefix(end + 1);
    }
}

// Adds the dials of the offer at `index` to those offered before it.
void check_offer(TomlTable& top, const std::string& text, std::size_t index, std::vector<Dial>& offered) {
    const TomlNode& place = top.content().get("offers")->as_list()->at(index);
    const auto fail = [&](Message what) {
        top.file().fail(fmt::format("offers.{}", index + 1), &place, std::move(what));
    };
    const auto offer = parse_offer(text);
    if (!offer) return fail(message_of("no_control", in_quotes(text)) + nearest_control(text));
    for (const Dial dial : offer->dials) {
        const DialRange own = range(dial), first = range(offer->dials.front());
        if (std::find(offered.begin(), offered.end(), dial) != offered.end())
            fail(message_of("offered_twice", in_quotes(name(dial))));
        if (own.low != first.low || own.high != first.high) fail(message_of("different_ranges", in_quotes(text)));
        offered.push_back(dial);
    }
}

void check_hidden(TomlTable& top, const Exercise& exercise) {
    for (std::size_t i = 0; i < exercise.hides.size(); ++i) {
        const std::string& kind = exercise.hides[i];
        if (const int index = find_kind(exercise.scene, kind); index < 0 || index == subject_kind(exercise.scene))
            top.file().fail(fmt::format("hides.{}", i + 1), &top.content().get("hides")->as_list()->at(i),
                            message_of("not_another_kind", in_quotes(kind)));
    }
}

void check_offers(TomlTable& top, const Exercise& exercise) {
    std::vector<Dial> offered;
    for (std::size_t i = 0; i < exercise.offers.size(); ++i) check_offer(top, exercise.offers[i], i, offered);
    if (top.content().contains("selection") && !offers_selection(exercise))
        top.fail("selection", message_of("selection_not_offered"));
    if (exercise.changes > 0 && exercise.offers.empty()) top.fail("changes", message_of("changes_without_offers"));
    if (exercise.changes > 0 && !exercise.offers.empty() && offers(exercise, offer_parts::wiring))
        top.fail("changes", message_of("changes_of_wires"));
}

void check_prediction(TomlTable& top, const Prediction& prediction) {
    const TomlNode* table = top.content().get("predict");
    if (!table || !table->as_table() || top.file().failed_at("predict")) return;
    const bool is_drawn_only = !prediction.path_of.empty() && prediction.options.empty();
    if (prediction.question.empty() ||
        (!is_drawn_only && (prediction.options.size() < 2 || !table->contains("answer"))))
        top.fail("predict", message_of("prediction_incomplete"));
}

// The options that the checks of the prediction belong to exist.
void check_shown_options(TomlTable& top, const Prediction& prediction) {
    if (prediction.options.empty()) return;  // absent, or wrong
    const std::vector<std::string_view> known(prediction.options.begin(), prediction.options.end());
    for (std::size_t i = 0; i < prediction.shows.size(); ++i) {
        const std::string& option = prediction.shows[i].option;
        if (option.empty() || std::find(known.begin(), known.end(), option) != known.end()) continue;
        const TomlNode& check = top.content().get("predict")->get("shows")->as_list()->at(i);
        top.file().fail(fmt::format("predict.shows.{}.option", i + 1), check.get("option"),
                        message_of("not_one_of", "option", in_quotes(option)) + nearest_of(option, known));
    }
}

// Calls `check` with each check of the steps and of the prediction, and with its place in the file.
template <class Function>
void for_each_check(TomlTable& top, const Exercise& exercise, const Function& check) {
    const std::string vehicle = exercise.scene.starts.empty() ? "" : exercise.scene.starts.front().name;
    const auto part = [&](const TomlNode& list, const std::string& path, std::size_t i) {
        return ExercisePart{
            top.file(), list.as_list()->at(i), fmt::format("{}.{}", path, i + 1), exercise.scene, vehicle, i};
    };
    for (std::size_t i = 0; i < exercise.prediction.shows.size(); ++i)
        check(part(*top.content().get("predict")->get("shows"), "predict.shows", i),
              exercise.prediction.shows[i].check);
    for (std::size_t i = 0; i < exercise.steps.size(); ++i)
        check(part(*top.content().get("step"), "step", i), exercise.steps[i].check);
}

void check_anchors(TomlTable& top, const Exercise& exercise) {
    const std::vector<std::string> anchors = anchors_of(exercise);
    const std::vector<std::string_view> known(anchors.begin(), anchors.end());
    const TomlNode* hints = top.content().get("hint");
    for (std::size_t i = 0; i < exercise.hints.size(); ++i) {
        const std::string& anchor = exercise.hints[i].anchor;
        if (anchor.empty() || std::find(known.begin(), known.end(), anchor) != known.end()) continue;
        top.file().fail(fmt::format("hint.{}.anchor", i + 1), hints->as_list()->at(i).get("anchor"),
                        message_of("no_widget", in_quotes(anchor)) + nearest_of(anchor, known));
    }
}

// Numbers that depend on others of the file.
void check_numbers(TomlTable& top, const Exercise& exercise) {
    const TomlFile& file = top.file();
    if (exercise.needed > exercise.starts && !file.failed_at("starts") && !file.failed_at("needed"))
        top.fail("needed", message_of("more_needed_than_starts", exercise.needed, exercise.starts));
    if (exercise.median.step > static_cast<int>(exercise.steps.size()) && !file.failed_at("step"))
        top.fail("median", message_of("median_step", exercise.median.step, exercise.steps.size()));
    if (top.has("median") && exercise.median.step == 0 && !file.failed_at("median"))
        top.fail("median", message_of("key_missing", "step", "step = 1"));
}

// True if an unknown key of the table at this path has been reported with `key` as the nearest one.
bool is_misspelt(const TomlFile& file, const std::string& table, const char* key) {
    const Phrase nearest{"nearest", {in_quotes(key)}};
    return std::any_of(file.faults.begin(), file.faults.end(), [&](const TomlFault& fault) {
        const auto& phrases = fault.error.phrases;
        return fault.path.starts_with(table + ".") && !phrases.empty() && phrases.front().id == "unknown_key" &&
               phrases.back() == nearest;
    });
}

// Every step and hint has a text.
void check_texts(TomlTable& top, const Exercise& exercise) {
    TomlFile& file = top.file();
    const auto check = [&](const char* list, const auto& elements, MessageId<0> id) {
        for (std::size_t i = 0; i < elements.size(); ++i)
            if (elements[i].text.empty() && !is_misspelt(file, fmt::format("{}.{}", list, i + 1), "text"))
                file.fail(fmt::format("{}.{}.text", list, i + 1), &top.content().get(list)->as_list()->at(i),
                          message_of(id));
    };
    check("step", exercise.steps, "step_text_missing");
    check("hint", exercise.hints, "hint_text_missing");
}

}  // namespace

void check_exercise(TomlTable& top, const Exercise& exercise) {
    TomlFile& file = top.file();
    const auto is_missing = [&](const char* key) { return !top.has(key) && !top.fail_if_misspelt(key, {}, {}); };
    for (const char* key : {"title", "goal"})
        if (is_missing(key))
            file.add(key, error_of(message_of("key_missing", key, std::string(key) + " = \"…\""), file.name, 1));
    check_prediction(top, exercise.prediction);
    check_shown_options(top, exercise.prediction);
    check_offers(top, exercise);
    check_numbers(top, exercise);
    if (is_missing("solution")) file.add("solution", error_of(message_of("solution_missing"), file.name));
    if (exercise.steps.empty() && (top.has("step") || is_missing("step")))
        file.add("step", error_of(message_of("step_missing"), file.name));
    check_texts(top, exercise);
    for_each_check(top, exercise, check_check);
}

void check_against_scene(TomlTable& top, const Exercise& exercise) {
    check_hidden(top, exercise);
    const Prediction& asked = exercise.prediction;
    if (const TomlNode* table = top.content().get("predict"); table && !asked.path_of.empty()) {
        const ExercisePart part{top.file(), *table, "predict", exercise.scene, ""};
        part.check_name("path", asked.path_of, exercise.scene.starts, of_vehicle);
    }
    for_each_check(top, exercise, check_names_of_check);
    check_anchors(top, exercise);
}

}  // namespace braitenlab
