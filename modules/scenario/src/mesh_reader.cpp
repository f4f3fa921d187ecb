#include "readers.hpp"

#include <memory>

#include <fmt/format.h>

#include <scree/pictures/load_backend.hpp>

namespace scree::scenario {

MeshReader read_meshes_from(const std::filesystem::path& folder) {
  return [folder](const document::Table& table, const char* key) {
    const std::string file = table.string(key);
    if (!pictures::has_pictures())
      throw table.error(key, std::string(pictures::no_pictures), std::string(pictures::no_pictures_cure));
    return placed(table, key, [&] { return pictures::load_backend()->read_mesh(folder / file); });
  };
}

MeshReader recorded_meshes(const std::vector<RecordedPlugin>& boundaries) {
  struct Next {
    std::vector<RecordedPlugin> boundaries;
    std::size_t number = 0;
  };
  const auto next = std::make_shared<Next>(Next{boundaries});
  return [next](const document::Table& table, const char* key) {
    const std::string begin = fmt::format("{} = ", key);
    for (; next->number < next->boundaries.size(); ++next->number)
      for (const std::string& line : next->boundaries[next->number].parameters)
        if (next->boundaries[next->number].plugin == table.string("plugin") && line.starts_with(begin)) {
          table.string(key);  // it is not an unknown key
          ++next->number;
          return numbers_of_line(line);
        }
    throw table.error(key, "the state has no such mesh", "begin a new run from the state (particles.state)");
  };
}

std::vector<double> no_mesh(const document::Table& table, const char* key) {
  throw table.error(key, "a mesh is read at the start of a run alone", "remove it");
}

}  // namespace scree::scenario
