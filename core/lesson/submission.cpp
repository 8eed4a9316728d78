#include "core/lesson/submission.h"

#include <algorithm>

#include "core/scene/sensor_pairs.h"

namespace braitenlab {

namespace {

const Kind& shipped_kind(const Exercise& exercise) {
    return exercise.scene.kinds[static_cast<std::size_t>(subject_kind(exercise.scene))];
}

template <class Range, class Value>
bool contains(const Range& range, const Value& value) {
    return std::find(std::begin(range), std::end(range), value) != std::end(range);
}

// The pairs whose wires the dials are: those of the sensors, or SL and SR.
std::vector<SensorPair> pairs_of(const std::vector<Sensor>& sensors) {
    std::vector<SensorPair> pairs;
    for (const KindPair& pair : sensor_pairs(sensors)) pairs.push_back(pair.sensors);
    if (pairs.empty()) pairs.emplace_back();
    return pairs;
}

bool differs(const BrainGraph& a, const BrainGraph& b, Dial dial, const std::vector<SensorPair>& pairs) {
    return std::any_of(pairs.begin(), pairs.end(), [&](const SensorPair& pair) {
        return at(read_dials(a, pair), dial) != at(read_dials(b, pair), dial);
    });
}

// The brain with the dials and the curves of its direct wires set to the same values in every brain, so that two brains
// differ afterwards only in something else. A direct wire that has nothing else is left out: a missing one has weight
// 0. The wires are in the order of their ends.
BrainGraph without_dials(BrainGraph graph, const std::vector<SensorPair>& pairs) {
    std::erase_if(graph.wires, [&](Wire& wire) {
        const WireEnds ends{wire.from, wire.to};
        const bool is_direct = std::any_of(pairs.begin(), pairs.end(), [&](const SensorPair& pair) {
            return direct_dial(graph, ends, pair).has_value();
        });
        if (is_direct) wire.weight = wire.threshold = 0, wire.curve = {};
        return is_direct && wire == Wire{.from = ends.from, .to = ends.to, .weight = 0};
    });
    std::sort(graph.wires.begin(), graph.wires.end(), [](const Wire& a, const Wire& b) {
        return WireEnds{a.from, a.to} < WireEnds{b.from, b.to};
    });
    for (Node& node : graph.nodes)
        if (node.name == "ML" || node.name == "MR") node.bias = 0;
    return without_places(std::move(graph));
}

// The brain with its nodes and wires in the order of their ids, without places.
BrainGraph sorted_by_ids(BrainGraph graph) {
    std::sort(graph.nodes.begin(), graph.nodes.end(), [](const Node& a, const Node& b) { return a.id < b.id; });
    std::sort(graph.wires.begin(), graph.wires.end(), [](const Wire& a, const Wire& b) {
        return WireEnds{a.from, a.to} < WireEnds{b.from, b.to};
    });
    return without_places(std::move(graph));
}

// The curves of the direct wires, in the order of pairs and dials.
std::vector<Curve> curves_of(const BrainGraph& graph, const std::vector<SensorPair>& pairs) {
    std::vector<Curve> curves;
    for (const SensorPair& pair : pairs)
        for (const Dial dial : weight_dials) {
            const auto ends = direct_ends(graph, dial, pair);
            const auto wire = std::find_if(graph.wires.begin(), graph.wires.end(), [&](const Wire& w) {
                return ends && w.from == ends->from && w.to == ends->to;
            });
            curves.push_back(wire == graph.wires.end() ? Curve{} : wire->curve);
        }
    return curves;
}

// True if errors of copies can turn one brain into the other.
bool differ_by_errors_only(BrainGraph a, BrainGraph b, const Mutation& mutation) {
    for (BrainGraph* graph : {&a, &b}) {
        for (Wire& wire : graph->wires) {
            if (mutation.weights) wire.weight = 0;
            if (mutation.thresholds) wire.threshold = 0;
        }
        for (Node& node : graph->nodes)
            if (mutation.biases) node.bias = 0;
        if (mutation.rewiring > 0) graph->wires.clear();
    }
    return same_wiring(a, b);
}

// True if both lists have the same sensors but for their values.
bool same_but_for_values(const std::vector<Sensor>& a, const std::vector<Sensor>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Sensor& one, const Sensor& other) {
        return one.name == other.name && one.channel == other.channel;
    });
}

}  // namespace

Submission as_shipped(const Exercise& exercise) { return submission_of(shipped_kind(exercise)); }

Submission with_brain(const Exercise& exercise, BrainGraph brain) {
    Submission submission = as_shipped(exercise);
    submission.brain = std::move(brain);
    return submission;
}

Submission with_solution(const Exercise& exercise) { return exercise.solution.submission; }

