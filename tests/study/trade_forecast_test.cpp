// SPDX-License-Identifier: MIT
// Forecasts of combinations, from runs whose costs and errors are made up.
#include "study/trade_forecast.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace hackle {
namespace {

const Settings f32{{"simulate.precision", "f32"}}, ramp{{"simulate.quadrature", "ramp"}},
    area{{"simulate.quadrature", "area"}},
    fine{{"simulate.spacing", "1"}, {"simulate.horizon", "4"}}, tough{{"material.alpha", "0.02"}};

const std::vector<TradeAxis> forecast_axes{
    {.name = "precision", .values = {f32}, .exact_by_itself = true},
    {.name = "quadrature", .values = {ramp, area}},
    {.name = "spacing", .values = {fine}, .of_lattice = true},
    {.name = "history", .values = {tough}, .of_model = true}};

TradeRun told(const Settings& settings, double cpu, double error, bool finished = true) {
  TradeRun run{.settings = settings, .outcome = {}, .errors = {}, .error = error};
  run.outcome.cpu = cpu;
  run.outcome.state = finished ? CaseState::finished : CaseState::failed;
  return run;
}

const std::vector<TradeRun> varied{told({}, 2.0, 1.0),    told(f32, 1.0, 1.05),
                                   told(ramp, 2.2, 0.5),  told(area, 3.0, 2.0, false),
                                   told(fine, 16.0, 0.8), told(tough, 0.1, 0.1)};

TEST(TradeForecast, MultipliesSharesOfCostAndOfWhatIsGained) {
  const TradeForecast both = forecast_of(joined(f32, ramp), forecast_axes, varied);
  EXPECT_DOUBLE_EQ(both.cost, 2.0 * 0.5 * 1.1);
  EXPECT_DOUBLE_EQ(both.error, 0.5) << "what f32 loses may be made good by the other";
  const TradeForecast three = forecast_of(joined(joined(f32, ramp), fine), forecast_axes, varied);
  EXPECT_DOUBLE_EQ(three.cost, 2.0 * 0.5 * 1.1 * 8.0);
  EXPECT_DOUBLE_EQ(three.error, 0.5 * 0.8);
  EXPECT_TRUE(std::isinf(forecast_of(joined(f32, area), forecast_axes, varied).cost));
}

TEST(TradeForecast, LeavesOutWhatCostsTooMuchOrIsBeaten) {
  const auto hopeless = [](const TradeForecast& forecast) {
    return is_hopeless(forecast, forecast_axes, varied, 8.0);
  };
  EXPECT_TRUE(hopeless({9.0, 0.0})) << "above what may be spent";
  EXPECT_TRUE(hopeless({4.0, 0.6})) << "ramp errs less for half of that";
  EXPECT_FALSE(hopeless({4.0, 0.4}));
  EXPECT_FALSE(hopeless({2.3, 0.5})) << "ramp is not clearly cheaper";
  EXPECT_FALSE(hopeless({0.9, 0.9})) << "another model, however cheap, beats nothing";
}

TEST(TradeForecast, TakesTheSurestAndTheFastestOfEachAxis) {
  EXPECT_EQ(surest(forecast_axes, varied), ramp);
  EXPECT_EQ(fast_arithmetic(forecast_axes, varied), f32);
}

}  // namespace
}  // namespace hackle
