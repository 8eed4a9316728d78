#include "core/sensing/intensity.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/arena.h"

namespace braitenlab::sensing {

namespace {

constexpr float most_responses = 3e5f;  // samples times stimuli of one update

}  // namespace

Sensor measuring_sensor(const Kind* kind, Channel channel) {
    Sensor sensor;
    if (kind) {
        const auto own = std::find_if(kind->sensors.begin(), kind->sensors.end(),
                                      [&](const Sensor& s) { return s.channel == channel; });
        if (own != kind->sensors.end()) sensor = *own;
    }
    sensor.name.clear();
    sensor.channel = channel;
    sensor.x = sensor.y = sensor.angle = sensor.noise = sensor.latency = 0;
    sensor.fov = 2 * maths::pi, sensor.shape = SensorShape::omni;
    if (channel == Channel::floor) sensor.response = SensorResponse::graded;
    return sensor;
}

void IntensityMap::resize_grid() {
    const Channel channel = input_.sensor.channel;
    const std::size_t blocking = is_blocked_by_obstacles(channel) ? input_.obstacles.size() : 0;
    const std::size_t wall_sides = input_.scene->arena.round ? round_corners(input_.scene->arena).size() : 4;
    const std::size_t responses =
        channel == Channel::obstacle ? input_.obstacles.size() + wall_sides : input_.stimuli.size() * (1 + blocking);
    const float samples = most_responses / static_cast<float>(std::max<std::size_t>(responses, 1));
    const float aspect = input_.scene->arena.width / input_.scene->arena.height;
    const auto side = [](float wanted, int most) { return std::clamp(static_cast<int>(wanted), 24, most); };
    grid_.columns = side(std::sqrt(samples * aspect), Intensity::most_columns);
    grid_.rows = side(std::sqrt(samples / aspect), Intensity::most_rows);
    grid_.values.resize(static_cast<std::size_t>(grid_.columns * grid_.rows));
}

bool IntensityMap::update(IntensityInput input) {
    if (grid_.columns > 0 && input == input_) return false;
    input_ = std::move(input);
    if (!input_.scene) {
        grid_ = {2, 2, {0, 0, 0, 0}};
        return true;
    }
    const Arena& arena = input_.scene->arena;
    const CompiledSensor sensor(input_.sensor);
    std::vector<mechanics::Motion> obstacles = input_.obstacles;
    if (obstacles.empty())
        for (const Obstacle& o : input_.scene->obstacles)
            obstacles.push_back(mechanics::at_rest({o.x, o.y}, o.heading));
    const Environment environment(*input_.scene, obstacles);
    StimulusGrids grids;
    StimulusGrid& stimuli = grids[static_cast<std::size_t>(sensor.channel)];
    stimuli.lay_out(arena, sensor.range);
    stimuli.fill(input_.stimuli);

    resize_grid();
    constexpr std::int32_t no_row = -2;
    std::size_t i = 0;
    for (int row = 0; row < grid_.rows; ++row)
        for (int column = 0; column < grid_.columns; ++column) {
            const float x = static_cast<float>(column) / static_cast<float>(grid_.columns - 1) - 0.5f;
            const float y = static_cast<float>(row) / static_cast<float>(grid_.rows - 1) - 0.5f;
            const SensorPose pose = sensor_pose(sensor, {x * arena.width, y * arena.height}, {1, 0});
            grid_.values[i++] = std::min(read_environment(environment, grids, sensor, pose, no_row), 1.0f);
        }
    return true;
}

}  // namespace braitenlab::sensing
