// What survives a crash: edits and run up to the last seconds, kept in a file of this program's own, and offered by the
// next start. A run that plays is kept too: the person watched it come that far.
//
// Every running lab holds a lock beside its file. A file whose lock is free belongs to a lab that did not end properly.
#pragma once

#include <cstdint>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/lab.h"
#include "app/platform.h"
#include "core/result.h"
#include "ui/files.h"

namespace braitenlab {

// The run as it is now, what it was opened from and how far its exercise has got: plain values, cheap to take from the
// lab, that another thread may write while the lab goes on.
struct Draft {
    std::string name;
    std::filesystem::path path;
    SavedRun run;
    struct Progress {
        int prediction = -1, hints_shown = 0;
        bool has_run = false;
    };
    std::optional<Progress> exercise;
};
Draft draft_of(const Lab&);
// `ended`: the lab was told to end, and did so properly.
std::string write_autosave(const Draft&, std::string_view when, bool ended = false);

// The document from such text; an exercise is read from its own file. Fails with the line on anything else.
Result<Document> open_autosave(std::string_view text, std::string file_name);

// What a lab that crashed has left behind.
struct Leftover {
    std::filesystem::path file;
    RecoveryOffer offer;
};

class Autosave {
public:
    static constexpr double period = 19.5;  // s; with the time that writing takes, a crash costs 20 s at most
    static constexpr double soon = 1.5;     // s, after the first edit

    // frame: may wait until it is due. now: is on the disk before keep() returns. end: the same, for the last time.
    enum class Occasion { frame, now, end };

    // Looks for what another lab has left in the folder; the newest counts. One that cannot be read is renamed to
    // <name>.broken and complained about. An empty folder: nothing is looked for or written.
    explicit Autosave(std::filesystem::path folder, std::vector<Error>& complaints);
    Autosave(Autosave&&) = default;
    Autosave& operator=(Autosave&&) = default;

    const std::optional<Leftover>& leftover() const { return leftover_; }

    // The work that was left behind, or why it cannot be had. It stays on the disk until forget().
    Result<Document> recover() const;
    void forget();

    // Writes when there are edits or ticks that are not on the disk yet: `soon` after they began, but `period` after
    // the last time at the earliest; at once when the mode has changed. That happens on another thread, so that no
    // frame waits for a disk. What a person saved needs no keeping. An error is told once until writing works again,
    // which is tried again and again.
    std::optional<Error> keep(const Lab&, double wall_seconds, Occasion = Occasion::frame);

    // Waits until what keep() began is on the disk.
    std::optional<Error> settle();

    // At a proper end: there is nothing to recover.
    void finish();

private:
    bool begin();  // takes a name and its lock
    void write(const Lab&, bool ended);

    std::filesystem::path folder_, file_;
    std::optional<FileLock> lock_;
    std::optional<Leftover> leftover_;
    // How far the lab had got when it was last kept.
    struct Reached {
        std::int64_t work = -1;
        std::uint64_t tick = 0;
        friend bool operator==(const Reached&, const Reached&) = default;
    };
    Reached kept_;
    double dirty_since_ = -1;  // wall seconds; negative: all is on the disk
    double written_at_ = -period;
    Mode mode_ = Mode::paused;
    bool due_ = false;                           // as soon as the one before is on the disk
    std::future<std::optional<Error>> writing_;  // valid until its end was heard of
    bool failed_ = false;
};

}  // namespace braitenlab
