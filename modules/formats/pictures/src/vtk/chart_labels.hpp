#pragma once

#include "chart_layout.hpp"

#include <vtkContextItem.h>

namespace scree::pictures {

// Text of a chart: title, axis labels, legend.
class ChartLabels : public vtkContextItem {
 public:
  static ChartLabels* New();
  vtkTypeMacro(ChartLabels, vtkContextItem)

      bool Paint(vtkContext2D* painter) override;

  const ChartSpec* spec = nullptr;
  const ChartLayout* layout = nullptr;

 private:
  void paint_legend(vtkContext2D* painter, const Box& box) const;
  void paint_legend_row(vtkContext2D* painter, const Box& box, std::size_t row) const;
};

}  // namespace scree::pictures
