// The canvas with a mouse: Dear ImGui without a window, pointer and keys put in by hand.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>

#include "ui/strings.h"
#include "ui/wiring/canvas.h"
#include "ui/wiring/interaction.h"

namespace braitenlab::tests {

using maths::vec2;

inline constexpr NodeId SL = 0, SR = 1, ML = 2, MR = 3;

// A lab with one vehicle that carries out edits of its brain as the app would, and the hand on the mouse.
struct WiringCanvas : testing::Test {
    WiringCanvas() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1000, 700};
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // as OpenGL 3.3 has
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);

        scene.kinds.resize(1);
        now.scene = std::make_shared<Scene>(scene);
        now.sensed = {0.4f, 0.2f};
        now.neurons = {0.3f, 0.6f};
        VehicleView vehicle;
        vehicle.id = 7;
        vehicle.neuron_count = 2;
        now.vehicles = {vehicle};
        now.brains = {std::make_shared<BrainGraph>(make_graph({.LR = 1.5f, .RL = 1.5f}))};
        view.now = &now;
        view.mode = Mode::wiring;
        view.selected = 7;
        frames(3);
    }
    ~WiringCanvas() override { ImGui::DestroyContext(); }

    void frames(int count = 1) {
        for (int i = 0; i < count; ++i) {
            ImGuiIO& io = ImGui::GetIO();
            io.DeltaTime = 1.0f / 60;
            view.wall_seconds += io.DeltaTime;
            ImGui::NewFrame();
            anchors.begin();
            outbox.clear();
            Ui ui{strings, palette(Theme::dark), {}, 1, anchors, outbox, {}};
            wiring_canvas(view, state, ui, area);
            ImGui::Render();
            io.MouseWheel = 0;
            const std::size_t before = edits.size();
            for (const Request& request : outbox) carry_out(std::get<EditRequest>(request));
            view.undo_depth += edits.size() > before;
        }
    }
    void carry_out(const EditRequest& request) {
        edits.push_back(request);
        auto edited = std::make_shared<BrainGraph>(*now.brains[0]);
        if (const auto* dial = std::get_if<TurnDial>(&request.command)) turn(*edited, dial->dial, dial->value);
        if (const auto* brain = std::get_if<SetBrain>(&request.command)) *edited = brain->brain;
        if (const auto* placed = std::get_if<PlaceNodes>(&request.command))
            for (const NodePlace& place : placed->places)
                for (Node& node : edited->nodes)
                    if (node.id == place.node) node.place = place.at;
        now.brains[0] = edited;
        now.neurons.resize(edited->nodes.size());
    }

    vec2 middle(const std::string& anchor) const {
        const Rect* r = anchors.find(anchor);
        EXPECT_NE(r, nullptr) << anchor;
        return r ? vec2{r->x + r->w / 2, r->y + r->h / 2} : vec2{};
    }
    void move(vec2 to) {
        ImGui::GetIO().MousePos = {to.x, to.y};
        frames();
    }
    void button(bool down, int which = 0) {
        ImGui::GetIO().MouseDown[which] = down;
        frames();
    }
    void drag(vec2 from, vec2 to) {
        move(from);
        button(true);
        move(from + (to - from) * 0.5f);
        move(to);
        button(false);
        frames();
    }
    void click(vec2 at) {
        move(at);
        button(true);
        button(false);
    }
    void key(Action action) {
        press_key(state, action);
        frames(2);
    }
    void right_click(vec2 at) {
        move(at);
        button(true, 1);
        button(false, 1);
        frames();
    }
    void choose(const char* row) {
        ASSERT_NE(anchors.find(std::string("menu.") + row), nullptr) << row;
        click(middle(std::string("menu.") + row));
        frames();
    }
    void wheel(float notches) {
        ImGui::GetIO().MouseWheel = notches;
        frames();
    }
    const BrainGraph& brain() const { return *now.brains[0]; }
    FourNeurons dials() const { return read_dials(brain()); }

    Rect area{20, 30, 900, 640};
    Strings strings;
    Anchors anchors;
    Outbox outbox;
    Scene scene;
    Snapshot now;
    LabView view;
    CanvasState state;
    std::vector<EditRequest> edits;
};

}  // namespace braitenlab::tests
