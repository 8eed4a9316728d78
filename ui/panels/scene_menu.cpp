// The menu of a right click into the scene: what can be done with the object there, or added on the floor.
#include <algorithm>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/brain/presets.h"
#include "core/maths/angle.h"
#include "core/scene/enums.h"
#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/scene_input/edits.h"
#include "ui/scene_input/polygon_tool.h"
#include "ui/shortcuts.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/menu_bar.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float scene_menu_width = 312, scene_menu_pad = spacing::small, scene_row_height = 28,
                rule_height = 9;  // layout pixels

// A row of the menu: words, requests, and the page it leads to.
struct SceneMenuRow {
    std::string anchor, words, keys;
    std::vector<Request> asks;
    std::optional<MenuPage> leads_to;
    std::optional<SceneInputTool> takes;  // the tool that starts at the menu's position
    std::optional<Role> role;             // shows the sign of a vehicle
    std::optional<Channel> channel;
    std::optional<Command> tries;  // BrainState::what_if while the pointer is over the row
    bool heading = false, rule_above = false;
};

class SceneMenuRows {
public:
    SceneMenuRows(const LabView& view, const SceneInputMenu& menu, const Ui& ui)
        : view_(view), now_(*view.now), menu_(menu), ui_(ui) {}

    std::vector<SceneMenuRow> of_page() {
        const bool vehicle = menu_.object.kind == SceneObjectKind::vehicle;
        if (vehicle && menu_.page == MenuPage::brains)
            brains();
        else if (vehicle)
            of_vehicle();
        else if (menu_.object)
            of_object();
        if (!menu_.object || menu_.object.kind == SceneObjectKind::zone) of_floor();
        return std::move(rows_);
    }

private:
    std::string words(std::string_view key) const { return std::string(ui_.strings(key)); }
    std::string keys(Action action) const { return ui_.finger > 0 ? std::string() : key_name(action, ui_.strings); }

    SceneMenuRow& add(std::string anchor, std::string text, std::vector<Request> asks = {}, std::string shortcut = {}) {
        SceneMenuRow row;
        row.anchor = "menu." + std::move(anchor);
        row.words = std::move(text);
        row.keys = std::move(shortcut);
        row.asks = std::move(asks);
        rows_.push_back(std::move(row));
        return rows_.back();
    }
    void heading(std::string text) { add("heading", std::move(text)).heading = true; }
    void edit(std::string anchor, std::string_view key, const std::optional<Command>& command, Action shown) {
        if (command) add(std::move(anchor), words(key), {EditRequest{*command}}, keys(shown));
    }
    void copy_and_erase() {
        edit("duplicate", "action.duplicate", copy_of(now_, menu_.object), Action::duplicate);
        edit("erase", "menu.erase", removal_of(now_, menu_.object), Action::erase);
        rows_.back().rule_above = true;
    }

    std::string name_of(const Kind& kind) const {
        const bool lone = now_.scene->kinds.size() == 1 && kind.role == Role::none;
        return lone ? words("kind.vehicle") : kind_name(ui_, kind);
    }

    std::string name_of(const VehicleView& v) const {
        return name_of(kind_of(now_, v)) + " " + std::to_string(v.id + 1);
    }

    void of_vehicle() {
        const VehicleView* v = find_vehicle(now_, menu_.object.index);
        if (!v) return;
        heading(name_of(*v));
        add("brains", words("menu.brains")).leads_to = MenuPage::brains;
        const bool by_hand = v->driver == Driver::manual;
        add("drive", words(by_hand ? "menu.let_drive" : "menu.drive"), {SelectRequest{v->id}, Action::drive},
            keys(Action::drive));
        look("follow", "menu.follow", Action::follow, CameraMode::follow, v->id);
        look("eyes", "menu.eyes", Action::drivers_eye, CameraMode::driver, v->id);
        copy_and_erase();
    }

    void look(std::string anchor, std::string_view key, Action action, CameraMode mode, VehicleId id) {
        std::vector<Request> asks{SelectRequest{id}};
        if (view_.settings.camera.mode != mode) asks.push_back(action);
        add(std::move(anchor), words(key), std::move(asks), keys(action));
    }

