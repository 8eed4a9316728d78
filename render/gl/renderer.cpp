#include "render/gl/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <utility>

#include "core/sensing/intensity.h"
#include "render/gl/batch.h"
#include "render/gl/frame.h"
#include "render/gl/opengl.h"
#include "render/gl/programs.h"
#include "render/gl/resampling.h"
#include "render/gl/stored_picture.h"
#include "render/gl/texture.h"
#include "render/text/set_type.h"
#include "render/view/draw_list.h"
#include "render/view/fine_shapes.h"
#include "render/view/hidden_parts.h"
#include "render/view/shapes.h"

namespace braitenlab::render {

namespace {

template <class Instance>
constexpr int vectors = static_cast<int>(sizeof(Instance) / sizeof(maths::vec4));

struct FloorInstance {
    maths::vec4 half_size;  // z: ground beyond the arena, m
};
constexpr float floor_fade = 1.2f;  // of the arena's half size; ground visible beyond the arena

// The instances of one type with their mesh.
struct Kit {
    Kit(const Shape& shape, int count, bool copied) : instances(count, copied), batch(shape, instances) {}
    Instances instances;
    Batch batch;
};

// make() of each role, and of the channel of each shape of sources.
template <auto... keys>
auto one_for_each(const auto& make) {
    return std::array{make(keys)...};
}
auto by_role(const auto& make) { return one_for_each<Role::none, Role::predator, Role::prey>(make); }
auto by_source(const auto& make) {
    return one_for_each<Channel::light, Channel::heat, Channel::smell, Channel::oxygen>(make);
}

// True for SwiftShader, which draws each instance as a call of its own.
bool draws_instances_one_by_one() {
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    return name && std::string_view(name).find("SwiftShader") != std::string_view::npos;
}

// Rounded vehicles are large or few: pieces of wires and trails are then long enough on the screen to be curved.
bool has_rounded(const DrawList& list) { return !list.tyres.empty(); }

// Vehicles below full detail have a rim.
bool has_rims(const std::vector<HullInstance>& hulls) {
    return std::any_of(hulls.begin(), hulls.end(), [](const HullInstance& hull) { return hull.look.x < 1; });
}

// Fields that end in a chord are cut off by the shader of outlines, too.
bool need_outlines(const std::vector<FieldInstance>& fields) {
    return std::any_of(fields.begin(), fields.end(),
                       [](const FieldInstance& field) { return field.line.x > 0 || field.line.y < 0; });
}

void clear_depth_to(float depth) {
#ifdef BRAITENLAB_OPENGL_ES
    glClearDepthf(depth);
#else
    glClearDepth(static_cast<double>(depth));
#endif
}

void set_viewport(const Rect& window) {
    glViewport(static_cast<GLint>(window.x), static_cast<GLint>(window.y), static_cast<GLsizei>(window.w),
               static_cast<GLsizei>(window.h));
}

// `part`: pixels of the window with y down; `share`: as Picture::resolution.
void set_scissor(const Rect& part, const Rect& window, float share) {
    const auto pixel = [share](float at) { return static_cast<GLint>(std::lround(at * share)); };
    const GLint left = pixel(window.x + part.x), right = pixel(window.x + part.x + part.w);
    const GLint high = pixel(window.y + window.h - part.y), low = pixel(window.y + window.h - part.y - part.h);
    glScissor(left, low, right - left, high - low);
}

template <class Instance>
std::uint64_t hash_of(const std::vector<Instance>& instances) {
    return std::hash<std::string_view>()(
        {reinterpret_cast<const char*>(instances.data()), instances.size() * sizeof(Instance)});
}

struct ContourInstance {
    maths::vec4 place;   // half the arena's size; samples along x and y
    maths::vec4 colour;  // w: side of the texture, samples
};

}  // namespace

struct Renderer::Parts {
    Programs with;
    std::filesystem::path folder;
    SectorPath path = SectorPath::automatic;
    std::filesystem::file_time_type shaders_changed;

    bool copied = draws_instances_one_by_one();
    template <class Instance>
    Kit kit(const Shape& shape) const {
        return Kit(shape, vectors<Instance>, copied);
    }

