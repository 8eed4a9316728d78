// How lists and menus name the exercises. The title of many exercises tells what the vehicle will do, so it is shown
// only once the student has made the prediction, has seen the outcome or has passed; before, the first words of the
// goal stand for it. While a lecture asks first (Revealed::asks_first), exercises and scenes have a number only.
#pragma once

#include <string>
#include <string_view>

#include "ui/lab_view.h"
#include "ui/widgets/ui.h"

namespace braitenlab::ui {

// The progress of the present student; null if there is none.
const ExerciseProgress* progress_of(const LabView&, const CatalogueEntry&);

// True if the title tells nothing that the student is still asked to predict, and where no progress is kept.
bool is_title_known(const LabView&, const CatalogueEntry&);

// The exercise after the open one, by number and then by name; null without one, and for one's own exercise, which is
// in no order. The string key of what leads to it, on the card and in the bar.
const CatalogueEntry* next_exercise(const LabView&);
std::string_view next_exercise_key(const LabView&);

// "14"; "14a", "14b" … for exercises that share a number, in the order of their names.
std::string number_words(const LabView&, int number, std::string_view name);

// True while titles, goals and stories would tell an audience what it is asked.
bool hides_titles(const LabView&);

// While a lecture asks first: true until the title of what is open is shown, with its story, reason and caption; and
// true until the character is shown, with the names that kinds and vehicles have.
bool hides_open_title(const LabView&);
bool hides_names(const LabView&);

// The title, or the goal, without the number. Of a scene: its title, or its number among the scenes.
std::string exercise_words(const LabView&, const Ui&, const CatalogueEntry&);
// The title, or the goal, as it is shown while no lecture asks first: what a search goes by.
std::string searched_words(const LabView&, const Ui&, const CatalogueEntry&);
// With the number before it: "5  Aggressor". A scene: as exercise_words().
std::string entry_words(const LabView&, const Ui&, const CatalogueEntry&);

// What a tooltip or a second line says of it: the goal or the story; nothing while titles are hidden.
std::string_view told_of(const LabView&, const Ui&, const CatalogueEntry&);

// The title of a file, translated; of a shipped exercise as entry_words(), and so of a shipped scene while titles are
// hidden. Empty for others then.
std::string known_title(const LabView&, const Ui&, std::string_view title);

// "9/10": the best grade so far; empty without one.
std::string best_words(const ExerciseProgress*);

}  // namespace braitenlab::ui
