#include "ui/panels/prompts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "core/scene/subject.h"
#include "render/view/pick.h"
#include "ui/panels/offered.h"
#include "ui/panels/panels.h"
#include "ui/widgets/item.h"
#include "ui/widgets/paint.h"
#include "ui/widgets/theme.h"
#include "ui/words/strings.h"

namespace braitenlab::ui {

namespace {

// Simulated seconds before the first slider is suggested, and after which no slider is suggested any more.
constexpr double watched = 3, enough = 8;
constexpr double suggestion = 12;             // wall seconds that a suggestion of free play is shown
constexpr double run_worth_a_look_back = 15;  // simulated seconds

constexpr float sees_nothing = 0.02f, standstill = 0.03f;  // of a sensor, 0..1; m/s
constexpr double lost_after = 3, stuck_after = 6;          // simulated seconds; 3a-love rests for five

bool all_steps_done(const LessonView& lesson) {
    return std::all_of(lesson.verdicts.begin(), lesson.verdicts.end(), [](const Verdict& v) { return v.done; });
}

int edit_count(const LabView& view) { return view.undo_depth + view.redo_depth; }

bool is_blind(const Snapshot& now, const VehicleView& vehicle) {
    const auto begin = now.sensed.begin() + vehicle.first_sensed;
    const auto count = static_cast<std::ptrdiff_t>(kind_of(now, vehicle).sensors.size());
    return count > 0 && std::all_of(begin, begin + count, [](float value) { return value < sees_nothing; });
}

// The readings of the vehicle's sensors, in their order.
std::span<const float> readings(const Snapshot& now, const VehicleView& vehicle) {
    const auto first = static_cast<std::size_t>(vehicle.first_sensed);
    return std::span(now.sensed).subspan(first, kind_of(now, vehicle).sensors.size());
}

// The value of the sensor of this name among those of all; 0 if there is none.
float value_of(std::string_view sensor, const std::vector<Sensor>& sensors, std::span<const float> values) {
    for (std::size_t i = 0; i < std::min(sensors.size(), values.size()); ++i)
        if (sensors[i].name == sensor) return values[i];
    return 0;
}

// A weight with the slider that turns it.
struct TellingWeight {
    Dial dial;
    std::string_view slider;
};

// The weight of a sensor that reads something, more than the threshold of the wire, so that turning it has an effect:
// preferably of a wire, that is a weight that is not 0, and only one that `suits`. An empty slider if there is none.
// `values`: of the vehicle's sensors.
template <class Suits>
std::string_view telling_slider(const Snapshot& now, const VehicleView& vehicle, const SensorPair& pair,
                                std::span<const float> values, Suits suits) {
    constexpr TellingWeight weights[]{
        {Dial::LL, "slider.LL"}, {Dial::LR, "slider.LR"}, {Dial::RL, "slider.RL"}, {Dial::RR, "slider.RR"}};
    const FourNeurons dials = read_dials(*brain_of(now, vehicle), pair);
    const auto& sensors = kind_of(now, vehicle).sensors;
    const float left = value_of(pair.left, sensors, values), right = value_of(pair.right, sensors, values);
    for (const bool is_wire : {true, false})
        for (const TellingWeight& each : weights) {
            const float seen = each.dial == Dial::LL || each.dial == Dial::RL ? left : right;
            if (seen >= std::max(sees_nothing, at(dials, threshold_of(each.dial))) &&
                (at(dials, each.dial) != 0) == is_wire && suits(each.dial))
                return each.slider;
        }
    return {};
}

// The first lamp that a sensor of the selected vehicle measures; null if there is none.
const SourceView* telling_lamp(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle) return nullptr;
    const auto& sensors = kind_of(*view.now, *vehicle).sensors;
    for (const SourceView& lamp : view.now->sources)
        for (const Sensor& sensor : sensors)
            if (is_seen_as(lamp.channel, sensor.channel)) return &lamp;
    return nullptr;
}

// True if the brain gives the wheels little or no speed; else something is in the way of a vehicle that stands.
bool is_halted(const VehicleView& vehicle) {
    constexpr float at_rest = 0.05f;
    return std::fabs(vehicle.motor[0]) < at_rest && std::fabs(vehicle.motor[1]) < at_rest;
}

// True for a vehicle that something holds although its motors turn: what its brain does then changes nothing.
bool is_held(const LabView& view, const VehicleView& vehicle) {
    return view.mode == Mode::playing && std::fabs(vehicle.speed) < standstill && !is_halted(vehicle);
}

// Both biases, first the one that a hint of the exercise points at.
std::array<Dial, 2> biases_to_try(const Exercise& exercise) {
    const auto is_hinted = [&](Dial bias) {
        return std::any_of(exercise.hints.begin(), exercise.hints.end(),
                           [&](const Hint& hint) { return hint.anchor == anchor_of(bias); });
    };
    return is_hinted(Dial::RM) && !is_hinted(Dial::LM) ? std::array{Dial::RM, Dial::LM}
                                                       : std::array{Dial::LM, Dial::RM};
}

// Of the controls that the exercise offers, one whose effect the user sees at once: a weight of an eye that sees
// something, a bias, the peak of the curves of such an eye, or the sensors, if they see nothing.
Prompt offered_change(const LabView& view, const VehicleView& vehicle) {
    if (is_held(view, vehicle)) return {};
    const Exercise& exercise = *view.lesson->exercise;
    const std::string_view hint = view.mode == Mode::playing ? "hint.turn_slider" : "hint.turn_slider_paused";
    const auto is_offered_dial = [&](Dial dial) { return offers(exercise, dial); };
    if (const auto slider = telling_slider(*view.now, vehicle, shown_pair(view, vehicle), readings(*view.now, vehicle),
                                           is_offered_dial);
        !slider.empty())
        return {slider, hint};
    for (const Dial bias : biases_to_try(exercise))
        if (offers(exercise, bias)) return {anchor_of(bias), hint};
    const bool sees = !is_blind(*view.now, vehicle);
    if (sees && offers(exercise, offer_parts::curves)) return {"curve.peak", hint};
    if (!sees && offers(exercise, offer_parts::sensors)) return {"card.sensors", "hint.turn_sensors"};
    if (offers(exercise, offer_parts::wiring)) return {"button.wiring", "hint.open_wiring"};
    return {};
}

// A change that the user sees at once: of a weight, or of the stimulus if the sensors read nothing.
// (In an exercise a run with a moved lamp does not count.)
Prompt first_change(const LabView& view) {
    const VehicleView* vehicle = selected_vehicle(view);
    if (!vehicle) return {};
    const bool plays = view.mode == Mode::playing;
    if (offers_some(view)) return offered_change(view, *vehicle);
    const auto any = [](Dial) { return true; };
    if (const auto slider =
            telling_slider(*view.now, *vehicle, shown_pair(view, *vehicle), readings(*view.now, *vehicle), any);
        !slider.empty())
        return {slider, plays ? "hint.turn_slider" : "hint.turn_slider_paused"};
    if (!view.lesson && is_blind(*view.now, *vehicle) && telling_lamp(view)) return {lamp_anchor, "hint.lamp_nearer"};
    return {};
}

// ── A vehicle that is blocked or senses nothing ──

// `since`: the time from which on the condition holds; −1 while it does not.
void keep_time(double& since, bool holds, double now) {
    if (!holds || now < since) since = -1;
    if (holds && since < 0) since = now;
}

bool lasts(double since, double for_seconds, double now) { return since >= 0 && now - since >= for_seconds; }

// The vehicle that the student changes: of several the first of the kind that the exercise is about. Null: none.
const VehicleView* subject_of(const LabView& view) {
    const auto& vehicles = view.now->vehicles;
    if (vehicles.size() == 1) return &vehicles.front();
    const int kind = view.lesson ? subject_kind(*view.now->scene) : -1;
    const auto found =
        std::find_if(vehicles.begin(), vehicles.end(), [&](const VehicleView& v) { return v.kind == kind; });
    return found == vehicles.end() ? nullptr : &*found;
}

// What the student changes: of the subject, or of its kind when it is gone. nullopt: the scene has none.
std::optional<TriedBrain> tried_now(const LabView& view) {
    const Snapshot& now = *view.now;
    if (const VehicleView* subject = subject_of(view))
        return TriedBrain{brain_of(now, *subject), kind_of(now, *subject).sensors};
    const int kind = view.lesson ? subject_kind(*now.scene) : -1;
    const auto index = static_cast<std::size_t>(kind);
    if (kind < 0 || index >= now.kind_brains.size()) return std::nullopt;
    return TriedBrain{now.kind_brains[index], now.scene->kinds[index].sensors};
}

bool are_equal(const std::optional<TriedBrain>& a, const std::optional<TriedBrain>& b) {
    return a && b && (a->brain == b->brain || *a->brain == *b->brain) && a->sensors == b->sensors;
}

// True if this run has shown the present brain and sensors from its start on: a reset alone then gives the same run.
bool is_as_at_start(const PromptMemory& memory, const LabView& view) {
    return are_equal(memory.at_start, tried_now(view));
}

// The most that each sensor of the subject has read in this run; at its start, in the last one.
void remember_readings(PromptMemory& memory, const LabView& view) {
    const VehicleView* subject = subject_of(view);
    const bool begins = !std::exchange(memory.has_begun, view.now->tick > 0);
    if (view.now->tick == 0 || !subject) return;
    const std::span<const float> values = readings(*view.now, *subject);
    const bool stands = std::fabs(subject->speed) < standstill && is_halted(*subject);
    memory.halted_blind = (memory.halted_blind && !begins) || (stands && is_blind(*view.now, *subject));
    if (begins || memory.most_read.size() != values.size()) memory.most_read.assign(values.size(), 0);
    for (std::size_t i = 0; i < values.size(); ++i) memory.most_read[i] = std::max(memory.most_read[i], values[i]);
}

// A single vehicle that senses nothing or does not move needs a reset. In scenes with several vehicles both are common.
void watch_vehicle(PromptMemory& memory, const LabView& view) {
    const Snapshot& now = *view.now;
    const VehicleView* vehicle = now.vehicles.size() == 1 ? &now.vehicles.front() : nullptr;
    const bool counts = vehicle && vehicle->driver == Driver::brain && now.tick > 0;
    const bool stands = vehicle && std::fabs(vehicle->speed) < standstill;
    keep_time(memory.blind_since, counts && !stands && is_blind(now, *vehicle), now.seconds);
    keep_time(memory.still_since, counts && stands, now.seconds);
    keep_time(memory.dark_since, counts && is_blind(now, *vehicle), now.seconds);
    if (now.tick == 0) memory.at_start = tried_now(view);
    remember_readings(memory, view);
}

// Why a vehicle does not move.
std::string_view hint_at_rest(const VehicleView& vehicle) {
    if (is_halted(vehicle)) return "hint.halted";
    return wheels_push(vehicle.motor[0], vehicle.motor[1]) ? "hint.blocked" : "hint.stuck";
}

Prompt way_out(const PromptMemory& memory, const LabView& view) {
    if (lasts(memory.still_since, stuck_after, view.now->seconds))
        return {"button.reset", hint_at_rest(view.now->vehicles.front())};
    if (lasts(memory.blind_since, lost_after, view.now->seconds)) return {"button.reset", "hint.lost"};
    return {};
}

// ── The exercise ──

// True if what the button opens or starts is so already: pressing it would undo what the hint asks for.
bool is_pressed_already(const LabView& view, std::string_view button) {
    if (button == "button.watch") return view.settings.watching || view.mode == Mode::wiring;
    if (button == "button.wiring" || button == "button.open_wiring") return view.mode == Mode::wiring;
    if (button == "button.play") return view.mode == Mode::playing;
    return button == "exercise.compare" && view.lesson->attempt.work.compares;
}

bool has_failed(const LabView&);

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

bool may_ask_for_a_hint(const LabView& view) {
    const LessonView& lesson = *view.lesson;
    const Attempt::Answers& answers = lesson.attempt.answers;
    const bool left = answers.hints_shown < static_cast<int>(lesson.exercise->hints.size());
    return left && answers.hint_ready && view.now->seconds >= 0.5 * static_cast<double>(lesson.exercise->seconds);
}

// True if the run alone completes a step within the next seconds, or every step in the end: then no hint asks for a
// change.
bool is_completing_a_step(const LessonView& lesson) {
    constexpr float soon = 5;  // s
    const auto lasts_for = [](const Verdict& verdict, float most) {
        return !verdict.done && !verdict.lost &&
               std::any_of(verdict.measures.begin(), verdict.measures.end(), [most](const Measure& m) {
                   return m.unit == "s" && !m.at_most && !m.best && m.value > 0 && m.value < m.needed &&
                          m.needed - m.value <= most;
               });
    };
    const auto& verdicts = lesson.verdicts;
    return std::any_of(verdicts.begin(), verdicts.end(), [&](const Verdict& v) { return lasts_for(v, soon); }) ||
           std::all_of(verdicts.begin(), verdicts.end(),
                       [&](const Verdict& v) { return v.done || lasts_for(v, INFINITY); });
}

// True while a step is still to be judged at a later time, after lamps were switched for example: the vehicle may stand
// and see nothing until then.
bool waits_for_a_step(const LabView& view) {
    const auto& steps = view.lesson->exercise->steps;
    const auto& verdicts = view.lesson->verdicts;
    for (std::size_t i = 0; i < std::min(steps.size(), verdicts.size()); ++i)
        if (!verdicts[i].done && !verdicts[i].lost && static_cast<double>(steps[i].check.earliest) > view.now->seconds)
            return true;
    return false;
}

// True if wires were changed in this run and the vehicle senses nothing: they then carry nothing, and the change shows
// after a reset only.
bool has_missed_a_change(const PromptMemory& memory, const LabView& view) {
    if (!lasts(memory.dark_since, lost_after, view.now->seconds) || waits_for_a_step(view)) return false;
    const auto& brain = brain_of(*view.now, view.now->vehicles.front());
    return memory.at_start && memory.at_start->brain != brain && memory.at_start->brain->wires != brain->wires;
}

bool is_bred(const LabView& view) { return view.lesson && !offered_breeding(*view.lesson->exercise).empty(); }

// True if the run has not shown the present brain and sensors from its start on.
bool has_changed_since_start(const PromptMemory& memory, const LabView& view) {
    return view.now->tick > 0 && memory.at_start && tried_now(view) && !is_as_at_start(memory, view);
}

// True if this run cannot complete every step any more.
bool has_failed(const LabView& view) {
    const auto& verdicts = view.lesson->verdicts;
    return view.now->seconds >= static_cast<double>(view.lesson->exercise->seconds) ||
           std::any_of(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return v.lost && !v.done; });
}