    void brains() {
        const VehicleView* v = find_vehicle(now_, menu_.object.index);
        if (!v) return;
        heading(name_of(*v) + "  ·  " + words("menu.brains"));
        const bool is_selected = v->id == view_.settings.selection.vehicle;  // its path is predicted
        const auto give = [&](std::string anchor, std::string text, const BrainGraph& brain) -> SceneMenuRow& {
            const SetBrain edit{{v->id, -1}, brain};
            SceneMenuRow& row = add(std::move(anchor), std::move(text), {SelectRequest{v->id}, EditRequest{edit}});
            if (is_selected) row.tries = edit;
            return row;
        };
        for (std::size_t k = 0; k < now_.kind_brains.size(); ++k)
            if (now_.scene->kinds.size() > 1)
                give("brain.kind." + std::to_string(k), name_of(now_.scene->kinds[k]), *now_.kind_brains[k]).role =
                    now_.scene->kinds[k].role;
        for (const Preset& preset : presets()) {
            const std::string key(preset.name);
            give("brain." + key, std::string(ui_.strings.find("preset." + key, key)),
                 graft(*brain_of(now_, *v), preset.brain));
        }
    }

    void of_object() {
        const bool source = menu_.object.kind == SceneObjectKind::source;
        const auto index = static_cast<std::size_t>(menu_.object.index);
        if (!place_of(now_, menu_.object)) return;
        heading(source ? words("source." + std::string(word(now_.scene->sources[index].channel)))
                       : words("thing." + std::string(word(menu_.object.kind))));
        copy_and_erase();
    }

    void of_floor() {
        heading(words("menu.add"));
        const float towards_middle = maths::arctangent2(-menu_.place.y, -menu_.place.x);
        const Pose pose{menu_.place.x, menu_.place.y, towards_middle};
        for (std::size_t k = 0; k < now_.scene->kinds.size(); ++k)
            add("add.vehicle." + std::to_string(k), name_of(now_.scene->kinds[k]),
                {EditRequest{AddVehicle{static_cast<int>(k), pose}}})
                .role = now_.scene->kinds[k].role;
        for (const Channel channel : source_channels) {
            Source source;
            source.channel = channel, source.x = menu_.place.x, source.y = menu_.place.y;
            const std::string name(word(channel));
            SceneMenuRow& row = add("add." + name, words("source." + name), {EditRequest{AddSource{source}}});
            row.channel = channel;
            row.rule_above = channel == source_channels.front();
        }
        Obstacle box;
        box.x = menu_.place.x, box.y = menu_.place.y;
        add("add.box", words("menu.box"), {EditRequest{AddObstacle{box}}}).rule_above = true;
        add("add.polygon", words("menu.polygon")).takes = SceneInputTool::polygon;
        add("add.zone", words("menu.zone"), {EditRequest{AddZone{zone_between(menu_.place, menu_.place)}}});
        add("add.tape", words("menu.tape")).takes = SceneInputTool::tape;
        add("home", words("action.home"), {Action::home}, keys(Action::home)).rule_above = true;
    }

    const LabView& view_;
    const Snapshot& now_;
    const SceneInputMenu& menu_;
    const Ui& ui_;
    std::vector<SceneMenuRow> rows_;
};

// Of the menu without its rows, window pixels.
float menu_frame_height(const Ui& ui, const std::vector<SceneMenuRow>& rows) {
    float height = 2 * ui.px(scene_menu_pad);
    for (const SceneMenuRow& row : rows) height += row.rule_above ? ui.px(rule_height) : 0;
    return height;
}

// `indented`: leaves room for the signs of other rows.
void draw_menu_row(const Ui& ui, const SceneMenuRow& row, const Item& at, bool indented) {
    const Palette& p = ui.palette;
    fill_box(ui, at.rect, p.line.with_alpha(std::max(0.6f * at.warmth, at.focused ? 0.6f : 0.0f)));
    float x = at.rect.x + ui.px(spacing::medium);
    const ImVec2 sign{x + ui.px(6), at.middle_y()};
    if (row.role) put_role(ui, sign, ui.px(12), *row.role);
    if (row.channel) ImGui::GetWindowDrawList()->AddCircleFilled(sign, ui.px(6), paint(colour_of(p, *row.channel)), 20);
    if (indented) x += ui.px(22);
    const float y = at.middle_y() - line_height(ui, Face::text) / 2;
    put(ui, {x, y}, row.words, p.text);
    const float right = at.right() - ui.px(spacing::medium);
    if (row.leads_to) put_icon(ui, {right - ui.px(3), at.middle_y()}, icon::folded, p.second_text);
    put_right(ui, {right, at.middle_y() - line_height(ui, Face::small) / 2}, row.keys, p.second_text, Face::small);
}

