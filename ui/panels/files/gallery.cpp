// The exercises in the file browser: chapters of cards, each with a still picture of its scene.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "ui/imgui_compat.h"
#include "ui/panels/exercise_names.h"
#include "ui/panels/files/file_lists.h"
#include "ui/panels/scene_picture.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

constexpr std::string_view gallery_stem = "gallery.";
constexpr std::size_t lines_of_card = 3;                                                            // of a goal
constexpr float least_card = 180, card_inset = spacing::small, between_previews = spacing::medium;  // layout pixels

// A disc with a check mark; a ring while the exercise was passed only by the solution that was shown.
void passed_mark(const Ui& ui, ImVec2 c, bool alone) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float radius = ui.px(9), r = radius * 0.5f;
    draw.AddCircleFilled(c, radius, paint(alone ? ui.palette.accent : ui.palette.panel));
    draw.AddCircle(c, radius, paint(ui.palette.accent), 0, ui.px(1.5f));
    draw.PathLineTo({c.x - r, c.y}), draw.PathLineTo({c.x - r * 0.25f, c.y + r * 0.75f});
    draw.PathLineTo({c.x + r, c.y - r * 0.7f});
    draw.PathStroke(paint(alone ? ui.palette.on_accent : ui.palette.accent), 0, ui.px(1.8f));
}

void card_picture(const LabView& view, const Ui& ui, const CatalogueEntry& entry, const ExerciseProgress* progress,
                  Rect place) {
    fill_box(ui, place, mix(ui.palette.raised, ui.palette.line, 0.5f), Corner::box);
    ImGui::PushClipRect({place.x, place.y}, {place.x + place.w, place.y + place.h}, true);
    if (!put_scene_picture(view, ui, entry.path, place) && entry.exercise) {
        const FloorMap map(occupied_area(entry.exercise->scene), place);
        draw_floor(ui, entry.exercise->scene, map);
        draw_vehicles(ui, entry.exercise->scene, map);
    }
    ImGui::PopClipRect();
    if (progress && progress->passed)
        passed_mark(ui, {place.x + place.w - ui.px(13), place.y + ui.px(13)}, !progress->shown);
}

// Of the number of an exercise, its words and its best grade; window pixels.
struct FootColumns {
    float number, words, best;
};

FootColumns foot_columns(const LabView& view, const Ui& ui, const CatalogueEntry& entry, float inner) {
    const std::string number = number_words(view, entry.number, entry.name),
                      best = best_words(progress_of(view, entry));
    FootColumns foot{};
    foot.number = std::max(text_width(ui, Face::strong, "88"), text_width(ui, Face::strong, number)) + ui.px(6);
    foot.best = best.empty() ? 0 : text_width(ui, Face::small, best) + ui.px(6);
    foot.words = inner - foot.number - foot.best;
    return foot;
}

// The lines of the words below the picture.
std::size_t lines_of_foot(const LabView& view, const Ui& ui, const CatalogueEntry& entry, float inner) {
    const float room = foot_columns(view, ui, entry, inner).words;
    return std::clamp<std::size_t>(lines_of_words(ui, exercise_words(view, ui, entry), Face::small, room).size(), 1,
                                   lines_of_card);
}

// `lines`: of the foot. True when the card was pressed.
bool exercise_tile(const LabView& view, Ui& ui, const CatalogueEntry& entry, float width, std::size_t lines) {
    const ExerciseProgress* progress = progress_of(view, entry);
    const float inset = ui.px(card_inset), inner = width - 2 * inset, picture = inner * picture_share;
    const float height =
        picture + 2 * inset + ui.px(spacing::tight) + static_cast<float>(lines) * line_height(ui, Face::small);
    const Item at = item(ui, std::string(gallery_stem) + entry.name, {width, height});
    const bool is_open = entry.name == view.documents.opened;
    fill_box(ui, at.rect, mix(ui.palette.raised, ui.palette.accent, 0.14f * at.warmth));
    line_box(ui, at.rect, is_open ? ui.palette.accent : ui.palette.line, Corner::box, is_open ? 2.0f : 1.0f);
    if (ImGui::IsRectVisible({at.rect.x, at.rect.y}, {at.right(), at.bottom()}))
        card_picture(view, ui, entry, progress, {at.rect.x + inset, at.rect.y + inset, inner, picture});
    const ImVec2 words{at.rect.x + inset, at.rect.y + inset + picture + ui.px(spacing::tight)};
    const std::string number = number_words(view, entry.number, entry.name), best = best_words(progress);
    const FootColumns foot = foot_columns(view, ui, entry, inner);
    put(ui, {words.x, words.y - (line_height(ui, Face::strong) - line_height(ui, Face::small)) / 2}, number,
        ui.palette.text, Face::strong);
    put_right(ui, {at.right() - inset, words.y}, best, ui.palette.second_text, Face::small);
    put_lines(ui, {words.x + foot.number, words.y}, exercise_words(view, ui, entry), ui.palette.text, Face::small,
              foot.words, lines);
    const std::string_view told = told_of(view, ui, entry);
    if (wants_tooltip(ui, at)) tooltip(ui, at, told.empty() ? ui.strings("files.open_how") : told);
    return at.pressed;
}

