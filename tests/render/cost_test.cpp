// Limits for a frame: no new OpenGL objects, and one upload per type of instance.
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "render/gl/renderer.h"
#include "render/gl/texture.h"
#include "tests/render/rendered.h"
#include "tests/view/hand_made.h"

namespace {
int objects_made = 0, uploads = 0;
}  // namespace

// Texture calls belong to OpenGL 1.1 and are linked by name: a definition in the program replaces the library's.
extern "C" void GLAPIENTRY glGenTextures(GLsizei n, GLuint* names) {
    static const auto real = reinterpret_cast<void(GLAPIENTRY*)(GLsizei, GLuint*)>(glfwGetProcAddress("glGenTextures"));
    ++objects_made, real(n, names);
}

namespace braitenlab::tests::cost_test {
namespace {

using namespace render;

// GLEW calls through pointers, which a test can replace: each replacement counts the call and forwards it.
PFNGLGENBUFFERSPROC real_gen_buffers;
PFNGLGENVERTEXARRAYSPROC real_gen_arrays;
PFNGLCREATESHADERPROC real_create_shader;
PFNGLCREATEPROGRAMPROC real_create_program;
PFNGLGENFRAMEBUFFERSPROC real_gen_framebuffers;
PFNGLGENRENDERBUFFERSPROC real_gen_renderbuffers;
PFNGLGENSAMPLERSPROC real_gen_samplers;
PFNGLGENQUERIESPROC real_gen_queries;
PFNGLFENCESYNCPROC real_fence;
PFNGLBUFFERSUBDATAPROC real_upload;

void GLAPIENTRY counted_gen_buffers(GLsizei n, GLuint* names) { ++objects_made, real_gen_buffers(n, names); }
void GLAPIENTRY counted_gen_arrays(GLsizei n, GLuint* names) { ++objects_made, real_gen_arrays(n, names); }
void GLAPIENTRY counted_gen_framebuffers(GLsizei n, GLuint* names) { ++objects_made, real_gen_framebuffers(n, names); }
void GLAPIENTRY counted_gen_renderbuffers(GLsizei n, GLuint* names) {
    ++objects_made, real_gen_renderbuffers(n, names);
}
void GLAPIENTRY counted_gen_samplers(GLsizei n, GLuint* names) { ++objects_made, real_gen_samplers(n, names); }
void GLAPIENTRY counted_gen_queries(GLsizei n, GLuint* names) { ++objects_made, real_gen_queries(n, names); }
GLsync GLAPIENTRY counted_fence(GLenum what, GLbitfield flags) { return ++objects_made, real_fence(what, flags); }
GLuint GLAPIENTRY counted_create_shader(GLenum stage) { return ++objects_made, real_create_shader(stage); }
GLuint GLAPIENTRY counted_create_program() { return ++objects_made, real_create_program(); }
void GLAPIENTRY counted_upload(GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
    ++uploads, real_upload(target, offset, size, data);
}

class CostTest : public Rendered {
protected:
    void SetUp() override {
        Rendered::SetUp();
        if (HasFatalFailure()) return;
        renderer->use_lettering(std::move(*Lettering::from_fonts(find_font, 14)));
        picture.settings.outlines = true, picture.settings.selection.vehicle = 0,
        picture.settings.overlays.field = Channel::light;

        real_gen_buffers = glGenBuffers, glGenBuffers = counted_gen_buffers;
        real_gen_arrays = glGenVertexArrays, glGenVertexArrays = counted_gen_arrays;
        real_create_shader = glCreateShader, glCreateShader = counted_create_shader;
        real_create_program = glCreateProgram, glCreateProgram = counted_create_program;
        real_gen_framebuffers = glGenFramebuffers, glGenFramebuffers = counted_gen_framebuffers;
        real_gen_renderbuffers = glGenRenderbuffers, glGenRenderbuffers = counted_gen_renderbuffers;
        real_gen_samplers = glGenSamplers, glGenSamplers = counted_gen_samplers;
        real_gen_queries = glGenQueries, glGenQueries = counted_gen_queries;
        real_fence = glFenceSync, glFenceSync = counted_fence;
        real_upload = glBufferSubData, glBufferSubData = counted_upload;
        objects_made = uploads = 0;
    }
    void TearDown() override {
        if (!renderer) return;
        glGenBuffers = real_gen_buffers, glGenVertexArrays = real_gen_arrays;
        glCreateShader = real_create_shader, glCreateProgram = real_create_program;
        glGenFramebuffers = real_gen_framebuffers, glGenRenderbuffers = real_gen_renderbuffers;
        glGenSamplers = real_gen_samplers, glGenQueries = real_gen_queries, glFenceSync = real_fence;
        glBufferSubData = real_upload;
        renderer.reset();
    }

    // A scene with every type of object and this many vehicles.
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
};

TEST_F(CostTest, CreatesNoGlObjectInAFrame) {
    Snapshot now = busy(10);
    for (int frame = 0; frame < 12; ++frame) {
        now.tick += 6;
        for (VehicleView& v : now.vehicles) v.x += 0.1f;
        now.sources[0].x += 0.1f;  // the contours change
        renderer->draw(now, picture);
    }
    now = busy(300);
    renderer->draw(now, picture);
    EXPECT_EQ(objects_made, 0);
}

// Checks the counter of the test above.
TEST_F(CostTest, CountsEveryTypeOfGlObject) {
    int expected = 0;
    const auto count = [&](const char* kind) { EXPECT_EQ(objects_made, ++expected) << kind; };
    GLuint id = 0;
    glGenBuffers(1, &id), count("buffer"), glDeleteBuffers(1, &id);
    glGenVertexArrays(1, &id), count("array"), glDeleteVertexArrays(1, &id);
    glGenFramebuffers(1, &id), count("framebuffer"), glDeleteFramebuffers(1, &id);
    glGenRenderbuffers(1, &id), count("renderbuffer"), glDeleteRenderbuffers(1, &id);
    glGenSamplers(1, &id), count("sampler"), glDeleteSamplers(1, &id);
    glGenQueries(1, &id), count("query"), glDeleteQueries(1, &id);
    glGenTextures(1, &id), count("texture"), glDeleteTextures(1, &id);
    id = glCreateShader(GL_VERTEX_SHADER), count("shader"), glDeleteShader(id);
    id = glCreateProgram(), count("program"), glDeleteProgram(id);
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    count("fence"), glDeleteSync(fence);
}

TEST_F(CostTest, UploadsEachTypeOfInstanceOnce) {
    const auto uploads_for = [&](int count) {
        const Snapshot now = busy(count);
        uploads = 0;
        renderer->draw(now, picture);
        return uploads;
    };
    const int few = uploads_for(10), many = uploads_for(500);
    // Several calls may draw a type of instance, as for hulls and rims, but it is uploaded once.
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
}  // namespace braitenlab::tests::cost_test