    Kit floors = kit<FloorInstance>(quad());
    StoredPicture backdrop;  // the ground
    StoredPicture whole{3};  // the scene without its labels
    Resampling resampling;
    Kit blocks = kit<BlockInstance>(prism());
    Batch skirts{skirt(), blocks.instances};
    Kit zones = kit<ZoneInstance>(quad());
    std::array<Kit, role_count> hulls = by_role([&](Role role) { return kit<HullInstance>(hull_shape(role)); });
    std::array<Kit, role_count> signs = by_role([&](Role role) { return kit<SignInstance>(sign_shape(role)); });
    const Instances& hulls_of(Role role) const { return hulls[static_cast<std::size_t>(role)].instances; }
    std::array<Batch, role_count> rims = by_role([&](Role role) { return Batch(rim_shape(role), hulls_of(role)); });
    Kit wheels = kit<WheelInstance>(wheel_shape());
    Kit eyes = kit<EyeInstance>(quad());
    std::array<Batch, role_count> coarse_hulls =
        by_role([&](Role role) { return Batch(hull_shape(role, Mesh::coarse), hulls_of(role)); });
    Batch coarse_wheels{wheel_shape(Mesh::coarse), wheels.instances};
    std::array<Kit, role_count> bodies = by_role([&](Role role) { return kit<HullInstance>(fine_hull_shape(role)); });
    Kit tyres = kit<WheelInstance>(tyre_shape());
    Kit eyeballs = kit<EyeballInstance>(eyeball_shape());
    Kit casts = kit<CastInstance>(quad());
    Kit wires = kit<WireInstance>(strip(12));
    Batch coarse_wires{wire_strip(), wires.instances};
    Kit neurons = kit<NeuronInstance>(quad());
    Kit deck_shades = kit<DeckShadeInstance>(quad());
    Kit contours = kit<ContourInstance>(quad());
    Kit letters = kit<LetterInstance>(quad());
    Texture intensities{Texture::Kind::numbers, sensing::Intensity::most_columns, sensing::Intensity::most_rows};
    Texture characters{Texture::Kind::bytes, Lettering::side, Lettering::side};
    Kit fields = kit<FieldInstance>(fan());
    Batch field_points = Batch::points(fields.instances);
    Kit marks = kit<MarkInstance>(quad());
    Kit rings = kit<MarkInstance>(quad());
    std::array<Kit, source_shape_count> sources =
        by_source([&](Channel channel) { return kit<SourceInstance>(source_shape(channel)); });
    std::array<Batch, source_shape_count> fine_sources = by_source([&](Channel channel) {
        return Batch(fine_source_shape(channel), sources[static_cast<std::size_t>(source_shape_of(channel))].instances);
    });
    Kit halos = kit<HaloInstance>(quad());
    Kit trail_strips = kit<TrailInstance>(strip(4));
    Batch coarse_trails{strip(1), trail_strips.instances};

    unsigned frame_buffer = 0;
    DrawList list;
    Trails trails;
    sensing::IntensityMap intensity;
    std::vector<ContourInstance> contour;
    std::optional<Lettering> lettering;
    std::vector<LetterInstance> type;
    std::vector<FloorInstance> floor_size{1};
    bool walled = true;  // has_walls()
    int calls = 0;
    double seconds = -1;                // of the last snapshot
    float resolution = 1;               // of the last picture
    bool reused = false;                // the last picture was one of `whole`
    std::uint64_t lettered = 0;         // hash of the last picture's labels
    std::vector<Rect> hidden, visible;  // of the picture; see find_visible

