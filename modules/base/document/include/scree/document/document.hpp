#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <scree/document/table.hpp>

namespace scree::document {

struct DocumentState;

// Text of a scene: a TOML file with the "key=value" overrides of the command line applied in order.
// The key of an override is a dotted path. It selects an entry of an array of tables by index
// (stage[1].duration=2) or by the name, plugin or type of the entry (stage.cycle.duration=5); neither is
// needed if there is only one entry. The value is TOML; a bare word is read as a string.
class Document {
 public:
  // Maximum size of a file (bytes). Many particles belong in a packing file, not in a scene.
  static constexpr std::size_t largest_file = 16u << 20;

  // Throws Error (bad_input) if the file cannot be read, is not TOML or contains no key, or if an override
  // cannot be applied. cure: what to write into an empty file.
  static Document load(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                       std::string_view cure = "write a scene: [scene], [time], [particles], ...");
  // name: name of the file in messages.
  static Document parse(std::string_view text, std::string_view name,
                        const std::vector<std::string>& overrides = {});

  Table root() const;
  // Throws for the first key, in file order, that no reader has requested; keys of overrides come last.
  void refuse_unused() const { root().refuse_unused(); }
  // TOML with the overrides applied: keys in file order, numbers that read back to the same bits, no
  // comments.
  std::string resolved_text() const;
  // "--set a=1 is undone by --set b=2" for the first override that overwrites all or part of what an earlier
  // one wrote; empty if there is none.
  const std::string& conflict() const;

 private:
  explicit Document(std::shared_ptr<DocumentState> state) : state_(std::move(state)) {}

  std::shared_ptr<DocumentState> state_;
};

}  // namespace scree::document
