#include "ui/wiring/menu.h"

#include <algorithm>
#include <array>
#include <string>

namespace braitenlab {
namespace {

constexpr float row_height = 28, padding = 6, group_gap = 9, heading_height = 26, note_height = 20;  // layout pixels

void add_kinds(std::vector<MenuRow>& rows) {
    for (std::size_t kind = 0; kind < neuron_kinds.size(); ++kind)
        rows.push_back({MenuCommand::add, kind_key(kind), {}, kind});
}

void add_canvas_rows(std::vector<MenuRow>& rows, bool can_paste) {
    add_kinds(rows);
    if (can_paste) rows.push_back({MenuCommand::paste, "wiring.do.paste", Action::paste, 0, true});
    rows.push_back({MenuCommand::select_all, "wiring.do.select_all", Action::select_all, 0, !can_paste});
    rows.push_back({MenuCommand::tidy, "wiring.do.tidy", Action::tidy});
    rows.push_back({MenuCommand::fit, "wiring.do.fit", Action::fit});
}

void add_wire_rows(std::vector<MenuRow>& rows, const BrainGraph& graph, const Caught& selection) {
    const Wire* wire = find_wire(graph, selection.wires.begin()->from, selection.wires.begin()->to);
    rows.push_back({MenuCommand::edit_numbers, "wiring.do.edit_numbers"});
    if (wire == nullptr || wire->weight == 0) return;
    rows.push_back({MenuCommand::insert, "wiring.do.insert"});
    rows.push_back({MenuCommand::flip, "wiring.do.flip"});
}

void add_node_rows(std::vector<MenuRow>& rows, const BrainGraph& graph, NodeId id) {
    const Node* node = find_node(graph, id);
    if (node == nullptr) return;
    if (node->kind != NodeKind::sensor) rows.push_back({MenuCommand::edit_numbers, "wiring.do.edit_numbers"});
    rows.push_back({MenuCommand::join, "wiring.do.join"});
}

void add_order_rows(std::vector<MenuRow>& rows, std::size_t nodes) {
    if (nodes < 2) return;
    rows.push_back({MenuCommand::column, "wiring.do.column", {}, 0, true});
    rows.push_back({MenuCommand::row, "wiring.do.row"});
    if (nodes < 3) return;
    rows.push_back({MenuCommand::even_down, "wiring.do.even_down"});
    rows.push_back({MenuCommand::even_across, "wiring.do.even_across"});
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

std::vector<MenuRow> menu_rows(const BrainGraph& graph, const Caught& selection, bool can_paste) {
    std::vector<MenuRow> rows;
    const std::size_t nodes = selection.nodes.size(), wires = selection.wires.size();
    if (nodes + wires == 0) {
        add_canvas_rows(rows, can_paste);
        return rows;
    }
    if (nodes == 0 && wires == 1) add_wire_rows(rows, graph, selection);
    if (nodes == 1 && wires == 0) add_node_rows(rows, graph, *selection.nodes.begin());
    const bool hurt = all_lesioned(graph, selection.nodes, selection.wires);
    rows.push_back({MenuCommand::lesion,
                    hurt        ? "wiring.do.heal"
                    : nodes > 0 ? "wiring.do.silence"
                                : "wiring.do.sever",
                    Action::lesion});
    const auto is_neuron = [&](NodeId id) {
        const Node* node = find_node(graph, id);
        return node != nullptr && node->kind == NodeKind::neuron;
    };
    const bool neurons = std::any_of(selection.nodes.begin(), selection.nodes.end(), is_neuron);
    if (neurons) {
        rows.push_back({MenuCommand::copy, "wiring.do.copy", Action::copy, 0, true});
        rows.push_back({MenuCommand::cut, "wiring.do.cut", Action::cut});
        rows.push_back({MenuCommand::duplicate, "wiring.do.duplicate", Action::duplicate});
    }
    add_order_rows(rows, nodes);
    if (nodes > 0) rows.push_back({MenuCommand::detach, "wiring.do.detach", {}, 0, true});
    if (neurons || wires > 0) rows.push_back({MenuCommand::erase, "wiring.do.erase", Action::erase, 0, nodes == 0});
    return rows;
}

std::vector<MenuRow> drop_rows() {
    std::vector<MenuRow> rows;
    add_kinds(rows);
    return rows;
}

void head_menu(CanvasMenu& menu) {
    if (menu.rows.empty() || menu.rows.front().command != MenuCommand::add) return;
    menu.heading = "wiring.add_neuron";
    if (menu.loose.part == Part::nothing) menu.note = "wiring.add_how";
}

float head_height(const CanvasMenu& menu) {
    return ((menu.heading.empty() ? 0 : heading_height) + (menu.note.empty() ? 0 : note_height)) * menu.ui_scale;
}

void place_menu(CanvasMenu& menu, Rect area, float ui_scale, float widest) {
    menu.ui_scale = ui_scale;
    float height = 2 * padding * ui_scale + head_height(menu);
    for (const MenuRow& row : menu.rows) height += (row_height + (row.begins_group ? group_gap : 0)) * ui_scale;
    const float room = 4 * ui_scale;
    const auto within = [room](float at, float size, float low, float extent) {
        return std::clamp(at, low + room, std::max(low + room, low + extent - size - room));
    };
    menu.rect = {within(menu.at.x, widest, area.x, area.w), within(menu.at.y, height, area.y, area.h), widest, height};
}

Rect row_rect(const CanvasMenu& menu, std::size_t wanted) {
    float y = menu.rect.y + padding * menu.ui_scale + head_height(menu);
    for (std::size_t i = 0; i < menu.rows.size(); ++i) {
        if (menu.rows[i].begins_group) y += group_gap * menu.ui_scale;
        if (i == wanted) break;
        y += row_height * menu.ui_scale;
    }
    return {menu.rect.x, y, menu.rect.w, row_height * menu.ui_scale};
}

int row_at(const CanvasMenu& menu, maths::vec2 pixel) {
    for (std::size_t i = 0; i < menu.rows.size(); ++i)
        if (row_rect(menu, i).contains(pixel.x, pixel.y)) return static_cast<int>(i);
    return -1;
}

}  // namespace braitenlab