    Parts() {
        glGenBuffers(1, &frame_buffer);
        glBindBuffer(GL_UNIFORM_BUFFER, frame_buffer);
        glBufferData(GL_UNIFORM_BUFFER, sizeof(FrameBlock), nullptr, GL_DYNAMIC_DRAW);
    }
    ~Parts() { glDeleteBuffers(1, &frame_buffer); }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    // Copies the frame block to the graphics memory.
    void upload(const FrameBlock& frame) {
        glBindBuffer(GL_UNIFORM_BUFFER, frame_buffer);
        glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(frame), &frame);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_buffer);
    }

    // Copies the draw list to the graphics memory, once per frame. `frame`: its arena is used. Returns a hash of the
    // instances of the scene; 0 unless `hashed`.
    std::uint64_t upload_list(const FrameBlock& frame, bool hashed) {
        std::uint64_t hash = 0;
        const auto upload = [&](Instances& to, const auto& instances) {
            to.upload(instances);
            if (hashed) hash = 31 * hash + hash_of(instances);
        };
        // Beyond this distance the ground has faded into the sky.
        const float beyond = floor_fade * std::max(frame.arena.x, frame.arena.y);
        floor_size[0].half_size = {frame.arena.x + beyond, frame.arena.y + beyond, beyond, 0};
        upload(floors.instances, floor_size);
        upload(blocks.instances, list.blocks);
        upload(zones.instances, list.zones);
        for (std::size_t role = 0; role < hulls.size(); ++role) upload(hulls[role].instances, list.hulls[role]);
        for (std::size_t role = 0; role < signs.size(); ++role) upload(signs[role].instances, list.signs[role]);
        upload(wheels.instances, list.wheels);
        upload(eyes.instances, list.eyes);
        for (std::size_t role = 0; role < bodies.size(); ++role) upload(bodies[role].instances, list.bodies[role]);
        upload(tyres.instances, list.tyres);
        upload(eyeballs.instances, list.eyeballs);
        upload(casts.instances, list.casts);
        upload(wires.instances, list.wires);
        upload(neurons.instances, list.neurons);
        upload(deck_shades.instances, list.deck_shades);
        upload(contours.instances, contour);
        letters.instances.upload(type);
        upload(fields.instances, list.fields);
        upload(marks.instances, list.marks);
        upload(rings.instances, list.rings);
        for (std::size_t i = 0; i < sources.size(); ++i) upload(sources[i].instances, list.sources[i]);
        upload(halos.instances, list.halos);
        upload(trail_strips.instances, list.trails);
        return hash;
    }

    void draw(const Program& program, const Batch& batch, const Instances& instances) {
        if (instances.count() == 0) return;
        program.use();
        calls += batch.draw(instances);
    }
    void draw(const Program& program, const Kit& kit) { draw(program, kit.batch, kit.instances); }

    void draw_solids(Quality quality) {
        draw(with.block, blocks);
        for (std::size_t role = 0; role < hulls.size(); ++role)
            draw(with.hull, list.coarse ? coarse_hulls[role] : hulls[role].batch, hulls[role].instances);
        for (const Kit& of_role : signs) draw(with.sign, of_role);
        draw(with.wheel, list.coarse ? coarse_wheels : wheels.batch, wheels.instances);
        draw(with.eye, eyes);
        for (const Kit& of_role : bodies) draw(with.hull, of_role);
        draw(with.wheel, tyres);
        draw(with.eyeball, eyeballs);
        for (std::size_t i = 0; i < sources.size(); ++i)
            draw(with.source, quality == Quality::low ? sources[i].batch : fine_sources[i], sources[i].instances);
        draw(with.wire, list.coarse && !has_rounded(list) ? coarse_wires : wires.batch, wires.instances);
        draw(with.neuron, neurons);
    }

    void draw_ground() {
        draw(list.floor_lamps > 0 ? with.lamplit : with.floor, floors);
        if (walled) return;
        glEnable(GL_BLEND);
        draw(with.brink, floors);
        glDisable(GL_BLEND);
    }

    // Draws the ground into the backdrop.
    void paint_backdrop(const FrameBlock& frame) {
        upload(backdrop.begin_painting());
        glClear(GL_COLOR_BUFFER_BIT);
        draw_ground();
        backdrop.end_painting();
        upload(frame);
    }

    // Draws the ground with fewer pixels and enlarges it to the visible parts of the viewport. False, and nothing is
    // drawn, where the framebuffer has several samples. Changes the viewport, the frame block and the state of blending
    // and of the depth test.
    bool draw_coarse_ground(const FrameBlock& frame, const Rect& window) {
        constexpr float share = 0.5f;
        if (!resampling.begin_coarse(window, share)) return false;
        upload(at_resolution(frame, share));
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        leave_out_hidden(window, share);
        draw_ground_below();
        resampling.end();
        set_viewport(window);
        upload(frame);
        enlarge(window);
        return true;
    }

    // Draws the ground after all solid objects, so hidden parts of it are not shaded. It writes no depth: flat marks on
    // it do not flicker and halos that reach into it are not cut.
    void draw_ground_below() {
        glDepthMask(GL_FALSE);
        draw_ground();
        glDepthMask(GL_TRUE);
    }

    // Prepares the contours of overlays.field and their labels. Does nothing without a channel.
    void prepare_contours(const Snapshot& now, const Picture& picture) {
        contour.clear();
        if (!picture.settings.overlays.field || !now.scene) return;
        const Channel channel = *picture.settings.overlays.field;
        const sensing::Intensity& grid = intensity.grid();
        if (intensity.update(intensity_input(now, channel, picture.settings.selection.vehicle))) {
            intensities.fill(0, grid.columns, grid.rows, grid.values.data());
            whole.forget();
        }
        const Palette colours = palette(picture.theme);
        const Colour c = colour_of(colours, channel);
        const Arena& arena = now.scene->arena;
        contour.push_back(
            {{arena.width / 2, arena.height / 2, static_cast<float>(grid.columns), static_cast<float>(grid.rows)},
             {c.r, c.g, c.b, static_cast<float>(sensing::Intensity::most_columns)}});
        if (picture.settings.overlays.labels) add_level_labels(list, grid, arena, colours.text, picture.decimal_mark);
    }

    // Prepares the characters of the labels.
    void prepare_letters(const Picture& picture) {
        type.clear();
        if (!lettering) return;
        set_type(type, list.labels, *lettering, picture, list.label_space);
        const auto [first, end] = lettering->take_changes();
        if (first < end)
            characters.fill(first, Lettering::side, end - first,
                            lettering->sheet().data() + static_cast<std::size_t>(first) * Lettering::side);
    }

    void draw_flat() {
        glDepthMask(GL_FALSE);
        glDisable(GL_CULL_FACE);
        glEnable(GL_BLEND);
        draw(with.zone, zones);
        intensities.bind();
        draw(with.contour, contours);
        draw(with.skirt, skirts, blocks.instances);
        draw(with.cast, casts);
        draw(with.shade, marks);
        draw(with.deck_shade, deck_shades);
        draw(with.trail, has_rounded(list) ? trail_strips.batch : coarse_trails, trail_strips.instances);
        draw(need_outlines(list.fields) ? with.outlined : with.field,
             with.sectors_from_points ? field_points : fields.batch, fields.instances);
        for (std::size_t role = 0; role < rims.size(); ++role)
            if (has_rims(list.hulls[role])) draw(with.rim, rims[role], hulls[role].instances);
        draw(with.mark, rings);
        draw(with.halo, halos);
        glDepthMask(GL_TRUE);
    }

    // The parts of the picture that are copied. Only what hides much is left out: each part is a call of its own.
    void find_visible(const Picture& picture) {
        constexpr float least_share = 1.0f / 32;
        hidden = hidden_parts(picture);
        const Rect& window = picture.camera_view.window;
        std::vector<Rect> large = hidden;
        std::erase_if(large, [&](const Rect& r) { return r.w * r.h < least_share * window.w * window.h; });
        visible = visible_parts({0, 0, window.w, window.h}, large);
    }

    // Nothing passes the depth test in what is hidden. `share`: pixels drawn per pixel of the window, in width and in
    // height.
    void leave_out_hidden(const Rect& window, float share) const {
        glEnable(GL_SCISSOR_TEST);
        clear_depth_to(0);
        for (const Rect& part : hidden) {
            set_scissor(part, window, share);
            glClear(GL_DEPTH_BUFFER_BIT);
        }
        clear_depth_to(1);
        glDisable(GL_SCISSOR_TEST);
    }

    // Draws everything but the labels, with `resolution` of the picture's pixels. Afterwards the frame block is that of
    // all pixels.
    void draw_scene(const FrameBlock& frame, const Picture& picture) {
        const Rect& window = picture.camera_view.window;
        const bool coarse = resolution < 1 && resampling.begin_coarse(window, resolution);
        const FrameBlock drawn = coarse ? at_resolution(frame, resolution) : frame;
        upload(drawn);
        const bool smooth = !coarse && picture.quality == Quality::high && resampling.begin_smooth(window);
        // OpenGL 3.3 copies into several samples per pixel only from an identical format, OpenGL ES 3.0 not at all.
        const auto ground = smooth ? StoredPicture::Content::moves : backdrop.look(ground_of(drawn));
        const bool in_backdrop = ground != StoredPicture::Content::moves;
        if (ground == StoredPicture::Content::rests) paint_backdrop(drawn);
        const bool below =
            !in_backdrop && !coarse && !smooth && picture.coarse_ground && draw_coarse_ground(drawn, window);
        glEnable(GL_DEPTH_TEST);
        glClear(in_backdrop || below ? GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        // The copy comes before all draw calls: a software renderer waits for those before it.
        const Rect all{0, 0, drawn.window.x, drawn.window.y};
        if (in_backdrop) backdrop.copy(coarse ? std::span(&all, 1) : std::span<const Rect>(visible));
        leave_out_hidden(window, coarse ? resolution : 1);
        draw_solids(picture.quality);
        if (!in_backdrop && !below) draw_ground_below();
        draw_flat();
        resampling.end();
        if (!coarse) return;
        set_viewport(window);
        upload(frame);
        enlarge(window);
    }

    // Draws the visible parts of the coarse picture over the viewport. SwiftShader takes twice the time for a copy that
    // changes the size.
    void enlarge(const Rect& window) {
        glDisable(GL_BLEND);
        glDisable(GL_DEPTH_TEST);
        resampling.coarse().bind();
        glEnable(GL_SCISSOR_TEST);
        set_scissor({0, 0, window.w, window.h}, window, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        for (const Rect& part : visible) {
            set_scissor(part, window, 1);
            draw(with.enlarge, floors);
        }
        glDisable(GL_SCISSOR_TEST);
    }

    // The state in which everything is drawn.
    void begin_picture(const Picture& picture) {
        const Rect& window = picture.camera_view.window;
        set_viewport(window);
        glDisable(GL_SCISSOR_TEST);
        glDepthMask(GL_TRUE);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        const Colour sky = palette(picture.theme).sky;
        glClearColor(sky.r, sky.g, sky.b, 1);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glEnable(GL_CULL_FACE);
        glCullFace(GL_BACK);
        glFrontFace(GL_CCW);
        glDisable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
        // Premultiplied colours: alpha 0 adds light, alpha 1 covers.
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    }

    void draw_letters() {
        glDisable(GL_CULL_FACE);
        glEnable(GL_BLEND);
        glDisable(GL_DEPTH_TEST);
        characters.bind();
        draw(with.letter, letters);
    }
};

Result<Renderer> Renderer::create(const std::filesystem::path& shader_folder, SectorPath sectors) {
    auto parts = std::make_unique<Parts>();
    if (auto error = parts->with.load(shader_folder, sectors)) return *error;
    parts->folder = shader_folder, parts->path = sectors, parts->shaders_changed = newest_change(shader_folder);
    return Renderer(std::move(parts));
}

std::optional<Error> Renderer::follow_shaders() {
    const auto changed = newest_change(parts_->folder);
    if (changed == parts_->shaders_changed) return std::nullopt;
    parts_->shaders_changed = changed;
    Programs fresh;
    if (auto error = fresh.load(parts_->folder, parts_->path)) return error;
    parts_->with = std::move(fresh);
    parts_->backdrop.forget(), parts_->whole.forget();
    return std::nullopt;
}

void Renderer::use_lettering(Lettering lettering) { parts_->lettering = std::move(lettering); }

Renderer::Renderer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

void Renderer::remember(const Snapshot& now) { parts_->trails.record(now); }

bool Renderer::draw(const Snapshot& now, const Picture& picture) {
    Parts& p = *parts_;
    p.calls = 0;
    remember(now);
    fill(p.list, now, picture, p.trails);
    p.walled = !now.scene || has_walls(now.scene->arena.edge);
    p.prepare_contours(now, picture);
    p.prepare_letters(picture);

    const FrameBlock frame = frame_block(now, picture, p.list);
    // Graphics hardware, whose windows have several samples, needs no copy.
    const bool has_single_samples = p.resampling.samples_of_window() == 0;
    const bool may_rest = picture.copied_at_rest && has_single_samples && p.seconds == now.seconds;
    p.seconds = now.seconds;
    const std::uint64_t instances = p.upload_list(frame, may_rest) + hash_of(picture.opaque);
    const auto content = may_rest ? p.whole.look(frame, instances) : StoredPicture::Content::moves;
    p.resolution = content == StoredPicture::Content::moves ? picture.resolution : 1;
    p.reused = content == StoredPicture::Content::kept;
    const std::uint64_t labels = hash_of(p.type), labels_before = std::exchange(p.lettered, labels);
    if (p.reused && picture.may_stay && labels == labels_before) return false;
    p.begin_picture(picture);
    p.find_visible(picture);
    if (p.reused) {
        glClear(GL_DEPTH_BUFFER_BIT);  // as copy() demands
        p.whole.copy(p.visible);
        p.upload(frame);
    } else {
        p.draw_scene(frame, picture);
    }
    if (content == StoredPicture::Content::rests) p.whole.store();
    p.draw_letters();

    // Restore default GL state for Dear ImGui.
    glBindVertexArray(0);
    glUseProgram(0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    return true;
}

void Renderer::draw_still(const Snapshot& now, const Picture& picture) {
    Trails kept = std::exchange(parts_->trails, Trails{});
    draw(now, picture);
    parts_->trails = std::move(kept);
}

void Renderer::finish() {
    glFinish();
#ifdef BRAITENLAB_OPENGL_ES  // WebGL's glFinish does not wait; reading a pixel does
    std::uint8_t pixel[4];
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
#endif
}

int Renderer::draw_calls() const { return parts_->calls; }

float Renderer::resolution() const { return parts_->resolution; }

bool Renderer::reused() const { return parts_->reused; }

bool Renderer::sectors_from_points() const { return parts_->with.sectors_from_points; }

}  // namespace braitenlab::render
