// The user interface without a window: Dear ImGui with synthetic input over a hand-made snapshot.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"
#include "tests/languages.h"
#include "tests/ui/found.h"
#include "ui/imgui_compat.h"
#include "ui/panels/panels.h"
#include "ui/panels/prompts.h"
#include "ui/widgets/theme.h"
#include "ui/window.h"
#include "ui/window_keys.h"

namespace braitenlab::tests {

// The fonts of the window at one scale. Loaded once per process, because it takes longer than a test.
struct TestFonts {
    ImFontAtlas atlas;
    ui::LoadedFonts loaded;
};
inline TestFonts& test_fonts(float scale) {
    static std::map<float, std::unique_ptr<TestFonts>> known;
    auto& fonts = known[scale];
    if (fonts) return *fonts;
    fonts = std::make_unique<TestFonts>();
    const std::string noto = "/usr/share/fonts/truetype/noto/";
    fonts->loaded = ui::load_fonts(fonts->atlas, scale,
                                   {noto + "NotoSans-Regular.ttf",
                                    noto + "NotoSans-Bold.ttf",
                                    "/usr/share/fonts/truetype/fork-awesome/forkawesome-webfont.ttf",
                                    {noto + "NotoSansMath-Regular.ttf"}});
    return *fonts;
}

inline Kind kind(const char* name, Role role, const FourNeurons& dials) {
    Kind made;
    made.name = name;
    made.role = role;
    made.sensors.resize(2);
    made.sensors[0].name = "SL";
    made.sensors[1].name = "SR";
    made.brain = make_graph(dials);
    return made;
}

// `predators` and twice as many prey; or, with none, one vehicle without a role.
inline Snapshot snapshot(int predators) {
    Snapshot now;
    auto scene = std::make_shared<Scene>();
    scene->title = "A scene";
    scene->story = "What it is about.";
    const FourNeurons aggressor{.LR = 1.5f, .RL = 1.5f, .LM = 0.1f, .RM = 0.1f};
    const FourNeurons coward{.LL = 1.5f, .RR = 1.5f, .LM = 0.1f, .RM = 0.1f};
    if (predators > 0) {
        scene->kinds = {kind("predator", Role::predator, aggressor), kind("prey", Role::prey, coward)};
    } else {
        scene->kinds = {kind("vehicle", Role::none, coward)};
    }
    for (const Kind& each : scene->kinds) now.brains.push_back(std::make_shared<BrainGraph>(each.brain));
    const int count = predators > 0 ? 3 * predators : 1;
    for (int i = 0; i < count; ++i) {
        VehicleView vehicle;
        vehicle.id = i;
        vehicle.kind = predators > 0 && i % 3 != 0 ? 1 : 0;
        vehicle.role = scene->kinds[static_cast<std::size_t>(vehicle.kind)].role;
        vehicle.brain = vehicle.kind;
        vehicle.first_sensed = vehicle.first_neuron = 2 * i;
        vehicle.neuron_count = 2;
        vehicle.motor = {0.3f, 0.5f};
        now.sensed.insert(now.sensed.end(), {0.4f, 0.2f});
        now.neurons.insert(now.neurons.end(), {0.3f, 0.5f});
        now.vehicles.push_back(vehicle);
        now.predators += vehicle.role == Role::predator;
        now.prey += vehicle.role == Role::prey;
    }
    now.inactivity_left = 12;
    now.scene = scene;
    return now;
}

inline Exercise exercise() {
    Exercise made;
    made.id = "05-aggressor";
    made.number = 5;
    made.title = "Aggressor";
    made.goal = "Wire this vehicle so that it turns to the lamp and strikes it, faster and faster.";
    made.why = "It differs from the coward in nothing but two crossed wires.";
    made.prediction = {"What will the vehicle do when you press Play?",
                       {"Turn to the lamp", "Turn away from the lamp and speed off", "Drive straight past the lamp"},
                       1,
                       "It turned away."};
    Step turns{"Turn to the lamp", {}}, touches{"Touch the lamp", {}}, speeds{"Arrive faster", {}};
    turns.check.goal = goals::TurnsTo{};
    touches.check.goal = goals::Touches{};
    speeds.check.goal = goals::SpeedsUp{};
    made.steps = {turns, touches, speeds};
    made.hints = {{"A nudge.", ""}, {"The principle.", ""}, {"Raise LR.", "slider.LR"}};
    return made;
}

inline Snapshot shipped_scene(const char* name) {
    auto scene = load_scene(std::string(BRAITENLAB_SOURCE) + "/exercises/scenes/" + name + ".toml");
    EXPECT_TRUE(scene);
    Snapshot now;
    World::create(*scene, 1)->capture(now);
    return now;
}

class Desk {
public:
    explicit Desk(float width = 1280, float height = 800, float scale = 1, bool fonts = false) : scale_(scale) {
        if (fonts) fonts_ = test_fonts(scale).loaded.fonts;
        ImGui::CreateContext(fonts ? &test_fonts(scale).atlas : nullptr);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {width, height};
        io.DeltaTime = 1.0f / 60;
        unsigned char* pixels = nullptr;
        int w = 0, h = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &w, &h);
        if (fonts) compat::announce_atlas(*io.Fonts);
        ui::apply_theme(Theme::dark, scale);
        view.now = &now;
        view.settings.selection.vehicle = 0;
        view.program.reduce_motion = true;
        view.program.languages = &spoken;
    }
    ~Desk() { ImGui::DestroyContext(); }
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    void open_exercise() {
        now = snapshot(0);
        lesson.exercise = &opened;
        lesson.verdicts.assign(opened.steps.size(), Verdict{false, {{0.83f, 0.6f, "m", true, true}}});
        show_lesson();
    }
    void show_lesson() {
        view.lesson = std::shared_ptr<const LessonView>(std::shared_ptr<void>(), &lesson);
    }  // not owned

