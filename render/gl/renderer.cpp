#include "render/gl/renderer.h"

#include <algorithm>
#include <string>
#include <utility>

#include <GL/glew.h>

#include "render/gl/batch.h"
#include "render/gl/frame.h"
#include "render/gl/shader.h"
#include "render/view/draw_list.h"
#include "render/view/shapes.h"

namespace braitenlab {

namespace {

template <class Instance>
constexpr int vectors = static_cast<int>(sizeof(Instance) / sizeof(maths::vec4));

Shape quad() {
    Shape shape;
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}})
        shape.corners.push_back({{x, y, 0}, {0, 0, 1}, 0});
    shape.indices = {0, 1, 2, 0, 2, 3};
    return shape;
}

// A strip of squares along x from 0 to 1, y from −1 to 1.
Shape strip(int squares) {
    Shape shape;
    for (int i = 0; i <= squares; ++i)
        for (const float y : {-1.0f, 1.0f})
            shape.corners.push_back({{static_cast<float>(i) / static_cast<float>(squares), y, 0}, {0, 0, 1}, 0});
    for (int i = 0; i < squares; ++i)
        for (const int k : {0, 2, 3, 0, 3, 1}) shape.indices.push_back(static_cast<std::uint16_t>(2 * i + k));
    return shape;
}

// Four numbered corners that the field's shader puts where the sector needs them.
Shape fan() {
    Shape shape;
    for (const float i : {0.0f, 1.0f, 2.0f, 3.0f}) shape.corners.push_back({{i, 0, 0}, {0, 0, 1}, 0});
    shape.indices = {0, 1, 2, 0, 2, 3};
    return shape;
}

struct FloorInstance {
    maths::vec4 half_size;  // z: how far beyond the arena the ground reaches, m
};
constexpr float floor_fade = 0.55f;  // of the arena's half size

}  // namespace

struct Renderer::Parts {
    Program floor, block, hull, rim, wheel, eye, wire, field, mark, source, halo, trail;

    Batch floors{quad(), 1};
    Batch blocks{block_shape(), vectors<BlockInstance>};
    std::array<Batch, role_count> hulls{Batch{hull_shape(Role::none), vectors<HullInstance>},
                                        Batch{hull_shape(Role::predator), vectors<HullInstance>},
                                        Batch{hull_shape(Role::prey), vectors<HullInstance>}};
    std::array<Batch, role_count> rims{Batch{rim_shape(Role::none), vectors<HullInstance>},
                                       Batch{rim_shape(Role::predator), vectors<HullInstance>},
                                       Batch{rim_shape(Role::prey), vectors<HullInstance>}};
    Batch wheels{wheel_shape(), vectors<WheelInstance>};
    Batch eyes{eye_shape(), vectors<EyeInstance>};
    Batch wires{strip(12), vectors<WireInstance>};
    Batch fields{fan(), vectors<FieldInstance>};
    Batch marks{quad(), vectors<MarkInstance>};
    Batch rings{quad(), vectors<MarkInstance>};
    std::array<Batch, source_shape_count> sources{Batch{source_shape(Channel::light), vectors<SourceInstance>},
                                                  Batch{source_shape(Channel::heat), vectors<SourceInstance>},
                                                  Batch{source_shape(Channel::smell), vectors<SourceInstance>},
                                                  Batch{source_shape(Channel::oxygen), vectors<SourceInstance>}};
    Batch halos{quad(), vectors<HaloInstance>};
    Batch trail_strips{strip(1), vectors<TrailInstance>};

    unsigned frame_buffer = 0;
    DrawList list;
    Trails trails;
    std::vector<FloorInstance> floor_size{1};
    int calls = 0;

