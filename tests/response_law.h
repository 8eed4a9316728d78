// The graded response of a sensor, written once more for comparison with the product.
#pragma once

namespace braitenlab::tests {

// Reading along the sensor's axis of a source of strength 1 at `distance` metres, within the range.
// 1/(1 + (d/d0)²) · (1 − (d/range)²)², as core/scene/scene.h documents it.
inline double reading_at(double distance, double half_distance = 3, double range = 12) {
    const double near = distance / half_distance, far = distance / range;
    return (1 - far * far) * (1 - far * far) / (1 + near * near);
}

}  // namespace braitenlab::tests
