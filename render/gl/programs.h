// Every program of the scene, each for a kind of thing.
#pragma once

#include <filesystem>
#include <optional>

#include "render/gl/renderer.h"
#include "render/gl/shader.h"

namespace braitenlab::render {

struct Programs {
    Program floor, brink, backdrop, zone, contour, block, skirt, hull, sign, rim, wheel, eye, wire, neuron, field,
        shade, mark, source, halo, trail, letter;
    bool sectors_from_points = false;

    // Compiles all of them; after an error some may be missing.
    std::optional<Error> load(const std::filesystem::path& folder, SectorPath);
};

// When a file of the folder was last written; the beginning of time for none.
std::filesystem::file_time_type newest_change(const std::filesystem::path& folder);

}  // namespace braitenlab::render
