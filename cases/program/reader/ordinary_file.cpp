#include "cases/program/reader/ordinary_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <limits>
#include <new>
#include <system_error>

namespace delabole {

namespace {

FileContent read_up_to(const std::filesystem::path& path, std::string_view what, std::uintmax_t largest,
                       std::uintmax_t most) {
    const auto unreadable = [](const std::error_code& error) {
        return FileContent{{}, "cannot be read: " + error.message()};
    };
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        return error && error != std::errc::no_such_file_or_directory ? unreadable(error)
                                                                      : FileContent{{}, "there is no such file"};
    }
    if (std::filesystem::is_directory(status)) {
        return {{}, "is a folder, not " + std::string(what)};
    }
    // A pipe or a device has no size and may never end.
    if (!std::filesystem::is_regular_file(status)) {
        return {{}, "is not an ordinary file"};
    }
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) {
        return unreadable(error);
    }
    if (size > largest) {
        return {{}, "is larger than " + std::to_string(largest >> 20U) + " MiB, the limit for " + std::string(what)};
    }
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        return unreadable({errno, std::generic_category()});
    }
    FileContent content{.size = size};
    const auto wanted = static_cast<std::size_t>(std::min(size, most));
    try {
        content.bytes.resize(wanted);
    } catch (const std::bad_alloc&) {
        content.fault = "does not fit into the memory";
        return content;
    }
    stream.read(content.bytes.data(), static_cast<std::streamsize>(wanted));
    content.bytes.resize(static_cast<std::size_t>(stream.gcount()));
    if (stream.bad()) {
        content.fault = "cannot be read to its end";
    }
    return content;
}

}  // namespace

FileContent read_ordinary_file(const std::filesystem::path& path, std::string_view what, std::size_t largest) {
    return read_up_to(path, what, largest, largest);
}

FileContent read_beginning(const std::filesystem::path& path, std::string_view what, std::size_t most) {
    return read_up_to(path, what, std::numeric_limits<std::uintmax_t>::max(), most);
}

}  // namespace delabole
