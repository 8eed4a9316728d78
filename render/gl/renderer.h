// Draws a snapshot with OpenGL 3.3 core into the bound framebuffer.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/result.h"
#include "core/world/snapshot.h"
#include "render/text/lettering.h"
#include "render/view/picture.h"

namespace braitenlab::render {

// How sensor fields are drawn: one point each, expanded by a geometry shader, or instances of a mesh where there are no
// geometry shaders (WebGL). Both give the same picture. `automatic` uses geometry shaders where the driver has them.
enum class SectorPath { automatic, geometry, instanced };

class Renderer {
public:
    // Precondition: an OpenGL 3.3 context is current and its functions are loaded. Reads the shaders from a folder.
    // Errors: a shader is missing or does not compile (with file and line); SectorPath::geometry without geometry
    // shaders.
    static Result<Renderer> create(const std::filesystem::path& shader_folder,
                                   SectorPath sectors = SectorPath::automatic);

    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    // Reloads the shaders when a file in their folder has changed since the last call. After an error (with file and
    // line) the previous shaders stay in use; the error is returned once per change.
    std::optional<Error> follow_shaders();

    // Sets the characters of labels, from the next frame on. Labels are not drawn before the first call.
    void use_lettering(Lettering);

    // Records the positions of the vehicles for their trails. draw() calls it; call it for snapshots that are not
    // drawn.
    void remember(const Snapshot&);

    // Clears the framebuffer and draws the snapshot. The number of draw calls does not depend on the number of
    // vehicles. Returns false without drawing if the last picture stays; see Picture::may_stay.
    bool draw(const Snapshot&, const Picture&);

    // As draw(), without paths; the paths recorded so far stay.
    void draw_still(const Snapshot&, const Picture&);

    // Waits until everything is drawn.
    void finish();

    // Number of draw calls of the last draw().
    int draw_calls() const;

    // Of the last draw(): pixels drawn per pixel of the window, in width and in height; 1 for a copied picture.
    float resolution() const;
    // True if the last draw() copied the picture of the scene; see Picture::copied_at_rest.
    bool reused() const;

    // True when geometry shaders draw the sensor fields.
    bool sectors_from_points() const;

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts>);
    std::unique_ptr<Parts> parts_;
};

}  // namespace braitenlab::render
