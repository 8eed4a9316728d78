// Fixture: a lab whose user has a folder of files.
#pragma once

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "app/files/data.h"
#include "app/files/file_commands.h"
#include "app/lab_requests.h"
#include "tests/folder.h"

namespace braitenlab::tests {

struct LabFiles : testing::Test {
    Folder folder;
    FilesView files;
    StoredState state;
    UserFolders folders{.home = folder.path, .pictures = folder / "Pictures", .documents = folder / "Documents"};
    Lab lab = open("2a-coward");
    fs::path nowhere = folder / "text" / "below" / "mine";  // below a file

    static Lab open(const std::string& name) {
        auto opened = open_lab(*find_shipped(name), std::nullopt, {});
        return std::move(*opened);
    }

    LabFiles() {
        state.folder = folder.path.string();
        put_text(folder / "text", "");
        refresh(files, lab);
    }
    void ask(const Request& request) {
        handle(lab, request);
        execute_file_requests(lab, files, state, folders);
    }
    const FourNeurons dials() const { return read_dials(*lab.document.session.snapshot().kind_brains[0]); }
};

}  // namespace braitenlab::tests
