#include "app/ctl/ranks.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <list>
#include <optional>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <mpi.h>
#include <sched.h>
#include <unistd.h>

#include "app/ctl/ctl.h"
#include "app/jobs/jobs.h"
#include "app/platform/platform.h"

namespace braitenlab {

namespace {

// Messages from rank 0: a list of parts, a chunk of them, the end; to it: numbers of a chunk.
enum Tag { list_tag = 1, chunk_tag, end_tag, numbers_tag };

// Set once by run_in_ranks(), before there are threads.
struct JobOfRanks {
    int rank = 0, size = 1;
    pid_t launcher = 0;        // the parent process
    std::vector<int> threads;  // by rank, if the user gives no number
} mpi_job;

struct Chunk {
    std::size_t first = 0, count = 0;
};

// Open MPI ends the ranks of a killed launcher a second later, and with 5.0 only those that call MPI. A rank ends
// before, without a message, since nothing reads it.
void end_without_launcher() {
    if (getppid() != mpi_job.launcher) std::_Exit(exit_code::failed);
}

// The wait between two looks for messages: half of the time in which nothing has happened, so that a rank reacts
// soon to what comes soon, as single short parts at the end of a list do. A rank that waits inside MPI would take a
// whole processor.
class Pause {
public:
    void wait() {
        end_without_launcher();
        const auto quiet = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - since_) / 2;
        std::this_thread::sleep_for(std::clamp(quiet, shortest, longest));
    }
    void be_short() { since_ = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::microseconds shortest{50}, longest{500};
    Clock::time_point since_ = Clock::now();  // the last event
};

// Messages that are on their way. A rank sends and goes on computing: a long message leaves only once its receiver
// looks for messages.
class Outbox {
public:
    ~Outbox() {
        for (Pause pause; !is_empty(); pause.wait()) {
        }
    }

    void send(std::string bytes, int rank, Tag tag) {
        Sent& sent = sent_.emplace_back(std::move(bytes), MPI_REQUEST_NULL);
        // MPI_Test() completes the request, which the analyzer does not know.
        MPI_Isend(sent.bytes.data(), static_cast<int>(sent.bytes.size()), MPI_BYTE, rank, tag, MPI_COMM_WORLD,
                  &sent.request);  // NOLINT(*MPI-Checker)
    }
    // False while a message is on its way. Call often, so that MPI goes on.
    bool is_empty() {
        std::erase_if(sent_, [](Sent& sent) {
            int done = 0;
            MPI_Test(&sent.request, &done, MPI_STATUS_IGNORE);
            return done != 0;
        });
        return sent_.empty();
    }

private:
    struct Sent {
        std::string bytes;
        MPI_Request request;
    };
    std::list<Sent> sent_;  // MPI holds the addresses
};

struct RankMessage {
    Tag tag{};
    int rank = 0;
    std::string bytes;

    template <class T>
    T as() const {
        T value{};
        std::copy_n(bytes.data(), std::min(bytes.size(), sizeof value), reinterpret_cast<char*>(&value));
        return value;
    }
};

std::optional<RankMessage> receive() {
    MPI_Status status;
    int is_there = 0, size = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &is_there, &status);
    if (!is_there) return std::nullopt;
    MPI_Get_count(&status, MPI_BYTE, &size);
    RankMessage message{static_cast<Tag>(status.MPI_TAG), status.MPI_SOURCE,
                        std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.rank, message.tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
}

// Chunks that this process computes: worker threads and, between two looks for messages, the thread that calls MPI. A
// thread that only looked for messages would wait for the processor on which a worker computes, 4 ms on Linux 6.18,
// longer than most parts take.
class OwnChunks {
public:
    OwnChunks(Jobs& jobs, Part part) : jobs_(jobs), part_(std::move(part)) {}

    void add(Chunk chunk) {
        running_.push_back(
            {chunk, jobs_.submit_one_by_one(
                        chunk.count, [part = part_, first = chunk.first](std::size_t i) { return part(first + i); })});
    }
    std::size_t size() const { return running_.size(); }

    // Computes a part. False when none waits.
    bool step() { return jobs_.step(); }

    // Calls each(chunk, numbers) for those that are complete. The error of a part, if one has failed.
    std::optional<Error> take(const auto& each) {
        jobs_.publish();
        std::optional<Error> error;
        std::erase_if(running_, [&](Running& running) {
            const auto result = running.job.take();
            if (!result) return false;
            if (*result)
                each(running.chunk, **result);
            else
                error = result->error();
            return true;
        });
        return error;
    }

private:
    struct Running {
        Chunk chunk;
        Job<std::vector<Numbers>> job;
    };
    Jobs& jobs_;
    Part part_;
    std::vector<Running> running_;
};

// Chunks are large at first, so that there are few messages, and small at the end, so that no rank waits for another.
class Handout {
public:
    Handout(std::size_t count, int wanted_threads) : count_(count), wanted_(wanted_threads) {}

