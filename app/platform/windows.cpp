#include <codecvt>
#include <csignal>
#include <cwchar>
#include <locale>
#include <string>
#include <string_view>
#include <vector>

#define WIN32_LEAN_AND_MEAN
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
// After windows.h.
#include <fcntl.h>
#include <io.h>
#include <knownfolders.h>
#include <shellapi.h>
#include <shlobj.h>
#include <sys/stat.h>

#include "app/platform/memory.h"
#include "app/platform/platform.h"

namespace braitenlab {

namespace {

std::string utf8_of(std::wstring_view wide) {
    const int length = static_cast<int>(wide.size());
    std::string text(static_cast<std::size_t>(length) * 3, '\0');  // a UTF-16 unit takes at most three bytes
    const int used = WideCharToMultiByte(CP_UTF8, 0, wide.data(), length, text.data(), static_cast<int>(text.size()),
                                         nullptr, nullptr);
    text.resize(static_cast<std::size_t>(used));
    return text;
}

std::filesystem::path known_folder(const KNOWNFOLDERID& id) {
    wchar_t* found = nullptr;
    std::filesystem::path folder;
    if (SHGetKnownFolderPath(id, KF_FLAG_DEFAULT, nullptr, &found) == S_OK) folder = found;
    CoTaskMemFree(found);
    return folder;
}

std::filesystem::path inside(const std::filesystem::path& folder, const char* name) {
    return folder.empty() ? folder : folder / name;
}

std::wstring wide_of(std::string_view utf8) {
    std::wstring text(utf8.size(), L'\0');
    const int length = static_cast<int>(utf8.size());
    const int used = MultiByteToWideChar(CP_UTF8, 0, utf8.data(), length, text.data(), length);
    text.resize(static_cast<std::size_t>(used));
    return text;
}

// An argument as CommandLineToArgvW reads it: in quotes, with backslashes doubled before a quote.
std::wstring quoted(const std::wstring& argument) {
    std::wstring text = L"\"";
    std::size_t backslashes = 0;
    for (const wchar_t c : argument) {
        if (c == L'"') text.append(backslashes + 1, L'\\');
        backslashes = c == L'\\' ? backslashes + 1 : 0;
        text += c;
    }
    return text.append(backslashes, L'\\') + L'"';
}

HANDLE handle_of(int file) { return reinterpret_cast<HANDLE>(_get_osfhandle(file)); }

}  // namespace

std::filesystem::path program_file() {
    std::wstring name(32768, L'\0');  // the longest path of the system
    name.resize(GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size())));
    return name;
}

void keep_freed_memory() {}  // the heap keeps it

void use_utf8(int& count, char**& arguments) {
    _setmode(_fileno(stdout), _O_BINARY);  // the same bytes in a table as on other systems
    SetConsoleOutputCP(CP_UTF8);
    wchar_t** wide = CommandLineToArgvW(GetCommandLineW(), &count);
    if (!wide) return;
    static std::vector<std::string> texts;
    static std::vector<char*> pointers;
    for (int i = 0; i < count; ++i) texts.push_back(utf8_of(wide[i]));
    LocalFree(wide);
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    arguments = pointers.data();
}

UserFolders user_folders() {
    return {.home = known_folder(FOLDERID_Profile),
            .config = inside(known_folder(FOLDERID_RoamingAppData), "Braitenlab"),
            .state = inside(known_folder(FOLDERID_LocalAppData), "Braitenlab"),
            .pictures = known_folder(FOLDERID_Pictures),
            .documents = known_folder(FOLDERID_Documents)};
}

std::FILE* open_for_writing(const std::filesystem::path& path) { return _wfopen(path.c_str(), L"wb"); }

bool is_terminal(std::FILE* stream) { return _isatty(_fileno(stream)) != 0; }

bool flush_to_disk(std::FILE* file) { return _commit(_fileno(file)) == 0; }

void flush_folder_to_disk(const std::filesystem::path&) {}  // NTFS writes names to its journal

FileLock::~FileLock() {
    if (handle_ >= 0) _close(handle_);
}

