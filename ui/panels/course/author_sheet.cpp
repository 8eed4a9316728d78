// The sheet that saves the open scene as an exercise: texts, offered controls, steps and a prediction, a page for each.
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/lesson/submission.h"
#include "ui/panels/panels.h"
#include "ui/strings.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/record_fields.h"
#include "ui/widgets/sheet.h"
#include "ui/widgets/theme.h"

namespace braitenlab::ui {

namespace {

constexpr float author_width = 680;  // layout pixels
constexpr float page_height = 530;   // of a page, so that the buttons stay in their place

struct AuthorSheet {
    const LabView& view;
    PanelState& panels;
    AuthorState& state;
    Ui& ui;

    const Scene& scene() const { return *view.now->scene; }
    std::string_view words(std::string_view key) const { return ui.strings(key); }

    void field(std::string_view name, TextField& text, std::string_view id, std::string_view how) const {
        subheading(ui, words(name));
        text_field(ui, text, id, card_width(ui), {}, words(how));
        gap(ui, 8);
    }

    // Switches side by side, wrapped at the sheet's edge. `on` is switched by a press.
    void toggle(const std::string& id, std::string_view label, bool on, std::string_view how, bool& pressed,
                float& x) const {
        const SmallButton look{id, {}, label, on};
        const float width = small_button_width(ui, look, true);
        if (x > 0 && x + ui.px(6) + width <= card_width(ui))
            ImGui::SameLine(0, ui.px(6)), x += ui.px(6) + width;
        else
            x = width;
        const Item at = small_button(ui, look);
        tooltip(ui, at, how);
        pressed = at.pressed;
    }

    // One of several names; the index pressed, or −1.
    int choice(const std::string& id, const std::vector<std::string>& names, std::string_view chosen,
               std::string_view how) const {
        int found = -1;
        float x = 0;
        for (std::size_t i = 0; i < names.size() && i < 24; ++i) {
            bool pressed = false;
            toggle(id + "." + std::to_string(i + 1), names[i], names[i] == chosen, how, pressed, x);
            if (pressed) found = static_cast<int>(i);
        }
        gap(ui, 8);
        return found;
    }

    float number(const std::string& id, std::string_view label, float value, const NumberField& number) const {
        SliderLook look = look_of(number);
        look.words = label;
        look.tooltip = words("author.value_how");
        look.unit = number.unit;
        look.words_width = 176, look.number_width = 76;
        const auto edit = slider(ui, panels.sliders, id, value, card_width(ui), view.wall_seconds, look);
        return edit ? edit->value : value;
    }

    // ── The pages ──

    void texts() const {
        field("author.title", state.title, "author.title", "author.title_how");
        field("author.goal_text", state.goal, "author.goal", "author.goal_how");
        vehicle();
        subheading(ui, words("author.ships"));
        for (const ShippedBrain each : {ShippedBrain::of_file, ShippedBrain::without_wires}) {
            const bool of_file = each == ShippedBrain::of_file;
            if (radio_row(ui, of_file ? "author.ships.file" : "author.ships.none",
                          words(of_file ? "author.ships_file" : "author.ships_none"), state.draft.ships == each, true,
                          words("author.ships_how")))
                state.draft.ships = each;
        }
        paragraph(ui, words("author.solution"), ui.palette.second_text, Face::small);
        gap(ui, 8);
        subheading(ui, words("author.file"));
        text_field(ui, state.path, "author.path", card_width(ui), file_name_for(state.title.text) + ".toml",
                   words("author.file_how"));
        if (view.files) paragraph(ui, view.files->listing.folder, ui.palette.second_text, Face::small);
    }

    void vehicle() const {
        std::vector<std::string> names;
        for (const Start& each : scene().starts) names.push_back(each.name);
        if (names.size() < 2) return;
        subheading(ui, words("author.vehicle"));
        const int pressed = choice("author.vehicle", names, state.draft.vehicle, words("author.vehicle_how"));
        if (pressed >= 0) state.draft.vehicle = names[static_cast<std::size_t>(pressed)];
    }

