// The sums of both motors in numbers, and the cause of the difference between the wheels.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "core/insight/why.h"
#include "ui/panels/brain/brain_analysis.h"
#include "ui/panels/panels.h"
#include "ui/shortcuts.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/wiring/node_text.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Between two parts of an equation, layout pixels. With factors, signs are between the numbers.
constexpr float least_space = spacing::tight, least_factor_space = spacing::hair;

// "0.42·1.50"; "0.20 < θ" for a reading that the threshold masks, as the picture of the brain shows the reading.
std::string numbers_of(const Ui& ui, const Product& p) {
    if (p.masked && !p.cut) return fixed(ui, p.reading, 2) + " < θ";
    const std::string input = fixed(ui, p.input, 2) + "·";
    return input + (p.cut ? std::string(ui.strings("sums.cut")) : as_factor(ui, p.weight, 2));
}

// The parts of both equations between "=" and the result, from left to right. A brain with more wires than the products
// has a column for each contribution, without factors.
std::size_t term_columns(const std::array<MotorSum, 2>& both) {
    return std::max(both[0].terms.size(), both[1].terms.size());
}

// Adds the terms of the last column to the rest.
void drop_last_column(std::array<MotorSum, 2>& both) {
    const std::size_t columns = term_columns(both);
    for (MotorSum& sum : both) {
        if (sum.terms.size() < columns) continue;
        sum.rest += sum.terms.back().value;
        sum.terms.pop_back();
    }
}

// Adds the biases to the rest, whose column is there also without them.
void add_biases_to_rest(std::array<MotorSum, 2>& both) {
    for (MotorSum& sum : both) {
        if (!sum.more_wires) continue;
        sum.rest += std::exchange(sum.bias, 0.0f);
        sum.bias_letters = {};
    }
}

// "LR" for "greenR·LR": the sliders above have the same names.
void name_by_wires(std::array<MotorSum, 2>& both) {
    constexpr std::string_view dot = "·";
    for (MotorSum& sum : both)
        for (Product& p : sum.products)
            if (const auto at = p.label.find(dot); at != std::string::npos) p.label.erase(0, at + dot.size());
}

// x of the parts, window pixels. Each part is as wide as its widest number, so that only a change of a weight moves
// them.
struct EquationColumns {
    float equals, first, plus, second;      // middles of signs, else right ends
    std::array<float, most_terms> terms{};  // right ends
    float bias, rest, result, total;
    float space;   // between two parts
    bool factors;  // products are shown as "0.11·1.50", else by their value
    Face face;     // of the numbers
};

EquationColumns equation_columns(const Ui& ui, const std::array<MotorSum, 2>& both, bool factors, float left,
                                 float width, Face face = Face::small) {
    const bool more = both[0].more_wires;
    const float equals = std::max(text_width(ui, face, "="), text_width(ui, face, "≈"));
    const float sign = std::max(equals, more ? text_width(ui, face, "→") : 0);
    const float number = text_width(ui, face, with_sign(ui, 1, 2));
    const auto product = [&](std::size_t i) {
        float widest = 0;
        for (const MotorSum& sum : both) {
            Product unmasked = sum.products[i];  // as wide, so that a reading that passes θ moves nothing
            unmasked.masked = false;
            widest = std::max(widest, !factors ? std::max(number, text_width(ui, Face::label, unmasked.label))
                                               : text_width(ui, face, numbers_of(ui, unmasked)));
        }
        return widest;
    };
    const auto term = [&](std::size_t i) {
        float widest = number;
        for (const MotorSum& sum : both)
            if (i < sum.terms.size()) widest = std::max(widest, text_width(ui, Face::label, sum.terms[i].label));
        return widest;
    };
    const float rest = more ? std::max(number, text_width(ui, Face::label, ui.strings("sums.rest"))) : 0;
    const bool has_bias = !both[0].bias_letters.empty();
    const float total = text_width(ui, Face::strong, with_sign(ui, 1, 2)), name = text_width(ui, Face::strong, "MR");
    const std::size_t terms = term_columns(both);
    const bool products = both[0].shows_products;
    float taken = name + (factors ? 3 : 2) * sign + (has_bias ? number : 0) + rest + total;
    if (products) taken += product(0) + product(1);
    for (std::size_t i = 0; i < terms; ++i) taken += term(i);
    const std::size_t spaces = 3 + (has_bias ? 1 : 0) + (products ? 2 : 0) + (more ? 1 + terms : factors ? 1 : 0);
    const float space = std::max(0.0f, (width - taken) / static_cast<float>(spaces));
    EquationColumns c{};
    c.space = space;
    c.factors = factors;
    c.face = face;
    float x = left + name;
    const auto end_of = [&](float w) { return x += space + w; };
    c.equals = end_of(sign) - sign / 2;
    if (products) c.first = end_of(product(0));
    if (factors) c.plus = end_of(sign) - sign / 2;
    if (products) c.second = end_of(product(1));
    for (std::size_t i = 0; i < terms; ++i) c.terms[i] = end_of(term(i));
    c.bias = has_bias ? end_of(number) : x;
    c.rest = more ? end_of(rest) : x;
    c.result = end_of(sign) - sign / 2;
    c.total = left + width;
    return c;
}

