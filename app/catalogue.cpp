#include "app/catalogue.h"

#include "app/data.h"
#include "core/lesson/exercise.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

std::vector<CatalogueEntry> read_catalogue() {
    std::vector<CatalogueEntry> catalogue;
    for (const auto& path : shipped_exercises())
        if (const auto exercise = load_exercise(path))
            catalogue.push_back({path.stem().string(), path.string(), exercise->title, "", exercise->number});
    for (const auto& path : shipped_scenes())
        if (const auto scene = load_scene(path))
            catalogue.push_back({path.stem().string(), path.string(), scene->title, scene->story});
    return catalogue;
}

}  // namespace braitenlab
