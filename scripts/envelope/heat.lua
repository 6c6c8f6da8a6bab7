-- heat.lua: temperature changes from -1e4 to 1e4 K.
--
-- A free plate is heated alike everywhere; way = "rest" looks for its equilibrium, "at once" runs, "ramp" heats it slowly.
-- Expected: at rest its strain is alphaT times the change, to first order, as e = 2 alphaT change has it; in motion no momentum arises.
--
--   hackle run scripts/envelope/heat.lua --set change=-1e4
local parts = require "envelope.parts"
local o = options { change = 100, alphaT = 3e-6, way = "rest", precision = "f64", s0 = 0.5, steps = 200 }
local dx, nx, ny = 1*mm, 24, 18
local p = plate { width = nx*dx, height = ny*dx, material = parts.glass { alphaT = o.alphaT, s0 = o.s0 } }
p:temperature { change = o.change, time = o.way == "ramp" and ramp(20*us) or nil }
local s = simulate(p, { spacing = dx, precision = o.precision })
if o.way == "rest" then
  s:relax()
  local a, b = s:at { 0.5*dx, 0.5*dx }, s:at { (nx - 0.5)*dx, 0.5*dx }
  parts.near("strain at rest", (b.ux - a.ux)/((nx - 1)*dx), math.sqrt(1 + 2*o.alphaT*o.change) - 1,
             1e-6*math.abs(o.alphaT*o.change) + 1e-15, "(1 + strain)^2 = 1 + 2 alphaT change")
else
  s:step(o.steps)
  local sum = parts.sums(s, nx, ny)
  parts.near("momentum over the sum of |v|", math.sqrt(sum.px^2 + sum.py^2)/(sum.size + 1e-300), 0, 1e4*parts.rounding[o.precision], "no force from outside")
end
