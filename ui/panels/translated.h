// The texts of scenes and exercises in the language that is shown. Translations are stored by id (see texts_of in
// core/lesson/exercise.h) and found by the shipped text, so that a text changed by the user is shown as it is.
#pragma once

#include <string_view>
#include <vector>

#include "core/lesson/exercise.h"
#include "ui/strings.h"
#include "ui/widgets/ui.h"

namespace braitenlab {

inline std::string_view translated(const Ui& ui, std::string_view words) { return ui.strings.find(words, words); }

// Adds the translation of each text that has one. `by_id`: a file of exercises/words.
inline void add_translations(Strings& strings, const std::vector<TranslatableText>& texts, const Strings& by_id) {
    for (const TranslatableText& text : texts)
        if (const std::string_view translation = by_id.find(text.id, {}); !translation.empty())
            strings.add(text.text, std::string(translation));
}

}  // namespace braitenlab
