// The sheet that saves the open scene as an exercise: its frame and buttons, the pages of texts and offered controls.
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <imgui.h>

#include "core/lesson/submission.h"
#include "ui/panels/course/author_fields.h"
#include "ui/panels/panels.h"
#include "ui/panels/sheets.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/record_fields.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Layout pixels: of a page, so that the buttons stay in their place; what a sheet as high as the window has besides.
constexpr float page_height = 726, around_page = 148;

struct AuthorSheet : AuthorFields {
    // ── The pages ──

    void texts() const {
        field("author.title", state.title, "author.title", "author.title_how");
        field("author.goal_text", state.goal, "author.goal", "author.goal_how");
        subheading(ui, words("author.hints"));
        constexpr std::array<std::string_view, author_hints> hows{"author.hint_how_1", "author.hint_how_2"};
        for (std::size_t i = 0; i < hows.size(); ++i)
            text_field(ui, state.hints[i], "author.hint." + std::to_string(i + 1), card_width(ui), words(hows[i]),
                       words(hows[i]));
        gap(ui, 8);
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
        if (view.documents.files)
            paragraph(ui, view.documents.files->listing.folder, ui.palette.second_text, Face::small);
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
            const std::string part(offer_parts::all[i]);
            if (toggle("author.part." + part, words("author.part." + part), state.parts[i], words("author.part_how"),
                       x))
                state.parts[i] = !state.parts[i];
        }
    }

    void dials(std::size_t from, std::size_t end, std::string_view heading) const {
        subheading(ui, words(heading));
        float x = 0;
        for (std::size_t i = from; i < end; ++i) {
            const std::string dial(name(all_dials[i]));
            std::string label = dial;
            if (label.starts_with("threshold_")) label.erase(0, 10);
            if (toggle("author.dial." + dial, label, state.dials[i], words("author.dial_how"), x))
                state.dials[i] = !state.dials[i];
        }
        gap(ui, 8);
    }

    // ── Saving ──

    // Why it cannot be saved yet or was not; empty: nothing is wrong.
    std::string problem() const {
        if (const std::string_view missing = missing_in(state); !missing.empty())
            return std::string(state.tried ? words(missing) : std::string_view{});
        const bool is_refused = state.asked && view.documents.files && view.documents.files->refused;
        return is_refused ? text_of(*view.documents.files->refused, ui.strings) : std::string();
    }

    void save() const {
        state.tried = !missing_in(state).empty();
        if (state.tried) return;
        const std::string path = state.path.text.empty() ? file_name_for(state.title.text) : state.path.text;
        const bool refused = state.asked && view.documents.files->refused;
        const bool replace = refused && state.replacing == path;
        state.replacing = path;
        state.asked = true;
        state.done = view.documents.files->done;
        ui.outbox.push_back(
            SaveExerciseRequest{path, std::make_shared<const ExerciseDraft>(finished_draft(state)), replace});
    }

    void buttons() const {
        if (push_button(ui, "author.save", {{}, words("author.save"), Emphasis::primary}, words("author.save_how")))
            save();
        ImGui::SameLine(0, ui.px(spacing::small));
        if (push_button(ui, "author.cancel", {{}, words("files.cancel")}, words("author.cancel_how"),
                        key_name({key::escape}, ui.strings)))
            panels.sheet = Sheet::none;
    }

    void pages() const {
        const std::array<std::string_view, 5> names{words("author.page_texts"), words("author.page_controls"),
                                                    words("author.page_steps"), words("author.page_prediction"),
                                                    words("author.page_wrong")};
        const int clicked =
            segments(ui, "author.page", names, static_cast<int>(state.page), card_width(ui), words("author.page_how"));
        if (clicked >= 0) state.page = static_cast<AuthorPage>(clicked), state.goals_open = state.shows_open = false;
        gap(ui, 10);
        switch (state.page) {
            case AuthorPage::texts:
                return texts();
            case AuthorPage::controls:
                return controls();
            case AuthorPage::steps:
                return author_steps_page(*this);
            case AuthorPage::prediction:
                return author_prediction_page(*this);
            case AuthorPage::wrong:
                return author_wrong_page(*this);
        }
    }
};

}  // namespace

void follow_author(const LabView& view, PanelState& panels, Ui&) {
    AuthorState& state = panels.sheets.author;
    if (!state.goes_on || view.documents.draft_run != view.run_id || view.documents.has_draft) return;
    state.run_id = view.run_id;
    state.goes_on = false;
    begin_author(view, state);
    panels.sheet = Sheet::author;
}

void author_sheet(const LabView& view, PanelState& panels, Ui& ui, Rect window) {
    AuthorState& state = panels.sheets.author;
    const bool is_saved = state.asked && view.documents.files && view.documents.files->done > state.done;
    if (is_saved || !view.documents.files || view.now->scene->starts.empty()) {
        panels.sheet = Sheet::none;
        return;
    }
    if (!state.begun) {
        ui.outbox.push_back(BrowseRequest{});
        if (state.title.text == view.now->scene->title) state.title.text = translated(ui, view.now->scene->title);
    }
    const AuthorSheet parts{{view, panels, state, ui}};
    SheetState& sheet = open_sheet(panels, ui, Sheet::author, window);
    // Tabs and buttons stay under the pointer.
    sheet.fixed = std::min(ui.px(page_height), window.h - ui.px(around_page)) - sheet.footer;
    parts.pages();
    sheet_buttons(ui, sheet, parts.problem());
    parts.buttons();
    if (!state.begun && ui.keyboard) ui.keyboard->focus = "author.title", ui.keyboard->revealed = true;
    state.begun = true;
    (void)end_sheet(sheet);  // a click beside it would take what is typed out of sight
}

}  // namespace braitenlab::ui
