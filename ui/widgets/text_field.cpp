#include "ui/widgets/text_field.h"

#include <utility>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/widgets/button.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/text_box.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

int follow_text(ImGuiInputTextCallbackData* data) {
    auto& field = *static_cast<TextField*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        field.text.resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = field.text.data();
    } else if (std::exchange(field.at_end, false)) {
        data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
    }
    return 0;
}

}  // namespace

void settle_focus(Ui& ui, TextField& field, const TextBox& shown) {
    field.active = ImGui::IsItemActive();
    if (field.active && ui.keyboard) ui.keyboard->field = shown.box;
    if (shown.clicked && ui.keyboard) ui.keyboard->focus = shown.id;
    if (!shown.clicked && ImGui::IsMouseClicked(0) && !ImGui::IsItemHovered()) leave(ui.keyboard, shown.id);
    if (field.active && !shown.focused && !shown.clicked) ImGui::ClearActiveID(), field.active = false;
    takes_text(ui.keyboard, shown.id, field.active);
}

void finish_text_box(Ui& ui, TextField& field, const TextBox& shown, std::string_view what, std::string_view how) {
    const Rect box = shown.box;
    const std::string visible =
        field.text.empty() ? shortened(ui, what, Face::text, box.w - 2 * shown.pad.x) : std::string();
    put(ui, {box.x + shown.pad.x, box.y + shown.pad.y}, visible, ui.palette.second_text);
    line_box(ui, box, shown.focused ? ui.palette.accent : ui.palette.line, Corner::box, shown.focused ? 1.5f : 1.0f);
    mark(ui, shown.id, box);
    // No tooltip for words that the field shows.
    Item item{.rect = box, .hovered = ImGui::IsItemHovered() && visible != how, .held = field.active};
    if (ui.shown) {
        item.shown = static_cast<int>(ui.shown->size());
        ui.shown->push_back({std::string(shown.id), false, box, true});
    }
    tooltip(ui, item, how);
    field.drawn = true;
}

void text_field(Ui& ui, TextField& field, std::string_view id, float width, std::string_view what,
                std::string_view how) {
    const float height = ui.px(ui.tall(button_height));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box{at.x, at.y, width, height};
    const ImVec2 pad{ui.px(spacing::small), (height - line_height(ui, Face::text)) / 2};
    const bool focused = stop_here(ui.keyboard, id);
    compat::push_font(font(ui, Face::text));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, pad);
    ImGui::SetNextItemWidth(width);
    // Not while a mouse button is down: the widget under the pointer would lose the press.
    if (focused && !field.active && !ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(0)) compat::focus_next_field();
    ImGui::PushID(id.data(), id.data() + id.size());
    const int masked = field.is_masked ? ImGuiInputTextFlags_Password : 0;
    ImGui::InputText("##text", field.text.data(), field.text.capacity() + 1,
                     ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_CallbackAlways |
                         ImGuiInputTextFlags_AutoSelectAll | masked,
                     follow_text, &field);
    ImGui::PopID();
    const TextBox shown{id, box, pad, focused, ImGui::IsItemClicked()};
    settle_focus(ui, field, shown);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    finish_text_box(ui, field, shown, what, how);
    field.entered = std::exchange(field.ask_enter, false);
}

bool keep_drawn(TextField& field) {
    const bool drawn = std::exchange(field.drawn, false);
    if (!drawn) field.active = field.ask_enter = false;
    return drawn;
}

bool for_text_field(TextField& field, KeyPress press) {
    if (!field.active) return false;
    if (press.key == key::enter) field.ask_enter = true;
    return press.key != key::tab && press.key != key::up && press.key != key::down && press.key != key::escape &&
           press.key < key::f1;
}

}  // namespace braitenlab::ui
