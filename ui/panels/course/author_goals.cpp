// The fields of the author's sheet, and its pages about what the vehicle does: steps, prediction, wrong answers.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <imgui.h>

#include "ui/panels/course/author_fields.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/keyboard.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

void AuthorFields::field(std::string_view name, TextField& text, std::string_view id, std::string_view how) const {
    subheading(ui, words(name));
    text_field(ui, text, id, card_width(ui), words(how), words(how));
    gap(ui, 8);
}

bool AuthorFields::toggle(const std::string& id, std::string_view label, bool on, std::string_view how,
                          float& x) const {
    const SmallButton look{id, {}, label, on};
    const float width = small_button_width(ui, look, true);
    if (x > 0 && x + ui.px(spacing::small) + width <= card_width(ui))
        ImGui::SameLine(0, ui.px(spacing::small)), x += ui.px(spacing::small) + width;
    else
        x = width;
    return small_push_button(ui, look, how);
}

int AuthorFields::choice(const std::string& id, const std::vector<std::string>& names, std::string_view chosen,
                         std::string_view how) const {
    int found = -1;
    float x = 0;
    for (std::size_t i = 0; i < names.size() && i < 24; ++i)
        if (toggle(id + "." + std::to_string(i + 1), names[i], names[i] == chosen, how, x)) found = static_cast<int>(i);
    gap(ui, 8);
    return found;
}

float AuthorFields::number(const std::string& id, std::string_view label, std::string_view how, float value,
                           const NumberField& number) const {
    SliderLook look = look_of(number);
    look.words = label;
    look.tooltip = how;
    look.unit = number.unit;
    look.words_width = 176, look.number_width = 76;
    const auto edit = slider(ui, panels.sliders, id, value, card_width(ui), view.wall_seconds, look);
    return edit ? edit->value : value;
}

