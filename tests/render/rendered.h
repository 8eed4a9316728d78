// Fixture for tests of rendered pictures: a hidden window of 640 x 480, a renderer and a picture of the whole arena.
#pragma once

#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "render/gl/renderer.h"
#include "tests/render/stage.h"

namespace braitenlab::render {

inline constexpr int window_width = 640, window_height = 480;
inline const Rect window{0, 0, window_width, window_height};

inline float brightness(Colour c) { return (c.r + c.g + c.b) / 3; }

class Rendered : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(stage.ready()) << stage.problem();
        auto created = Renderer::create(BRAITENLAB_SOURCE "/shaders");
        ASSERT_TRUE(created) << created.error().text();
        renderer.emplace(std::move(*created));
        look_from({});
    }
    void TearDown() override { renderer.reset(); }

    // The mean colour of 3 x 3 pixels, which single pixels of lines and edges hardly change.
    Colour patch(maths::vec2 middle) {
        Colour mean{0, 0, 0, 1};
        for (const float y : {-1.0f, 0.0f, 1.0f})
            for (const float x : {-1.0f, 0.0f, 1.0f}) {
                const Colour c = stage.pixel({middle.x + x, middle.y + y});
                mean.r += c.r / 9, mean.g += c.g / 9, mean.b += c.b / 9;
            }
        return mean;
    }

    void look_from(const Camera& camera) { picture.camera_view = look(camera, Arena{}, nullptr, window, window); }

    Stage stage{window_width, window_height};
    std::optional<Renderer> renderer;
    Picture picture;
};

}  // namespace braitenlab::render