// True while the breeding of the exercise has the opponents of its file: with them hardly a champion passes.
bool has_shipped_opponents(const LabView& view) {
    const BreedingView& bred = view.features.breeding;
    const std::string_view offered = offered_breeding(*view.lesson->exercise);
    if (!bred.base || !bred.shipped) return false;
    return std::any_of(bred.shipped->begin(), bred.shipped->end(), [&](const evolve::Breeding& each) {
        return each.id == offered && each.opponents == bred.base->breeding().opponents;
    });
}

// The next step of an exercise that is solved by breeding: start it, wait, take the champion, reset, play. A hint, or
// a champion that has failed, leads to other opponents first.
Prompt of_breeding(const PromptMemory& memory, const LabView& view) {
    const LessonView& lesson = *view.lesson;
    const BreedingView& bred = view.features.breeding;
    const bool plays = view.mode == Mode::playing;
    if (has_changed_since_start(memory, view)) return {"button.reset", "hint.changed_since"};
    const bool has_champion = is_edited(*lesson.exercise, submission_of(*lesson.exercise, *view.now));
    if (has_champion && view.now->tick == 0 && !are_equal(memory.failed, tried_now(view)))
        return plays ? Prompt{} : Prompt{"button.play", "hint.press_play"};
    if (bred.runs) return {{}, "hint.breeding_runs"};
    const bool shows_outcome = is_asked(lesson.exercise->prediction) && !lesson.attempt.work.outcome_known;
    if (has_champion ? view.now->tick > 0 && !has_failed(view) : shows_outcome)
        return plays ? Prompt{} : Prompt{"button.play", "hint.press_play"};
    const bool has_hint = lesson.attempt.answers.hints_shown > 0;
    if ((has_hint || has_champion) && has_shipped_opponents(view))
        return {"breeding.against.random", "hint.breed_against"};
    const bool is_complete = bred.base && last_generation(bred) >= bred.base->breeding().generations;
    if (!is_complete) return {"breeding.start", has_shipped_opponents(view) ? "hint.breed_shipped" : "hint.breed"};
    const bool is_tried = memory.failed_base == bred.base && memory.failed_generation == last_generation(bred);
    return has_champion && is_tried ? Prompt{"breeding.matrix", "hint.breed_again"}
                                    : Prompt{"breeding.take", "hint.take_champion"};
}

