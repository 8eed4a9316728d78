// What the tests of rendered pictures begin with: a hidden window of 640 by 480, our renderer, and a picture of it all.
#pragma once

#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "render/gl/renderer.h"
#include "tests/render/stage.h"

namespace braitenlab::render {

inline constexpr int width = 640, height = 480;
inline const Rect window{0, 0, width, height};

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

    void look_from(const Camera& camera) { picture.sight = look(camera, Arena{}, nullptr, window, window); }

    Stage stage{width, height};
    std::optional<Renderer> renderer;
    Picture picture;
};

}  // namespace braitenlab::render
