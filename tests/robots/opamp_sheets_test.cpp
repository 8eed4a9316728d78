// The schematic of a circuit: its parts and connections, read from the drawing, are those of the netlists, and nothing
// lies on something else.
#include <cmath>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "core/brain/four_neurons.h"
#include "core/export/opamp.h"
#include "core/maths/random.h"
#include "tests/robots/exported.h"
#include "tests/robots/schematic.h"
#include "tests/well_formed.h"

namespace braitenlab::tests::opamp_sheets_test {
namespace {

using robots::BrainToExport;
using robots::Target;
using namespace schematic;
namespace opamp = robots::opamp;
using Files = std::vector<robots::ExportedFile>;

struct DrawnSheet {
    explicit DrawnSheet(const std::string& text) : svg(text), picture(read_picture(text)), nets(picture) {}
    DrawnSheet(const DrawnSheet&) = delete;
    std::string svg;
    Picture picture;
    Nets nets;  // of the picture
};

struct Circuit {
    BrainToExport brain;
    Files files;
    std::vector<std::unique_ptr<DrawnSheet>> sheets{};
};

Circuit circuit_from(const BrainToExport& brain, const Files& files) {
    Circuit circuit{brain, files};
    for (const auto& file : files)
        if (file.name.starts_with("wiring")) circuit.sheets.push_back(std::make_unique<DrawnSheet>(file.text));
    return circuit;
}

const std::string& text_of(const Files& files, std::string_view name) {
    return std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.name == name; })->text;
}

double ohms_of(const std::string& text) {
    return std::stod(text) * (text.find("MΩ") != std::string::npos   ? 1e6
                              : text.find("kΩ") != std::string::npos ? 1e3
                                                                     : 1);
}

// "R3 120000 buffered_SL left_minus"
std::multiset<std::string> drawn_resistors(const Circuit& circuit) {
    std::multiset<std::string> all;
    const std::regex label(R"re((R\d+) ([\d.]+ [kM]?Ω))re");
    for (const auto& sheet : circuit.sheets) {
        const Picture& picture = sheet->picture;
        const Nets& nets = sheet->nets;
        for (const Words& w : picture.words) {
            std::smatch found;
            if (!std::regex_match(w.text, found, label)) continue;
            const double y = w.at.y + 9;
            for (const Box& box : picture.boxes)
                if (std::fabs((box.upper + box.lower) / 2 - (w.at.y - 4)) < 1 &&
                    std::fabs((box.left + box.right) / 2 + 10 - w.at.x) < 1)
                    all.insert(fmt::format("{} {:.4g} {} {}", std::string(found[1]), ohms_of(found[2]),
                                           nets.at({w.at.x - 10, box.upper}), nets.at({w.at.x - 10, box.lower})));
            for (const Box& box : picture.boxes)
                if (std::fabs(box.upper + 6 - y) < 1 && std::fabs((box.left + box.right) / 2 - w.at.x) < 1)
                    // The feedback resistor is drawn from the input to the output.
                    all.insert(fmt::format("{} {:.4g} {}", std::string(found[1]), ohms_of(found[2]),
                                           w.at.x < 600 ? nets.at({box.left, y}) + " " + nets.at({box.right, y})
                                                        : nets.at({box.right, y}) + " " + nets.at({box.left, y})));
        }
    }
    return all;
}

std::multiset<std::string> spice_resistors(const std::string& netlist) {
    std::multiset<std::string> all;
    std::istringstream lines(netlist);
    const std::regex resistor(R"re((R\d+) (\S+) (\S+) (\S+))re");
    std::smatch found;
    for (std::string line; std::getline(lines, line);)
        if (std::regex_match(line, found, resistor))
            all.insert(fmt::format("{} {:.4g} {} {}", std::string(found[1]), std::stod(found[4]), std::string(found[2]),
                                   std::string(found[3])));
    return all;
}

