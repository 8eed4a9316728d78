// Text, shapes and icons on Dear ImGui's draw list.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "core/scene/scene.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// Icons of Fork Awesome, by their meaning here.
namespace icon {
inline constexpr std::string_view play = "\uf04b", pause = "\uf04c", step = "\uf051", reset = "\uf049",
                                  new_population = "\uf074", add = "\uf067", remove = "\uf068", follow = "\uf05b",
                                  sensors = "\uf06e", view = "\uf278", outlines = "\uf247", wiring = "\uf0e8",
                                  exit = "\uf08b", slower = "\uf04a", faster = "\uf04e", hint = "\uf0eb",
                                  unfolded = "\uf107", folded = "\uf105", warning = "\uf071", check = "\uf00c",
                                  cross = "\uf00d", presets = "\uf02d", open = "\uf07c", clock = "\uf017",
                                  mirror = "\uf042", cross_over = "\uf0ec", drive = "\uf11b", save = "\uf0c7",
                                  load = "\uf115", chart = "\uf201", heal = "\uf0fa", enlarge = "\uf065",
                                  bookmark = "\uf02e", folder = "\uf07b", file = "\uf15b", notice = "\uf05a",
                                  undo = "\uf0e2", previous = "\uf104", next = "\uf105", map = "\uf00a",
                                  robot = "\uf2db";
// Of the channels.
inline constexpr std::string_view light = "\uf185", heat = "\uf06d", smell = "\uf069", oxygen = "\uf06c",
                                  obstacle = "\uf1b2", predator = "\uf0d8", prey = "\uf111", vehicle = "\uf1b9",
                                  memory = "\uf041", touch = "\uf256", floor = "\uf018", energy = "\uf0e7",
                                  random = "\uf074";
}  // namespace icon

enum class Face { text, strong, title, small, label, display, caption };

// The font of a face; Dear ImGui's current font when none was loaded. In a lecture labels have that of small text.
ImFont* font(const Ui&, Face);

// Window pixels.
float line_height(const Ui&, Face);
float text_width(const Ui&, Face, std::string_view);

// Text with its upper left corner at `at`. Returns its width.
float put(const Ui&, ImVec2 at, std::string_view, Colour, Face = Face::text);

// As put(), with the right end or the middle at at.x.
void put_right(const Ui&, ImVec2 at, std::string_view, Colour, Face = Face::text);
void put_centred(const Ui&, ImVec2 at, std::string_view, Colour, Face = Face::text);

// As put(), on this draw list and without a limit of the card; wrapped at `wrap` window pixels (0: not).
void put_on(ImDrawList&, const Ui&, ImVec2 at, std::string_view, Colour, Face, float wrap = 0);

// Records a text that a caller draws itself, `pixels` high, for Ui::written.
void record_text(const Ui&, const ImDrawList&, Rect, std::string_view, float pixels);

// The text, shortened with an ellipsis to `width` window pixels.
std::string shortened(const Ui&, std::string_view, Face, float width);
// The same for the first sentence only; it ends before the last comma, colon or semicolon that fits, unless less than a
// third of the width is used then.
std::string shortened_first_sentence(const Ui&, std::string_view, Face, float width);

// The words with a line break wherever a line would become wider than `width` window pixels: at spaces only, where
// Dear ImGui would also break a number after its decimal mark. Words without such a number are returned as they are.
std::string wrapped_at_spaces(const Ui&, Face, std::string_view words, float width);

// The words in lines no wider than `width` window pixels, broken at spaces and at the text's own line ends.
std::vector<std::string> lines_of_words(const Ui&, std::string_view words, Face, float width);

// The same in as many lines, which are as short as this number allows: none has a word alone where a longer line can
// give it another one.
std::vector<std::string> even_lines(const Ui&, std::string_view words, Face, float width);
// Draws the words in at most `most` lines; the last one is shortened where they need more. Returns true if all words
// are shown.
bool put_lines(const Ui&, ImVec2 at, std::string_view words, Colour, Face, float width, std::size_t most);

// Text as an item at the cursor, wrapped at `width` window pixels (0: at the card's edge).
void paragraph(Ui&, std::string_view, Colour, Face = Face::text, float width = 0);
// The same in even_lines().
void even_paragraph(Ui&, std::string_view, Colour, Face = Face::text, float width = 0);

// The translation of a text of a scene or exercise, from exercises/words/*.toml; the text itself where there is none.
std::string_view translated(const Ui&, std::string_view words);

// True when the icon font is loaded; otherwise widgets show words.
bool has_icons(const Ui&);

// An icon with its middle at `middle`; does nothing without the icon font.
void put_icon(const Ui&, ImVec2 middle, std::string_view, Colour, Face = Face::text);

// The corners of a rectangle: by the radii of the theme, or round ends with half the shorter side as radius.
enum class Corner { square, bar, box, round };

// A filled and an outlined rectangle with rounded corners.
void fill_box(const Ui&, Rect, Colour, Corner = Corner::box);
void line_box(const Ui&, Rect, Colour, Corner = Corner::box, float layout_thickness = 1);

// A soft shadow: so many rings, each `step` layout pixels wider than the last, each with this share of the palette's
// shadow. Only what a box of the same corners does not cover is drawn.
struct Shadow {
    int rings;
    float step, share;
};
void shadow_box(const Ui&, ImDrawList&, Rect, Corner, Shadow);

// The sign of a role: wedge for predators, disc for prey, square for others. `size` in window pixels.
void put_role(const Ui&, ImVec2 middle, float size, Role);  // in the colour of the role
void put_role(const Ui&, ImVec2 middle, float size, Role, Colour);

// Orange for a positive (excitatory) weight, blue for a negative one, grey for 0.
Colour colour_of_weight(const Palette&, float weight);

// The text with its arrows replaced by those of the icon font, which have the size of other key names. Unchanged
// without the icon font.
std::string with_large_arrows(const Ui&, std::string text);

inline constexpr float side_padding = spacing::large;  // layout pixels, of a card
inline constexpr float card_scrollbar_inset = 3;       // layout pixels, from the edge of a card

// The width of the body of the card that is drawn, without padding and scrollbar, window pixels.
float card_width(const Ui&);

}  // namespace braitenlab::ui
