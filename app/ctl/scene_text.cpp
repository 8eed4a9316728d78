// The text of a scene's file for the commands that run scenes.
#include <fmt/format.h>

#include "app/ctl/ctl.h"
#include "core/scene/file_kind.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

Result<std::string> read_scene_text(const std::filesystem::path& path, std::string_view command,
                                    std::string_view takes) {
    auto text = read_text(path);
    if (!text) return text;
    const auto other = [&](std::string_view kind, std::string_view advice) {
        return Error{fmt::format("this is {}, and '{}' takes {}; {}", kind, command, takes, advice), path.string()};
    };
    switch (detect_kind(path, *text)) {
        case FileKind::exercise:
            return other("an exercise",
                         "use 'check' to test the exercise, 'grade' for a brain or hand-ins, 'show' to print it");
        case FileKind::lecture:
            return other("a lecture", "use 'check' to test the lecture");
        case FileKind::study:
            return other("a study", "use 'study' to run it");
        case FileKind::brain:
            return other("a brain alone", "use 'grade EXERCISE FILE'");
        default:
            return text;
    }
}

}  // namespace braitenlab
