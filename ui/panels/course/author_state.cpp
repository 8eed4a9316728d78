#include "ui/panels/course/author_state.h"

#include <algorithm>

#include "core/lesson/submission.h"
#include "core/maths/angle.h"

namespace braitenlab::ui {

namespace {

// Every text field of the sheet.
const Start* start_of_selected(const LabView& view) {
    const VehicleView* selected = selected_vehicle(view);
    const auto& starts = view.now->scene->starts;
    if (!selected || selected->start < 0 || static_cast<std::size_t>(selected->start) >= starts.size()) return nullptr;
    return &starts[static_cast<std::size_t>(selected->start)];
}

}  // namespace

std::vector<TextField*> fields_of(AuthorState& author) {
    std::vector<TextField*> all{&author.title, &author.goal, &author.path, &author.question, &author.outcome};
    for (TextField& each : author.hints) all.push_back(&each);
    for (TextField& each : author.step_texts) all.push_back(&each);
    for (TextField& each : author.options) all.push_back(&each);
    for (TextField& each : author.wrong_names) all.push_back(&each);
    return all;
}

void begin_author(const LabView& view, AuthorState& author) {
    if (author.run_id != view.run_id) author = {};
    author.run_id = view.run_id;
    author.begun = author.asked = author.tried = false;
    author.replacing.clear();
    const Scene& scene = *view.now->scene;
    if (!author.dials.empty() || scene.starts.empty()) return;
    author.dials.assign(all_dials.size(), false);
    for (std::size_t i = 0; i < all_dials.size(); ++i) author.dials[i] = !name(all_dials[i]).starts_with("threshold");
    author.parts.assign(std::size(offer_parts::all), false);
    const Start* start = start_of_selected(view);
    author.draft.vehicle = start ? start->name : scene.starts.front().name;
    const Start& first = start ? *start : scene.starts.front();
    if (first.heading_spread > 0) author.draft.heading_spread = maths::degrees(first.heading_spread);
    author.title.text = scene.title;
}

ExerciseDraft finished_draft(const AuthorState& author) {
    ExerciseDraft draft = author.draft;
    draft.title = author.title.text, draft.goal = author.goal.text;
    draft.hints.clear();
    for (const TextField& each : author.hints)
        if (!each.text.empty()) draft.hints.push_back(each.text);
    draft.offers.clear();
    for (std::size_t i = 0; !author.all_controls && i < author.dials.size(); ++i)
        if (author.dials[i]) draft.offers.emplace_back(name(all_dials[i]));
    for (std::size_t i = 0; !author.all_controls && i < author.parts.size(); ++i)
        if (author.parts[i]) draft.offers.emplace_back(offer_parts::all[i]);
    for (std::size_t i = 0; i < draft.steps.size(); ++i) draft.steps[i].text = author.step_texts[i].text;
    for (std::size_t i = 0; i < draft.wrong.size(); ++i) draft.wrong[i].name = author.wrong_names[i].text;
    draft.prediction = {};
    if (author.question.text.empty()) return draft;
    draft.prediction.question = author.question.text;
    draft.prediction.outcome = author.outcome.text;
    draft.prediction.shows = author.draft.prediction.shows;
    draft.prediction.after = std::min(author.draft.prediction.after, draft.seconds);
    for (std::size_t i = 0; i < author.options.size(); ++i) {
        if (author.options[i].text.empty()) continue;
        if (static_cast<int>(i) == author.draft.prediction.answer)
            draft.prediction.answer = static_cast<int>(draft.prediction.options.size());
        draft.prediction.options.push_back(author.options[i].text);
    }
    return draft;
}

std::string_view missing_in(const AuthorState& author) {
    const ExerciseDraft draft = finished_draft(author);
    if (draft.title.empty()) return "author.no_title";
    if (draft.goal.empty()) return "author.no_goal";
    if (draft.offers.empty() && !author.all_controls) return "author.no_control";
    if (draft.steps.empty()) return "author.no_step";
    for (const Step& step : draft.steps)
        if (step.text.empty()) return "author.no_step_text";
    for (const WrongDraft& each : draft.wrong)
        if (each.name.empty()) return "author.no_wrong_name";
    if (draft.prediction.question.empty()) return "";
    const std::vector<std::string>& options = draft.prediction.options;
    for (auto option = options.begin(); option != options.end(); ++option)
        if (std::find(options.begin(), option, *option) != option) return "author.same_options";
    const auto answer = static_cast<std::size_t>(author.draft.prediction.answer);
    if (draft.prediction.options.size() < 2) return "author.no_options";
    return author.options[answer].text.empty() ? "author.no_answer" : "";
}

std::string file_name_for(std::string_view title) {
    std::string made;
    for (const char c : title) {
        const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (is_letter)
            made += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        else if (!made.empty() && made.back() != '-')
            made += '-';
    }
    while (made.ends_with('-')) made.pop_back();
    return made.empty() ? "exercise" : made;
}

}  // namespace braitenlab::ui
