// The place of the words of the title page, beside or above which the scene is.
#pragma once

namespace braitenlab::ui {

// Of the window's width, of an upright one's height.
inline constexpr float title_words_share = 0.42f;

}  // namespace braitenlab::ui
