#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <scree/column.hpp>
#include <scree/precision.hpp>

namespace scree {

// Columns of numbers per pair, such as histories: of double or, in mixed precision, of float.
class PairColumns {
 public:
  explicit PairColumns(Precision precision = Precision::double_precision) : precision_(precision) {}

  // Changes the size; values are undefined afterwards.
  void resize(std::uint32_t width, std::size_t rows) {
    rows_ = rows;
    if (precision_ == Precision::double_precision)
      resize_with_room(full_, width * rows);
    else
      resize_with_room(single_, width * rows);
  }
  // Changes the size and sets all values to 0.
  void reset(std::uint32_t width, std::size_t rows) {
    resize(width, rows);
    std::fill(full_.begin(), full_.end(), 0.0);
    std::fill(single_.begin(), single_.end(), 0.0f);
  }

  Precision precision() const { return precision_; }
  // Number of values in all columns together.
  std::size_t size() const {
    return precision_ == Precision::double_precision ? full_.size() : single_.size();
  }
  std::uint32_t width() const { return rows_ ? std::uint32_t(size() / rows_) : 0; }
  std::size_t bytes_per_number() const {
    return precision_ == Precision::double_precision ? sizeof(double) : sizeof(float);
  }

  // T must match the precision: double or float.
  template <class T>
  T* column(std::uint32_t k) {
    if constexpr (std::is_same_v<T, double>)
      return full_.data() + k * rows_;
    else
      return single_.data() + k * rows_;
  }
  template <class T>
  const T* column(std::uint32_t k) const {
    return const_cast<PairColumns*>(this)->column<T>(k);
  }
  double value(std::uint32_t k, std::size_t row) const {
    const std::size_t i = k * rows_ + row;
    return precision_ == Precision::double_precision ? full_[i] : double(single_[i]);
  }
  // Copies rows from other columns of the same precision; columns that only one of them has are skipped.
  struct Move {
    std::uint32_t from, to;
  };
  void take(const PairColumns& other, const std::vector<Move>& rows) {
    const auto take_of = [&]<class T>(const T*) {
      for (std::uint32_t k = 0; k < std::min(width(), other.width()); ++k)
        for (const Move& row : rows) column<T>(k)[row.to] = other.column<T>(k)[row.from];
    };
    if (precision_ == Precision::double_precision)
      take_of(full_.data());
    else
      take_of(single_.data());
  }
  // Sets a value, rounded to the precision.
  void set(std::uint32_t k, std::size_t row, double number) {
    const std::size_t i = k * rows_ + row;
    if (precision_ == Precision::double_precision)
      full_[i] = number;
    else
      single_[i] = float(number);
  }

  // The listed rows, with the width that the columns have.
  void transfer(const class StateTransfer& state, const std::string& name, const char* unit,
                const std::vector<std::uint32_t>& rows);
  // Whether any bit of a row is set.
  bool is_used(std::size_t row) const;

 private:
  Precision precision_;
  std::size_t rows_ = 0;
  Column<double> full_;
  Column<float> single_;
};

}  // namespace scree
