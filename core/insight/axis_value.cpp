#include "core/insight/axis_value.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/scene/scene_number.h"
#include "core/scene/sensor_edits.h"

namespace braitenlab::insight {

namespace {

// How the usual range of a value follows. share: from a fifth to the double of the present value, where it is above 0.
enum class Usual { fixed, share };
struct ValueRow {
    ValueOwner owner;
    std::string_view key;
    Usual usual;
    float from, to;
};
constexpr std::array value_rows{
    ValueRow{ValueOwner::sensors, "angle", Usual::fixed, 0, 90},
    ValueRow{ValueOwner::sensors, "field", Usual::fixed, 20, 180},
    ValueRow{ValueOwner::sensors, "range", Usual::share, 1, 20},
    ValueRow{ValueOwner::sensors, "half_distance", Usual::share, 0.5f, 8},
    ValueRow{ValueOwner::sensors, "noise", Usual::fixed, 0, 0.3f},
    ValueRow{ValueOwner::sensors, "latency", Usual::fixed, 0, 0.5f},
    ValueRow{ValueOwner::sensors, "gain_spread", Usual::fixed, 0, 0.5f},
    ValueRow{ValueOwner::body, "top_speed", Usual::share, 0.5f, 6},
    ValueRow{ValueOwner::body, "mass", Usual::share, 2, 20},
    ValueRow{ValueOwner::body, "motor_force", Usual::share, 2, 50},
    ValueRow{ValueOwner::body, "mismatch", Usual::fixed, 0, 0.3f},
    ValueRow{ValueOwner::body, "dead_band", Usual::fixed, 0, 0.5f},
    ValueRow{ValueOwner::start, "heading", Usual::fixed, -180, 180},
    ValueRow{ValueOwner::source, "strength", Usual::fixed, 0, 1},
    ValueRow{ValueOwner::arena, "ambient", Usual::fixed, 0, 0.5f},
    ValueRow{ValueOwner::arena, "friction", Usual::share, 0, 80},
    ValueRow{ValueOwner::arena, "grip", Usual::fixed, 0.1f, 1},
};

constexpr float share_of_arena = 0.9f;  // the middle of each side in which positions vary

bool is_mirrored(std::string_view key) { return key == "angle"; }

// With two significant digits.
float rounded(double value) {
    if (value == 0) return 0;
    const double step = std::pow(10, std::floor(std::log10(std::fabs(value))) - 1);
    return static_cast<float>(std::round(value / step) * step);
}

class ValueList {
public:
    explicit ValueList(const ValueSubject& subject)
        : subject_(subject),
          scene_(*subject.now.scene),
          kind_(kind_of(subject.now, subject.vehicle)),
          holder_(holder()) {}

    std::vector<AxisValue> all() {
        add_dials();
        add_rows(ValueOwner::sensors), add_rows(ValueOwner::body);
        if (subject_.vehicle.start >= 0) {
            add_place(ValueOwner::start);
            add_rows(ValueOwner::start);
        }
        for (std::size_t i = 0; i < std::min(most_offered_sources, scene_.sources.size()); ++i) {
            source_ = &scene_.sources[i];
            add_place(ValueOwner::source);
            add_rows(ValueOwner::source);
        }
        add_rows(ValueOwner::arena);
        return std::move(values_);
    }

private:
    const Start& start() const { return scene_.starts[static_cast<std::size_t>(subject_.vehicle.start)]; }

    // The table that holds the target's brain and sensors in a file.
    std::string holder() const {
        if (subject_.target.vehicle == no_vehicle) return "kind." + kind_.name;
        if (subject_.vehicle.start >= 0) return "vehicle." + start().name;
        return fmt::format("member.{}", number_in_population(subject_.now, subject_.vehicle.id));
    }

    void add_dials() {
        const FourNeurons dials = read_dials(*brain_of(subject_.now, subject_.vehicle), subject_.pair);
        for (const char* path : brain_axes) {
            const MapAxis axis = *insight::axis_of(path);
            AxisValue value{.id = path, .key = path, .source = {}, .dials = axis.dials, .paths = {}};
            value.from = axis.from, value.to = axis.to;
            value.allowed = {axis.from, axis.to};
            value.now = at(dials, axis.dials.front());
            value.is_one = std::all_of(axis.dials.begin(), axis.dials.end(),
                                       [&](Dial dial) { return at(dials, dial) == value.now; });
            if (subject_.pair == SensorPair{})
                for (const Dial dial : axis.dials)
                    value.paths.push_back(fmt::format("{}.brain.{}", holder_, name(dial)));
            values_.push_back(std::move(value));
        }
    }

    void add_rows(ValueOwner owner) {
        for (const ValueRow& row : value_rows)
            if (row.owner == owner) add(row);
    }

