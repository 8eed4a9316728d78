// Where the arrow keys lead from one thing on the canvas to the next.
#pragma once

#include "ui/wiring/hit.h"

namespace braitenlab {

enum class Towards { left, right, up, down };

// The node or wire's label that lies that way, the nearest counting what lies aside more than twice; `from` itself when
// nothing does. From nothing: the node nearest to the upper left corner. Nodes alone when asked for.
Hit next_towards(const Layout&, const Hit& from, Towards, bool nodes_only = false);

// Its middle, canvas units; nothing for a thing that is gone.
std::optional<maths::vec2> middle_of(const Layout&, const Hit&);

}  // namespace braitenlab
