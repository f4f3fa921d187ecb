#pragma once

#include "motion/integrator.hpp"

namespace scree {

// Gear's predictor-corrector with a Taylor series of five terms r_k = h^k/k! x^(k), for velocity-dependent
// forces; C. W. Gear, "Numerical Initial Value Problems in Ordinary Differential Equations" (1971),
// coefficients as in Allen & Tildesley, "Computer Simulation of Liquids" (1987), appendix E:
//   begin_step:  r_k <- Σ_j≥k binomial(j, k) r_j
//   finish_step: r_k += c_k (h²/2 F/m − r_2), c = 19/90, 3/4, 1, 1/2, 1/12
class PredictorCorrector : public Integrator {
 public:
  void prepare(Particles& particles, double step, std::span<const BodyRange> bodies) override;
  double begin_step(Particles& particles, double step, BodyRange bodies) override;
  bool finish_step(Particles& particles, double step, BodyRange bodies) override;
  void restart() override {
    for (auto* column : {&second_, &third_, &fourth_}) column->clear();
  }
  void add_to_hash(StateHash& hash, const BodyOrder& order) const override;
  void transfer(const StateTransfer& state, const BodyOrder& order) override;
  void send(Ranks& ranks, const RowRoutes& routes, std::size_t bodies) override;
  void rearrange(const std::vector<std::uint32_t>& from, std::span<const BodyRange> kept) override;

 private:
  // r_2, r_3, r_4 of each motion, four numbers each.
  BodyColumn<double> second_, third_, fourth_;
};

}  // namespace scree
