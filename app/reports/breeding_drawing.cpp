#include "app/reports/breeding_drawing.h"

#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "app/reports/axes.h"
#include "app/reports/svg_file.h"
#include "ui/words/number_text.h"

namespace braitenlab {

namespace {

using evolve::BreedingBase;
using evolve::BreedingState;
using evolve::Generation;
using evolve::Side;
using evolve::Tournament;

constexpr float curves_width = 520, curves_height = 220, curves_step = 330;                 // px
constexpr float matrix_side = 400, matrix_step = 560, drawing_left = 92, drawing_top = 84;  // px

std::string side_name(Side side, const Strings& strings) {
    return std::string(strings(side == Side::predator ? "kind.predator" : "kind.prey"));
}

std::string_view title_of(const evolve::Breeding& breeding, const FigureLabels& labels, const Strings& strings) {
    return labels.title.empty() ? strings.find(breeding.title, breeding.title) : labels.title;
}

std::string panel_heading(Side side, const Strings& strings) {
    return words_at(0, -12, side_name(side, strings), " font-weight=\"bold\"");
}

// What the score counts.
std::string counted_text(const evolve::Breeding& breeding, const Strings& strings) {
    const std::string seconds =
        ui::fixed(breeding.seconds, breeding.seconds == std::floor(breeding.seconds) ? 0 : 1, decimal_mark(strings));
    if (!breeding.measure) return fill(strings("report.breeding_counts_life"), {seconds});
    const auto& measure = row_of(*breeding.measure);
    const std::string name(strings("study.measure." + std::string(measure.word)));
    const Side side = breeding.predator_better == evolve::Better::more ? Side::predator : Side::prey;
    if (measure.unit == "s")
        return fill(strings("report.breeding_counts_time"), {side_name(side, strings), name, seconds});
    const std::string unit = measure.unit.empty() ? "" : fmt::format(" ({})", measure.unit);
    return fill(strings("report.breeding_counts_number"), {side_name(side, strings), name + unit, seconds});
}

// Generations as an axis: never without length.
PlotFrame::Axis generation_axis(int first, int last) {
    return {first == last ? first - 0.5 : first, first == last ? last + 0.5 : last, 1};
}

struct Curve {
    float Generation::*score;
    const char *key, *colour, *dashes;
};
constexpr std::array<Curve, 3> curves{{
    {&Generation::best, "report.breeding_best", "#0072b2", ""},
    {&Generation::median, "report.breeding_median", "#d55e00", " stroke-dasharray=\"2 4\""},
    {&Generation::panel, "report.breeding_panel", "#007a5a", " stroke-dasharray=\"9 4\""},
}};

std::string curve_svg(const Curve& curve, const std::string& data) {
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", data, curve.colour,
                       curve.dashes);
}

std::string curves_of(const std::vector<Generation>& generations, const PlotFrame& frame) {
    std::string out;
    for (const Curve& curve : curves) {
        std::string data;
        for (std::size_t i = 0; i < generations.size(); ++i) {
            const float score = generations[i].*curve.score;
            if (score < 0) continue;  // not known
            data += fmt::format("{}{:.1f} {:.1f}", data.empty() ? 'M' : 'L', frame.x_of(static_cast<double>(i)),
                                frame.y_of(static_cast<double>(score)));
        }
        if (generations.size() == 1 && !data.empty()) data += "h4";  // a curve of one point would not be seen
        if (!data.empty()) out += curve_svg(curve, data);
    }
    return out;
}

std::string curves_legend(bool has_panel, const Strings& strings) {
    std::string out;
    float y = 8;
    for (const Curve& curve : curves) {
        if (curve.score == &Generation::panel && !has_panel) continue;
        out += curve_svg(curve, fmt::format("M0 {}h28", y)) + words_at(36, y + 5, strings(curve.key));
        y += 22;
    }
    return out;
}

std::string cells_of(const Tournament& tournament, Side side, MatrixKind kind, const Strings& strings) {
    constexpr float least_number = 36;  // px, of a cell
    const float cell = matrix_side / static_cast<float>(tournament.size());
    std::string squares, numbers;
    for (std::size_t own = 0; own < tournament.size(); ++own)
        for (std::size_t opponent = 0; opponent < opponents_of(tournament, kind, own); ++opponent) {
            const float score = tournament.score(side, own, opponent);
            const float left = cell * static_cast<float>(opponent),
                        top = matrix_side - cell * static_cast<float>(own + 1);
            squares += fmt::format("<path d=\"{}\" fill=\"{}\"/>\n", square_data(left, top, cell),
                                   colour_text(ui::scale_colour(score)));
            if (cell >= least_number)
                numbers += outlined_text(left + cell / 2, top + cell / 2 + 4, "middle", axis_ink,
                                         ui::fixed(score, 2, decimal_mark(strings)));
        }
    return "<g shape-rendering=\"crispEdges\">\n" + squares + "</g>\n" + numbers;
}

}  // namespace

