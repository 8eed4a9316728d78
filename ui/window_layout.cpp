#include "ui/window_layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/panels/exercise_names.h"
#include "ui/panels/map/map_parts.h"
#include "ui/panels/panels.h"
#include "ui/widgets/menu_bar.h"
#include "ui/wiring/layout.h"

namespace braitenlab::ui {

namespace {

// Layout pixels.
constexpr float toolbar_height = 42, hint_height = 32, timeline_height = 50, above_timeline = 8;
constexpr float lecture_bar_height = 56, figures_height = 92, counts_height = 60, live_height = 136,
                lecture_inset_aspect = 1.6f;
constexpr float caption_height = 84, question_share = 0.45f;       // of the width
constexpr float lecture_canvas_share = 0.52f;                      // at least: its weights are legible
constexpr float canvas_share_beside_card = 0.5f;                   // at least, in a lecture
constexpr float canvas_share_of_network = 0.66f;                   // at least, of many nodes: their names are large
constexpr float question_above_card = 0.55f;                       // of the height, at most
constexpr float largest_notes = 0.36f;                             // of the height
constexpr float least_notes = 100;                                 // three lines below the heading
constexpr float column_share = 0.375f, lone_column_share = 0.45f;  // at most, of the width with a margin
constexpr float metre_labels = 16;                                 // below the arena
constexpr float wide_window = 1600;                                // has room for both columns and a watched canvas
constexpr float narrow_window = 1200;                              // a narrower window has narrower cards and margins
constexpr float small_window = 900;                                // below: all cards are in one column
constexpr float tab_width = 156, tab_pitch = 44;                   // of a folded card of a column without an open one
constexpr float scene_aspect = 1.4f;                               // width by height, of most arenas
constexpr float inset_height = 232;
constexpr float upright_scene = 0.4f, upright_diagram = 0.55f;  // of the height between the bars
constexpr float upright_scene_of_finger = 0.34f;                // the answers of a question need the room
constexpr float upright_cards = 300;                            // at least, below the diagram
constexpr float two_row_toolbar = 720;                          // a narrower upright window has two rows of buttons
constexpr float charts_height = 248, low_middle = 560, below_tools = 12;
constexpr float narrow_scene = 520, above_scene = 4;

struct ColumnWidths {
    float margin, left, right;
};

ColumnWidths column_widths(float layout_width, bool lecture) {
    if (layout_width < small_window && !lecture) return {8, 0, 292};
    if (layout_width < narrow_window) return {12, 264, 316};
    return {16, 304, 336};
}

// A card of the left column that was asked for. It takes the room of the watched diagram, and that of the question
// beside the scene, where there is none for both.
bool has_asked_card(const LabView& view) {
    const ViewSettings& shown = view.settings;
    return view.mode != Mode::wiring && (shown.map || shown.reality || (shown.values && !view.lecture));
}

// Takes the strip for the timeline from the bottom of the middle column.
Rect take_timeline(Rect& middle, float scale, float height) {
    const float strip = height * scale;
    middle.h = std::max(0.0f, middle.h - strip - above_timeline * scale);
    return {middle.x, middle.y + middle.h + above_timeline * scale, middle.w, strip};
}

// True for a diagram of many nodes that is shown.
bool shows_network(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    const bool has_brain = vehicle && vehicle->brain >= 0 && vehicle->brain < static_cast<int>(view.now->brains.size());
    return has_brain && !hides_brain(view, vehicle->kind) &&
           brain_of(*view.now, *vehicle)->nodes.size() > wiring::few_nodes;
}

// Gives a part of the scene to the canvas: the right part of a wide scene, else the lower part, because a diagram is
// wider than high. In a lecture, where the scene is low, also the right part of a less wide one; then folded cards of
// the right column are over the scene, and an open one has a column of its own.
void split_for_canvas(WindowLayout& l, const LabView& view, float border, bool card_is_open) {
    const float wide = view.lecture ? 1.5f : 1.9f;  // width by height
    const float least = !view.lecture         ? least_canvas_share
                        : card_is_open        ? canvas_share_beside_card
                        : shows_network(view) ? canvas_share_of_network
                                              : lecture_canvas_share;
    const float share = std::clamp(view.settings.canvas_share, least, largest_canvas_share);
    if (view.lecture && card_is_open && !asked(view)) l.scene.w -= l.right.w + border;
    if (l.scene.w > wide * l.scene.h) {
        const float canvas = (l.scene.w - border) * share;
        l.scene.w -= canvas + border;
        l.border = {l.scene.x + l.scene.w, l.scene.y, border, l.scene.h};
        l.canvas = {l.border.x + border, l.scene.y, canvas, l.scene.h};
        if (view.lecture && !card_is_open) l.right.x = l.border.x - l.right.w;
    } else {
        // As high as the cards of a small brain need for their numbers.
        constexpr float with_numbers = 216, most = 0.56f;  // layout pixels; of the height
        const float least_height = view.lecture ? 0 : std::min(with_numbers * l.scale, most * (l.scene.h - border));
        const float canvas = std::max((l.scene.h - border) * share, least_height);
        l.scene.h -= canvas + border;
        l.border = {l.scene.x, l.scene.y + l.scene.h, l.scene.w, border};
        l.scene.h = std::max(0.0f, l.scene.h - metre_labels * l.scale);
        l.canvas = {l.scene.x, l.border.y + border, l.scene.w, canvas};
    }
}

// Whether the question of a page, or one that is asked without a page, is beside the scene. Once it is answered and the
// page shows its brain, an open card, the diagram or a comparison of two brains takes its place, also while the
// lecturer hides the brain again. A question without a page gives way to a comparison and to a sum in the diagram.
bool asks_beside(const LabView& view, OpenCards open) {
    if (!view.pages) return view.tally && !has_asked_card(view) && !open.sum && view.features.slots.seconds <= 0;
    const LectureView& page = *view.pages;
    const bool is_answered =
        page.shows(PagePart::answer) && (page.shows(PagePart::brain) || view.settings.revealed.brain);
    return page.shows(PagePart::question) && !page.shows(PagePart::exercise) && !has_asked_card(view) &&
           !(is_answered && (open.right || view.settings.watching || view.features.slots.seconds > 0));
}

// In a lecture the type is large: the right column is wider where nothing else is beside the scene.
float right_share(const LabView& view, OpenCards open) {
    if (!view.lecture || view.settings.map) return column_share;
    if (!view.pages) return lone_column_share;
    return asks_beside(view, open) || open.left ? column_share : lone_column_share;
}

// True for an open card of the left column that is alone beside the scene of a lecture: there its type is large.
bool is_lone_left(const LabView& view, OpenCards open) { return view.lecture && open.left && !open.right; }

// True while the open card of an exercise asks for a prediction, outside a lecture file.
bool asks_in_card(const LabView& view, OpenCards open) {
    return !view.pages && open.left && view.lesson && view.may.open_prediction && awaits_prediction(*view.lesson);
}

// The behaviour map of a lecture is read from the last row: it has the width that the scene and an open card leave.
float left_share(const LabView& view, OpenCards open) {
    constexpr float least_scene = 0.25f, beside_map = 0.42f;
    if (!shows_map_of_lecture(view)) return is_lone_left(view, open) ? lone_column_share : column_share;
    return open.right ? 1 - right_share(view, open) - least_scene : 1 - beside_map;
}

// A caption that asks the page's question stays where titles are hidden.
bool has_caption(const LabView& view) {
    const LectureView* page = view.pages;
    if (!page || !page->shows(PagePart::caption) || page->current().caption.empty()) return false;
    const LectureQuestion& asked = page->current().question;
    const bool asks = !asked.options.empty() && asked.text.empty();
    return asks || !hides_open_title(view);
}

// Narrows a column whose cards are all folded, and gives the scene the room beside or below them, whichever shows more.
void fold_columns(WindowLayout& l, OpenCards open, float margin) {
    const float end = l.window.w - margin, wide = tab_width * l.scale;
    const auto below = [&](int folded) { return l.scene.y + static_cast<float>(folded) * tab_pitch * l.scale; };
    const auto shown = [](const Rect& r) { return std::min(r.w, scene_aspect * r.h); };
    const auto cut = [](Rect r, float from, float top, float until) {
        const float bottom = r.y + r.h;
        return Rect{from, top, std::max(0.0f, until - from), std::max(0.0f, bottom - top)};
    };
    if (open.folded_left > 0 && l.left.w > wide) {
        l.left.w = wide;
        const float until = l.scene.x + l.scene.w;
        const Rect beside = cut(l.scene, 2 * margin + wide, l.scene.y, until);
        const Rect under = cut(l.scene, margin, below(open.folded_left), until);
        l.scene = shown(under) > shown(beside) ? under : beside;
    }
    const bool has_guest = open.left && l.left.w <= 0;  // a card of the left column, above those of the right one
    if (open.folded_right > 0 && l.right.w > wide && !has_guest) {
        l.right = {end - wide, l.right.y, wide, l.right.h};
        const Rect beside = cut(l.scene, l.scene.x, l.scene.y, l.right.x - margin);
        const Rect under =
            cut(l.scene, l.scene.x,
                std::max(l.scene.y, l.right.y + static_cast<float>(open.folded_right) * tab_pitch * l.scale), end);
        l.scene = shown(under) > shown(beside) ? under : beside;
    }
}

// The cards of both columns as those of the right one.
OpenCards in_one_column(OpenCards open) {
    open.right |= std::exchange(open.left, false);
    open.folded_right = open.right ? 0 : open.folded_right + open.folded_left;
    open.folded_left = 0;
    return open;
}

// The parts of a page of a lecture: the caption above, and the scene beside the question and the open cards. The
// exercise takes the place of the question, as the sliders do once it is answered; before, an open card is below the
// question. The values below are shown on request only, and so are the notes, which take the place of the values.
void lay_out_page(WindowLayout& l, const LabView& view, OpenCards open, float margin) {
    Rect& s = l.scene;
    const bool has_values = shows_lecture_figures(view) && open.notes <= 0 && l.hint_bar.h > 0;
    const bool asks = asks_beside(view, open);
    const float end = l.window.w - margin;
    float bottom = has_values ? s.y + s.h : l.window.h - margin;
    float top = l.toolbar.y + l.toolbar.h;
    if (has_caption(view)) {
        l.caption = {0, top, l.window.w, caption_height * l.scale};
        top += l.caption.h;
    }
    s.y = top + margin;
    if (open.notes > 0) {  // the question keeps the height that its options need; the notes scroll
        const float left = bottom - s.y - (asks ? open.question + margin : 0);
        const float most =
            std::min({largest_notes * l.window.h, (bottom - s.y - margin) / 2, std::max(left, least_notes * l.scale)});
        l.notes = {margin, bottom, l.window.w - 2 * margin, std::min(open.notes, most)};
        l.notes.y -= l.notes.h;
        bottom = l.notes.y - margin;
    }
    s.h = std::max(0.0f, bottom - s.y);
    l.left.y = l.right.y = s.y;
    l.left.h = l.right.h = s.h;
    if (asks) l.question = {margin, s.y, question_share * l.window.w - margin, s.h};
    if (asks) l.left = {};
    const bool has_left = open.left && l.left.w > 0;
    const float from = asks ? l.question.x + l.question.w + margin : has_left ? l.left.x + l.left.w + margin : s.x;
    if (!open.right && view.pages) l.right = {};
    if (asks && open.right) {
        l.question.h = question_above_card * s.h;
        const float below = std::min(open.question, l.question.h) + margin;
        l.right = {l.question.x, s.y + below, l.question.w, s.h - below};
    }
    const float until = open.right && !asks ? l.right.x - margin : end;
    s.x = from, s.w = std::max(0.25f * l.window.w, until - from);
}

// The scene above all cards. In Mode::wiring the diagram is above, the scene and the cards share the rest.
void stand_up(WindowLayout& l, const LabView& view, OpenCards open, float margin) {
    const float top = l.right.y, column = l.right.h, wide = l.window.w - 2 * margin;
    const bool is_folded = !open.left && !open.right;
    const float headings = static_cast<float>(open.folded_left + open.folded_right) * tab_pitch * l.scale;
    const float upper = view.mode == Mode::wiring ? upright_diagram * column
                        : is_folded               ? std::max(0.0f, column - headings)
                        : view.program.touch      ? upright_scene_of_finger * column
                                                  : upright_scene * column;
    const float below = top + upper + margin, rest = std::max(0.0f, column - upper - margin);
    l.left = {}, l.left_on_right = true;
    if (view.mode == Mode::wiring) {
        const float cards = std::min(std::max(wide / 2, upright_cards * l.scale), 0.8f * wide),
                    inset = wide - cards - margin;
        l.canvas = {margin, top, wide, upper};
        l.scene = {margin, below, inset, rest};
        l.right = {margin + inset + margin, below, cards, rest};
    } else {
        l.scene = {margin, top, wide, upper};
        l.right = {margin, below, wide, rest};
    }
}

// The tools in columns at the left of a scene that is wider than its arena needs.
void tools_beside(WindowLayout& l, float size, float margin) {
    const float in_a_column = std::max(1.0f, std::floor((l.scene.h / l.scale - 2 * tool_pad) / size));
    const float wide = (std::ceil(tool_words.size() / in_a_column) * size + 2 * tool_pad) * l.scale;
    l.tools = {l.scene.x, l.scene.y, wide, l.scene.h};
    l.scene.x += wide + margin, l.scene.w -= wide + margin;
}

// The room of the tools: beside the folded cards above the scene where they fit, so that they cover none of it, else
// the scene.
Rect room_of_tools(const WindowLayout& l, float finger, float top, float margin) {
    const float size = std::max(tool_size, finger), strip = l.scene.y - margin - top;
    const float row = (static_cast<float>(tool_words.size()) * size + 2 * tool_pad) * l.scale;
    const float end_of_left = l.left.x + l.left.w + margin, end_of_scene = l.scene.x + l.scene.w;
    const float from = l.left.w > 0 ? std::max(l.scene.x, end_of_left) : l.scene.x;
    const float until = l.right.w > 0 ? std::min(end_of_scene, l.right.x - margin) : end_of_scene;
    const bool fits = strip >= (size + 2 * tool_pad) * l.scale && until - from >= row;
    return fits ? Rect{from, top, until - from, strip} : l.scene;
}

// In a lecture open cards of both columns are in one, so that the scene keeps half of the width.
void share_column(WindowLayout& l, float margin) {
    const float half = (l.window.w - 3 * margin) / 2;
    l.right = {l.window.w - margin - half, l.left.y, half, l.left.h};
    l.scene.x = margin, l.scene.w = half;
    l.left = {};
    l.left_on_right = true;
}

}  // namespace

float fitting_scale(float scale, Rect window, bool lecture, bool fingers) {
    constexpr float steps = 8, narrowest = 768, lowest = 560, least_scale = 0.625f;  // layout pixels
    constexpr float least_upright = 400;
    const bool stands = !lecture && window.h > 1.2f * window.w;
    // Type of less than two thirds of its size is not legible, so a smaller window is left to window_too_small().
    const float of_small = std::min(window.w / narrowest, window.h / lowest);
    if (of_small < 1 && !stands && !fingers)
        return std::min(scale, std::max(least_scale, std::floor(of_small * steps) / steps));
    const float least_width = lecture  ? 730.0f
                              : stands ? least_upright
                                       : 940.0f,
                least_height = lecture ? 540.0f : 570.0f;  // layout pixels
    const float most = std::min(window.w / least_width, window.h / least_height);
    return scale <= most ? scale : std::max(1.0f, std::floor(most * steps) / steps);
}

bool window_too_small(const WindowLayout& layout) {
    constexpr float least_width = 480, least_height = 260, least_upright_width = 400;  // window pixels
    const bool stands = layout.window.h > layout.window.w;
    return layout.window.w < (stands ? least_upright_width : least_width) || layout.window.h < least_height;
}

WindowLayout lay_out(float width, float height, float scale, const LabView& view, OpenCards open) {
    WindowLayout l;
    l.scale = scale;
    l.window = {0, 0, width, height};
    const float finger = finger_height(view, scale);
    const float timeline = std::max(timeline_height, finger);
    l.menu_bar = {0, 0, width, std::max(menu_bar_height, finger) * scale};
    const bool upright = !view.lecture && is_upright(width / scale, height / scale);
    const float toolbar_rows = upright && width < two_row_toolbar * scale ? 2.0f : 1.0f;
    l.toolbar = {0, l.menu_bar.h, width, toolbar_rows * std::max(toolbar_height, finger) * scale};
    l.hint_bar = {0, height - hint_height * scale, width, hint_height * scale};

    const ColumnWidths c = column_widths(width / scale, view.lecture);
    const bool is_small = !view.lecture && !upright && width / scale < small_window;
    if (is_small) open = in_one_column(open);
    const bool is_narrow = width / scale < (view.lesson ? narrow_window : wide_window);
    l.card_replaces_diagram = is_narrow && !is_small && has_asked_card(view);
    const bool watches = view.settings.watching && view.mode != Mode::wiring && !l.card_replaces_diagram;
    if (view.lecture) {
        l.menu_bar = {};
        l.toolbar = {0, 0, width, lecture_bar_height * scale};
        // The diagram beside the scene needs the height; it shows the wires larger.
        const bool is_large = !watches;
        const bool is_picture = vehicle_of_live_picture(view) != nullptr;
        const float figures = (!is_picture ? counts_height : is_large ? live_height : figures_height) * scale;
        // A card beside the diagram has the numbers, too: both have the room. A question has the height of its values.
        l.hint_bar = {0, height, width, 0};
        if ((!watches || !open.right) && !asks_in_card(view, open)) l.hint_bar.y -= figures, l.hint_bar.h = figures;
    }
    const float margin = c.margin * scale;
    // A page shows its values on request only; below the editor they then need no room.
    const bool has_figures =
        view.pages ? view.mode != Mode::wiring || shows_lecture_figures(view) : !shows_map_of_lecture(view);
    const float top = l.toolbar.y + l.toolbar.h + margin, bottom = (has_figures ? l.hint_bar.y : height) - margin;
    const float column = std::max(0.0f, bottom - top);
    // At most three eighths of the window each, so that a quarter stays free.
    const float wanted = shows_map_of_lecture(view) || is_lone_left(view, open) ? width : c.left * scale;
    const float left = std::min(wanted, width * left_share(view, open) - 2 * margin);
    const float right = std::min(c.right * scale, width * right_share(view, open) - margin);
    l.left = {margin, top, left, column};
    l.right = {width - margin - right, top, right, column};
    if (is_small || (watches && is_narrow)) l.left = {};  // room for the scene or the canvas
    l.left_on_right = is_small;
    const float from_left = l.left.w > 0 ? 2 * margin + left : margin;
    l.scene = {from_left, top, width - 2 * margin - right - from_left, column};

    if (upright)
        stand_up(l, view, open, margin);
    else if (view.mode != Mode::wiring && !view.lecture)
        fold_columns(l, open, margin);
    if (open.charts && view.mode != Mode::wiring && !view.lecture) {
        const float share = column < low_middle * scale ? 0.36f : 0.45f;
        const float strip = std::min(charts_height * scale, column * share);
        l.charts = {l.scene.x, l.scene.y + l.scene.h - strip, l.scene.w, strip};
        l.scene.h -= strip + margin;
        l.tools = l.scene;
        const float row = (std::max(tool_size, finger) + below_tools) * scale;
        l.scene.y += row, l.scene.h -= row;
    }
    // Between two cards of a small window the tools are above the scene, so that they cover none of it.
    const bool is_scene_narrow = l.scene.w < narrow_scene * scale;
    if (is_scene_narrow && !upright && !view.lecture && !watches && view.mode != Mode::wiring && l.tools.w <= 0) {
        const float strip = (tool_palette_height(l.scene.w / scale, finger) + above_scene) * scale;
        l.tools = l.scene;
        l.scene.y += strip, l.scene.h = std::max(0.0f, l.scene.h - strip);
    }
    // Folded cards cover part of the scene.
    if (view.lecture) l.scene = {margin, top, width - 2 * margin, column};
    if (view.lecture && open.left && l.left.w > 0) l.scene.x = from_left, l.scene.w -= from_left - margin;
    const bool covers = view.lecture && open.right && !asked(view) && view.mode != Mode::wiring;
    if (covers && !watches) l.scene.w -= l.right.w + margin;  // an open card has a column of its own
    if (asked(view) && view.mode != Mode::wiring) lay_out_page(l, view, open, margin);
    if (view.lecture && open.left && open.right && l.left.w > 0 && view.mode != Mode::wiring) share_column(l, margin);

    if (upright && view.mode == Mode::wiring) {
        l.timeline = take_timeline(l.canvas, scale, timeline);
    } else if (view.mode == Mode::wiring) {
        // There is no left column in a narrow window and without an exercise.
        if (!view.lesson || width / scale < narrow_window || (view.pages && !open.left)) l.left = {};
        const float from = l.left.w > 0 ? l.scene.x : margin;
        // Above the inset the exercise needs the height where it has no column of its own.
        const bool is_shared = view.lesson && l.left.w <= 0;
        const float share = view.lecture ? 0.33f : is_shared ? 0.25f : 0.36f;
        const float inset = std::min(inset_height * scale, column * share);
        // In a lecture the canvas also covers the area of the timeline, and the inset is narrower. An open card has
        // a column of its own.
        const float inset_width = view.lecture ? std::min(l.right.w, inset * lecture_inset_aspect) : l.right.w;
        l.scene = {width - margin - inset_width, bottom - inset, inset_width, inset};
        l.canvas = {from, top, l.scene.x - margin - from, column};
        if (!view.lecture) l.timeline = take_timeline(l.canvas, scale, timeline);
        l.right.h = column - inset - margin;
        if (view.lecture && open.right) l.canvas.w = std::min(l.canvas.w, l.right.x - margin - l.canvas.x);
    } else if (!view.lecture) {
        l.timeline = take_timeline(l.scene, scale, timeline);
    }
    if (upright && view.mode != Mode::wiring && l.tools.w <= 0 && !view.program.touch)
        tools_beside(l, std::max(tool_size, finger), margin);
    if (watches) split_for_canvas(l, view, margin, open.right);
    const bool may_be_beside_cards = !upright && !view.lecture && view.mode != Mode::wiring;
    if (l.tools.w <= 0) l.tools = may_be_beside_cards ? room_of_tools(l, finger, top, margin) : l.scene;
    l.exercise_on_right = view.lesson && l.left.w <= 0 && !view.lecture;
    return l;
}

}  // namespace braitenlab::ui
