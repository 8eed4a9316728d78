// Another program that writes the open file of a lab.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "app/files/file_commands.h"
#include "tests/folder.h"

namespace braitenlab::tests {

// The text with its first `old` replaced.
inline std::string with(std::string text, const std::string& old, const std::string& fresh) {
    const auto at = text.find(old);
    EXPECT_NE(at, text.npos) << old;
    return at == text.npos ? text : text.replace(at, old.size(), fresh);
}

// The lab looks twice after each write: a change counts once the file stays the same.
class OtherProgram {
public:
    OtherProgram(Lab& lab, FilesView& files) : lab_(lab), files_(files) {}

    void write(const std::filesystem::path& file, const std::string& text) {
        put_text(file, text);
        set_time(file, std::filesystem::last_write_time(file));
        look_twice();
    }
    // As an editor does that renames a new file over the old one.
    void rename_over(const std::filesystem::path& file, const std::string& text) {
        const std::filesystem::path fresh = file.parent_path() / "new";
        put_text(fresh, text);
        set_time(fresh, std::filesystem::last_write_time(file));
        std::filesystem::rename(fresh, file);
        look_twice();
    }

private:
    void set_time(const std::filesystem::path& file, std::filesystem::file_time_type before) {
        std::filesystem::last_write_time(file, before + std::chrono::seconds(++written_));
    }
    void look_twice() { follow_file(lab_, files_), follow_file(lab_, files_); }

    Lab& lab_;
    FilesView& files_;
    int written_ = 0;
};

}  // namespace braitenlab::tests
