// The two sums that drive the wheels, with this moment's numbers in them, and which product makes which wheel faster.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/theme.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

namespace {

// One product of a sum: what the eye delivers, and what the wire makes of it.
struct Product {
    std::string_view letters;  // "SL·LL"
    std::string_view plain;    // the eye alone, "SL"
    float input = 0;           // as the eye reads it
    float weight = 0;
    float value = 0;      // what arrives: mask, curve and weight applied
    bool masked = false;  // below the threshold: counts as 0
};

struct Sum {
    std::string_view motor;  // "ML"
    std::string_view bias_letters;
    std::array<Product, 2> products;
    float bias = 0;
    float others = 0;  // what the brain's further wires bring, beyond the four of the equations
    bool more_wires = false;
    float total = 0;  // what the motor really gets, clamped
};

Product product(const LabView& view, const VehicleView& vehicle, const BrainGraph& brain, const char* eye,
                const char* motor, Dial dial, std::string_view letters) {
    Product p{letters, eye, 0, 0, 0, false};
    const Node* from = find_node(brain, std::string(eye));
    const Node* to = find_node(brain, std::string(motor));
    if (!from || !to) return p;
    p.input = node_value(*view.now, vehicle, from->id);
    p.weight = at(read_dials(brain), dial);
    if (const Wire* wire = find_wire(brain, from->id, to->id)) {
        p.value = signal(*wire, p.input);
        p.masked = std::fabs(p.input) < wire->threshold;
    }
    return p;
}

std::array<Sum, 2> sums(const LabView& view, const VehicleView& vehicle) {
    const BrainGraph& brain = *view.now->brains[static_cast<std::size_t>(vehicle.brain)];
    const FourNeurons dials = read_dials(brain);
    const std::array<float, 2>& motors = vehicle.motor;  // of this moment, while time stands still too
    const auto make = [&](const char* eye, const char* motor, Dial dial, std::string_view letters) {
        return product(view, vehicle, brain, eye, motor, dial, letters);
    };
    std::array<Sum, 2> both{{{"ML",
                              "LM",
                              {{make("SL", "ML", Dial::LL, "SL·LL"), make("SR", "ML", Dial::LR, "SR·LR")}},
                              dials.LM,
                              0,
                              false,
                              motors[0]},
                             {"MR",
                              "RM",
                              {{make("SR", "MR", Dial::RR, "SR·RR"), make("SL", "MR", Dial::RL, "SL·RL")}},
                              dials.RM,
                              0,
                              false,
                              motors[1]}}};
    if (is_four_neurons(brain)) return both;
    for (Sum& sum : both) {
        sum.more_wires = true;
        if (const Node* motor = find_node(brain, std::string(sum.motor)))
            sum.others =
                node_value(*view.now, vehicle, motor->id) - sum.products[0].value - sum.products[1].value - sum.bias;
    }
    return both;
}

// What decides which wheel is faster: the largest push towards that difference, from either wheel.
struct Cause {
    float difference = 0;  // MR − ML
    const Product* product = nullptr;
    bool bias = false;        // neither product but the biases
    bool others = false;      // or rather the further wires
    bool holds_back = false;  // it slows the other wheel instead of driving the faster one
};

Cause cause(const std::array<Sum, 2>& both) {
    Cause c;
    c.difference = both[1].total - both[0].total;
    const float towards = c.difference > 0 ? 1.0f : -1.0f;
    const float by_bias = (both[1].bias - both[0].bias) * towards,
                by_others = (both[1].others - both[0].others) * towards;
    float largest = std::max({0.005f, by_bias, by_others});
    c.others = by_others >= largest;
    c.bias = !c.others && by_bias >= largest;
    for (int side = 0; side < 2; ++side)
        for (const Product& p : both[static_cast<std::size_t>(side)].products) {
            const float push = p.value * (side == 1 ? towards : -towards);
            if (push <= largest) continue;
            largest = push;
            c.product = &p;
            c.bias = c.others = false;
            c.holds_back = p.value < 0;
        }
    return c;
}

// Columns of one equation, in layout pixels: motor, =, product, +, product, ±, bias, =, total.
struct Columns {
    float first, second, bias, total;  // the right ends of their numbers
};

void one_product(const Ui& ui, float right, float y, const Product& p, bool strongest) {
    const Palette& c = ui.palette;
    const std::string numbers = fixed(p.masked ? 0 : p.input, 2) + "·" + fixed(p.weight, 2);
    const float w = text_width(ui, Face::small, numbers), h = line_height(ui, Face::small);
    if (strongest) {
        const Colour meaning = colour_of_weight(c, p.value);
        const Rect mark{right - w - ui.px(4), y + h + ui.px(1), w + ui.px(8), h + ui.px(3)};
        fill_box(ui, mark, meaning.with_alpha(0.22f), 4);
        line_box(ui, mark, meaning, 4);
    }
    put_right(ui, {right - (w - text_width(ui, Face::small, p.letters)) / 2, y}, p.letters, c.second_text, Face::small);
    put_right(ui, {right, y + h + ui.px(2)}, numbers, p.masked ? c.second_text : c.text, Face::small);
}

void equation(const Ui& ui, const Sum& sum, const Columns& x, ImVec2 at, const Product* strongest) {
    const Palette& c = ui.palette;
    const float h = line_height(ui, Face::small), numbers = at.y + h + ui.px(2);
    const auto sign = [&](float right, std::string_view words) {
        put_centred(ui, {at.x + ui.px(right), numbers}, words, c.second_text, Face::small);
    };
    put(ui, {at.x, numbers - (line_height(ui, Face::text) - h) / 2}, sum.motor, c.text, Face::strong);
    sign(28, "=");
    one_product(ui, at.x + ui.px(x.first), at.y, sum.products[0], &sum.products[0] == strongest);
    sign((x.first + x.second - 60) / 2, "+");
    one_product(ui, at.x + ui.px(x.second), at.y, sum.products[1], &sum.products[1] == strongest);
    // A longer brain's further wires stand with the bias, so that the sum is right.
    const std::string letters =
        std::string(sum.bias_letters) + (sum.more_wires ? "+" + std::string(ui.strings("sums.others")) : "");
    put_right(ui, {at.x + ui.px(x.bias), at.y}, letters, c.second_text, Face::small);
    put_right(ui, {at.x + ui.px(x.bias), numbers}, with_sign(sum.bias + sum.others, 2), c.text, Face::small);
    sign((x.bias + x.total - 43) / 2, "=");
    put_right(ui, {at.x + ui.px(x.total), numbers - (line_height(ui, Face::text) - h) / 2}, with_sign(sum.total, 2),
              c.text, Face::strong);
}

std::string verdict(const Ui& ui, const std::array<Sum, 2>& both, const Cause& why) {
    constexpr float alike = 0.02f;
    if (std::fabs(both[0].total) < alike && std::fabs(both[1].total) < alike)
        return std::string(ui.strings("sums.still"));
    if (std::fabs(why.difference) < alike) return std::string(ui.strings("sums.straight"));
    const std::string_view wheel = ui.strings(why.difference > 0 ? "sums.right_faster" : "sums.left_faster");
    if (why.product)
        return fill(ui.strings(why.holds_back ? "sums.because_held" : "sums.because"),
                    {wheel, why.product->letters, with_sign(why.product->value, 2)});
    return fill(ui.strings(why.others ? "sums.because_others" : "sums.because_bias"), {wheel});
}

}  // namespace

void equations(const LabView& view, Ui& ui, const VehicleView& vehicle) {
    const std::array<Sum, 2> both = sums(view, vehicle);
    const Cause why = cause(both);
    const float width = card_width(ui) / ui.scale;
    const Columns x{width < 300 ? 98.0f : 102.0f, width < 300 ? 174.0f : 186.0f, width - 62, width};
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float row = 2 * line_height(ui, Face::small) + ui.px(8);
    const Product* strongest = std::fabs(why.difference) < 0.02f ? nullptr : why.product;
    equation(ui, both[0], x, at, strongest);
    equation(ui, both[1], x, {at.x, at.y + row}, strongest);
    const Item area = item(ui, "equations", {card_width(ui), 2 * row}, false);
    const bool more = !is_four_neurons(*view.now->brains[static_cast<std::size_t>(vehicle.brain)]);
    tooltip(ui, area, ui.strings(more ? "sums.more_wires" : "sums.how"));
    paragraph(ui, verdict(ui, both, why), ui.palette.text, Face::small);
}

}  // namespace braitenlab
