// What the commands that edit a running world's scene have in common. Inside core/world only.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/scene/scene_file.h"
#include "core/world/state.h"

namespace braitenlab {

// Puts an edited scene in the place of the old one and makes the world again from it.
inline void take_over(WorldState& s, Scene scene) {
    Moment moment = std::move(static_cast<Moment&>(s));
    moment.scene = std::make_shared<const Scene>(std::move(scene));
    s = WorldState(std::move(moment));
}

inline std::optional<Error> take_over_if_sound(WorldState& s, Scene scene) {
    if (auto error = check_scene(scene)) return error;
    take_over(s, std::move(scene));
    return std::nullopt;
}

template <class Thing>
std::optional<Error> missing(const std::vector<Thing>& things, int index, const char* what) {
    if (index >= 0 && static_cast<std::size_t>(index) < things.size()) return std::nullopt;
    return Error{fmt::format("the scene has no {} number {}", what, index)};
}

template <class Thing>
auto place_in(std::vector<Thing>& things, int index) {
    return things.begin() + static_cast<std::ptrdiff_t>(index);
}

// Where something new goes: before the one that is named, else at the end.
template <class Thing>
int place_for(const std::vector<Thing>& things, int before) {
    const auto count = static_cast<int>(things.size());
    return before < 0 ? count : std::min(before, count);
}

// The name itself where it is given and free, else the word with the lowest number that makes it so.
template <class Thing>
std::string free_name(const std::vector<Thing>& things, const std::string& wished, std::string_view word) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(things.begin(), things.end(), [&](const Thing& t) { return t.name == name; });
    };
    if (!wished.empty() && !taken(wished)) return wished;
    std::string name(word);
    for (int number = 2; taken(name); ++number) name = fmt::format("{}-{}", word, number);
    return name;
}

}  // namespace braitenlab
