#include "app/files/links.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/data.h"
#include "core/io/link.h"
#include "core/lesson/submission.h"
#include "core/messages.h"
#include "core/plain_letters.h"
#include "core/scene/nearest.h"

namespace braitenlab {

namespace {

// A name for a file: the letters and digits of the title with a '-' between its words.
std::string name_of_title(const std::string& title) {
    const std::string name = with_dashes(title);
    return name.empty() ? "link" : name;
}

// True if the student has changed the vehicle of the open exercise.
bool is_changed(const Document& document) {
    const Exercise& exercise = *document.lesson->exercise;
    return is_edited(exercise, submission_of(exercise, document.session.snapshot()));
}

}  // namespace

void copy_link(Lab& lab) {
    const Document& document = lab.document;
    const bool is_exercise = document.lesson && ships(document.path), has_work = is_exercise && is_changed(document);
    const bool names_exercise = is_exercise && !has_work;
    lab.window.to_copy = lab.link_base + (names_exercise ? io::encode_exercise_link(document.path.stem().string())
                                                         : io::encode_link(scene_to_keep(document)));
    const std::size_t length = lab.window.to_copy.size();
    const std::string characters = std::to_string(length);
    if (names_exercise)
        say(lab, {NoticeKind::done, "notice.link_exercise", characters});
    else if (length > io::longest_useful_link)
        say(lab, {NoticeKind::notice, "notice.link_too_long", characters, std::to_string(io::longest_useful_link)});
    else if (length > io::safe_link)
        say(lab, {NoticeKind::notice, "notice.link_long", characters, std::to_string(io::safe_link)});
    else
        say(lab, {NoticeKind::done, has_work ? "notice.link_work" : "notice.link", characters});
}

Result<Document> linked_document(Scene scene, std::uint64_t seed) {
    auto session = Session::open(scene, seed);
    if (!session) return session.error();
    Document document{.session = std::move(*session)};
    document.name = name_of_title(scene.title);
    document.file = std::make_shared<const Scene>(std::move(scene));
    return document;
}

Result<std::filesystem::path> linked_exercise(const std::string& name) {
    const auto shipped = shipped_exercises();
    const auto found = std::find_if(shipped.begin(), shipped.end(),
                                    [&](const std::filesystem::path& path) { return path.stem().string() == name; });
    if (found != shipped.end()) return *found;
    std::vector<std::string> names;
    for (const std::filesystem::path& path : shipped) names.push_back(path.stem().string());
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    return error_of(message_of("no_exercise_of_link", name) + nearest_of(name, candidates));
}

}  // namespace braitenlab
