#include "core/lesson/submitter.h"

#include <algorithm>
#include <optional>

#include "core/text_parts.h"

namespace braitenlab {

namespace {

bool is_number(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::optional<Submitter> of_moodle(std::string_view name) {
    const std::string_view person = name.substr(0, name.find("_assignsubmission_"));
    const std::size_t before_id = person.rfind('_');
    if (person.size() == name.size() || before_id == 0 || before_id == std::string_view::npos) return std::nullopt;
    const std::string_view id = person.substr(before_id + 1);
    if (!is_number(id)) return std::nullopt;
    return Submitter{{}, std::string(id), std::string(person.substr(0, before_id)), std::string(person)};
}

std::optional<Submitter> of_ilias(std::string_view folder) {
    const auto parts = parts_of(folder, '_');
    const bool has_gap = std::any_of(parts.begin(), parts.end(), [](std::string_view part) { return part.empty(); });
    if (parts.size() < 4 || has_gap || !is_number(parts.back())) return std::nullopt;
    const std::string &last_name = parts[0], &login = parts[parts.size() - 2];
    std::string first_name = parts[1];
    for (std::size_t i = 2; i + 2 < parts.size(); ++i) first_name += " " + parts[i];
    return Submitter{{}, parts.back(), last_name + " " + first_name, std::string(folder), last_name, first_name, login};
}

std::optional<Submitter> of_canvas(std::string_view file) {
    const auto parts = parts_of(file, '_');
    const std::size_t id = parts.size() > 1 && parts[1] == "LATE" ? 2 : 1;
    const bool has_numbers = parts.size() > id + 2 && is_number(parts[id]) && is_number(parts[id + 1]);
    if (!has_numbers || parts[0].empty()) return std::nullopt;
    const std::string &name = parts[0], &number = parts[id];
    return Submitter{{}, number, name, name + "_" + number};
}

}  // namespace

Submitter submitter_of(std::string_view path) {
    const auto names = parts_of(path, '/');
    for (std::size_t i = 0; i + 1 < names.size(); ++i) {
        auto found = of_moodle(names[i]);
        if (!found) found = of_ilias(names[i]);
        if (!found) continue;
        found->folder = names[i];
        return *found;
    }
    auto found = of_moodle(names.back());
    if (!found) found = of_canvas(names.back());
    if (!found) found.emplace();
    if (names.size() > 1) found->folder = names.front();
    return *found;
}

std::size_t folders_around(const std::vector<std::string>& paths) {
    std::size_t around = 0;
    while (!paths.empty()) {
        const std::size_t end = paths.front().find('/', around);
        if (end == std::string::npos) return around;
        const std::string first = paths.front().substr(0, end + 1);
        const bool is_common =
            std::all_of(paths.begin(), paths.end(), [&](const std::string& path) { return path.starts_with(first); });
        if (!is_common || !submitter_of(first.substr(around)).person.empty()) return around;
        around = first.size();
    }
    return around;
}

}  // namespace braitenlab
