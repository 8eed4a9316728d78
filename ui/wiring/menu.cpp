#include "ui/wiring/menu.h"

#include <algorithm>
#include <array>
#include <string>

#include "ui/shortcuts.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/draw.h"
#include "ui/wiring/inspector.h"
#include "ui/words/strings.h"

namespace braitenlab::wiring {

using namespace ui;

using maths::vec2;

namespace {

constexpr float menu_row_height = 28, least_menu_row = 20, menu_padding = spacing::small,
                menu_group_gap = spacing::small, heading_room = 26,
                note_room = 20;  // layout pixels

void add_kinds(std::vector<MenuRow>& rows) {
    for (std::size_t kind = 0; kind < neuron_kinds.size(); ++kind)
        rows.push_back({kind_key(kind), MenuCommand::add, kind});
}

void add_canvas_rows(std::vector<MenuRow>& rows, bool can_paste) {
    add_kinds(rows);
    if (can_paste) rows.push_back({"wiring.do.paste", Action::paste, 0, true});
    rows.push_back({"wiring.do.select_all", Action::select_all, 0, !can_paste});
    rows.push_back({"wiring.do.tidy", Action::tidy});
    rows.push_back({"wiring.do.fit", Action::fit});
}

void add_wire_rows(std::vector<MenuRow>& rows, const BrainGraph& graph, const CanvasSelection& selection) {
    const Wire* wire = find_wire(graph, selection.wires.begin()->from, selection.wires.begin()->to);
    rows.push_back({"wiring.do.edit_numbers", MenuCommand::edit_numbers});
    if (wire == nullptr || wire->weight == 0) return;
    rows.push_back({"wiring.do.insert", MenuCommand::insert});
    rows.push_back({"wiring.do.flip", MenuCommand::flip});
}

void add_node_rows(std::vector<MenuRow>& rows, const BrainGraph& graph, NodeId id) {
    const Node* node = find_node(graph, id);
    if (node == nullptr) return;
    if (node->kind != NodeKind::sensor) rows.push_back({"wiring.do.edit_numbers", MenuCommand::edit_numbers});
    rows.push_back({"wiring.do.join", MenuCommand::join});
}

void add_arrangement_rows(std::vector<MenuRow>& rows, std::size_t nodes) {
    if (nodes < 2) return;
    rows.push_back({"wiring.do.column", MenuCommand::column, 0, true});
    rows.push_back({"wiring.do.row", MenuCommand::row});
    if (nodes < 3) return;
    rows.push_back({"wiring.do.even_down", MenuCommand::even_down});
    rows.push_back({"wiring.do.even_across", MenuCommand::even_across});
}

constexpr float curve_width = 24, curve_room = curve_width + spacing::small, menu_side = spacing::medium,
                key_gap = spacing::wide;  // layout pixels

std::string shortcut_of(const Ui& ui, const MenuRow& row) {
    const auto* action = std::get_if<Action>(&row.effect);
    if (!action || ui.finger > 0) return {};  // a finger has no keys
    for (const Shortcut& shortcut : shortcuts())
        if (shortcut.action == *action && shortcut.place == KeyPlace::canvas)
            return key_name(shortcut.press, ui.strings);
    return {};
}

bool shows_curves(const CanvasMenu& menu) { return menu.rows.front().adds(); }

float menu_width(const Ui& ui, const CanvasMenu& menu) {
    float widest = std::max(text_width(ui, Face::strong, ui.strings.find(menu.heading, "")),
                            text_width(ui, Face::small, ui.strings.find(menu.note, ""))) -
                   ui.px(shows_curves(menu) ? curve_room : 0);
    for (const MenuRow& row : menu.rows) {
        const std::string key = shortcut_of(ui, row);
        float width = text_width(ui, Face::text, ui.strings(row.words));
        if (!key.empty()) width += ui.px(key_gap) + text_width(ui, Face::small, key);
        widest = std::max(widest, width);
    }
    return widest + ui.px(2 * menu_side + (shows_curves(menu) ? curve_room : 0));
}

void draw_row(const Pen& pen, const CanvasMenu& menu, std::size_t index) {
    const Ui& ui = pen.ui;
    const Palette& p = ui.palette;
    const MenuRow& row = menu.rows[index];
    const Rect r = row_rect(menu, index);
    const float middle = r.y + r.h / 2;
    if (row.begins_group)
        pen.list.AddLine({r.x + ui.px(menu_side), r.y - ui.px(menu_group_gap / 2)},
                         {r.x + r.w - ui.px(menu_side), r.y - ui.px(menu_group_gap / 2)}, paint(p.line), ui.px(1));
    const bool current = static_cast<int>(index) == menu.current;
    if (current)
        fill_box(ui, {r.x + ui.px(spacing::tight), r.y, r.w - ui.px(2 * spacing::tight), r.h},
                 mix(p.panel, p.accent, 0.28f));
    float x = r.x + ui.px(menu_side);
    if (shows_curves(menu)) {
        const Rect sign{x, middle - ui.px(8), ui.px(curve_width), ui.px(16)};
        if (row.adds()) draw_curve(pen.list, ui, sign, neuron_kinds[row.kind].curve, p.excites);
        x += ui.px(curve_room);
    }
    put(ui, {x, middle - line_height(ui, Face::text) / 2}, ui.strings(row.words), p.text);
    put_right(ui, {r.x + r.w - ui.px(menu_side), middle - line_height(ui, Face::small) / 2}, shortcut_of(ui, row),
              p.second_text, Face::small);
    // The anchor of "wiring.do.insert" is menu.insert.
    const std::string_view words = row.words;
    ui.anchors.record("menu." + std::string(words.substr(words.rfind('.') + 1)), r);
}

void draw_heading(const Ui& ui, const CanvasMenu& menu) {
    const float x = menu.rect.x + ui.px(menu_side), y = menu.rect.y + ui.px(spacing::small);
    if (!menu.heading.empty()) put(ui, {x, y}, ui.strings(menu.heading), ui.palette.text, Face::strong);
    if (!menu.note.empty())
        put(ui, {x, y + line_height(ui, Face::strong) + ui.px(spacing::hair)}, ui.strings(menu.note),
            ui.palette.second_text, Face::small);
}

}  // namespace

std::string_view kind_key(std::size_t kind) {
    static const auto keys = [] {
        std::array<std::string, neuron_kinds.size()> made;
        for (std::size_t i = 0; i < made.size(); ++i) made[i] = "wiring.kind." + std::string(neuron_kinds[i].word);
        return made;
    }();
    return keys.at(kind);
}

std::vector<MenuRow> menu_rows(const BrainGraph& graph, const CanvasSelection& selection, bool can_paste) {
    std::vector<MenuRow> rows;
    const std::size_t nodes = selection.nodes.size(), wires = selection.wires.size();
    if (nodes + wires == 0) {
        add_canvas_rows(rows, can_paste);
        return rows;
    }
    if (nodes == 0 && wires == 1) add_wire_rows(rows, graph, selection);
    if (nodes == 1 && wires == 0) add_node_rows(rows, graph, *selection.nodes.begin());
    const bool lesioned = all_lesioned(graph, selection.nodes, selection.wires);
    rows.push_back({lesioned ? "wiring.do.heal" : nodes > 0 ? "wiring.do.silence" : "wiring.do.sever", Action::lesion});
    if (nodes > 0) rows.push_back({"wiring.do.probe", Action::probe});
    if (nodes > 0) rows.push_back({"wiring.do.chart", MenuCommand::chart});
    const auto is_neuron = [&](NodeId id) {
        const Node* node = find_node(graph, id);
        return node != nullptr && node->kind == NodeKind::neuron;
    };
    const bool neurons = std::any_of(selection.nodes.begin(), selection.nodes.end(), is_neuron);
    if (neurons) {
        rows.push_back({"wiring.do.copy", Action::copy, 0, true});
        rows.push_back({"wiring.do.cut", Action::cut});
        rows.push_back({"wiring.do.duplicate", Action::duplicate});
    }
    add_arrangement_rows(rows, nodes);
    if (nodes > 0) rows.push_back({"wiring.do.detach", MenuCommand::detach, 0, true});
    if (neurons || wires > 0) rows.push_back({"wiring.do.erase", Action::erase, 0, nodes == 0});
    return rows;
}

std::vector<MenuRow> drop_rows() {
    std::vector<MenuRow> rows;
    add_kinds(rows);
    return rows;
}

void set_heading(CanvasMenu& menu) {
    if (menu.rows.empty() || !menu.rows.front().adds()) return;
    menu.heading = "wiring.add_neuron";
    if (menu.loose.part == Part::nothing) menu.note = "wiring.add_how";
}

float heading_height(const CanvasMenu& menu) {
    return ((menu.heading.empty() ? 0 : heading_room) + (menu.note.empty() ? 0 : note_room)) * menu.ui_scale;
}

void place_menu(CanvasMenu& menu, Rect window, float ui_scale, float width) {
    menu.ui_scale = ui_scale;
    const float room = spacing::tight * ui_scale;
    float height = 2 * menu_padding * ui_scale + heading_height(menu);
    for (const MenuRow& row : menu.rows) height += row.begins_group ? menu_group_gap * ui_scale : 0;
    const float count = static_cast<float>(std::max<std::size_t>(1, menu.rows.size()));
    const float fits = (window.h - 2 * room - height) / count / ui_scale;
    menu.row_height = std::clamp(fits, least_menu_row, std::max(menu_row_height, menu.finger));
    height += count * menu.row_height * ui_scale;
    const auto within = [room](float at, float size, float low, float extent) {
        return std::clamp(at, low + room, std::max(low + room, low + extent - size - room));
    };
    menu.rect = {within(menu.at.x, width, window.x, window.w), within(menu.at.y, height, window.y, window.h), width,
                 height};
}

Rect row_rect(const CanvasMenu& menu, std::size_t wanted) {
    float y = menu.rect.y + menu_padding * menu.ui_scale + heading_height(menu);
    for (std::size_t i = 0; i < menu.rows.size(); ++i) {
        if (menu.rows[i].begins_group) y += menu_group_gap * menu.ui_scale;
        if (i == wanted) break;
        y += menu.row_height * menu.ui_scale;
    }
    return {menu.rect.x, y, menu.rect.w, menu.row_height * menu.ui_scale};
}

int row_at(const CanvasMenu& menu, maths::vec2 pixel) {
    for (std::size_t i = 0; i < menu.rows.size(); ++i)
        if (row_rect(menu, i).contains(pixel)) return static_cast<int>(i);
    return -1;
}

void draw_menu(const Pen& pen, CanvasMenu& menu, Rect window) {
    if (!menu.open()) return;
    const Ui& ui = pen.ui;
    const Palette& p = ui.palette;
    place_menu(menu, window, ui.scale, menu_width(ui, menu));
    const Rect& r = menu.rect;
    shadow_box(ui, pen.list, r, Corner::box, {6, 1.5f, 0.09f});
    fill_box(ui, r, mix(p.panel, p.raised, 0.5f));
    line_box(ui, r, p.line);
    draw_heading(ui, menu);
    for (std::size_t i = 0; i < menu.rows.size(); ++i) draw_row(pen, menu, i);
    ui.anchors.record("menu", r);
}

}  // namespace braitenlab::wiring
