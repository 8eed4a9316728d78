#include "core/lesson/shipped_hashes.h"

#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "core/io/json.h"
#include "core/lesson/exercise_file.h"
#include "core/scene/file_kind.h"
#include "core/scene/folder_entries.h"
#include "core/scene/scene_file.h"
#include "core/world/world.h"

namespace braitenlab {

namespace {

namespace fs = std::filesystem;

Result<std::string> hash_after(const Scene& scene, std::uint64_t seed, double seconds) {
    auto world = World::create(scene, seed);
    if (!world) return world.error();
    const auto end = static_cast<std::uint64_t>(std::llround(seconds * 60));
    while (world->tick() < end) world->step();
    return fmt::format("{:016x}", world->hash());
}

Result<std::vector<fs::path>> toml_files_of(const fs::path& folder) {
    std::vector<fs::path> files;
    for_each_entry(folder, [&files](const fs::directory_entry& entry) {
        if (entry.path().extension() == ".toml") files.push_back(entry.path());
    });
    if (files.empty()) return Error{"this folder has no scene or exercise", folder.string()};
    return files;
}

Result<std::string> hash_of_scene(const fs::path& file, double seconds) {
    const auto scene = load_scene(file);
    if (!scene) return scene.error();
    return hash_after(*scene, 1, seconds);
}

Result<std::string> hash_of_exercise(const fs::path& file, double seconds) {
    const auto exercise = load_exercise(file);
    if (!exercise) return exercise.error();
    return hash_after(exercise->scene, exercise->seed, seconds);
}

std::optional<Error> add_hashes(Hashes& hashes, const fs::path& folder,
                                Result<std::string> (*hash_of)(const fs::path&, double), double seconds) {
    const auto files = toml_files_of(folder);
    if (!files) return files.error();
    for (const fs::path& file : *files) {
        auto hash = hash_of(file, seconds);
        if (!hash) return hash.error();
        hashes[file.stem().string()] = std::move(*hash);
    }
    return std::nullopt;
}

}  // namespace

Result<Hashes> hashes_of_shipped(const fs::path& exercises, double seconds) {
    Hashes hashes;
    if (auto error = add_hashes(hashes, exercises / "scenes", hash_of_scene, seconds)) return *error;
    if (auto error = add_hashes(hashes, exercises / "guided", hash_of_exercise, seconds)) return *error;
    return hashes;
}

Result<Hashes> read_hashes(const fs::path& file) {
    const auto text = read_text(file);
    if (!text) return text.error();
    try {
        return io::Json::parse(*text).get<Hashes>();
    } catch (const io::Json::exception&) {
        return Error{"this is not a JSON object of names and hashes", file.string()};
    }
}

std::string write_hashes(const Hashes& hashes) { return io::json_text(io::Json(hashes), 2) + "\n"; }

std::vector<std::string> differences(const Hashes& computed, const Hashes& expected) {
    std::vector<std::string> lines;
    for (const auto& [name, hash] : computed) {
        const auto other = expected.find(name);
        if (other == expected.end())
            lines.push_back(fmt::format("{}: {}, no hash is expected", name, hash));
        else if (other->second != hash)
            lines.push_back(fmt::format("{}: {}, expected {}", name, hash, other->second));
    }
    for (const auto& [name, hash] : expected)
        if (!computed.contains(name)) lines.push_back(fmt::format("{}: not run, expected {}", name, hash));
    return lines;
}

}  // namespace braitenlab
