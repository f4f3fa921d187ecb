#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

#include <scree/run/run_directory.hpp>
#include <scree/run/spare_room.hpp>

namespace scree::run {

void SpareRoom::reserve(const RunDirectory& directory, const char* record) {
  path_ = directory.add(file_name);
  std::error_code failed;  // without a record none is kept for it
  const std::uintmax_t present = std::filesystem::file_size(directory.path() / record, failed);
  file_ = files::create_file(path_.c_str());
  if (!file_.is_open()) throw_unwritable(path_, errno);
  const int code = posix_fallocate(file_.get(), 0, off_t(size + (failed ? 0 : present)));
  if (code == ENOSPC || code == EDQUOT) throw_unwritable(path_, code);
}

void SpareRoom::release() {
  if (file_.is_open() && files::is_at(file_, path_.c_str())) unlink(path_.c_str());
  file_ = files::Descriptor();
}

}  // namespace scree::run
