#include "ui/panels/prompts.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "render/view/pick.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompt_breeding.h"
#include "ui/panels/prompt_change.h"
#include "ui/panels/prompt_run.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Simulated seconds before the first slider is suggested, and after which free play suggests none any more, nor an
// exercise while a step is judged at a later time.
constexpr double watched = 3, enough = 8;
constexpr double suggestion = 12;             // wall seconds that a suggestion of free play is shown
constexpr double run_worth_a_look_back = 15;  // simulated seconds

int edit_count(const LabView& view) { return view.undo_depth + view.redo_depth; }

// ── The exercise ──

// True if what the button opens or starts is so already: pressing it would undo what the hint asks for.
bool is_pressed_already(const LabView& view, std::string_view button) {
    if (button == "button.watch") return view.settings.watching || view.mode == Mode::wiring;
    if (button == "button.wiring" || button == "button.open_wiring") return view.mode == Mode::wiring;
    if (button == "button.play") return view.mode == Mode::playing;
    return button == "exercise.compare" && view.lesson->attempt.work.compares;
}

// The newest hint, until the next edit, or until a later run has failed without one and the next hint may be shown.
const Hint* hinted(PromptMemory& memory, const LabView& view) {
    const LessonView& lesson = *view.lesson;
    const int shown = lesson.attempt.answers.hints_shown;
    if (memory.hint != shown) {
        memory.hint = shown, memory.edits_before_hint = edit_count(view);
        memory.runs_before_hint = lesson.attempt.work.runs;
    }
    const int newest = std::min(shown, static_cast<int>(lesson.exercise->hints.size())) - 1;
    if (newest < 0 || edit_count(view) != memory.edits_before_hint) return nullptr;
    const bool is_next_ready =
        lesson.attempt.answers.hint_ready && static_cast<int>(lesson.exercise->hints.size()) > shown;
    if (is_next_ready && lesson.attempt.work.runs > memory.runs_before_hint && has_failed(view)) return nullptr;
    return &lesson.exercise->hints[static_cast<std::size_t>(newest)];
}

// What the newest hint points at. Nothing pulses while its button is pressed already, but the words still ask to follow
// the hint, or to think about it if it is a question.
Prompt of_hint(PromptMemory& memory, const LabView& view) {
    const Hint* hint = hinted(memory, view);
    if (!hint || hint->anchor.empty()) return {};
    const bool is_question = hint->text.ends_with('?'), is_pressed = is_pressed_already(view, hint->anchor);
    return {is_pressed ? std::string_view() : std::string_view(hint->anchor), is_question  ? "hint.think"
                                                                              : is_pressed ? "hint.after_hint"
                                                                                           : "hint.follow_hint"};
}

// In a run that has done a step not before its end: it may do the others, too.
bool may_ask_for_a_hint(const LabView& view) {
    const LessonView& lesson = *view.lesson;
    const Attempt::Answers& answers = lesson.attempt.answers;
    const bool left = answers.hints_shown < static_cast<int>(lesson.exercise->hints.size());
    const bool gains = std::any_of(lesson.verdicts.begin(), lesson.verdicts.end(), [](auto& v) { return v.done; });
    const double from = gains && !has_failed(view) ? 1 : 0.5;  // share of the run
    return left && answers.hint_ready && view.now->seconds >= from * static_cast<double>(lesson.exercise->seconds);
}

// True once the student has changed something: in the runs before, or in this one.
bool has_tried(const PromptMemory& memory, const LabView& view) {
    return edit_count(view) > 0 || has_changed_since_start(memory, view);
}

// True once no hint is left, the solution may be shown, and there was a run for each offered control since the last
// hint: the prompts know no better one.
bool is_at_end_of_hints(const PromptMemory& memory, const LabView& view) {
    const LessonView& lesson = *view.lesson;
    const Attempt::Answers& answers = lesson.attempt.answers;
    const bool is_last = answers.hint_ready && answers.hints_shown >= static_cast<int>(lesson.exercise->hints.size());
    const int controls = static_cast<int>(offered_dials(*lesson.exercise).size());
    return is_last && controls > 0 && lesson.attempt.work.runs > memory.runs_before_hint + controls;
}

