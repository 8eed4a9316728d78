// The drawing of simple simulators, for comparison: one draw call and five uniforms per box (chassis and four wheels),
// and the vertices of each sensor sector computed and uploaded again for each. Fields have the length and strength of
// the renderer.
#pragma once

#include <array>
#include <vector>

#include <GL/glew.h>

#include "render/view/draw_list.h"

namespace braitenlab::bench {

class CubeByCube {
public:
    // Reads length and strength of each field from the renderer once, outside the measured time.
    CubeByCube(const Snapshot&, const Picture&);
    ~CubeByCube();
    CubeByCube(const CubeByCube&) = delete;
    CubeByCube& operator=(const CubeByCube&) = delete;

    void draw(const Snapshot&, const Picture&);
    int draw_calls() const { return calls_; }

private:
    void draw_box(const Picture&, maths::vec2 place, float heading, maths::vec3 size, Colour);
    void draw_vehicle(const Picture&, const VehicleView&, const Body&, Colour);
    void draw_sector(const render::FieldInstance&);

    std::vector<render::FieldInstance> fields_;
    std::array<GLint, 5> box_uniforms_{};   // model, view, projection, turned, base
    std::array<GLint, 2> flat_uniforms_{};  // view_projection, base
    GLuint box_program_ = 0, flat_program_ = 0, box_array_ = 0, box_buffer_ = 0, fan_array_ = 0, fan_buffer_ = 0;
    int calls_ = 0;
};

}  // namespace braitenlab::bench
