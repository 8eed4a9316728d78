#include "ui/panels/course/pages.h"

#include <algorithm>

namespace braitenlab::ui {

std::vector<std::string> pages_in(std::string_view text) {
    constexpr std::string_view folder = "docs/", ending = ".md", letters = "abcdefghijklmnopqrstuvwxyz0123456789-";
    std::vector<std::string> pages;
    for (std::size_t at = text.find(folder); at != std::string_view::npos; at = text.find(folder, at + 1)) {
        const std::size_t name = at + folder.size();
        const std::size_t end = std::min(text.find_first_not_of(letters, name), text.size());
        if (end == name || text.substr(end, ending.size()) != ending) continue;
        std::string page(text.substr(at, end + ending.size() - at));
        if (std::find(pages.begin(), pages.end(), page) == pages.end()) pages.push_back(std::move(page));
    }
    return pages;
}

}  // namespace braitenlab::ui
