#include "render/gl/programs.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "render/gl/opengl.h"

namespace braitenlab::render {

namespace {

// True when the current context has geometry shaders.
bool has_geometry_shaders() {
#ifdef BRAITENLAB_OPENGL_ES
    return false;
#else
    GLint most = 0;
    if (GLEW_VERSION_3_2) glGetIntegerv(GL_MAX_GEOMETRY_OUTPUT_VERTICES, &most);
    return most >= 4;
#endif
}

std::optional<Error> load_sectors(Programs& programs, const std::filesystem::path& folder, SectorPath path) {
    const bool can = has_geometry_shaders();
    if (path == SectorPath::geometry && !can)
        return Error{"this graphics driver has no geometry shaders; leave out --sectors=geometry"};
    programs.sectors_from_points = path == SectorPath::geometry || (path == SectorPath::automatic && can);
    for (const auto& [program, fragment] :
         {std::pair{&programs.field, "field.frag"}, {&programs.outlined, "outlined.frag"}}) {
        auto loaded = programs.sectors_from_points ? Program::load(folder, "sector.vert", fragment, "sector.geom")
                                                   : Program::load(folder, "field.vert", fragment);
        if (!loaded) return loaded.error();
        *program = std::move(*loaded);
    }
    return std::nullopt;
}

}  // namespace

std::optional<Error> Programs::load(const std::filesystem::path& folder, SectorPath path) {
    struct Stages {
        Program* program;
        const char* vertex;
        const char* fragment;
    };
    const Stages all[] = {{&floor, "floor", "floor"},
                          {&brink, "floor", "brink"},
                          {&zone, "zone", "zone"},
                          {&contour, "contour", "contour"},
                          {&block, "block", "block"},
                          {&skirt, "block", "skirt"},
                          {&hull, "hull", "hull"},
                          {&rim, "rim", "rim"},
                          {&sign, "sign", "sign"},
                          {&wheel, "wheel", "wheel"},
                          {&eye, "eye", "eye"},
                          {&wire, "wire", "wire"},
                          {&neuron, "neuron", "neuron"},
                          {&deck_shade, "neuron", "deck_shade"},
                          {&source, "source", "source"},
                          {&shade, "mark", "shade"},
                          {&mark, "mark", "mark"},
                          {&trail, "trail", "trail"},
                          {&halo, "halo", "halo"},
                          {&letter, "letter", "letter"},
                          {&eyeball, "eyeball", "eyeball"},
                          {&cast, "cast", "cast"},
                          {&lamplit, "floor", "lamplit"},
                          {&enlarge, "enlarge", "enlarge"}};
    for (const auto& [program, vertex, fragment] : all) {
        auto loaded = Program::load(folder, std::string(vertex) + ".vert", std::string(fragment) + ".frag");
        if (!loaded) return loaded.error();
        *program = std::move(*loaded);
    }
    return load_sectors(*this, folder, path);
}

std::filesystem::file_time_type newest_change(const std::filesystem::path& folder) {
    auto newest = std::filesystem::file_time_type::min();
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (const auto changed = entry.last_write_time(ignored); !ignored) newest = std::max(newest, changed);
    return newest;
}

}  // namespace braitenlab::render