// "U1 3 sensor_SL", of every pin of an amplifier.
std::multiset<std::string> drawn_pins(const Circuit& circuit) {
    std::multiset<std::string> all;
    for (const auto& sheet : circuit.sheets) {
        const Picture& picture = sheet->picture;
        const Nets& nets = sheet->nets;
        const auto pin_at = [&](Point p) -> std::string {
            for (const Words& w : picture.words)
                if (is_same(w.at, p)) return w.text;
            return "";
        };
        for (const Point& corner : picture.triangles) {
            const double x = corner.x, y = corner.y + 30;
            std::string chip = pin_at({x + 21, y + 4});
            chip = chip.substr(0, chip.size() - 1);
            for (const double input : {y - 15, y + 15})
                all.insert(chip + " " + pin_at({x - 3, input - 4}) + " " + nets.at({x - 6, input}));
            all.insert(chip + " " + pin_at({x + 53, y - 5}) + " " + nets.at({x + 58, y}));
        }
    }
    return all;
}

std::multiset<std::string> kicad_pins(const std::string& netlist) {
    std::multiset<std::string> all;
    std::istringstream lines(netlist);
    const std::regex net(R"re(\(net .*\(name "([^"]+)"\))re"), pin(R"re(\(node \(ref "(U\d+)"\) \(pin "(\d+)"\)\))re");
    const std::regex regulator(R"re(\(ref "(U\d+)"\) \(value "L7805"\))re");
    std::string present, without;
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_search(line, found, regulator)) without = found[1];
        if (std::regex_search(line, found, net)) present = found[1];
        if (!std::regex_search(line, found, pin) || found[1] == without || found[2] == "4" || found[2] == "11")
            continue;
        // The net of an unused output has no name in the picture.
        const std::string node = present == "GND" ? "0" : present.starts_with("unused_") ? "" : present;
        all.insert(std::string(found[1]) + " " + std::string(found[2]) + " " + node);
    }
    return all;
}

// ---- Brains ----

std::string name_of_sensor(int i, bool is_long) {
    return is_long ? fmt::format("{:_<38}{:02}", "SENSOR & <name>", i) : fmt::format("S{}", i);
}

constexpr Channel channels_with_parts[] = {Channel::light, Channel::red,   Channel::green,    Channel::blue,
                                           Channel::heat,  Channel::smell, Channel::obstacle, Channel::touch,
                                           Channel::floor, Channel::energy};

// A weight for which there is a resistor.
float strength(maths::Random& random) {
    const float size = random.uniform(0.03f, 2);
    return random.uniform(0, 1) < 0.5f ? -size : size;
}

BrainToExport brain_of(int sensors, maths::Random& random, bool long_names, float share = 1) {
    BrainToExport made{fmt::format("{} sensors", sensors), {}, {}};
    int id = 0;
    for (int i = 0; i < sensors; ++i) {
        made.brain.nodes.push_back({.id = id++, .kind = NodeKind::sensor, .name = name_of_sensor(i, long_names)});
        made.sensors.push_back(
            {.name = name_of_sensor(i, long_names), .channel = channels_with_parts[static_cast<std::size_t>(i) % 10]});
    }
    for (const char* motor : {"ML", "MR"})
        made.brain.nodes.push_back(
            {.id = id++, .kind = NodeKind::motor, .name = motor, .bias = 0.5f * strength(random)});
    for (int i = 0; i < sensors; ++i)
        for (int motor = sensors; motor < sensors + 2; ++motor)
            if (random.uniform(0, 1) <= share)
                made.brain.wires.push_back({.from = i, .to = motor, .weight = strength(random)});
    return made;
}

