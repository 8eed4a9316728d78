// The picture of a brain with lesions: a lid over an eye, a cross over a wheel or a neuron, a gap in a wire.
#include <algorithm>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "render/gl/renderer.h"
#include "render/view/draw_list.h"
#include "tests/render/rendered.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::lesion_test {
namespace {

using namespace render;

class LesionTest : public Rendered {
protected:
    void SetUp() override {
        Rendered::SetUp();
        if (HasFatalFailure()) return;
        Camera near;
        near.mode = CameraMode::birds_eye, near.zoom = 10;  // 200 pixels per vehicle
        look_from(near);
        picture.settings.overlays.labels = false;
        hand_made::add(now, 0, 0, 0, 0);
        hand_made::add_others(now);  // plain meshes
    }

    // Changes the brain of the vehicle.
    template <class Change>
    void hurt(Change change) {
        BrainGraph brain = *now.brains[0];
        change(brain);
        now.brains[0] = std::make_shared<BrainGraph>(brain);
    }
    void silence(const char* name) {
        hurt([&](BrainGraph& brain) { find_node(brain, std::string(name))->silenced = true; });
    }

    // The darkest and the brightest pixel of a square around a point of the vehicle.
    std::pair<float, float> extremes(maths::vec2 own, float up, float half) {
        renderer->draw(now, picture);
        const maths::vec2 middle = *project(picture.camera_view, own, up);
        float darkest = 1, brightest = 0;
        for (float y = -half; y <= half; ++y)
            for (float x = -half; x <= half; ++x) {
                const float b = brightness(stage.pixel({middle.x + x, middle.y + y}));
                darkest = std::min(darkest, b), brightest = std::max(brightest, b);
            }
        return {darkest, brightest};
    }

    Snapshot now = hand_made::empty(hand_made::scene());
};

TEST_F(LesionTest, DrawsADarkCapWithACrossOnASilencedSensor) {
    // In the middle of the lens, which points 45 degrees upwards and 35 degrees outwards.
    constexpr maths::vec2 left{0.3575f, 0.280f}, right{0.3575f, -0.280f};
    constexpr float up = 0.37f;
    EXPECT_LT(extremes(left, up, 1).second, 0.35f) << "the lens is dark at the reading 0";
    now.sensed = {0.9f, 0.9f};
    EXPECT_GT(extremes(left, up, 1).first, 0.6f) << "the lens is bright at a high reading";
    silence("SL");
    EXPECT_GT(extremes(left, up, 1).second, 0.8f) << "the arms of the cross meet in the middle of the lid";
    EXPECT_LT(extremes(left, up, 9).first, 0.12f) << "on dark ground";
    const Colour other = stage.pixel(*project(picture.camera_view, right, up)), lamp = palette(picture.theme).lamp;
    EXPECT_LT(other.b, other.r) << "the other eye still senses light";
    EXPECT_NEAR(other.r, lamp.r, 0.2f);
}

TEST_F(LesionTest, DrawsNoFieldOfASilencedSensor) {
    now.sensed = {0.9f, 0.9f};
    const auto before_left = [&] { return extremes({1.4f, 1.0f}, 0, 2).second; };
    const float open = before_left();
    silence("SL");
    const float covered = before_left();
    picture.settings.sensors = false;
    EXPECT_GT(open, before_left() + 0.05f);
    EXPECT_NEAR(covered, before_left(), 0.01f);
}

TEST_F(LesionTest, CrossesOutAWheelWithASilencedMotor) {
    const Wheel& wheel = now.scene->kinds[0].body.wheels[0];
    const maths::vec2 at{wheel.x, wheel.y + (wheel.y < 0 ? -0.04f : 0.04f)};
    EXPECT_LT(extremes(at, 0.3f, 1).second, 0.6f);
    silence(wheel.motor == Motor::left ? "ML" : "MR");
    EXPECT_GT(extremes(at, 0.3f, 1).first, 0.8f) << "the arms of the cross meet in the middle";
    const auto [between, arms] = extremes(at, 0.3f, 14);
    EXPECT_LT(between, 0.12f);
    EXPECT_GT(arms, 0.8f);
}

TEST_F(LesionTest, DrawsAGapInACutWire) {
    hurt([](BrainGraph& brain) {
        brain.wires.resize(1);
        brain.wires[0].weight = 2;  // straight, left eye to left wheel
    });
    const Colour excites = palette(picture.theme).excites;
    const auto painted = [&] {
        renderer->draw(now, picture);
        int count = 0;  // pixels in the wire's colour
        for (int y = 0; y < window_height; ++y)
            for (int x = window_width / 2 - 120; x < window_width / 2 + 120; ++x) {
                const Colour c = stage.pixel({static_cast<float>(x), static_cast<float>(y)});
                count += c.r > 0.7f * excites.r && c.r > 2.5f * c.b && c.g > 0.5f * excites.g;
            }
        return count;
    };
    const int whole = painted();
    hurt([](BrainGraph& brain) { brain.wires[0].cut = true; });
    renderer->draw(now, picture);
    EXPECT_GT(whole, 100);
    EXPECT_LT(painted(), whole / 4) << "a cut wire also has a duller colour";
    DrawList list;
    render::fill(list, now, picture, Trails{});
    ASSERT_EQ(list.wires.size(), 1U);
    // The deck is visible in the gap; t = 0.42 of a bent line.
    const maths::vec4 ends = list.wires[0].ends, shape = list.wires[0].shape;
    const float t = 0.42f, u = 1 - t;
    const maths::vec2 amid = maths::vec2{ends.x, ends.y} * (u * u) + maths::vec2{shape.x, shape.y} * (2 * t * u) +
                             maths::vec2{ends.z, ends.w} * (t * t);
    const Colour gap = stage.pixel(*project(picture.camera_view, amid, shape.z));
    EXPECT_LT(gap.r, 1.2f * gap.b) << "no orange in the gap";
}

TEST_F(LesionTest, CrossesOutASilencedNeuron) {
    hurt([](BrainGraph& brain) {
        Node neuron;
        neuron.id = 5, neuron.name = "N";
        brain.nodes.push_back(neuron);
        for (Wire& wire : brain.wires) wire.weight = 0;
        Wire wire;
        wire.from = 1, wire.to = 5;
        brain.wires.push_back(wire);
    });
    DrawList list;
    render::fill(list, now, picture, Trails{});
    ASSERT_EQ(list.neurons.size(), 1U);
    const maths::vec4 at = list.neurons[0].place;
    EXPECT_LT(extremes({at.x, at.y}, at.z, 0).second, 0.6f);
    silence("N");
    EXPECT_GT(extremes({at.x, at.y}, at.z, 0).first, 0.8f);
}

}  // namespace
}  // namespace braitenlab::tests::lesion_test
