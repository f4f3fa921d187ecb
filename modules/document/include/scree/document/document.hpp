#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <scree/document/table.hpp>

namespace scree::document {

struct DocumentState;

// A scene as text: a TOML file with the "key=value" overrides of the command line applied in order.
// The path of an override is dotted. An entry of an array of tables goes by index (stage[1].duration=2) or by
// its name, plugin or type (stage.cycle.duration=5); neither is needed where there is only one entry. The
// value is TOML; a bare word is a string.
class Document {
 public:
  // Largest file that is read (bytes); particles belong in a packing file, not in a scene.
  static constexpr std::size_t largest_file = 16u << 20;

  // Throws Error (bad_input) when the file cannot be read, is no TOML, holds no key, or an override cannot be
  // applied.
  // cure tells what to write into an empty file.
  static Document load(const std::filesystem::path& path, const std::vector<std::string>& overrides = {},
                       std::string_view cure = "write a scene: [scene], [time], [particles], ...");
  // name stands for the file in messages.
  static Document parse(std::string_view text, std::string_view name,
                        const std::vector<std::string>& overrides = {});

  Table root() const;
  // Throws for the first key in file order that no reader has asked for; those of overrides come last.
  void refuse_unused() const { root().refuse_unused(); }
  // TOML with the overrides in, keys in file order, numbers that read back to the same bits; no comments.
  std::string resolved_text() const;
  // "--set a=1 is undone by --set b=2" if they are two names for the same, or one holds the other; else
  // empty.
  const std::string& conflict() const;

 private:
  explicit Document(std::shared_ptr<DocumentState> state) : state_(std::move(state)) {}

  std::shared_ptr<DocumentState> state_;
};

}  // namespace scree::document
