// SPDX-License-Identifier: MIT
// What a combination of choices will cost and gain, from the runs that varied one choice each:
// those that cannot be on the front need not be run.
#pragma once

#include <vector>

#include "study/trade_axes.hpp"
#include "study/trade_run.hpp"

namespace hackle {

struct TradeForecast {
  double cost = 0.0;   // s of CPU time: shares of the axes multiply
  double error = 0.0;  // at best: likewise, choices that err more count as if they did not
};

// Returns the forecast for settings that join values of `axes`. The first of the runs is the scene
// as written. A choice whose run did not finish makes both infinite.
TradeForecast forecast_of(const Settings& settings, const std::vector<TradeAxis>& axes,
                          const std::vector<TradeRun>& runs);

// Returns whether it costs more than `most`, s, or a run that is clearly cheaper errs no more than
// the forecast at its best. Runs that change the model do not count.
bool is_hopeless(const TradeForecast& forecast, const std::vector<TradeAxis>& axes,
                 const std::vector<TradeRun>& runs, double most);

// Returns the value of each axis apart from the lattice that errs clearly least.
Settings surest(const std::vector<TradeAxis>& axes, const std::vector<TradeRun>& runs);

// Returns the cheapest value of each axis that only changes the arithmetic, if it does little harm.
Settings fast_arithmetic(const std::vector<TradeAxis>& axes, const std::vector<TradeRun>& runs);

// Returns whether settings are of an axis that changes the model.
bool is_of_model(const Settings& settings, const std::vector<TradeAxis>& axes);

}  // namespace hackle
