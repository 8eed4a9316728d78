#include "render/gl/stored_picture.h"

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "render/gl/offscreen.h"
#include "tests/render/rendered.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::stored_picture_test {
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

class StoredPictureTest : public Rendered {
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

TEST_F(StoredPictureTest, ShowsTheSameGroundAsDirectDrawing) {
    for (const Boundary edge : {Boundary::wall, Boundary::open, Boundary::torus})
        for (const Theme theme : {Theme::dark, Theme::light}) {
            const Snapshot now = arena_with(edge);
            picture.theme = theme;
            const auto moving = drawn_afresh(now);
            for (int frame = 0; frame < 4; ++frame)
                EXPECT_TRUE(alike(drawn(now), moving)) << "frame " << frame << " of edge " << static_cast<int>(edge);
        }
}

TEST_F(StoredPictureTest, FollowsACameraThatMovesAgain) {
    const Snapshot now = arena_with(Boundary::wall);
    for (int frame = 0; frame < 3; ++frame) drawn(now);
    Camera camera;
    camera.zoom = 1.7f, camera.azimuth += 0.4f;
    look_from(camera);
    EXPECT_TRUE(alike(drawn(now), drawn_afresh(now)));
}

TEST_F(StoredPictureTest, FillsAPictureThatIsOnlyPartOfTheFramebuffer) {
    const Snapshot now = arena_with(Boundary::wall);
    const Rect part{160, 120, 320, 240};
    picture.camera_view = look(Camera{}, Arena{}, nullptr, part, part);
    const auto moving = drawn_afresh(now);
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(alike(drawn(now), moving)) << frame;
}

TEST_F(StoredPictureTest, FillsAPictureOfHalfAnOddNumberOfPixels) {
    const Snapshot now = arena_with(Boundary::wall);
    const Rect part{0, 0, 639, 479};
    picture.camera_view = look(Camera{}, Arena{}, nullptr, part, part);
    picture.resolution = 0.5f;
    const auto moving = drawn_afresh(now);
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(alike(drawn(now), moving)) << frame;
}

TEST_F(StoredPictureTest, ShowsTheSameGroundWithSeveralSamplesPerPixel) {
    const Snapshot now = arena_with(Boundary::torus);
    picture.quality = Quality::high;
    const auto moving = drawn_afresh(now);
    for (int frame = 0; frame < 3; ++frame) EXPECT_TRUE(alike(drawn(now), moving)) << frame;
    picture.quality = Quality::medium;
    EXPECT_FALSE(alike(drawn_afresh(now), moving)) << "high quality has several samples";
}

// The rows of a window begin at the top, those of a framebuffer object at the bottom.
TEST_F(StoredPictureTest, ShowsTheSameGroundInAWindowAndInAFramebufferObject) {
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

TEST_F(StoredPictureTest, StoresTheGroundAfterTwoEqualFrames) {
    const Snapshot now = arena_with(Boundary::wall);
    StoredPicture stored;
    const auto ground = [&] { return stored.look(ground_of(frame_block(now, picture, DrawList{}))); };
    EXPECT_EQ(ground(), StoredPicture::Content::moves);
    EXPECT_EQ(ground(), StoredPicture::Content::rests);
    stored.begin_painting();
    stored.end_painting();
    EXPECT_EQ(ground(), StoredPicture::Content::kept);
    picture.theme = Theme::light;
    EXPECT_EQ(ground(), StoredPicture::Content::moves);
    picture.theme = Theme::dark;
    EXPECT_EQ(ground(), StoredPicture::Content::kept) << "the stored ground is valid again";
    stored.forget();
    EXPECT_EQ(ground(), StoredPicture::Content::rests);
}

TEST_F(StoredPictureTest, DrawsASceneAtRestWithAllPixelsAndThenCopiesIt) {
    Snapshot now = arena_with(Boundary::wall);
    picture.resolution = 0.5f;
    const auto coarse = drawn_afresh(now);
    picture.resolution = 1;
    const auto sharp = drawn_afresh(now);
    EXPECT_FALSE(alike(coarse, sharp));
    picture.resolution = 0.5f, picture.copied_at_rest = true;
    int coarse_frames = 0;
    while (coarse_frames < 20 && alike(drawn(now), coarse)) ++coarse_frames;
    EXPECT_GE(coarse_frames, 3) << "a pause between two movements of the mouse is no rest";
    EXPECT_LE(coarse_frames, 6);
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_TRUE(alike(drawn(now), sharp)) << frame;
        EXPECT_EQ(renderer->draw_calls(), 0) << "it is a copy";
        EXPECT_EQ(renderer->resolution(), 1);
    }
    now.vehicles[0].x += 0.5f;
    EXPECT_TRUE(alike(drawn(now), drawn_afresh(now))) << "no copy of another picture";
    EXPECT_EQ(renderer->resolution(), 0.5f);
}

TEST_F(StoredPictureTest, ShowsVehiclesWithAllPixelsOnACoarseGroundWhichRests) {
    for (const Boundary edge : {Boundary::wall, Boundary::torus}) {
        const Snapshot now = arena_with(edge);
        picture.settings.sensors = false;
        picture.coarse_ground = false;
        const auto sharp = drawn_afresh(now);
        const auto at = *project(picture.camera_view, {now.vehicles[0].x, now.vehicles[0].y}, 0.2f);
        const float vehicle = brightness(patch(at));
        picture.coarse_ground = true;
        const auto moving = drawn_afresh(now);
        EXPECT_NEAR(brightness(patch(at)), vehicle, 0.004f);
        int differ = 0;
        double sum = 0;
        for (std::size_t i = 0; i < sharp.size(); ++i) {
            const int difference = std::abs(sharp[i] - moving[i]);
            differ += difference > 3, sum += difference;
        }
        EXPECT_GT(differ, 100) << "lines of the grid are softer";
        EXPECT_LT(sum / static_cast<double>(sharp.size()), 2) << "of 255";
        drawn(now);
        EXPECT_TRUE(alike(drawn(now), sharp)) << "a ground that rests has all pixels";
    }
}

TEST_F(StoredPictureTest, CopiesNoSceneInWhichSomethingChanges) {
    Snapshot now = arena_with(Boundary::wall);
    picture.copied_at_rest = true;
    const auto rest = [&] {
        for (int frame = 0; frame < 8; ++frame) drawn(now);
        EXPECT_EQ(renderer->draw_calls(), 0);
    };
    const auto drawn_anew = [&](const char* what) {
        const auto after = drawn(now);
        EXPECT_GT(renderer->draw_calls(), 0) << what;
        picture.copied_at_rest = false;
        EXPECT_TRUE(alike(after, drawn_afresh(now))) << what;
        picture.copied_at_rest = true;
    };
    rest();
    picture.hovered = now.vehicles[0].id;
    drawn_anew("a ring around a vehicle");
    rest();
    picture.settings.overlays.field = Channel::light;
    drawn_anew("contours");
    rest();
    now.sources[0].x -= 2;
    drawn_anew("a lamp and its contours");
    rest();
    auto scene = std::make_shared<Scene>(*now.scene);
    for (Sensor& eye : scene->kinds[0].sensors) eye.channel = Channel::heat;
    now.scene = scene;
    hand_made::add_source(now, Channel::heat, -3, -1);
    picture.settings.overlays.field = Channel::heat, picture.settings.selection.vehicle = now.vehicles[0].id;
    picture.settings.sensors = false;
    rest();
    auto other = std::make_shared<Scene>(*scene);
    for (Sensor& eye : other->kinds[0].sensors) eye.half_distance *= 2;
    now.scene = other;
    drawn_anew("only the contours");
    rest();
    now.seconds += 1;
    drawn_anew("the time");
    rest();
    picture.theme = Theme::light;
    drawn_anew("the theme");
}

TEST_F(StoredPictureTest, KeepsTheGroundWhileTimePassesAndLampsMove) {
    Snapshot now = arena_with(Boundary::wall);
    StoredPicture stored;
    DrawList list;
    stored.look(ground_of(frame_block(now, picture, list)));
    now.seconds += 1, now.vehicles[0].x += 1;
    list.lamps.push_back({{1, 1, 0, 1}, {1, 1, 1, 4}});
    EXPECT_EQ(stored.look(ground_of(frame_block(now, picture, list))), StoredPicture::Content::rests);
}

TEST_F(StoredPictureTest, LeavesOutWhatIsBelowCards) {
    // The picture in the stage beside another one, but for the rows of a card.
    const auto same_outside = [&](const Rect& card, const Pixels& other) {
        const auto upper = [&](Pixels all) {
            all.resize(static_cast<std::size_t>(card.y) * window_width * 3);
            return all;
        };
        return alike(upper(stage.pixels()), upper(other));
    };
    const Snapshot now = arena_with(Boundary::wall);
    picture.settings.sensors = false;
    picture.copied_at_rest = true;
    const maths::vec2 vehicle = *project(picture.camera_view, {now.vehicles[0].x, now.vehicles[0].y}, 0.3f);
    for (const auto& [quality, resolution] :
         {std::pair{Quality::medium, 1.0f}, {Quality::low, 0.5f}, {Quality::high, 1.0f}}) {
        picture.quality = quality, picture.resolution = resolution;
        picture.opaque.clear();
        drawn_afresh(now);
        const float shown = brightness(patch(vehicle));
        const Pixels whole = stage.pixels();
        picture.opaque = {{vehicle.x - 60, vehicle.y - 60, 120, 120}};
        for (int frame = 0; frame < 4; ++frame) {
            renderer->draw(now, picture);
            EXPECT_GT(std::fabs(brightness(patch(vehicle)) - shown), 0.05f) << "frame " << frame;
            const bool is_coarser = renderer->resolution() != resolution;
            EXPECT_TRUE(is_coarser || same_outside(picture.opaque.front(), whole)) << "frame " << frame;
        }
        picture.opaque.clear();
        EXPECT_TRUE(alike(drawn(now), drawn_afresh(now))) << "the card has gone";
    }
}

TEST_F(StoredPictureTest, StaysOnlyWhileTheSceneRests) {
    Snapshot now = arena_with(Boundary::wall);
    picture.copied_at_rest = picture.may_stay = true;
    const auto stays = [&] {
        for (int frame = 0; frame < 20; ++frame)
            if (!renderer->draw(now, picture)) return true;
        return false;
    };
    EXPECT_TRUE(stays());
    EXPECT_FALSE(renderer->draw(now, picture));
    now.vehicles[0].x += 0.1f;
    EXPECT_TRUE(renderer->draw(now, picture)) << "a vehicle is elsewhere";
    EXPECT_TRUE(stays());
    picture.opaque = {{0, 0, 50, 50}};
    EXPECT_TRUE(renderer->draw(now, picture)) << "a card has come";
    picture.may_stay = false;
    EXPECT_FALSE(stays()) << "something over the scene has changed";
}

}  // namespace
}  // namespace braitenlab::tests::stored_picture_test
