// Sensor fields from geometry shaders and from instances: the same picture.
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "render/gl/renderer.h"
#include "tests/render/stage.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::sector_test {
namespace {

using namespace render;

constexpr int width = 640, height = 480;

class SectorTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(stage.ready()) << stage.problem(); }

    // One vehicle with one eye of this field in the middle of the arena, seen from above, heading along +x.
    std::vector<unsigned char> picture_of(SectorPath path, float field_degrees, SensorShape shape) {
        auto scene = hand_made::scene();
        Sensor eye = scene->kinds[0].sensors[0];
        eye.x = eye.y = eye.angle = 0, eye.range = 7, eye.half_distance = 20;
        eye.fov = maths::radians(field_degrees), eye.shape = shape;
        scene->kinds[0].sensors = {eye};
        Snapshot now = hand_made::empty(scene);
        hand_made::add(now, 0, 0, 0, 0, 0.9f);
        Camera camera;
        camera.elevation = 1.5f;
        Picture picture;
        picture.camera_view = look(camera, scene->arena, nullptr, {0, 0, width, height}, {0, 0, width, height});
        picture.settings.outlines = true, picture.settings.selection.vehicle = 0;
        camera_view = picture.camera_view;
        auto renderer = Renderer::create(BRAITENLAB_SOURCE "/shaders", path);
        EXPECT_TRUE(renderer) << renderer.error().text();
        renderer->draw(now, picture);
        EXPECT_EQ(renderer->sectors_from_points(), path == SectorPath::geometry);
        EXPECT_EQ(stage.complaints(), "");
        return stage.pixels();
    }

    Stage stage{width, height};
    CameraView camera_view;
};

struct Case {
    float field;
    SensorShape shape;
};
const Case cases[] = {{30, SensorShape::sector},  {100, SensorShape::sector},  {119, SensorShape::sector},
                      {121, SensorShape::sector}, {170, SensorShape::sector},  {181, SensorShape::sector},
                      {300, SensorShape::sector}, {80, SensorShape::triangle}, {360, SensorShape::omni}};

TEST_F(SectorTest, LooksTheSameWithGeometryShadersAndWithInstances) {
    for (const auto& [field, shape] : cases) {
        const auto a = picture_of(SectorPath::geometry, field, shape),
                   b = picture_of(SectorPath::instanced, field, shape);
        int differing = 0;
        for (std::size_t i = 0; i < a.size(); ++i) differing += std::abs(a[i] - b[i]) > 3;
        // A pixel on an edge may differ, because the corner is rounded differently.
        EXPECT_LE(differing, 30) << field;
    }
}

TEST_F(SectorTest, ShowsTheFieldOnlyInsideItsSidesAndRange) {
    for (const SectorPath path : {SectorPath::geometry, SectorPath::instanced})
        for (const float field : {60.0f, 100.0f, 140.0f, 270.0f}) {
            picture_of(path, field, SensorShape::sector);
            const Colour floor = palette(Theme::dark).floor;
            const auto yellowness = [&](float angle, float distance) {
                const Colour c = stage.pixel(*project(camera_view, maths::direction(maths::radians(angle)) * distance));
                return c.r - c.b - (floor.r - floor.b);
            };
            for (const float side : {-1.0f, 1.0f}) {
                EXPECT_GT(yellowness(side * (field / 2 - 9), 3), 0.08f) << field;
                EXPECT_LT(yellowness(side * (field / 2 + 9), 3), 0.03f) << field;
            }
            EXPECT_GT(yellowness(5, 3.5f), 0.05f) << field;
            EXPECT_LT(yellowness(5, 7.4f), 0.03f) << field;
        }
}

TEST_F(SectorTest, UsesGeometryShadersWhereTheDriverHasThem) {
    const auto renderer = Renderer::create(BRAITENLAB_SOURCE "/shaders");
    ASSERT_TRUE(renderer) << renderer.error().text();
    EXPECT_TRUE(renderer->sectors_from_points());
}

}  // namespace
}  // namespace braitenlab::tests::sector_test
