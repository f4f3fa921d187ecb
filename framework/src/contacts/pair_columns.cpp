#include "contacts/pair_columns.hpp"

#include <algorithm>
#include <bit>

#include <scree/state_transfer.hpp>

namespace scree {

namespace {

template <class T>
void transfer_rows(const StateTransfer& state, const std::string& name, const char* unit,
                   const std::vector<std::uint32_t>& rows, std::uint32_t width, const auto& column) {
  std::vector<T*> columns(width);
  for (std::uint32_t k = 0; k < width; ++k) columns[k] = column(k);
  std::vector<T> packed(rows.size() * width);
  if (!state.restoring())
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::uint32_t k = 0; k < width; ++k) packed[r * width + k] = columns[k][rows[r]];
  state.moved_rows(name, unit, packed, width, stored::any);
  if (!state.restoring()) return;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::uint32_t k = 0; k < width; ++k) columns[k][rows[r]] = packed[r * width + k];
}

}  // namespace

void PairColumns::transfer(const StateTransfer& state, const std::string& name, const char* unit,
                           const std::vector<std::uint32_t>& rows) {
  if (precision_ == Precision::double_precision)
    transfer_rows<double>(state, name, unit, rows, width(),
                          [this](std::uint32_t k) { return column<double>(k); });
  else
    transfer_rows<float>(state, name, unit, rows, width(),
                         [this](std::uint32_t k) { return column<float>(k); });
}

bool PairColumns::is_used(std::size_t row) const {
  for (std::uint32_t k = 0; k < width(); ++k) {
    const std::size_t i = k * rows_ + row;
    if (precision_ == Precision::double_precision ? std::bit_cast<std::uint64_t>(full_[i]) != 0
                                                  : std::bit_cast<std::uint32_t>(single_[i]) != 0)
      return true;
  }
  return false;
}

}  // namespace scree