std::vector<Circuit> made_circuits() {
    std::vector<Circuit> circuits;
    each_exported(Target::opamp, "lm324", [&](const BrainToExport& brain, const Files& files) {
        circuits.push_back(circuit_from(brain, files));
    });
    maths::Random random(5, 1);
    std::vector<BrainToExport> brains{{"no wire", make_graph({.LM = 1, .RM = 0.5f}), {}},
                                      {"one wire", make_graph({.LL = 0.5f}), {}},
                                      {"other wire", make_graph({.RL = -0.5f}), {}}};
    for (int sensors = 1; sensors < 12; ++sensors)
        for (const float share : {1.0f, 0.4f}) brains.push_back(brain_of(sensors, random, sensors % 2 == 0, share));
    brains.push_back(brain_of(limits::sensors, random, false));
    brains.push_back(brain_of(limits::sensors, random, true));
    for (const BrainToExport& brain : brains) {
        const auto files = robots::export_brain(brain, Target::opamp, *robots::find_robot("lm324"));
        EXPECT_TRUE(files) << brain.title << ": " << (files ? "" : files.error().what);
        if (files) circuits.push_back(circuit_from(brain, *files));
    }
    return circuits;
}

// Of every shipped brain that the circuit holds, and of brains from one wire to the most sensors.
const std::vector<Circuit>& circuits() {
    static const std::vector<Circuit> made = made_circuits();
    return made;
}

template <class Test>
void each_circuit(Test test) {
    for (const Circuit& circuit : circuits()) test(circuit);
}

TEST(OpampSheets, HaveEachResistorOfTheNetlistOnceWithItsValueBetweenItsNodes) {
    std::size_t most = 0;
    each_circuit([&](const Circuit& circuit) {
        const auto drawn = drawn_resistors(circuit), spice = spice_resistors(text_of(circuit.files, "brain.cir"));
        EXPECT_EQ(drawn, spice) << circuit.brain.title;
        most = std::max(most, spice.size());
    });
    EXPECT_GT(most, 200u) << "the largest brain";
}

TEST(OpampSheets, HaveEachPinOfEachAmplifierOnTheNetOfTheBoard) {
    each_circuit([](const Circuit& circuit) {
        EXPECT_EQ(drawn_pins(circuit), kicad_pins(text_of(circuit.files, "brain.net"))) << circuit.brain.title;
    });
}

// "R3 120 kΩ" of each resistor in a table with its names and values in these columns.
std::multiset<std::string> listed(const std::string& text, char separator, std::size_t names, std::size_t values) {
    std::multiset<std::string> all;
    std::istringstream lines(text);
    const std::regex name(R"re(R\d+)re"), value(R"re([\d.]+ [kM]?Ω)re");
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, separator);) cells.push_back(cell);
        if (cells.size() <= std::max(names, values)) continue;
        const std::sregex_iterator end;
        std::sregex_iterator n(cells[names].begin(), cells[names].end(), name),
            v(cells[values].begin(), cells[values].end(), value);
        if (n == end || v == end) continue;
        // One value for all names, whose number is in the first column, or one for each.
        const bool is_one = std::next(v) == end;
        if (is_one && separator == ',') {
            EXPECT_EQ(std::distance(n, end), std::stol(cells[0])) << line;
        }
        for (; n != end && v != end; ++n) {
            all.insert(n->str() + " " + v->str());
            if (!is_one) ++v;
        }
        EXPECT_TRUE(n == end) << line;
    }
    return all;
}

TEST(OpampSheets, NameTheResistorsAsTheReadmeAndTheListOfParts) {
    each_circuit([](const Circuit& circuit) {
        std::multiset<std::string> labels;
        const std::regex label(R"re(R\d+ [\d.]+ [kM]?Ω)re");
        for (const auto& sheet : circuit.sheets)
            for (const Words& w : sheet->picture.words)
                if (std::regex_match(w.text, label)) labels.insert(w.text);
        EXPECT_EQ(labels, listed(text_of(circuit.files, "README.md"), '|', 1, 5)) << circuit.brain.title;
        EXPECT_EQ(labels, listed(text_of(circuit.files, "parts.csv"), ',', 5, 2)) << circuit.brain.title;
    });
}