// True if the dial of this vehicle has the value of the file: it is not tried yet.
bool is_untried(const LabView& view, const VehicleView& vehicle, const SensorPair& pair, Dial dial) {
    const Kind* filed = filed_kind(view, vehicle);
    return !filed ||
           at(read_dials(filed->brain, pair), dial) == at(read_dials(*brain_of(*view.now, vehicle), pair), dial);
}

// A control of which another value makes the next run another one: as offered_change(), but judged by the most that the
// sensors have read in the run. A bias comes first where the vehicle came to rest without a stimulus, since no weight
// moves it from there; then a weight that has still the value of the file, then any bias or weight.
Prompt change_for_next_run(const PromptMemory& memory, const LabView& view) {
    const VehicleView *subject = subject_of(view), *selected = selected_vehicle(view);
    if (!subject || !selected || selected->kind != subject->kind) return {};
    const std::string_view hint = view.now->tick == 0 ? "hint.change_then_play" : "hint.change_then_reset";
    const auto& read = memory.most_read;
    const bool saw = std::any_of(read.begin(), read.end(), [](float value) { return value >= sees_nothing; });
    const auto is_offered_dial = [&](Dial dial) { return is_offered(view, dial); };
    if (!saw && !read.empty() && is_offered(view, offer_parts::sensors)) return {"card.sensors", "hint.turn_sensors"};
    const SensorPair pair = shown_pair(view, *selected);
    const auto is_new = [&](Dial dial) { return is_offered(view, dial) && is_untried(view, *selected, pair, dial); };
    const auto bias_that = [&](auto suits) {
        for (const Dial bias : biases_to_try(*view.lesson->exercise))
            if (suits(bias)) return anchor_of(bias);
        return std::string_view();
    };
    const auto weight_that = [&](auto suits) { return telling_slider(*view.now, *selected, pair, read, suits); };
    const bool needs_bias = memory.halted_blind;
    for (const std::string_view anchor :
         {needs_bias ? bias_that(is_new) : std::string_view(), weight_that(is_new), bias_that(is_new),
          needs_bias ? bias_that(is_offered_dial) : std::string_view(), weight_that(is_offered_dial),
          bias_that(is_offered_dial)})
        if (!anchor.empty()) return {anchor, hint};
    if (saw && is_offered(view, offer_parts::curves)) return {"curve.peak", hint};
    for (const Dial threshold : {Dial::threshold_LL, Dial::threshold_LR, Dial::threshold_RL, Dial::threshold_RR})
        if (saw && is_offered(view, threshold)) return {anchor_of(threshold), hint};
    if (is_offered(view, offer_parts::wiring)) return {"button.wiring", hint};
    if (is_offered(view, offer_parts::selection)) return {"selection.open", "hint.open_children"};
    return {};
}

