#include "core/lesson/lecture.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/lesson/exercise_file.h"
#include "core/messages.h"
#include "core/scene/folder_entries.h"
#include "core/scene/format_table.h"
#include "core/scene/nearest.h"
#include "core/scene/toml_reader.h"
#include "core/utf8.h"

namespace braitenlab {

namespace limits {
inline constexpr std::size_t pages = 100, page_steps = 16, answers = 6, notes = 4000, caption = 120;
}

void describe(auto& v, Of<LectureQuestion>) {
    v.text("text", &LectureQuestion::text, limits::text_length,
           "what the lecturer asks; without it, the caption is the question");
    v.texts("options", &LectureQuestion::options, limits::answers, limits::caption,
            "two or more; the audience raises hands");
    v.choice("answer", &LectureQuestion::answer, &LectureQuestion::options, "the right option");
    v.text("why", &LectureQuestion::why, limits::text_length, "the reason, shown with the answer");
}

void describe(auto& v, Of<LecturePage>) {
    v.text("scene", &LecturePage::scene, limits::text_length,
           "name of a shipped scene, or a path relative to this file; a page has a scene or an exercise");
    v.text("exercise", &LecturePage::exercise, limits::text_length,
           "name of a shipped exercise, or a path relative to this file");
    v.settings("set", &LecturePage::settings, "values of the scene, by their paths, that differ from its file");
    v.number("seed", &LecturePage::seed, "", {0, 1e15}, "of the run; 0: that of the exercise, or 1 for a scene");
    v.text("caption", &LecturePage::caption, limits::caption, "shown large above the scene, in at most two lines");
    v.text("notes", &LecturePage::notes, limits::notes, "for the lecturer only; the key N shows them");
    v.number("minutes", &LecturePage::minutes, "min", {0, 240}, "planned for this page");
    v.word("camera", &LecturePage::camera,
           "framed: the whole scene; follow: behind the selected vehicle; driver: at its front; above: straight down");
    v.angle("azimuth", &LecturePage::azimuth, {-360, 360}, "of the framed camera: direction from the scene to it");
    v.angle("elevation", &LecturePage::elevation, {9, 85}, "of the framed camera above the floor");
    v.number("zoom", &LecturePage::zoom, "", {0.25, 8}, "1: the whole scene fits");
    v.number("x", &LecturePage::x, "m", {-limits::place, limits::place},
             "shift of the point in the middle of the view");
    v.number("y", &LecturePage::y, "m", {-limits::place, limits::place}, "the same in y");
    v.text("select", &LecturePage::select, limits::name_length,
           "NAME of the [vehicle.NAME] that is selected; none: no vehicle, so that no ring marks one; without it, the "
           "scene's first");
    v.flag("play", &LecturePage::play, "the page begins with a playing run");
    v.number("pause", &LecturePage::pause, "s", {0, 3600},
             "second of the run at which it pauses, so that the values of this moment stay; Space goes on; 0: never");
    v.texts("show", &LecturePage::show, page_part_table.size(), limits::name_length,
            "parts that are hidden otherwise and shown from the start");
    v.texts("hide", &LecturePage::hide, page_part_table.size(), limits::name_length, "parts that are not shown");
    v.texts("steps", &LecturePage::steps, limits::page_steps, limits::caption,
            "what Page Down shows before it goes to the next page: a part, or several with spaces between them; they "
            "are hidden until then");
    v.table("question", &LecturePage::question, "a question with a count of raised hands");
}

void describe(auto& v, Of<Lecture>) {
    v.text("title", &Lecture::title, limits::title_length, "must be given");
    v.number("minutes", &Lecture::minutes, "min", {1, 600}, "of the whole lecture; must be given");
    v.list("page", &Lecture::pages, limits::pages, "a page; at least one");
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t index_of(PagePart part) { return static_cast<std::size_t>(part); }

bool is_file(const fs::path& path) {
    std::error_code none;
    return fs::is_regular_file(path, none);
}

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for_each_entry(folder, [&names](const fs::directory_entry& entry) {
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    });
    std::sort(names.begin(), names.end());
    return names;
}

// One page of the file after its values have been read: checks names and words.
class PageChecker {
public:
    PageChecker(TomlFile& file, const TomlNode& table, std::string path, LecturePage& page)
        : file_(file), table_(table), path_(std::move(path)), page_(page) {}

