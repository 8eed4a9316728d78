// braitenctl export and think: a brain as a program for a robot, and the vectors that test such a program.
#include "core/export/export.h"

#include <filesystem>
#include <iostream>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/ctl/ctl.h"
#include "app/ctl/outputs.h"
#include "app/ctl/table_file.h"
#include "app/files/export_folder.h"
#include "app/terminal.h"
#include "core/brain/presets.h"
#include "core/export/vectors.h"
#include "core/lesson/hand_in.h"
#include "core/scene/nearest.h"

namespace braitenlab {

namespace {

Result<robots::BrainToExport> brain_to_export(const std::string& file, const BrainChoice& choice) {
    auto found = brain_of_file(file, choice);
    if (!found) {
        const Preset* preset = find_preset(file);
        if (!preset) return found.error();
        return robots::BrainToExport{file, preset->brain, {}};
    }
    std::string stem = std::filesystem::path(file).stem().string();
    if (is_hand_in(file)) stem = std::filesystem::path(stem).stem().string();
    const std::string title = found->owner.empty() ? stem : stem + ", " + found->owner;
    return robots::BrainToExport{
        title,     std::move(found->brain), std::move(found->sensors), found->length, found->width, found->ambient,
        found->lux};
}

Result<robots::Target> target_of(const std::string& given) {
    if (given.empty())
        return Error{fmt::format("is missing; give one of {}", fmt::join(words_of(robots::target_table), ", ")),
                     "--to"};
    return named_in(robots::target_table, given, "there is no target", "--to");
}

Result<const robots::Robot*> robot_of(const std::string& given, robots::Target target) {
    const std::string name = given.empty() ? std::string(row_of(target).robot) : given;
    if (const robots::Robot* robot = robots::find_robot(name)) return robot;
    return Error{"there is no robot " + in_quotes(name) + name_nearest(name, known_names(robots::robots())), "--robot"};
}

}  // namespace

int export_to_robot(const ExportOptions& options) {
    const auto target = target_of(options.target);
    if (!target) return complain(target.error());
    const auto robot = robot_of(options.robot, *target);
    if (!robot) return complain(robot.error());
    const auto brain = brain_to_export(options.file, options.choice);
    if (!brain) return complain(brain.error());
    auto files = robots::export_brain(*brain, *target, **robot);
    if (!files) {
        Error error = files.error();
        error.file = options.file;
        return complain(error);
    }
    if (auto error = export_folder_fault(options.folder); error && !options.force) {
        error->what += ", or --force to write into it";
        return complain(*error);
    }
    if (const auto edited = edited_files(options.folder, *files); !edited.empty() && !options.force)
        return complain({fmt::format("these files are not as an export wrote them: {}; give another folder, or "
                                     "--force to replace them",
                                     fmt::join(edited, ", ")),
                         options.folder});
    std::vector<std::filesystem::path> written;
    for (const robots::ExportedFile& file : *files)
        written.push_back(std::filesystem::path(options.folder) / file.name);
    if (const auto error = output_fault(options.file, written)) return complain(*error);
    if (const auto error = write_export(options.folder, *files)) return complain(*error);
    for (const Error& warning : robots::export_warnings(*brain, **robot))
        std::cerr << format_lines("braitenctl: warning: {}\n", warning.text());
    for (const std::filesystem::path& path : written) std::cout << format_lines("{}\n", path.string());
    return exit_code::done;
}

int think_vectors(const ThinkOptions& options) {
    const auto brain = brain_to_export(options.file, options.choice);
    if (!brain) return complain(brain.error());
    const auto vectors =
        robots::golden_vectors(*brain, static_cast<float>(options.rate_hz), options.ticks, options.seed);
    if (!vectors) return complain(vectors.error());
    if (const auto error = write_table(options.vectors, {}, robots::write_csv(*vectors))) return complain(*error);
    return exit_code::done;
}

}  // namespace braitenlab