    std::optional<Chunk> take(int rank) {
        const std::size_t left = count_ - next_;
        if (left == 0) return std::nullopt;
        const auto own =
            static_cast<std::size_t>(wanted_ > 0 ? wanted_ : mpi_job.threads[static_cast<std::size_t>(rank)]);
        const std::size_t share = left * own / static_cast<std::size_t>(threads_of_ranks(wanted_)) / 6;
        const Chunk chunk{next_, std::min(left, std::clamp(share, own, 64 * own))};
        next_ += chunk.count;
        return chunk;
    }

private:
    std::size_t count_, next_ = 0;
    int wanted_;
};

std::string bytes_of(Chunk chunk) { return {reinterpret_cast<const char*>(&chunk), sizeof chunk}; }

// A rank computes one chunk while the next ones wait or are on their way: rank 0 answers between two parts of its own,
// so that the answer to a chunk of one part takes as long as two parts.
constexpr std::size_t chunks_of_rank = 3;

// Of each part their number, then they.
std::string packed(Chunk chunk, const std::vector<Numbers>& all) {
    std::vector<double> flat{static_cast<double>(chunk.first)};
    for (const Numbers& numbers : all) {
        flat.push_back(static_cast<double>(numbers.size()));
        flat.insert(flat.end(), numbers.begin(), numbers.end());
    }
    return {reinterpret_cast<const char*>(flat.data()), flat.size() * sizeof(double)};
}

// Returns the number of parts.
std::size_t unpack(const RankMessage& message, std::vector<Numbers>& all) {
    std::vector<double> flat(message.bytes.size() / sizeof(double));
    std::copy_n(message.bytes.data(), flat.size() * sizeof(double), reinterpret_cast<char*>(flat.data()));
    std::size_t count = 0;
    for (std::size_t at = 1; at < flat.size(); ++count) {
        const auto size = static_cast<std::ptrdiff_t>(flat[at++]);
        const auto from = flat.begin() + static_cast<std::ptrdiff_t>(at);
        all[static_cast<std::size_t>(flat[0]) + count].assign(from, from + size);
        at += static_cast<std::size_t>(size);
    }
    return count;
}

[[noreturn]] void fail_all(const Error& error) {
    complain({fmt::format("rank {}: {}", mpi_job.rank, error.text())});
    std::cerr.flush();
    MPI_Abort(MPI_COMM_WORLD, exit_code::failed);  // with 0 or 256 the launcher would report a success
    std::_Exit(exit_code::failed);
}

// The program of all ranks but the first. A list begins with its number of threads on a line.
void serve() {
    std::optional<Jobs> jobs;
    std::optional<OwnChunks> chunks;
    int wanted_before = -1;
    Pause pause;
    Outbox outbox;
    for (;;) {
        end_without_launcher();
        const auto message = receive();
        if (message) pause.be_short();
        if (message && message->tag == end_tag) return;
        if (message && message->tag == list_tag) {
            const std::string_view text = message->bytes;
            const std::size_t line = text.find('\n');
            int wanted = 0;
            std::from_chars(text.data(), text.data() + line, wanted);
            auto part = part_of(text.substr(line + 1));
            if (!part) fail_all(part.error());
            chunks.reset();
            if (wanted != wanted_before) jobs.emplace(worker_threads_of_rank(wanted));
            wanted_before = wanted;
            chunks.emplace(*jobs, std::move(*part));
        }
        if (message && message->tag == chunk_tag) chunks->add(message->as<Chunk>());
        if (chunks) {
            const auto error = chunks->take([&](Chunk chunk, const std::vector<Numbers>& numbers) {
                outbox.send(packed(chunk, numbers), 0, numbers_tag);
                pause.be_short();
            });
            if (error) fail_all(*error);
        }
        outbox.is_empty();
        if (chunks && chunks->step()) continue;
        if (!message) pause.wait();
    }
}

// A variable of the launcher as a number; 0 without it.
int number_in_environment(const char* name) {
    const char* text = std::getenv(name);
    return text ? std::max(0, std::atoi(text)) : 0;
}

// The processes of the job as the launcher has told them; 0 without one.
int ranks_of_launcher() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "SLURM_STEP_NUM_TASKS", "PMI_SIZE"})
        if (const int size = number_in_environment(name); size > 0) return size;
    return 0;
}
bool is_first_of_launcher() {
    return number_in_environment("OMPI_COMM_WORLD_RANK") + number_in_environment("SLURM_PROCID") +
               number_in_environment("PMI_RANK") ==
           0;
}

int refuse(const std::string& what) {
    if (is_first_of_launcher()) complain({what});
    return exit_code::bad_input;
}

// Each processor counts as much as the ranks of this computer that may use it leave to each of them.
int share_of_processors() {
    cpu_set_t own;
    CPU_ZERO(&own);
    if (sched_getaffinity(0, sizeof own, &own) != 0) return 1;
    MPI_Comm computer = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &computer);
    int here = 1;
    MPI_Comm_size(computer, &here);
    std::vector<cpu_set_t> all(static_cast<std::size_t>(here));
    MPI_Allgather(&own, sizeof own, MPI_BYTE, all.data(), sizeof own, MPI_BYTE, computer);
    MPI_Comm_free(&computer);
    double share = 0;
    for (std::size_t processor = 0; processor < CPU_SETSIZE; ++processor)
        if (CPU_ISSET(processor, &own))
            share += 1.0 / static_cast<double>(std::count_if(all.begin(), all.end(), [&](const cpu_set_t& set) {
                         return CPU_ISSET(processor, &set);
                     }));
    return std::max(1, static_cast<int>(share + 1e-6));
}

