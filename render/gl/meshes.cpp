#include "render/gl/meshes.h"

#include <utility>

namespace braitenlab::render {

Shape quad() {
    Shape shape;
    for (const auto& [x, y] : {std::pair{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}})
        shape.corners.push_back({{x, y, 0}, {0, 0, 1}, 0});
    shape.indices = {0, 1, 2, 0, 2, 3};
    return shape;
}

Shape strip(int squares) {
    Shape shape;
    for (int i = 0; i <= squares; ++i)
        for (const float y : {-1.0f, 1.0f})
            shape.corners.push_back({{static_cast<float>(i) / static_cast<float>(squares), y, 0}, {0, 0, 1}, 0});
    for (int i = 0; i < squares; ++i)
        for (const int k : {0, 2, 3, 0, 3, 1}) shape.indices.push_back(static_cast<std::uint16_t>(2 * i + k));
    return shape;
}

Shape fan() {
    Shape shape;
    for (const float i : {0.0f, 1.0f, 2.0f, 3.0f}) shape.corners.push_back({{i, 0, 0}, {0, 0, 1}, 0});
    shape.indices = {0, 1, 2, 0, 2, 3};
    return shape;
}

Shape prism() {
    Shape shape;
    const auto corner = [&](int edge, int end, int level) {
        shape.corners.push_back(
            {{static_cast<float>(edge), static_cast<float>(end), static_cast<float>(level)}, {}, 0});
    };
    for (int edge = 0; edge < 8; ++edge) {
        const auto first = static_cast<int>(shape.corners.size());
        for (const auto& [low, high] : {std::pair{0, 1}, {2, 3}})
            for (const auto& [end, level] : {std::pair{0, low}, {1, low}, {1, high}, {0, high}})
                corner(edge, end, level);
        for (const int k : {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7})
            shape.indices.push_back(static_cast<std::uint16_t>(first + k));
    }
    const auto top = static_cast<int>(shape.corners.size());
    for (int edge = 0; edge < 8; ++edge) corner(edge, 0, 4);
    for (int edge = 1; edge < 7; ++edge)
        for (const int k : {0, edge, edge + 1}) shape.indices.push_back(static_cast<std::uint16_t>(top + k));
    return shape;
}

Shape skirt() {
    Shape shape;
    for (int edge = 0; edge < 8; ++edge) {
        for (const auto& [end, level] : {std::pair{0, -2}, {1, -2}, {1, -1}, {0, -1}})
            shape.corners.push_back(
                {{static_cast<float>(edge), static_cast<float>(end), static_cast<float>(level)}, {}, 0});
        for (const int k : {0, 1, 2, 0, 2, 3}) shape.indices.push_back(static_cast<std::uint16_t>(4 * edge + k));
    }
    return shape;
}

}  // namespace braitenlab::render