// True once the student has changed something: in the runs before, or in this one.
bool has_tried(const PromptMemory& memory, const LabView& view) {
    return edit_count(view) > 0 || has_changed_since_start(memory, view);
}

// After a run that failed without a change: a control, and a hint once the student has changed something; a reset would
// only repeat the run. Of children the next generation is what is left to choose.
Prompt next_try(const PromptMemory& memory, const LabView& view) {
    const Attempt::Answers& answers = view.lesson->attempt.answers;
    const bool has_hint =
        answers.hint_ready && answers.hints_shown < static_cast<int>(view.lesson->exercise->hints.size());
    const Prompt change = change_for_next_run(memory, view);
    const bool chooses = change.anchor == "selection.open" && view.lesson->selection &&
                         view.lesson->selection->generation < view.lesson->exercise->selection.generations;
    if (has_hint && !chooses && (has_tried(memory, view) || change.anchor.empty()))
        return {"exercise.hint", "hint.ask"};
    return change;
}

// The same for a run in which the vehicle stands: the words say so where something is in its way.
Prompt next_try_of_standing(const PromptMemory& memory, const LabView& view, std::string_view why) {
    Prompt next = next_try(memory, view);
    if (why == "hint.blocked" && next.hint == "hint.change_then_reset") next.hint = "hint.change_blocked";
    return next;
}