// After a run that failed without a change: a control, and a hint once the student has changed something; a reset would
// only repeat the run. Of children the next generation is what is left to choose. At the end of the hints the solution.
Prompt next_try(const PromptMemory& memory, const LabView& view) {
    const Attempt::Answers& answers = view.lesson->attempt.answers;
    const bool has_hint =
        answers.hint_ready && answers.hints_shown < static_cast<int>(view.lesson->exercise->hints.size());
    const Prompt change = change_for_next_run(memory, view);
    const bool chooses = change.anchor == "selection.open" && view.lesson->selection &&
                         view.lesson->selection->generation < view.lesson->exercise->selection.generations;
    if (has_hint && !chooses && (has_tried(memory, view) || change.anchor.empty()))
        return {"exercise.hint", "hint.ask"};
    if (is_at_end_of_hints(memory, view)) return {"exercise.show_me", "hint.show_me"};
    return change;
}

// The same for a run in which the vehicle stands: the words say so where something is in its way.
Prompt next_try_of_standing(const PromptMemory& memory, const LabView& view, std::string_view why) {
    Prompt next = next_try(memory, view);
    if (why == "hint.blocked" && next.hint == "hint.change_then_reset") next.hint = "hint.change_blocked";
    return next;
}

// While too few of the other starts pass: the newest hint, or the next one, or a control.
Prompt of_other_starts(PromptMemory& memory, const LabView& view) {
    const Attempt::Answers& answers = view.lesson->attempt.answers;
    if (const Prompt prompt = of_hint(memory, view); !prompt.hint.empty()) return prompt;
    if (answers.hint_ready && answers.hints_shown < static_cast<int>(view.lesson->exercise->hints.size()))
        return {"exercise.hint", "hint.other_starts"};
    const Prompt change = change_for_next_run(memory, view);
    return change.anchor.empty() ? Prompt{{}, "hint.other_starts"} : change;
}

// True if more is changed than the exercise offers or allows: its other starts are not tested then.
bool is_beyond_offers(const Standing& standing) { return standing.outside_offers || standing.too_many_changes; }

Prompt of_lesson(PromptMemory& memory, const LabView& view) {
    const LessonView& lesson = *view.lesson;
    const bool at_start = view.now->tick == 0 && view.mode == Mode::paused;
    if (!lesson.attempt.work.has_run && needs_start_over(lesson)) return {"exercise.reset", "hint.start_over"};
    if (awaits_prediction(lesson)) return {"exercise.predict", "hint.predict"};
    if (!lesson.attempt.work.has_run) return at_start ? Prompt{"button.play", "hint.press_play"} : Prompt{};
    if (lesson.grade && lesson.grade->good) return {"exercise.next", "hint.passed"};
    if (all_steps_done(lesson) && lesson.standing.changed_since_done) return {"button.reset", "hint.changed_since"};
    if (all_steps_done(lesson) && is_beyond_offers(lesson.standing)) return {{}, "hint.not_graded"};
    if (all_steps_done(lesson)) return lesson.grade ? of_other_starts(memory, view) : Prompt{{}, "hint.steps_done"};
    if (is_subject_gone(view)) return {"button.reset", "hint.gone"};
    if (is_bred(view)) return of_breeding(memory, view);
    if (const Prompt prompt = of_hint(memory, view); !prompt.hint.empty()) return prompt;
    if (at_start && are_equal(memory.failed, tried_now(view)))
        if (const Prompt prompt = next_try(memory, view); !prompt.anchor.empty()) return prompt;
    if (at_start) return {"button.play", "hint.press_play"};
    if (view.mode == Mode::playing && is_completing_a_step(lesson)) return {};
    const bool is_repeated = is_as_at_start(memory, view);
    if (const Prompt out = way_out(memory, view); !out.anchor.empty() && !waits_for_a_step(view))
        return is_repeated ? next_try_of_standing(memory, view, out.hint) : out;
    const bool has_failed_as_changed = has_failed(view) && has_changed_since_start(memory, view);
    if (has_failed_as_changed || has_missed_a_change(memory, view)) return {"button.reset", "hint.changed_since"};
    if (has_failed(view) && is_repeated) return next_try(memory, view);
    if (has_tried(memory, view) && may_ask_for_a_hint(view)) return {"exercise.hint", "hint.ask"};
    return {};
}

// ── Free play ──

