-- load.lua: loads with kinks, spikes, jumps, and functions that return no numbers.
--
-- A traction with an odd amplitude; what a function cannot be is refused, or stops the run where it occurs.
-- Expected: momentum = force times the integral of the amplitude, which leapfrog sums with the values of its steps.
--
--   hackle run scripts/envelope/load.lua --set amplitude=spike
local parts = require "envelope.parts"
local o = options { amplitude = "kink", precision = "f64", steps = 120, stress = 1*MPa }
local dx, nx, ny = 1*mm, 24, 18
local t1 = 10*us
local amplitudes = {
  constant = { 1 },
  kink = { { { 0, 0 }, { t1, 1 }, { 2*t1, -3 }, { 3*t1, 0 } } },
  spike = { { { 0, 0 }, { t1, 0 }, { t1 + 0.1*us, 1e3 }, { t1 + 0.2*us, 0 } } },
  giant_spike = { { { 0, 0 }, { t1, 0 }, { t1 + 1*us, 1e9 }, { t1 + 2*us, 0 } } },
  jump = { { { 0, 1 }, { t1, 1 }, { t1 + 1e-15, -1 }, { 4*t1, -1 } } },
  ramp = { ramp(t1) }, short_ramp = { ramp(1e-15) }, long_ramp = { ramp(1e6) },
  pulse = { pulse(t1) }, short_pulse = { pulse(1e-15) }, late = { step_at(1e9) }, step = { step_at(t1) },
  sine = { function(t) return math.sin(t/us) end }, fast_sine = { function(t) return math.sin(1e12*t) end },
  noise = { function(t) return parts.noise(math.floor(t*1e9)) end },
  huge = { function(t) return 1e30*t end }, tiny = { function(t) return 1e-300 end },
  nan = { function(t) return 0/0 end }, nan_later = { function(t) return t > t1 and 0/0 or 1 end },
  inf = { function(t) return 1/0 end }, inf_later = { function(t) return t > t1 and 1/0 or 1 end },
  text = { function(t) return "a" end }, nothing = { function(t) end }, nothing_later = { function(t) if t < t1 then return 1 end end },
  table = { function(t) return {} end }, error = { function(t) error "no load" end }, error_later = { function(t) if t > t1 then error "no load" end return 1 end },
  endless = { function(t) while t >= 0 do end end }, endless_later = { function(t) while t > t1 do end return 1 end },
  unordered = { { { 0, 1 }, { 2*t1, 1 }, { t1, 0 } } }, twice = { { { 0, 1 }, { t1, 1 }, { t1, 0 }, { 2*t1, 0 } } },
  empty = { {} }, nan_point = { { { 0, 1 }, { t1, 0/0 } } }, nan_time = { { { 0, 1 }, { 0/0, 1 } } },
}
local amplitude = amplitudes[o.amplitude][1]
local p = plate { width = nx*dx, height = ny*dx, material = parts.glass() }
p:traction { edge = "top", stress = { 0, o.stress }, time = amplitude }
local s = simulate(p, { spacing = dx, precision = o.precision })
s:step(o.steps)
local function at(t)
  if type(amplitude) == "function" then return amplitude(t) end
  if type(amplitude) == "number" then return amplitude end
end
local sum = parts.sums(s, nx, ny)
local scale = o.stress*nx*dx*s.dt/(2235*dx*dx)
if at(0) then
  local whole, largest = 0.5*at(0), math.abs(at(0))
  for k = 1, o.steps - 1 do whole, largest = whole + at(k*s.dt), math.max(largest, math.abs(at(k*s.dt))) end
  whole = whole + 0.5*at(o.steps*s.dt)
  -- What is below the least number of the precision in lattice units adds nothing.
  local least = ({ f64 = 1e-307, f32 = 1.2e-38 })[o.precision]*dx/s.dt
  parts.near("momentum along y", sum.py, whole*scale,
             10*o.steps*largest*scale*parts.rounding[o.precision] + o.steps*nx*ny*least, "sum of the forces of all steps")
end
parts.near("momentum along x over the sum of |v|", sum.px/(sum.size + 1e-300), 0, 1e4*parts.rounding[o.precision], "nothing acts along x")