    Parts() {
        glGenBuffers(1, &frame_buffer);
        glBindBuffer(GL_UNIFORM_BUFFER, frame_buffer);
        glBufferData(GL_UNIFORM_BUFFER, sizeof(FrameBlock), nullptr, GL_DYNAMIC_DRAW);
    }
    ~Parts() { glDeleteBuffers(1, &frame_buffer); }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    template <class Instance>
    void draw(const Program& program, Batch& batch, const std::vector<Instance>& instances) {
        if (instances.empty()) return;
        program.use();
        calls += batch.draw(instances);
    }

    void draw_solids() {
        draw(block, blocks, list.blocks);
        for (std::size_t role = 0; role < hulls.size(); ++role) draw(hull, hulls[role], list.hulls[role]);
        draw(wheel, wheels, list.wheels);
        draw(eye, eyes, list.eyes);
        for (std::size_t shape = 0; shape < sources.size(); ++shape) draw(source, sources[shape], list.sources[shape]);
        draw(wire, wires, list.wires);
    }

    // Last of the solid things, so that what stands before it need not be painted twice. It leaves no depth behind:
    // nothing is below it, so what lies flat on it cannot flicker and a halo that dips into it is not cut.
    void draw_floor(const FrameBlock& frame) {
        glDepthMask(GL_FALSE);
        // Farther out the ground has melted into the sky, which is there already.
        const float beyond = floor_fade * std::max(frame.arena.x, frame.arena.y);
        floor_size[0].half_size = {frame.arena.x + beyond, frame.arena.y + beyond, beyond, 0};
        draw(floor, floors, floor_size);
        glDepthMask(GL_TRUE);
    }

    void draw_flat_things() {
        glDepthMask(GL_FALSE);
        glDisable(GL_CULL_FACE);
        glEnable(GL_BLEND);
        draw(mark, marks, list.marks);
        draw(trail, trail_strips, list.trails);
        draw(field, fields, list.fields);
        for (std::size_t role = 0; role < rims.size(); ++role) draw(rim, rims[role], list.hulls[role]);
        draw(mark, rings, list.rings);
        draw(halo, halos, list.halos);
        glDepthMask(GL_TRUE);
    }
};

Result<Renderer> Renderer::create(const std::filesystem::path& shader_folder) {
    auto parts = std::make_unique<Parts>();
    const std::pair<Program*, const char*> programs[] = {
        {&parts->floor, "floor"},   {&parts->block, "block"}, {&parts->hull, "hull"},   {&parts->wheel, "wheel"},
        {&parts->eye, "eye"},       {&parts->wire, "wire"},   {&parts->field, "field"}, {&parts->mark, "mark"},
        {&parts->source, "source"}, {&parts->halo, "halo"},   {&parts->trail, "trail"}, {&parts->rim, "rim"},
    };
    for (const auto& [program, name] : programs) {
        auto loaded = Program::load(shader_folder, std::string(name) + ".vert", std::string(name) + ".frag");
        if (!loaded) return loaded.error();
        *program = std::move(*loaded);
    }
    return Renderer(std::move(parts));
}

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

void Renderer::draw(const Snapshot& now, const Picture& picture) {
    Parts& p = *parts_;
    p.calls = 0;
    p.trails.record(now);
    fill(p.list, now, picture, p.trails);

    const Rect& window = picture.sight.window;
    glViewport(static_cast<GLint>(window.x), static_cast<GLint>(window.y), static_cast<GLsizei>(window.w),
               static_cast<GLsizei>(window.h));
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    const Colour sky = palette(picture.theme).sky;
    glClearColor(sky.r, sky.g, sky.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glDisable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    // Colours come premultiplied: alpha 0 adds light, alpha 1 covers.
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

    const FrameBlock frame = frame_block(now, picture, p.list);
    glBindBuffer(GL_UNIFORM_BUFFER, p.frame_buffer);
    glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(frame), &frame);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, p.frame_buffer);

    p.draw_solids();
    p.draw_floor(frame);
    p.draw_flat_things();

    // Whoever draws next starts from a clean table.
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
}

int Renderer::draw_calls() const { return parts_->calls; }

}  // namespace braitenlab