// "C1 330 nF v9 0" of each capacitor, "D1 1N4148 left_limit v5" of each diode.
std::multiset<std::string> drawn_two_poles(const Circuit& circuit) {
    std::multiset<std::string> all;
    for (const auto& sheet : circuit.sheets) {
        const auto text_at = [&](Point p) -> std::string {
            for (const Words& w : sheet->picture.words)
                if (is_same(w.at, p)) return w.text;
            return "";
        };
        for (const Point& c : sheet->picture.capacitors)
            all.insert(fmt::format("{} {} {} {}", text_at({c.x + 11, c.y + 2}), text_at({c.x + 11, c.y + 13}),
                                   sheet->nets.at(c), sheet->nets.at({c.x, c.y + 6})));
        for (const Point& d : sheet->picture.diodes)
            all.insert(fmt::format("{} {} {}", text_at({d.x + 6, d.y + 18}), sheet->nets.at({d.x + 12, d.y}),
                                   sheet->nets.at(d)));
    }
    return all;
}

std::multiset<std::string> listed_two_poles(const std::string& parts) {
    const std::regex row(R"re(1,(?:capacitor|diode),([^,]+),([^,]+),([^,]+),([CD]\d+))re");
    const auto node = [](const std::string& name) -> std::string {
        return name == "ground" ? "0" : name == "5 V" ? "v5" : name == "9 V" ? "v9" : name;
    };
    std::multiset<std::string> all;
    for (std::sregex_iterator r(parts.begin(), parts.end(), row), end; r != end; ++r)
        all.insert(fmt::format("{} {} {} {}", (*r)[4].str(), (*r)[1].str(), node((*r)[2]), node((*r)[3])));
    return all;
}

// Pin 1 of a diode is its cathode.
std::multiset<std::string> kicad_two_poles(const std::string& netlist) {
    std::map<std::string, std::string> values, nets[2];
    const std::regex part(R"re(\(ref "([CD]\d+)"\) \(value "([^"]+)"\))re"), net(R"re(\(net .*\(name "([^"]+)"\))re"),
        pin(R"re(\(node \(ref "([CD]\d+)"\) \(pin "([12])"\)\))re");
    const std::map<std::string, std::string> nodes{{"GND", "0"}, {"+5V", "v5"}, {"+9V", "v9"}};
    std::istringstream lines(netlist);
    std::string present;
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
        if (std::regex_search(line, found, part)) values[found[1]] = found[2];
        if (std::regex_search(line, found, net))
            present = nodes.contains(found[1]) ? nodes.at(found[1]) : std::string(found[1]);
        if (std::regex_search(line, found, pin)) nets[found[2] == "1" ? 0 : 1][found[1]] = present;
    }
    std::multiset<std::string> all;
    for (const auto& [name, value] : values) {
        const bool is_diode = name[0] == 'D';
        all.insert(fmt::format("{} {} {} {}", name, value, nets[is_diode ? 1 : 0][name], nets[is_diode ? 0 : 1][name]));
    }
    return all;
}

TEST(OpampSheets, HaveTheCapacitorsAndDiodesOfTheListOfPartsAndOfTheBoard) {
    each_circuit([](const Circuit& circuit) {
        const auto listed = listed_two_poles(text_of(circuit.files, "parts.csv"));
        EXPECT_GE(listed.size(), 5u) << circuit.brain.title;
        EXPECT_EQ(drawn_two_poles(circuit), listed) << circuit.brain.title;
        EXPECT_EQ(kicad_two_poles(text_of(circuit.files, "brain.net")), listed) << circuit.brain.title;
    });
}

TEST(OpampSheets, NameTheRegulatorAsTheListOfParts) {
    each_circuit([](const Circuit& circuit) {
        const opamp::Circuit parts = opamp::circuit_of(*robots::make_plan(circuit.brain, 60));
        const std::string name = fmt::format("U{}", parts.chips() + 1), value(opamp::regulator_value);
        std::set<std::string> words;
        for (const auto& sheet : circuit.sheets)
            for (const Words& w : sheet->picture.words) words.insert(w.text);
        EXPECT_TRUE(words.contains(name) && words.contains(value)) << circuit.brain.title;
        EXPECT_NE(text_of(circuit.files, "parts.csv").find(fmt::format("1,regulator,{},9 V,5 V,{}\n", value, name)),
                  std::string::npos);
    });
}