std::optional<FileLock> lock_file(const std::filesystem::path& path) {
    const int handle = _wopen(path.c_str(), _O_RDWR | _O_CREAT | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
    if (handle < 0) return std::nullopt;
    FileLock lock(handle);
    OVERLAPPED start{};
    if (!LockFileEx(handle_of(handle), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0, 1, 0, &start))
        return std::nullopt;
    return lock;
}

namespace {

volatile std::sig_atomic_t told_to_end = 0;  // set by the handler, on a thread of the system

BOOL WINAPI note_end_request(DWORD) {
    if (told_to_end) return FALSE;  // the second request: the system ends the program at once
    told_to_end = 1;
    return TRUE;
}

}  // namespace

bool is_told_to_end() {
    static const bool installed = SetConsoleCtrlHandler(note_end_request, TRUE) != 0;
    return installed && told_to_end;
}

void let_requests_interrupt(bool) {}

double thread_time() {
    FILETIME created{}, ended{}, kernel{}, user{};
    GetThreadTimes(GetCurrentThread(), &created, &ended, &kernel, &user);
    const auto seconds = [](const FILETIME& time) {
        return (static_cast<double>(time.dwHighDateTime) * 4294967296.0 + time.dwLowDateTime) * 1e-7;
    };
    return seconds(kernel) + seconds(user);
}

void end_at_closed_pipe() {}

bool has_threads() { return true; }

bool saves_by_download() { return false; }

bool may_refuse_downloads() { return false; }

std::filesystem::path find_program(const std::string& name) {
    std::wstring found(32768, L'\0');
    const DWORD length =
        SearchPathW(nullptr, wide_of(name).c_str(), L".exe", static_cast<DWORD>(found.size()), found.data(), nullptr);
    if (length == 0 || length >= found.size()) return {};
    found.resize(length);
    return found;
}

bool open_with_system(const std::filesystem::path& file) {
    const HINSTANCE result = ShellExecuteW(nullptr, L"open", file.c_str(), nullptr, nullptr, SW_SHOWNORMAL);
    return reinterpret_cast<INT_PTR>(result) > 32;  // below: an error
}

struct ProgramPipe::Running {
    HANDLE process = nullptr, input = nullptr;

    void close_input() {
        if (input) CloseHandle(input);
        input = nullptr;
    }
};

ProgramPipe::ProgramPipe(std::unique_ptr<Running> running) : running_(std::move(running)) {}
ProgramPipe::ProgramPipe(ProgramPipe&&) noexcept = default;

// The errors of the program are discarded.
std::optional<ProgramPipe> ProgramPipe::start(const std::filesystem::path& program,
                                              const std::vector<std::string>& arguments) {
    std::wstring line = quoted(program.wstring());
    for (const std::string& argument : arguments) line += L' ' + quoted(wide_of(argument));
    SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
    HANDLE reads = nullptr, writes = nullptr;
    if (!CreatePipe(&reads, &writes, &inherited, 0)) return std::nullopt;
    SetHandleInformation(writes, HANDLE_FLAG_INHERIT, 0);
    const HANDLE nowhere =
        CreateFileW(L"NUL", GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_WRITE, &inherited, OPEN_EXISTING, 0, nullptr);
    STARTUPINFOW start{};
    start.cb = sizeof(start);
    start.dwFlags = STARTF_USESTDHANDLES;
    start.hStdInput = reads, start.hStdOutput = nowhere, start.hStdError = nowhere;
    PROCESS_INFORMATION begun{};
    const bool runs = CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, TRUE, CREATE_NO_WINDOW, nullptr,
                                     nullptr, &start, &begun) != 0;
    CloseHandle(reads);
    CloseHandle(nowhere);
    if (!runs) {
        CloseHandle(writes);
        return std::nullopt;
    }
    CloseHandle(begun.hThread);
    auto running = std::make_unique<Running>();
    running->process = begun.hProcess, running->input = writes;
    return ProgramPipe(std::move(running));
}

ProgramPipe::~ProgramPipe() {
    if (!running_ || !running_->process) return;
    running_->close_input();
    TerminateProcess(running_->process, 1);
    WaitForSingleObject(running_->process, INFINITE);
    CloseHandle(running_->process);
}

bool ProgramPipe::write(std::string_view bytes) {
    while (!bytes.empty()) {
        DWORD taken = 0;
        if (!WriteFile(running_->input, bytes.data(), static_cast<DWORD>(bytes.size()), &taken, nullptr)) return false;
        bytes.remove_prefix(taken);
    }
    return true;
}

std::optional<std::string> ProgramPipe::finish() {
    running_->close_input();
    WaitForSingleObject(running_->process, INFINITE);
    DWORD code = 1;
    GetExitCodeProcess(running_->process, &code);
    CloseHandle(std::exchange(running_->process, nullptr));
    if (code == 0) return std::nullopt;
    return std::string{};
}

long process_number() { return static_cast<long>(GetCurrentProcessId()); }

std::string system_language() {
    wchar_t name[LOCALE_NAME_MAX_LENGTH];
    if (GetUserDefaultLocaleName(name, LOCALE_NAME_MAX_LENGTH) == 0) return {};
    const std::string locale = utf8_of(name);
    const std::string code = locale.substr(0, locale.find('-'));
    return code.size() == 2 ? code : std::string{};
}

}  // namespace braitenlab

#ifdef __MINGW32__

// libstdc++ 12 makes UTF-8 of a path for path::string(), but reads the narrow string of a new path in the C locale. Its
// conversion for that is this member function of std::codecvt<wchar_t, char, std::mbstate_t>; the linker's --wrap
// option (see app/CMakeLists.txt) replaces it by one that reads UTF-8.
extern "C" std::codecvt_base::result __wrap__ZNKSt7codecvtIwciE5do_inERiPKcS3_RS3_PwS5_RS5_(
    const void*, std::mbstate_t& state, const char* from, const char* from_end, const char*& from_next, wchar_t* to,
    wchar_t* to_end, wchar_t*& to_next) {
    static const std::codecvt_utf8_utf16<wchar_t> utf8;
    return utf8.in(state, from, from_end, from_next, to, to_end, to_next);
}

#endif