    void controls() const {
        paragraph(ui, words("author.controls_what"), ui.palette.second_text);
        gap(ui, 6);
        if (radio_row(ui, "author.all", words("author.all_controls"), state.all_controls, true,
                      words("author.all_how")))
            state.all_controls = true;
        if (radio_row(ui, "author.some", words("author.some_controls"), !state.all_controls, true,
                      words("author.some_how")))
            state.all_controls = false;
        gap(ui, 8);
        if (state.all_controls) return;
        dials(0, 4, "author.weights"), dials(8, 10, "author.biases"), dials(4, 8, "author.thresholds");
        subheading(ui, words("author.parts"));
        float x = 0;
        for (std::size_t i = 0; i < state.parts.size(); ++i) {
            bool pressed = false;
            const std::string part(offer_parts::all[i]);
            toggle("author.part." + part, words("author.part." + part), state.parts[i], words("author.part_how"),
                   pressed, x);
            if (pressed) state.parts[i] = !state.parts[i];
        }
    }

    void dials(std::size_t from, std::size_t end, std::string_view heading) const {
        subheading(ui, words(heading));
        float x = 0;
        for (std::size_t i = from; i < end; ++i) {
            const std::string dial(name(all_dials[i]));
            std::string label = dial;
            if (label.starts_with("threshold_")) label.erase(0, 10);
            bool pressed = false;
            toggle("author.dial." + dial, label, state.dials[i], words("author.dial_how"), pressed, x);
            if (pressed) state.dials[i] = !state.dials[i];
        }
        gap(ui, 8);
    }

    void add_step(const Goal& goal) const {
        state.step_texts[state.draft.steps.size()].text = words("author.goal." + std::string(word_of(goal)));
        state.draft.steps.push_back({"", {goal}});
        state.step_shown = state.draft.steps.size() - 1;
    }

    void steps() const {
        const std::vector<Goal> goals = goals_for(scene(), state.draft.vehicle);
        if (state.draft.steps.empty()) {
            const auto touches = std::find_if(goals.begin(), goals.end(), [](const Goal& goal) {
                return std::holds_alternative<goals::Touches>(goal);
            });
            add_step(touches == goals.end() ? goals.front() : *touches);
        }
        step_bar(goals);
        gap(ui, 6);
        one_step(goals);
        gap(ui, 8);
        subheading(ui, words("author.run"));
        state.draft.seconds = number("author.seconds", words("author.seconds"), state.draft.seconds,
                                     {"seconds", " s", {1, 600}, state.draft.seconds, 20, true});
        state.draft.starts =
            static_cast<int>(number("author.starts", words("author.starts"), static_cast<float>(state.draft.starts),
                                    {"starts", "", {1, 100}, static_cast<float>(state.draft.starts), 10, true}));
        state.draft.heading_spread = number("author.spread", words("author.spread"), state.draft.heading_spread,
                                            {"spread", "°", {0, 180}, state.draft.heading_spread, 15, false});
    }

    // The steps, and buttons that add and remove one.
    void step_bar(const std::vector<Goal>& goals) const {
        float x = 0;
        for (std::size_t i = 0; i < state.draft.steps.size(); ++i) {
            bool pressed = false;
            toggle("author.step." + std::to_string(i + 1), fill(words("author.step"), {std::to_string(i + 1)}),
                   state.step_shown == i, words("author.step_how"), pressed, x);
            if (pressed) state.step_shown = i, state.goals_open = false;
        }
        bool add = false, remove = false;
        if (state.draft.steps.size() < author_steps)
            toggle("author.step.add", words("author.add_step"), false, words("author.add_step_how"), add, x);
        if (state.draft.steps.size() > 1)
            toggle("author.step.remove", words("author.remove_step"), false, words("author.remove_step_how"), remove,
                   x);
        if (add) add_step(goals.front());
        if (!remove) return;
        const std::size_t at = state.step_shown;
        state.draft.steps.erase(state.draft.steps.begin() + static_cast<std::ptrdiff_t>(at));
        for (std::size_t i = at; i + 1 < author_steps; ++i) state.step_texts[i].text = state.step_texts[i + 1].text;
        state.step_texts.back().text.clear();
        state.step_shown = std::min(at, state.draft.steps.size() - 1);
    }

