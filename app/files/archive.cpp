#include "app/files/archive.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <utility>

#include <unzip.h>

#include "core/messages.h"
#include "core/scene/schema.h"
#include "core/utf8.h"

namespace braitenlab {

bool is_zip(std::string_view content) {
    using namespace std::string_view_literals;
    return content.starts_with("PK\x03\x04"sv) || content.starts_with("PK\x05\x06"sv);  // the second one is empty
}

bool is_zip_file(const std::filesystem::path& path) {
    std::array<char, 4> first{};
    std::ifstream in(path, std::ios::binary);
    in.read(first.data(), first.size());
    return in && is_zip({first.data(), first.size()});
}

struct Archive::Impl {
    explicit Impl(const std::filesystem::path& path) : name(path.string()), zip(unzOpen64(name.c_str())) {}
    ~Impl() {
        if (zip) unzClose(zip);
    }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    std::string name;
    unzFile zip;
    std::vector<Entry> entries;
    std::vector<unz64_file_pos> places;  // of the entries
    std::uint64_t bytes_left = limits::archive_bytes;
};

namespace {

std::string in_utf8(std::string_view name) {
    std::string text;
    while (!name.empty()) {
        const CodePoint first = first_code_point(name);
        text += first.is_valid ? name.substr(0, first.size) : "?";
        name.remove_prefix(first.size);
    }
    return text;
}

// The entry of the current file; nullopt if the archive is damaged.
std::optional<Archive::Entry> current_entry(unzFile zip) {
    unz_file_info64 info{};
    if (unzGetCurrentFileInfo64(zip, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK) return std::nullopt;
    std::string name(info.size_filename, '\0');
    if (unzGetCurrentFileInfo64(zip, &info, name.data(), info.size_filename, nullptr, 0, nullptr, 0) != UNZ_OK)
        return std::nullopt;
    Archive::Entry entry{in_utf8(name)};
    for (char& c : entry.path) c = c == '\\' ? '/' : c;  // of old programs for Windows
    entry.is_folder = entry.path.ends_with('/');
    while (entry.path.ends_with('/')) entry.path.pop_back();
    entry.path.erase(0, entry.path.find_first_not_of('/'));
    return entry;
}

}  // namespace

Archive::Archive(std::shared_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<Archive> Archive::open(const std::filesystem::path& path) {
    auto impl = std::make_shared<Impl>(path);
    const Error damaged{"this is no ZIP archive, or it is damaged; download it again", path.string()};
    if (!impl->zip) return damaged;
    unz_global_info64 info{};
    if (unzGetGlobalInfo64(impl->zip, &info) != UNZ_OK) return damaged;
    if (info.number_entry > limits::archive_entries)
        return Error{"the archive has more than " + std::to_string(limits::archive_entries) +
                         " files; unpack it and give the folders one by one",
                     path.string()};
    int step = info.number_entry == 0 ? UNZ_END_OF_LIST_OF_FILE : unzGoToFirstFile(impl->zip);
    for (; step == UNZ_OK; step = unzGoToNextFile(impl->zip)) {
        auto entry = current_entry(impl->zip);
        unz64_file_pos place{};
        if (!entry || unzGetFilePos64(impl->zip, &place) != UNZ_OK) return damaged;
        impl->entries.push_back(std::move(*entry));
        impl->places.push_back(place);
    }
    if (step != UNZ_END_OF_LIST_OF_FILE) return damaged;
    return Archive(std::move(impl));
}

const std::vector<Archive::Entry>& Archive::entries() const { return impl_->entries; }

Result<std::string> Archive::read(std::size_t entry) {
    const std::string name = impl_->entries[entry].path;
    const Error damaged{"cannot be unpacked: it is damaged or needs a password", name};
    if (unzGoToFilePos64(impl_->zip, &impl_->places[entry]) != UNZ_OK) return damaged;
    if (unzOpenCurrentFile(impl_->zip) != UNZ_OK) return damaged;
    std::string text;
    std::array<char, 1u << 16u> part{};
    int size = 0;
    while ((size = unzReadCurrentFile(impl_->zip, part.data(), static_cast<unsigned>(part.size()))) > 0) {
        const auto bytes = static_cast<std::size_t>(size);
        const bool is_within = text.size() + bytes <= limits::file_bytes && bytes <= impl_->bytes_left;
        impl_->bytes_left -= std::min<std::uint64_t>(bytes, impl_->bytes_left);
        if (!is_within) {
            unzCloseCurrentFile(impl_->zip);
            return impl_->bytes_left == 0
                       ? Error{"the archive unpacks to more than " + std::to_string(limits::archive_bytes >> 20u) +
                                   " MB; unpack it and give the folder",
                               impl_->name}
                       : error_of(message_of("too_large", limits::file_bytes >> 20u), name);
        }
        text.append(part.data(), bytes);
    }
    const bool is_whole = unzCloseCurrentFile(impl_->zip) == UNZ_OK;  // false for a wrong checksum
    if (size < 0 || !is_whole) return damaged;
    return text;
}

}  // namespace braitenlab
