#include "ui/panels/exercise_names.h"

#include <tuple>

#include "ui/widgets/paint.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// From 1, in the order of the list.
int number_of_scene(const LabView& view, const CatalogueEntry& entry) {
    int number = 1;
    for (const CatalogueEntry& other : *view.documents.catalogue) {
        if (other.name == entry.name) break;
        number += other.number == 0 ? 1 : 0;
    }
    return number;
}

}  // namespace

const CatalogueEntry* next_exercise(const LabView& view) {
    const CatalogueEntry* next = nullptr;
    if (!view.lesson || !view.documents.catalogue || view.lesson->exercise->number == 0)
        return next;  // one's own is in no order
    const auto order = [](const CatalogueEntry& entry) { return std::tie(entry.number, entry.name); };
    const auto now = std::tie(view.lesson->exercise->number, view.lesson->exercise->id);
    for (const CatalogueEntry& entry : *view.documents.catalogue)
        if (entry.number > 0 && order(entry) > now && (!next || order(entry) < order(*next))) next = &entry;
    return next;
}

std::string_view next_exercise_key(const LabView& view) {
    return next_exercise(view) ? "exercise.next" : "exercise.more";
}

std::string number_words(const LabView& view, int number, std::string_view name) {
    int sharing = 0, before = 0;
    if (view.documents.catalogue)
        for (const CatalogueEntry& other : *view.documents.catalogue)
            if (other.number == number) ++sharing, before += other.name < name ? 1 : 0;
    std::string words = std::to_string(number);
    if (sharing > 1) words += static_cast<char>('a' + before);
    return words;
}

const ExerciseProgress* progress_of(const LabView& view, const CatalogueEntry& entry) {
    return view.documents.students && entry.number > 0 ? find_progress(view.documents.students->student(), entry.name)
                                                       : nullptr;
}

bool is_title_known(const LabView& view, const CatalogueEntry& entry) {
    if (!view.documents.students || !entry.exercise || !is_asked(entry.exercise->prediction)) return true;
    if (view.lesson && view.lesson->exercise->id == entry.name && !hides_outcome(view)) return true;
    const ExerciseProgress* progress = progress_of(view, entry);
    return progress && (progress->passed || !progress->prediction.empty() || progress->drew_path);
}

bool hides_titles(const LabView& view) { return view.lecture && view.settings.revealed.asks_first; }

bool hides_open_title(const LabView& view) { return hides_titles(view) && !view.settings.revealed.title; }

bool hides_names(const LabView& view) { return hides_titles(view) && !view.settings.revealed.character; }

std::string exercise_words(const LabView& view, const Ui& ui, const CatalogueEntry& entry) {
    if (!hides_titles(view)) return searched_words(view, ui, entry);
    if (entry.number > 0) return std::string(ui.strings("open.exercise"));
    return fill(ui.strings("open.scene"), {std::to_string(number_of_scene(view, entry))});
}

std::string searched_words(const LabView& view, const Ui& ui, const CatalogueEntry& entry) {
    return std::string(translated(ui, is_title_known(view, entry) ? entry.title : entry.exercise->goal));
}

std::string_view told_of(const LabView& view, const Ui& ui, const CatalogueEntry& entry) {
    if (hides_titles(view)) return {};
    return translated(ui, entry.exercise ? entry.exercise->goal : entry.story);
}

std::string entry_words(const LabView& view, const Ui& ui, const CatalogueEntry& entry) {
    if (entry.number == 0) return exercise_words(view, ui, entry);
    return number_words(view, entry.number, entry.name) + "  " + exercise_words(view, ui, entry);
}

std::string known_title(const LabView& view, const Ui& ui, std::string_view title) {
    if (view.documents.catalogue)
        for (const CatalogueEntry& entry : *view.documents.catalogue)
            if (entry.title == title && (hides_titles(view) || (entry.number > 0 && !is_title_known(view, entry))))
                return entry_words(view, ui, entry);
    if (hides_titles(view)) return {};
    return std::string(translated(ui, title));
}

std::string best_words(const ExerciseProgress* progress) {
    if (!progress || progress->starts == 0) return {};
    return std::to_string(progress->best) + "/" + std::to_string(progress->starts);
}

}  // namespace braitenlab::ui
