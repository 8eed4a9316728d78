// Draws a snapshot with OpenGL 3.3 core into the framebuffer that is bound.
#pragma once

#include <filesystem>
#include <memory>

#include "core/result.h"
#include "core/world/snapshot.h"
#include "render/view/picture.h"

namespace braitenlab {

class Renderer {
public:
    // Needs a current context of OpenGL 3.3 with its functions loaded. Reads the shaders from a folder; an error names
    // the shader's file and line.
    static Result<Renderer> create(const std::filesystem::path& shader_folder);

    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    // Clears and draws everything. One draw call per kind of thing, however many there are.
    void draw(const Snapshot&, const Picture&);

    // Of the last draw().
    int draw_calls() const;

private:
    struct Parts;
    explicit Renderer(std::unique_ptr<Parts>);
    std::unique_ptr<Parts> parts_;
};

}  // namespace braitenlab
