// The card of the trial with real robots: how real they are, how many do what the ideal robot does, a dot for each.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "ui/panels/cards.h"
#include "ui/panels/panels.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/number.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/slider.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

using insight::RobotResult;
using insight::RobotsReport;

constexpr std::size_t dots_per_row = 10;
constexpr float most_dot = 26;  // layout pixels, the distance between two dots

// The robots from the best to the weakest.
std::vector<int> ranked(const RobotsReport& report) {
    std::vector<int> order(report.robots.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return is_weaker(report.robots[static_cast<std::size_t>(b)], report.robots[static_cast<std::size_t>(a)],
                         report.ideal);
    });
    return order;
}

class RealityCard {
public:
    RealityCard(const LabView& view, PanelState& panels, Ui& ui)
        : view_(view), robots_(*view.features.robots), state_(panels.reality), sliders_(panels.sliders), ui_(ui) {}

    void draw() {
        how_real();
        if (robots_.report) {
            share();
            dots();
            words();
            gap(ui_, 8);
        }
        buttons();
        gap(ui_, 8);
        figures();
    }

private:
    std::string_view strings(std::string_view key) const { return ui_.strings(key); }
    Colour tone(const RobotResult& robot) const {
        return robot.works ? legible(ui_.palette.accent, ui_.palette.panel, ui_.palette.text)
                           : colour_of(NoticeKind::failure, ui_.palette);
    }
    const RobotResult& robot(int index) const { return robots_.report->robots[static_cast<std::size_t>(index)]; }
    void request(RobotsRequest request) { ui_.outbox.emplace_back(request); }

    // The slider, and below its track what 0, 1 and 2 are.
    void how_real() {
        constexpr float number_width = 46;
        const std::string_view name = strings("reality.reality");
        const float aside = text_width(ui_, Face::text, name) / ui_.px(1) + 10;
        SliderLook look{.words = name,
                        .tooltip = strings("reality.how"),
                        .low = 0,
                        .high = insight::limits::reality,
                        .home = 1,
                        .step = 0.05f,
                        .signed_number = false,
                        .meaning = false};
        look.words_width = aside, look.number_width = number_width;
        const float width = card_width(ui_);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        if (const auto edit = slider(ui_, sliders_, "reality.slider", robots_.reality, width, view_.wall_seconds, look))
            request({.reality = edit->value});
        const ImVec2 below = ImGui::GetCursorScreenPos();
        const float from = at.x + ui_.px(aside + 8), until = at.x + width - ui_.px(number_width + 8);
        const Colour quiet = ui_.palette.second_text;
        put(ui_, {from, below.y}, strings("reality.ideal"), quiet, Face::small);
        put_centred(ui_, {(from + until) / 2, below.y}, strings("reality.real"), quiet, Face::small);
        put_right(ui_, {until, below.y}, strings("reality.twice"), quiet, Face::small);
        ImGui::Dummy({1, line_height(ui_, Face::small) + ui_.px(spacing::small)});
    }

    // The figures of the robots, in the order of a signal: eye to wheel.
    void figures() {
        const insight::Reality& f = robots_.figures;
        const auto percent = [&](float share) { return std::to_string(std::lround(100 * share)); };
        std::string text = fill(strings("reality.sensors"), {percent(f.gain_spread), fixed(ui_, f.noise, 3),
                                                             std::to_string(std::lround(1000 * f.latency))});
        // A sensor without an interval takes a sample at every tick.
        const float interval = std::max(f.interval, tick_seconds);
        text += "\n" + fill(strings("reality.samples"), {std::to_string(std::lround(1000 * interval))});
        if (f.bits > 0) text += ", " + fill(strings("reality.bits"), {std::to_string(f.bits)});
        text += "\n" + fill(strings("reality.motors"),
                            {percent(f.mismatch), fixed(ui_, f.dead_band, 2), percent(f.friction_spread)});
        paragraph(ui_, text, ui_.palette.second_text, Face::small);
        if (robots_.is_typical) paragraph(ui_, strings("reality.typical"), ui_.palette.second_text, Face::small);
    }

