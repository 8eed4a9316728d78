// Who has handed in a file, as learning platforms write it into the names of folders and files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace braitenlab {

struct Submitter {
    std::string folder;  // the folder that one person's files are in; empty: none
    std::string id;      // number of the person on the platform; empty: the names do not tell
    std::string name;    // of the person, as the platform writes it; empty: the names do not tell
    std::string person;  // the same text for all files of a person; empty: the names do not tell
    std::string last_name{}, first_name{}, login{};  // of ILIAS; empty elsewhere
    friend bool operator==(const Submitter&, const Submitter&) = default;
};

// The submitter by a path with '/'. Known are
// Moodle   NAME_ID_assignsubmission_file_, a folder or the beginning of a file's name (docs.moodle.org, "Assignment");
// ILIAS    a folder Lastname_Firstname_login_ID; of more words the first is the last name;
// Canvas   a file lastnamefirstname_ID_NUMBER_file or lastnamefirstname_LATE_ID_NUMBER_file.
// Of another path the folder is its first one.
Submitter submitter_of(std::string_view path);

// Number of bytes at the beginning of all paths that are folders around the whole class, "Submissions/": they tell
// nothing about a person. A folder that belongs to a person is not among them.
std::size_t folders_around(const std::vector<std::string>& paths);

}  // namespace braitenlab