// Open MPI looks for networks for a fifth of a second, which ranks of one computer do not need. A choice by --mca or in
// the environment stays.
void leave_out_networks() {
#ifdef OMPI_MAJOR_VERSION
    const int all = number_in_environment("OMPI_COMM_WORLD_SIZE");
    if (all == 0 || number_in_environment("OMPI_COMM_WORLD_LOCAL_SIZE") != all) return;
    for (const char* name : {"OMPI_MCA_pml", "OMPI_MCA_btl"})
        if (std::getenv(name)) return;
    setenv("OMPI_MCA_pml", "ob1", 0);
    setenv("OMPI_MCA_btl", OMPI_MAJOR_VERSION < 5 ? "self,vader" : "self,sm", 0);
#endif
}

}  // namespace

bool has_ranks() { return mpi_job.size > 1; }

int threads_of_rank() { return has_ranks() ? mpi_job.threads[static_cast<std::size_t>(mpi_job.rank)] : 0; }

int worker_threads_of_rank(int wanted) { return (wanted > 0 ? wanted : threads_of_rank()) - 1; }

int threads_of_ranks(int wanted) {
    int sum = 0;
    for (const int own : mpi_job.threads) sum += wanted > 0 ? wanted : own;
    return sum;
}

Result<std::vector<Numbers>> run_on_ranks(Jobs& jobs, int wanted_threads, const Parts& parts) {
    std::vector<Numbers> numbers(parts.count);
    Handout handout(parts.count, wanted_threads);
    Outbox outbox;
    const auto give = [&](int rank) {
        if (const auto chunk = handout.take(rank)) outbox.send(bytes_of(*chunk), rank, chunk_tag);
    };
    const std::string text = fmt::format("{}\n{}", wanted_threads, parts.text());
    for (int rank = 1; rank < mpi_job.size; ++rank) outbox.send(text, rank, list_tag);
    for (std::size_t i = 0; i < chunks_of_rank; ++i)
        for (int rank = 1; rank < mpi_job.size; ++rank) give(rank);

    OwnChunks own(jobs, parts.part);
    const auto fill = [&] {
        while (own.size() < chunks_of_rank) {
            const auto chunk = handout.take(0);
            if (!chunk) break;
            own.add(*chunk);
        }
    };
    fill();
    if (parts.meanwhile) parts.meanwhile();
    Pause pause;
    for (std::size_t missing = parts.count; missing > 0;) {
        end_without_launcher();
        if (is_told_to_end()) return std::vector<Numbers>{};
        fill();
        const auto error = own.take([&](Chunk chunk, const std::vector<Numbers>& made) {
            std::copy(made.begin(), made.end(), numbers.begin() + static_cast<std::ptrdiff_t>(chunk.first));
            missing -= chunk.count;
            pause.be_short();
        });
        if (error) fail_all(*error);
        while (const auto message = receive()) {
            missing -= unpack(*message, numbers);
            give(message->rank);
            pause.be_short();
        }
        outbox.is_empty();
        if (!own.step() && missing > 0) pause.wait();
    }
    return numbers;
}

int run_in_ranks(const std::function<int()>& command) {
    const int told = ranks_of_launcher();
    if (told < 2) return command();
    if (!std::getenv("PMIX_RANK") && !std::getenv("OMPI_COMM_WORLD_RANK"))
        return refuse(fmt::format(
            "{} processes were started that do not know each other; start them with mpirun, or with srun --mpi=pmix",
            told));
    leave_out_networks();
    int provided = 0;
    mpi_job.launcher = getppid();
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &mpi_job.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &mpi_job.size);
    if (mpi_job.size != told || provided < MPI_THREAD_FUNNELED) {
        const int code = refuse(
            fmt::format("{} processes were started, but MPI connects {}; use the launcher of the MPI of this program",
                        told, mpi_job.size));
        MPI_Finalize();
        return code;
    }
    const int own = share_of_processors();
    mpi_job.threads.resize(static_cast<std::size_t>(mpi_job.size));
    MPI_Allgather(&own, 1, MPI_INT, mpi_job.threads.data(), 1, MPI_INT, MPI_COMM_WORLD);
    if (mpi_job.rank > 0) {
        serve();
        MPI_Finalize();
        return exit_code::done;
    }
    is_told_to_end();  // from now on rank 0 ends a command in order
    const int code = command();
    std::cout.flush(), std::cerr.flush();
    // Without MPI_Finalize, which would wait for ranks that the launcher has ended.
    if (is_told_to_end()) std::_Exit(code);
    {
        Outbox outbox;
        for (int rank = 1; rank < mpi_job.size; ++rank) outbox.send({}, rank, end_tag);
    }
    MPI_Finalize();
    return code;
}

}  // namespace braitenlab
