// Texts of files that have translations.
#pragma once

#include <string>

namespace braitenlab {

// A text that can be translated, by an id that does not depend on its wording: "05-aggressor.step.1.text",
// "scene.2a-coward.story". Translations: exercises/words/*.toml.
struct TranslatableText {
    std::string id, text;
};

}  // namespace braitenlab