namespace {

// The text of a goal in a list.
std::string_view label_of(const AuthorFields& page, const Goal& goal) {
    return page.words("author.goal." + std::string(word_of(goal)));
}

// ── A goal ──

// What the number means: for this goal, or for each that has it.
std::string_view meaning_of(const AuthorFields& page, const Goal& goal, const std::string& key) {
    return page.ui.strings.find("author.value_how." + std::string(word_of(goal)) + "_" + key,
                                page.words("author.value_how." + key));
}

void goal_value(const AuthorFields& page, const std::string& prefix, const Goal& goal, const GoalValue& value) {
    const std::string key(value.key), id = prefix + "." + key;
    const std::string_view label = page.words("author.value." + key);
    const std::string unit = value.unit.empty() ? "" : value.unit == "°" ? "°" : " " + std::string(value.unit);
    if (value.number)
        *value.number = page.number(id, label, meaning_of(page, goal, key), *value.number,
                                    {key.c_str(), unit, value.range, *value.number, *value.number, false});
    if (value.count) {
        const auto count = static_cast<float>(*value.count);
        *value.count = static_cast<int>(page.number(id, label, meaning_of(page, goal, key), count,
                                                    {key.c_str(), unit, value.range, count, count, true}));
    }
    if (!value.name) return;
    subheading(page.ui, label);
    const auto names = names_for(value.key, page.scene(), page.state.draft.vehicle);
    const int pressed = page.choice(id, names, *value.name, page.words("author.name_how"));
    if (pressed >= 0) *value.name = names[static_cast<std::size_t>(pressed)];
}

void goal_values(const AuthorFields& page, const std::string& prefix, Goal& goal) {
    for (const GoalValue& value : values_of(goal)) goal_value(page, prefix, goal, value);
}

// The list of goals; the one pressed, or null.
const Goal* goal_list(const AuthorFields& page, const std::string& prefix, const std::vector<Goal>& goals,
                      const Goal* chosen) {
    const Goal* pressed = nullptr;
    for (const Goal& each : goals)
        if (radio_row(page.ui, prefix + std::string(word_of(each)), label_of(page, each),
                      chosen && each.index() == chosen->index(), true, page.words("author.goals_how")))
            pressed = &each;
    return pressed;
}

// The row that opens a list of goals. The focus goes to the chosen row, so that arrow keys go on from there.
bool list_row(const AuthorFields& page, std::string_view id, std::string_view words, bool& open, std::string_view how,
              const std::string& chosen) {
    const bool was_open = open;
    if (!fold_row(page.ui, id, words, open, how)) return false;
    if (Keyboard* keyboard = page.ui.keyboard; keyboard && !was_open)
        keyboard->focus = chosen, keyboard->revealed = true;
    return true;
}

// ── Steps ──

// What a new step asks for: something that a standing vehicle does not do.
const Goal& usual_goal(const std::vector<Goal>& goals) {
    for (const std::string_view word : {"touches", "drives"})
        for (const Goal& each : goals)
            if (word_of(each) == word) return each;
    return goals.front();
}

void add_step(const AuthorFields& page, const Goal& goal) {
    AuthorState& state = page.state;
    state.step_texts[state.draft.steps.size()].text = label_of(page, goal);
    state.draft.steps.push_back({"", {goal}});
    state.step_shown = state.draft.steps.size() - 1;
}

void remove_shown_step(AuthorState& state) {
    const std::size_t at = state.step_shown;
    state.draft.steps.erase(state.draft.steps.begin() + static_cast<std::ptrdiff_t>(at));
    for (std::size_t i = at; i + 1 < author_steps; ++i) state.step_texts[i].text = state.step_texts[i + 1].text;
    state.step_texts.back().text.clear();
    state.step_shown = std::min(at, state.draft.steps.size() - 1);
}

// The steps, and buttons that add and remove one.
void step_bar(const AuthorFields& page, const std::vector<Goal>& goals) {
    AuthorState& state = page.state;
    float x = 0;
    for (std::size_t i = 0; i < state.draft.steps.size(); ++i)
        if (page.toggle("author.step." + std::to_string(i + 1),
                        fill(page.words("author.step"), {std::to_string(i + 1)}), state.step_shown == i,
                        page.words("author.step_how"), x))
            state.step_shown = i, state.goals_open = false;
    const bool add =
        state.draft.steps.size() < author_steps &&
        page.toggle("author.step.add", page.words("author.add_step"), false, page.words("author.add_step_how"), x);
    const bool remove =
        state.draft.steps.size() > 1 && page.toggle("author.step.remove", page.words("author.remove_step"), false,
                                                    page.words("author.remove_step_how"), x);
    if (add) add_step(page, usual_goal(goals));
    if (remove) remove_shown_step(state);
}

void one_step(const AuthorFields& page, const std::vector<Goal>& goals) {
    AuthorState& state = page.state;
    Step& step = state.draft.steps[state.step_shown];
    const std::string of_step = "author.step." + std::to_string(state.step_shown + 1);
    const std::string goal(label_of(page, step.check.goal));
    subheading(page.ui, page.words("author.goal_of_step"));
    if (list_row(page, "author.goals", goal, state.goals_open, page.words("author.goals_how"),
                 "author.goal." + std::string(word_of(step.check.goal)))) {
        const Goal* pressed = goal_list(page, "author.goal.", goals, &step.check.goal);
        if (!pressed) return;
        std::string& text = state.step_texts[state.step_shown].text;
        if (text.empty() || text == goal) text = label_of(page, *pressed);
        step.check.goal = *pressed;
        state.goals_open = false;
        return;
    }
    goal_values(page, "author.value", step.check.goal);
    step.check.hold = page.number("author.hold", page.words("author.value.hold"), page.words("author.value_how.hold"),
                                  step.check.hold, {"hold", " s", {0, 600}, step.check.hold, 0, false});
    gap(page.ui, 8);
    page.field("author.step_text", state.step_texts[state.step_shown], of_step + ".text", "author.step_text_how");
}

// ── Prediction ──

// A button that makes the option the answer, and its text.
void option(const AuthorFields& page, std::size_t i) {
    Ui& ui = page.ui;
    AuthorState& state = page.state;
    const std::string id = "author.option." + std::to_string(i + 1), id_of_answer = id + ".answer";
    const bool is_answer = state.draft.prediction.answer == static_cast<int>(i);
    const SmallButton look{
        id_of_answer, {}, page.words(is_answer ? "author.answer" : "author.other_answer"), is_answer};
    const float x = ImGui::GetCursorPosX(), y = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(y + ui.px(ui.tall(button_height) - ui.tall(small_button_height)) / 2);
    if (small_push_button(ui, look, page.words("author.answer_how")))
        state.draft.prediction.answer = static_cast<int>(i);
    // All fields have the same edges.
    const float widest = std::max(text_width(ui, Face::small, page.words("author.answer")),
                                  text_width(ui, Face::small, page.words("author.other_answer")));
    const float aside =
        small_button_width(ui, look, true) - text_width(ui, Face::small, look.words) + widest + ui.px(8);
    ImGui::SetCursorPos({x + aside, y});
    const std::string_view how = page.words("author.option_how");
    text_field(ui, state.options[i], id, card_width(ui) - aside, how, how);
}

// A time of the run in which the check can be met: what takes five seconds is not seen after three.
float time_to_show(Prediction& asked) {
    constexpr float to_begin = 1;  // s
    float seconds = asked.after;
    for (const GoalValue& value : values_of(asked.shows.front().check.goal))
        if (value.number && value.key == "seconds") seconds = std::max(seconds, std::ceil(*value.number) + to_begin);
    return seconds;
}

// What the run with the shipped brain must show: nothing, or one goal.
void shown_goal(const AuthorFields& page) {
    Ui& ui = page.ui;
    Prediction& asked = page.state.draft.prediction;
    Goal* now = asked.shows.empty() ? nullptr : &asked.shows.front().check.goal;
    subheading(ui, page.words("author.shows"));
    const std::string label(now ? label_of(page, *now) : page.words("author.shows_nothing"));
    if (list_row(page, "author.shows", label, page.state.shows_open, page.words("author.shows_how"),
                 "author.shows." + std::string(now ? word_of(*now) : "nothing"))) {
        const bool none = radio_row(ui, "author.shows.nothing", page.words("author.shows_nothing"), !now, true,
                                    page.words("author.shows_how"));
        const std::vector<Goal> goals = goals_for(page.scene(), page.state.draft.vehicle);
        const Goal* pressed = goal_list(page, "author.shows.", goals, now);
        if (none) asked.shows.clear();
        if (pressed) asked.shows = {{.option = {}, .check = {*pressed}}}, asked.after = time_to_show(asked);
        if (none || pressed) page.state.shows_open = false;
        return;
    }
    if (now) goal_values(page, "author.shown", *now);
    asked.after = page.number("author.after", page.words("author.after"), page.words("author.after_how"), asked.after,
                              {"after", " s", {1, page.state.draft.seconds}, asked.after, Prediction{}.after, true});
}

// ── Wrong answers ──

// The brain that the vehicle of the draft has in the window.
const BrainGraph* brain_in_window(const AuthorFields& page) {
    const auto start = static_cast<int>(subject_start(page.state.draft, page.scene()));
    for (const VehicleView& vehicle : page.view.now->vehicles)
        if (vehicle.start == start) return brain_of(*page.view.now, vehicle).get();
    return nullptr;
}

void remove_wrong(AuthorState& state, std::size_t at) {
    state.draft.wrong.erase(state.draft.wrong.begin() + static_cast<std::ptrdiff_t>(at));
    for (std::size_t i = at; i + 1 < author_wrong; ++i) state.wrong_names[i].text = state.wrong_names[i + 1].text;
    state.wrong_names.back().text.clear();
}

}  // namespace

