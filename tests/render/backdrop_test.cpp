#include "render/gl/backdrop.h"

#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

#include "render/gl/offscreen.h"
#include "tests/render/rendered.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::backdrop_test {
namespace {

using namespace render;

using Pixels = std::vector<unsigned char>;

// Whether two pictures are equal except for rounding: two of 255 levels, because of the order of drawing.
testing::AssertionResult alike(const Pixels& a, const Pixels& b) {
    if (a.size() != b.size() || a.empty()) return testing::AssertionFailure() << "of different sizes";
    int odd = 0;
    for (std::size_t i = 0; i < a.size(); ++i) odd += std::abs(a[i] - b[i]) > 2;
    if (odd == 0) return testing::AssertionSuccess();
    return testing::AssertionFailure() << odd << " bytes differ";
}

class BackdropTest : public Rendered {
protected:
    Pixels drawn(const Snapshot& now) {
        renderer->draw(now, picture);
        return stage.pixels();
    }

    // Drawn by a new renderer without a stored ground.
    Pixels drawn_afresh(const Snapshot& now) {
        auto created = Renderer::create(BRAITENLAB_SOURCE "/shaders");
        if (!created) return {};
        created->draw(now, picture);
        return stage.pixels();
    }

    static Snapshot arena_with(Boundary edge) {
        auto scene = hand_made::scene();
        scene->arena.edge = edge;
        Snapshot now = hand_made::empty(scene);
        hand_made::add(now, 1, -1, 2, 0.4f);
        hand_made::add_source(now, Channel::light, 3, 1);
        return now;
    }
};

TEST_F(BackdropTest, ShowsTheSameGroundAsDirectDrawing) {
    for (const Boundary edge : {Boundary::wall, Boundary::open, Boundary::torus})
        for (const Theme theme : {Theme::dark, Theme::light}) {
            const Snapshot now = arena_with(edge);
            picture.theme = theme;
            const auto moving = drawn_afresh(now);
            for (int frame = 0; frame < 4; ++frame)
                EXPECT_TRUE(alike(drawn(now), moving)) << "frame " << frame << " of edge " << static_cast<int>(edge);
        }
}

TEST_F(BackdropTest, FollowsACameraThatMovesAgain) {
    const Snapshot now = arena_with(Boundary::wall);
    for (int frame = 0; frame < 3; ++frame) drawn(now);
    Camera camera;
    camera.zoom = 1.7f, camera.azimuth += 0.4f;
    look_from(camera);
    EXPECT_TRUE(alike(drawn(now), drawn_afresh(now)));
}

TEST_F(BackdropTest, FillsAPictureThatIsOnlyPartOfTheFramebuffer) {
    const Snapshot now = arena_with(Boundary::wall);
    const Rect part{160, 120, 320, 240};
    picture.camera_view = look(Camera{}, Arena{}, nullptr, part, part);
    const auto moving = drawn_afresh(now);
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(alike(drawn(now), moving)) << frame;
}

TEST_F(BackdropTest, FillsAPictureOfHalfAnOddNumberOfPixels) {
    const Snapshot now = arena_with(Boundary::wall);
    const Rect part{0, 0, 639, 479};
    picture.camera_view = look(Camera{}, Arena{}, nullptr, part, part);
    picture.resolution = 0.5f;
    const auto moving = drawn_afresh(now);
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(alike(drawn(now), moving)) << frame;
}

TEST_F(BackdropTest, ShowsTheSameGroundWithSeveralSamplesPerPixel) {
    const Snapshot now = arena_with(Boundary::torus);
    picture.quality = Quality::high;
    const auto moving = drawn_afresh(now);
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(alike(drawn(now), moving)) << frame;
    picture.quality = Quality::medium;
    EXPECT_FALSE(alike(drawn_afresh(now), moving)) << "high quality has several samples";
}

// The rows of a window begin at the top, those of a framebuffer object at the bottom.
TEST_F(BackdropTest, ShowsTheSameGroundInAWindowAndInAFramebufferObject) {
    const Snapshot now = arena_with(Boundary::open);
    const auto moving = drawn_afresh(now);
    Offscreen elsewhere(window_width, window_height);
    for (int turn = 0; turn < 2; ++turn) {
        for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(alike(drawn(now), moving)) << "window, frame " << frame;
        elsewhere.bind();
        for (int frame = 0; frame < 3; ++frame) {
            renderer->draw(now, picture);
            EXPECT_TRUE(alike(elsewhere.pixels(), moving)) << "framebuffer object, frame " << frame;
        }
        elsewhere.release();
    }
}

TEST_F(BackdropTest, StoresTheGroundAfterTwoEqualFrames) {
    const Snapshot now = arena_with(Boundary::wall);
    Backdrop backdrop;
    const auto ground = [&] { return backdrop.look(frame_block(now, picture, DrawList{})); };
    EXPECT_EQ(ground(), Backdrop::Ground::moves);
    EXPECT_EQ(ground(), Backdrop::Ground::rests);
    backdrop.begin_painting();
    backdrop.end_painting();
    EXPECT_EQ(ground(), Backdrop::Ground::kept);
    picture.theme = Theme::light;
    EXPECT_EQ(ground(), Backdrop::Ground::moves);
    picture.theme = Theme::dark;
    EXPECT_EQ(ground(), Backdrop::Ground::kept) << "the stored ground is valid again";
    backdrop.forget();
    EXPECT_EQ(ground(), Backdrop::Ground::rests);
}

TEST_F(BackdropTest, KeepsTheGroundWhileTimePassesAndLampsMove) {
    Snapshot now = arena_with(Boundary::wall);
    Backdrop backdrop;
    DrawList list;
    backdrop.look(frame_block(now, picture, list));
    now.seconds += 1, now.vehicles[0].x += 1;
    list.lamps.push_back({{1, 1, 0, 1}, {1, 1, 1, 4}});
    EXPECT_EQ(backdrop.look(frame_block(now, picture, list)), Backdrop::Ground::rests);
}

}  // namespace
}  // namespace braitenlab::tests::backdrop_test