// Notes that the brain and the sensors with which the run began have failed in it.
void remember_failure(PromptMemory& memory, const LabView& view) {
    if (!view.lesson || view.now->tick == 0 || all_steps_done(*view.lesson) || !is_as_at_start(memory, view)) return;
    const bool is_out = !way_out(memory, view).anchor.empty() && !waits_for_a_step(view);
    if (!is_out && !has_failed(view) && !is_subject_gone(view)) return;
    if (are_equal(memory.failed, memory.at_start)) return;
    memory.failed = memory.at_start;
    memory.failed_base = view.features.breeding.base;
    memory.failed_generation = last_generation(view.features.breeding);
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
    memory.slider_known |= memory.followed.slider || view.now->seconds > enough;
    memory.played |= view.now->tick > 0 || view.mode == Mode::playing;
    watch_vehicle(memory, view);
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
        if (const Prompt out = way_out(memory, view); !out.anchor.empty()) return out;
    return of_free_play(memory, view);
}

bool is_subject_gone(const LabView& view) {
    const Snapshot& now = *view.now;
    const int kind = view.lesson ? subject_kind(*now.scene) : -1;
    return now.tick > 0 && kind >= 0 &&
           std::none_of(now.vehicles.begin(), now.vehicles.end(), [&](const VehicleView& v) { return v.kind == kind; });
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