void author_steps_page(const AuthorFields& page) {
    AuthorState& state = page.state;
    const std::vector<Goal> goals = goals_for(page.scene(), state.draft.vehicle);
    if (state.draft.steps.empty()) add_step(page, usual_goal(goals));
    step_bar(page, goals);
    gap(page.ui, 6);
    one_step(page, goals);
    gap(page.ui, 8);
    subheading(page.ui, page.words("author.run"));
    ExerciseDraft& draft = state.draft;
    draft.seconds = page.number("author.seconds", page.words("author.seconds"), page.words("author.seconds_how"),
                                draft.seconds, {"seconds", " s", {1, 600}, draft.seconds, 20, true});
    draft.starts = static_cast<int>(page.number("author.starts", page.words("author.starts"),
                                                page.words("author.starts_how"), static_cast<float>(draft.starts),
                                                {"starts", "", {1, 100}, static_cast<float>(draft.starts), 10, true}));
    draft.heading_spread =
        page.number("author.spread", page.words("author.spread"), page.words("author.spread_how"), draft.heading_spread,
                    {"spread", "°", {0, 180}, draft.heading_spread, 15, false});
}

void author_prediction_page(const AuthorFields& page) {
    AuthorState& state = page.state;
    page.field("author.question", state.question, "author.question", "author.question_how");
    subheading(page.ui, page.words("author.options"));
    for (std::size_t i = 0; i < state.options.size(); ++i) option(page, i);
    gap(page.ui, 8);
    page.field("author.outcome", state.outcome, "author.outcome", "author.outcome_how");
    shown_goal(page);
}

void author_wrong_page(const AuthorFields& page) {
    Ui& ui = page.ui;
    AuthorState& state = page.state;
    paragraph(ui, page.words("author.wrong_what"), ui.palette.second_text);
    gap(ui, 8);
    for (std::size_t i = 0; i < state.draft.wrong.size(); ++i) {
        const std::string id = "author.wrong." + std::to_string(i + 1), id_of_remove = id + ".remove";
        const SmallButton remove{id_of_remove, icon::remove, page.words("author.remove_wrong")};
        const float y = ImGui::GetCursorPosY(), aside = small_button_width(ui, remove, true) + ui.px(8);
        const std::string_view how = page.words("author.wrong_name_how");
        text_field(ui, state.wrong_names[i], id, card_width(ui) - aside, how, how);
        ImGui::SameLine(0, ui.px(spacing::small));
        ImGui::SetCursorPosY(y + ui.px(ui.tall(button_height) - ui.tall(small_button_height)) / 2);
        const bool pressed = small_push_button(ui, remove, page.words("author.remove_wrong_how"));
        ImGui::SetCursorPosY(y + ui.px(ui.tall(button_height) + 6));
        if (pressed) return remove_wrong(state, i);
    }
    const BrainGraph* brain = brain_in_window(page);
    const bool is_known = std::any_of(state.draft.wrong.begin(), state.draft.wrong.end(),
                                      [&](const WrongDraft& each) { return brain && each.brain == *brain; });
    ButtonLook look{icon::add, page.words("author.add_wrong")};
    look.enabled = brain && !is_known && state.draft.wrong.size() < author_wrong;
    if (!push_button(ui, "author.wrong.add", look,
                     page.words(is_known ? "author.wrong_known" : "author.add_wrong_how")) ||
        !look.enabled)
        return;
    state.wrong_names[state.draft.wrong.size()].text =
        fill(page.words("author.wrong_name"), {std::to_string(state.draft.wrong.size() + 1)});
    state.draft.wrong.push_back({"", *brain});
}

}  // namespace braitenlab::ui