// The numbers are below their names; window pixels.
float below_name(const Ui& ui) { return line_height(ui, Face::label) + ui.px(spacing::hair); }

// The cause of a turn is marked by a box in the colour of its sign.
void mark_cause(const Ui& ui, float right, float y, const std::string& numbers, float value, Face face) {
    const float w = text_width(ui, face, numbers), h = line_height(ui, face);
    const Colour meaning = colour_of_weight(ui.palette, value);
    const Rect mark{right - w - ui.px(3), y + below_name(ui) - ui.px(1), w + ui.px(6), h + ui.px(3)};
    fill_box(ui, mark, meaning.with_alpha(0.22f));
    line_box(ui, mark, meaning);
}

// In a lecture the names above the numbers are as dark as these.
Colour colour_of_names(const Ui& ui) { return ui.least_type > 0 ? ui.palette.text : ui.palette.second_text; }

void one_product(const Ui& ui, float right, float y, const Product& p) {
    const std::string numbers = numbers_of(ui, p);
    const float w = text_width(ui, Face::small, numbers);  // with factors there is room
    put_centred(ui, {right - w / 2, y}, p.label, colour_of_names(ui), Face::label);
    put_right(ui, {right, y + below_name(ui)}, numbers, p.masked || p.cut ? ui.palette.second_text : ui.palette.text,
              Face::small);
}

// A signed number of a sum; also zero has a sign unless it is the first.
std::string addend(const Ui& ui, float value, bool first) {
    const std::string signed_value = with_sign(ui, value, 2);
    return !first && signed_value == fixed(ui, 0, 2) ? "+" + signed_value : signed_value;
}

// A number of a sum below its name.
void signed_term(const Ui& ui, float right, float y, std::string_view letters, float value, bool first, Face face) {
    put_right(ui, {right, y}, letters, colour_of_names(ui), Face::label);
    put_right(ui, {right, y + below_name(ui)}, addend(ui, value, first), ui.palette.text, face);
}

// The sum of the numbers that are shown. With `factors` a product is that of its shown factors.
float sum_of_shown(const MotorSum& sum, bool factors) {
    const auto shown = [](float value) { return std::round(value * 100) / 100; };
    float all = shown(sum.bias) + shown(sum.rest);
    if (sum.shows_products)
        for (const Product& p : sum.products)
            all += p.masked || p.cut ? 0 : factors ? shown(p.input) * shown(p.weight) : shown(p.value);
    for (const Term& term : sum.terms) all += shown(term.value);
    return all;
}

// Before the total: → where it is limited to −1..1 or the motor is stopped, ≈ where the shown numbers have another sum.
std::string_view sign_of_total(const MotorSum& sum, bool factors) {
    if (sum.limited || sum.stopped) return "→";
    const float total = std::round(sum.total * 100) / 100, half_a_digit = 0.0051f;
    const bool adds_up = std::fabs(sum_of_shown(sum, factors) - total) < half_a_digit;
    return adds_up ? "=" : "≈";
}

