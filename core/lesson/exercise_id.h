// The id of an exercise, which hand-ins name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace braitenlab {

// The name without what a browser or a file manager adds to the name of a copy: "charge (1)", "charge - Copy (2)" and
// "charge - Kopie" are "charge".
std::string_view without_copy_suffix(std::string_view name);

// The id of an exercise whose file does not have one: the file's stem without_copy_suffix().
std::string exercise_id_of(const std::filesystem::path&);

// True if a hand-in that names `handed_in` is for the exercise with this id. A hand-in that was written from a copy of
// the file has the copy's name.
bool is_for_exercise(std::string_view handed_in, std::string_view id);

}  // namespace braitenlab