    void find_file(const fs::path& lecture, const fs::path& exercises) {
        if (page_.scene.empty() && page_.exercise.empty() && file_.failed_at(path_)) return;  // perhaps misspelt
        if (page_.scene.empty() == page_.exercise.empty())
            return fail(page_.scene.empty() ? "scene" : "exercise", message_of("scene_or_exercise"));
        const bool is_scene = page_.exercise.empty();
        const std::string& wanted = is_scene ? page_.scene : page_.exercise;
        const fs::path shipped = exercises / (is_scene ? "scenes" : "guided");
        page_.file = (lecture.parent_path() / wanted).lexically_normal();
        if (is_file(page_.file)) return;
        page_.file = shipped / (wanted + ".toml");
        if (is_file(page_.file)) return;
        const std::vector<std::string> names = names_in(shipped);
        const std::vector<std::string_view> known(names.begin(), names.end());
        fail(is_scene ? "scene" : "exercise", (is_scene ? message_of("no_scene_of_page", in_quotes(wanted))
                                                        : message_of("no_exercise_of_page", in_quotes(wanted))) +
                                                  nearest_of(wanted, known));
    }

    void check_question() {
        const LectureQuestion& asked = page_.question;
        if (!table_.contains("question") || file_.failed_at(path_ + ".question")) return;  // perhaps misspelt
        if (asked.options.size() < 2) return fail("question", message_of("few_options"));
        if (!table_.get("question")->contains("answer")) fail("question", message_of("answer_missing"));
        for (auto option = asked.options.begin(); option != asked.options.end(); ++option)
            if (std::find(asked.options.begin(), option, *option) != option)
                return fail("question", message_of("offered_twice", in_quotes(*option)));
    }

    void read_parts() {
        for (const PagePartTraits& part : page_part_table) page_.at_first[index_of(part.value)] = part.at_first;
        const bool asks = !page_.question.options.empty();
        if (!asks) page_.at_first[index_of(PagePart::question)] = false;
        for (std::size_t i = 0; i < page_.show.size(); ++i)
            for (const PagePart part : parts_of("show", i, page_.show[i])) page_.at_first[index_of(part)] = true;
        for (std::size_t i = 0; i < page_.hide.size(); ++i)
            for (const PagePart part : parts_of("hide", i, page_.hide[i])) page_.at_first[index_of(part)] = false;
        bool answers = false;
        for (std::size_t i = 0; i < page_.steps.size(); ++i) {
            const std::string& step = page_.steps[i];
            if (step.find_first_not_of(' ') == step.npos) fail_at("steps", i, "", message_of("empty_page_step"));
            PageParts& revealed = page_.reveal.emplace_back();
            for (const PagePart part : parts_of("steps", i, step)) {
                page_.at_first[index_of(part)] = false;
                revealed[index_of(part)] = true;
                answers |= part == PagePart::answer;
            }
        }
        answers |= page_.at_first[index_of(PagePart::answer)];
        if (asks && !answers) page_.reveal.emplace_back()[index_of(PagePart::answer)] = true;
    }

private:
    void fail(const std::string& key, Message what) {
        const TomlNode* value = table_.get(key);
        file_.fail(path_ + "." + key, value ? value : &table_, std::move(what));
    }

    // At a text of the list `key`, and at a word of it: each word has an error of its own.
    void fail_at(const std::string& key, std::size_t index, const std::string& word, Message what) {
        const std::string of_word = word.empty() ? "" : "." + word;
        file_.fail(fmt::format("{}.{}.{}{}", path_, key, index + 1, of_word), &table_.get(key)->as_list()->at(index),
                   std::move(what));
    }

    // The parts named in a text of the list `key`, separated by spaces.
    std::vector<PagePart> parts_of(const char* key, std::size_t index, const std::string& text) {
        std::vector<PagePart> parts;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find(' ', begin), text.size());
            const std::string word = text.substr(begin, end - begin);
            begin = end + 1;
            if (word.empty()) continue;
            if (const auto part = find_word(page_part_table, word))
                parts.push_back(*part);
            else
                fail_at(key, index, word,
                        message_of("no_page_part", key, in_quotes(word)) + nearest_of(word, words_of(page_part_table)));
        }
        return parts;
    }

    TomlFile& file_;
    const TomlNode& table_;
    std::string path_;
    LecturePage& page_;
};

void check_lecture(TomlTable& top, Lecture& lecture, const fs::path& path, const fs::path& exercises) {
    TomlFile& file = top.file();
    for (const char* needed : {"title", "minutes", "page"})
        if (!top.has(needed) && !top.fail_if_misspelt(needed, {}, {}))
            file.add(needed, error_of(message_of("missing_in_lecture", needed), file.name));
    if (!top.has("page") || (file.failed_at("page") && lecture.pages.empty())) return;
    if (lecture.pages.empty()) return top.fail("page", message_of("page_missing"));
    const TomlNode::List& pages = *top.content().get("page")->as_list();
    for (std::size_t i = 0; i < std::min(lecture.pages.size(), pages.size()); ++i) {
        PageChecker page(file, pages[i], fmt::format("page.{}", i + 1), lecture.pages[i]);
        lecture.pages[i].line = static_cast<int>(pages[i].place.line);
        page.find_file(path, exercises);
        page.check_question();
        page.read_parts();
    }
}

