#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <scree/document/table.hpp>
#include <scree/scenario/keys.hpp>

namespace scree::scenario {

using document::Range;

// A key of a table: its name for the readers, and the range of its value. Keys are declared once, in the
// headers *_keys.hpp or, of a study, beside the reader of its table, and read with the functions below.
struct Key {
  std::string name;
  document::Range range = document::Range::any();
  operator std::string_view() const { return name; }
};

// With a fallback the key may be absent.
template <class T>
struct TypedKey : Key {
  std::optional<T> fallback;
};
using NumberKey = TypedKey<double>;
using IntegerKey = TypedKey<std::int64_t>;
using BooleanKey = TypedKey<bool>;
using StringKey = TypedKey<std::string>;
struct ChoiceKey : StringKey {
  std::vector<std::string> words;
};

// The value or the fallback. Throw Error if the key is absent and has none, or the value is out of range.
double read(const document::Table& table, const NumberKey& key);
std::int64_t read(const document::Table& table, const IntegerKey& key);
bool read(const document::Table& table, const BooleanKey& key);
std::string read(const document::Table& table, const StringKey& key);
std::string read(const document::Table& table, const ChoiceKey& key);
std::optional<double> read_optional(const document::Table& table, const NumberKey& key);

// The keys of one table. A derived class has a member for each, in the order of the documentation.
class TableKeys {
 public:
  const TableDescription& description() const { return description_; }

 protected:
  TableKeys(std::string name, std::string header, std::string doc)
      : description_{std::move(name), std::move(header), std::move(doc), {}} {}

  // `absent` describes what holds without the key where that is no fixed fallback.
  NumberKey number(std::string name, document::Range range, std::string doc, std::string absent = "required");
  NumberKey number(std::string name, document::Range range, double fallback, std::string doc);
  IntegerKey integer(std::string name, document::Range range, std::string doc,
                     std::string absent = "required");
  IntegerKey integer(std::string name, document::Range range, std::int64_t fallback, std::string doc);
  BooleanKey boolean(std::string name, bool fallback, std::string doc);
  StringKey string(std::string name, std::string doc, std::string absent = "required");
  StringKey string(std::string name, std::string fallback, std::string doc, std::string absent);
  ChoiceKey choice(std::string name, std::vector<std::string> words, std::string doc,
                   std::string absent = "required");
  // The first word is the fallback.
  ChoiceKey choice_or_first(std::string name, std::vector<std::string> words, std::string doc);
  // Of another form, such as "[x, y, z]" or "table"; the range holds for each number.
  Key other(std::string name, std::string form, document::Range range, std::string absent, std::string doc);

 private:
  void describe(const Key& key, const std::string& form, std::string absent, std::string doc);
  TableDescription description_;
};

}  // namespace scree::scenario
