#include "render/gl/renderer.h"

#include <algorithm>
#include <optional>
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

// The edges of a prism of up to eight corners, numbered for block.vert: side, chamfer and top of each.
Shape prism() {
    Shape shape;
    const auto corner = [&](int edge, int end, int level) {
        shape.corners.push_back(
            {{static_cast<float>(edge), static_cast<float>(end), static_cast<float>(level)}, {}, 0});
    };
    for (int edge = 0; edge < 8; ++edge) {
        const auto first = static_cast<int>(shape.corners.size());
        for (const auto& [low, high] : {std::pair{0, 1}, {2, 3}})
            for (const auto& [end, level] : {std::pair{0, low}, {1, low}, {1, high}, {0, high}})
                corner(edge, end, level);
        for (const int k : {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7})
            shape.indices.push_back(static_cast<std::uint16_t>(first + k));
    }
    const auto top = static_cast<int>(shape.corners.size());
    for (int edge = 0; edge < 8; ++edge) corner(edge, 0, 4);
    for (int edge = 1; edge < 7; ++edge)
        for (const int k : {0, edge, edge + 1}) shape.indices.push_back(static_cast<std::uint16_t>(top + k));
    return shape;
}

// The same for the shadow round its feet.
Shape skirt_shape() {
    Shape shape;
    for (int edge = 0; edge < 8; ++edge) {
        for (const auto& [end, level] : {std::pair{0, -2}, {1, -2}, {1, -1}, {0, -1}})
            shape.corners.push_back(
                {{static_cast<float>(edge), static_cast<float>(end), static_cast<float>(level)}, {}, 0});
        for (const int k : {0, 1, 2, 0, 2, 3}) shape.indices.push_back(static_cast<std::uint16_t>(4 * edge + k));
    }
    return shape;
}

struct FloorInstance {
    maths::vec4 half_size;  // z: how far beyond the arena the ground reaches, m
};
constexpr float floor_fade = 0.55f;  // of the arena's half size

// The instances of one kind of thing with the mesh that shows them.
struct Kit {
    Kit(const Shape& shape, int count) : instances(count), batch(shape, instances) {}
    Instances instances;
    Batch batch;
};

template <class Instance>
Kit kit(const Shape& shape) {
    return Kit(shape, vectors<Instance>);
}

// Whether this context draws the sectors from points.
bool has_geometry_shaders() {
#ifdef __EMSCRIPTEN__
    return false;
#else
    GLint most = 0;
    if (GLEW_VERSION_3_2) glGetIntegerv(GL_MAX_GEOMETRY_OUTPUT_VERTICES, &most);
    return most >= 4;
#endif
}

}  // namespace

struct Renderer::Parts {
    Program floor, block, skirt, zone, hull, sign, rim, wheel, eye, wire, field, mark, source, halo, trail;
    bool sectors_from_points = false;

    Kit floors = kit<FloorInstance>(quad());
    Kit blocks = kit<BlockInstance>(prism());
    Batch skirts{skirt_shape(), blocks.instances};
    Kit zones = kit<ZoneInstance>(quad());
    std::array<Kit, role_count> hulls{kit<HullInstance>(hull_shape(Role::none)),
                                      kit<HullInstance>(hull_shape(Role::predator)),
                                      kit<HullInstance>(hull_shape(Role::prey))};
    std::array<Kit, role_count> signs{kit<SignInstance>(sign_shape(Role::none)),
                                      kit<SignInstance>(sign_shape(Role::predator)),
                                      kit<SignInstance>(sign_shape(Role::prey))};
    std::array<Batch, role_count> rims{Batch{rim_shape(Role::none), hulls[0].instances},
                                       Batch{rim_shape(Role::predator), hulls[1].instances},
                                       Batch{rim_shape(Role::prey), hulls[2].instances}};
    Kit wheels = kit<WheelInstance>(wheel_shape());
    Kit eyes = kit<EyeInstance>(eye_shape());
    Kit wires = kit<WireInstance>(strip(12));
    Kit fields = kit<FieldInstance>(fan());
    Batch field_points = Batch::points(fields.instances);
    Kit marks = kit<MarkInstance>(quad());
    Kit rings = kit<MarkInstance>(quad());
    std::array<Kit, source_shape_count> sources{
        kit<SourceInstance>(source_shape(Channel::light)), kit<SourceInstance>(source_shape(Channel::heat)),
        kit<SourceInstance>(source_shape(Channel::smell)), kit<SourceInstance>(source_shape(Channel::oxygen))};
    Kit halos = kit<HaloInstance>(quad());
    Kit trail_strips = kit<TrailInstance>(strip(1));

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

