#include "ui/panels/course/lesson_text.h"

#include "ui/measure_text.h"

namespace braitenlab::ui {

std::string measure_text(const Ui& ui, const Measure& measure, bool done) {
    return measure_text(ui.strings, measure, done);
}

}  // namespace braitenlab::ui