class Equation {
public:
    Equation(const Ui& ui, const MotorSum& sum, const EquationColumns& x, ImVec2 at, const Cause* why)
        : ui_(ui), sum_(sum), x_(x), at_(at), why_(why) {}

    void draw() const {
        const Palette& c = ui_.palette;
        const float h = line_height(ui_, x_.face), numbers = at_.y + below_name(ui_);
        const float large = numbers - (line_height(ui_, Face::text) - h) / 2;
        const auto sign = [&](float middle, std::string_view words) {
            put_centred(ui_, {middle, numbers}, words, c.second_text, x_.face);
        };
        put(ui_, {at_.x, large}, sum_.motor, c.text, Face::strong);
        sign(x_.equals, "=");
        if (sum_.shows_products) {
            product(x_.first, sum_.products[0], true);
            if (x_.factors) sign(x_.plus, "+");
            product(x_.second, sum_.products[1], false);
        }
        for (std::size_t i = 0; i < sum_.terms.size(); ++i)
            contribution(x_.terms[i], sum_.terms[i].label, sum_.terms[i].name, sum_.terms[i].value,
                         i == 0 && !sum_.shows_products);
        const bool is_first = !sum_.shows_products && sum_.terms.empty();
        if (!sum_.bias_letters.empty())
            signed_term(ui_, x_.bias, at_.y, sum_.bias_letters, sum_.bias, is_first, x_.face);
        if (sum_.more_wires) signed_term(ui_, x_.rest, at_.y, ui_.strings("sums.rest"), sum_.rest, false, x_.face);
        sign(x_.result, sign_of_total(sum_, x_.factors));
        put_right(ui_, {x_.total, large}, with_sign(ui_, sum_.total, 2), sum_.stopped ? c.second_text : c.text,
                  Face::strong);
    }

private:
    void product(float right, const Product& p, bool first) const {
        if (!x_.factors) return contribution(right, p.label, p.letters, p.value, first);
        if (why_ && why_->product == &p) mark_cause(ui_, right, at_.y, numbers_of(ui_, p), p.value, x_.face);
        one_product(ui_, right, at_.y, p);
    }
    void contribution(float right, std::string_view label, std::string_view name, float value, bool first) const {
        const bool is_cause = why_ && why_->name == name && why_->value == value;
        if (is_cause) mark_cause(ui_, right, at_.y, addend(ui_, value, first), value, x_.face);
        signed_term(ui_, right, at_.y, label, value, first, x_.face);
    }

    const Ui& ui_;
    const MotorSum& sum_;
    const EquationColumns& x_;
    ImVec2 at_;
    const Cause* why_;  // null: no cause is marked
};

// The name of a node that feeds a motor, with what it is: "OL (sees obstacles)". Names that the card explains elsewhere
// stay as they are.
std::string with_meaning(const LabView& view, const Ui& ui, const VehicleView& vehicle, const std::string& name) {
    for (const Node& node : brain_of(*view.now, vehicle)->nodes)
        if (node.name == name) {
            const std::string_view key = wiring::description_key(*view.now, vehicle, node);
            const std::string label = wiring::short_name(kind_of(*view.now, vehicle).sensors, name);
            return label + " (" + std::string(ui.strings(key)) + ")";
        }
    return name;
}

// The same in a sentence: a sensor with letters as its name as words, "Obstacles left".
std::string in_words(const LabView& view, const Ui& ui, const VehicleView& vehicle, const std::string& name) {
    const std::vector<Sensor>& sensors = kind_of(*view.now, vehicle).sensors;
    for (const Sensor& sensor : sensors)
        if (sensor.name == name) return sensor_label(ui, sensors, sensor);
    return with_meaning(view, ui, vehicle, name);
}

