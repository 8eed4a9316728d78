#include "ui/panels/prompt_change.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "core/brain/four_neurons.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompt_run.h"

namespace braitenlab::ui {

namespace {

// The value of the sensor of this name among those of all; 0 if there is none.
float value_of(std::string_view sensor, const std::vector<Sensor>& sensors, std::span<const float> values) {
    for (std::size_t i = 0; i < std::min(sensors.size(), values.size()); ++i)
        if (sensors[i].name == sensor) return values[i];
    return 0;
}

// A weight with the slider that turns it.
struct TellingWeight {
    Dial dial;
    std::string_view slider;
};

// The weight of a sensor that reads something, more than the threshold of the wire, so that turning it has an effect:
// preferably of a wire, that is a weight that is not 0, and only one that `suits`. An empty slider if there is none.
// `values`: of the vehicle's sensors.
template <class Suits>
std::string_view telling_slider(const Snapshot& now, const VehicleView& vehicle, const SensorPair& pair,
                                std::span<const float> values, Suits suits) {
    constexpr TellingWeight weights[]{
        {Dial::LL, "slider.LL"}, {Dial::LR, "slider.LR"}, {Dial::RL, "slider.RL"}, {Dial::RR, "slider.RR"}};
    const FourNeurons dials = read_dials(*brain_of(now, vehicle), pair);
    const auto& sensors = kind_of(now, vehicle).sensors;
    const float left = value_of(pair.left, sensors, values), right = value_of(pair.right, sensors, values);
    for (const bool is_wire : {true, false})
        for (const TellingWeight& each : weights) {
            const float seen = each.dial == Dial::LL || each.dial == Dial::RL ? left : right;
            if (seen >= std::max(sees_nothing, at(dials, threshold_of(each.dial))) &&
                (at(dials, each.dial) != 0) == is_wire && suits(each.dial))
                return each.slider;
        }
    return {};
}

constexpr float gains_something = 0.02f;  // share of what the run lacks

// The dials of the offered control that gains most for the present brain; empty if none is known to gain anything.
std::vector<Dial> most_gaining(const LabView& view) {
    const std::vector<float> gains = view.lesson->gains.value_or(std::vector<float>{});
    const auto most = std::max_element(gains.begin(), gains.end());
    const auto offers = offered_dials(*view.lesson->exercise);
    const auto index = static_cast<std::size_t>(most - gains.begin());
    if (most == gains.end() || *most < gains_something || index >= offers.size()) return {};
    return offers[index].dials;
}

// True if turning the dial changes the vehicle now: a bias, or of an eye that sees enough for the wire's threshold.
// `values`: of the vehicle's sensors.
bool has_effect(const Snapshot& now, const VehicleView& vehicle, const SensorPair& pair, std::span<const float> values,
                Dial dial) {
    if (is_bias(dial)) return true;
    const FourNeurons dials = read_dials(*brain_of(now, vehicle), pair);
    const auto& sensors = kind_of(now, vehicle).sensors;
    for (const Dial weight : weight_dials) {
        if (dial != weight && dial != threshold_of(weight)) continue;
        const bool is_left = weight == Dial::LL || weight == Dial::RL;
        const float seen = value_of(is_left ? pair.left : pair.right, sensors, values);
        return seen >= (is_weight(dial) ? std::max(sees_nothing, at(dials, threshold_of(weight))) : sees_nothing);
    }
    return false;
}

// Both biases, first the one that a hint of the exercise points at.
std::array<Dial, 2> biases_to_try(const Exercise& exercise) {
    const auto is_hinted = [&](Dial bias) {
        return std::any_of(exercise.hints.begin(), exercise.hints.end(),
                           [&](const Hint& hint) { return hint.anchor == anchor_of(bias); });
    };
    return is_hinted(Dial::RM) && !is_hinted(Dial::LM) ? std::array{Dial::RM, Dial::LM}
                                                       : std::array{Dial::LM, Dial::RM};
}

// Of the controls that the exercise offers, the one that brings the vehicle nearest to the goal. Where no single one is
// known to, one whose effect the user sees at once: a weight of an eye that sees something, a bias, the peak of the
// curves of such an eye, or the sensors, if they see nothing.
Prompt offered_change(const LabView& view, const VehicleView& vehicle) {
    if (is_held(view, vehicle) || !view.lesson->gains) return {};
    const Exercise& exercise = *view.lesson->exercise;
    const std::string_view hint = view.mode == Mode::playing ? "hint.turn_slider" : "hint.turn_slider_paused";
    if (const auto dials = most_gaining(view); !dials.empty()) {
        const bool is_seen = std::any_of(dials.begin(), dials.end(), [&](Dial dial) {
            return has_effect(*view.now, vehicle, shown_pair(view, vehicle), readings(*view.now, vehicle), dial);
        });
        return {anchor_of(dials.front()), is_seen ? hint : "hint.change_then_reset"};
    }
    const auto is_offered_dial = [&](Dial dial) { return offers(exercise, dial); };
    if (const auto slider = telling_slider(*view.now, vehicle, shown_pair(view, vehicle), readings(*view.now, vehicle),
                                           is_offered_dial);
        !slider.empty())
        return {slider, hint};
    for (const Dial bias : biases_to_try(exercise))
        if (offers(exercise, bias)) return {anchor_of(bias), hint};
    const bool sees = !is_blind(*view.now, vehicle);
    if (sees && offers(exercise, offer_parts::curves)) return {"curve.peak", hint};
    if (!sees && offers(exercise, offer_parts::sensors)) return {"card.sensors", "hint.turn_sensors"};
    if (offers(exercise, offer_parts::wiring)) return {"button.wiring", "hint.open_wiring"};
    return {};
}

// True if the dial of this vehicle has the value of the file: it is not tried yet.
bool is_untried(const LabView& view, const VehicleView& vehicle, const SensorPair& pair, Dial dial) {
    const Kind* filed = filed_kind(view, vehicle);
    return !filed ||
           at(read_dials(filed->brain, pair), dial) == at(read_dials(*brain_of(*view.now, vehicle), pair), dial);
}

}  // namespace

const SourceView* telling_lamp(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle) return nullptr;
    const auto& sensors = kind_of(*view.now, *vehicle).sensors;
    for (const SourceView& lamp : view.now->sources)
        for (const Sensor& sensor : sensors)
            if (is_seen_as(lamp.channel, sensor.channel)) return &lamp;
    return nullptr;
}

