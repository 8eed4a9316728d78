// The subcommands of braitenctl. Each prints its result and returns the exit code.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/ctl/brain_of_file.h"
#include "app/ctl/table_file.h"
#include "app/reports/map_file.h"
#include "core/enum_table.h"
#include "core/result.h"
#include "core/scene/nearest.h"
#include "core/scene/translatable.h"
#include "core/world/world.h"
#include "ui/words/strings.h"

namespace braitenlab {

namespace exit_code {
inline constexpr int done = 0, failed = 1, bad_input = 2;
inline constexpr int interrupted = 130;  // as a shell counts the end by Ctrl+C
}  // namespace exit_code

// Prints the error to stderr. Returns exit_code::bad_input.
int complain(const Error&);
int complain_of_all(const std::vector<Error>&);

// Prints to stderr that the program was interrupted and that no file has changed. Returns exit_code::interrupted.
int interrupted();

// The error if the file of this option is given and has another ending than this one, ".svg". It is written in one
// format only, whatever its name is.
std::optional<Error> ending_fault(std::string_view option, const std::string& file, std::string_view ending);

// The error if the table is written to standard output, which also gets a JSON object.
std::optional<Error> json_beside_csv(std::string_view csv, bool json);

// The enumerator with this word in a table. The error begins with `none`, "there is no measure", and names the nearest
// word.
template <class Table>
auto named_in(const Table& table, const std::string& word, const std::string& none, const std::string& option)
    -> Result<decltype(Table::value_type::value)> {
    if (const auto value = find_word(table, word)) return *value;
    return Error{none + " " + in_quotes(word) + name_nearest(word, words_of(table)), option};
}

// The strings of a language of the program.
Result<Strings> strings_of(const std::string& language);
// The same, with the translations of these shipped texts.
Result<Strings> strings_with(const std::string& language, const std::vector<TranslatableText>&);

struct RunOptions {
    std::string file;  // a scene or a saved run
    double seconds = 10;
    std::string seed;                   // as parse_sweep() reads it
    std::vector<std::string> settings;  // as parse_sweep() reads them
    int threads = 0;                    // of a sweep; 0: one per processor
    std::string csv;                    // file of the table; "-": standard output; empty: none
    std::string save;                   // file; empty: none
    std::vector<std::string> columns;   // words of io::ColumnGroup: further columns of the CSV file
    TableOptions table;
    bool json = false, hash = false;
};
int run(const RunOptions&);

struct MapOptions {
    std::string file;              // a scene
    std::string x = "LL=RR=-2:2";  // as insight::parse_axis() reads it
    std::string y = "LR=RL=-2:2";
    std::string measure = "kind";  // word of insight::MapMeasure
    std::string vehicle;           // name of a start; empty: the first vehicle
    int size = 32, seeds = 1;
    std::uint64_t seed = 1;             // the first
    double seconds = 20;                // of each run
    int threads = 0;                    // 0: one per processor
    std::vector<std::string> settings;  // PATH=VALUE, for every run
    std::string csv, png, svg;          // files; "-" of the table: standard output; empty: none
    FigureLabels labels;                // of the SVG file
    TableOptions table;                 // its language is also that of the words in the SVG file
    bool json = false;
};
// Runs a map of behaviour and prints it as text or JSON, or writes it as a table or a picture.
int map(const MapOptions&);

struct CompareOptions {
    std::string file;     // a scene
    std::string a, b;     // files of brains, as brain_of_file() reads them
    std::string vehicle;  // name of a start; empty: the first vehicle
    std::uint64_t seed = 1;
    double seconds = 30;  // of each run
    bool json = false;
};
// Runs both brains from the same start and prints the measures of core/insight/compare.h.
int compare(const CompareOptions&);

struct MysteryOptions {
    std::string file;   // a scene with a hidden brain
    std::string brain;  // file of the rebuilt brain, as brain_of_file() reads it
    std::uint64_t seed = 1;
    int starts = 10;
    int threads = 0;  // 0: one per processor
    bool json = false;
};
// Prints the score of core/insight/mystery.h.
int mystery(const MysteryOptions&);

struct PictureOptions {
    std::string file;           // a scene; for the wiring alone also a brain or a saved run
    std::string wiring, paths;  // SVG files; empty: not written
    BrainChoice choice;         // of the brain
    double seconds = 20;        // of the run whose paths are drawn
    std::uint64_t seed = 1;
    std::vector<std::string> settings;  // PATH=VALUE, for the paths
    std::string language = "en";        // of the words in the drawings
};
// Writes the wiring diagram of a brain, and the paths of a run, as SVG files.
int picture(const PictureOptions&);

struct StudyOptions {
    std::string file;  // a study: path or bare name
    std::string csv;   // file of the table; "-": standard output; empty: none
    std::string svg;   // file of the drawing; empty: none
    FigureLabels labels;
    TableOptions table;
    int threads = 0;  // 0: one per processor
    bool json = false;
};
// Runs a study and prints medians and quartiles as text or JSON, or the table. Interrupted with a file for the table,
// it continues the next time.
int study(const StudyOptions&);

struct BreedOptions {
    std::string file;      // a breeding: path or bare name, or the folder of its results
    std::string out;       // folder of the results; with `champion` or `match` the file to write
    int generations = 0;   // 0: those of the file
    int threads = 0;       // 0: one per processor
    bool goes_on = false;  // with the results in the folder
    bool json = false;
    std::string matrix;  // ciao or master; empty: none
    std::string csv;     // file of the matrix, or without one of the scores; "-": standard output; empty: none
    std::string svg;     // file of a drawing of the matrix, or without one of the scores by generation; empty: none
    std::string report;  // folder for all tables and drawings; empty: none
    FigureLabels labels;
    TableOptions table;    // its language is also that of the words in the SVG file
    std::string champion;  // predator:GENERATION or prey:GENERATION; empty: none
    std::string match;     // PREDATOR:PREY, two generations; empty: none
};
// The files of `report`.
inline constexpr std::array breeding_report_files{"breeding.json", "scores.svg",   "ciao.svg",
                                                  "master.svg",    "breeding.csv", "breeding.txt"};
// Breeds predators and prey into a folder, which holds the state after each generation. Or prints the matrix of a
// folder, or writes or draws it or the scores, or all of this, or the brain of a champion, or the scene of a match.
int breed(const BreedOptions&);

struct RobustnessOptions {
    std::string file;     // a scene or an exercise
    std::string brain;    // file; of an exercise, in place of its solution
    std::string vehicle;  // name of a start; empty: the first vehicle
    int robots = 40;
    double reality = 1;
    std::optional<std::uint64_t> seed;  // of the start and the first robot; nullopt: 1, or that of the exercise
    std::optional<double> seconds;      // of each run; nullopt: 20, or those of the exercise
    int threads = 0;                    // 0: one per processor
    std::vector<std::string> settings;  // PATH=VALUE, for a scene
    std::string csv;                    // file; "-": standard output; empty: none
    TableOptions table;
    bool json = false;
};
// Runs a number of robots whose parts differ, and prints how many do what the ideal robot does.
int robustness(const RobustnessOptions&);

// The content of a scene's file. The error for another kind of file says what it is, what the command takes, and which
// command is for it.
Result<std::string> read_scene_text(const std::filesystem::path&, std::string_view command, std::string_view takes);

// The scene of a file, with values set. Fails as read_scene_text() does, and for a saved run.
Result<Scene> read_scene_with(const std::string& file, const std::vector<std::string>& settings,
                              std::string_view command, std::string_view takes);

// The vehicle with the start of this name in a world's first state; without a name the first vehicle. Fails with the
// nearest name. `file`: that of the scene.
Result<VehicleId> vehicle_at_start(const Snapshot& start, const std::string& name, const std::string& file);

// The number of worker threads of Jobs: `wanted`, or one per processor if that is 0.
int threads_for(int wanted);

struct CheckOptions {
    std::string exercise;    // or a lecture: path or bare name
    std::string brain;       // file; empty: see check()
    BrainChoice choice;      // of the brain in the file
    std::uint64_t seed = 1;  // of the first start
    bool all = false;        // every shipped exercise, in place of one
    bool json = false;
};
// Prints whether the brain of the file (see brain_of_file) passes the exercise, and for each start that fails the first
// step that was not done. With an empty file name: whether the exercise is sound, i.e. no start passes as shipped,
// every start passes with its own solution, which uses only what is offered, no wrong answer passes, and the run shows
// what the prediction's answer says. With `all`: whether each shipped exercise is sound.
int check(const CheckOptions&);
// Prints whether every page of a lecture can be opened and whether their minutes are those of the lecture.
int check_lecture(const std::filesystem::path&, bool json);

struct ClassOptions {
    std::string exercise;            // path or bare name
    std::vector<std::string> files;  // hand-ins, brains, scenes, saved runs, and folders of these
    BrainChoice choice;              // of the brain in a scene or a saved run
    std::string csv, html;           // files to write; csv empty or "-": standard output, if there is no page either
    TableOptions table;              // its language is also that of feedback and page
    std::string platform;            // word of Platform, for the marks; empty: no marks are written
    std::string marks;               // file of the marks; "-": standard output
    std::string list, column;        // the platform's list of students, a file; the column for the marks
    double points = 0;               // the best mark; 0: see GradebookOptions
    std::uint64_t first_seed = 1;
};

// Grades brains, one row each, into the CSV file, or to stdout when its name is empty or "-". A file that holds no
// brain gets a row with the error; the other files are still graded. Where a folder or a hand-in is among the files, or
// a page or marks are wanted, the files are those of a class: see docs/grading.md.
int grade(const ClassOptions&);

// The error for an argument that is neither a file or a folder nor the name of a shipped scene, as for a mistyped
// folder.
std::optional<Error> missing_argument(const std::vector<std::string>& files);

// True if there is a folder or a hand-in file among the files.
bool is_class(const std::vector<std::string>& files);

// Grades a class, one row a file. A file that cannot be graded is a row with its error.
int grade_class(const ClassOptions&);

struct HashOptions {
    double seconds = 60;   // simulated time of each run
    std::string compared;  // a file that this command printed; empty: none
};
// Prints the hashes of the shipped scenes and exercises as JSON. With a file to compare: the differences; failed if
// there are any.
int print_hashes(const HashOptions&);

struct LinkOptions {
    std::string what;  // a scene, the name of a shipped scene or exercise, or a link
    std::string base;  // the address before '#' of a link that is printed
    std::string out;   // file of the scene of a link; empty: standard output
};
// Prints the link of a scene or a shipped exercise; of a link, writes the scene that it holds.
int link(const LinkOptions&);

struct ExportOptions {
    std::string file;    // a brain, scene, saved run, or the name of a preset
    BrainChoice choice;  // of the brain in a scene or a saved run
    std::string target;  // word of robots::Target
    std::string robot;   // name; empty: the target's own
    std::string folder;  // created when it does not exist
    bool force = false;  // a folder with other files than those of an earlier export, or with edited ones, is taken
};
// Writes the program of a brain for a robot into the folder and prints the names of the files. Files of an earlier
// export are replaced; a folder with other files only, or with edited ones, is an error without `force`. A brain that
// the target cannot hold is an error that names the part; then no file is written.
int export_to_robot(const ExportOptions&);

struct ThinkOptions {
    std::string file;
    BrainChoice choice;
    double rate_hz = 60;
    int ticks = 1000;
    std::uint64_t seed = 1;
    std::string vectors;  // file of the table; "-": standard output
};
// Writes golden vectors, see core/export/vectors.h.
int think_vectors(const ThinkOptions&);

// Prints the content of a scene, an exercise, a saved run or a brain, and the recognised characters of its brains.
int show(const std::string& file);

}  // namespace braitenlab