    // "95 %" in large type, and what it is a share of.
    void share() {
        const RobotsReport& report = *robots_.report;
        const std::string number =
            fill(strings("reality.percent"), {std::to_string(std::lround(100 * report.share()))});
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float height = line_height(ui_, Face::title);
        const float width = put(ui_, at, number, ui_.palette.text, Face::title);
        ImGui::SetCursorScreenPos(
            {at.x + width + ui_.px(10), at.y + height - line_height(ui_, Face::small) - ui_.px(3)});
        const std::string count = std::to_string(report.working), all = std::to_string(report.robots.size());
        std::string what = fill(strings(robots_.judged ? "reality.pass" : "reality.do_same"), {count, all});
        if (!robots_.judged) what += ": " + behaviour(report.ideal);
        const float room = card_width(ui_) - width - ui_.px(10);
        paragraph(ui_, what, ui_.palette.text, Face::small, room);
        const ImVec2 after = ImGui::GetCursorScreenPos();
        ImGui::SetCursorScreenPos({at.x, std::max(after.y, at.y + height) + ui_.px(6)});
    }

    std::string behaviour(const RobotResult& robot) const {
        return std::string(strings("map.kind." + std::string(row_of(robot.outcome.behaviour).word)));
    }

    // From the best robot to the weakest, which has a ring.
    void dots() {
        const std::vector<int> order = ranked(*robots_.report);
        const float side = std::min(ui_.px(most_dot), card_width(ui_) / static_cast<float>(dots_per_row));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const std::size_t rows = (order.size() + dots_per_row - 1) / dots_per_row;
        mark(ui_, "reality.dots", {at.x, at.y, side * dots_per_row, side * static_cast<float>(rows)});
        for (std::size_t i = 0; i < order.size(); ++i) {
            ImGui::SetCursorScreenPos({at.x + side * static_cast<float>(i % dots_per_row),
                                       at.y + side * static_cast<float>(i / dots_per_row)});
            dot(order[i], side);
        }
        ImGui::SetCursorScreenPos({at.x, at.y + side * static_cast<float>(rows) + ui_.px(6)});
    }

