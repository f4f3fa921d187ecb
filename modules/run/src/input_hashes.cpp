#include <scree/files/content_hash.hpp>
#include <scree/run/input_hashes.hpp>

namespace scree::run {

InputHashes hashes_of(const scenario::InputFiles& files) {
  InputHashes hashes;
  if (!files.bodies.empty()) hashes.bodies = files::file_hash(files.bodies);
  for (const auto& [name, path] : files.plugins) hashes.plugins[name] = files::file_hash(path);
  return hashes;
}

}  // namespace scree::run
