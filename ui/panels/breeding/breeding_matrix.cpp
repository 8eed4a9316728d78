#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include <imgui.h>

#include "ui/panels/breeding/breeding_parts.h"
#include "ui/widgets/item.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using evolve::Side;
using evolve::Tournament;

constexpr float legend_bar = 12;  // layout pixels

// From the colour of the prey over that of the panel to that of the predator.
Colour colour_of_score(const Palette& p, float score) {
    const Colour middle = mix(p.panel, p.text, 0.12f);
    return score < 0.5f ? mix(p.prey, middle, 2 * score) : mix(middle, p.predator, 2 * score - 1);
}

// Beside the field: the numbers of the predators. Above and below it: the names of the axes, numbers and the legend.
float numbers_width(const Ui& ui) { return text_width(ui, Face::label, "0000") + ui.px(spacing::tight); }
float around_field(const Ui& ui) {
    return line_height(ui, Face::label) + 3 * line_height(ui, Face::small) + ui.px(legend_bar + 2 * spacing::small);
}

// Indices of a cell in Tournament::generations.
struct MatrixPlace {
    std::size_t predator = 0, prey = 0;
};

class BreedingMatrix {
public:
    BreedingMatrix(const BreedingView& view, Ui& ui) : view_(view), matrix_(*view.matrix), ui_(ui) {}

    void draw(Rect all) {
        lay_out(all);
        axes(all);
        ImGui::SetCursorScreenPos({field_.x, field_.y});
        const Item area = item(ui_, "breeding.matrix", {field_.w, field_.h});
        fill_box(ui_, field_, ui_.palette.ground, Corner::square);
        cells();
        react(area);
        line_box(ui_, field_, ui_.palette.line, Corner::square);
        legend();
        if (matrix_.size() == 0) say_what_comes_first();
    }

private:
    // In the middle of the field.
    void say_what_comes_first() const {
        constexpr std::size_t most = 6;  // lines
        const std::string_view words = ui_.strings(breeds_panel(view_) ? "breeding.empty_panel" : "breeding.empty");
        const float width = field_.w - ui_.px(spacing::large), line = line_height(ui_, Face::small);
        const std::size_t lines = std::min(most, lines_of_words(ui_, words, Face::small, width).size());
        put_lines(ui_,
                  {field_.x + ui_.px(spacing::small), field_.y + (field_.h - line * static_cast<float>(lines)) / 2},
                  words, ui_.palette.second_text, Face::small, width, most);
    }

    // While it grows, the cells keep their size.
    std::size_t places() const {
        const int wanted = view_.base->breeding().generations;
        if (last_generation(view_) >= wanted) return matrix_.size();
        return std::max(matrix_.size(), static_cast<std::size_t>(std::min(most_in_matrix, wanted + 1)));
    }

    // A square field, with the names and numbers of both axes and the legend around it.
    void lay_out(Rect all) {
        const float line = line_height(ui_, Face::small), left = numbers_width(ui_);
        const float side = std::floor(std::min(all.w - left, all.h - around_field(ui_)));
        cell_ = side / static_cast<float>(places());
        field_ = {all.x + left, all.y + line + ui_.px(spacing::tight), side, side};
    }

    Rect rect_of(MatrixPlace place) const {
        const float x = std::floor(field_.x + cell_ * static_cast<float>(place.prey));
        const float y = std::floor(field_.y + field_.h - cell_ * static_cast<float>(place.predator + 1));
        return {x, y, std::floor(field_.x + cell_ * static_cast<float>(place.prey + 1)) - x - 1,
                std::floor(field_.y + field_.h - cell_ * static_cast<float>(place.predator)) - y - 1};
    }

    BreedingCell cell_at(MatrixPlace place) const {
        return {matrix_.generations[place.predator], matrix_.generations[place.prey]};
    }

