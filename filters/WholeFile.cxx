// SPDX-License-Identifier: GPL-3.0-or-later
#include "WholeFile.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace foam::filters {
namespace {

[[noreturn]] void fail_to_write(const std::filesystem::path& path, int cause) {
  throw std::system_error(cause, std::generic_category(), "cannot write " + path.string());
}

/// An open file or folder.
class Descriptor {
public:
  Descriptor(const std::filesystem::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) {
      fail_to_write(path, errno);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { ::close(descriptor_); }
  operator int() const { return descriptor_; }

private:
  int descriptor_;
};

/// \returns 0, or the cause of what went wrong.
int write_to_disk(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const auto written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno != EINTR) {
      return errno;
    }
    content.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
  return ::fsync(descriptor) == 0 ? 0 : errno;
}

} // namespace

std::filesystem::path unfinished(const std::filesystem::path& path) {
  return path.parent_path() / (".unfinished-" + path.filename().string());
}

void write_unfinished(const std::filesystem::path& path, std::string_view content) {
  const auto name = unfinished(path);
  int cause = 0;
  {
    const Descriptor file(name, O_WRONLY | O_CREAT | O_TRUNC);
    cause = write_to_disk(file, content);
  }
  if (cause != 0) {
    ::unlink(name.c_str());
    fail_to_write(path, cause);
  }
}

void write_whole(const std::filesystem::path& path, std::string_view content) {
  write_unfinished(path, content);
  const auto name = unfinished(path);
  if (::rename(name.c_str(), path.c_str()) != 0) {
    const int cause = errno;
    ::unlink(name.c_str());
    fail_to_write(path, cause);
  }
  const auto folder = path.parent_path();
  ::fsync(Descriptor(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY));
}

} // namespace foam::filters
