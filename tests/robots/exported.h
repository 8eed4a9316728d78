// Exported brains for tests: which brains, and how a program is run and compared with golden vectors.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/files/data.h"
#include "core/brain/presets.h"
#include "core/export/export.h"
#include "core/export/vectors.h"
#include "core/scene/scene_file.h"
#include "tests/folder.h"
#include "tests/shell.h"

namespace braitenlab::tests {

// Every preset, and the brain of every kind of the shipped scenes.
inline std::vector<robots::BrainToExport> shipped_brains() {
    std::vector<robots::BrainToExport> brains;
    for (const Preset& preset : presets()) brains.push_back({std::string(preset.name), preset.brain, {}});
    for (const auto& path : shipped_scenes()) {
        const auto scene = load_scene(path);
        if (!scene) continue;
        for (const Kind& kind : scene->kinds)
            brains.push_back({path.stem().string() + " " + kind.name, kind.brain, kind.sensors});
    }
    return brains;
}

// Calls `test` with each shipped brain that a target exports, the same brain once, and its files. Each other brain is
// refused with the name of a part in quotes.
template <class Test>
void each_exported(robots::Target target, std::string_view robot, Test test) {
    std::vector<BrainGraph> done;
    for (const robots::BrainToExport& brain : shipped_brains()) {
        const auto files = robots::export_brain(brain, target, *robots::find_robot(robot));
        if (!files) {
            EXPECT_NE(files.error().what.find('\''), std::string::npos) << files.error().what;
            continue;
        }
        if (std::find(done.begin(), done.end(), brain.brain) != done.end()) continue;
        done.push_back(brain.brain);
        test(brain, *files);
    }
    EXPECT_GT(done.size(), 8u);
}

// True if ./dev robots runs the tests and has installed this package; other tests that need it are skipped.
inline bool has_tool(std::string_view package) {
    const char* installed = std::getenv("BRAITENLAB_ROBOTS");
    return installed && fmt::format(" {} ", installed).find(fmt::format(" {} ", package)) != std::string::npos;
}

}  // namespace braitenlab::tests
