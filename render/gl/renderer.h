// Draws a snapshot with OpenGL 3.3 core into the framebuffer that is bound.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/result.h"
#include "core/world/snapshot.h"
#include "render/text/lettering.h"
#include "render/view/picture.h"

namespace braitenlab::render {

// How sensor fields get their corners: from one point each by a geometry shader, or as instances of a mesh where there
// are no geometry shaders (WebGL). Both give the same picture. Automatic takes geometry shaders where it can.
enum class SectorPath { automatic, geometry, instanced };

class Renderer {
public:
    // Needs a current context of OpenGL 3.3 with its functions loaded. Reads the shaders from a folder; an error names
    // the shader's file and line. Asking for SectorPath::geometry fails where the driver has no geometry shaders.
    static Result<Renderer> create(const std::filesystem::path& shader_folder,
                                   SectorPath sectors = SectorPath::automatic);

    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    // Reads the shaders again if a file of theirs has changed since the last time. Where one is broken all stay as they
    // were, and the error names its file and line.
    std::optional<Error> follow_shaders();

    // Draws labels with these characters from the next frame on; until then, none.
    void use_lettering(Lettering);

    // Notes where the vehicles are, for their trails. draw() does so by itself; this is for moments that nobody sees.
    void remember(const Snapshot&);

    // Clears and draws everything. One draw call per kind of thing, however many there are.
    void draw(const Snapshot&, const Picture&);

    // Of the last draw().
    int draw_calls() const;

    // Whether geometry shaders make the sensor fields.
    bool sectors_from_points() const;

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts>);
    std::unique_ptr<Parts> parts_;
};

}  // namespace braitenlab::render
