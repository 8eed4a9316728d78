// The choice of a value of the scene for an axis of a map or a study: its group, then the values of the group.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/insight/axis_value.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// "LL = RR", "sensor direction", "lamp x".
std::string axis_words(const Ui&, const insight::AxisValue&);

// Draws the choice at the cursor and returns the value that is clicked, or null. `now`: the id of the present one.
// Anchors: BEGIN.group.1 …, BEGIN.ID.
const insight::AxisValue* value_choice(Ui&, const std::vector<insight::AxisValue>&, const std::string& begin,
                                       std::string_view now, insight::ValueGroup&, float width);

// The slider of an end of the value's range, without a unit.
SliderLook end_look(const Ui&, const insight::AxisValue&, bool is_from, float now);

// A small button in a row of such buttons, at a new line where it would pass `right`. True when clicked.
bool choice_in_row(Ui&, const std::string& id, const std::string& words, bool on, bool is_first, float right);

}  // namespace braitenlab::ui
