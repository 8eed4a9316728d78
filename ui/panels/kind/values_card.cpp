// The card of the arena and the kinds: every value that holds for the whole scene or for all vehicles of a kind.
#include <algorithm>
#include <array>
#include <string>

#include <imgui.h>

#include "core/scene/schema.h"
#include "core/text_parts.h"
#include "ui/panels/cards.h"
#include "ui/panels/kind/kind_editor.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/record_fields.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr float seed_width = 96;  // layout pixels

// Requests an edit of a record drawn in this frame.
template <class Edit, class ToCommand>
void request(Ui& ui, const Edit& edit, ToCommand to_command) {
    if (edit) ui.outbox.push_back(EditRequest{to_command(edit->to), edit->gesture});
}

void arena_values(const LabView& view, PanelState& state, Ui& ui) {
    const Scene& scene = *view.now->scene;
    const Scene& filed = view.file ? *view.file : scene;
    if (view.lesson) start_row(view, state, ui);
    request(ui, record_fields(rows_for(view, state, ui), scene.arena, filed.arena),
            [](const Arena& to) { return EditArena{to}; });
    gap(ui, 12);
    subheading(ui, ui.strings("values.energy"));
    constexpr std::string_view shown[]{"drain", "bite", "inactivity"};
    request(ui, record_fields(rows_for(view, state, ui), scene.ecology, filed.ecology, shown),
            [](const Ecology& to) { return EditEcology{to}; });
}

// One button per kind, as many in a row as fit.
void kind_names(const LabView& view, ValuesState& values, Ui& ui) {
    const std::vector<Kind>& kinds = view.now->scene->kinds;
    const float right = ImGui::GetCursorScreenPos().x + card_width(ui);
    for (int i = 0; i < static_cast<int>(kinds.size()); ++i) {
        const Kind& kind = kinds[static_cast<std::size_t>(i)];
        const std::string id = "kind." + kind.name;
        const std::string words =
            kinds.size() == 1 && view.lesson ? std::string(ui.strings("kind.vehicle")) : kind_name(ui, kind);
        const SmallButton look{id, {}, words, i == values.kind};
        if (i > 0) beside_or_below(ui, small_button_width(ui, look, true), right);
        if (small_push_button(ui, look, ui.strings("values.kind_how"))) values.kind = i;
    }
}

// Adds a copy of the present kind, or removes it.
void kind_buttons(const LabView& view, PanelState& state, Ui& ui) {
    const Snapshot& now = *view.now;
    const auto index = static_cast<std::size_t>(state.values.kind);
    ButtonLook more{{}, ui.strings("values.kind_add")};
    more.compact = true;
    if (push_button(ui, "kind.add", more, ui.strings("values.kind_add_how"))) {
        Kind copy = index < now.scene->kinds.size() ? now.scene->kinds[index] : Kind{};
        if (index < now.kind_brains.size()) copy.brain = *now.kind_brains[index];
        copy.share = 0;
        ui.outbox.push_back(EditRequest{AddKind{std::move(copy)}});
        state.values.kind = static_cast<int>(now.scene->kinds.size());
    }
    if (index >= now.scene->kinds.size()) return;
    const bool used = std::any_of(now.vehicles.begin(), now.vehicles.end(),
                                  [&](const VehicleView& v) { return v.kind == state.values.kind; });
    ImGui::SameLine(0, ui.px(spacing::small));
    ButtonLook look{{}, ui.strings("values.kind_remove")};
    look.enabled = !used, look.compact = true;
    if (push_button(ui, "kind.remove", look, ui.strings(used ? "values.kind_used" : "values.kind_remove_how")))
        ui.outbox.push_back(EditRequest{RemoveKind{state.values.kind}});
}

// The kind of the selected vehicle, whenever another vehicle is selected.
void follow_selection(const LabView& view, ValuesState& values) {
    const VehicleView* selected = selected_vehicle(view);
    if (selected && selected->id != values.followed) values.kind = selected->kind;
    values.followed = selected ? selected->id : no_vehicle;
    values.kind = std::clamp(values.kind, 0, std::max(0, static_cast<int>(view.now->scene->kinds.size()) - 1));
}

