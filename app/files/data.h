// The files that ship with the program: exercises, scenes, shaders, strings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

namespace braitenlab {

struct CatalogueEntry;
struct Lecture;
struct TomlNode;

// The program's version: "0.1.0".
const char* version_text();

// The folder that holds exercises/, shaders/ and ui/: $BRAITENLAB_DATA, the checkout of the build, or the folder of the
// installation. Fails with the list of folders that it has tried.
Result<std::filesystem::path> data_folder();

// What a person looks for among the shipped files; it decides which names an error lists.
enum class Shipped { any, exercise, study, breeding };

// A path of a file, or the name of a shipped scene ("2a-coward"), exercise ("05-aggressor"), lecture, study or
// breeding. Fails with
// the nearest shipped name of what is wanted.
Result<std::filesystem::path> find_shipped(const std::string& path_or_name, Shipped wanted = Shipped::any);

// The scene that a file names: a path relative to the file, or the name of a shipped scene.
Result<std::filesystem::path> scene_beside(const std::filesystem::path& file, const std::string& scene);

// The same for the text at the key `scene` of a file with this content: an error has the file and the line of the key.
Result<std::filesystem::path> scene_at_key(const std::filesystem::path& file, std::string_view toml,
                                           const std::string& scene);

// The values in a study, a breeding, an exercise or a lecture that name other files: texts.
std::vector<const TomlNode*> named_files(const TomlNode& root);

// The shipped exercises, scenes, scenes of robots, lectures, studies and breedings, each sorted by file name.
std::vector<std::filesystem::path> shipped_exercises();
std::vector<std::filesystem::path> shipped_scenes();
std::vector<std::filesystem::path> shipped_robots();
std::vector<std::filesystem::path> shipped_lectures();
std::vector<std::filesystem::path> shipped_studies();
std::vector<std::filesystem::path> shipped_breedings();

// True for a file that ships with the program.
bool ships(const std::filesystem::path&);

// load_lecture() with the shipped scenes and exercises.
Result<Lecture> read_lecture(const std::filesystem::path&);

// The shipped exercises and scenes, for the menu. A broken file is left out; opening it by name reports the error.
std::vector<CatalogueEntry> read_catalogue();
std::vector<CatalogueEntry> read_lecture_catalogue();

// The files of the exercises and of the scenes by turns: the file browser shows the beginning of both lists.
std::vector<std::string> files_by_turns(const std::vector<CatalogueEntry>&);

// The first candidate that exists; empty if none does.
std::filesystem::path first_existing(const std::vector<std::filesystem::path>& candidates);

}  // namespace braitenlab
