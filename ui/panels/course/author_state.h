// State of the sheet that saves the open scene as an exercise.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/lesson/author.h"
#include "ui/lab_view.h"
#include "ui/widgets/text_field.h"

namespace braitenlab::ui {

enum class AuthorPage { texts, controls, steps, prediction, wrong };

inline constexpr std::size_t author_steps = 3, author_options = 4, author_wrong = 4, author_hints = 2;  // at most

struct AuthorState {
    AuthorPage page = AuthorPage::texts;
    ExerciseDraft draft;  // texts are in the fields below until it is saved
    TextField title, goal, path;
    std::array<TextField, author_hints> hints;
    std::array<TextField, author_steps> step_texts;
    TextField question, outcome;
    std::array<TextField, author_options> options;
    std::array<TextField, author_wrong> wrong_names;
    std::size_t step_shown = 0;      // whose goal and values are shown
    bool goals_open = false;         // the list of goals of the step is unfolded
    bool shows_open = false;         // that of what the run shows
    std::vector<bool> dials, parts;  // offered, in the order of all_dials and offer_parts::all
    bool all_controls = false;       // offered are all controls
    std::uint64_t run_id = 0;        // of the document that the draft is about; the draft stays while it is open
    bool goes_on = false;            // opens again with this draft once its scene is restored
    bool tried = false;              // to save, while something was missing
    bool begun = false;              // drawn at least once since it was opened
    bool asked = false;              // a request is in progress; it has succeeded when FilesView::done exceeds `done`
    int done = 0;
    std::string replacing;  // path of an existing file, until the user confirms
};

// Prepares the sheet for the open scene. A draft of the same document is kept.
void begin_author(const LabView&, AuthorState&);

// The text fields of the sheet.
std::vector<TextField*> fields_of(AuthorState&);

// The draft with the texts of the fields and the offered controls.
ExerciseDraft finished_draft(const AuthorState&);

// The string key of what the draft lacks; empty if it can be saved.
std::string_view missing_in(const AuthorState&);

// "The lamp!" becomes "the-lamp": a file name for a title.
std::string file_name_for(std::string_view title);

}  // namespace braitenlab::ui