// The sensors and neurons of the columns, each once, in a line of its own.
std::string legend(const LabView& view, const Ui& ui, const VehicleView& vehicle, const std::array<MotorSum, 2>& both) {
    std::vector<std::string> names;
    const auto add = [&](const std::string& name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    };
    for (const MotorSum& sum : both) {
        if (sum.shows_products)
            for (const Product& product : sum.products) add(product.sensor);
        for (const Term& term : sum.terms) add(term.name);
    }
    std::string lines;
    for (const std::string& name : names) lines += "\n" + with_meaning(view, ui, vehicle, name);
    return lines;
}

struct Explained {
    const LabView& view;
    const VehicleView& vehicle;
    const std::array<MotorSum, 2>& both;
    const Cause& why;
};

std::string explanation(const Ui& ui, const Explained& given, bool stuck) {
    const auto& [view, vehicle, both, why] = given;
    if (both[0].stopped && both[1].stopped) return std::string(ui.strings("sums.both_stopped"));
    if (both[0].stopped || both[1].stopped)
        return std::string(ui.strings(both[0].stopped ? "sums.left_stopped" : "sums.right_stopped"));
    if (insight::are_alike(both[0].total, 0) && insight::are_alike(both[1].total, 0))
        return std::string(ui.strings("sums.still"));
    if (insight::are_alike(both[0].total, both[1].total))
        return std::string(ui.strings(alike_key(both[0].total, stuck)));
    if (stuck) return std::string(ui.strings("why.blocked"));
    const std::string_view wheel = ui.strings(why.difference > 0 ? "sums.right_faster" : "sums.left_faster");
    if (why.by == Cause::By::product || why.by == Cause::By::term)
        return fill(ui.strings(why.holds_back ? "sums.because_held" : "sums.because"),
                    {wheel, in_words(view, ui, vehicle, why.name), with_sign(ui, why.value, 2)});
    if (why.by == Cause::By::nothing) return std::string(wheel);
    return fill(ui.strings(why.by == Cause::By::rest ? "sums.because_rest" : "sums.because_bias"), {wheel});
}

// A button that opens a further analysis.
struct Analysis {
    SmallButton look;
    Action action;
    std::string_view tooltip;
};

std::array<Analysis, 3> analyses(const LabView& view, const Ui& ui) {
    return {
        Analysis{{"button.why", icon::notice, ui.strings("why.button"), view.features.why != nullptr},
                 Action::why,
                 "tooltip.button_why"},
        Analysis{
            {"button.map", icon::map, ui.strings("map.button"), view.settings.map}, Action::map, "tooltip.button_map"},
        Analysis{{"button.reality", icon::robot, ui.strings("reality.button"), view.settings.reality},
                 Action::reality,
                 "tooltip.button_reality"}};
}

// The cause in words, and the buttons at its right. The buttons are left out where the words beside them would end
// below `bottom` (window pixels, with the scroll of the card): each of them has a key and a row in a menu. With
// `scrolls` words that would be cut then are scrolled to, else they are left out, too.
void explanation_row(Ui& ui, const std::string& words, std::span<const Analysis> buttons, float bottom, bool scrolls) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float space = ui.px(spacing::tight), line = line_height(ui, Face::small);
    float width = buttons.empty() ? 0 : -space;
    for (const Analysis& each : buttons) width += space + small_button_width(ui, each.look, !has_icons(ui));
    const float room = card_width(ui) - width - (buttons.empty() ? 0 : ui.px(spacing::small));
    const auto fits_into = [&](float wrapped_at) {
        const float lines = static_cast<float>(lines_of_words(ui, words, Face::small, wrapped_at).size());
        return at.y + ImGui::GetScrollY() + lines * line + ui.px(spacing::large) <= bottom;
    };
    const bool fits = fits_into(room);
    if (!fits && !scrolls && !fits_into(card_width(ui))) return;
    paragraph(ui, words, ui.palette.text, Face::small, fits ? room : 0);
    if (!fits || buttons.empty()) return;
    const ImVec2 after = ImGui::GetCursorScreenPos();
    // The buttons are higher than the line beside them.
    ImVec2 corner{at.x + card_width(ui) - width, at.y - (ui.px(ui.tall(small_button_height)) - line) / 2};
    const float bottom_of_buttons = corner.y + ui.px(ui.tall(small_button_height));
    for (const Analysis& each : buttons) {
        ImGui::SetCursorScreenPos(corner);
        const Item shown = small_button(ui, each.look, !has_icons(ui));
        tooltip(ui, shown, fill(ui.strings(each.tooltip), {key_name(each.action, ui.strings)}));
        if (shown.pressed) ui.outbox.push_back(each.action);
        corner.x += small_button_width(ui, each.look, !has_icons(ui)) + space;
    }
    // The last row of the card has no space below it.
    const float bottom_of_words = after.y - ImGui::GetStyle().ItemSpacing.y;
    ImGui::SetCursorScreenPos({after.x, std::max(bottom_of_words, bottom_of_buttons)});
}

}  // namespace

