// The parts of the card of the map of behaviour: the choices beside its field, the field, and the words below it.
#pragma once

#include <string>
#include <vector>

#include "core/insight/axis_value.h"
#include "ui/lab_view.h"
#include "ui/map_look.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// True while a lecture shows the map: it has the room of the values, of the scene's card and of that of two brains.
bool shows_map_of_lecture(const LabView&);

// What all parts read. The pointers are never null.
struct MapFrame {
    const LabView& view;
    const MapView& map;
    MapState& state;
    SliderState& sliders;
    Ui& ui;
    const insight::ValueSubject& subject;
    const std::vector<insight::AxisValue>& values;
    const insight::AxisValue *x, *y;

    int size() const { return map.cells->size; }
    // A value on the axis between its ends, as a share 0..1 of the field, and back.
    float share_of(const insight::MapAxis&, float value) const;
    float value_of(const insight::MapAxis&, float share) const;  // rounded for a drag
    insight::MapPlace cell_of_now() const;                       // that of the present values
};

// "45°", "3.2 m", with as many decimals as a step of the map needs.
std::string value_words(const Ui&, const insight::AxisValue&, const insight::MapAxis&, float value);
std::string measure_words(const Ui&, insight::MapMeasure);

// map_choices.cpp: the vertical axis and what is shown, above the field; the horizontal axis below it, between its
// ends. An unfolded list follows its row. `left`, `width`: of the card's content, window pixels. Anchors of the ends of
// the axes: map.x.low, map.x.high, map.y.low, map.y.high.
void map_upper_row(const MapFrame&, float width);
void map_lower_row(const MapFrame&, Rect field, float left, float width);

// The ends of the vertical axis at the left of the field, and the width that they need there, window pixels.
float map_ends_width(const MapFrame&);
void map_vertical_ends(const MapFrame&, Rect field);

inline Colour as_colour(MapColour c) { return {c.r, c.g, c.b, 1}; }

// map_field.cpp. Draws it at the cursor and sets MapState::hovered. Anchors: map, map.dot.
void map_field(const MapFrame&, float side);
void draw_map_mark(ImDrawList&, Rect, insight::Behaviour, MapColour on);

// map_legend.cpp: what the cell under the pointer shows, else that of the present values, or how these differ from
// every cell; then the colours.
void map_words(const MapFrame&, float width);
// Of map_words() without a cell under the pointer, window pixels.
float map_words_height(const MapFrame&, float width);
void map_legend(const MapFrame&, float width);
int map_legend_rows(const MapFrame&);

// The kinds in one column beside the field, for a lecture, where the height is short. Words are shortened where the
// width is below map_legend_width().
inline constexpr float beside_field = 12;  // layout pixels
float map_legend_width(const MapFrame&);
void map_legend_beside(const MapFrame&, Rect field, float width);

}  // namespace braitenlab::ui