    void add(const ValueRow& row) {
        AxisValue value{
            .owner = row.owner, .id = {}, .key = std::string(row.key), .source = {}, .dials = {}, .paths = {}};
        std::optional<SceneNumber> number;
        switch (row.owner) {
            case ValueOwner::sensors:
                number = of_sensors(row, value);
                break;
            case ValueOwner::body:
                number = number_of(kind_.body, row.key);
                value.paths = {"kind." + kind_.name + ".body." + value.key};
                break;
            case ValueOwner::start:
                number = number_of(start(), row.key);
                value.paths = {"vehicle." + start().name + "." + value.key};
                break;
            case ValueOwner::source:
                number = number_of(*source_, row.key);
                value.source = source_->name;
                value.paths = {"source." + source_->name + "." + value.key};
                break;
            case ValueOwner::arena:
                number = number_of(scene_.arena, row.key);
                value.paths = {"arena." + value.key};
                break;
            case ValueOwner::dials:
                break;
        }
        if (!number) return;
        finish(value, *number, row);
        values_.push_back(std::move(value));
    }

    // The position on both axes, of the start or of source_.
    void add_place(ValueOwner owner) {
        const auto add_axis = [&](std::string_view key, float side) {
            const float to = rounded(share_of_arena * side / 2);
            add({owner, key, Usual::fixed, -to, to});
        };
        add_axis("x", scene_.arena.width), add_axis("y", scene_.arena.height);
    }

    // Of the pair, or of the only sensor.
    std::optional<SceneNumber> of_sensors(const ValueRow& row, AxisValue& value) const {
        const Sensor* left = find_sensor(kind_.sensors, subject_.pair.left);
        const Sensor* right = find_sensor(kind_.sensors, subject_.pair.right);
        if (!left || !right) {
            if (kind_.sensors.size() != 1) return std::nullopt;
            left = &kind_.sensors.front(), right = nullptr;
        }
        const std::string begin = holder_ + ".sensor.";
        value.paths = {begin + left->name + "." + value.key};
        const auto number = number_of(*left, row.key);
        if (!right) return number;
        const bool other_sign = is_mirrored(row.key);
        value.paths.push_back((other_sign ? "-" : "") + begin + right->name + "." + value.key);
        const double other = number_of(*right, row.key)->value;
        value.is_one = std::fabs(number->value - (other_sign ? -other : other)) < 1e-4;
        return number;
    }

    static void finish(AxisValue& value, const SceneNumber& number, const ValueRow& row) {
        constexpr std::array words{"", "sensor.", "body.", "start.", "source.", "arena."};
        static_assert(has_enumerators<ValueOwner, words.size()>());
        value.id =
            words[static_cast<std::size_t>(value.owner)] + (value.source.empty() ? "" : value.source + ".") + value.key;
        value.unit = number.unit, value.allowed = number.range;
        value.now = static_cast<float>(number.value);
        value.from = row.from, value.to = row.to;
        if (row.usual == Usual::share && number.value > 0)
            value.from = rounded(number.value / 5), value.to = rounded(number.value * 2);
        const auto low = static_cast<float>(number.range.low), high = static_cast<float>(number.range.high);
        value.from = std::clamp(std::min(value.from, value.now), low, high);
        value.to = std::clamp(std::max(value.to, value.now), low, high);
    }

