// Pictures of scenes and exercises at their start, for the file browser: rendered once and kept in the user's cache
// folder.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/still.h"
#include "ui/lab_view.h"

namespace braitenlab {

// The name of a picture in the cache: it depends on the content of the file, the program's version and the theme.
std::string cached_picture_name(std::string_view content, std::string_view version, Theme);

class Gallery {
public:
    // An empty folder: nothing is kept.
    explicit Gallery(std::filesystem::path cache) : cache_(std::move(cache)) {}

    // Reads or renders the picture of the first of these files that has none in this theme: one in a call, so that no
    // frame becomes long. False if all have been tried. Precondition: a current GL context.
    bool make_next(render::Renderer&, const std::vector<std::string>& files, Theme);

    const ScenePictures& pictures() const { return pictures_; }

private:
    void make(render::Renderer&, const std::string& file);

    std::filesystem::path cache_;
    Theme theme_ = Theme::dark;
    std::map<std::string, render::Still> stills_;
    ScenePictures pictures_;  // 0: tried in vain
};

}  // namespace braitenlab
