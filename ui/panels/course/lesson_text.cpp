#include "ui/panels/course/lesson_text.h"

#include <algorithm>

#include "ui/words/measure_text.h"

namespace braitenlab::ui {

namespace {

// The key of what is measured; empty where the unit says it: rounds, contacts.
std::string_view quantity(const Measure& measure) {
    const std::string_view unit = measure.unit;
    if (measure.quantity == "rest") return "exercise.longest_rest";
    if (measure.quantity == "hold") return "exercise.time_held";
    if (measure.quantity == "nearest") return "exercise.smallest_distance";
    if (measure.quantity == "steady") return "exercise.time_steady";
    if (measure.quantity == "path") return "exercise.distance_of_paths";
    if (unit == "m") return "exercise.distance";
    if (unit == "s") return "exercise.time";
    if (unit == "m/s") return "exercise.speed";
    if (unit == "correlation") return "exercise.correlation";
    return unit == "°" ? "exercise.angle" : std::string_view{};
}

}  // namespace

std::string measure_name(const Ui& ui, const Measure& measure) {
    const std::string_view what = quantity(measure);
    const bool is_rest_of_way = measure.at_most && measure.needed == 0;  // "1.44 m to go"
    if (what.empty() || is_rest_of_way) return {};
    // A scene's only source is "lamp" in most exercises; other names tell apart several sources.
    const bool is_named = !measure.source.empty() && measure.source != "lamp";
    const std::string of = is_named ? " (" + shown_name(ui.strings, measure.source) + ")" : std::string();
    return std::string(ui.strings(what)) + of;
}

std::string measure_text(const Ui& ui, const Measure& measure, bool done) {
    const std::string words = measure_text(ui.strings, measure, done), title = measure_name(ui, measure);
    return words.empty() || title.empty() ? words : title + " " + words;
}

Gauge gauge_of(const Measure& measure) {
    const float most = measure.needed_most.value_or(measure.needed), least = measure.at_most ? 0.0f : measure.needed;
    const bool is_limited = measure.at_most || measure.needed_most;
    const float end = most * (measure.needed_most ? 1.5f : measure.at_most ? 3.0f : 1.25f);
    return {least / end, is_limited ? most / end : 1.0f, std::clamp(measure.value / end, 0.0f, 1.0f)};
}

}  // namespace braitenlab::ui
