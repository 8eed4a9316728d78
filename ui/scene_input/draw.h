// Drawing over the 3D view: rings, handles, previews, and notes at the pointer.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "ui/scene_input/handles.h"

namespace braitenlab::ui {

// On Dear ImGui's background draw list: over the scene, below the cards.
void draw_scene_input(const SceneInputState&, const SceneInputFrame&, const Ui&);

// Parts that the drawings share. A line has a contrasting border, so that it is visible on any floor; a note is beside
// a position, within the area free of cards. Lengths in layout pixels, points in window pixels.
void draw_line(const Ui&, const std::vector<ImVec2>& points, Colour, float width, bool closed);
void draw_dot(const Ui&, ImVec2 at, float radius, Colour, float border = 1.5f);
// A handle, in its middle these words; the anchor is the square of handle_grip within which a press takes it.
void draw_handle(const SceneInputFrame&, const Ui&, maths::vec2 place, bool warm, const std::string& anchor,
                 std::string_view words = {});
// Where a note is. any: below its position; elsewhere where it would leave the scene or cover another label, a vehicle
// or the bulb of a source.
enum class NoteSide { any, below, above };
void draw_note(const SceneInputFrame&, const Ui&, std::string_view words, Colour edge, maths::vec2 beside,
               NoteSide = NoteSide::any);
// The name of something in the scene, at most label_reach from the rectangle around it and with a line to it where it
// is not adjacent. It covers nothing of LabelSpace; without a free place the name is left out. SceneInputFrame::labels
// must be set. `other`: something that has another name; the label is nearer to its own thing where there is room.
inline constexpr float label_reach = 34;
void draw_label(const SceneInputFrame&, const Ui&, std::string_view words, Colour edge, Rect thing,
                NoteSide = NoteSide::any, std::optional<Rect> other = std::nullopt);

}  // namespace braitenlab::ui