    // A disc for a robot that works, a cross for one that does not, so that the colour does not tell alone.
    void dot(int index, float side) {
        const RobotResult& shown = robot(index);
        const Item at = item(ui_, "reality.robot." + std::to_string(index + 1), {side, side});
        if (at.hovered || at.focused) state_.hovered = index;
        ImDrawList& draw = *ImGui::GetWindowDrawList();
        const ImVec2 c{at.middle_x(), at.middle_y()};
        const float radius = side * (0.28f + 0.06f * at.warmth);
        const ImU32 colour = paint(tone(shown).with_alpha(robots_.progress < 1 ? 0.45f : 1.0f));
        if (shown.works) {
            draw.AddCircleFilled(c, radius, colour);
        } else {
            const float r = radius * 0.85f, width = ui_.px(2);
            draw.AddLine({c.x - r, c.y - r}, {c.x + r, c.y + r}, colour, width);
            draw.AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, colour, width);
        }
        const bool is_replayed = robots_.replayed && (*robots_.replayed == index || *robots_.replayed == every_robot);
        if (index == robots_.report->weakest || is_replayed)
            draw.AddCircle(c, side * 0.46f, paint(is_replayed ? ui_.palette.accent : ui_.palette.text), 0,
                           ui_.px(1.5f));
        if (wants_tooltip(ui_, at))
            tooltip(ui_, at, result_words(index) + "\n" + std::string(strings("reality.robot_how")));
        if (at.pressed) request({.replays = std::optional<int>(index)});
    }

    // "Robot 7: passes, closest 0.83 m", of an exercise "Robot 7: fails at “It …”".
    std::string result_words(int index) const {
        const RobotResult& shown = robot(index);
        const bool is_weakest = index == robots_.report->weakest;
        std::string text =
            fill(strings(is_weakest ? "reality.weakest_robot" : "reality.robot"), {std::to_string(index + 1)}) + ": ";
        if (!robots_.judged) {
            text += behaviour(shown);
        } else if (shown.works) {
            text += fill(strings("reality.passes"), {fixed(ui_, shown.seconds, 1)});
        } else {
            const auto step = static_cast<std::size_t>(std::max(shown.failed_step, 0));
            const auto& steps = view_.lesson->exercise->steps;
            text += fill(strings("reality.fails"),
                         {step < steps.size() ? std::string(translated(ui_, steps[step].text)) : std::string()});
        }
        if (std::isfinite(shown.outcome.closest))
            text += ", " + fill(strings("reality.closest"), {fixed(ui_, shown.outcome.closest, 1)});
        return text;
    }

    // About the robot under the pointer, else the weakest; during a replay, which robot is shown.
    void words() {
        if (robots_.replayed && !state_.hovered) {
            const std::string text = *robots_.replayed == every_robot
                                         ? std::string(strings("reality.all_replayed"))
                                         : fill(strings("reality.replayed"), {std::to_string(*robots_.replayed + 1)});
            return paragraph(ui_, text, ui_.palette.text, Face::strong);
        }
        paragraph(ui_, result_words(state_.hovered.value_or(robots_.report->weakest)), ui_.palette.text);
    }

    void progress_bar(float width) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const Rect whole{at.x, at.y + ui_.px(10), width, ui_.px(4)};
        fill_box(ui_, whole, ui_.palette.raised, Corner::bar);
        fill_box(ui_, {whole.x, whole.y, width * std::max(0.02f, robots_.progress), whole.h}, ui_.palette.accent,
                 Corner::bar);
        ImGui::Dummy({width, ui_.px(ui_.tall(small_button_height))});
    }

    void buttons() {
        if (!robots_.is_on) {
            if (push_button(
                    ui_, "reality.try",
                    {icon::play, fill(strings("reality.try"), {std::to_string(robots_.count)}), Emphasis::primary},
                    strings("reality.try_how")))
                request({.tries = true});
            return;
        }
        if (robots_.replayed) return back_button();
        const float right = ImGui::GetCursorScreenPos().x + card_width(ui_);
        if (robots_.report) {
            const SmallButton weakest{"reality.weakest", icon::play, strings("reality.replay_weakest")};
            if (small_push_button(ui_, weakest, strings("reality.replay_weakest_how")))
                request({.replays = std::optional<int>(robots_.report->weakest)});
            const SmallButton every{"reality.all", icon::play, strings("reality.replay_all")};
            beside_or_below(ui_, small_button_width(ui_, every, true), right);
            if (small_push_button(ui_, every, strings("reality.replay_all_how")))
                request({.replays = std::optional<int>(every_robot)});
        } else {
            progress_bar(card_width(ui_) * 0.55f);
        }
        const SmallButton stop{"reality.cancel", icon::cross, strings("reality.cancel")};
        beside_or_below(ui_, small_button_width(ui_, stop, true), right);
        if (small_push_button(ui_, stop, strings("reality.cancel_how"))) request({.tries = false});
    }

    void back_button() {
        if (push_button(ui_, "reality.back", {icon::undo, strings("reality.back"), Emphasis::primary},
                        strings("reality.back_how"), key_name({key::escape}, ui_.strings)))
            request({.replays = std::optional<std::optional<int>>(std::in_place, std::nullopt)});
    }

    const LabView& view_;
    const RobotsView& robots_;
    RealityState& state_;
    SliderState& sliders_;
    Ui& ui_;
};

}  // namespace

void reality_card(const LabView& view, PanelState& state, Ui& ui, Rect place, Rect) {
    if (open_card(state, ui, Card::reality, place)) {
        if (view.features.robots)
            RealityCard(view, state, ui).draw();
        else
            paragraph(ui, ui.strings("unavailable.reality"), ui.palette.second_text, Face::small);
    }
    CardState& card = state.card(Card::reality);
    end_card(ui, card);
    if (std::exchange(card.folded, false)) ui.outbox.push_back(Action::reality);  // folding closes it
}

}  // namespace braitenlab::ui
