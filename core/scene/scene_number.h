// One number of a scene by its path or of a record by its key, in the units of a file (angles in degrees), without a
// file. A path is one that --set takes: "source.lamp.strength".
#pragma once

#include <optional>
#include <string_view>

#include "core/scene/scene.h"
#include "core/scene/schema.h"

namespace braitenlab {

struct SceneNumber {
    double value = 0;
    Range range{0, 0};  // that the schema allows
    std::string_view unit;
};

// Of a record; nullopt or false for a key that is no number or angle of it.
std::optional<SceneNumber> number_of(const Arena&, std::string_view key);
std::optional<SceneNumber> number_of(const Body&, std::string_view key);
std::optional<SceneNumber> number_of(const Sensor&, std::string_view key);
std::optional<SceneNumber> number_of(const Source&, std::string_view key);
std::optional<SceneNumber> number_of(const Start&, std::string_view key);
// Sets the value, clamped to the range; whole numbers are rounded.
bool set_number(Arena&, std::string_view key, double value);
bool set_number(Body&, std::string_view key, double value);
bool set_number(Sensor&, std::string_view key, double value);
bool set_number(Source&, std::string_view key, double value);
bool set_number(Start&, std::string_view key, double value);

// As above, by the path of a value of the arena, a source, a vehicle's start, a kind's body, or a sensor of a kind, a
// vehicle or a member. False without such a value.
bool set_number_at(Scene&, std::string_view path, double value);

}  // namespace braitenlab
