// The open menu and the small picture in the corner: what lies over the canvas.
#include <algorithm>
#include <string>

#include "ui/imgui_compat.h"
#include "ui/shortcuts.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/wiring/curve_plot.h"
#include "ui/wiring/draw.h"
#include "ui/wiring/minimap.h"

namespace braitenlab {
namespace {

using maths::vec2;

constexpr float sign_room = 34, side = 12, key_gap = 28;  // layout pixels

std::string key_of(const Ui& ui, const MenuRow& row) {
    if (!row.key) return {};
    for (const Shortcut& shortcut : shortcuts())
        if (shortcut.action == *row.key && shortcut.place == KeyPlace::canvas)
            return key_name(shortcut.press, ui.strings);
    return {};
}

bool has_signs(const CanvasMenu& menu) { return menu.rows.front().command == MenuCommand::add; }

float width_of(const Ui& ui, const CanvasMenu& menu) {
    float widest = std::max(text_width(ui, Face::strong, ui.strings.find(menu.heading, "")),
                            text_width(ui, Face::small, ui.strings.find(menu.note, ""))) -
                   ui.px(has_signs(menu) ? sign_room : 0);
    for (const MenuRow& row : menu.rows) {
        const std::string key = key_of(ui, row);
        float width = text_width(ui, Face::text, ui.strings(row.words));
        if (!key.empty()) width += ui.px(key_gap) + text_width(ui, Face::small, key);
        widest = std::max(widest, width);
    }
    return widest + ui.px(2 * side + (has_signs(menu) ? sign_room : 0));
}

void draw_row(const Pen& pen, const CanvasMenu& menu, std::size_t index) {
    const Ui& ui = pen.ui;
    const Palette& p = ui.palette;
    const MenuRow& row = menu.rows[index];
    const Rect r = row_rect(menu, index);
    const float middle = r.y + r.h / 2;
    if (row.begins_group)
        pen.list.AddLine({r.x + ui.px(side), r.y - ui.px(4.5f)}, {r.x + r.w - ui.px(side), r.y - ui.px(4.5f)},
                         paint(p.line), ui.px(1));
    const bool current = static_cast<int>(index) == menu.current;
    if (current) fill_box(ui, {r.x + ui.px(4), r.y, r.w - ui.px(8), r.h}, mix(p.panel, p.accent, 0.28f), 4);
    float x = r.x + ui.px(side);
    if (has_signs(menu)) {
        const Rect sign{x, middle - ui.px(8), ui.px(24), ui.px(16)};
        if (row.command == MenuCommand::add)
            draw_curve_sign(pen.list, ui, sign, neuron_kinds[row.kind].curve, p.excites);
        x += ui.px(sign_room);
    }
    put(ui, {x, middle - line_height(ui, Face::text) / 2}, ui.strings(row.words), p.text);
    put_right(ui, {r.x + r.w - ui.px(side), middle - line_height(ui, Face::small) / 2}, key_of(ui, row), p.second_text,
              Face::small);
    // "wiring.do.insert" is recorded as menu.insert.
    const std::string_view words = row.words;
    ui.anchors.record("menu." + std::string(words.substr(words.rfind('.') + 1)), r);
}

void draw_head(const Ui& ui, const CanvasMenu& menu) {
    const float x = menu.rect.x + ui.px(side), y = menu.rect.y + ui.px(9);
    if (!menu.heading.empty()) put(ui, {x, y}, ui.strings(menu.heading), ui.palette.text, Face::strong);
    if (!menu.note.empty())
        put(ui, {x, y + line_height(ui, Face::strong) + ui.px(2)}, ui.strings(menu.note), ui.palette.second_text,
            Face::small);
}

}  // namespace

void draw_menu(const Pen& pen, CanvasMenu& menu, Rect area) {
    if (!menu.open()) return;
    const Ui& ui = pen.ui;
    const Palette& p = ui.palette;
    place_menu(menu, area, ui.scale, width_of(ui, menu));
    const Rect& r = menu.rect;
    for (int i = 6; i > 0; --i) {
        const float grow = ui.px(1.5f) * static_cast<float>(i);
        pen.list.AddRectFilled({r.x - grow, r.y - grow + ui.px(2)}, {r.x + r.w + grow, r.y + r.h + grow + ui.px(2)},
                               paint(p.shadow.with_alpha(p.shadow.a * 0.09f)), ui.px(8) + grow);
    }
    fill_box(ui, r, mix(p.panel, p.raised, 0.5f), 8);
    line_box(ui, r, p.line, 8);
    draw_head(ui, menu);
    for (std::size_t i = 0; i < menu.rows.size(); ++i) draw_row(pen, menu, i);
    ui.anchors.record("menu", r);
}

void draw_minimap(const Pen& pen, const CanvasPicture& picture, Rect area) {
    const auto map = minimap_of(picture.layout, pen.view, area, pen.ui.scale);
    if (!map) return;
    const Palette& p = pen.palette();
    const Rect& r = map->rect;
    fill_box(pen.ui, r, p.panel.with_alpha(0.92f));
    pen.list.PushClipRect({r.x, r.y}, {r.x + r.w, r.y + r.h}, true);
    for (const NodeShape& node : picture.layout.nodes) {
        const bool selected = picture.state.selection.nodes.count(node.id) > 0;
        const vec2 low = map->view.to_window(node.centre - node.size / 2);
        const vec2 high = map->view.to_window(node.centre + node.size / 2);
        const Colour colour = selected ? p.selected : node.kind == NodeKind::neuron ? p.second_text : p.accent;
        pen.list.AddRectFilled({low.x, low.y}, {std::max(high.x, low.x + 1.5f), std::max(high.y, low.y + 1.5f)},
                               paint(colour));
    }
    const vec2 low = map->view.to_window(picture.low), high = map->view.to_window(picture.high);
    pen.list.AddRectFilled({low.x, low.y}, {high.x, high.y}, paint(p.text.with_alpha(0.07f)));
    compat::outline(pen.list, {low.x, low.y}, {high.x, high.y}, paint(p.text), 0, pen.ui.px(1.5f));
    pen.list.PopClipRect();
    line_box(pen.ui, r, p.line);
    pen.ui.anchors.record("canvas.minimap", r);
}

}  // namespace braitenlab