// The names of the exercises, in rows as they are drawn: a chapter begins a row.
using Rows = std::vector<std::vector<std::string_view>>;
Rows rows_of_gallery(const std::vector<CatalogueEntry>& listed, std::size_t columns) {
    Rows rows;
    int chapter = -1;
    for (const CatalogueEntry& entry : listed) {
        if (entry.number == 0) continue;
        if (entry.chapter != chapter || rows.back().size() == columns) rows.emplace_back();
        chapter = entry.chapter;
        rows.back().push_back(entry.name);
    }
    return rows;
}

// The anchor that gets the focus from the card in this row and column: the nearest one in this direction. Beyond the
// first row it is the choice of the place; beyond the last row and right of a row, `beside`.
std::string neighbour(const std::string& beside, const FilesState& files, const Rows& rows, std::size_t row,
                      std::size_t column, int direction) {
    const auto card = [&](std::size_t r, std::size_t c) {
        return std::string(gallery_stem) + std::string(rows[r][std::min(c, rows[r].size() - 1)]);
    };
    if (direction == key::left) return card(row, column == 0 ? 0 : column - 1);
    if (direction == key::right) return column + 1 < rows[row].size() ? card(row, column + 1) : beside;
    if (direction == key::up)
        return row > 0 ? card(row - 1, column) : "files.place." + std::to_string(static_cast<int>(files.place) + 1);
    return row + 1 < rows.size() ? card(row + 1, column) : beside;
}

// The arrow keys move the focus from card to card. Call before the cards are drawn.
void move_in_gallery(const std::vector<CatalogueEntry>& listed, const std::string& beside, const FilesState& files,
                     Ui& ui, int columns) {
    if (!ui.keyboard || !ui.keyboard->focus.starts_with(gallery_stem)) return;
    const Rows rows = rows_of_gallery(listed, static_cast<std::size_t>(columns));
    for (const int direction : {key::left, key::right, key::up, key::down})
        while (take(*ui.keyboard, direction))
            for (std::size_t row = 0; row < rows.size(); ++row) {
                const auto at = std::find(rows[row].begin(), rows[row].end(),
                                          std::string_view(ui.keyboard->focus).substr(gallery_stem.size()));
                if (at == rows[row].end()) continue;
                const auto column = static_cast<std::size_t>(at - rows[row].begin());
                const std::string next = neighbour(beside, files, rows, row, column, direction);
                if (!next.empty()) ui.keyboard->focus = next;
                ui.keyboard->revealed = true;
                break;
            }
}

}  // namespace

bool put_scene_picture(const LabView& view, const Ui& ui, const std::string& path, Rect place) {
    if (!view.documents.pictures) return false;
    const auto found = view.documents.pictures->find(path);
    if (found == view.documents.pictures->end() || found->second == 0) return false;
    // Rows of the texture are from the bottom.
    ImGui::GetWindowDrawList()->AddImageRounded(compat::texture(found->second), {place.x, place.y},
                                                {place.x + place.w, place.y + place.h}, {0, 1}, {1, 0}, IM_COL32_WHITE,
                                                ui.px(radius::box));
    return true;
}

void exercise_gallery(const LabView& view, const std::vector<CatalogueEntry>& listed, const std::string& beside,
                      FilesState& files, Ui& ui) {
    const float all = card_width(ui), gap_between = ui.px(between_previews);
    const int columns = std::max(1, static_cast<int>((all + gap_between) / (ui.px(least_card) + gap_between)));
    const float width = (all - gap_between * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    move_in_gallery(listed, beside, files, ui, columns);
    int chapter = -1, column = 0;
    // The feet of one row are as high as the highest of them.
    const Rows rows = rows_of_gallery(listed, static_cast<std::size_t>(columns));
    const auto lines_in_row = [&](std::string_view name) {
        std::size_t lines = 1;
        for (const auto& row : rows)
            if (std::find(row.begin(), row.end(), name) != row.end())
                for (const CatalogueEntry& entry : listed)
                    if (std::find(row.begin(), row.end(), entry.name) != row.end())
                        lines = std::max(lines, lines_of_foot(view, ui, entry, width - 2 * ui.px(card_inset)));
        return lines;
    };
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap_between, gap_between});
    std::size_t lines = 1;
    for (const CatalogueEntry& entry : listed) {
        if (entry.number == 0) continue;
        if (entry.chapter != chapter) {
            paragraph(ui, chapter_title(ui, entry.chapter), ui.palette.second_text, Face::small);
            column = 0;
        }
        chapter = entry.chapter;
        if (column > 0)
            ImGui::SameLine();
        else
            lines = lines_in_row(entry.name);
        column = (column + 1) % columns;
        if (exercise_tile(view, ui, entry, width, lines)) request_file(view, files, ui, OpenRequest{entry.path});
        if (entry.name == view.documents.opened && !files.begun) ImGui::SetScrollHereY();
    }
    ImGui::PopStyleVar();
    gap(ui, 8);
}

}  // namespace braitenlab::ui