// Draws the row.
Item menu_row(Ui& ui, const SceneMenuRow& row, bool indented, float height) {
    const float width = ui.px(scene_menu_width - 2 * scene_menu_pad);
    if (row.rule_above) {
        const ImVec2 from = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddLine({from.x, from.y + ui.px(4)}, {from.x + width, from.y + ui.px(4)},
                                            paint(ui.palette.line), ui.px(1));
        ImGui::Dummy({width, ui.px(rule_height)});
    }
    if (row.heading) {
        const ImVec2 from = ImGui::GetCursorScreenPos();
        put(ui, {from.x + ui.px(spacing::medium), from.y + (height - line_height(ui, Face::small)) / 2}, row.words,
            ui.palette.second_text, Face::small);
        ImGui::Dummy({width, height});
        return {};
    }
    const Item at = item(ui, row.anchor, {width, height});
    draw_menu_row(ui, row, at, indented);
    return at;
}

void execute(const LabView& view, PanelState& state, Ui& ui, const SceneMenuRow& row) {
    SceneInputState& scene_input = state.scene_input;
    if (row.leads_to) {
        scene_input.menu.page = *row.leads_to;
        scene_input.menu.rows.clear();
        if (ui.keyboard) ui.keyboard->focus.clear();
        return;
    }
    for (Request request : row.asks) {
        if (auto* edit = std::get_if<EditRequest>(&request)) edit->command = with_room(*view.now, edit->command);
        ui.outbox.push_back(std::move(request));
    }
    if (row.takes) {
        choose_tool(scene_input, *row.takes);
        scene_input.corners = {scene_input.menu.place};
    }
    scene_input.menu.open = false;
    if (ui.keyboard) ui.keyboard->focus.clear();
}

}  // namespace

void scene_menu(const LabView& view, PanelState& state, Ui& ui, Rect window) {
    SceneInputMenu& menu = state.scene_input.menu;
    if (view.mode == Mode::wiring) menu.open = false;
    if (!menu.open) return;
    const bool just_opened = !std::exchange(menu.placed, true);
    if (just_opened) ImGui::OpenPopup("scene menu");
    const std::vector<SceneMenuRow> rows = SceneMenuRows(view, menu, ui).of_page();
    const float w = ui.px(scene_menu_width), most = window.h - ui.px(16), frame = menu_frame_height(ui, rows);
    const float count = static_cast<float>(rows.size());
    const float row_height = ui.px(ui.tall(scene_row_height));
    const float h = std::min(frame + count * row_height, most);
    const auto within = [](float at, float low, float size, float room) {
        return std::clamp(at, low, std::max(low, low + room - size));
    };
    const ImVec2 at{within(menu.at.x, window.x + ui.px(8), w, window.w - ui.px(16)),
                    within(menu.at.y, window.y + ui.px(8), h, most)};
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowSize({w, h});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(scene_menu_pad), ui.px(scene_menu_pad)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    if (ImGui::BeginPopup("scene menu", ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav)) {
        begin_stops(ui.keyboard);
        menu.rows.clear();
        const bool signs =
            std::any_of(rows.begin(), rows.end(), [](const SceneMenuRow& r) { return r.role || r.channel; });
        for (const SceneMenuRow& row : rows) {
            if (!row.heading) menu.rows.push_back(row.anchor);
            const Item at_row = menu_row(ui, row, signs, row_height);
            if (at_row.hovered && row.tries) state.brain.what_if = {*row.tries};
            if (at_row.pressed) execute(view, state, ui, row);
        }
        mark(ui, "menu", {at.x, at.y, w, h});
        if (menu.by_key && ui.keyboard && !menu.rows.empty() && ui.keyboard->focus.empty())
            ui.keyboard->focus = menu.rows.front();
        menu.by_key = false;
        if (!menu.open) ImGui::CloseCurrentPopup();
        compat::end_popup();
    } else {
        menu.open = false;  // closed by a click beside it
    }
    ImGui::PopStyleVar(2);
}

}  // namespace braitenlab::ui
