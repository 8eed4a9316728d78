// What Dear ImGui has drawn in a frame.
#pragma once

#include <cstdint>
#include <optional>

struct ImDrawData;

namespace braitenlab::ui {

// A hash of all triangles, with the parts that clip them and their textures. nullopt while a texture changes. Call
// between ImGui::Render() and the next frame.
std::optional<std::uint64_t> hash_of_drawn(const ImDrawData&);

}  // namespace braitenlab::ui
