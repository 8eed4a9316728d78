#include "ui/panels/csv.h"

#include <cmath>

#include <fmt/format.h>

#include "core/scene/names.h"

namespace braitenlab {

namespace {

// A name in quotes where it holds what a comma-separated file is made of.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

std::string number(float value) { return std::isfinite(value) ? fmt::format("{:.4f}", value) : std::string(); }

}  // namespace

std::string signals_csv(const History& history) {
    std::string text = "seconds,SL,SR,ML,MR\n";
    for (const History::Signals& s : history.signals)
        text += fmt::format("{:.3f},{:.4f},{:.4f},{:.4f},{:.4f}\n", s.seconds, s.values[0], s.values[1], s.values[2],
                            s.values[3]);
    return text;
}

std::string population_csv(const History& history) {
    std::string text = "seconds,predators,prey,others,energy_predators,energy_prey,energy_others\n";
    for (const History::Population& p : history.population)
        text += fmt::format("{:.3f},{},{},{},{},{},{}\n", p.seconds, p.count[0], p.count[1], p.count[2],
                            number(p.energy[0]), number(p.energy[1]), number(p.energy[2]));
    return text;
}

std::string energies_csv(const Snapshot& now) {
    std::string text = "id,kind,role,energy\n";
    for (const VehicleView& v : now.vehicles)
        text += fmt::format("{},{},{},{:.4f}\n", v.id, quoted(now.scene->kinds[static_cast<std::size_t>(v.kind)].name),
                            word(v.role), v.energy);
    return text;
}

}  // namespace braitenlab