std::string curves_drawing(const BreedingBase& base, const BreedingState& state, const FigureLabels& labels,
                           const Strings& strings) {
    const auto count = static_cast<std::size_t>(complete_generations(base, state));
    const bool has_panel = base.breeding().panel > 0;
    std::string drawn;
    float top = drawing_top;
    for (const Side side : base.bred_sides()) {
        const std::vector<Generation>& all = at(state.main.generations, side);
        const PlotFrame frame{curves_width, curves_height, generation_axis(0, static_cast<int>(count) - 1), {0, 1}};
        const bool is_first = top == drawing_top;
        drawn +=
            placed(drawing_left, top,
                   panel_heading(side, strings) +
                       frame_svg(frame, labels.x.empty() ? strings("report.breeding_generation") : labels.x,
                                 is_first && !labels.y.empty() ? labels.y : strings("report.breeding_score"), strings) +
                       curves_of({all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count)}, frame) +
                       (is_first ? placed(curves_width + 24, 0, curves_legend(has_panel, strings)) : ""));
        top += curves_step;
    }
    drawn += words_at(drawing_left, top - 30, counted_text(base.breeding(), strings));
    if (has_panel) drawn += words_at(drawing_left, top - 10, strings("report.breeding_rise"));
    return svg_file(title_of(base.breeding(), labels, strings), drawing_left + curves_width + 330, top + 10, drawn);
}

std::string matrix_drawing(const BreedingBase& base, const Tournament& tournament, MatrixKind kind,
                           const FigureLabels& labels, const Strings& strings) {
    const int all = tournament.generations.back() + 1;
    auto axis = generation_axis(tournament.generations.front(), tournament.generations.back());
    axis.cells.assign(tournament.generations.begin(), tournament.generations.end());
    const PlotFrame frame{matrix_side, matrix_side, axis, axis,
                          matrix_side / static_cast<float>(tournament.size()) / 2};
    std::string drawn;
    float left = drawing_left;
    for (const Side side : base.bred_sides()) {
        const bool is_first = left == drawing_left;
        const auto label = [&](const std::string& given, Side of) {
            return is_first && !given.empty()
                       ? given
                       : std::string(strings(of == Side::predator ? "report.breeding_predator_generation"
                                                                  : "report.breeding_prey_generation"));
        };
        drawn += placed(left, drawing_top,
                        panel_heading(side, strings) + cells_of(tournament, side, kind, strings) +
                            frame_svg(frame, label(labels.x, other(side)), label(labels.y, side), strings));
        left += matrix_step;
    }
    const float legend = left - matrix_step + matrix_side + 28;
    drawn +=
        placed(legend, drawing_top,
               words_at(0, 12, strings("report.breeding_score"), " font-weight=\"bold\"") + scale_svg({0, 1}, strings));
    drawn += words_at(drawing_left, drawing_top + matrix_side + 76,
                      fill(strings(kind == MatrixKind::ciao ? "report.breeding_ciao" : "report.breeding_master"),
                           {std::to_string(evolve::tournament_trials)}));
    drawn += words_at(drawing_left, drawing_top + matrix_side + 96, counted_text(base.breeding(), strings));
    if (static_cast<int>(tournament.size()) < all)
        drawn +=
            words_at(drawing_left, drawing_top + matrix_side + 116,
                     fill(strings("report.breeding_chosen"), {std::to_string(tournament.size()), std::to_string(all)}));
    return svg_file(title_of(base.breeding(), labels, strings), legend + 180, drawing_top + matrix_side + 136, drawn);
}

}  // namespace braitenlab