    void one_step(const std::vector<Goal>& goals) const {
        Step& step = state.draft.steps[state.step_shown];
        const std::string of_step = "author.step." + std::to_string(state.step_shown + 1);
        const std::string goal(words("author.goal." + std::string(word_of(step.check.goal))));
        subheading(ui, words("author.goal_of_step"));
        if (fold_row(ui, "author.goals", goal, state.goals_open, words("author.goals_how"))) return list_goals(goals);
        for (const GoalValue& value : values_of(step.check.goal)) goal_value(value);
        step.check.hold = number("author.hold", words("author.value.hold"), step.check.hold,
                                 {"hold", " s", {0, 600}, step.check.hold, 0, false});
        gap(ui, 8);
        field("author.step_text", state.step_texts[state.step_shown], of_step + ".text", "author.step_text_how");
    }

    void list_goals(const std::vector<Goal>& goals) const {
        Step& step = state.draft.steps[state.step_shown];
        std::string& text = state.step_texts[state.step_shown].text;
        for (const Goal& each : goals) {
            const std::string word(word_of(each));
            const std::string_view label = words("author.goal." + word);
            if (!radio_row(ui, "author.goal." + word, label, each.index() == step.check.goal.index(), true,
                           words("author.goals_how")))
                continue;
            if (text.empty() || text == words("author.goal." + std::string(word_of(step.check.goal)))) text = label;
            step.check.goal = each;
            state.goals_open = false;
        }
    }

    void goal_value(const GoalValue& value) const {
        const std::string key(value.key), id = "author.value." + key;
        const std::string_view label = words(id);
        const std::string unit = value.unit.empty() ? "" : value.unit == "°" ? "°" : " " + std::string(value.unit);
        if (value.number)
            *value.number =
                number(id, label, *value.number, {key.c_str(), unit, value.range, *value.number, *value.number, false});
        if (value.count) {
            const auto count = static_cast<float>(*value.count);
            *value.count =
                static_cast<int>(number(id, label, count, {key.c_str(), unit, value.range, count, count, true}));
        }
        if (!value.name) return;
        subheading(ui, label);
        const auto names = names_for(value.key, scene(), state.draft.vehicle);
        const int pressed = choice(id, names, *value.name, words("author.name_how"));
        if (pressed >= 0) *value.name = names[static_cast<std::size_t>(pressed)];
    }

    void prediction() const {
        field("author.question", state.question, "author.question", "author.question_how");
        subheading(ui, words("author.options"));
        for (std::size_t i = 0; i < state.options.size(); ++i) option(i);
        gap(ui, 8);
        field("author.outcome", state.outcome, "author.outcome", "author.outcome_how");
    }

    // A button that makes the option the answer, and its text.
    void option(std::size_t i) const {
        const std::string id = "author.option." + std::to_string(i + 1), id_of_answer = id + ".answer";
        const bool is_answer = state.draft.prediction.answer == static_cast<int>(i);
        const SmallButton look{id_of_answer, {}, words("author.answer"), is_answer};
        const float y = ImGui::GetCursorPosY();
        ImGui::SetCursorPosY(y + ui.px(button_height - small_button_height) / 2);
        const Item at = small_button(ui, look);
        tooltip(ui, at, words("author.answer_how"));
        if (at.pressed) state.draft.prediction.answer = static_cast<int>(i);
        const float aside = small_button_width(ui, look, true) + ui.px(8);
        ImGui::SameLine(0, ui.px(8));
        ImGui::SetCursorPosY(y);
        text_field(ui, state.options[i], id, card_width(ui) - aside, {}, words("author.option_how"));
    }