    // What may be shown follows from the lesson, the page and what the lecture reveals.
    void follow_disclosure() {
        Known known{.brain_revealed = view.settings.revealed.brain,
                    .character_revealed = view.settings.revealed.character};
        if (view.lesson) {
            known.predicted = has_predicted(lesson.attempt.answers), known.outcome = lesson.attempt.work.outcome_known;
            known.passed = lesson.grade && lesson.grade->good;
            known.has_run = lesson.attempt.work.has_run, known.at_start = lesson.at_start,
            known.as_given = lesson.as_given;
            known.free_play = lesson.attempt.work.free_play, known.together = lesson.together;
        }
        if (view.pages) {
            known.page_asks = !view.pages->current().question.options.empty();
            known.page_answers = view.pages->shows(PagePart::answer);
        }
        view.may = disclosure_of(view.lesson ? lesson.exercise : nullptr, known);
    }

    // Draws so many frames; `asked` then holds what the last one put into the outbox, `all` everything so far.
    void frame(int count = 1) {
        for (; count > 0; --count) {
            view.wall_seconds += 1.0 / 60;
            follow_disclosure();
            asked.clear();
            anchors.begin();
            ui::Ui ui{strings, palette(view.program.theme), fonts_, scale_, anchors, asked, {}, 1};
            written.clear();
            ui.written = &written;
            shown.clear();
            ui.shown = &shown;
            shortened = 0;
            ui.shortened = &shortened;
            ui.pointed_out = &pointed_out;
            ImGui::NewFrame();
            layout = ui::lay_out(ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y, scale_, view,
                                 ui::open_cards(view, panels));
            ui::draw_window(view, panels, ui, layout);
            ImGui::Render();
            all.insert(all.end(), asked.begin(), asked.end());
        }
    }