Lecture read_lecture_file(TomlFile& file, const fs::path& path, const fs::path& exercises) {
    Lecture lecture;
    lecture.id = path.stem().string();
    lecture.path = path;
    TomlTable top = read_top(file, lecture);
    check_lecture(top, lecture, path, exercises);
    return lecture;
}

// The first error of the page's scene or exercise, or a selected vehicle that it does not have.
std::optional<Error> error_of_page(const Lecture& lecture, const LecturePage& page) {
    Result<Scene> scene = Error{};
    if (page.exercise.empty()) {
        scene = load_scene(page.file, page.settings);
    } else {
        auto exercise = load_exercise(page.file, page.settings);
        scene = exercise ? Result<Scene>(std::move(exercise->scene)) : exercise.error();
    }
    if (!scene) return scene.error();
    const std::vector<std::string_view> names = known_names(scene->starts);
    // A camera on a vehicle needs one.
    const bool needs_vehicle = page.camera == PageCamera::follow || page.camera == PageCamera::driver;
    if (page.select.empty() || (page.select == nothing_selected && !needs_vehicle) ||
        std::find(names.begin(), names.end(), page.select) != names.end())
        return std::nullopt;
    return error_of(message_of("no_vehicle_to_select", in_quotes(page.select)) + nearest_of(page.select, names),
                    lecture.path.string(), page.line);
}

}  // namespace

bool shows(const LecturePage& page, PagePart part, int steps) {
    bool shown = page.at_first[index_of(part)];
    const std::size_t done = std::min(page.reveal.size(), static_cast<std::size_t>(std::max(0, steps)));
    for (std::size_t i = 0; i < done; ++i) shown |= page.reveal[i][index_of(part)];
    return shown;
}

bool is_long(const LectureQuestion& asked) {
    constexpr std::size_t letters = 26, most_lines = 15, lines_of_hands = 2;  // in that window, with the smallest type
    const auto lines = [&](const std::string& text) { return (count_characters(text) + letters - 1) / letters; };
    std::size_t sum = lines(asked.text);
    for (const std::string& option : asked.options) sum += lines(option) + lines_of_hands;
    return sum > most_lines;
}

float minutes_of_pages(const Lecture& lecture) {
    float sum = 0;
    for (const LecturePage& page : lecture.pages) sum += page.minutes;
    return sum;
}

Result<Lecture> parse_lecture(std::string_view toml, const fs::path& path, const fs::path& exercises) {
    return read_whole(toml, path.string(), [&](TomlFile& file) { return read_lecture_file(file, path, exercises); });
}

Result<Lecture> load_lecture(const fs::path& path, const fs::path& exercises) {
    const auto text = read_text(path);
    if (!text) return text.error();
    return parse_lecture(*text, path, exercises);
}

std::optional<Error> check_pages(const Lecture& lecture) {
    for (const LecturePage& page : lecture.pages)
        if (auto error = error_of_page(lecture, page)) return error;
    return std::nullopt;
}

std::vector<Error> errors_of_lecture(std::string_view toml, const fs::path& path, const fs::path& exercises) {
    auto file = parse_toml(toml, path.string());
    if (!file) return syntax_errors(toml, path.string());
    const Lecture lecture = read_lecture_file(*file, path, exercises);
    for (std::size_t i = 0; i < lecture.pages.size(); ++i) {
        const std::string page = fmt::format("page.{}", i + 1);
        if (file->failed_at(page)) continue;
        if (auto error = error_of_page(lecture, lecture.pages[i])) file->add(page, std::move(*error));
    }
    return file->errors();
}

std::vector<TranslatableText> texts_of(const Lecture& lecture) {
    std::vector<TranslatableText> texts;
    const auto add = [&](const std::string& key, const std::string& text) {
        if (!text.empty()) texts.push_back({"lecture." + lecture.id + "." + key, text});
    };
    add("title", lecture.title);
    for (std::size_t i = 0; i < lecture.pages.size(); ++i) {
        const LecturePage& page = lecture.pages[i];
        const std::string key = fmt::format("page.{}.", i + 1);
        add(key + "caption", page.caption);
        add(key + "notes", page.notes);
        add(key + "question", page.question.text);
        for (std::size_t k = 0; k < page.question.options.size(); ++k)
            add(fmt::format("{}option.{}", key, k + 1), page.question.options[k]);
        add(key + "why", page.question.why);
    }
    return texts;
}

std::string describe_lecture_format() {
    std::string text = describe_top<Lecture>() +
                       "\n## Parts of a page\n\nThe words of `show`, `hide` and `steps`.\n\n"
                       "| Part | At first | Meaning |\n|---|---|---|\n";
    for (const PagePartTraits& part : page_part_table)
        text += fmt::format("| `{}` | {} | {} |\n", part.word, part.at_first ? "shown" : "hidden", part.meaning);
    return text;
}

}  // namespace braitenlab
