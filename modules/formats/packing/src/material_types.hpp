#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <scree/files/text_reader.hpp>
#include <scree/packing/packing.hpp>

namespace scree::packing {

// Maximum type number in a data file: LAMMPS and LIGGGHTS allocate tables of its square.
inline constexpr std::int64_t max_type = 10'000;

// Material of a type number: its name in the list, or the number as text if the list is empty.
std::string material_of_type(const files::Token& type, const std::vector<std::string>& materials,
                             const files::TextReader& reader);

// The same of a number that counts from 0, such as a species of MercuryDPM or a material of YADE. what: its
// name.
std::string material_of_number(const files::Token& number, std::string_view what,
                               const std::vector<std::string>& materials, const files::TextReader& reader);

// Type numbers for the materials of a packing; see ExportOptions::materials for the rule.
class MaterialTypes {
 public:
  // Throws Error if `materials` is not empty and lacks the material of a body.
  MaterialTypes(const Packing& packing, const std::vector<std::string>& materials);
  std::int64_t type(const Body& body) const { return type_of_.at(body.material); }
  std::int64_t count() const { return count_; }

 private:
  std::unordered_map<std::string, std::int64_t> type_of_;
  std::int64_t count_ = 1;
};

}  // namespace scree::packing
