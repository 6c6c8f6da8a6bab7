-- step.lua: steps from a fifth of the limit to beyond it.
--
-- Random velocities in a plate that cannot break. Below the limit the energy of leapfrog swings by at most 1/(1 - share^2), above
-- it grows until the run is stopped.
-- Expected: the energy stays within that factor; above the limit a stop that names step, time and place.
--
--   hackle run scripts/envelope/step.lua --set share=0.95 --set m=8
local parts = require "envelope.parts"
local o = options { share = 0.9, m = 4, precision = "f64", steps = 400, force = true }
local dx = 1*mm
local n = math.max(24, math.ceil(5*o.m))
local p = plate { width = n*dx, height = n*dx, material = parts.glass { s0 = 0.5 } }
p:initial { velocity = function(x, y)
  local k = (x/dx)//1 + n*((y/dx)//1)
  return 1e-3*parts.noise(2*k), 1e-3*parts.noise(2*k + 1)
end }
local numerics = { spacing = dx, horizon = o.m*dx, precision = o.precision, force_step = o.force }
numerics.step = o.share*simulate(p, numerics).dt_limit
local s = simulate(p, numerics)
local start = s.energy.kinetic
local least, most = start, start
for _ = 1, 10 do
  s:step(o.steps//10)
  local now = s.energy.kinetic + s.energy.strain
  least, most = math.min(least, now), math.max(most, now)
end
if o.share < 1 then
  local swing = 1.01/(1 - o.share^2)
  expect { "energy over that at the start", got = most/start, max = swing, source = "leapfrog: 1/(1 - share^2)" }
  expect { "least energy over that at the start", got = least/start, min = 1/swing, source = "the same" }
else
  expect { "energy over that at the start", got = most/start, min = 0, max = 1e300, source = "a number, if it is not stopped" }
end
