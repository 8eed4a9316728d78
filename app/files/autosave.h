// Autosave: the run and its edits, written every few seconds to a file that the next start offers after a crash.
//
// Every running lab holds a lock beside its file. If the lock of a file is free, its lab has crashed or was told to
// end. A lab that is killed holds it until the system has taken its memory back, which can take longer than the next
// start.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "app/lab.h"
#include "app/platform/platform.h"
#include "core/result.h"
#include "ui/files.h"

namespace braitenlab {

// The content of an autosave: plain values, which another thread may write while the lab runs.
struct Draft {
    std::string title, name;
    std::filesystem::path path;            // absolute; empty: not saved yet
    std::optional<std::uint64_t> content;  // Document::content
    SavedRun run;
    Edits edits;  // none where a brain is hidden: only the run is sealed
    struct Progress {
        Attempt::Answers answers{};  // of these, prediction, path and hints are kept
        bool has_run = false, outcome_known = false;
        int runs = 0;
        std::string referee{};  // at the run's last keyframe, from write_referee_state
    };
    std::optional<Progress> exercise;
    bool hides_brain = false;  // the exercise hides one: the run is sealed
};
Draft draft_of(const Document&);
// The same with another state of its run.
Draft draft_of(const Document&, const Session&);

// A saved run (see core/io/run_file.h) with one more key, "autosave". `ended`: the lab was told to end and has ended
// without a crash.
std::string write_autosave(const Draft&, std::string_view when, bool ended = false);

struct Autosaved {
    Document document;
    std::string when;
    bool ended = false;
};
// An exercise is read from its own file. Fails with the file and, if known, the line.
Result<Autosaved> open_autosave(std::string_view text, std::string file_name);

// Work of a lab that has not ended properly.
struct Leftover {
    std::filesystem::path file;
    RecoveryOffer offer;
    std::filesystem::file_time_type written{};  // decides where RecoveryOffer::when, of whole seconds, is the same
};

// Runs a task before returning.
template <class Task>
std::future<std::optional<Error>> run_now(const Task& task) {
    std::promise<std::optional<Error>> done;
    done.set_value(task());
    return done.get_future();
}

// Starts a task by launch(task), as std::async does on another thread. If that fails because there is no thread
// (std::system_error), runs the task before returning.
template <class Task, class Launch>
std::future<std::optional<Error>> start_or_run(const Task& task, const Launch& launch) {
    try {
        return launch(task);
    } catch (const std::system_error&) {
        return run_now(task);
    }
}

class Autosave {
public:
    static constexpr double period = 19.5;  // s between two writes of a run; a crash loses at most 20 s of it
    static constexpr double soon = 0.5;     // s between two writes of edits; a crash loses at most 1 s of them

    // frame: writes when due. now: the file is on the disk before keep() returns. end: the same, as the last call.
    enum class Occasion { frame, now, end };

    static constexpr std::chrono::hours kept_for{30 * 24};  // since the last write; older leftovers are removed

    static constexpr double still_ending = 5;  // s after the start in which a lock that was held then may become free

    static constexpr std::size_t most_at_start = 4U << 20U;  // bytes of a leftover that is read whole at the start

    // Searches the folder for leftovers, removes those that are too old (broken ones, too) and offers the newest, first
    // of those with work, then the others. A file that cannot be read is renamed to <name>.broken and reported in
    // `errors`; in a file of more bytes than most_at_start, which takes seconds, the run is read by recover() only. If
    // `folder` is empty, nothing is read or written.
    explicit Autosave(std::filesystem::path folder, std::vector<Error>& errors);
    Autosave(Autosave&&) = default;
    Autosave& operator=(Autosave&&) = default;

    const std::optional<Leftover>& leftover() const { return leftover_; }

    // Call once a frame. Offers the work of a lab that was still ending at the start: the newest first, also before
    // what is on offer.
    void follow_ending_labs(double wall_seconds, std::vector<Error>& errors);

    // Opens the leftover. Its file stays until forget().
    Result<Document> recover() const;
    void forget();  // removes its file; the next one is offered
    // Renames the leftover, which recover() cannot read, as the constructor does; the next one is offered.
    void set_aside();
    void pass_over();  // leaves its file for the next start; the next one is offered
    void offer_no_more() { older_.clear(), locked_.clear(); }  // leaves the others for the next start

    // Removes leftovers of a scene file that has been saved: the file has newer work.
    void forget_work_on(const std::filesystem::path& saved);

    // Writes if there are edits, a prediction or ticks that are neither in the document's file nor in the autosave: a
    // prediction at once, edits also,
    // but at least `soon` after the last write; without edits `soon` after the first tick and at least `period` after
    // the last write; and at once when the mode changes. Edits that are undone do not count; their autosave is removed
    // when the next write is due. Writing happens on another thread; where there is none, edits also wait for the
    // period. An error is returned once until writing succeeds again; every period it is tried again.
    std::optional<Error> keep(const Lab&, double wall_seconds, Occasion = Occasion::frame);

    // Waits until the write that keep() has started is on the disk.
    std::optional<Error> settle();

    // Removes the file: the lab ends properly, or everything is saved.
    void finish();

private:
    void take_up(const std::filesystem::path&, std::vector<Error>& errors);  // a leftover
    void offer_newest();
    bool lock();  // chooses a file name and locks it
    void write(const Lab&, bool ended);

    std::filesystem::path folder_, file_;
    std::optional<FileLock> lock_;
    std::optional<Leftover> leftover_;
    std::vector<Leftover> older_;                // offered after it, the newest last
    std::vector<std::filesystem::path> locked_;  // at the start: of labs that run or are still ending
    double searched_at_ = 0;                     // wall seconds: the last look at them
    // Progress of the lab at the last write.
    struct Reached {
        std::int64_t edits = -1;
        std::uint64_t tick = 0;
        int prediction = -1;                    // of the open exercise
        std::vector<maths::vec2> drawn_path{};  // the same, as a path
        friend bool operator==(const Reached&, const Reached&) = default;
    };
    static Reached reached_by(const Document&);
    Reached written_;
    double dirty_since_ = -1;  // wall seconds; negative: nothing to write
    double written_at_ = -period;
    Mode mode_ = Mode::paused;
    bool due_ = false;                           // write as soon as the current write has finished
    std::future<std::optional<Error>> writing_;  // valid until settle() has taken its result
    bool failed_ = false;
};

}  // namespace braitenlab
