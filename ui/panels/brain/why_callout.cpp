// The callout beside the selected vehicle: the cause of its turn in a sentence, and a bar for the part of each sensor.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/brain/brain.h"
#include "core/insight/origin.h"
#include "core/maths/angle.h"
#include "core/scene/sensor_edits.h"
#include "render/view/drawing.h"
#include "ui/panels/panels.h"
#include "ui/scene_input/draw.h"
#include "ui/widgets/card.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Layout pixels.
constexpr float narrowest_callout = 190, widest_callout = 250, callout_pad = spacing::medium,
                between_parts = spacing::small, callout_row = spacing::tight, least_bar = 28, from_vehicle = 54;
constexpr std::size_t most_why_bars = 4;
constexpr float shown_as_zero = insight::least_part;

struct WhyBar {
    std::string words;
    float value = 0;  // positive: towards the turn
};

struct WhyCallout {
    std::vector<std::string> lines, cause;  // then the bars, then the footnote
    std::vector<WhyBar> bars;
    std::vector<std::string> footnote;
};

// The largest parts stay the first ones, but in the order of the sensors, so that no row changes its place in a run.
void keep_order(insight::Why& why, const std::vector<Sensor>& sensors) {
    const auto place = [&](const insight::SensorPart& part) {
        return std::find_if(sensors.begin(), sensors.end(),
                            [&](const Sensor& each) { return each.name == part.sensor; }) -
               sensors.begin();
    };
    const auto end = why.sensors.begin() + static_cast<std::ptrdiff_t>(std::min(most_why_bars, why.sensors.size()));
    std::sort(why.sensors.begin(), end,
              [&](const insight::SensorPart& a, const insight::SensorPart& b) { return place(a) < place(b); });
}

// The largest parts of sensors, the bias, and a rest that holds the other sensors, too.
std::vector<WhyBar> why_bars(const LabView& view, const Ui& ui, const VehicleView& vehicle, const insight::Why& why,
                             float towards) {
    const std::vector<Sensor>& sensors = kind_of(*view.now, vehicle).sensors;
    std::vector<WhyBar> bars;
    float rest = why.rest;
    for (std::size_t i = 0; i < why.sensors.size(); ++i) {
        const insight::SensorPart& part = why.sensors[i];
        if (i >= most_why_bars) {
            rest += part.value;
            continue;
        }
        const Sensor* sensor = find_sensor(sensors, part.sensor);
        bars.push_back({sensor ? sensor_label(ui, sensors, *sensor) : part.sensor, part.value * towards});
    }
    bars.push_back({std::string(ui.strings("why.bias")), why.bias * towards});
    bars.push_back({std::string(ui.strings("why.rest")), rest * towards});  // last, see main_cause()
    return bars;
}

// The name of the source or vehicle that the sensor reads most of, as the scene shows it; empty if there is none.
std::string origin_words(const LabView& view, const Ui& ui, const VehicleView& vehicle, const std::string& name) {
    const Sensor* sensor = find_sensor(kind_of(*view.now, vehicle).sensors, name);
    const auto origin = sensor ? insight::main_origin(*view.now, vehicle, *sensor) : std::nullopt;
    if (!origin) return {};
    if (const VehicleView* other = find_vehicle(*view.now, origin->vehicle))
        return kind_name(view, ui, *other) + " " + std::to_string(other->id + 1);
    const auto index = static_cast<std::size_t>(origin->source);
    if (index >= view.now->scene->sources.size()) return {};
    return shown_name(ui.strings, view.now->scene->sources[index].name);
}

// "Mostly …" of the largest part towards the turn; empty if none is shown as more than 0.
std::string main_cause(const LabView& view, const Ui& ui, const VehicleView& vehicle, const insight::Why& why,
                       const std::vector<WhyBar>& bars) {
    std::vector<float> parts;
    for (const WhyBar& bar : bars) parts.push_back(bar.value);
    const auto main = insight::main_part(parts);
    if (!main) return {};
    const std::size_t largest = *main;
    const WhyBar& bar = bars[largest];
    const std::string value = with_sign(ui, bar.value, 2);
    if (largest + 2 == bars.size()) return fill(ui.strings("why.mostly_bias"), {value});
    if (largest + 1 == bars.size()) return fill(ui.strings("why.mostly_rest"), {value});
    const insight::SensorPart& part = why.sensors[largest];
    const std::string reading = fixed(ui, part.reading, 2);
    const std::string origin = origin_words(view, ui, vehicle, part.sensor);
    return origin.empty() ? fill(ui.strings("why.mostly"), {bar.words, reading, value})
                          : fill(ui.strings("why.mostly_of"), {bar.words, reading, origin, value});
}

// True if the wheels push the vehicle forwards or backwards and it does not move.
bool is_blocked(const LabView& view, const VehicleView& vehicle, const insight::Why& why) {
    return stands_still(view, vehicle) && wheels_push(why.left, why.right);
}

