#include "document_file.hpp"
#include "document_message.hpp"
#include "document_parse.hpp"
#include "document_state.hpp"
#include "document_text.hpp"
#include "override.hpp"

#include <scree/document/document.hpp>
#include <scree/files/text.hpp>

namespace scree::document {

namespace {

constexpr std::size_t longest_name = 4096;

}  // namespace

const std::string& Document::outdone() const { return state_->outdone; }

Document Document::load(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                        std::string_view cure) {
  const std::string text = read_text_file(path, largest_file);
  Document document = parse(text, path.string(), overrides);
  if (!document.state_->root->children.empty()) return document;
  throw document.root().error("the file holds no key", cure);
}

Document Document::parse(std::string_view text, std::string_view name,
                         const std::vector<std::string>& overrides) {
  auto state = std::make_shared<DocumentState>();
  state->name = files::one_line(name, longest_name);
  state->overrides = overrides;
  state->root = parse_toml(text, state->name);
  for (std::size_t number = 0; number < overrides.size(); ++number) apply_override(*state, number);
  return Document(std::move(state));
}

Table Document::root() const { return {state_, state_->root.get()}; }

std::string Document::resolved_text() const { return toml_text(*state_->root); }

}  // namespace scree::document
