// Which kinds of a scene get the champions of a match.
#pragma once

#include <algorithm>
#include <optional>

#include "core/evolve/breeding.h"
#include "core/scene/subject.h"

namespace braitenlab::evolve {

// The first kind with each role, as indices. −1: this side gets no champion, because it does not evolve or, in an
// exercise, is not the student's. Nullopt if the scene lacks a role, hides the brain of such a kind or would get no
// champion.
inline std::optional<BySide<int>> kinds_for_champions(const BreedingBase& base, const Scene& scene, bool is_exercise) {
    BySide<int> kinds{};
    bool any = false;
    for (const Side side : both_sides) {
        const auto found = std::find_if(scene.kinds.begin(), scene.kinds.end(),
                                        [side](const Kind& kind) { return kind.role == role_of(side); });
        if (found == scene.kinds.end() || found->hidden) return std::nullopt;
        const int index = static_cast<int>(found - scene.kinds.begin());
        const bool gets_one = base.breed(side) && (!is_exercise || index == subject_kind(scene));
        at(kinds, side) = gets_one ? index : -1;
        any |= gets_one;
    }
    return any ? std::optional(kinds) : std::nullopt;
}

}  // namespace braitenlab::evolve
