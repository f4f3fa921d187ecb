#pragma once

#include <array>
#include <cstddef>

namespace reference {

// The explicit Runge-Kutta method of order 8 by Dormand and Prince with error estimates of orders 5 and 3,
// "DOP853"; coefficients from Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, second
// edition.
namespace dormand_prince {

inline constexpr int stages = 12;
inline constexpr std::array<double, stages> nodes = {0,
                                                     0.0526001519587677318785587544488,
                                                     0.0789002279381515978178381316732,
                                                     0.118350341907227396726757197510,
                                                     0.281649658092772603273242802490,
                                                     1.0 / 3,
                                                     0.25,
                                                     4.0 / 13,
                                                     127.0 / 195,
                                                     0.6,
                                                     6.0 / 7,
                                                     1};
// clang-format off
inline constexpr double matrix[stages][stages - 1] = {
    {},
    {5.26001519587677318785587544488e-2},
    {1.97250569845378994544595329183e-2, 5.91751709536136983633785987549e-2},
    {2.95875854768068491816892993775e-2, 0, 8.87627564304205475450678981324e-2},
    {2.41365134159266685502369798665e-1, 0, -8.84549479328286085344864962717e-1, 9.24834003261792003115737966543e-1},
    {1.0 / 27, 0, 0, 1.70828608729473871279604482173e-1, 1.25467687566822425016691814123e-1},
    {3.7109375e-2, 0, 0, 1.70252211019544039314978060272e-1, 6.02165389804559606850219397283e-2, -1.7578125e-2},
    {3.70920001185047927108779319836e-2, 0, 0, 1.70383925712239993810214054705e-1, 1.07262030446373284651809199168e-1,
     -1.53194377486244017527936158236e-2, 8.27378916381402288758473766002e-3},
    {6.24110958716075717114429577812e-1, 0, 0, -3.36089262944694129406857109825, -8.68219346841726006818189891453e-1,
     27.5920996994467083049415600797, 20.1540675504778934086186788979, -43.4898841810699588477366255144},
    {4.77662536438264365890433908527e-1, 0, 0, -2.48811461997166764192642586468, -5.90290826836842996371446475743e-1,
     21.2300514481811942347288949897, 15.2792336328824235832596922938, -33.2882109689848629194453265587,
     -2.03312017085086261358222928593e-2},
    {-9.3714243008598732571704021658e-1, 0, 0, 5.18637242884406370830023853209, 1.09143734899672957818500254654,
     -8.14978701074692612513997267357, -18.5200656599969598641566180701, 22.7394870993505042818970056734,
     2.49360555267965238987089396762, -3.0467644718982195003823669022},
    {2.27331014751653820792359768449, 0, 0, -10.5344954667372501984066689879, -2.00087205822486249909675718444,
     -17.9589318631187989172765950534, 27.9488845294199600508499808837, -2.85899827713502369474065508674,
     -8.87285693353062954433549289258, 12.3605671757943030647266201528, 6.43392746015763530355970484046e-1}};
inline constexpr std::array<double, stages> weights = {
    5.42937341165687622380535766363e-2, 0, 0, 0, 0, 4.45031289275240888144113950566, 1.89151789931450038304281599044,
    -5.8012039600105847814672114227, 3.1116436695781989440891606237e-1, -1.52160949662516078556178806805e-1,
    2.01365400804030348374776537501e-1, 4.47106157277725905176885569043e-2};
inline constexpr std::array<double, stages> fifth_order_error = {
    0.01312004499419488073250102996, 0, 0, 0, 0, -1.225156446376204440720569753, -0.4957589496572501915214079952,
    1.664377182454986536961530415, -0.3503288487499736816886487290, 0.3341791187130174790297318841,
    0.08192320648511571246570742613, -0.02235530786388629525884427845};
// clang-format on
inline constexpr double third_order_first = 0.244094488188976377952755905512;
inline constexpr double third_order_ninth = 0.733846688281611857341361741547;
inline constexpr double third_order_last = 0.0220588235294117647058823529412;

}  // namespace dormand_prince

template <std::size_t Size>
struct RungeKuttaStep {
  using State = std::array<double, Size>;
  State end;
  State fifth_order_error, third_order_error;
};

// One step of the length `step` from `begin`, where rates(elapsed, state) is the derivative; `first` is that
// of the beginning.
template <std::size_t Size, class Rates>
RungeKuttaStep<Size> dormand_prince_step(const std::array<double, Size>& begin,
                                         const std::array<double, Size>& first, double step,
                                         const Rates& rates) {
  namespace dp = dormand_prince;
  std::array<std::array<double, Size>, dp::stages> k;
  k[0] = first;
  for (std::size_t stage = 1; stage < dp::stages; ++stage) {
    std::array<double, Size> sum{};
    for (std::size_t j = 0; j < stage; ++j)
      if (dp::matrix[stage][j] != 0)
        for (std::size_t i = 0; i < Size; ++i) sum[i] += dp::matrix[stage][j] * k[j][i];
    for (std::size_t i = 0; i < Size; ++i) sum[i] = begin[i] + step * sum[i];
    k[stage] = rates(dp::nodes[stage] * step, sum);
  }
  RungeKuttaStep<Size> result;
  for (std::size_t i = 0; i < Size; ++i) {
    double sum = 0, fifth = 0;
    for (std::size_t j = 0; j < dp::stages; ++j) {
      sum += dp::weights[j] * k[j][i];
      fifth += dp::fifth_order_error[j] * k[j][i];
    }
    result.end[i] = begin[i] + step * sum;
    result.fifth_order_error[i] = step * fifth;
    result.third_order_error[i] = step * (sum - dp::third_order_first * k[0][i] -
                                          dp::third_order_ninth * k[8][i] - dp::third_order_last * k[11][i]);
  }
  return result;
}

}  // namespace reference
