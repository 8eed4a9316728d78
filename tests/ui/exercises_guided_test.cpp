// The window with each exercise of the course: what it points at, and what it offers.
#include <cmath>
#include <optional>

#include "breeding_on_desk.h"
#include "course_on_desk.h"
#include "ui/panels/prompt_run.h"

namespace braitenlab::tests::exercises_guided_test {

using namespace ui;
namespace {

// How far the subject's place differs after this time from a fork in which the commands are applied first, m; after a
// death or a birth 1.
float difference(const World& world, VehicleId subject, const std::vector<Command>& commands, float seconds) {
    World plain = world.fork(), changed = world.fork();
    for (const Command& command : commands) EXPECT_FALSE(changed.apply(command));
    Snapshot a, b;
    float most = 0;
    for (int tick = 0; tick < static_cast<int>(60 * seconds); ++tick) {
        plain.step(), changed.step();
        plain.capture(a), changed.capture(b);
        const VehicleView *left = find_vehicle(a, subject), *right = find_vehicle(b, subject);
        if (!left || !right) return !left && !right ? most : 1.0f;
        most = std::max(most, std::hypot(left->x - right->x, left->y - right->y));
    }
    return most;
}

// A hint may name a part of the diagram, which is closed here: nothing pulses then, and the bar asks to follow the
// hint.
bool is_in_diagram(std::string_view anchor) {
    const auto begins = [&](std::string_view stem) { return anchor.starts_with(stem); };
    return begins("node.") || begins("pin.") || begins("wire.") || begins("canvas");
}

// What a student may do at the widget that the prompt points at: a dial by ±0.5, sensors to the rear.
std::vector<std::vector<Command>> tries_at(const Opened& it, std::string_view anchor) {
    std::vector<std::vector<Command>> tries;
    const VehicleView& subject = *it.subject();
    const Exercise& exercise = it.desk.opened;
    if (anchor == "card.sensors" || anchor == "card.sensors.fold") {
        std::vector<Sensor> sensors = kind_of(it.desk.now, subject).sensors;
        for (Sensor& sensor : sensors) sensor.angle = sensor.y > 0 ? 2.44f : -2.44f;
        tries.push_back({SetSensors{{.kind = subject.kind}, sensors}});
    }
    const auto dials = dials_at(exercise, anchor);
    const SensorPair pair = shown_pair(it.desk.view, subject);
    for (const float change : {0.5f, -0.5f}) {
        std::vector<Command> turned;
        for (const Dial dial : dials)
            turned.push_back(TurnDial{{.kind = subject.kind},
                                      dial,
                                      at(read_dials(*brain_of(it.desk.now, subject), pair), dial) + change,
                                      pair});
        if (!turned.empty()) tries.push_back(std::move(turned));
    }
    return tries;
}

// What the window points at in this state of the run.
Prompt suggestion(const Opened& it, const Snapshot& now) {
    LabView view = it.desk.view;
    view.now = &now;
    PromptMemory memory{.opened = it.desk.opened.id, .played = true};
    return next_prompt(memory, view);
}

// What it points at a tenth of a second later.
Prompt next_suggestion(const Opened& it) {
    World later = it.world.fork();
    for (int tick = 0; tick < 6; ++tick) later.step();
    Snapshot now;
    later.capture(now);
    return suggestion(it, now);
}

}  // namespace

// Each suggestion of a change, at each half second of the run as shipped, is tried in a fork of that moment. A predator
// that drives past an eye is seen for some ticks. A suggestion that ends within a tenth of a second is too short to
// follow.
TEST(ExercisesGuided, ASuggestedChangeChangesWhatTheVehicleDoes) {
    int suggested = 0, gone = 0;
    for (Exercise& exercise : course()) {
        Opened it(std::move(exercise));
        it.play_after_prediction();
        const std::string id = it.desk.opened.id;
        for (int tick = 0; tick <= 60 * 9 && it.subject(); ++tick, it.world.step(), it.show()) {
            if (tick % 30 != 0) continue;
            it.desk.follow_disclosure();
            const Prompt prompt = suggestion(it, it.desk.now);
            const bool is_change = prompt.hint == "hint.turn_slider" || prompt.hint == "hint.turn_sensors";
            if (!is_change) continue;
            const auto tries = tries_at(it, prompt.anchor);
            if (prompt.anchor.starts_with("curve.")) continue;  // see Offered
            EXPECT_FALSE(tries.empty()) << id << ": " << prompt.anchor << " is not offered";
            if (next_suggestion(it).anchor != prompt.anchor) {
                ++gone;
                continue;
            }
            const float left = std::max(2.0f, std::min(8.0f, it.desk.opened.seconds - static_cast<float>(tick) / 60));
            float most = 0;
            for (const auto& commands : tries)
                most = std::max(most, difference(it.world, it.subject()->id, commands, left));
            EXPECT_GT(most, 0.01f) << id << " after " << tick / 60.0 << " s: " << prompt.anchor;
            ++suggested;
        }
    }
    EXPECT_GT(suggested, 20);
    EXPECT_LE(gone, suggested / 5) << "most suggestions last";
}

namespace {

// The exercise after its first run as shipped, with what the prompts remember of it.
struct Guided {
    explicit Guided(const Exercise& exercise) : it(exercise), start(it.world.fork()) {
        it.desk.lesson.attempt.answers.prediction = exercise.prediction.answer;
        it.desk.lesson.attempt.answers.hint_ready = false;  // so that controls are what is left
        pointed();
        it.play_after_prediction();
        it.desk.lesson.attempt.work.outcome_known = true;
    }
    Prompt pointed() {
        it.desk.follow_disclosure();
        return next_prompt(memory, it.desk.view);
    }
    void tick() { it.world.step(), it.show(); }
    void reset() {
        it.world = start.fork();
        it.desk.view.timeline.latest = 0;
        it.desk.view.mode = Mode::paused;
        it.show();
        it.desk.view.settings.selection.vehicle = it.desk.now.vehicles.front().id;
    }
    // The most that a change at this widget makes of a run from the start.
    float most_difference(std::string_view anchor, std::vector<Command>* best = nullptr) const {
        float most = 0;
        for (const auto& commands : tries_at(it, anchor)) {
            const float differs = difference(start, it.desk.now.vehicles.front().id, commands, it.desk.opened.seconds);
            if (differs > most && best) *best = commands;
            most = std::max(most, differs);
        }
        return most;
    }

