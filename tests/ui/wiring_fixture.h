// The wiring canvas in Dear ImGui without a window, with pointer and keys set by the test.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>

#include "core/brain/four_neurons.h"
#include "tests/ui/found.h"
#include "tests/ui/large_brain.h"
#include "ui/wiring/input.h"
#include "ui/words/strings.h"

namespace braitenlab::wiring {

using maths::vec2;

using namespace four_neuron_ids;

// A lab with one vehicle: edits of its brain are executed as the app does.
struct CanvasFixture : testing::Test {
    CanvasFixture() {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {1000, 700};
        // With indices of 16 bits a long list needs it. The window's OpenGL has it (OpenedWindow); the page's has not,
        // but indices of 32 bits.
        if (sizeof(ImDrawIdx) == 2) io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
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
        view.settings.selection.vehicle = 7;
        frames(3);
    }
    ~CanvasFixture() override { ImGui::DestroyContext(); }

    void frames(int count = 1) {
        for (int i = 0; i < count; ++i) {
            ImGuiIO& io = ImGui::GetIO();
            io.DeltaTime = 1.0f / 60;
            view.wall_seconds += io.DeltaTime;
            ImGui::NewFrame();
            anchors.begin();
            outbox.clear();
            ui::Ui ui{strings, palette(Theme::dark), {}, 1, anchors, outbox, {}};
            draw_canvas(view, state, ui, area);
            ImGui::Render();
            io.MouseWheel = 0;
            const std::size_t before = edits.size();
            for (const Request& request : outbox) execute_edit(std::get<EditRequest>(request));
            view.undo_depth += edits.size() > before;
        }
    }
    void execute_edit(const EditRequest& request) {
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
    // Shows another brain; the vehicle keeps its id.
    void show(const BrainGraph& graph) {
        const VehicleId id = view.settings.selection.vehicle;
        now = tests::snapshot_with(graph);
        now.vehicles[0].id = id;
        frames(3);
    }
    // A neuron N1 (id 4) without wires.
    void add_neuron_at(vec2 pixel) {
        right_click(pixel);
        choose("linear");
        ASSERT_EQ(edits.size(), 1u);
    }
    vec2 on_wire(WireEnds ends, float t) {
        const WireShape* wire = find_shape(state.layout.get(now.brains[0], state.held), ends);
        return view_of(state.camera, area, 1).to_window(bezier_point(wire->bezier, t));
    }
    const Wire* wire(NodeId from, NodeId to) const { return find_wire(brain(), from, to); }
    const BrainGraph& brain() const { return *now.brains[0]; }
    FourNeurons dials() const { return read_dials(brain()); }

    Rect area{20, 30, 900, 640};
    Strings strings;
    ui::Anchors anchors;
    Outbox outbox;
    Scene scene;
    Snapshot now;
    LabView view;
    CanvasState state;
    tests::Found<EditRequest> edits;
};

}  // namespace braitenlab::wiring