    // ── Saving ──

    // Why it cannot be saved yet or was not; empty: nothing is wrong.
    std::string problem() const {
        if (const std::string_view missing = missing_in(state); !missing.empty())
            return std::string(state.tried ? words(missing) : std::string_view{});
        const bool is_refused = state.asked && view.files && view.files->refused;
        return is_refused ? text_of(*view.files->refused, ui.strings) : std::string();
    }

    void save() const {
        state.tried = !missing_in(state).empty();
        if (state.tried) return;
        const std::string path = state.path.text.empty() ? file_name_for(state.title.text) : state.path.text;
        const bool refused = state.asked && view.files->refused;
        const bool replace = refused && state.replacing == path;
        state.replacing = path;
        state.asked = true;
        state.done = view.files->done;
        ui.outbox.push_back(
            SaveExerciseRequest{path, std::make_shared<const ExerciseDraft>(finished_draft(state)), replace});
    }

    void buttons() const {
        const Item yes = button(ui, "author.save", {{}, words("author.save"), Emphasis::primary});
        tooltip(ui, yes, words("author.save_how"));
        if (yes.pressed) save();
        ImGui::SameLine(0, ui.px(8));
        const Item cancel = button(ui, "author.cancel", {{}, words("files.cancel")});
        tooltip(ui, cancel, words("author.cancel_how"), key_name({key::escape}, ui.strings));
        if (cancel.pressed) panels.sheet = Sheet::none;
    }

    void pages() const {
        const std::array<std::string_view, 4> names{words("author.page_texts"), words("author.page_controls"),
                                                    words("author.page_steps"), words("author.page_prediction")};
        const int clicked =
            segments(ui, "author.page", names, static_cast<int>(state.page), card_width(ui), words("author.page_how"));
        if (clicked >= 0) state.page = static_cast<AuthorPage>(clicked), state.goals_open = false;
        gap(ui, 10);
        switch (state.page) {
            case AuthorPage::texts:
                return texts();
            case AuthorPage::controls:
                return controls();
            case AuthorPage::steps:
                return steps();
            case AuthorPage::prediction:
                return prediction();
        }
    }
};

}  // namespace

void author_sheet(const LabView& view, PanelState& panels, Ui& ui, Rect window) {
    if (panels.sheet != Sheet::author) return;
    AuthorState& state = panels.author;
    const bool is_saved = state.asked && view.files && view.files->done > state.done;
    if (is_saved || !view.files || view.now->scene->starts.empty()) {
        panels.sheet = Sheet::none;
        return;
    }
    if (!state.begun) {
        ui.outbox.push_back(BrowseRequest{});
        if (state.title.text == view.now->scene->title) state.title.text = translated(ui, view.now->scene->title);
    }
    const AuthorSheet sheet{view, panels, state, ui};
    begin_sheet(ui, state.sheet, "card.author", ui.strings("author.heading"), author_width, window);
    const float bottom = ImGui::GetCursorPosY() + std::min(ui.px(page_height), window.h - ui.px(200));
    sheet.pages();
    if (const std::string wrong = sheet.problem(); !wrong.empty())
        paragraph(ui, wrong, legible(ui.palette.warning, ui.palette.panel, ui.palette.text));
    if (ImGui::GetCursorPosY() < bottom) ImGui::Dummy({1, bottom - ImGui::GetCursorPosY()});
    sheet_buttons(ui, state.sheet);
    sheet.buttons();
    if (!state.begun && ui.keyboard) ui.keyboard->focus = "author.title", ui.keyboard->revealed = true;
    state.begun = true;
    if (end_sheet(state.sheet)) panels.sheet = Sheet::none;
}

}  // namespace braitenlab::ui
