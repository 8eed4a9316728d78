// Still pictures in textures of their own.
#include "render/gl/still.h"

#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "tests/render/rendered.h"
#include "tests/view/hand_made.h"

namespace braitenlab::tests::still_test {
namespace {

using namespace render;

class StillTest : public Rendered {};

TEST_F(StillTest, HasThePictureOfTheSceneAndLeavesTheWindowAlone) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, 0, 0, 0);
    picture.settings.sensors = false;
    renderer->draw(now, picture);
    const auto before = stage.pixels();

    for (const Quality quality : {Quality::low, Quality::high}) {
        constexpr int w = 96, h = 64;
        Still still(w, h);
        Picture small = picture;
        small.quality = quality;
        small.camera_view = look({}, Arena{}, nullptr, {0, 0, w, h}, {0, 0, w, h});
        ASSERT_TRUE(still.draw(*renderer, now, small));
        EXPECT_EQ(stage.pixels(), before);
        const auto pixels = still.pixels();
        ASSERT_EQ(pixels.size(), std::size_t{w} * h * 4);
        const std::size_t middle = (std::size_t{h / 2} * w + w / 2) * 4, corner = 0;
        EXPECT_GT(pixels[middle], pixels[corner] + 20) << "the predator is vermilion, the surroundings are dark";

        Still copy(w, h);
        copy.fill(pixels);
        EXPECT_EQ(copy.pixels(), pixels);
        EXPECT_NE(copy.texture(), still.texture());
    }
}

TEST_F(StillTest, KeepsThePathsOfTheRun) {
    Snapshot now = hand_made::empty(hand_made::scene());
    hand_made::add(now, 1, -2, 0, 0);
    picture.settings.sensors = false;
    for (int i = 0; i < 60; ++i) {
        now.vehicles[0].x += 0.05f, now.tick += 6;
        renderer->remember(now);
    }
    renderer->draw(now, picture);
    const auto before = stage.pixels();
    Snapshot other = hand_made::empty(hand_made::scene());
    other.seed = 99;
    Still still(32, 32);
    Picture small = picture;
    small.camera_view = look({}, Arena{}, nullptr, {0, 0, 32, 32}, {0, 0, 32, 32});
    ASSERT_TRUE(still.draw(*renderer, other, small));
    renderer->draw(now, picture);
    EXPECT_EQ(stage.pixels(), before);
}

}  // namespace
}  // namespace braitenlab::tests::still_test
