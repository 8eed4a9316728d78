#include "app/files/breeding_files.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "core/evolve/breeding_json.h"
#include "core/messages.h"
#include "core/scene/file_kind.h"
#include "core/scene/scene_file.h"
#include "core/scene/toml_tree.h"

namespace braitenlab {

namespace fs = std::filesystem;
using evolve::Breeding;
using evolve::BreedingBase;

namespace {

constexpr std::uintmax_t most_bytes = 64U << 20U;  // of a state; about 1 kB a generation

struct TextOfFile {
    fs::path path;
    std::string text;
};

std::array<TextOfFile, 2> breeding_texts(const BreedingBase& base, const fs::path& folder) {
    Breeding breeding = base.breeding();
    breeding.scene = "scene.toml";
    return {TextOfFile{folder / breeding.scene, write_scene(base.scene())},
            TextOfFile{breeding_in(folder), evolve::write_breeding(breeding)}};
}

}  // namespace

std::vector<Breeding> shipped_breeding_list() {
    std::vector<Breeding> breedings;
    for (const fs::path& path : shipped_breedings())
        if (const auto text = read_text(path))
            if (auto breeding = evolve::parse_breeding(*text, path.string())) breedings.push_back(std::move(*breeding));
    std::sort(breedings.begin(), breedings.end(), [](const Breeding& a, const Breeding& b) { return a.id < b.id; });
    return breedings;
}

fs::path breeding_in(const fs::path& folder) { return folder / "breeding.toml"; }

fs::path state_in(const fs::path& folder) { return folder / "state.json"; }

bool holds_breeding(const fs::path& folder) {
    std::error_code none;
    return fs::is_regular_file(state_in(folder), none);  // reading a pipe could block
}

Result<std::shared_ptr<const BreedingBase>> load_breeding(const fs::path& path) {
    const auto text = read_text(path);
    if (!text) return text.error();
    auto breeding = evolve::parse_breeding(*text, path.string());
    if (!breeding) return breeding.error();
    const auto scene = scene_at_key(path, *text, breeding->scene);
    if (!scene) return scene.error();
    const auto scene_text = read_text(*scene);
    if (!scene_text) return scene_text.error();
    return BreedingBase::create(std::move(*breeding), *scene_text, scene->string());
}

std::vector<Error> errors_of_breeding(const fs::path& path) {
    const auto text = read_text(path);
    if (!text) return {text.error()};
    auto [breeding, errors] = evolve::read_breeding_fully(*text, path.string());
    std::erase_if(breeding.breeds, [](const evolve::Breed& each) { return each.kind.empty(); });
    if (!breeding.scene.empty()) {
        const auto scene = scene_at_key(path, *text, breeding.scene);
        const auto scene_text = scene ? read_text(*scene) : scene.error();
        const auto more = scene_text ? BreedingBase::errors(std::move(breeding), *scene_text, scene->string())
                                     : std::vector<Error>{scene_text.error()};
        errors.insert(errors.end(), more.begin(), more.end());
    }
    return in_order(std::move(errors), path.string());
}

std::optional<Error> other_breeding_fault(const BreedingBase& base, const fs::path& folder) {
    for (const TextOfFile& each : breeding_texts(base, folder)) {
        std::error_code none;
        if (!fs::exists(each.path, none)) continue;
        const auto text = read_text(each.path);
        if (!text || *text != each.text)
            return Error{"the breeding would write over this file; give another folder", each.path.string()};
    }
    return std::nullopt;
}

std::optional<Error> write_breeding_files(const BreedingBase& base, const fs::path& folder) {
    std::vector<NewFile> files;
    const auto texts = breeding_texts(base, folder);
    for (const TextOfFile& each : texts) files.push_back({each.path, each.text});
    return write_all(files);
}

std::optional<Error> write_breeding_state(const BreedingBase& base, const evolve::BreedingState& state,
                                          const fs::path& folder) {
    FileWriter file(state_in(folder), false);
    file.write(evolve::write_state(base, state));
    return file.commit();
}

fs::path kept_breeding(const fs::path& all, const BreedingBase& base) {
    return all / fmt::format("{:016x}", base.fingerprint());
}

void drop_oldest_breedings(const fs::path& all, std::size_t most, std::uintmax_t bytes) {
    std::error_code none;
    std::vector<std::pair<fs::file_time_type, fs::path>> kept;
    for (fs::directory_iterator each(all, none), end; each != end; each.increment(none))
        if (holds_breeding(each->path()))
            kept.emplace_back(fs::last_write_time(state_in(each->path()), none), each->path());
    std::sort(kept.rbegin(), kept.rend());
    std::uintmax_t sum = 0;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        std::error_code problem;
        const std::uintmax_t size = fs::file_size(state_in(kept[i].second), problem);
        sum += problem ? 0 : size;
        if (i > 0 && (i >= most || sum > bytes)) fs::remove_all(kept[i].second, none);
    }
}

Result<evolve::BreedingState> read_breeding_state(const BreedingBase& base, const fs::path& folder) {
    const fs::path path = state_in(folder);
    const auto text = read_text(path, most_bytes, "run_too_large");
    return text ? evolve::read_state(base, *text, path.string()) : text.error();
}

}  // namespace braitenlab