    const ValueSubject& subject_;
    const Scene& scene_;
    const Kind& kind_;
    std::string holder_;
    const Source* source_ = nullptr;
    std::vector<AxisValue> values_;
};

// The last two parts of "-kind.prey.sensor.SL.angle": sensor and key.
struct SensorPath {
    bool negative;
    std::string sensor, key;
};
SensorPath sensor_path(const std::string& path) {
    const std::size_t key = path.rfind('.'), sensor = path.rfind('.', key - 1);
    return {path.front() == '-', path.substr(sensor + 1, key - sensor - 1), path.substr(key + 1)};
}

template <class Record, class Edit>
std::vector<Command> edit_of(const Record& record, std::string_view key, float value, Edit edit) {
    Record changed = record;
    if (!set_number(changed, key, static_cast<double>(value)) || changed == record) return {};
    return edit(std::move(changed));
}

std::vector<Command> set_sensors(const ValueSubject& subject, const AxisValue& axis, float value) {
    const std::vector<Sensor>& present = kind_of(subject.now, subject.vehicle).sensors;
    std::vector<Sensor> sensors = present;
    for (const std::string& path : axis.paths) {
        const SensorPath part = sensor_path(path);
        if (Sensor* sensor = find_sensor(sensors, part.sensor))
            set_number(*sensor, part.key, static_cast<double>(part.negative ? -value : value));
    }
    if (sensors == present) return {};
    return {SetSensors{subject.target, std::move(sensors)}};
}

std::vector<Command> set_start(const ValueSubject& subject, const AxisValue& axis, float value) {
    const VehicleView& vehicle = subject.vehicle;
    return edit_of(
        subject.now.scene->starts[static_cast<std::size_t>(vehicle.start)], axis.key, value, [&](Start start) {
            std::vector<Command> commands;
            const bool is_there = start.facing.empty() && start.place_spread == 0 && start.heading_spread == 0;
            if (subject.now.tick == 0 && is_there)
                commands.push_back(MoveVehicle{vehicle.id, start.x, start.y, start.heading});
            commands.push_back(EditStart{vehicle.start, std::move(start)});
            return commands;
        });
}

// Gives the part of the subject's vehicle to all that its target holds. `own`: the part of a start or a member.
template <class Part, class Own>
void place_part(Scene& scene, const ValueSubject& subject, const Part& part, Part Kind::*of_kind, Own own) {
    const std::string& kind = scene.kinds[static_cast<std::size_t>(subject.vehicle.kind)].name;
    if (subject.target.vehicle == no_vehicle) {
        for (Start& start : scene.starts)
            if (start.kind == kind) own(start).reset();
        for (Member& member : scene.members)
            if (member.kind == kind) own(member).reset();
        scene.kinds[static_cast<std::size_t>(subject.vehicle.kind)].*of_kind = part;
        return;
    }
    if (subject.vehicle.start >= 0) {
        own(scene.starts[static_cast<std::size_t>(subject.vehicle.start)]) = part;
        return;
    }
    const int number = number_in_population(subject.now, subject.vehicle.id);
    auto place = std::find_if(scene.members.begin(), scene.members.end(),
                              [&](const Member& member) { return number_of(member) >= number; });
    if (place == scene.members.end() || number_of(*place) != number)
        place = scene.members.insert(place, Member{.name = std::to_string(number), .kind = kind});
    own(*place) = part;
}

}  // namespace

std::vector<AxisValue> axis_values(const ValueSubject& subject) { return ValueList(subject).all(); }

const AxisValue* find_value(const std::vector<AxisValue>& values, std::string_view id) {
    const auto found = std::find_if(values.begin(), values.end(), [&](const AxisValue& each) { return each.id == id; });
    return found == values.end() ? nullptr : &*found;
}

MapAxis axis_of(const AxisValue& value, float from, float to) {
    MapAxis axis{.path = value.id, .dials = value.dials, .values = {}, .from = from, .to = to};
    if (value.dials.empty()) axis.values = value.paths;
    return axis;
}

std::vector<Command> commands_that_set(const ValueSubject& subject, const AxisValue& axis, float value) {
    const Scene& scene = *subject.now.scene;
    switch (axis.owner) {
        case ValueOwner::dials: {
            const FourNeurons dials = read_dials(*brain_of(subject.now, subject.vehicle), subject.pair);
            std::vector<Command> commands;
            for (const Dial dial : axis.dials)
                if (at(dials, dial) != value) commands.push_back(TurnDial{subject.target, dial, value, subject.pair});
            return commands;
        }
        case ValueOwner::sensors:
            return set_sensors(subject, axis, value);
        case ValueOwner::body:
            return edit_of(scene.kinds[static_cast<std::size_t>(subject.vehicle.kind)].body, axis.key, value,
                           [&](Body body) {
                               Kind kind = scene.kinds[static_cast<std::size_t>(subject.vehicle.kind)];
                               kind.body = std::move(body);
                               return std::vector<Command>{EditKind{subject.vehicle.kind, std::move(kind)}};
                           });
        case ValueOwner::start:
            return set_start(subject, axis, value);
        case ValueOwner::source: {
            const int index = find_source(scene, axis.source);
            if (index < 0) return {};
            return edit_of(scene.sources[static_cast<std::size_t>(index)], axis.key, value, [&](Source source) {
                return std::vector<Command>{EditSource{index, std::move(source)}};
            });
        }
        case ValueOwner::arena:
            return edit_of(scene.arena, axis.key, value,
                           [](const Arena& arena) { return std::vector<Command>{EditArena{arena}}; });
    }
    return {};
}

void place_sensors(Scene& scene, const ValueSubject& subject) {
    place_part(
        scene, subject, kind_of(subject.now, subject.vehicle).sensors, &Kind::sensors,
        [](auto& holder) -> auto& { return holder.sensors; });
}

void place_brain(Scene& scene, const ValueSubject& subject) {
    place_part(
        scene, subject, *brain_of(subject.now, subject.vehicle), &Kind::brain,
        [](auto& holder) -> auto& { return holder.brain; });
}

}  // namespace braitenlab::insight