    std::optional<MatrixPlace> place_of(BreedingCell cell) const {
        const auto index = [&](int generation) {
            return static_cast<std::size_t>(
                std::find(matrix_.generations.begin(), matrix_.generations.end(), generation) -
                matrix_.generations.begin());
        };
        const MatrixPlace place{index(cell.predator), index(cell.prey)};
        if (std::max(place.predator, place.prey) >= matrix_.size()) return std::nullopt;
        return place;
    }

    std::optional<MatrixPlace> under(ImVec2 mouse) const {
        const float x = (mouse.x - field_.x) / cell_, y = (field_.y + field_.h - mouse.y) / cell_;
        const auto count = static_cast<float>(matrix_.size());
        if (x < 0 || y < 0 || x >= count || y >= count) return std::nullopt;
        return MatrixPlace{static_cast<std::size_t>(y), static_cast<std::size_t>(x)};
    }

    // Numbers at equal distances, as many as have room.
    void axes(Rect all) const {
        const Colour quiet = ui_.palette.second_text;
        const float line = line_height(ui_, Face::label), space = ui_.px(spacing::tight);
        put(ui_, {all.x, all.y}, shortened(ui_, ui_.strings("breeding.axis_predator"), Face::small, all.w), quiet,
            Face::small);
        put_centred(ui_, {field_.x + field_.w / 2, field_.y + field_.h + line + ui_.px(2)},
                    shortened(ui_, ui_.strings("breeding.axis_prey"), Face::small, field_.w), quiet, Face::small);
        const float room = std::max(text_width(ui_, Face::label, "000") + 2 * space, line);
        const auto step = static_cast<std::size_t>(std::max(1.0f, std::ceil(room / cell_)));
        for (std::size_t i = 0; i < matrix_.size(); i += step) {
            const std::string number = std::to_string(matrix_.generations[i]);
            const Rect r = rect_of({i, i});
            put_right(ui_, {field_.x - space, r.y + (r.h - line) / 2}, number, quiet, Face::label);
            put_centred(ui_, {r.x + r.w / 2, field_.y + field_.h + ui_.px(1)}, number, quiet, Face::label);
        }
    }

    void cells() {
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        for (std::size_t predator = 0; predator < matrix_.size(); ++predator)
            for (std::size_t prey = 0; prey < matrix_.size(); ++prey) {
                const Rect r = rect_of({predator, prey});
                const float score = matrix_.score(Side::predator, predator, prey);
                if (std::isnan(score)) continue;
                draw.AddRectFilled({r.x, r.y}, {r.x + r.w, r.y + r.h}, paint(colour_of_score(ui_.palette, score)));
            }
        name_cells();  // last: the ring of a cell that pulses is over its neighbours
        for (const BreedingCell& watched : view_.watched)
            if (const auto place = place_of(watched)) frame_cell(*place, false);
        if (const auto place = place_of(chosen_cell(view_))) frame_cell(*place, true);
    }

    void name_cells() {
        for (std::size_t predator = 0; predator < matrix_.size(); ++predator)
            for (std::size_t prey = 0; prey < matrix_.size(); ++prey) {
                const BreedingCell cell = cell_at({predator, prey});
                mark(ui_, "breeding.cell." + std::to_string(cell.predator) + "." + std::to_string(cell.prey),
                     rect_of({predator, prey}));
            }
    }

    void frame_cell(MatrixPlace place, bool is_chosen) const {
        const Rect r = rect_of(place);
        line_box(ui_, {r.x - 1, r.y - 1, r.w + 2, r.h + 2}, ui_.palette.text, Corner::square, is_chosen ? 2.5f : 1.5f);
    }

    void watch(MatrixPlace place) {
        ui_.outbox.emplace_back(BreedingRequest{.edit = BreedingEdit::watch, .cell = cell_at(place)});
    }