Submission submission_of(const Exercise& exercise, const Snapshot& now) {
    const auto subject = std::find_if(now.vehicles.begin(), now.vehicles.end(),
                                      [](const VehicleView& vehicle) { return vehicle.start == 0; });
    const auto index =
        static_cast<std::size_t>(subject == now.vehicles.end() ? subject_kind(exercise.scene) : subject->kind);
    if (index >= now.scene->kinds.size()) return as_shipped(exercise);  // the kind was removed
    const BrainGraph& brain = subject == now.vehicles.end() ? *now.kind_brains[index] : *brain_of(now, *subject);
    const Kind& kind = subject == now.vehicles.end() ? now.scene->kinds[index] : kind_of(now, *subject);
    return {brain, kind.sensors, kind.body};
}

Scene scene_with(const Exercise& exercise, const Submission& submission) {
    Scene scene = exercise.scene;
    Kind& kind = scene.kinds[static_cast<std::size_t>(subject_kind(scene))];
    kind = with_submission(std::move(kind), submission);
    return scene;
}

std::optional<Offer> parse_offer(std::string_view text) {
    Offer offer{std::string(text), {}};
    constexpr std::string_view of_breeding = "breeding:";
    const bool names_breeding = text.starts_with(of_breeding) && text.size() > of_breeding.size();
    if (contains(offer_parts::all, text) || names_breeding) return offer;
    while (true) {
        const std::size_t end = std::min(text.find('='), text.size());
        const auto dial = dial_named(text.substr(0, end));
        if (!dial) return std::nullopt;
        offer.dials.push_back(*dial);
        if (end == text.size()) return offer;
        text.remove_prefix(end + 1);
    }
}

bool offers_all(const Exercise& exercise) { return exercise.offers.empty(); }

bool offers(const Exercise& exercise, Dial dial) {
    return offers_all(exercise) ||
           std::any_of(exercise.offers.begin(), exercise.offers.end(), [&](const std::string& text) {
               const auto offer = parse_offer(text);
               return offer && contains(offer->dials, dial);
           });
}

bool offers(const Exercise& exercise, std::string_view part) {
    return offers_all(exercise) || contains(exercise.offers, part);
}

std::string_view offered_breeding(const Exercise& exercise) {
    constexpr std::string_view stem = "breeding:";
    for (const std::string& offer : exercise.offers)
        if (offer.starts_with(stem)) return std::string_view(offer).substr(stem.size());
    return {};
}

std::vector<Offer> offered_dials(const Exercise& exercise) {
    std::vector<Offer> dials;
    for (const std::string& text : exercise.offers)
        if (auto offer = parse_offer(text); offer && !offer->dials.empty()) dials.push_back(std::move(*offer));
    return dials;
}

bool is_same_submission(const Submission& a, const Submission& b) {
    return a.sensors == b.sensors && a.body == b.body && sorted_by_ids(a.brain) == sorted_by_ids(b.brain);
}

bool is_edited(const Exercise& exercise, const Submission& submission) {
    return !is_same_submission(submission, as_shipped(exercise));
}

std::vector<std::string> outside_offers(const Exercise& exercise, const Submission& submission) {
    std::vector<std::string> outside;
    if (offers_all(exercise)) return outside;
    const Submission shipped = as_shipped(exercise);
    if (submission.body != shipped.body) outside.emplace_back("body");
    const bool allows_values =
        offers(exercise, offer_parts::sensors) && same_but_for_values(submission.sensors, shipped.sensors);
    if (submission.sensors != shipped.sensors && !allows_values) outside.emplace_back(offer_parts::sensors);
    if (offers(exercise, offer_parts::wiring)) return outside;
    if (offers(exercise, offer_parts::selection) &&
        differ_by_errors_only(submission.brain, shipped.brain, exercise.selection.mutation))
        return outside;
    const std::vector<SensorPair> pairs = pairs_of(shipped.sensors);
    for (const Dial dial : all_dials)
        if (!offers(exercise, dial) && differs(submission.brain, shipped.brain, dial, pairs))
            outside.emplace_back(name(dial));
    if (!offers(exercise, offer_parts::curves) && curves_of(submission.brain, pairs) != curves_of(shipped.brain, pairs))
        outside.emplace_back(offer_parts::curves);
    if (without_dials(submission.brain, pairs) != without_dials(shipped.brain, pairs))
        outside.emplace_back(offer_parts::wiring);
    return outside;
}

int changed_controls(const Exercise& exercise, const Submission& submission) {
    const Submission shipped = as_shipped(exercise);
    const std::vector<SensorPair> pairs = pairs_of(shipped.sensors);
    int changed = submission.sensors != shipped.sensors;
    changed += curves_of(submission.brain, pairs) != curves_of(shipped.brain, pairs);
    for (const Offer& offer : offered_dials(exercise))
        changed += std::any_of(offer.dials.begin(), offer.dials.end(),
                               [&](Dial dial) { return differs(submission.brain, shipped.brain, dial, pairs); });
    return changed;
}

bool changes_too_many(const Exercise& exercise, const Submission& submission) {
    return exercise.changes > 0 && changed_controls(exercise, submission) > exercise.changes;
}

bool keeps_to_offers(const Exercise& exercise, const Submission& submission) {
    return outside_offers(exercise, submission).empty() && !changes_too_many(exercise, submission);
}

}  // namespace braitenlab
