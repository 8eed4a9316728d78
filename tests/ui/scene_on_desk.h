// Fixture: mouse and keys over a scene without a window, by synthetic Dear ImGui events over a hand-made snapshot.
#pragma once

#include <gtest/gtest.h>

#include "desk.h"
#include "ui/scene_input/scene_input.h"

namespace braitenlab::tests {

inline constexpr float a_pixel = 0.055f;  // m, into the picture: Dear ImGui rounds the mouse to whole pixels

// A desk with a scene for the mouse: four predators in the middle, a lamp and a box to the north.
struct SceneOnDesk : testing::Test {
    SceneOnDesk() {
        auto scene = std::make_shared<Scene>(*desk.now.scene);
        scene->sources.push_back({.name = "lamp", .x = -3, .y = 6});
        scene->obstacles.push_back({.name = "box", .x = 3, .y = 6, .length = 2, .width = 1});
        scene->zones.push_back({.name = "pond", .x = 6, .y = -7, .length = 3, .width = 2, .surface = Surface::ice});
        desk.now.scene = scene;
        desk.now.sources.push_back({0, Channel::light, -3, 6, 1});
        desk.now.obstacles.push_back({3, 6, 0});
        for (const Kind& kind : scene->kinds) desk.now.kind_brains.push_back(std::make_shared<BrainGraph>(kind.brain));
        for (std::size_t i = 0; i < desk.now.vehicles.size(); ++i) {
            desk.now.vehicles[i].x = -6 + 1.5f * static_cast<float>(i % 8);
            desk.now.vehicles[i].y = i < 8 ? 0.0f : -4.0f;
        }
        desk.view.camera_view = &camera_view;
        desk.frame(2);  // cards are measured in the first frames
        camera_view = look(Camera{}, scene->arena, nullptr, {0, 0, 1280, 800}, desk.layout.scene);
        rest_pointer();
    }

    maths::vec2 pixel(maths::vec2 place) const { return *project(camera_view, place); }
    void point(maths::vec2 place) {
        desk.point(pixel(place).x, pixel(place).y);
        desk.frame();
    }
    void rest_pointer() { point({0, 3}); }
    void press(int button = 0) { desk.button(button, true), desk.frame(); }
    void release(int button = 0) { desk.button(button, false), desk.frame(); }
    void click(maths::vec2 place, int button = 0) {
        point(place), press(button), release(button);
        desk.rest();
    }
    // Presses at one place and moves to another in steps.
    void hold(maths::vec2 from, maths::vec2 to) {
        point(from), press();
        for (int i = 1; i <= 4; ++i) point(from + (to - from) * (static_cast<float>(i) / 4));
    }

    template <class C>
    Found<C> commands() const {
        Found<C> found;
        for (const EditRequest& edit : desk.edits())
            if (const auto* command = std::get_if<C>(&edit.command)) found.push_back(*command);
        return found;
    }
    template <class R>
    Found<R> requests() const {
        Found<R> found;
        for (const Request& request : desk.all)
            if (const auto* one = std::get_if<R>(&request)) found.push_back(*one);
        return found;
    }
    ui::SceneInputState& scene_input() { return desk.panels.scene_input; }
    // Applies the requests, as the lab does.
    void take(SceneObject object) { desk.view.settings.selection.object = object, desk.frame(); }

    Desk desk;
    CameraView camera_view = look(Camera{}, Arena{}, nullptr, {0, 0, 1280, 800}, {336, 64, 576, 680});
    const SceneObject lamp{SceneObjectKind::source, 0}, box{SceneObjectKind::obstacle, 0},
        pond{SceneObjectKind::zone, 0};
};

}  // namespace braitenlab::tests
