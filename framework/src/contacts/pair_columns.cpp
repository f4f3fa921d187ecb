#include "contacts/pair_columns.hpp"

#include <bit>

#include <scree/state_transfer.hpp>

namespace scree {

void PairColumns::transfer(const StateTransfer& state, const std::string& name, const char* unit,
                           const std::vector<std::uint32_t>& rows) {
  std::vector<double> packed(rows.size() * width());
  if (!state.restoring())
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::uint32_t k = 0; k < width(); ++k) packed[r * width() + k] = column(k)[rows[r]];
  state.moved_rows(name, unit, packed, width(), stored::any);
  if (!state.restoring()) return;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::uint32_t k = 0; k < width(); ++k) column(k)[rows[r]] = packed[r * width() + k];
}

bool PairColumns::is_used(std::size_t row) const {
  for (std::uint32_t k = 0; k < width(); ++k)
    if (std::bit_cast<std::uint64_t>(column(k)[row]) != 0) return true;
  return false;
}

}  // namespace scree
