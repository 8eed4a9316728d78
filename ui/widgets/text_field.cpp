#include "ui/widgets/text_field.h"

#include <utility>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/widgets/button.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

int grow(ImGuiInputTextCallbackData* data) {
    auto& text = *static_cast<std::string*>(data->UserData);
    text.resize(static_cast<std::size_t>(data->BufTextLen));
    data->Buf = text.data();
    return 0;
}

}  // namespace

void text_field(Ui& ui, TextField& field, std::string_view id, float width, std::string_view what,
                std::string_view how) {
    const float height = ui.px(button_height);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box{at.x, at.y, width, height};
    const bool focused = stop_here(ui.keyboard, id);
    compat::push_font(font(ui, Face::text));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {ui.px(spacing::small), (height - line_height(ui, Face::text)) / 2});
    ImGui::SetNextItemWidth(width);
    // Not while a mouse button is down: the widget under the pointer would lose the press.
    if (focused && !field.active && !ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(0)) ImGui::SetKeyboardFocusHere();
    ImGui::PushID(id.data(), id.data() + id.size());
    ImGui::InputText("##text", field.text.data(), field.text.capacity() + 1,
                     ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_AutoSelectAll, grow, &field.text);
    ImGui::PopID();
    const bool clicked = ImGui::IsItemClicked();
    field.active = ImGui::IsItemActive();
    if (clicked && ui.keyboard) ui.keyboard->focus = id;
    if (!clicked && ImGui::IsMouseClicked(0) && !ImGui::IsItemHovered()) leave(ui.keyboard, id);
    if (field.active && !focused && !clicked) ImGui::ClearActiveID(), field.active = false;
    takes_text(ui.keyboard, id, field.active);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    if (field.text.empty())
        put(ui, {box.x + ui.px(spacing::small), box.y + (height - line_height(ui, Face::text)) / 2},
            shortened(ui, what, Face::text, width - ui.px(20)), ui.palette.second_text);
    line_box(ui, box, focused ? ui.palette.accent : ui.palette.line, 6, focused ? 1.5f : 1.0f);
    mark(ui, id, box);
    Item field_item{.rect = box, .hovered = ImGui::IsItemHovered(), .held = field.active};
    if (ui.shown) {
        field_item.shown = static_cast<int>(ui.shown->size());
        ui.shown->push_back({std::string(id), false, box, true});
    }
    tooltip(ui, field_item, how);
    field.entered = std::exchange(field.ask_enter, false);
    field.drawn = true;
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
