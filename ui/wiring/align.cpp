#include "ui/wiring/align.h"

#include <algorithm>

#include "core/brain/fragment.h"

namespace braitenlab {
namespace {

using maths::vec2;

constexpr float least_gap = 24;  // between cards, units

// One coordinate of a place or a size.
float& along(vec2& v, bool down) { return down ? v.y : v.x; }
float along(const vec2& v, bool down) { return down ? v.y : v.x; }

std::vector<NodeShape> sorted(const Layout& layout, const std::set<NodeId>& nodes, bool down) {
    std::vector<NodeShape> shapes;
    for (const NodeId id : nodes)
        if (const NodeShape* shape = find_shape(layout, id)) shapes.push_back(*shape);
    std::stable_sort(shapes.begin(), shapes.end(), [down](const NodeShape& a, const NodeShape& b) {
        return along(a.centre, down) < along(b.centre, down);
    });
    return shapes;
}

// All on one line across, and far enough apart along it.
void line_up(std::vector<NodeShape>& shapes, bool down) {
    float sum = 0;
    for (const NodeShape& shape : shapes) sum += along(shape.centre, !down);
    for (NodeShape& shape : shapes) along(shape.centre, !down) = sum / static_cast<float>(shapes.size());
    for (std::size_t i = 1; i < shapes.size(); ++i) {
        const float apart = (along(shapes[i - 1].size, down) + along(shapes[i].size, down)) / 2 + least_gap;
        float& at = along(shapes[i].centre, down);
        at = std::max(at, along(shapes[i - 1].centre, down) + apart);
    }
}

void spread(std::vector<NodeShape>& shapes, bool down) {
    const float first = along(shapes.front().centre, down), last = along(shapes.back().centre, down);
    const auto gaps = static_cast<float>(shapes.size() - 1);
    for (std::size_t i = 1; i + 1 < shapes.size(); ++i)
        along(shapes[i].centre, down) = first + (last - first) * static_cast<float>(i) / gaps;
}

}  // namespace

Places put_in_order(const Layout& layout, const std::set<NodeId>& nodes, Order order) {
    const bool down = order == Order::column || order == Order::even_down;
    const bool even = order == Order::even_down || order == Order::even_across;
    std::vector<NodeShape> shapes = sorted(layout, nodes, down);
    if (shapes.size() < (even ? 3u : 2u)) return {};
    if (even)
        spread(shapes, down);
    else
        line_up(shapes, down);
    Places places;
    for (const NodeShape& shape : shapes) places[shape.id] = rounded_position(shape.centre);
    return places;
}

}  // namespace braitenlab