    // Draws only the hint bar, with this text, while the widget `prompted` pulses.
    void show_hint(std::string_view key, std::string_view prompted = {}) {
        follow_disclosure();
        anchors.begin();
        ui::Ui ui{strings, palette(view.program.theme), fonts_, scale_, anchors, asked, {}, 1};
        ui.highlight = prompted;
        written.clear();
        ui.written = &written;
        ImGui::NewFrame();
        ui::hint_bar(view, ui, layout.hint_bar, key);
        ImGui::Render();
    }

    Rect where(std::string_view anchor) const {
        const Rect* found = anchors.find(anchor);
        if (!found) throw std::runtime_error("no anchor " + std::string(anchor));
        return *found;
    }

    void point(float x, float y) { ImGui::GetIO().MousePos = {x, y}; }
    void point(std::string_view anchor, float share = 0.5f) {
        const Rect r = where(anchor);
        point(r.x + r.w * share, r.y + r.h / 2);
    }
    void button(int which, bool down) { ImGui::GetIO().MouseDown[which] = down; }

    void click(std::string_view anchor, int which = 0, float share = 0.5f) {
        point(anchor, share);
        frame(2);
        button(which, true);
        frame(2);
        button(which, false);
        frame(2);
    }
    // Clicks a row of the menu bar: choose("file", "open").
    void choose(const std::string& menu, const std::string& row) {
        click("menu." + menu);
        click("menu." + menu + "." + row);
    }
    void rest() { frame(30); }  // long enough that two clicks are no double click

    void key(KeyPress press) {
        follow_disclosure();
        ui::press_key(view, panels, press, all);
    }
    void type(const char* text) { ImGui::GetIO().AddInputCharactersUTF8(text); }
    // The number of a slider, typed.
    void type_into(const char* slider, const char* number) {
        click(slider, 0, 0.97f);
        type(number);
        frame(2);
        key({braitenlab::key::enter});
        frame(2);
    }

    // True if the last frame has these words; a line ends with "\n".
    bool says(std::string_view words) const {
        std::string text;
        for (const ui::Written& each : written) text += each.words + "\n";
        return text.find(words) != std::string::npos;
    }

    Found<EditRequest> edits() const {
        Found<EditRequest> found;
        for (const Request& request : all)
            if (const auto* edit = std::get_if<EditRequest>(&request)) found.push_back(*edit);
        return found;
    }
    // The last request of this type, or null.
    template <class Wanted>
    const Wanted* last() const {
        for (auto request = all.rbegin(); request != all.rend(); ++request)
            if (const auto* found = std::get_if<Wanted>(&*request)) return found;
        return nullptr;
    }
    Found<Action> actions() const {
        Found<Action> found;
        for (const Request& request : all)
            if (const auto* action = std::get_if<Action>(&request)) found.push_back(*action);
        return found;
    }

    Strings strings = english();
    std::vector<Language> spoken = shipped_languages();
    Snapshot now = snapshot(4);
    Exercise opened = exercise();
    LessonView lesson;
    LabView view;
    ui::PanelState panels;
    ui::Anchors anchors;
    std::vector<ui::Written> written;  // the texts of the last frame
    std::vector<ui::Shown> shown;      // the widgets of the last frame
    ui::PointedOut pointed_out;        // what was pointed out last
    int shortened = 0;                 // its texts that were cut with an ellipsis
    Outbox asked, all;
    ui::WindowLayout layout;

private:
    float scale_;
    ui::Fonts fonts_;
};

// A grade of starts that passed or not.
inline Grade graded(const std::vector<bool>& passed, bool good) {
    Grade grade{{}, static_cast<int>(std::count(passed.begin(), passed.end(), true)), good};
    for (std::size_t i = 0; i < passed.size(); ++i) grade.starts.push_back({i + 1, passed[i], {}, {}});
    return grade;
}

// The dial that an edit changes.
inline TurnDial turned(const EditRequest& edit) { return std::get<TurnDial>(edit.command); }

}  // namespace braitenlab::tests
