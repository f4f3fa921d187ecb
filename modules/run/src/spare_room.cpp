#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

#include <scree/files/descriptor.hpp>
#include <scree/run/run_directory.hpp>
#include <scree/run/spare_room.hpp>

namespace scree::run {

void SpareRoom::reserve(const std::filesystem::path& file, std::size_t bytes) {
  const files::Descriptor open_file = files::create_file(file.c_str());
  if (!open_file.is_open()) throw_unwritable(file, errno);
  file_ = file;
  const int code = posix_fallocate(open_file.get(), 0, off_t(bytes));
  if (code == ENOSPC || code == EDQUOT) throw_unwritable(file, code);
}

void SpareRoom::release() {
  if (!file_.empty()) unlink(file_.c_str());
  file_.clear();
}

}  // namespace scree::run
