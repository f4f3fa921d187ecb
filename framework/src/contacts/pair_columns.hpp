#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <scree/column.hpp>

namespace scree {

// Columns of numbers per pair, such as histories.
class PairColumns {
 public:
  // Changes the size; values are undefined afterwards.
  void resize(std::uint32_t width, std::size_t rows) {
    rows_ = rows;
    resize_with_room(numbers_, width * rows);
  }
  // Changes the size and sets all values to 0.
  void reset(std::uint32_t width, std::size_t rows) {
    resize(width, rows);
    clear(0, rows);
  }
  // Sets the rows [begin, end) to 0.
  void clear(std::size_t begin, std::size_t end) {
    for (std::uint32_t k = 0; k < width(); ++k) std::fill(column(k) + begin, column(k) + end, 0.0);
  }

  // Number of values in all columns together.
  std::size_t size() const { return numbers_.size(); }
  std::uint32_t width() const { return rows_ ? std::uint32_t(size() / rows_) : 0; }

  double* column(std::uint32_t k) { return numbers_.data() + k * rows_; }
  const double* column(std::uint32_t k) const { return numbers_.data() + k * rows_; }

  // Copies rows from other columns; columns that only one of them has are skipped.
  struct Move {
    std::uint32_t from, to;
  };
  void take(const PairColumns& other, const std::vector<Move>& rows) {
    for (std::uint32_t k = 0; k < std::min(width(), other.width()); ++k)
      for (const Move& row : rows) column(k)[row.to] = other.column(k)[row.from];
  }

  // The listed rows, with the width that the columns have.
  void transfer(const class StateTransfer& state, const std::string& name, const char* unit,
                const std::vector<std::uint32_t>& rows);
  // Whether any bit of a row is set.
  bool is_used(std::size_t row) const;

 private:
  std::size_t rows_ = 0;
  Column<double> numbers_;
};

}  // namespace scree
