// The strips of the chart card: a row for each signal of the selected vehicle, with its name, its line and its value.
#pragma once

#include <string_view>

#include "ui/lab_view.h"
#include "ui/panels/panel_state.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Adds the signal to the tab "Chosen", unless it is there already or the tab has most_strips.
void choose_strip(PanelState&, std::string_view name);

// Moves a strip of the tab "Chosen" to the place of another one; those between them move up or down by one. Does
// nothing if one of them is not there.
void move_strip(PanelState&, std::string_view name, std::string_view onto);

// The tab "All": every sensor, wheel, neuron and learned weight, in two columns. Those without room are counted.
// Anchors: charts.picture, charts.strip.NAME, charts.name.NAME (the name, which can be dragged to the tab "Chosen"),
// charts.add.NAME.
void all_strips(const LabView&, PanelState&, Ui&, Rect);

// The tab "Chosen": ChartsState::strips that the vehicle has. Anchors: charts.picture, charts.strip.NAME,
// charts.name.NAME (the name, which can be dragged to another strip), charts.remove.NAME.
void chosen_strips(const LabView&, PanelState&, Ui&, Rect);

}  // namespace braitenlab::ui
