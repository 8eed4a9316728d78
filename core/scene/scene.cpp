#include "core/scene/scene.h"

#include <algorithm>

namespace braitenlab {

namespace {

template <class Named>
int find_named(const std::vector<Named>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

}  // namespace

int find_kind(const Scene& scene, const std::string& name) { return find_named(scene.kinds, name); }
int find_source(const Scene& scene, const std::string& name) { return find_named(scene.sources, name); }

std::vector<std::string> sensor_names(const Kind& kind) {
    std::vector<std::string> names;
    names.reserve(kind.sensors.size());
    for (const Sensor& sensor : kind.sensors) names.push_back(sensor.name);
    return names;
}

}  // namespace braitenlab