// Name and colour of the selected vehicle alone.
void look_of_selected(const LabView& view, Ui& ui, const FieldRows& row, const VehicleView& selected) {
    Look to = look_of(*view.now, selected);
    FieldRows name_row = row;
    name_row.anchor += "." + std::to_string(selected.id);
    const auto named = view.lesson ? std::nullopt : name_row.text("name", to.label, limits::name_length);
    const auto tinted = colour_row(row, "vehicle.colour.", to.colour, selected.role);
    if (!named && !tinted) return;
    if (named) to.label = *named;
    if (tinted) to.colour = *tinted;
    const auto start = static_cast<std::size_t>(selected.start);
    if (selected.start < 0 || start >= view.now->scene->starts.size())
        return ui.outbox.push_back(EditRequest{SetLook{selected.id, std::move(to)}, row.next_gesture()});
    Start edited = view.now->scene->starts[start];
    edited.name = to.label, edited.colour = to.colour;
    ui.outbox.push_back(EditRequest{EditStart{selected.start, std::move(edited)}, row.next_gesture()});
}

// The values of the selected vehicle alone: its name, its colour and its driver.
void values_of_selected(const LabView& view, PanelState& state, Ui& ui) {
    const VehicleView* selected = selected_vehicle(view);
    if (!selected) return;
    gap(ui, 12);
    subheading(ui, fill(ui.strings("values.selected"), {std::to_string(selected->id + 1)}));
    FieldRows row = rows_for(view, state, ui);
    row.anchor = "vehicle", row.words = "field.kind.";
    look_of_selected(view, ui, row, *selected);
    std::vector<std::string_view> words;
    for (const auto& driver : driver_table)
        words.push_back(ui.strings.find(std::string(word_stem(Driver{})) + std::string(driver.word), driver.word));
    const int chosen = row.choice("driver", words, static_cast<int>(selected->driver));
    if (chosen >= 0)
        ui.outbox.push_back(EditRequest{ChooseDriver{selected->id, static_cast<Driver>(chosen)}, row.next_gesture()});
}

void kind_values(const LabView& view, PanelState& state, Ui& ui) {
    follow_selection(view, state.values);
    kind_names(view, state.values, ui);
    kind_buttons(view, state, ui);
    if (state.values.kind < static_cast<int>(view.now->scene->kinds.size()))
        kind_editor(view, state, ui, state.values.kind);
    values_of_selected(view, state, ui);
}

}  // namespace

void start_row(const LabView& view, PanelState& state, Ui& ui) {
    TextField& field = state.values.seed;
    const bool was_active = field.active;
    if (!was_active) field.text = std::to_string(view.now->seed);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = text_width(ui, Face::text, ui.strings("values.seed")) + ui.px(10);
    put(ui, {at.x, at.y + (ui.px(ui.tall(button_height)) - line_height(ui, Face::text)) / 2}, ui.strings("values.seed"),
        ui.palette.text);
    ImGui::SetCursorScreenPos({at.x + left, at.y});
    text_field(ui, field, "seed", ui.px(seed_width), {}, ui.strings("values.seed_how"));
    if (field.entered || (was_active && !field.active)) {
        if (field.entered && ui.keyboard) ui.keyboard->focus.clear(), field.active = false;
        if (const auto seed = whole_number<std::uint64_t>(field.text); seed && *seed != view.now->seed)
            ui.outbox.push_back(SeedRequest{*seed});
    }
    ImGui::SetCursorScreenPos({at.x, at.y + ui.px(ui.tall(button_height) + 8)});
    const auto press = [&](std::string_view id, std::string_view words, std::string_view how, Action action) {
        if (small_push_button(ui, {id, {}, ui.strings(words)}, ui.strings(how), key_name(action, ui.strings)))
            ui.outbox.push_back(action);
    };
    press("button.same_start", "button.same_start", "tooltip.same_start", Action::reset);
    ImGui::SameLine(0, ui.px(spacing::small));
    press("button.another_start", "button.another_start", "tooltip.another_start", Action::another_start);
}

void values_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect) {
    std::array buttons{HeadingButton{"values.close", ui.strings("values.close"), ui.strings("tooltip.values"),
                                     key_name(Action::values, ui.strings), false, false, false, icon::cross}};
    const bool open = open_card(state, ui, Card::values, place, buttons);
    if (buttons[0].pressed) ui.outbox.push_back(Action::values);
    if (open) {
        const std::array words{ui.strings("values.arena"), ui.strings("values.kinds")};
        const int chosen = segments(ui, "values.part", words, state.values.kinds ? 1 : 0, card_width(ui));
        if (chosen >= 0) state.values.kinds = chosen == 1;
        state.values.kinds ? kind_values(view, state, ui) : arena_values(view, state, ui);
    }
    end_card(ui, state.card(Card::values));
}

}  // namespace braitenlab::ui
