// The words that files and programs use for the values of the scene's enumerations.
#pragma once

#include <array>
#include <string_view>

#include "core/brain/graph.h"
#include "core/scene/scene.h"

namespace braitenlab {

template <class Enum>
struct Named {
    Enum value;
    std::string_view word;
};

inline constexpr std::array<Named<Channel>, channel_count> channel_words{{
    {Channel::light, "light"},
    {Channel::red, "red"},
    {Channel::green, "green"},
    {Channel::blue, "blue"},
    {Channel::heat, "heat"},
    {Channel::smell, "smell"},
    {Channel::oxygen, "oxygen"},
    {Channel::obstacle, "obstacle"},
    {Channel::predator, "predator"},
    {Channel::prey, "prey"},
    {Channel::vehicle, "vehicle"},
    {Channel::memory, "memory"},
    {Channel::touch, "touch"},
    {Channel::floor, "floor"},
    {Channel::energy, "energy"},
}};
inline constexpr std::array<Named<Role>, 4> role_words{
    {{Role::none, "none"}, {Role::predator, "predator"}, {Role::prey, "prey"}, {Role::wiring, "wiring"}}};
inline constexpr std::array<Named<Driver>, 5> driver_words{{{Driver::brain, "brain"},
                                                            {Driver::manual, "manual"},
                                                            {Driver::path, "path"},
                                                            {Driver::wander, "wander"},
                                                            {Driver::parked, "parked"}}};
inline constexpr std::array<Named<Boundary>, 3> boundary_words{
    {{Boundary::wall, "wall"}, {Boundary::open, "open"}, {Boundary::torus, "torus"}}};
inline constexpr std::array<Named<Surface>, 5> surface_words{{{Surface::none, "none"},
                                                              {Surface::ice, "ice"},
                                                              {Surface::carpet, "carpet"},
                                                              {Surface::sand, "sand"},
                                                              {Surface::tape, "tape"}}};
inline constexpr std::array<Named<Motor>, 3> motor_words{
    {{Motor::none, "none"}, {Motor::left, "left"}, {Motor::right, "right"}}};
inline constexpr std::array<Named<SensorShape>, 3> shape_words{
    {{SensorShape::sector, "sector"}, {SensorShape::triangle, "triangle"}, {SensorShape::omni, "omni"}}};
inline constexpr std::array<Named<SensorResponse>, 2> sensor_response_words{
    {{SensorResponse::graded, "graded"}, {SensorResponse::boolean, "boolean"}}};
inline constexpr std::array<Named<NodeKind>, 3> node_kind_words{
    {{NodeKind::sensor, "sensor"}, {NodeKind::neuron, "neuron"}, {NodeKind::motor, "motor"}}};

constexpr const auto& words(Channel) { return channel_words; }
constexpr const auto& words(Role) { return role_words; }
constexpr const auto& words(Driver) { return driver_words; }
constexpr const auto& words(Boundary) { return boundary_words; }
constexpr const auto& words(Surface) { return surface_words; }
constexpr const auto& words(Motor) { return motor_words; }
constexpr const auto& words(SensorShape) { return shape_words; }
constexpr const auto& words(SensorResponse) { return sensor_response_words; }
constexpr const auto& words(NodeKind) { return node_kind_words; }
constexpr const auto& words(Response) { return responses; }

// The word for a value, e.g. word(Role::prey) == "prey".
template <class Enum>
constexpr std::string_view word(Enum value) {
    for (const auto& named : words(value))
        if (named.value == value) return named.word;
    return {};
}

}  // namespace braitenlab
