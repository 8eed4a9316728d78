// Bringing order into chosen nodes by hand.
#pragma once

#include <set>

#include "ui/wiring/layout.h"

namespace braitenlab {

enum class Order { column, row, even_down, even_across };  // one x; one y; equal gaps downwards; equal gaps rightwards

// New places for these nodes; the others keep theirs. In a column or a row cards that would cover each other are moved
// apart. Even gaps keep the two outermost where they are. Fewer than two nodes (three for even gaps): nothing.
Places put_in_order(const Layout&, const std::set<NodeId>&, Order);

}  // namespace braitenlab
