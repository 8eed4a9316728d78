// The text field of several lines of text_field.h. Dear ImGui 1.86 does not wrap a line of it; this one breaks it.
#include <algorithm>
#include <utility>

#include <imgui.h>
#include <imgui_internal.h>

#include "ui/imgui_compat.h"
#include "ui/widgets/button.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/text_box.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

struct AreaEdit {
    std::string* text;
    ImFont* font;
    float room;          // for a line, window pixels
    bool cursor_to_end;  // once
    bool is_new;         // once: the active field takes this text over
    std::string given;   // a copy of it
};

// Replaces the text of the active field. The cursor stays as far from its beginning.
void take_over(ImGuiInputTextCallbackData& data, const std::string& given) {
    const int cursor = std::min(data.CursorPos, static_cast<int>(given.size()));
    data.DeleteChars(0, data.BufTextLen);
    data.InsertChars(0, given.data(), given.data() + given.size());
    data.CursorPos = data.SelectionStart = data.SelectionEnd = cursor;
}

// Call after a callback has replaced the text of a field: what it would undo refers to the earlier one. From 1.88 on
// Dear ImGui does so.
void forget_undo([[maybe_unused]] ImGuiID field) {
#if IMGUI_VERSION_NUM < 18800
    ImGuiInputTextState* state = ImGui::GetInputTextState(field);
    if (!state) return;
    auto& undo = state->Stb.undostate;
    undo.undo_point = 0, undo.undo_char_point = 0;
    undo.redo_point = STB_TEXTEDIT_UNDOSTATECOUNT, undo.redo_char_point = STB_TEXTEDIT_UNDOCHARCOUNT;
#endif
}

// Index of the last space of the first line that is too wide; −1 if there is none.
int break_in(const AreaEdit& edit, std::string_view text) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        const float width =
            edit.font->CalcTextSizeA(compat::size_of(edit.font), 1e9f, 0, line.data(), line.data() + line.size()).x;
        const std::size_t space = line.find_last_of(' ');
        if (width > edit.room && space != std::string_view::npos && space > 0) return static_cast<int>(begin + space);
        begin = end + 1;
    }
    return -1;
}

int edit_area(ImGuiInputTextCallbackData* data) {
    auto& edit = *static_cast<AreaEdit*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
        edit.text->resize(static_cast<std::size_t>(data->BufTextLen));
        data->Buf = edit.text->data();
    } else if (data->EventFlag == ImGuiInputTextFlags_CallbackEdit) {
        for (int at = 0; (at = break_in(edit, {data->Buf, static_cast<std::size_t>(data->BufTextLen)})) >= 0;
             data->BufDirty = true)
            data->Buf[at] = '\n';
    } else if (std::exchange(edit.is_new, false)) {
        take_over(*data, edit.given);
    } else if (std::exchange(edit.cursor_to_end, false)) {
        data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
    }
    return 0;
}

void input_area(Ui& ui, TextField& field, std::string_view id, ImVec2 size, ImVec2 pad, bool begins) {
    AreaEdit edit{&field.text,
                  ImGui::GetFont(),
                  size.x - 2 * pad.x - ImGui::GetStyle().ScrollbarSize - ui.px(4),
                  begins,
                  std::exchange(field.is_new, false) && field.active,
                  field.text};
    const bool is_new = edit.is_new;
    ImGui::PushID(id.data(), id.data() + id.size());
    ImGui::InputTextMultiline("##area", field.text.data(), field.text.capacity() + 1, size,
                              ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_CallbackEdit |
                                  ImGuiInputTextFlags_CallbackAlways | ImGuiInputTextFlags_NoHorizontalScroll,
                              edit_area, &edit);
    if (is_new) forget_undo(ImGui::GetID("##area"));
    ImGui::PopID();
}

}  // namespace

void text_area(Ui& ui, TextField& field, std::string_view id, float width, int rows, std::string_view what,
               std::string_view how) {
    const ImVec2 pad{ui.px(spacing::small), ui.px(spacing::small)}, at = ImGui::GetCursorScreenPos();
    const Rect box{at.x, at.y, width, line_height(ui, Face::text) * static_cast<float>(rows) + 2 * pad.y};
    const bool focused = stop_here(ui.keyboard, id);
    compat::push_font(font(ui, Face::text));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, pad);
    const bool begins = focused && !field.active;
    // Not while a mouse button is down: the widget under the pointer would lose the press.
    if (begins && !ImGui::IsAnyItemActive() && !ImGui::IsMouseDown(0)) compat::focus_next_field();
    // Before the field sees the key: Dear ImGui would restore the text from before the first key.
    if (std::exchange(field.ask_leave, false)) ImGui::ClearActiveID();
    input_area(ui, field, id, {box.w, box.h}, pad, begins);
    const TextBox shown{id, box, pad, focused, ImGui::IsItemHovered() && ImGui::IsMouseClicked(0)};
    settle_focus(ui, field, shown);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    finish_text_box(ui, field, shown, what, how);
    field.entered = field.ask_enter = false;
}

bool for_text_area(TextField& field, KeyPress press) {
    if (!field.active) return false;
    if (press.key == key::escape) field.ask_leave = true;
    return press.key != key::tab && press.key != key::escape && press.key < key::f1;
}

}  // namespace braitenlab::ui