WhyCallout callout_of(const LabView& view, const Ui& ui, const VehicleView& vehicle, const insight::Why& why,
                      float width) {
    const float difference = why.right - why.left;
    const bool turns = !insight::are_alike(why.left, why.right);
    WhyCallout callout;
    callout.bars = why_bars(view, ui, vehicle, why, turns && difference < 0 ? -1.0f : 1.0f);
    const bool rests = std::fabs(why.left) < shown_as_zero && std::fabs(why.right) < shown_as_zero;
    const bool stuck = view.mode == Mode::playing && is_blocked(view, vehicle, why);
    std::string sentence(ui.strings(rests ? "sums.still" : alike_key(why.left, stuck)));
    if (turns)
        sentence = fill(ui.strings(difference > 0 ? "why.turns_left" : "why.turns_right"),
                        {fixed(ui, std::fabs(difference), 2)});
    if (turns && is_blocked(view, vehicle, why)) sentence += " " + std::string(ui.strings("why.blocked"));
    callout.lines = lines_of_words(ui, sentence, Face::text, width);
    const std::string cause = turns ? main_cause(view, ui, vehicle, why, callout.bars) : std::string();
    for (const std::string& line : lines_of_words(ui, cause, Face::small, width))
        if (!line.empty()) callout.cause.push_back(line);
    const auto is_nothing = [](const WhyBar& bar) { return std::fabs(bar.value) < shown_as_zero; };
    if (is_nothing(callout.bars.back()))
        callout.bars.pop_back();
    else
        callout.footnote = lines_of_words(ui, ui.strings("why.rest_means"), Face::small, width);
    if (std::all_of(callout.bars.begin(), callout.bars.end(), is_nothing))
        callout.bars.clear();  // the sentence says it
    if (why.ticks > 0 && !callout.bars.empty()) {
        const std::string seconds = fixed(ui, static_cast<float>(why.ticks) * tick_seconds, 1);
        for (std::string& line : lines_of_words(ui, fill(ui.strings("why.silenced"), {seconds}), Face::small, width))
            callout.footnote.push_back(std::move(line));
    }
    return callout;
}

float callout_height(const Ui& ui, const WhyCallout& callout) {
    const float row = line_height(ui, Face::small) + ui.px(callout_row);
    return ui.px(2 * callout_pad + 6) + static_cast<float>(callout.lines.size()) * line_height(ui, Face::text) +
           static_cast<float>(callout.cause.size() + callout.bars.size() + !callout.bars.empty() +
                              callout.footnote.size()) *
               row;
}

// The widest words beside a bar.
float width_of_words(const Ui& ui, const WhyCallout& callout) {
    float width = text_width(ui, Face::small, ui.strings("why.total"));
    for (const WhyBar& bar : callout.bars) width = std::max(width, text_width(ui, Face::small, bar.words));
    return width;
}

// The width of the callout without its border in which the words beside the bars are whole.
float bars_width(const Ui& ui, const WhyCallout& callout) {
    if (callout.bars.empty()) return 0;
    return width_of_words(ui, callout) + text_width(ui, Face::small, with_sign(ui, -1, 2)) + ui.px(least_bar) +
           2 * ui.px(between_parts);
}

// A bar from the middle of `room` and its number, right of it. The longest bar fills half of the room.
void draw_why_bar(const Ui& ui, Rect room, const WhyBar& bar, float longest) {
    const Palette& p = ui.palette;
    const float middle = room.x + room.w / 2, reach = room.w / 2 * bar.value / std::max(longest, 0.05f);
    fill_box(ui, {middle, room.y, ui.px(1), room.h}, p.line, Corner::square);
    if (std::fabs(reach) >= 1)
        fill_box(ui, {std::min(middle, middle + reach), room.y + room.h * 0.2f, std::fabs(reach), room.h * 0.6f},
                 colour_of_weight(p, bar.value), Corner::bar);
}

void draw_callout(const Ui& ui, const WhyCallout& callout, ImVec2 at, float width) {
    const Palette& p = ui.palette;
    float y = at.y;
    for (const std::string& line : callout.lines)
        put(ui, {at.x, y}, line, p.text, Face::text), y += line_height(ui, Face::text);
    for (const std::string& line : callout.cause)
        put(ui, {at.x, y += ui.px(callout_row)}, line, p.text, Face::small), y += line_height(ui, Face::small);
    if (callout.bars.empty()) return;
    y += ui.px(6);
    float longest = 0, sum = 0;
    for (const WhyBar& bar : callout.bars) longest = std::max(longest, std::fabs(bar.value)), sum += bar.value;
    const float height = line_height(ui, Face::small), number = text_width(ui, Face::small, with_sign(ui, -1, 2));
    const float room = std::max(ui.px(least_bar), std::min(0.24f * width, width - number - width_of_words(ui, callout) -
                                                                              2 * ui.px(between_parts)));
    const float bars = at.x + width - number - room - ui.px(between_parts);
    const auto row = [&](const WhyBar& bar, Colour colour) {
        put(ui, {at.x, y}, shortened(ui, bar.words, Face::small, bars - at.x - ui.px(between_parts)), colour,
            Face::small);
        put_right(ui, {at.x + width, y}, with_sign(ui, bar.value, 2), colour, Face::small);
    };
    for (const WhyBar& bar : callout.bars) {
        row(bar, p.text);
        draw_why_bar(ui, {bars, y, room, height}, bar, longest);
        y += height + ui.px(callout_row);
    }
    fill_box(ui, {at.x, y - ui.px(callout_row / 2), width, ui.px(1)}, p.line, Corner::square);
    row({std::string(ui.strings("why.total")), sum}, p.second_text);
    for (const std::string& line : callout.footnote)
        put(ui, {at.x, y += height + ui.px(callout_row)}, line, p.second_text, Face::small);
}