// A sheet is named in the README once, and each other file, too.
TEST(OpampSheets, AreNamedInTheReadmeAsTheOtherFiles) {
    each_circuit([](const Circuit& circuit) {
        for (const auto& file : circuit.files)
            EXPECT_EQ(text_of(circuit.files, "README.md").find(fmt::format("| `{}` |", file.name)) != std::string::npos,
                      file.name != "README.md")
                << circuit.brain.title << " " << file.name;
    });
}

TEST(OpampSheets, HaveADotWhereThreeWiresMeetAndNowhereElse) {
    each_circuit([](const Circuit& circuit) {
        for (const auto& sheet : circuit.sheets) {
            const Picture& picture = sheet->picture;
            const auto branches = [&](Point p) {
                int ends = 0;
                for (const Segment& s : picture.wires) ends += s.ends_at(p) ? 1 : s.touches(p) ? 2 : 0;
                for (const Point& supply : picture.supplies) ends += is_same(supply, p) ? 1 : 0;
                return ends;
            };
            const auto has_dot = [&](Point p) {
                return std::any_of(picture.dots.begin(), picture.dots.end(), [&](Point d) { return is_same(d, p); });
            };
            for (const Point& dot : picture.dots)
                EXPECT_GE(branches(dot), 3) << circuit.brain.title << dot.x << " " << dot.y;
            for (const Segment& s : picture.wires)
                for (const Point& end : {s.a, s.b})
                    EXPECT_EQ(has_dot(end), branches(end) >= 3) << circuit.brain.title << " " << end.x << " " << end.y;
        }
    });
}

TEST(OpampSheets, HaveNoTextOnAnotherTextOnAWireOrOverTheEdge) {
    each_circuit([](const Circuit& circuit) {
        for (const auto& sheet : circuit.sheets) {
            EXPECT_EQ(xml_fault("<!DOCTYPE svg>\n" + sheet->svg), "") << circuit.brain.title;
            const Picture& picture = sheet->picture;
            std::vector<Segment> lines = picture.wires;
            lines.insert(lines.end(), picture.bars.begin(), picture.bars.end());
            for (std::size_t i = 0; i < picture.words.size(); ++i) {
                const Words& w = picture.words[i];
                EXPECT_TRUE((Box{20, 20, 774, 1103}).holds(w.box)) << circuit.brain.title << " " << w.text;
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_FALSE(w.box.meets(picture.words[j].box))
                        << circuit.brain.title << ": " << w.text << ", " << picture.words[j].text;
                for (const Box& box : picture.boxes)
                    EXPECT_TRUE(!w.box.meets(box) || box.holds(w.box)) << circuit.brain.title << ": " << w.text;
                for (const Segment& s : lines)
                    EXPECT_FALSE(w.box.meets({std::min(s.a.x, s.b.x) - 0.5, std::min(s.a.y, s.b.y) - 0.5,
                                              std::max(s.a.x, s.b.x) + 0.5, std::max(s.a.y, s.b.y) + 0.5}))
                        << circuit.brain.title << ": " << w.text << " at " << s.a.x << " " << s.a.y;
            }
        }
    });
}

TEST(OpampSheets, AreOneForABrainOfTwoSensors) {
    EXPECT_EQ(
        opamp::wiring_sheets(
            *robots::make_plan(
                {"", make_graph({.LL = 0.9f, .LR = -0.7f, .RL = 0.7f, .RR = 0.3f, .LM = 0.4f, .RM = -0.9f}), {}}, 60))
            .size(),
        1u);
}

}  // namespace
}  // namespace braitenlab::tests::opamp_sheets_test
