// Confidence is fitted so that it means what it says.
#include "components/goalnet/training/calibration.h"

#include <gtest/gtest.h>

#include <cmath>

namespace goalnet::inference::training {
namespace {

TEST(Calibration, FindsTheCurveBehindTheSamples) {
  const network::Calibration truth{4, 1.5};
  std::vector<CalibrationSample> samples;
  for (int i = 0; i < 200; ++i) {
    const double x = -i / 100.0;
    const int right = static_cast<int>(std::lround(100 * truth(x)));
    for (int k = 0; k < 100; ++k) samples.push_back({x, k < right});
  }
  const network::Calibration fit = fit_calibration(samples);
  EXPECT_NEAR(fit.slope, truth.slope, 0.1);
  EXPECT_NEAR(fit.offset, truth.offset, 0.1);
}

TEST(Calibration, FewOrOneSidedSamplesDoNotRunAway) {
  EXPECT_DOUBLE_EQ(fit_calibration({}).offset, 3);
  const network::Calibration fit = fit_calibration({{-0.1, true}, {-0.2, true}, {-3, true}});
  EXPECT_TRUE(std::isfinite(fit.slope));
  EXPECT_GT(fit(-0.1), 0.5);
  EXPECT_LT(std::abs(fit.offset), 50);
}

}  // namespace
}  // namespace goalnet::inference::training
