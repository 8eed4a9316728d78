// The house's floors: a file includes only what stands on its own floor or below.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace braitenlab::tests::architecture_test {
namespace {

namespace fs = std::filesystem;

// Each folder with the folders it may include besides itself.
const std::map<std::string, std::vector<std::string>> may_include{
    {"core/maths", {}},
    {"core/mechanics", {"core/maths"}},
    {"core/brain", {"core/maths", "core"}},
    {"core/scene", {"core/maths", "core/brain", "core"}},
    {"core/world", {"core/maths", "core/mechanics", "core/brain", "core/scene", "core"}},
    {"core/session", {"core/maths", "core/brain", "core/scene", "core/world", "core"}},
    {"core/lesson", {"core/maths", "core/brain", "core/scene", "core/world", "core"}},
    {"core", {}},
    {"render/view", {"core"}},
    {"render/text", {"core", "render/view"}},
    {"render/gl", {"core", "render/view", "render/text"}},
    {"ui", {"core", "render/view", "ui"}},
    {"app", {"core", "render", "ui"}},
};

// What Dear ImGui, OpenGL, windows and Box2D are called in an include, and the only places that may know them.
const std::map<std::string, std::vector<std::string>> libraries{
    {"<box2d/", {"core/world/physics.cpp"}},
    {"<GL/", {"render/gl/", "app/window.cpp"}},
    {"<GLFW/", {"app/window.cpp"}},
    {"<imgui", {"ui/", "app/"}},
    {"<nlohmann/", {"core/world/json.h", "app/"}},
};

std::string folder_of(const std::string& file) {
    std::string best;
    for (const auto& [folder, allowed] : may_include)
        if (file.starts_with(folder + "/") && folder.size() > best.size()) best = folder;
    return best;
}

bool lies_in(const std::string& file, const std::string& folder) {
    // "core" alone names the files right inside it when asked from within core, and all of core from above.
    return file.starts_with(folder + "/");
}

std::vector<std::string> violations(const std::string& file, std::istream& text) {
    static const std::regex own{R"(^\s*#include "([^"]+)\")"}, system{R"(^\s*#include (<[^>]+>))"};
    std::vector<std::string> found;
    const std::string folder = folder_of(file);
    std::smatch match;
    for (std::string line; std::getline(text, line);) {
        if (std::regex_search(line, match, own)) {
            const std::string target = match[1];
            if (folder_of(target).empty() || lies_in(target, folder)) continue;
            bool allowed = false;
            for (const std::string& below : may_include.at(folder)) {
                const bool inside_core = folder.starts_with("core") && below == "core";
                allowed |= inside_core ? folder_of(target) == "core" : lies_in(target, below);
            }
            if (!allowed) found.push_back(file + " includes " + target);
        } else if (std::regex_search(line, match, system)) {
            const std::string target = match[1];
            for (const auto& [library, places] : libraries) {
                if (!target.starts_with(library)) continue;
                bool allowed = false;
                for (const std::string& place : places) allowed |= file.starts_with(place);
                if (!allowed) found.push_back(file + " includes " + target);
            }
        }
    }
    return found;
}

TEST(Architecture, IncludesRunDownwardsOnly) {
    int files = 0;
    for (const char* top : {"core", "render", "ui", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(BRAITENLAB_SOURCE) / top)) {
            if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
            std::ifstream text(entry.path());
            ++files;
            for (const auto& violation :
                 violations(fs::relative(entry.path(), BRAITENLAB_SOURCE).generic_string(), text))
                ADD_FAILURE() << violation;
        }
    EXPECT_GT(files, 50);
}

TEST(Architecture, FindsAnIncludeThatRunsUpwards) {
    std::istringstream upwards{"#include \"core/world/world.h\"\n"}, physics{"#include <box2d/box2d.h>\n"},
        fine{"#include \"core/brain/graph.h\"\n#include \"core/result.h\"\n#include <vector>\n"};
    EXPECT_EQ(violations("core/brain/brain.cpp", upwards).size(), 1u);
    EXPECT_EQ(violations("core/world/world.cpp", physics).size(), 1u);
    EXPECT_EQ(violations("core/brain/brain.cpp", fine).size(), 0u);
}

}  // namespace
}  // namespace braitenlab::tests::architecture_test