    void react(const Item& area) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const auto place = area.hovered ? under(mouse) : std::nullopt;
        if (area.focused) watch_by_keys(area.entered);
        if (place && area.pressed && !area.entered) watch(*place);
        if (place) line_box(ui_, rect_of(*place), ui_.palette.text, Corner::square);
        if (!wants_tooltip(ui_, area)) return;
        std::string words(ui_.strings("breeding.matrix_how"));
        if (place) words = words_of(*place);
        tooltip(ui_, area, words);
    }

    std::string words_of(MatrixPlace place) const {
        const BreedingCell cell = cell_at(place);
        const float score = matrix_.score(Side::predator, place.predator, place.prey);
        return fill(ui_.strings("breeding.cell"), {std::to_string(cell.predator), std::to_string(cell.prey),
                                                   std::isnan(score) ? "–" : fixed(ui_, score, 2)});
    }

    // From the watched cell, else from the last one. Enter watches the last one.
    void watch_by_keys(bool entered) {
        const int size = static_cast<int>(matrix_.size());
        if (size == 0) return;
        const auto watched = view_.watched.empty() ? std::nullopt : place_of(view_.watched.front());
        int predator = watched ? static_cast<int>(watched->predator) : size - 1;
        int prey = watched ? static_cast<int>(watched->prey) : size - 1;
        const int before = predator * size + prey;
        while (take(*ui_.keyboard, key::left)) --prey;
        while (take(*ui_.keyboard, key::right)) ++prey;
        while (take(*ui_.keyboard, key::down)) --predator;
        while (take(*ui_.keyboard, key::up)) ++predator;
        predator = std::clamp(predator, 0, size - 1), prey = std::clamp(prey, 0, size - 1);
        if (predator * size + prey == before && !(entered && !watched)) return;
        watch({static_cast<std::size_t>(predator), static_cast<std::size_t>(prey)});
    }

    void legend() const {
        constexpr int steps = 24;
        const float y = field_.y + field_.h + line_height(ui_, Face::label) + line_height(ui_, Face::small) +
                        ui_.px(spacing::small);
        const float sign = ui_.px(9), height = ui_.px(legend_bar), inset = sign + ui_.px(spacing::small);
        const float x = field_.x + inset, w = (field_.w - 2 * inset) / steps;
        put_role(ui_, {field_.x + sign / 2, y + height / 2}, sign, Role::prey);
        put_role(ui_, {field_.x + field_.w - sign / 2, y + height / 2}, sign, Role::predator);
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        for (int i = 0; i < steps; ++i)
            draw.AddRectFilled({x + w * static_cast<float>(i), y}, {x + w * static_cast<float>(i + 1), y + height},
                               paint(colour_of_score(ui_.palette, static_cast<float>(i) / (steps - 1))));
        const bool has_time = !view_.base->breeding().measure;
        const float below = y + height + ui_.px(1), space = ui_.px(spacing::small);
        const std::string_view least = has_time ? ui_.strings("breeding.score_0") : "0",
                               most = has_time ? ui_.strings("breeding.score_1") : "1";
        const float both = text_width(ui_, Face::small, least) + space + text_width(ui_, Face::small, most);
        const float beyond = std::max(0.0f, both - field_.w);  // below the numbers of the predators, too
        put(ui_, {field_.x - std::min(beyond, numbers_width(ui_)), below}, least, ui_.palette.text, Face::small);
        put_right(ui_, {field_.x + field_.w + std::max(0.0f, beyond - numbers_width(ui_)), below}, most,
                  ui_.palette.text, Face::small);
    }

    const BreedingView& view_;
    const Tournament& matrix_;
    Ui& ui_;
    Rect field_;
    float cell_ = 1;
};

}  // namespace

float breeding_matrix_width(const Ui& ui, float height) { return height - around_field(ui) + numbers_width(ui); }

void breeding_matrix(const BreedingView& view, Ui& ui, Rect r) { BreedingMatrix(view, ui).draw(r); }

}  // namespace braitenlab::ui