bool stands_still(const LabView& view, const VehicleView& vehicle) {
    return view.now->tick > 30 && std::fabs(vehicle.speed) < 0.02f;
}

std::string_view alike_key(float wheels, bool stuck) {
    return stuck ? "sums.stuck" : wheels < 0 ? "sums.back" : "sums.straight";
}

bool wheels_push(float left, float right) { return std::fabs(left + right) > 0.1f; }

bool is_stuck(const LabView& view, const VehicleView& vehicle) {
    return !view.now->is_preview && stands_still(view, vehicle) && wheels_push(vehicle.motor[0], vehicle.motor[1]);
}

void equations(const LabView& view, Ui& ui, const VehicleView& vehicle) {
    std::array<MotorSum, 2> both = motor_sums(*view.now, vehicle, shown_pair(view, vehicle));
    const Cause why = cause(both);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const auto columns = [&](bool factors) { return equation_columns(ui, both, factors, at.x, card_width(ui)); };
    EquationColumns x = columns(!both[0].more_wires);
    if (x.factors && x.space < ui.px(least_factor_space)) x = columns(false);
    for (; x.space < ui.px(least_space) && term_columns(both) > 0; x = columns(false)) drop_last_column(both);
    if (!x.factors && x.space < ui.px(least_space)) {
        name_by_wires(both);
        x = columns(false);
    }
    const auto small_columns = [&] { return equation_columns(ui, both, false, at.x, card_width(ui), Face::label); };
    if (x.space < ui.px(least_space) && !x.factors) x = small_columns();
    if (x.space < ui.px(least_space) && !x.factors) add_biases_to_rest(both), x = small_columns();
    const float row = below_name(ui) + line_height(ui, Face::small) + ui.px(spacing::tight);
    const bool stopped = both[0].stopped || both[1].stopped;
    const Cause* shown = stopped || insight::are_alike(both[0].total, both[1].total) ? nullptr : &why;
    Equation(ui, both[0], x, at, shown).draw();
    Equation(ui, both[1], x, {at.x, at.y + row}, shown).draw();
    const Item area = item(ui, "equations", {card_width(ui), 2 * row}, false);
    if (!both[0].more_wires)
        tooltip(ui, area, ui.strings("sums.how"));
    else if (wants_tooltip(ui, area))
        tooltip(ui, area, std::string(ui.strings("sums.more_wires")) + legend(view, ui, vehicle, both));
}

void cause_in_words(const LabView& view, Ui& ui, const VehicleView& vehicle, float bottom, bool has_buttons) {
    const std::array<MotorSum, 2> both = motor_sums(*view.now, vehicle, shown_pair(view, vehicle));
    const Cause why = cause(both);
    const auto buttons = analyses(view, ui);
    explanation_row(ui, explanation(ui, {view, vehicle, both, why}, is_stuck(view, vehicle)),
                    has_buttons ? std::span<const Analysis>(buttons) : std::span<const Analysis>{}, bottom,
                    !view.lecture);
}

}  // namespace braitenlab::ui
