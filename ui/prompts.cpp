#include "ui/prompts.h"

#include <algorithm>
#include <cmath>

namespace braitenlab {

namespace {

bool all_done(const LessonView& lesson) {
    return std::all_of(lesson.verdicts.begin(), lesson.verdicts.end(), [](const Verdict& v) { return v.done; });
}

std::string_view lesson_prompt(const LabView& view) {
    const LessonView& lesson = *view.lesson;
    if (!lesson.has_run && lesson.prediction < 0 && !lesson.exercise->prediction.options.empty())
        return "exercise.predict";
    if (!lesson.has_run) return view.mode == Mode::paused ? "button.play" : "";
    if (all_done(lesson)) return {};
    const int newest = std::min(lesson.hints_shown, static_cast<int>(lesson.exercise->hints.size())) - 1;
    return newest >= 0 ? std::string_view(lesson.exercise->hints[static_cast<std::size_t>(newest)].anchor)
                       : std::string_view{};
}

}  // namespace

std::string_view next_prompt(const LabView& view) {
    if (view.lesson) {
        if (const auto prompt = lesson_prompt(view); !prompt.empty()) return prompt;
        if (!view.lesson->has_run || all_done(*view.lesson) || view.lesson->hints_shown > 0) return {};
    }
    if (view.mode == Mode::wiring || view.undo_depth > 0 || view.redo_depth > 0) return {};
    if (view.now->tick == 0 && view.mode == Mode::paused) return "button.play";
    constexpr double long_enough_to_watch = 3;  // seconds: first the behaviour, then the hand on it
    return view.selected != no_vehicle && view.now->seconds > long_enough_to_watch ? "slider.LL" : "";
}

float pulse(const LabView& view) {
    if (view.reduce_motion) return 1;
    return static_cast<float>(0.5 - 0.5 * std::cos(view.wall_seconds * 2 * 3.14159265358979 / 1.5));
}

}  // namespace braitenlab
