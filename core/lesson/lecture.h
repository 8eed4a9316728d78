// A lecture as its author writes it: one TOML file of pages, each with a scene or an exercise. The format:
// docs/lecture-format.md.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/enum_table.h"
#include "core/lesson/exercise.h"
#include "core/result.h"
#include "core/scene/scene_file.h"

namespace braitenlab {

// The parts of a page that it can show or hide.
enum class PagePart {
    caption,
    question,
    answer,
    values,
    brain,
    trails,
    sensors,
    labels,
    field,
    sliders,
    wiring,
    exercise,
    play,
    title,
    character
};

struct PagePartTraits {
    PagePart value;
    std::string_view word;
    bool at_first;  // shown unless the page hides it or names it in a step
    std::string_view meaning;
};
inline constexpr auto page_part_table = std::to_array<PagePartTraits>({
    {PagePart::caption, "caption", true, "the caption"},
    {PagePart::question, "question", true, "the question with its options"},
    {PagePart::answer, "answer", false, "the right option and the reason"},
    {PagePart::values, "values", false,
     "the large picture below the scene: character, speed, eyes, wires, wheels with their biases"},
    {PagePart::brain, "brain", true, "the wires on the deck, and the brain in its cards"},
    {PagePart::trails, "trails", true, "the paths of the vehicles"},
    {PagePart::sensors, "sensors", true, "the fields of the sensors"},
    {PagePart::labels, "labels", true, "the names of things"},
    {PagePart::field, "field", false, "the intensity of the first channel on the floor"},
    {PagePart::sliders, "sliders", false, "the card with the sliders of the brain"},
    {PagePart::wiring, "wiring", false, "the wiring diagram beside the scene"},
    {PagePart::exercise, "exercise", false, "the card of the exercise"},
    {PagePart::play, "play", false, "starts the run; it has no effect while the run plays"},
    {PagePart::title, "title", true, "the title of the lecture in the bar"},
    {PagePart::character, "character", true, "the recognised character below the scene and on the brain's card"},
});
constexpr const auto& table_of(PagePart) { return page_part_table; }
static_assert(is_complete_table<page_part_table>());

using PageParts = std::array<bool, page_part_table.size()>;

// The camera of a page.
enum class PageCamera { framed, follow, driver, above };
inline constexpr auto page_camera_table = std::to_array<Word<PageCamera>>({
    {PageCamera::framed, "framed"},
    {PageCamera::follow, "follow"},
    {PageCamera::driver, "driver"},
    {PageCamera::above, "above"},
});
constexpr const auto& table_of(PageCamera) { return page_camera_table; }
static_assert(is_complete_table<page_camera_table>());

// A question to the audience. There is none without options.
struct LectureQuestion {
    std::string text;  // empty: the caption asks
    std::vector<std::string> options;
    int answer = 0;   // index of the right option; in the file, the option's text
    std::string why;  // shown with the answer
};

inline constexpr std::string_view nothing_selected = "none";  // in LecturePage::select

struct LecturePage {
    std::string scene, exercise;    // name or path as in the file; exactly one is given
    std::filesystem::path file;     // of the scene or the exercise
    int line = 0;                   // of the page in the lecture's file
    std::vector<Setting> settings;  // of the scene
    std::uint64_t seed = 0;         // of the run; 0: that of the exercise, or 1
    std::string caption, notes;
    float minutes = 1;
    PageCamera camera = PageCamera::framed;
    float azimuth = -1.5707963f, elevation = 1.0f;  // rad; as Camera in render/view/camera.h
    float zoom = 1;
    float x = 0, y = 0;  // m, shift of the point that the camera looks at
    std::string select;  // name of the selected vehicle; empty: the scene's first; nothing_selected: no vehicle
    bool play = false;   // the page begins with a playing run
    float pause = 0;     // s of the run; it pauses there, so that the values of this moment stay. 0: never
    std::vector<std::string> show, hide, steps;
    LectureQuestion question;
    PageParts at_first{};           // the parts shown on opening
    std::vector<PageParts> reveal;  // the parts that each step shows, in the order of the steps
};

// True if the page shows the part after so many steps.
bool shows(const LecturePage&, PagePart, int steps);

struct Lecture {
    std::string id;  // the file's stem: "four-numbers"
    std::filesystem::path path;
    std::string title;
    float minutes = 0;  // of the whole lecture
    std::vector<LecturePage> pages;
};

// True if a window of 1024x768 probably cannot show all options with their hands without scrolling: estimated from the
// number of lines, because there are no letters here.
bool is_long(const LectureQuestion&);

// The sum of the minutes of the pages.
float minutes_of_pages(const Lecture&);

// Errors carry file and line. A page names its scene or exercise by a path relative to the lecture's file, or by the
// name of a file in `exercises`/scenes or `exercises`/guided. The scenes themselves are not read.
Result<Lecture> load_lecture(const std::filesystem::path&, const std::filesystem::path& exercises);
Result<Lecture> parse_lecture(std::string_view toml, const std::filesystem::path& file,
                              const std::filesystem::path& exercises);

// The first error in the pages' scenes and exercises, or a selected vehicle that its scene does not have; nullopt if
// every page can be opened.
std::optional<Error> check_pages(const Lecture&);

// Every error of the file, by line, and the first one of each page's scene or exercise. Pages with an error of their
// own are not opened.
std::vector<Error> errors_of_lecture(std::string_view toml, const std::filesystem::path& file,
                                     const std::filesystem::path& exercises);

// Titles, captions, notes and questions, with ids like "lecture.four-numbers.page.2.caption".
std::vector<TranslatableText> texts_of(const Lecture&);

// The tables of docs/lecture-format.md, in Markdown.
std::string describe_lecture_format();

}  // namespace braitenlab
