#include "core/insight/map.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/scene/nearest.h"
#include "core/scene/scene_file.h"
#include "core/text_parts.h"

namespace braitenlab::insight {

namespace {

std::vector<std::string_view> dial_words() {
    std::vector<std::string_view> words;
    for (const Dial dial : all_dials) words.push_back(name(dial));
    return words;
}

Error no_dial(const std::string& word) {
    return {in_quotes(word) + " is no number of the brain" + name_nearest(word, dial_words()) +
            "; a value of the scene has a path like kind.prey.body.mass"};
}

std::vector<Setting> settings_of(const MapAxis& axis, float value) {
    std::vector<Setting> settings;
    for (const std::string& path : axis.values) {
        const bool is_negative = path.front() == '-';
        // With all digits of a double, so that an angle is rounded as by set_number() (core/scene/scene_number.h).
        const auto number = static_cast<double>(is_negative ? -value : value);
        settings.push_back({path.substr(is_negative ? 1 : 0), fmt::format("{}", number), "the map", 0});
    }
    return settings;
}

// Strides of the levels: 4 blocks along an axis at first, 1 at last.
std::vector<int> strides_of(int size) {
    int stride = 1;
    while (stride * 2 * 4 <= size) stride *= 2;
    std::vector<int> strides;
    for (; stride >= 1; stride /= 2) strides.push_back(stride);
    return strides;
}

int middle_of_block(int index, int stride, int size) {
    return std::min(index / stride * stride + stride / 2, size - 1);
}

float median(std::vector<float> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

std::optional<Error> fault_of(const MapQuestion& question) {
    if (question.size < 2 || question.size > limits::map_size)
        return Error{fmt::format("a map has 2 to {} cells along an axis", limits::map_size)};
    if (question.seeds < 1 || question.seeds > limits::map_seeds)
        return Error{fmt::format("a map has 1 to {} seeds", limits::map_seeds)};
    for (const MapAxis* axis : {&question.x, &question.y})
        for (const Dial dial : axis->dials) {
            const DialRange allowed = range(dial);
            if (std::min(axis->from, axis->to) < allowed.low || std::max(axis->from, axis->to) > allowed.high)
                return Error{fmt::format("{} is from {:g} to {:g}", name(dial), allowed.low, allowed.high), axis->path};
        }
    if (have_common_value(question.x, question.y))
        return Error{"both axes have the same value; give each a value of its own", question.y.path};
    return std::nullopt;
}

}  // namespace

Result<MapAxis> axis_of(std::string_view path) {
    MapAxis axis{.path = std::string(path)};
    std::string table;  // of the first path
    for (const std::string& key : parts_of(path, '=')) {
        const std::size_t dot = key.rfind('.');
        if (key.empty() || dot == key.size() - 1)
            return Error{"the path of an axis is empty; write LL=RR or kind.prey.body.mass"};
        if (axis.dials.empty() && table.empty() && dot != std::string::npos) table = key.substr(0, dot + 1);
        if (!table.empty()) {
            axis.values.push_back(dot == std::string::npos ? table + key : key);
            continue;
        }
        const auto dial = dial_named(key);
        if (!dial) return no_dial(key);
        axis.dials.push_back(*dial);
    }
    if (axis.dials.empty()) {
        axis.from = 0, axis.to = 1;
        return axis;
    }
    const DialRange allowed = range(axis.dials.front());
    for (const Dial dial : axis.dials)
        if (range(dial).low != allowed.low || range(dial).high != allowed.high)
            return Error{"the numbers of one axis have the same range; weights, thresholds and biases differ"};
    axis.from = allowed.low, axis.to = allowed.high;
    return axis;
}

Result<MapAxis> parse_axis(const std::string& argument, const std::string& option) {
    const std::string where = option + " " + argument;
    const std::size_t equals = argument.rfind('=');
    const std::vector<std::string> numbers =
        equals == std::string::npos ? std::vector<std::string>{} : parts_of(argument.substr(equals + 1), ':');
    if (numbers.size() != 2) return Error{"an axis is PATH=A:B, like LL=RR=-1:1 or kind.prey.body.mass=5:20", where};
    auto axis = axis_of(argument.substr(0, equals));
    if (!axis) return Error{axis.error().what, where};
    const std::optional<float> from = real_number(numbers[0]), to = real_number(numbers[1]);
    if (!from || !to) return Error{in_quotes(from ? numbers[1] : numbers[0]) + " is not a number", where};
    if (*from == *to) return Error{"both ends of the axis are the same; give two different numbers", where};
    axis->from = *from, axis->to = *to;
    return axis;
}

bool have_common_value(const MapAxis& a, const MapAxis& b) {
    const auto shares = [](const auto& some, const auto& others, auto bare) {
        return std::any_of(some.begin(), some.end(), [&](const auto& each) {
            return std::any_of(others.begin(), others.end(),
                               [&](const auto& other) { return bare(each) == bare(other); });
        });
    };
    const auto path = [](const std::string& text) {
        return std::string_view(text).substr(text.front() == '-' ? 1 : 0);
    };
    return shares(a.dials, b.dials, [](Dial dial) { return dial; }) || shares(a.values, b.values, path);
}

float value_at(const MapAxis& axis, int index, int size) {
    if (index == size - 1) return axis.to;
    return axis.from + (axis.to - axis.from) * static_cast<float>(index) / static_cast<float>(size - 1);
}

Result<std::shared_ptr<const MapBase>> MapBase::create(MapQuestion question) {
    if (auto error = fault_of(question)) return *error;
    auto base = std::make_shared<MapBase>();
    base->question_ = std::move(question);
    const MapQuestion& q = base->question_;
    if (!q.x.values.empty() || !q.y.values.empty()) {
        auto file = parse_toml(write_scene(q.scene), q.scene.name);
        if (!file) return file.error();
        // With settings, the errors of an unknown path and of a value out of range name the setting.
        for (const MapAxis* axis : {&q.x, &q.y})
            for (const float end : {axis->from, axis->to})
                if (auto scene = read_scene(*file, "", settings_of(*axis, end)); !scene) {
                    Error error = scene.error();
                    error.file = axis->path, error.line = 0;
                    return error;
                }
        base->file_ = std::move(*file);
    }
    for (int seed = 0; seed < (base->file_ ? 1 : q.seeds); ++seed) {
        const auto world = World::create(q.scene, q.seed + static_cast<std::uint64_t>(seed));
        if (!world) return world.error();
        VehicleTrace trace;
        if (!world->trace(q.vehicle, trace)) return Error{"the scene has no vehicle whose behaviour a map can show"};
        if (!base->file_) base->starts_.push_back(world->checkpoint());
    }
    return std::shared_ptr<const MapBase>(std::move(base));
}

Result<World> MapBase::world(MapPlace place, int seed) const {
    const auto start = [&]() -> Result<World> {
        if (!file_) return World::restore(starts_[static_cast<std::size_t>(seed)]);
        TomlFile file = *file_;
        for (const auto& [axis, index] : {std::pair(&question_.x, place.x), std::pair(&question_.y, place.y)})
            for (const Setting& setting : settings_of(*axis, value_at(*axis, index, question_.size)))
                (void)put(file.root, setting);
        const auto scene = read_scene(std::move(file), "", {});
        if (!scene) return scene.error();
        return World::create(*scene, question_.seed + static_cast<std::uint64_t>(seed));
    };
    auto world = start();
    if (!world) return world;
    for (const Command& command : commands(place))
        if (const auto error = world->apply(command)) return *error;
    return world;
}

std::vector<Command> MapBase::commands(MapPlace place) const {
    std::vector<Command> all;
    for (const auto& [axis, index] : {std::pair(&question_.x, place.x), std::pair(&question_.y, place.y)})
        for (const Dial dial : axis->dials)
            all.push_back(TurnDial{question_.target, dial, value_at(*axis, index, question_.size), question_.pair});
    return all;
}

MapCell cell_of(const std::vector<Outcome>& runs) {
    std::array<std::size_t, behaviour_count> counts{};
    for (const Outcome& run : runs) ++counts[static_cast<std::size_t>(run.behaviour)];
    const auto most = std::max_element(counts.begin(), counts.end());
    const auto middle = [&](float Outcome::*member) {
        std::vector<float> values;
        for (const Outcome& run : runs) values.push_back(run.*member);
        return median(std::move(values));
    };
    Outcome outcome{.behaviour = static_cast<Behaviour>(most - counts.begin()),
                    .closest = middle(&Outcome::closest),
                    .final_distance = middle(&Outcome::final_distance),
                    .time_to_touch = middle(&Outcome::time_to_touch),
                    .captures = middle(&Outcome::captures),
                    .survival = middle(&Outcome::survival)};
    return {outcome, static_cast<float>(*most) / static_cast<float>(runs.size())};
}

MapCell run_cell(const std::shared_ptr<const MapBase>& base, MapPlace place) {
    std::vector<Outcome> runs;
    for (int seed = 0; seed < base->question().seeds; ++seed) {
        MapRun run(base, place, seed);
        while (!run.advance(base->question().ticks)) {
        }
        runs.push_back(run.outcome());
    }
    return cell_of(runs);
}

std::vector<std::vector<MapPlace>> map_levels(int size) {
    std::vector<std::vector<MapPlace>> levels;
    std::vector<bool> taken(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (const int stride : strides_of(size)) {
        std::vector<MapPlace> level;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                if (middle_of_block(x, stride, size) != x || middle_of_block(y, stride, size) != y) continue;
                const auto index = static_cast<std::size_t>(y * size + x);
                if (taken[index]) continue;
                taken[index] = true;
                level.push_back({x, y});
            }
        levels.push_back(std::move(level));
    }
    return levels;
}

const MapCell* MapCells::shown(MapPlace place) const {
    const std::vector<int> strides = strides_of(size);
    for (auto stride = strides.rbegin(); stride != strides.rend(); ++stride)
        if (const auto& cell = at({middle_of_block(place.x, *stride, size), middle_of_block(place.y, *stride, size)}))
            return &*cell;
    return nullptr;
}

}  // namespace braitenlab::insight
