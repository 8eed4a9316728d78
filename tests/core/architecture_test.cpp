// The include rules: a file includes only headers of its own folder or of folders below it, internal headers are
// included only where they are allowed, and few files include each other. The largest structs.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace braitenlab::tests::architecture_test {
namespace {

namespace fs = std::filesystem;

// Each folder and the folders that it may include besides itself. "core" names the files directly in it when included
// from within core, and all of core from above.
const std::map<std::string, std::vector<std::string>> may_include{
    {"core/maths", {}},
    {"core/mechanics", {"core/maths"}},
    {"core/brain", {"core/maths", "core"}},
    {"core/scene", {"core/maths", "core/brain", "core"}},
    {"core/sensing", {"core/maths", "core/mechanics", "core/brain", "core/scene", "core"}},
    {"core/world", {"core/maths", "core/mechanics", "core/brain", "core/scene", "core/sensing", "core"}},
    {"core/io", {"core/maths", "core/mechanics", "core/brain", "core/scene", "core/sensing", "core/world", "core"}},
    {"core/session", {"core/maths", "core/brain", "core/scene", "core/world", "core"}},
    {"core/insight", {"core/maths", "core/brain", "core/scene", "core/sensing", "core/world", "core/io", "core"}},
    {"core/lesson", {"core/maths", "core/brain", "core/scene", "core/sensing", "core/world", "core/io", "core"}},
    {"core/evolve", {"core/maths", "core/brain", "core/scene", "core/world", "core/io", "core/insight", "core"}},
    {"core/export", {"core/maths", "core/brain", "core/scene", "core/sensing", "core/io", "core"}},
    {"core", {}},
    {"render/view", {"core"}},
    {"render/text", {"core", "render/view"}},
    {"render/gl", {"core", "render/view", "render/text"}},
    {"ui/words", {"core"}},
    {"ui/shared", {"core", "render/view", "ui/words"}},
    {"ui/widgets", {"core", "render/view", "ui/words", "ui/shared"}},
    {"ui/wiring", {"core", "render/view", "ui/words", "ui/shared", "ui/widgets"}},
    {"ui/scene_input", {"core", "render/view", "ui/words", "ui/shared", "ui/widgets"}},
    {"ui/panels", {"core", "render/view", "ui/words", "ui/shared", "ui/widgets", "ui/wiring", "ui/scene_input"}},
    {"ui", {"core", "render/view", "ui"}},  // the window
    {"app/jobs", {"core"}},
    {"app", {"core", "render", "ui"}},
};

// Prefixes of library includes, and the only places that may use them.
const std::map<std::string, std::vector<std::string>> libraries{
    {"<box2d/", {"core/world/physics.cpp"}},
    {"<GL/", {"render/gl/", "app/window.cpp"}},
    {"<GLFW/", {"app/window.cpp"}},
    {"<imgui", {"ui/", "app/"}},
    {"<mpi.h>", {"app/ctl/ranks.cpp"}},
    {"<nlohmann/json.hpp>", {"core/io/checked_json.h"}},  // it checks whole numbers
    {"<nlohmann/json_fwd.hpp>", {"app/"}},
    {"<tbb/", {"app/jobs/jobs.cpp"}},
    {"<toml++/", {"core/scene/toml_tree.cpp"}},  // parse_toml() limits size and depth
};

// Internal headers, and the only places that may include them. Tests and benchmarks may include all.
const std::map<std::string, std::vector<std::string>> internal_headers{
    {"core/world/state.h", {"core/world/", "core/io/"}},
    {"core/world/compiled.h", {"core/world/", "core/io/"}},
    {"core/world/present_parts.h", {"core/world/", "core/io/"}},
    {"core/world/world_data.h", {"core/world/"}},
    {"core/world/tick.h", {"core/world/"}},
    {"core/world/physics.h", {"core/world/"}},
    {"core/world/free_space.h", {"core/world/"}},
    {"core/world/edits.h", {"core/world/"}},
    {"core/world/cosmetic_edits.h", {"core/world/", "core/session/"}},
    {"core/io/json.h", {"core/io/", "core/lesson/", "core/evolve/"}},
    {"core/io/state_json.h", {"core/io/"}},
    {"core/session/undo.h", {"core/session/"}},
};

// Files directly in ui/ that every layer of ui may include; they form the layer "ui/shared".
const std::vector<std::string> shared_in_ui{"actions",  "breeding_view", "files",   "imgui_compat", "lab_view",
                                            "map_look", "take_away",     "request", "shortcuts"};

// A folder whose own folders are slices: each includes what this one may include, files directly in it, and no other
// slice.
const std::string panels = "ui/panels";

std::string folder_of(const std::string& file) {
    for (const std::string& name : shared_in_ui)
        if (file.starts_with("ui/" + name + ".")) return "ui/shared";
    std::string best;
    for (const auto& [folder, allowed] : may_include)
        if (file.starts_with(folder + "/") && folder.size() > best.size()) best = folder;
    const std::size_t end = best == panels ? file.find('/', panels.size() + 1) : file.npos;
    return end == file.npos ? best : file.substr(0, end);
}

bool any_prefix_of(const std::string& file, const std::vector<std::string>& prefixes) {
    for (const std::string& prefix : prefixes)
        if (file.starts_with(prefix)) return true;
    return false;
}

bool may_include_file(const std::string& folder, const std::string& target) {
    const std::string layer = folder_of(target);
    if (layer.empty() || layer == folder || target.starts_with(folder + "/")) return true;
    const bool is_slice = folder.starts_with(panels + "/");
    if (is_slice && layer == panels) return true;
    for (const std::string& below : may_include.at(is_slice ? panels : folder)) {
        // "core" among core's folders means the files directly in core/; elsewhere it means all of core.
        const bool exact = (folder.starts_with("core") && below == "core") || below.starts_with("ui/");
        if (exact ? layer == below : target.starts_with(below + "/")) return true;
    }
    return false;
}

std::vector<std::string> violations(const std::string& file, std::istream& text) {
    static const std::regex own{R"(^\s*#include "([^"]+)\")"}, system{R"(^\s*#include (<[^>]+>))"};
    std::vector<std::string> found;
    const auto check = [&](bool allowed, const std::string& target) {
        if (!allowed) found.push_back(file + " includes " + target);
    };
    std::smatch match;
    for (std::string line; std::getline(text, line);) {
        if (std::regex_search(line, match, own)) {
            const std::string target = match[1];
            check(may_include_file(folder_of(file), target), target);
            if (const auto internal = internal_headers.find(target); internal != internal_headers.end())
                check(any_prefix_of(file, internal->second), "the internal header " + target);
        } else if (std::regex_search(line, match, system)) {
            const std::string target = match[1];
            for (const auto& [library, places] : libraries)
                if (target.starts_with(library)) check(any_prefix_of(file, places), target);
        }
    }
    return found;
}

std::size_t count_violations(const std::string& file, const std::string& include) {
    std::istringstream text("#include " + include + "\n");
    return violations(file, text).size();
}

// Calls each(file, text) for every header and source of the product.
template <class Each>
void for_each_source(const std::vector<std::string>& folders, const Each& each) {
    for (const std::string& folder : folders)
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(BRAITENLAB_SOURCE) / folder)) {
            if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
            std::ifstream text(entry.path());
            each(fs::relative(entry.path(), BRAITENLAB_SOURCE).generic_string(), text);
        }
}

TEST(Architecture, IncludesGoOnlyToLowerLayers) {
    int files = 0;
    for_each_source({"core", "render", "ui", "app"}, [&](const std::string& file, std::istream& text) {
        ++files;
        for (const auto& violation : violations(file, text)) ADD_FAILURE() << violation;
    });
    EXPECT_GT(files, 50);
}

// A header and its source are one unit, named without extension.
std::string unit_of(const std::string& file) { return file.substr(0, file.rfind('.')); }

using Units = std::map<std::string, std::set<std::string>>;  // a unit, and those that it includes

void add_includes(Units& units, const std::string& file, std::istream& text) {
    static const std::regex own{R"(^\s*#include "([^"]+)\")"};
    auto& included = units[unit_of(file)];
    std::smatch match;
    for (std::string line; std::getline(text, line);)
        if (std::regex_search(line, match, own)) included.insert(unit_of(match[1]));
}

std::set<std::string> reached_from(const Units& units, const std::string& start) {
    std::set<std::string> reached;
    std::vector<std::string> open{start};
    while (!open.empty()) {
        const auto unit = units.find(open.back());
        open.pop_back();
        if (unit == units.end()) continue;
        for (const std::string& next : unit->second)
            if (reached.insert(next).second) open.push_back(next);
    }
    return reached;
}

// The largest set of units that all include each other, directly or not.
std::set<std::string> largest_cycle(const Units& units) {
    std::map<std::string, std::set<std::string>> reached;
    for (const auto& [unit, included] : units) reached[unit] = reached_from(units, unit);
    std::set<std::string> largest;
    for (const auto& [unit, others] : reached) {
        std::set<std::string> cycle;
        for (const std::string& other : others)
            if (reached[other].contains(unit)) cycle.insert(other);
        if (cycle.size() > largest.size()) largest = cycle;
    }
    return largest;
}

TEST(Architecture, NoMoreThanThreeUnitsIncludeEachOther) {
    Units units;
    for_each_source({"core", "render", "ui", "app"},
                    [&](const std::string& file, std::istream& text) { add_includes(units, file, text); });
    const std::set<std::string> cycle = largest_cycle(units);
    EXPECT_LE(cycle.size(), 3u) << testing::PrintToString(cycle);
    const Units round{{"a", {"b"}}, {"b", {"c"}}, {"c", {"d"}}, {"d", {"a", "e"}}, {"e", {}}};
    EXPECT_EQ(largest_cycle(round).size(), 4u);
}

TEST(Architecture, AFeatureIncludesNoOtherFeatureAndNotTheLab) {
    int features = 0;
    for_each_source({"app/features"}, [&](const std::string& file, std::istream& text) {
        Units units;
        add_includes(units, file, text);
        ++features;
        for (const std::string& included : units[unit_of(file)])
            EXPECT_TRUE(included == unit_of(file) || !(included.starts_with("app/features/") || included == "app/lab"))
                << file << " includes " << included;
    });
    EXPECT_GT(features, 10);
}

// The numbers of members of the structs and classes of a text that is formatted as .clang-format says; those of structs
// inside them do not count.
std::map<std::string, int> members_of(std::istream& text) {
    static const std::regex begin{R"(^(?:struct|class) (\w+)[^;]*\{$)"}, comment{R"(\s*//.*)"},
        in_brackets{R"(\{[^{}]*\}|<[^<>]*>)"}, value{"=[^,;]*"},
        no_member{R"(^((using|friend|static|explicit|enum|struct|virtual) |\};))"};
    std::map<std::string, int> counts;
    std::string name, declaration;
    std::smatch match;
    for (std::string line; std::getline(text, line);) {
        line = std::regex_replace(line, comment, "");
        if (std::regex_search(line, match, begin)) name = match[1];
        if (line == "};") name.clear();
        if (name.empty() || line.size() < 4) continue;
        if (declaration.empty() && (!line.starts_with("    ") || line.starts_with("     "))) continue;
        declaration += line.substr(4);
        const char last = declaration.back();
        if (last != ';' && last != '{' && last != '}' && last != ':') continue;  // it goes on in the next line
        for (std::string before; before != declaration;)
            before = declaration, declaration = std::regex_replace(declaration, in_brackets, "");
        declaration = std::regex_replace(declaration, value, "");
        const bool is_function = declaration.find('(') != std::string::npos;
        if (last == ';' && !is_function && !std::regex_search(declaration, no_member))
            counts[name] += 1 + static_cast<int>(std::count(declaration.begin(), declaration.end(), ','));
        declaration.clear();
    }
    return counts;
}

TEST(Architecture, NoStructOfTheWindowOrTheLabHasMoreThan25Members) {
    int structs = 0;
    for_each_source({"ui", "app"}, [&](const std::string& file, std::istream& text) {
        for (const auto& [name, count] : members_of(text)) {
            ++structs;
            EXPECT_LE(count, 25) << file << ": " << name;
        }
    });
    EXPECT_GT(structs, 100);
    std::istringstream example(
        "struct Example {\n"
        "    int a = 0, b = f(1);  // and\n"
        "    std::map<int, std::pair<int, int>> c{1, 2};\n"
        "    std::array<int, 2>\n        d = {1, 2};  // too long for one line\n"
        "    int sum(int,\n            int) const;\n"
        "    bool any() const { return a; }\n"
        "    struct Part {\n        int e;\n    } part;\n"
        "    struct Other {\n        int f;\n    };\n"
        "};\n");
    EXPECT_EQ(members_of(example)["Example"], 5);
}

// True for a source that is compiled differently on a platform.
bool asks_for_platform(const std::string& text) {
    static const std::regex macro{R"(\b(_WIN32|_WIN64|__EMSCRIPTEN__|__linux__|__APPLE__)\b)"};
    return std::regex_search(text, macro);
}

TEST(Architecture, AsksForThePlatformInOneFolderOnly) {
    for (const char* top : {"core", "render", "ui", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(BRAITENLAB_SOURCE) / top)) {
            const std::string file = fs::relative(entry.path(), BRAITENLAB_SOURCE).generic_string();
            if (!entry.is_regular_file() || file.starts_with("app/platform/")) continue;
            std::ifstream stream(entry.path());
            const std::string text{std::istreambuf_iterator<char>(stream), {}};
            EXPECT_FALSE(asks_for_platform(text)) << file << ": put what differs into app/platform";
        }
    EXPECT_TRUE(asks_for_platform("#ifdef _WIN32\n"));
}

// True for a line that sets a gap or a padding to a number of its own.
bool has_own_gap(const std::string& line) {
    static const std::regex number{R"((SameLine|Dummy|ItemSpacing|FramePadding|WindowPadding)\b.*px\(\d+\))"};
    return std::regex_search(line, number);
}

TEST(Architecture, TakesTheGapsOfTheWindowFromTheSpacingGrid) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(BRAITENLAB_SOURCE) / "ui")) {
        if (!entry.is_regular_file() || entry.path().extension() != ".cpp") continue;
        std::ifstream stream(entry.path());
        int number = 0;
        for (std::string line; std::getline(stream, line);)
            EXPECT_FALSE(++number && has_own_gap(line))
                << entry.path().string() << ":" << number << ": use a value of spacing:: (ui/widgets/theme.h)";
    }
    EXPECT_TRUE(has_own_gap("ImGui::SameLine(0, ui.px(6));"));
    EXPECT_FALSE(has_own_gap("ImGui::SameLine(0, ui.px(spacing::small));"));
}

