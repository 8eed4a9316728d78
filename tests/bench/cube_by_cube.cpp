#include "tests/bench/cube_by_cube.h"

#include <array>
#include <vector>

#include "core/maths/angle.h"

namespace braitenlab::bench {

using maths::mat4;
using maths::vec2;
using maths::vec3;

namespace {

constexpr const char* box_vertex = R"(#version 330 core
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 normal;
uniform mat4 model, view, projection, turned;
out vec3 v_normal;
void main() {
    v_normal = mat3(turned) * normal;
    gl_Position = projection * view * model * vec4(corner, 1.0);
})";
constexpr const char* box_fragment = R"(#version 330 core
in vec3 v_normal;
uniform vec4 base;
out vec4 colour;
void main() {
    float light = 0.35 + 0.65 * max(dot(normalize(v_normal), normalize(vec3(-0.45, 0.82, 0.38))), 0.0);
    colour = vec4(base.rgb * light, 1.0);
})";
constexpr const char* flat_vertex = R"(#version 330 core
layout(location = 0) in vec2 place;
uniform mat4 view_projection;
void main() { gl_Position = view_projection * vec4(place.x, 0.008, -place.y, 1.0); })";
constexpr const char* flat_fragment = R"(#version 330 core
uniform vec4 base;
out vec4 colour;
void main() { colour = base; })";

GLuint program(const char* vertex, const char* fragment) {
    const GLuint made = glCreateProgram();
    for (const auto& [stage, text] : {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
        const GLuint shader = glCreateShader(static_cast<GLenum>(stage));
        glShaderSource(shader, 1, &text, nullptr);
        glCompileShader(shader);
        glAttachShader(made, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(made);
    return made;
}

// Six faces of two triangles; position and normal per corner.
std::vector<vec3> cube() {
    std::vector<vec3> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            vec3 normal, across;
            normal[axis] = side;
            across[(axis + 1) % 3] = 1;
            const vec3 up = maths::cross(normal, across);
            const std::array<vec3, 4> quad{normal - across - up, normal + across - up, normal + across + up,
                                           normal - across + up};
            for (const std::size_t i : {0U, 1U, 2U, 0U, 2U, 3U})
                corners.push_back(quad[i] * 0.5f), corners.push_back(normal);
        }
    return corners;
}

void set(GLint uniform, const mat4& value) { glUniformMatrix4fv(uniform, 1, GL_FALSE, &value[0].x); }
void set(GLint uniform, Colour c) { glUniform4f(uniform, c.r, c.g, c.b, c.a); }

}  // namespace

CubeByCube::CubeByCube(const Snapshot& now, const Picture& picture)
    : box_program_(program(box_vertex, box_fragment)), flat_program_(program(flat_vertex, flat_fragment)) {
    render::DrawList list;
    render::fill(list, now, picture, render::Trails{});
    fields_ = list.fields;
    std::size_t i = 0;
    for (const char* name : {"model", "view", "projection", "turned", "base"})
        box_uniforms_[i++] = glGetUniformLocation(box_program_, name);
    flat_uniforms_ = {glGetUniformLocation(flat_program_, "view_projection"),
                      glGetUniformLocation(flat_program_, "base")};

    const auto corners = cube();
    glGenVertexArrays(1, &box_array_);
    glBindVertexArray(box_array_);
    glGenBuffers(1, &box_buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, box_buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(vec3)), corners.data(),
                 GL_STATIC_DRAW);
    for (const GLuint at : {0U, 1U}) {
        glEnableVertexAttribArray(at);
        glVertexAttribPointer(at, 3, GL_FLOAT, GL_FALSE, 2 * sizeof(vec3),
                              reinterpret_cast<const void*>(at * sizeof(vec3)));
    }
    glGenVertexArrays(1, &fan_array_);
    glBindVertexArray(fan_array_);
    glGenBuffers(1, &fan_buffer_);
    glBindBuffer(GL_ARRAY_BUFFER, fan_buffer_);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(vec2), nullptr);
}

CubeByCube::~CubeByCube() {
    for (const GLuint buffer : {box_buffer_, fan_buffer_}) glDeleteBuffers(1, &buffer);
    for (const GLuint array : {box_array_, fan_array_}) glDeleteVertexArrays(1, &array);
    glDeleteProgram(box_program_);
    glDeleteProgram(flat_program_);
}

void CubeByCube::draw(const Snapshot& now, const Picture& picture) {
    calls_ = 0;
    const Palette colours = palette(picture.theme);
    const Rect& window = picture.camera_view.window;
    glViewport(0, 0, static_cast<GLsizei>(window.w), static_cast<GLsizei>(window.h));
    glClearColor(colours.sky.r, colours.sky.g, colours.sky.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glUseProgram(box_program_);
    const Arena& arena = now.scene->arena;
    draw_box(picture, {}, 0, {arena.width, 0.01f, arena.height}, colours.floor);
    for (const VehicleView& v : now.vehicles)
        draw_vehicle(picture, v, now.scene->kinds[static_cast<std::size_t>(v.kind)].body, colour_of(colours, v.role));
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUseProgram(flat_program_);
    for (const render::FieldInstance& field : fields_) {
        set(flat_uniforms_[0], picture.camera_view.projection * picture.camera_view.view);
        set(flat_uniforms_[1], Colour{field.colour.x, field.colour.y, field.colour.z, field.colour.w * 0.4f});
        draw_sector(field);
    }
    glDisable(GL_BLEND);
}

void CubeByCube::draw_box(const Picture& picture, vec2 place, float heading, vec3 size, Colour colour) {
    const mat4 turned = maths::rotation(heading, {0, 1, 0});
    set(box_uniforms_[0], maths::translation(to_gl(place, size.y / 2)) * turned * maths::scaling(size));
    set(box_uniforms_[1], picture.camera_view.view);
    set(box_uniforms_[2], picture.camera_view.projection);
    set(box_uniforms_[3], turned);
    set(box_uniforms_[4], colour);
    glBindVertexArray(box_array_);
    glDrawArrays(GL_TRIANGLES, 0, 36);
    ++calls_;
}

void CubeByCube::draw_vehicle(const Picture& picture, const VehicleView& v, const Body& body, Colour colour) {
    draw_box(picture, {v.x, v.y}, v.heading, {body.length, 0.25f, body.width}, colour);
    for (const Wheel& wheel : body.wheels) {
        const vec2 at = vec2{v.x, v.y} + maths::rotate({wheel.x, wheel.y}, maths::direction(v.heading));
        draw_box(picture, at, v.heading, {2 * wheel.radius, 2 * wheel.radius, wheel.width}, {0.1f, 0.1f, 0.1f});
    }
}

void CubeByCube::draw_sector(const render::FieldInstance& field) {
    constexpr int steps = 16;
    const vec2 apex{field.place.x, field.place.y}, axis{field.place.z, field.place.w};
    std::array<vec2, steps + 2> fan;
    fan[0] = apex;
    for (int i = 0; i <= steps; ++i) {
        const float angle = field.shape.y * (2 * static_cast<float>(i) / steps - 1);
        fan[static_cast<std::size_t>(i) + 1] = apex + maths::rotate(maths::direction(angle), axis) * field.shape.x;
    }
    glBindVertexArray(fan_array_);
    glBindBuffer(GL_ARRAY_BUFFER, fan_buffer_);
    glBufferData(GL_ARRAY_BUFFER, sizeof fan, fan.data(), GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLE_FAN, 0, steps + 2);
    ++calls_;
}

}  // namespace braitenlab::bench
