// The shader programs of the scene.
#pragma once

#include <filesystem>
#include <optional>

#include "render/gl/renderer.h"
#include "render/gl/shader.h"

namespace braitenlab::render {

struct Programs {
    Program floor, lamplit, brink, zone, contour, block, skirt, hull, sign, rim, wheel, eye, eyeball, cast, wire,
        neuron, deck_shade, field, outlined, shade, mark, source, halo, trail, letter, enlarge;
    bool sectors_from_points = false;

    // Compiles all programs. After an error the set is incomplete.
    std::optional<Error> load(const std::filesystem::path& folder, SectorPath);
};

// Time of the last change of any file in the folder; the minimum for an empty one.
std::filesystem::file_time_type newest_change(const std::filesystem::path& folder);

}  // namespace braitenlab::render