TEST(Architecture, FindsAnIncludeOfAHigherLayer) {
    EXPECT_EQ(count_violations("core/brain/brain.cpp", "\"core/world/world.h\""), 1u);
    EXPECT_EQ(count_violations("core/sensing/outline.cpp", "\"core/world/snapshot.h\""), 1u);
    EXPECT_EQ(count_violations("core/world/world.cpp", "\"core/io/run_file.h\""), 1u);
    EXPECT_EQ(count_violations("core/world/world.cpp", "<box2d/box2d.h>"), 1u);
    for (const char* file : {"app/files/settings.cpp", "ui/words/strings.cpp", "core/scene/scene_file.cpp"})
        EXPECT_EQ(count_violations(file, "<toml++/toml.h>"), 1u) << file << ": call parse_toml()";
    for (const char* file : {"app/files/autosave.cpp", "core/io/json.h", "core/lesson/progress.cpp"})
        EXPECT_EQ(count_violations(file, "<nlohmann/json.hpp>"), 1u) << file << ": include core/io/checked_json.h";
    EXPECT_EQ(count_violations("ui/panels/map/map_card.cpp", "\"ui/panels/study/study_draft.h\""), 1u);
    EXPECT_EQ(count_violations("ui/panels/map/map_card.cpp", "\"ui/wiring/canvas.h\""), 0u);
    EXPECT_EQ(count_violations("ui/panels/map/map_card.cpp", "\"ui/panels/cards.h\""), 0u);
    EXPECT_EQ(count_violations("core/brain/brain.cpp", "\"core/brain/graph.h\""), 0u);
    EXPECT_EQ(count_violations("core/brain/brain.cpp", "\"core/result.h\""), 0u);
    EXPECT_EQ(count_violations("core/brain/brain.cpp", "<vector>"), 0u);
    EXPECT_EQ(count_violations("ui/panels/toolbar.cpp", "\"ui/window_layout.h\""), 1u);
    EXPECT_EQ(count_violations("ui/panels/toolbar.cpp", "\"ui/widgets/ui.h\""), 0u);
    EXPECT_EQ(count_violations("ui/widgets/item.cpp", "\"ui/panels/panels.h\""), 1u);
    EXPECT_EQ(count_violations("ui/widgets/item.cpp", "\"ui/words/strings.h\""), 0u);
    EXPECT_EQ(count_violations("ui/words/strings.cpp", "\"ui/request.h\""), 1u);
    EXPECT_EQ(count_violations("ui/wiring/canvas.cpp", "\"ui/scene_input/edits.h\""), 1u);
    EXPECT_EQ(count_violations("ui/request.h", "\"ui/widgets/ui.h\""), 1u);
}

TEST(Architecture, FindsAnInternalHeaderIncludedFromOutside) {
    EXPECT_EQ(count_violations("core/lesson/referee.cpp", "\"core/world/state.h\""), 1u);
    EXPECT_EQ(count_violations("app/lab.cpp", "\"core/world/physics.h\""), 1u);
    EXPECT_EQ(count_violations("core/io/state_json.cpp", "\"core/world/state.h\""), 0u);
    EXPECT_EQ(count_violations("core/session/session.cpp", "\"core/world/cosmetic_edits.h\""), 0u);
}

TEST(Architecture, EveryInternalHeaderExists) {
    for (const auto& [header, places] : internal_headers)
        EXPECT_TRUE(fs::exists(fs::path(BRAITENLAB_SOURCE) / header)) << header;
}

}  // namespace
}  // namespace braitenlab::tests::architecture_test
