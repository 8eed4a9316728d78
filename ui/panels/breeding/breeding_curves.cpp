#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/breeding/breeding_parts.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using evolve::Side;

class BreedingCurves {
public:
    BreedingCurves(const BreedingView& view, Ui& ui) : view_(view), ui_(ui), last_(last_generation(view)) {
        generations_.high = std::max(1, view.base->breeding().generations);
    }

    void draw(Rect all) {
        mark(ui_, "breeding.curves", all);
        const float small = line_height(ui_, Face::small), space = ui_.px(spacing::tight);
        legend({all.x, all.y});
        const Rect rest{all.x, all.y + small + space, all.w, all.h - 2 * (small + space)};
        const bool has_panel = view_.base->breeding().panel > 0;
        const float height = has_panel ? rest.h / 2 : rest.h;
        plot({rest.x, rest.y, rest.w, height}, {"breeding.score_opponents", "breeding.score_opponents_how"},
             &evolve::Generation::best, !has_panel);
        if (has_panel)
            plot({rest.x, rest.y + height, rest.w, height}, {"breeding.score_panel", "breeding.score_panel_how"},
                 &evolve::Generation::panel, true);
        put_centred(ui_, {all.x + all.w / 2, all.y + all.h - small}, ui_.strings("breeding.generation"),
                    ui_.palette.second_text, Face::small);
    }

private:
    struct Title {
        std::string_view key, how;  // string keys; `key` is its anchor, too
    };

    const std::vector<evolve::Generation>& of(Side side) const { return at(view_.state->main.generations, side); }

    void legend(ImVec2 at) const {
        const float line = line_height(ui_, Face::small), sign = ui_.px(9);
        float x = at.x;
        for (const Side side : evolve::both_sides) {
            if (!view_.base->breed(side)) continue;
            put_role(ui_, {x + sign / 2, at.y + line / 2}, sign, role_of(side));
            x += sign + ui_.px(5);
            const bool is_predator = side == Side::predator;
            x += put(ui_, {x, at.y}, ui_.strings(is_predator ? "info.predators" : "info.prey"), ui_.palette.text,
                     Face::small);
            x += ui_.px(spacing::large);
        }
    }

    void plot(Rect outer, Title title, float evolve::Generation::*score, bool has_numbers) const {
        const auto lines = lines_of_words(ui_, ui_.strings(title.key), Face::small, outer.w).size();
        const float line = static_cast<float>(lines) * line_height(ui_, Face::small);
        put_lines(ui_, {outer.x, outer.y}, ui_.strings(title.key), ui_.palette.second_text, Face::small, outer.w,
                  lines);
        ImGui::SetCursorScreenPos({outer.x, outer.y});
        tooltip(ui_, item(ui_, title.key, {outer.w, line}, false), ui_.strings(title.how));
        Axis across = generations_;
        across.numbers = has_numbers;
        const Rect inner = plot_ground(ui_, {outer.x, outer.y + line, outer.w, outer.h - line}, across, scores_);
        for (const Side side : evolve::both_sides) {
            if (!view_.base->breed(side)) continue;
            const Colour colour = colour_of(ui_.palette, role_of(side));
            const auto point = [&](std::size_t i) {
                const float number = of(side)[i].*score;
                return PlotPoint{static_cast<double>(i), number < 0 ? NAN : number};
            };
            const auto count = static_cast<std::size_t>(last_ + 1);
            plot_line(ui_, inner, across, scores_, count, colour, 2, point);
            if (count == 0) continue;
            ImGui::GetWindowDrawList()->AddCircleFilled(plot_point(inner, across, scores_, point(count - 1)), ui_.px(3),
                                                        paint(colour), 12);
        }
        read_out(inner, across, score);
    }

    void read_out(Rect inner, const Axis& across, float evolve::Generation::*score) const {
        const auto under = plot_cursor(ui_, inner, across);
        if (!under || last_ < 0) return;
        const int generation = std::clamp(static_cast<int>(std::lround(*under)), 0, last_);
        std::vector<std::string> words{std::string(ui_.strings("breeding.generation")) + " " +
                                       std::to_string(generation)};
        std::vector<Colour> colours{ui_.palette.second_text};
        for (const Side side : evolve::both_sides) {
            if (!view_.base->breed(side)) continue;
            words.push_back(std::string(ui_.strings(side == Side::predator ? "info.predators" : "info.prey")) + " " +
                            fixed(ui_, of(side)[static_cast<std::size_t>(generation)].*score, 2));
            colours.push_back(ui_.palette.text);
        }
        const std::vector<std::string_view> lines(words.begin(), words.end());
        plot_words(ui_, inner, ImGui::GetIO().MousePos.x, lines.data(), colours.data(), static_cast<int>(lines.size()));
    }

    const BreedingView& view_;
    Ui& ui_;
    int last_;
    Axis generations_{0, 1, "", 0};
    Axis scores_{0, 1, "", 1};
};

}  // namespace

void breeding_curves(const BreedingView& view, Ui& ui, Rect r) { BreedingCurves(view, ui).draw(r); }

}  // namespace braitenlab::ui