// True while the suggestion is shown. It ends when it is followed or after `suggestion` seconds.
bool is_shown_now(Suggested& suggested, bool followed, double wall_seconds) {
    if (suggested.known || followed) return suggested.known = true, false;
    if (suggested.since < 0) suggested.since = wall_seconds;
    suggested.known = wall_seconds - suggested.since > suggestion;
    return !suggested.known;
}

bool lamp_was_moved(const LabView& view) {
    const auto& now = view.now->scene->sources;
    return !view.file || now.empty() || view.file->sources != now;
}

// The wires with an effect that start at the node.
std::ptrdiff_t wires_from(const BrainGraph& brain, const Node& node) {
    return std::count_if(brain.wires.begin(), brain.wires.end(),
                         [&](const Wire& wire) { return wire.from == node.id && wire.weight != 0; });
}

// In an exercise what the newest hint points at; else the output pin of the sensor SL, if the brain has one that is not
// wired to both motors, until the first edit.
Prompt of_wiring(PromptMemory& memory, const LabView& view) {
    // The task of an exercise is not to draw a first wire. The usual words of the mode stay.
    if (view.lesson) return {of_hint(memory, view).anchor, {}};
    if (memory.edits_before_wiring < 0) memory.edits_before_wiring = edit_count(view);
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle || edit_count(view) != memory.edits_before_wiring) return {};
    const BrainGraph& brain = *brain_of(*view.now, *vehicle);
    const Node* eye = find_node(brain, "SL");
    const bool has_free_motor = eye && wires_from(brain, *eye) < 2;
    return has_free_motor ? Prompt{"pin.SL.out", "hint.first_wire"} : Prompt{};
}

void remember_what_is_done(PromptMemory& memory, const LabView& view) {
    PromptsFollowed& followed = memory.followed;
    followed.slider |= edit_count(view) > 0;
    followed.lamp |= view.file && edit_count(view) > 0 && view.file->sources != view.now->scene->sources;
    followed.wiring |= view.mode == Mode::wiring;
    followed.timeline |= view.now->tick < view.timeline.latest;
    memory.lamp.known |= followed.lamp;
    memory.wiring.known |= followed.wiring;
    memory.timeline.known |= followed.timeline;
}

// True if nothing can move the selected vehicle: no wire carries anything, and no neuron gives anything by itself.
bool has_nothing_to_drive(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle || vehicle->driver != Driver::brain) return false;
    const BrainGraph& brain = *brain_of(*view.now, *vehicle);
    return std::all_of(brain.wires.begin(), brain.wires.end(), [](const Wire& wire) { return wire.weight == 0; }) &&
           std::all_of(brain.nodes.begin(), brain.nodes.end(), [](const Node& node) { return node.bias == 0; });
}

// True if the eyes of the selected vehicle see nothing because the scene has no lamp at all.
bool lacks_lamp(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle || !view.now->sources.empty() || !is_blind(*view.now, *vehicle)) return false;
    const auto& sensors = kind_of(*view.now, *vehicle).sensors;
    return std::any_of(sensors.begin(), sensors.end(),
                       [](const Sensor& sensor) { return is_seen_as(Channel::light, sensor.channel); });
}

Prompt of_free_play(PromptMemory& memory, const LabView& view) {
    const Snapshot& now = *view.now;
    if (!memory.played) return {"button.play", "hint.press_play"};
    if (!memory.slider_known) return now.seconds < watched ? Prompt{} : first_change(view);
    if (view.lesson) return {};  // the exercise gives the hints
    const bool lamp_is_known = lamp_was_moved(view) || !telling_lamp(view);
    if (is_shown_now(memory.lamp, lamp_is_known, view.wall_seconds)) return {lamp_anchor, "hint.drag_lamp"};
    if (is_shown_now(memory.wiring, false, view.wall_seconds)) return {"button.wiring", "hint.open_wiring"};
    if (now.seconds < run_worth_a_look_back) return {};
    if (is_shown_now(memory.timeline, false, view.wall_seconds)) return {"timeline.track", "hint.look_back"};
    return {};
}

}  // namespace