// A box behind the vehicle as seen on the screen, else ahead of it, below or above, within the area and without
// covering the vehicle; of these places the first one that covers the fewest lamps
// and other vehicles of a comparison.
Rect place_beside(maths::vec2 vehicle, bool heads_right, maths::vec2 size, float away, Rect area,
                  const std::vector<maths::vec2>& lamps) {
    const auto within = [](float at, float low, float high) {
        return std::floor(std::clamp(at, low, std::max(low, high)));
    };
    const maths::vec2 right{vehicle.x + away, vehicle.y - size.y / 2};
    const maths::vec2 left{vehicle.x - away - size.x, vehicle.y - size.y / 2};
    const float middle = vehicle.x - size.x / 2;
    const auto covered = [&](const Rect& box) {
        return std::count_if(lamps.begin(), lamps.end(), [&](maths::vec2 lamp) {
            return lamp.x > box.x && lamp.x < box.x + box.w && lamp.y > box.y && lamp.y < box.y + box.h;
        });
    };
    std::optional<Rect> best;
    Rect box, farthest;
    float most = -1;  // distance of `farthest` from the vehicle
    for (const maths::vec2 corner : {heads_right ? left : right, maths::vec2{middle, vehicle.y + away},
                                     maths::vec2{middle, vehicle.y - away - size.y}, heads_right ? right : left}) {
        box = {within(corner.x, area.x, area.x + area.w - size.x), within(corner.y, area.y, area.y + area.h - size.y),
               size.x, size.y};
        const float x = std::clamp(vehicle.x, box.x, box.x + box.w), y = std::clamp(vehicle.y, box.y, box.y + box.h);
        const float distance = maths::distance(vehicle, {x, y});
        if (distance > most) most = distance, farthest = box;
        if (distance < 0.8f * away) continue;
        if (!best || covered(box) < covered(*best)) best = box;
    }
    return best.value_or(farthest);  // in a narrow area it may cover the vehicle
}

}  // namespace

void why_callout(const LabView& view, const Ui& ui, Rect area) {
    if (!view.features.why || !view.camera_view || view.mode == Mode::wiring) return;
    const VehicleView* vehicle = find_vehicle(*view.now, view.features.why->vehicle);
    if (!vehicle) return;
    const auto middle = project(*view.camera_view, {vehicle->x, vehicle->y}, render::deck_height);
    if (!middle) return;
    constexpr float share = 0.45f;  // of the area, so that there is room beside the vehicle
    const float border = ui.px(2 * callout_pad);
    float w = std::clamp(share * area.w, ui.px(narrowest_callout), ui.px(widest_callout));
    insight::Why why = *view.features.why;
    keep_order(why, kind_of(*view.now, *vehicle).sensors);
    WhyCallout callout = callout_of(view, ui, *vehicle, why, w - border);
    if (const float wanted = bars_width(ui, callout) + border; wanted > w) {
        w = std::max(w, std::min(wanted, 0.9f * area.w));
        callout = callout_of(view, ui, *vehicle, why, w - border);
    }
    const float length = kind_of(*view.now, *vehicle).body.length;  // the dots of its sums are beside it
    const float reach = 0.8f * length * pixels_per_metre(*view.camera_view, {vehicle->x, vehicle->y});
    const float h = callout_height(ui, callout), away = std::max(ui.px(from_vehicle), reach);
    const auto ahead =
        project(*view.camera_view, maths::vec2{vehicle->x, vehicle->y} + maths::direction(vehicle->heading));
    std::vector<maths::vec2> lamps;
    for (const SourceView& lamp : view.now->sources)
        if (const auto at = project(*view.camera_view, {lamp.x, lamp.y}, render::deck_height)) lamps.push_back(*at);
    if (const auto& b = view.features.slots.b)  // the vehicle beside it in a comparison
        if (const auto at = project(*view.camera_view, {b->pose.x, b->pose.y}, render::deck_height))
            lamps.push_back(*at);
    const Rect box = place_beside(*middle, ahead && ahead->x > middle->x, {w, h}, away, area, lamps);
    draw_line(
        ui,
        {{middle->x, middle->y}, {std::clamp(middle->x, box.x, box.x + w), std::clamp(middle->y, box.y, box.y + h)}},
        ui.palette.accent, 1.5f, false);
    ui.anchors.record("why", box);
    begin_overlay(ui, "why", box, ui.palette.accent);
    draw_callout(ui, callout, {box.x + ui.px(callout_pad), box.y + ui.px(callout_pad)}, w - ui.px(2 * callout_pad));
    end_overlay();
}

}  // namespace braitenlab::ui
