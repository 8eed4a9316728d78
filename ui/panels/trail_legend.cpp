#include "ui/panels/trail_legend.h"

#include <algorithm>
#include <array>
#include <vector>

#include <imgui.h>

#include "ui/panels/panels.h"
#include "ui/widgets/card.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Layout pixels.
constexpr float narrowest_scale = 180, scale_height = 8, pad = spacing::small, from_edge = spacing::medium;

std::vector<TrailColour> choices(const LabView& view) {
    std::vector<TrailColour> all{{}, {TrailValue::wheels}, {TrailValue::speed}};
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle) return all;
    const std::vector<Sensor>& sensors = kind_of(*view.now, *vehicle).sensors;
    for (std::size_t i = 0; i < std::min(sensors.size(), render::recorded_sensors); ++i)
        all.push_back({TrailValue::reading, sensors[i].name});
    return all;
}

// What the ends and the middle of the scale say.
std::array<std::string, 3> numbers_of_scale(const LabView& view, const Ui& ui, TrailValue value) {
    if (value == TrailValue::wheels)
        return {fill(ui.strings("view.trail.left"), {fixed(ui, 1, 0)}), fixed(ui, 0, 0),
                fill(ui.strings("view.trail.right"), {fixed(ui, 1, 0)})};
    const float top = value == TrailValue::speed ? render::top_speed_of(*view.now) : 1;
    return {fixed(ui, 0, 0), fixed(ui, top / 2, 1), fixed(ui, top, 1)};
}

std::string title_of_scale(const LabView& view, const Ui& ui, TrailValue value) {
    if (value == TrailValue::wheels) return std::string(ui.strings("view.trail.wheels_unit"));
    if (value == TrailValue::speed) return std::string(ui.strings("view.trail.speed_unit"));
    return trail_colour_words(view, ui);
}

}  // namespace

TrailColour next_trail_colour(const LabView& view) {
    const std::vector<TrailColour> all = choices(view);
    const auto present = std::find(all.begin(), all.end(), view.settings.overlays.trail_colour);
    return present == all.end() || present + 1 == all.end() ? TrailColour{} : *(present + 1);
}

std::string trail_colour_words(const LabView& view, const Ui& ui) {
    const TrailColour& colour = view.settings.overlays.trail_colour;
    if (colour.value == TrailValue::plain) return std::string(ui.strings("view.trail.plain"));
    if (colour.value == TrailValue::wheels) return std::string(ui.strings("view.trail.wheels"));
    if (colour.value == TrailValue::speed) return std::string(ui.strings("view.trail.speed"));
    std::string words = colour.sensor;
    if (const VehicleView* vehicle = selected_vehicle(view))
        for (const Sensor& sensor : kind_of(*view.now, *vehicle).sensors)
            if (sensor.name == colour.sensor) words = sensor_label(ui, kind_of(*view.now, *vehicle).sensors, sensor);
    return fill(ui.strings("view.trail.reading"), {words});
}

void trail_legend(const LabView& view, const Ui& ui, Rect area) {
    const TrailValue value = view.settings.overlays.trail_colour.value;
    if (value == TrailValue::plain || !view.settings.overlays.trails || view.mode == Mode::wiring) return;
    const std::string title = title_of_scale(view, ui, value);
    const std::array<std::string, 3> numbers = numbers_of_scale(view, ui, value);
    const float space = ui.px(pad), line = line_height(ui, Face::small);
    float numbers_width = 4 * space;
    for (const std::string& number : numbers) numbers_width += text_width(ui, Face::small, number);
    const float inner = std::min(std::max({ui.px(narrowest_scale), text_width(ui, Face::small, title), numbers_width}),
                                 area.w - 2 * space - 2 * ui.px(from_edge));
    const float w = inner + 2 * space, h = 2 * line + ui.px(scale_height) + 3 * space;
    const Rect box{area.x + ui.px(from_edge), area.y + area.h - h - ui.px(from_edge), w, h};
    ui.anchors.record("trail_legend", box);
    begin_overlay(ui, "trail_legend", box, ui.palette.line);
    const float x = box.x + space;
    float y = box.y + space;
    put(ui, {x, y}, shortened(ui, title, Face::small, inner), ui.palette.text, Face::small);
    y += line + space / 2;
    constexpr int steps = 48;
    for (int i = 0; i < steps; ++i) {
        const float from = inner * static_cast<float>(i) / steps, to = inner * static_cast<float>(i + 1) / steps;
        const float share = (static_cast<float>(i) + 0.5f) / steps;
        fill_box(ui, {x + from, y, to - from, ui.px(scale_height)},
                 render::colour_of_share(value, share, view.program.theme), Corner::square);
    }
    y += ui.px(scale_height) + space / 2;
    const float middle = x + (inner - text_width(ui, Face::small, numbers[1])) / 2;
    put(ui, {x, y}, numbers[0], ui.palette.second_text, Face::small);
    put(ui, {middle, y}, numbers[1], ui.palette.second_text, Face::small);
    put_right(ui, {x + inner, y}, numbers[2], ui.palette.second_text, Face::small);
    end_overlay();
}

}  // namespace braitenlab::ui
