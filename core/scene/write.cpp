// Writes scenes and brains as TOML, in the order of the schema.
#include <cmath>
#include <utility>

#include "core/maths/angle.h"
#include "core/scene/scene_file.h"
#include "core/scene/sealed.h"
#include "core/scene/toml_tree.h"
#include "core/scene/toml_writer.h"

namespace braitenlab {

namespace toml_text {

std::string number(float value) { return fmt::format("{}", value == 0 ? 0.0f : value); }

std::string degrees(float radians) {
    const double degrees = static_cast<double>(radians) * (180 / maths::pi_d);
    double scale = 1;
    for (int places = 0; places <= 12; ++places, scale *= 10) {
        const double rounded = std::round(degrees * scale) / scale;
        if (static_cast<float>(rounded * (maths::pi_d / 180)) == radians)
            return fmt::format("{}", rounded == 0 ? 0.0 : rounded);
    }
    return fmt::format("{}", degrees);
}

std::string quote(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n') {
            out += "\\n";
        } else if (byte < 0x20 || byte == 0x7f) {
            out += fmt::format("\\u{:04X}", byte);
        } else {
            out += c;
        }
    }
    return out + "\"";
}

// A value that is no TOML value is a text.
std::string setting(const Setting& setting) {
    const auto is_value = static_cast<bool>(parse_toml(fmt::format("x = {}", setting.value), ""));
    return fmt::format("{} = {}\n", quote(setting.path), is_value ? setting.value : quote(setting.value));
}

}  // namespace toml_text

std::string write_scene(const Scene& scene) {
    Scene plain = scene;
    std::string sealed;
    for (Kind& kind : plain.kinds)
        if (kind.hidden) sealed += fmt::format("{} = \"{}\"\n", kind.name, seal(std::exchange(kind.brain, {})));
    return write_top(plain) + (sealed.empty() ? "" : "\n[sealed]\n" + sealed);
}

std::string write_brain(const BrainGraph& graph) {
    return write_top(BrainFile{graph}) + (graph.nodes.empty() ? "\n[brain]\n" : "");  // the file needs the table
}

}  // namespace braitenlab
