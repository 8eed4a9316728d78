// How much two paths on the floor differ, without regard to the time at which they are driven.
#pragma once

#include <span>
#include <vector>

#include "core/lesson/goal.h"
#include "core/maths/vec.h"

namespace braitenlab {

// Mean distance in m: of the points of each path, in equal steps along it, to the nearest point of the other, and then
// of both means (the modified Hausdorff distance of Dubuisson and Jain, 1994, with the mean of both directions). 0 for
// equal paths, also if one of them goes round twice. A path of one point is a place. 0 if a path is empty. A path is
// compared at `most_points` points at most: a long path in larger steps. The time is proportional to its square.
float path_distance(std::span<const maths::vec2> a, std::span<const maths::vec2> b, std::size_t most_points = 1000);

// True if the paths run the opposite way where they are close to each other: in the mean over both, the direction of a
// path is against that of the other one at the nearest point. False if a path has no direction.
bool runs_against(std::span<const maths::vec2> a, std::span<const maths::vec2> b);

// The positions of every `step`th pose of the first `count`, and the last of them. Precondition: step > 0.
std::vector<maths::vec2> positions(const ReferencePath&, std::size_t count, std::size_t step);

// Length in m.
float path_length(std::span<const maths::vec2>);

}  // namespace braitenlab
