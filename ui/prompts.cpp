#include "ui/prompts.h"

#include <algorithm>
#include <cmath>

#include "core/brain/four_neurons.h"

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

// Simulated seconds: first the behaviour, then the hand on it, and not for ever.
constexpr double watched = 3, enough = 8;

bool has_been_edited(const LabView& view) { return view.undo_depth > 0 || view.redo_depth > 0; }

// Of the selected vehicle's weights the first that does something now; else the first.
std::string_view telling_slider(const LabView& view) {
    const VehicleView* vehicle = find_vehicle(*view.now, view.selected);
    if (!vehicle) return {};
    const FourNeurons dials = read_dials(*view.now->brains[static_cast<std::size_t>(vehicle->brain)]);
    if (dials.LL != 0) return "slider.LL";
    if (dials.LR != 0) return "slider.LR";
    if (dials.RL != 0) return "slider.RL";
    return dials.RR != 0 ? "slider.RR" : "slider.LL";
}

bool follows_a_hint(const LabView& view) { return view.lesson && view.lesson->hints_shown > 0; }

}  // namespace

std::string_view next_prompt(const LabView& view) {
    if (view.lesson) {
        if (const auto prompt = lesson_prompt(view); !prompt.empty()) return prompt;
        if (!view.lesson->has_run || all_done(*view.lesson) || view.lesson->hints_shown > 0) return {};
    }
    if (view.mode == Mode::wiring || has_been_edited(view)) return {};
    if (view.now->tick == 0 && view.mode == Mode::paused) return "button.play";
    const double seconds = view.now->seconds;
    return seconds < watched || seconds > enough ? std::string_view{} : telling_slider(view);
}

std::string_view still_wanted(PromptMemory& memory, const LabView& view, std::string_view prompt) {
    if (memory.opened != view.opened) memory = {view.opened};
    memory.slider_known |= has_been_edited(view) || view.now->seconds > enough;
    const bool is_slider = prompt.substr(0, 7) == "slider.";
    return memory.slider_known && is_slider && !follows_a_hint(view) ? std::string_view{} : prompt;
}

float pulse(const LabView& view) {
    if (view.reduce_motion) return 1;
    return static_cast<float>(0.5 - 0.5 * std::cos(view.wall_seconds * 2 * 3.14159265358979 / 1.5));
}

}  // namespace braitenlab