    // Everything goes up once, whoever draws it how often.
    void upload(const FrameBlock& frame) {
        glBindBuffer(GL_UNIFORM_BUFFER, frame_buffer);
        glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(frame), &frame);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_buffer);
        // Farther out the ground has melted into the sky, which is there already.
        const float beyond = floor_fade * std::max(frame.arena.x, frame.arena.y);
        floor_size[0].half_size = {frame.arena.x + beyond, frame.arena.y + beyond, beyond, 0};
        floors.instances.upload(floor_size);
        blocks.instances.upload(list.blocks);
        zones.instances.upload(list.zones);
        for (std::size_t role = 0; role < hulls.size(); ++role) hulls[role].instances.upload(list.hulls[role]);
        for (std::size_t role = 0; role < signs.size(); ++role) signs[role].instances.upload(list.signs[role]);
        wheels.instances.upload(list.wheels);
        eyes.instances.upload(list.eyes);
        wires.instances.upload(list.wires);
        fields.instances.upload(list.fields);
        marks.instances.upload(list.marks);
        rings.instances.upload(list.rings);
        for (std::size_t i = 0; i < sources.size(); ++i) sources[i].instances.upload(list.sources[i]);
        halos.instances.upload(list.halos);
        trail_strips.instances.upload(list.trails);
    }

    void draw(const Program& program, const Batch& batch, const Instances& instances) {
        if (instances.count() == 0) return;
        program.use();
        calls += batch.draw(instances);
    }
    void draw(const Program& program, const Kit& kit) { draw(program, kit.batch, kit.instances); }

    void draw_solids() {
        draw(block, blocks);
        for (const Kit& of_role : hulls) draw(hull, of_role);
        for (const Kit& of_role : signs) draw(sign, of_role);
        draw(wheel, wheels);
        draw(eye, eyes);
        for (const Kit& of_shape : sources) draw(source, of_shape);
        draw(wire, wires);
    }

    // Last of the solid things, so that what stands before it need not be painted twice. It leaves no depth behind:
    // nothing is below it, so what lies flat on it cannot flicker and a halo that dips into it is not cut.
    void draw_floor() {
        glDepthMask(GL_FALSE);
        draw(floor, floors);
        glDepthMask(GL_TRUE);
    }

    void draw_flat_things() {
        glDepthMask(GL_FALSE);
        glDisable(GL_CULL_FACE);
        glEnable(GL_BLEND);
        draw(zone, zones);
        draw(skirt, skirts, blocks.instances);
        draw(mark, marks);
        draw(trail, trail_strips);
        draw(field, sectors_from_points ? field_points : fields.batch, fields.instances);
        for (std::size_t role = 0; role < rims.size(); ++role) draw(rim, rims[role], hulls[role].instances);
        draw(mark, rings);
        draw(halo, halos);
        glDepthMask(GL_TRUE);
    }

    std::optional<Error> load(const std::filesystem::path& folder, SectorPath path) {
        struct Stages {
            Program* program;
            const char* vertex;
            const char* fragment;
        };
        const Stages all[] = {{&floor, "floor", "floor"}, {&zone, "zone", "zone"},       {&block, "block", "block"},
                              {&skirt, "block", "skirt"}, {&hull, "hull", "hull"},       {&rim, "rim", "rim"},
                              {&sign, "sign", "sign"},    {&wheel, "wheel", "wheel"},    {&eye, "eye", "eye"},
                              {&wire, "wire", "wire"},    {&source, "source", "source"}, {&mark, "mark", "mark"},
                              {&trail, "trail", "trail"}, {&halo, "halo", "halo"}};
        for (const auto& [program, vertex, fragment] : all) {
            auto loaded = Program::load(folder, std::string(vertex) + ".vert", std::string(fragment) + ".frag");
            if (!loaded) return loaded.error();
            *program = std::move(*loaded);
        }
        return load_sectors(folder, path);
    }

    std::optional<Error> load_sectors(const std::filesystem::path& folder, SectorPath path) {
        const bool can = has_geometry_shaders();
        if (path == SectorPath::geometry && !can)
            return Error{"this graphics driver has no geometry shaders; leave out --sectors=geometry"};
        sectors_from_points = path == SectorPath::geometry || (path == SectorPath::automatic && can);
        auto loaded = sectors_from_points ? Program::load(folder, "sector.vert", "field.frag", "sector.geom")
                                          : Program::load(folder, "field.vert", "field.frag");
        if (!loaded) return loaded.error();
        field = std::move(*loaded);
        return std::nullopt;
    }
};

Result<Renderer> Renderer::create(const std::filesystem::path& shader_folder, SectorPath sectors) {
    auto parts = std::make_unique<Parts>();
    if (auto error = parts->load(shader_folder, sectors)) return *error;
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

    p.upload(frame_block(now, picture, p.list));
    p.draw_solids();
    p.draw_floor();
    p.draw_flat_things();

    // Whoever draws next starts from a clean table.
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
}

int Renderer::draw_calls() const { return parts_->calls; }

bool Renderer::sectors_from_points() const { return parts_->sectors_from_points; }

}  // namespace braitenlab
