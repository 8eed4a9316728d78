// The sums of both motors in numbers, and the cause of the difference between the wheels.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <imgui.h>

#include "ui/panels/brain_analysis.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

constexpr float equal_commands = 0.02f;  // a smaller difference of wheel commands makes no visible turn

std::string numbers_of(const Ui& ui, const Product& p) {
    const std::string input = fixed(p.input, 2) + "·";
    return input + (p.cut ? std::string(ui.strings("sums.cut")) : as_factor(p.weight, 2));
}

// x of the parts of both equations, from left to right; window pixels. Each part is as wide as its widest number, so
// that only a change of a weight moves them.
struct EquationColumns {
    float equals, first, plus, second, bias, others, result, total;  // middles of signs, else right ends
};

EquationColumns equation_columns(const Ui& ui, const std::array<MotorSum, 2>& both, float left, float width) {
    const auto product = [&](std::size_t i) {
        return std::max(text_width(ui, Face::small, numbers_of(ui, both[0].products[i])),
                        text_width(ui, Face::small, numbers_of(ui, both[1].products[i])));
    };
    const float sign = text_width(ui, Face::small, "="), number = text_width(ui, Face::small, with_sign(1, 2));
    const bool more = both[0].more_wires;
    const float others = more ? std::max(number, text_width(ui, Face::small, ui.strings("sums.others"))) : 0;
    const float total = text_width(ui, Face::strong, with_sign(1, 2)), name = text_width(ui, Face::strong, "MR");
    const float taken = name + 3 * sign + product(0) + product(1) + number + others + total;
    const float space = std::max(0.0f, (width - taken) / (more ? 8 : 7));
    EquationColumns c{};
    float x = left + name;
    const auto right_end = [&](float w) { return x += space + w; };
    c.equals = right_end(sign) - sign / 2;
    c.first = right_end(product(0));
    c.plus = right_end(sign) - sign / 2;
    c.second = right_end(product(1));
    c.bias = right_end(number);
    c.others = more ? right_end(others) : x;
    c.result = right_end(sign) - sign / 2;
    c.total = left + width;
    return c;
}

void one_product(const Ui& ui, float right, float y, const Product& p, bool strongest) {
    const Palette& c = ui.palette;
    const std::string numbers = numbers_of(ui, p);
    const float w = text_width(ui, Face::small, numbers), h = line_height(ui, Face::small);
    if (strongest) {
        const Colour meaning = colour_of_weight(c, p.value);
        const Rect mark{right - w - ui.px(3), y + h + ui.px(1), w + ui.px(6), h + ui.px(3)};
        fill_box(ui, mark, meaning.with_alpha(0.22f), 4);
        line_box(ui, mark, meaning, 4);
    }
    put_centred(ui, {right - w / 2, y}, p.letters, c.second_text, Face::small);
    put_right(ui, {right, y + h + ui.px(2)}, numbers, p.masked || p.cut ? c.second_text : c.text, Face::small);
}

// A signed number below its name.
void signed_term(const Ui& ui, float right, float y, std::string_view letters, float value) {
    put_right(ui, {right, y}, letters, ui.palette.second_text, Face::small);
    put_right(ui, {right, y + line_height(ui, Face::small) + ui.px(2)}, with_sign(value, 2), ui.palette.text,
              Face::small);
}

void equation(const Ui& ui, const MotorSum& sum, const EquationColumns& x, ImVec2 at, const Product* strongest) {
    const Palette& c = ui.palette;
    const float h = line_height(ui, Face::small), numbers = at.y + h + ui.px(2);
    const float large = numbers - (line_height(ui, Face::text) - h) / 2;
    const auto sign = [&](float middle, std::string_view words) {
        put_centred(ui, {middle, numbers}, words, c.second_text, Face::small);
    };
    put(ui, {at.x, large}, sum.motor, c.text, Face::strong);
    sign(x.equals, "=");
    one_product(ui, x.first, at.y, sum.products[0], &sum.products[0] == strongest);
    sign(x.plus, "+");
    one_product(ui, x.second, at.y, sum.products[1], &sum.products[1] == strongest);
    signed_term(ui, x.bias, at.y, sum.bias_letters, sum.bias);
    if (sum.more_wires) signed_term(ui, x.others, at.y, ui.strings("sums.others"), sum.others);
    sign(x.result, sum.limited ? "→" : "=");  // → when the sum is limited to −1..1
    put_right(ui, {x.total, large}, with_sign(sum.total, 2), sum.stopped ? c.second_text : c.text, Face::strong);
}

std::string explanation(const Ui& ui, const std::array<MotorSum, 2>& both, const Cause& why, bool is_stuck) {
    if (both[0].stopped && both[1].stopped) return std::string(ui.strings("sums.both_stopped"));
    if (both[0].stopped || both[1].stopped)
        return std::string(ui.strings(both[0].stopped ? "sums.left_stopped" : "sums.right_stopped"));
    if (std::fabs(both[0].total) < equal_commands && std::fabs(both[1].total) < equal_commands)
        return std::string(ui.strings("sums.still"));
    if (std::fabs(why.difference) < equal_commands)
        return std::string(ui.strings(is_stuck ? "sums.stuck" : "sums.straight"));
    const std::string_view wheel = ui.strings(why.difference > 0 ? "sums.right_faster" : "sums.left_faster");
    if (why.by == Cause::By::product)
        return fill(ui.strings(why.holds_back ? "sums.because_held" : "sums.because"),
                    {wheel, why.product->letters, with_sign(why.product->value, 2)});
    return fill(ui.strings(why.by == Cause::By::others ? "sums.because_others" : "sums.because_bias"), {wheel});
}

}  // namespace

void equations(const LabView& view, Ui& ui, const VehicleView& vehicle) {
    const std::array<MotorSum, 2> both = motor_sums(*view.now, vehicle);
    const Cause why = cause(both);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const EquationColumns x = equation_columns(ui, both, at.x, card_width(ui));
    const float row = 2 * line_height(ui, Face::small) + ui.px(8);
    const bool stopped = both[0].stopped || both[1].stopped;
    const Product* strongest = stopped || std::fabs(why.difference) < equal_commands ? nullptr : why.product;
    equation(ui, both[0], x, at, strongest);
    equation(ui, both[1], x, {at.x, at.y + row}, strongest);
    const Item area = item(ui, "equations", {card_width(ui), 2 * row}, false);
    tooltip(ui, area, ui.strings(both[0].more_wires ? "sums.more_wires" : "sums.how"));
    // The wheels are driven and the vehicle does not move: it is blocked. Not known in the first half second.
    const bool is_stuck = view.mode == Mode::playing && view.now->tick > 30 && std::fabs(vehicle.speed) < 0.02f;
    paragraph(ui, explanation(ui, both, why, is_stuck), ui.palette.text, Face::small);
}

}  // namespace braitenlab::ui