Prompt first_change(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle) return {};
    const bool plays = view.mode == Mode::playing;
    if (offers_some(view)) return offered_change(view, *vehicle);
    const auto any = [](Dial) { return true; };
    if (const auto slider =
            telling_slider(*view.now, *vehicle, shown_pair(view, *vehicle), readings(*view.now, *vehicle), any);
        !slider.empty())
        return {slider, plays ? "hint.turn_slider" : "hint.turn_slider_paused"};
    if (!view.lesson && is_blind(*view.now, *vehicle) && telling_lamp(view)) return {lamp_anchor, "hint.lamp_nearer"};
    return {};
}

Prompt change_for_next_run(const PromptMemory& memory, const LabView& view) {
    const VehicleView *subject = subject_of(view), *selected = selected_vehicle(view);
    if (!subject || !selected || selected->kind != subject->kind) return {};
    const std::string_view hint = view.now->tick == 0 ? "hint.change_then_play" : "hint.change_then_reset";
    const auto& read = memory.most_read;
    const bool saw = std::any_of(read.begin(), read.end(), [](float value) { return value >= sees_nothing; });
    const auto is_offered_dial = [&](Dial dial) { return is_offered(view, dial); };
    if (const auto dials = most_gaining(view); !dials.empty()) return {anchor_of(dials.front()), hint};
    if (!saw && !read.empty() && is_offered(view, offer_parts::sensors)) return {"card.sensors", "hint.turn_sensors"};
    const SensorPair pair = shown_pair(view, *selected);
    const auto is_new = [&](Dial dial) { return is_offered(view, dial) && is_untried(view, *selected, pair, dial); };
    const auto bias_that = [&](auto suits) {
        for (const Dial bias : biases_to_try(*view.lesson->exercise))
            if (suits(bias)) return anchor_of(bias);
        return std::string_view();
    };
    const auto weight_that = [&](auto suits) { return telling_slider(*view.now, *selected, pair, read, suits); };
    const bool needs_bias = memory.halted_blind;
    for (const std::string_view anchor :
         {needs_bias ? bias_that(is_new) : std::string_view(), weight_that(is_new), bias_that(is_new),
          needs_bias ? bias_that(is_offered_dial) : std::string_view(), weight_that(is_offered_dial),
          bias_that(is_offered_dial)})
        if (!anchor.empty()) return {anchor, hint};
    if (saw && is_offered(view, offer_parts::curves)) return {"curve.peak", hint};
    for (const Dial threshold : {Dial::threshold_LL, Dial::threshold_LR, Dial::threshold_RL, Dial::threshold_RR})
        if (saw && is_offered(view, threshold)) return {anchor_of(threshold), hint};
    if (is_offered(view, offer_parts::wiring)) return {"button.wiring", hint};
    if (is_offered(view, offer_parts::selection)) return {"selection.open", "hint.open_children"};
    return {};
}

}  // namespace braitenlab::ui
