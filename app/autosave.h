// What survives a crash: the work of the last seconds, kept in a file of this program's own, and offered by the next
// start.
//
// Every running lab holds a lock beside its file. A file whose lock is free belongs to a lab that did not end properly.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/lab.h"
#include "app/platform.h"
#include "core/result.h"
#include "ui/files.h"

namespace braitenlab {

// The run as it is now, what it was opened from and how far its exercise has got, as text.
std::string write_autosave(const Lab&, std::string_view when);

// A lab from such text, with an exercise from its own file. Fails, naming the line, on
// anything else.
Result<Lab> open_autosave(std::string_view text, std::string file_name);

// What a lab that crashed has left behind.
struct Leftover {
    std::filesystem::path file;
    RecoveryOffer offer;
};

class Autosave {
public:
    static constexpr double period = 20;  // s of work at most that a crash may cost

    // Looks for what another lab has left in the folder; the newest counts. One that cannot be read is renamed to
    // <name>.broken and complained about. An empty folder: nothing is looked for or written.
    explicit Autosave(std::filesystem::path folder, std::vector<Error>& complaints);
    Autosave(Autosave&&) = default;
    Autosave& operator=(Autosave&&) = default;

    const std::optional<Leftover>& leftover() const { return leftover_; }

    // The work that was left behind, or why it cannot be had. It stays on the disk until forget().
    Result<Lab> recover() const;
    void forget();

    // Writes when there is work that is not on the disk yet: 20 s after it began, or at once when `mode` has changed or
    // `now` is set. What a person saved needs no keeping. An error is told once until writing works again.
    std::optional<Error> keep(const Lab&, double wall_seconds, bool now = false);

    // At a proper end: there is nothing to recover.
    void finish();

private:
    bool begin();  // takes a name and its lock

    std::filesystem::path folder_, file_;
    std::optional<FileLock> lock_;
    std::optional<Leftover> leftover_;
    std::int64_t kept_ = 0;    // Lab::work as on the disk
    double dirty_since_ = -1;  // wall seconds; negative: all is on the disk
    Mode mode_ = Mode::paused;
    bool failed_ = false;
};

}  // namespace braitenlab