    Opened it;
    World start;
    PromptMemory memory{.opened = it.desk.opened.id};
};

}  // namespace

// A run without a change is the same after a reset. So while it fails, and at the start after it, neither Reset
// nor Play is what is next, but a control that makes the next run another one. Reset brings back a vehicle that is
// gone.
TEST(ExercisesGuided, AfterARunThatFailedUnchangedTheNextStepIsAChange) {
    int changed = 0;
    for (const Exercise& exercise : course()) {
        SCOPED_TRACE(exercise.id);
        Guided guided(exercise);
        Opened& it = guided.it;
        for (int tick = 0; tick <= static_cast<int>(60 * (exercise.seconds + 1)); ++tick, guided.tick()) {
            const Prompt prompt = guided.pointed();
            if (tick % 30 != 0) continue;
            EXPECT_TRUE(prompt.anchor != "button.reset" || !it.subject()) << tick / 60.0 << " s: " << prompt.hint;
            const bool is_change = prompt.hint == "hint.change_then_reset" && tick % 120 == 0;
            if (!is_change || tries_at(it, prompt.anchor).empty()) continue;
            EXPECT_GT(guided.most_difference(prompt.anchor), 0.01f) << tick / 60.0 << " s: " << prompt.anchor;
        }
        guided.reset();
        const Prompt next = guided.pointed();
        EXPECT_NE(next.anchor, "button.play");
        EXPECT_NE(next.anchor, "");
        std::vector<Command> best;
        if (tries_at(it, next.anchor).empty()) continue;  // of the diagram, the curves, a sheet
        EXPECT_GT(guided.most_difference(next.anchor, &best), 0.01f) << next.anchor;
        for (const Command& command : best) EXPECT_FALSE(it.world.apply(command));
        it.desk.view.undo_depth = 1;
        it.show();
        EXPECT_EQ(guided.pointed().anchor, "button.play") << "the change makes another run";
        ++changed;
    }
    EXPECT_GT(changed, 12);
}

namespace {

// The keys of sliders that the hint bar names, as caps.
std::vector<std::string> slider_keys_in_bar(const Desk& desk) {
    const Rect bar = desk.where("hint.bar");
    std::vector<std::string> keys;
    for (const Written& w : desk.written)
        if (w.words.size() == 1 && w.words[0] >= '1' && w.words[0] <= '6' && bar.contains(w.rect.x, w.rect.y))
            keys.push_back(w.words);
    return keys;
}

}  // namespace

// While a slider pulses, the bar names its key and that of no other slider, at each second second of the run as shipped
// and after it.
TEST(ExercisesGuided, TheKeyInTheBarIsThatOfTheSliderThatPulses) {
    int named = 0;
    for (const Exercise& exercise : course()) {
        Opened it(exercise);
        const auto check = [&](const std::string& when) {
            it.desk.follow_disclosure();
            it.desk.frame(2);
            const std::string pulsing = it.desk.panels.prompts.highlight.anchor;
            if (!is_slider(pulsing)) return;
            const std::string wanted = std::to_string(number_of_slider(it.desk.view, pulsing) + 1);
            for (const std::string& key : slider_keys_in_bar(it.desk)) {
                EXPECT_EQ(key, wanted) << exercise.id << ", " << when << ": " << pulsing;
                ++named;
            }
        };
        check("before the prediction");
        it.desk.lesson.attempt.answers.prediction = exercise.prediction.answer;
        it.desk.lesson.attempt.answers.hint_ready = false;  // so that controls are what is left
        check("predicted");
        it.play_after_prediction();
        for (int tick = 0; tick <= static_cast<int>(60 * (exercise.seconds + 1)) && it.subject(); ++tick) {
            if (tick % 120 == 0) check(std::to_string(tick / 60) + " s");
            it.world.step(), it.show();
        }
        it.desk.lesson.attempt.work.outcome_known = true;
        it.desk.view.mode = Mode::paused;
        check("after the run");
        it.world = std::move(*World::create(exercise.scene, exercise.seed));
        it.desk.view.timeline.latest = 0;
        it.show();
        it.desk.view.settings.selection.vehicle = it.desk.now.vehicles.front().id;
        check("at the next start");
    }
    EXPECT_GT(named, 20);
}

namespace {

// How much a value lacks of what is needed.
float lacking(const Measure& measure) {
    if (!std::isfinite(measure.value)) return 1e3f;
    const bool has_most = measure.at_most || measure.needed_most;
    const float above = has_most ? measure.value - measure.needed_most.value_or(measure.needed) : 0;
    const float below = measure.at_most ? 0 : measure.needed - measure.value;
    return std::max({0.0f, above, below});
}

// The share of what a value of an open step lacked that another run gained, the most of all; 1 if a step is done now.
float gained_by(const StartResult& run, const StartResult& before) {
    float most = 0;
    for (std::size_t i = 0; i < std::min(run.verdicts.size(), before.verdicts.size()); ++i) {
        if (before.verdicts[i].done) continue;
        if (run.verdicts[i].done) return 1;
        const auto& now = run.verdicts[i].measures;
        const auto& then = before.verdicts[i].measures;
        for (std::size_t m = 0; m < std::min(now.size(), then.size()); ++m)
            if (const float lacked = lacking(then[m]); lacked > 0)
                most = std::max(most, (lacked - lacking(now[m])) / lacked);
    }
    return most;
}

// The most that any value of the dials at this widget gains over the run as it is; nullopt without dials there.
std::optional<float> most_gained(const Guided& guided, std::string_view anchor) {
    const Opened& it = guided.it;
    const Exercise& exercise = it.desk.opened;
    const auto dials = dials_at(exercise, anchor);
    if (dials.empty()) return std::nullopt;
    const VehicleView& subject = *it.subject();
    const SensorPair pair = shown_pair(it.desk.view, subject);
    const StartResult present = try_start(exercise, submission_of(exercise, it.desk.now), exercise.seed);
    float most = -1;
    for (float value = -2; value <= 2.01f; value += 0.1f) {
        World changed = it.world.fork();
        for (const Dial dial : dials) EXPECT_FALSE(changed.apply(TurnDial{{.kind = subject.kind}, dial, value, pair}));
        Snapshot now;
        changed.capture(now);
        most = std::max(most, gained_by(try_start(exercise, submission_of(exercise, now), exercise.seed), present));
    }
    return most;
}

}  // namespace

// A change of the way alone is not enough: some value of what pulses brings the vehicle nearer to the goal.
TEST(ExercisesGuided, WhatPulsesAfterAFailedRunCanBringItNearerToTheGoal) {
    int tried = 0;
    for (const Exercise& exercise : course()) {
        Guided guided(exercise);
        for (int tick = 0; tick <= static_cast<int>(60 * (exercise.seconds + 1)); ++tick, guided.tick())
            guided.pointed();
        guided.reset();
        const Prompt next = guided.pointed();
        if (const auto gained = most_gained(guided, next.anchor)) {
            EXPECT_GT(*gained, 0.02f) << exercise.id << ": " << next.anchor;
            ++tried;
        }
    }
    EXPECT_GT(tried, 8);
}

// Of the sliders offered, the one that pulses is that with which one change brings most.
TEST(ExercisesGuided, WhatPulsesAfterAFailedRunGainsMostOfWhatIsOffered) {
    int compared = 0;
    for (const Exercise& exercise : course()) {
        const std::vector<float>& gains = gains_of_shipped(exercise);
        if (exercise.id == "22-breeding") continue;  // its steps lead to the breeding
        if (gains.size() < 2 || *std::max_element(gains.begin(), gains.end()) < 0.02f) continue;
        Guided guided(exercise);
        for (int tick = 0; tick <= static_cast<int>(60 * (exercise.seconds + 1)); ++tick, guided.tick())
            guided.pointed();
        guided.reset();
        const std::string_view pointed = guided.pointed().anchor;
        const auto offers = offered_dials(exercise);
        for (std::size_t i = 0; i < gains.size(); ++i)
            if (dials_at(exercise, pointed) == offers[i].dials) {
                EXPECT_EQ(gains[i], *std::max_element(gains.begin(), gains.end())) << exercise.id << ": " << pointed;
            }
        EXPECT_FALSE(dials_at(exercise, pointed).empty()) << exercise.id << ": " << pointed;
        const bool lacks_left = exercise.id == "04-coward" || exercise.id == "06-love";
        EXPECT_TRUE(!lacks_left || pointed == "slider.LL") << exercise.id << ": " << pointed;
        ++compared;
    }
    EXPECT_GT(compared, 6);
}

// From the first seconds of the run as shipped to its end, for a newcomer who changes nothing. A vehicle that something
// holds first shows that it stands. Where prey are bred, the run as shipped shows those before, and breeding follows
// it.
TEST(ExercisesGuided, SomethingPulsesWhileARunPlaysWithoutAChange) {
    int seen = 0;
    for (const Exercise& exercise : course()) {
        if (offered_dials(exercise).empty() || !offered_breeding(exercise).empty()) continue;
        Guided guided(exercise);
        for (int tick = 0; tick <= static_cast<int>(60 * exercise.seconds); ++tick, guided.tick()) {
            const Prompt prompt = guided.pointed();
            if (tick % 30 != 0 || tick < 60 * 4 || !guided.it.subject()) continue;
            const bool stands = std::fabs(guided.it.subject()->speed) < 0.03f;
            if (waits_for_a_step(guided.it.desk.view)) continue;
            EXPECT_TRUE(stands || !prompt.anchor.empty()) << exercise.id << " after " << tick / 60.0 << " s";
            ++seen;
        }
    }
    EXPECT_GT(seen, 200);
}

TEST(ExercisesGuided, AVehicleThatStallsInTheDarkNeedsABiasWhateverItsWeightsAre) {
    for (const float weight : {0.4f, 2.0f}) {
        Guided guided(exercise_of("03-alive"));
        for (const Dial dial : {Dial::LL, Dial::LR, Dial::RL, Dial::RR})
            EXPECT_FALSE(guided.it.world.apply(TurnDial{{.kind = guided.it.subject()->kind}, dial, weight, {}}));
        guided.start = guided.it.world.fork();
        guided.reset();
        guided.pointed();
        guided.it.play_after_prediction();
        guided.it.desk.lesson.gains = std::vector<float>{};  // those of the brain as shipped
        for (int tick = 0; tick <= static_cast<int>(60 * (guided.it.desk.opened.seconds + 1)); ++tick, guided.tick())
            guided.pointed();
        EXPECT_EQ(guided.pointed().anchor, "bias.LM") << weight;
    }
}

// The words of a hint fit what can be done while it is read, whether the run plays or not.
TEST(ExercisesGuided, NoHintBeginsWithPlay) {
    for (const Exercise& exercise : course())
        for (const Hint& hint : exercise.hints) EXPECT_FALSE(hint.text.starts_with("Press Play")) << exercise.id;
}

TEST(ExercisesGuided, APromptPointsAtAWidgetInTheWindow) {
    struct Window {
        float width, height, scale;
    };
    for (const Exercise& exercise : course())
        for (const Window w : {Window{1280, 800, 1}, {800, 600, 1}}) {
            Opened it(exercise, w.width, w.height, w.scale);
            const auto check = [&](const char* when) {
                it.desk.frame(6);
                const std::string pointed = it.desk.panels.prompts.highlight.anchor;
                if (pointed.empty() || is_in_diagram(pointed)) return;
                const Rect* at = it.desk.anchors.find(pointed);
                ASSERT_TRUE(at) << exercise.id << ", " << when << ", " << w.width << ": " << pointed;
                EXPECT_TRUE(at->x < w.width && at->y < w.height && at->x + at->w > 0 && at->y + at->h > 0)
                    << exercise.id << ", " << when << ": " << pointed;
            };
            check("before the prediction");
            it.desk.lesson.attempt.answers.prediction = 0;
            check("predicted");
            it.play_after_prediction();
            for (int tick = 0; tick < 60 * 4; ++tick) it.world.step();
            it.show();
            if (it.subject()) check("running");
            const auto& hints = it.desk.opened.hints;
            for (std::size_t i = 0; i < hints.size(); ++i) {
                it.desk.lesson.attempt.answers.hints_shown = static_cast<int>(i + 1);
                check("hint");
            }
            it.desk.panels.card(Card::brain).folded = it.desk.panels.card(Card::exercise).folded = true;
            check("folded");
        }
}

TEST(ExercisesGuided, OffersWhatTheFileOffersWhateverWasOpenBefore) {
    int with_sensors = 0;
    for (const Exercise& exercise : course()) {
        Opened it(exercise);
        it.desk.panels.card(Card::sensors).folded = false;  // in an earlier exercise
        it.desk.lesson.attempt.answers.prediction = 0;
        it.look_at_scene();
        it.desk.frame(4);
        const bool offers_sensors = offers(exercise, offer_parts::sensors);
        with_sensors += offers_sensors;
        EXPECT_EQ(it.desk.anchors.find("card.sensors") != nullptr, offers_sensors) << exercise.id;
        for (const char* id : {"handle.mount", "handle.axis", "handle.left"}) {
            if (offers_sensors) continue;
            EXPECT_FALSE(it.desk.anchors.find(id)) << exercise.id << ": " << id;
        }
        for (const Dial dial : all_dials)
            EXPECT_EQ(it.desk.anchors.find(anchor_of(dial)) != nullptr, !dials_at(exercise, anchor_of(dial)).empty())
                << exercise.id << ": " << anchor_of(dial);
        for (const char* id : {"button.mirror", "button.cross", "button.presets", "button.drive"})
            EXPECT_FALSE(it.desk.anchors.find(id)) << exercise.id << ": " << id;
    }
    EXPECT_GT(with_sensors, 1);
}

TEST(ExercisesGuided, WhatThePredictionAsksForIsNotReadBeforePlay) {
    for (const Exercise& exercise : course()) {
        if (!is_asked(exercise.prediction)) continue;
        Opened it(exercise, 1280, 1200);
        it.desk.lesson.attempt.answers.prediction = 0;
        it.desk.frame(4);
        for (const char* words : {"Left wheel faster", "Right wheel faster", "Both wheels"})
            EXPECT_FALSE(it.desk.says(words)) << exercise.id << ": the answer can still be changed";
        EXPECT_FALSE(it.desk.view.may.outcome) << exercise.id;
        it.play_after_prediction();
        it.desk.frame(4);
        EXPECT_TRUE(it.desk.view.may.outcome) << exercise.id;
    }
}

TEST(ExercisesGuided, TheCardOfABredExerciseOpensItsBreedingAndTheSheetPulsesWhatIsNext) {
    for (const float width : {1280.0f, 800.0f}) {
        Opened it(exercise_of("22-breeding"), width, width == 800 ? 600.0f : 800.0f);
        it.play_after_prediction();
        for (int tick = 0; tick < 60 * 16; ++tick) it.world.step();
        it.show();
        it.desk.frame(6);
        EXPECT_EQ(it.desk.panels.prompts.highlight.anchor, "exercise.breeding");
        it.desk.all.clear();
        it.desk.click("exercise.breeding");
        ASSERT_TRUE(it.desk.last<BreedingRequest>());
        const auto first = std::find_if(it.desk.all.begin(), it.desk.all.end(), [](const Request& request) {
            return std::holds_alternative<BreedingRequest>(request);
        });
        EXPECT_EQ(std::get<BreedingRequest>(*first).edit, BreedingEdit::open);
        EXPECT_EQ(std::get<BreedingRequest>(*first).path, "chase-ten");
        EXPECT_EQ(it.desk.panels.sheet, Sheet::breeding);
        BredOnDesk bred(0);
        bred.show(it.desk);
        it.desk.frame(6);
        EXPECT_EQ(it.desk.panels.prompts.highlight.anchor, "breeding.start");
        it.desk.view.features.breeding.runs = true, it.desk.view.features.breeding.seconds_left = 42;
        it.desk.panels.sheet = Sheet::none;
        it.desk.frame(6);
        EXPECT_EQ(it.desk.panels.prompts.highlight.anchor, "");
        EXPECT_TRUE(it.desk.says("0%, about 45")) << "on the card";
        EXPECT_TRUE(it.desk.says("The breeding runs: 0%, about 45 s left.")) << "in the bar";
        BredOnDesk complete(bred.base->breeding().generations + 1);
        complete.show(it.desk);
        it.desk.view.features.breeding.runs = false;
        it.desk.frame(6);
        EXPECT_TRUE(it.desk.panels.prompts.highlight.anchor.starts_with("breeding.cell."));
        EXPECT_TRUE(it.desk.anchors.find(it.desk.panels.prompts.highlight.anchor));
        const auto matches = telling_matches(it.desk.view.features.breeding);
        ASSERT_TRUE(matches);
        complete.watch(it.desk, matches->last, matches->ancestor);
        it.desk.frame(6);
        EXPECT_EQ(it.desk.panels.prompts.highlight.anchor, "breeding.take");
    }
}

TEST(ExercisesGuided, NoHintPulsesInARunThatHasDoneAStepBeforeItsEnd) {
    int seen = 0;
    for (const Exercise& exercise : course()) {
        if (exercise.steps.size() < 2 || !offered_breeding(exercise).empty()) continue;
        Opened it(exercise);
        it.play_after_prediction();
        it.desk.view.undo_depth = 1;
        it.desk.lesson.attempt.answers.hint_ready = true;
        it.desk.now.tick = it.desk.view.timeline.latest = 100;
        it.desk.now.seconds = 0.8 * static_cast<double>(exercise.seconds);
        it.desk.lesson.verdicts.front().done = true;
        PromptMemory memory;
        EXPECT_NE(next_prompt(memory, it.desk.view).anchor, "exercise.hint") << exercise.id;
        it.desk.lesson.verdicts.front().done = false;
        seen += next_prompt(memory, it.desk.view).anchor == "exercise.hint";
    }
    EXPECT_GT(seen, 10);
}

TEST(ExercisesGuided, NothingAsksToOpenTheChildrenWhileTheyAreOpen) {
    Opened it(exercise_of("20-selection"));
    it.play_after_prediction();
    it.desk.lesson.attempt.answers.hints_shown = 1;
    it.desk.frame(4);
    ASSERT_EQ(it.desk.panels.prompts.highlight.anchor, "selection.open");
    it.desk.panels.sheet = Sheet::children;
    it.desk.frame(4);
    EXPECT_EQ(it.desk.panels.prompts.highlight.anchor, "");
    EXPECT_EQ(it.desk.panels.prompts.highlight.hint, "");
}

}  // namespace braitenlab::tests::exercises_guided_test
