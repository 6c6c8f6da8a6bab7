-- ringing.lua: a plate that rings for up to 1e7 steps.
--
-- A small plate swings in a smooth shape; nothing takes energy.
-- Expected: the mean energy moves by less than the swing of leapfrog, (omega dt)^2/16 for waves of the mean frequency, and a
-- rounding of each step, either way.
--
--   hackle run scripts/envelope/ringing.lua --set steps=1000000 --set precision=f32
local parts = require "envelope.parts"
local o = options { steps = 10000, precision = "f64", n = 6, share = 0.2, m = 2 }
local dx = 1*mm
local p = plate { width = o.n*dx, height = o.n*dx, material = parts.glass { s0 = 0.5 } }
p:initial { displacement = function(x, y) return 1e-6*math.sin(2*x/(o.n*dx)), 1e-6*math.cos(3*y/(o.n*dx)) end }
local numerics = { spacing = dx, horizon = o.m*dx, precision = o.precision }
numerics.step = o.share*simulate(p, numerics).dt_limit
local s = simulate(p, numerics)
-- Returns the mean energy of 200 moments of the following 1000 steps.
local function mean()
  local sum = 0
  for _ = 1, 200 do
    s:step(5)
    sum = sum + (s.energy.kinetic + s.energy.strain)/200
  end
  return sum
end
local start = mean()
s:step(o.steps - 2000)
local drift = mean()/start - 1
print(string.format("drift of the energy in %d steps, %s: %.2e", o.steps, o.precision, drift))
parts.near("drift of the energy", drift, 0, 0.25*o.share^2 + 10*math.sqrt(o.steps)*parts.rounding[o.precision],
           "leapfrog's swing, and a rounding of each step, either way")
local sum = parts.sums(s, o.n, o.n)
parts.near("momentum over the sum of |v|", math.sqrt(sum.px^2 + sum.py^2)/sum.size, 0, 10*math.sqrt(o.steps)*parts.rounding[o.precision], "no force from outside")