Prompt next_prompt(PromptMemory& memory, const LabView& view) {
    if (memory.opened != view.documents.opened) memory = {view.documents.opened, memory.followed, memory.highlight};
    remember_what_is_done(memory, view);
    const bool is_later = view.now->seconds > enough && (!view.lesson || waits_for_a_step(view));
    memory.slider_known |= memory.followed.slider || is_later;
    memory.played |= view.now->tick > 0 || view.mode == Mode::playing;
    watch_run(memory, view);
    remember_failure(memory, view);
    if (view.mode == Mode::wiring) return of_wiring(memory, view);
    memory.edits_before_wiring = -1;
    const bool is_past = view.now->tick < view.timeline.latest;
    if (is_past || view.mode != Mode::paused || memory.past != view.now->tick) memory.past.reset();
    if (is_past && view.mode == Mode::paused) return memory.past = view.now->tick, Prompt{{}, "hint.in_the_past"};
    const bool has_passed = view.lesson && view.lesson->grade && view.lesson->grade->good;
    if (memory.past && !has_passed) return {"button.play", "hint.play_on"};  // a change has removed what came later
    if (view.lesson)
        if (const Prompt prompt = of_lesson(memory, view); !prompt.anchor.empty() || !prompt.hint.empty())
            return prompt;
    if (is_bred(view)) return {};
    if (view.lesson && (!view.lesson->attempt.work.has_run || view.lesson->attempt.answers.hints_shown > 0)) return {};
    if (!view.lesson && view.now->vehicles.empty()) return {};  // the usual hint is to add one
    if (!view.lesson && has_nothing_to_drive(view)) return {"bias.LM", "hint.no_wires"};
    if (!view.lesson)
        if (const Prompt out = way_out(memory, view); !out.anchor.empty())
            return lacks_lamp(view) ? Prompt{"tool.lamp", "hint.nothing_shines"} : out;
    return of_free_play(memory, view);
}

bool is_slider(std::string_view anchor) {
    constexpr std::string_view stems[]{"slider.", "bias.", "threshold.", "curve."};
    return std::any_of(std::begin(stems), std::end(stems), [&](auto stem) { return anchor.starts_with(stem); });
}

std::string_view next_change(const LabView& view, std::string_view pulsing) {
    const bool has_answered = view.lesson && has_predicted(view.lesson->attempt.answers);
    if (view.mode != Mode::wiring && hides_outcome(view) && !has_answered && !view.lecture)
        return view.may.open_prediction ? "hint.change.answer" : "hint.change.answer_later";
    if (is_slider(pulsing)) return "hint.change.pulsing";
    if (pulsing == "button.wiring") return "hint.change.wire";
    if (pulsing == "card.sensors") return "hint.change.sensor";
    if (pulsing == "selection.open") return "hint.change.child";
    if (!offers_some(view)) return "hint.change.slider";
    const Exercise& exercise = *view.lesson->exercise;
    if (is_bred(view) && view.mode != Mode::wiring) return "hint.change.breed";
    if (!offered_dials(exercise).empty() || offers(exercise, offer_parts::curves)) return "hint.change.slider";
    if (offers(exercise, offer_parts::wiring)) return "hint.change.wire";
    return offers(exercise, offer_parts::sensors) ? "hint.change.sensor" : "hint.change.child";
}

float pulse(const LabView& view) {
    if (view.program.reduce_motion) return 1;
    return static_cast<float>(0.5 - 0.5 * std::cos(view.wall_seconds * 2 * 3.14159265358979 / 1.5));
}

void point_to_lamp(const LabView& view, Ui& ui) {
    const SourceView* lamp = ui.highlight == lamp_anchor && view.camera_view ? telling_lamp(view) : nullptr;
    if (!lamp) return;
    const auto at = project(*view.camera_view, {lamp->x, lamp->y}, bulb_height * scale_of(view.now->scene->arena));
    if (!at) return;
    const float radius = ui.px(18 + 4 * ui.pulse);
    ImGui::GetBackgroundDrawList()->AddCircle(
        {at->x, at->y}, radius, paint(ui.palette.accent.with_alpha(0.4f + 0.6f * ui.pulse)), 48, ui.px(2.5f));
    const float away = 0.7f * radius + ui.px(0.25f * hint_badge_radius);
    hint_badge(ui, *ImGui::GetBackgroundDrawList(), {at->x + away, at->y - away});
    ui.anchors.record(lamp_anchor, {at->x - radius, at->y - radius, 2 * radius, 2 * radius});
}

}  // namespace braitenlab::ui
