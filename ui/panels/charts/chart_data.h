// Data of the charts: samples over time, the order of the energy bars, and both as CSV.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/world/snapshot.h"
#include "ui/lab_view.h"

namespace braitenlab::ui {

// Samples of the run, taken from the displayed snapshots. A step back in time removes the later samples.
struct History {
    static constexpr std::uint64_t signal_period = 3;       // ticks between samples
    static constexpr std::size_t signal_samples = 1200;     // one minute
    static constexpr std::uint64_t population_period = 60;  // ticks
    static constexpr std::size_t population_samples = 600;  // ten minutes
    static constexpr std::size_t most_brain_values = 32;    // of a large brain only the first ones are kept

    struct Signals {
        double seconds = 0;             // simulated
        std::vector<float> sensors;     // readings, 0..1, as History::sensors
        std::array<float, 2> motors{};  // commands of the left and right wheel, −1..1
        std::vector<float> brain{};     // as History::brain_values: the value of largest size since the last sample
    };
    struct Population {
        double seconds = 0;
        std::array<int, 3> count{};     // predators, prey, others
        std::array<float, 3> energy{};  // mean of each, 0..1; NaN for an empty group
    };

    VehicleId vehicle = no_vehicle;    // the vehicle that `signals` are of
    std::vector<std::string> sensors;  // names of its sensors
    std::shared_ptr<const BrainGraph> brain;
    std::vector<float> brain_peaks;         // since the last sample, as brain_values
    std::vector<std::string> brain_values;  // its neurons "N1", then the learned parts of its wires "SL>N1"
    std::deque<Signals> signals;            // oldest first
    std::deque<Population> population;
    std::uint64_t tick = 0;    // of the last snapshot
    std::uint64_t run_id = 0;  // LabView::run_id of the samples
};

// Adds a sample when one is due. Replaces the sample of the current tick, which an edit may have changed. Removes the
// later samples after a step back, the signals when another vehicle is selected or its sensors or neurons get other
// names, and all samples when another scene is opened. Call once per frame. At high speed the time between frames
// exceeds the periods, so there are fewer samples.
void record(History&, const LabView&);

// The longest time (s) in which every sample had at least `count` vehicles of the role, predator or prey.
double longest_time_with(const History&, Role, int count);

// The last seconds that the strips of the card and the probes of the diagram show.
inline constexpr double strip_seconds = 10;

// Index of the first sample within strip_seconds before the newest one; 0 without samples.
std::size_t first_in_strip(const History&);

// One of the recorded signals of the vehicle.
struct Signal {
    enum class Of { sensor, motor, brain };
    Of of = Of::sensor;
    std::size_t index = 0;  // in History::Signals::sensors, motors or brain
    std::string name;       // of the sensor, motor or neuron; of a learned part "SL>N1"

    float value(const History::Signals&) const;
};

// Sensors, motors, neurons, learned parts of wires.
std::vector<Signal> all_signals(const History&);

// nullopt: there is no signal with this name.
std::optional<Signal> signal_named(const History&, std::string_view name);

inline constexpr std::size_t most_strips = 32;  // on the tab "Chosen" of the chart card

// From −1 or 0 to 1, or symmetric about 0 and to the largest value where this is more.
struct SignalRange {
    float low = 0, high = 1;
};
SignalRange range_of(const History&, const Signal&);

// The four signals that strips and charts show: the readings of a pair of sensors, and the commands of both wheels.
struct ShownSignals {
    std::array<std::string, 4> names;                     // as diagrams show them: "SL", "SR", "ML", "MR"
    std::array<std::optional<std::size_t>, 2> sensors{};  // in History::sensors; nullopt: the vehicle has no such one

    // 0 for a sensor that the vehicle does not have.
    float value(const History::Signals&, std::size_t signal) const;
};
ShownSignals shown_signals(const History&, const SensorPair&);
// Of the pair that the sliders show; SL and SR without a vehicle.
ShownSignals shown_signals(const History&, const LabView&);

struct EnergyOrder {
    enum class By { number, energy, kind };
    By by = By::number;
    bool falling = false;
    friend bool operator==(const EnergyOrder&, const EnergyOrder&) = default;
};

// Fills `rows` with the indices of the snapshot's vehicles in this order. Equal vehicles are in ascending number.
void sort(const Snapshot&, const EnergyOrder&, std::vector<std::size_t>& rows);

// Tables as core/io/csv.h writes them. docs/command-line.md lists the columns.

std::string signals_csv(const History&);
std::string population_csv(const History&);  // empty fields for the mean energy of an empty group
std::string energies_csv(const Snapshot&);   // one row per vehicle

}  // namespace braitenlab::ui
