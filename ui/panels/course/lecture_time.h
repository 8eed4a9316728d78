// The time of a lecture in words.
#pragma once

#include <string>

#include "ui/lab_view.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

// The time since the lecture was opened, the planned end of the page and that of the lecture: "12:05 · page ends at
// 14:00 of 45:00".
std::string time_words(const LectureView&, const Strings&);

}  // namespace braitenlab::ui
