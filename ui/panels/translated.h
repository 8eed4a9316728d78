// What scenes and exercises say, in the language that is shown. Their own words are the key; the files are
// exercises/words/*.toml. Whatever has no translation there says it in its own words.
#pragma once

#include <string_view>

#include "ui/strings.h"
#include "ui/widgets/ui.h"

namespace braitenlab {

inline std::string_view translated(const Ui& ui, std::string_view words) { return ui.strings.find(words, words); }

}  // namespace braitenlab
