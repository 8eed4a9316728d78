#include "app/desk.h"

#include <utility>

#include "app/files.h"
#include "app/platform.h"
#include "core/match.h"

namespace braitenlab {

namespace fs = std::filesystem;

namespace {

struct Desk {
    Lab& lab;
    FilesView& view;
    Remembered& remembered;
    const Strings& strings;

    void say(std::string words) const {
        lab.notice = std::move(words);
        lab.notice_until = lab.wall_seconds + 8;
    }

    void refuse(const Error& error) const {
        view.refused = error.text();
        say(error.text());
    }

    void done(const fs::path& path, std::string_view words) const {
        if (!words.empty()) say(fill(words, {path.filename().string()}));
        view.refused.clear();
        ++view.done;
        refresh(view, lab);
    }

    fs::path folder() const {
        std::error_code none;
        if (!view.listing.folder.empty()) return view.listing.folder;
        if (fs::is_directory(remembered.folder, none)) return remembered.folder;
        return home_folder();
    }

    void list(const fs::path& path) const {
        view.listing = list_folder(path);
        view.refused.clear();
    }

    void open(const std::string& typed) const {
        const fs::path path = resolved(typed, folder());
        std::error_code none;
        if (fs::is_directory(path, none)) return list(path);
        if (kind_of_file(path) == FileKind::brain) {
            if (const auto error = take_brain(lab, path)) return refuse(*error);
            return done(path, strings("files.took_brain"));
        }
        auto opened = open_lab(path, std::nullopt, {});
        if (!opened) return refuse(opened.error());
        replace_lab(lab, std::move(*opened));
        remember_file(remembered, path);
        done(path, {});
    }

    void save(const SaveRequest& wanted) const {
        const fs::path path = with_ending(resolved(wanted.path, folder()), wanted.kind);
        if (const auto error = save_as(lab, path, wanted.kind)) return refuse(*error);
        if (wanted.kind == FileKind::run) remember_file(remembered, path);
        if (wanted.kind == FileKind::scene) {
            if (!lab.lesson) lab.path = path, lab.name = path.stem().string();
            remember_file(remembered, path);
            lab.saved_work = lab.work;
        }
        if (!view.listing.folder.empty()) list(view.listing.folder);
        done(path, strings(wanted.kind == FileKind::brain ? "files.saved_brain" : "files.saved"));
    }
};

}  // namespace

void replace_lab(Lab& lab, Lab next) {
    next.preferences = lab.preferences;
    next.before_lecture = lab.before_lecture;
    next.sensors = lab.sensors;
    next.outlines = lab.outlines;
    next.overlays = lab.overlays;
    next.overlays.field.reset();  // the next scene may have nothing on that channel
    next.wall_seconds = lab.wall_seconds;
    lab = std::move(next);
}

void remember_file(Remembered& remembered, const fs::path& file) {
    remember_opened(remembered, file);
    if (!ships(file)) remembered.folder = fs::path(remembered.last_opened).parent_path().string();
}

void do_files(Lab& lab, FilesView& view, Remembered& remembered, const Strings& strings) {
    const Desk desk{lab, view, remembered, strings};
    for (const Request& request : std::exchange(lab.files, {})) {
        if (const auto* open = std::get_if<OpenRequest>(&request)) desk.open(open->path);
        if (const auto* save = std::get_if<SaveRequest>(&request)) desk.save(*save);
        if (const auto* browse = std::get_if<BrowseRequest>(&request)) desk.list(resolved(browse->path, desk.folder()));
    }
}

void refresh(FilesView& view, const Lab& lab) {
    view.save_to = own_file(lab).string();
    view.suggested = lab.name;
}

}  // namespace braitenlab
