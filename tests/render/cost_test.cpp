// What a frame may ask of the graphics library: no new objects, one upload a kind of thing.
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "render/gl/renderer.h"
#include "tests/render/stage.h"
#include "tests/view/hand_made.h"

namespace braitenlab {
namespace {

constexpr int width = 640, height = 480;
const Rect window{0, 0, width, height};

int objects_made = 0, uploads = 0;

// GLEW calls through pointers, which a test can point elsewhere: each replacement counts and goes on.
PFNGLGENBUFFERSPROC real_gen_buffers;
PFNGLGENVERTEXARRAYSPROC real_gen_arrays;
PFNGLCREATESHADERPROC real_create_shader;
PFNGLCREATEPROGRAMPROC real_create_program;
PFNGLBUFFERSUBDATAPROC real_upload;

void GLAPIENTRY counted_gen_buffers(GLsizei n, GLuint* names) { ++objects_made, real_gen_buffers(n, names); }
void GLAPIENTRY counted_gen_arrays(GLsizei n, GLuint* names) { ++objects_made, real_gen_arrays(n, names); }
GLuint GLAPIENTRY counted_create_shader(GLenum stage) { return ++objects_made, real_create_shader(stage); }
GLuint GLAPIENTRY counted_create_program() { return ++objects_made, real_create_program(); }
void GLAPIENTRY counted_upload(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
    ++uploads, real_upload(target, offset, size, data);
}

class CostTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(stage.ready()) << stage.problem();
        auto created = Renderer::create(BRAITENLAB_SOURCE "/shaders");
        ASSERT_TRUE(created) << created.error().text();
        renderer.emplace(std::move(*created));
        renderer->use_lettering(std::move(*Lettering::from_fonts(find_font, 14)));
        picture.sight = look(Camera{}, Arena{}, nullptr, window, window);
        picture.outlines = true, picture.selected = 0, picture.overlays.field = Channel::light;

        real_gen_buffers = glGenBuffers, glGenBuffers = counted_gen_buffers;
        real_gen_arrays = glGenVertexArrays, glGenVertexArrays = counted_gen_arrays;
        real_create_shader = glCreateShader, glCreateShader = counted_create_shader;
        real_create_program = glCreateProgram, glCreateProgram = counted_create_program;
        real_upload = glBufferSubData, glBufferSubData = counted_upload;
        objects_made = uploads = 0;
    }
    void TearDown() override {
        if (!renderer) return;
        glGenBuffers = real_gen_buffers, glGenVertexArrays = real_gen_arrays;
        glCreateShader = real_create_shader, glCreateProgram = real_create_program;
        glBufferSubData = real_upload;
        renderer.reset();
    }

    // Everything there is, and this many vehicles.
    Snapshot busy(int count) {
        auto scene = hand_made::scene();
        scene->zones.push_back({.name = "ice", .surface = Surface::ice});
        scene->obstacles.push_back({.name = "box", .x = 3});
        scene->sources = {{.name = "lamp"}, {.name = "fire"}};
        Snapshot now = hand_made::empty(scene);
        for (int i = 0; i < count; ++i)
            hand_made::add(now, i % 3, static_cast<float>(i % 18) - 9, static_cast<float>(i / 18) - 9, 0, 0.5f);
        hand_made::add_source(now, Channel::light, 0, 0);
        hand_made::add_source(now, Channel::heat, 5, 5);
        now.marks = {{0, 1, 1, 0.5f}};
        return now;
    }

    static int textures() {
        int count = 0;
        for (GLuint name = 1; name < 256; ++name) count += glIsTexture(name);
        return count;
    }

    Stage stage{width, height};
    std::optional<Renderer> renderer;
    Picture picture;
};

TEST_F(CostTest, MakesNoObjectInAFrame) {
    Snapshot now = busy(10);
    const int before = textures();
    for (int frame = 0; frame < 12; ++frame) {
        now.tick += 6;
        for (VehicleView& v : now.vehicles) v.x += 0.1f;
        now.sources[0].x += 0.1f;  // the contours change
        renderer->draw(now, picture);
    }
    now = busy(300);
    renderer->draw(now, picture);
    EXPECT_EQ(objects_made, 0);
    EXPECT_EQ(textures(), before);
    EXPECT_GT(before, 0);
}

TEST_F(CostTest, UploadsEachKindOfThingOnce) {
    const auto uploads_for = [&](int count) {
        const Snapshot now = busy(count);
        uploads = 0;
        renderer->draw(now, picture);
        return uploads;
    };
    const int few = uploads_for(10), many = uploads_for(500);
    // A kind of thing may be drawn by several calls, as hulls with their rims, but goes up once.
    EXPECT_LE(few, renderer->draw_calls() + 1);
    EXPECT_LE(many, few + 4);
    EXPECT_GT(few, 8);
}

TEST_F(CostTest, DrawsEverythingInFewCalls) {
    const Snapshot few = busy(10), many = busy(500);
    renderer->draw(few, picture);
    const int calls = renderer->draw_calls();
    renderer->draw(many, picture);
    EXPECT_LE(renderer->draw_calls(), calls + 4);
    EXPECT_LE(renderer->draw_calls(), 32);
}

}  // namespace
}  // namespace braitenlab
