// braitenctl link: a scene or an exercise as a link, and a link as the file of a scene.
#include "core/io/link.h"

#include <iostream>

#include "app/ctl/ctl.h"
#include "app/files/data.h"
#include "app/files/safe_file.h"
#include "app/terminal.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

namespace {

int print_link(const LinkOptions& options) {
    const auto path = find_shipped(options.what);
    if (!path) return complain(path.error());
    for (const std::filesystem::path& exercise : shipped_exercises())
        if (exercise == *path) {
            std::cout << format_lines("{}{}\n", options.base, io::encode_exercise_link(path->stem().string()));
            return exit_code::done;
        }
    const auto text = read_scene_text(*path, "link", "a scene or a shipped exercise");
    if (!text) return complain(text.error());
    const auto scene = parse_scene(*text, path->string());
    if (!scene) return complain(scene.error());
    const std::string link = options.base + io::encode_link(*scene);
    std::cout << format_lines("{}\n", link);
    if (link.size() > io::safe_link)
        std::cerr << "braitenctl: the link has " << link.size() << " characters; "
                  << (link.size() > io::longest_useful_link ? "most" : "some")
                  << " chat programs cut a link of this length\n";
    return exit_code::done;
}

int open_link(const LinkOptions& options) {
    const auto linked = io::decode_link(options.what);
    if (!linked) return complain(linked.error());
    if (!linked->exercise.empty())
        return complain({"this link is to the exercise " + linked->exercise + " and holds no scene", "link"});
    const std::string text = write_scene(linked->scene);
    if (options.out.empty())
        std::cout << text;
    else if (const auto error = write_whole(options.out, text))
        return complain(*error);
    return exit_code::done;
}

}  // namespace

int link(const LinkOptions& options) {
    if (io::is_link(options.what)) return open_link(options);
    if (!options.out.empty()) return complain({"only the scene of a link is written; a link is printed", "--out"});
    return print_link(options);
}

}  // namespace braitenlab
