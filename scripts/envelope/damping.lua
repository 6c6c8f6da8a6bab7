-- damping.lua: damping rates from 0 to 1e12.
--
-- A flying plate under damping by rate slows down as exp(-rate t); damping of stretch leaves rigid motion alone.
-- Expected: v = v0 exp(-rate t) to rounding, which the step takes exactly; v0 under damping of stretch.
--
--   hackle run scripts/envelope/damping.lua --set rate=1e12
local parts = require "envelope.parts"
local o = options { rate = 0, stiffness = 0, precision = "f64", steps = 200 }
local dx, v0 = 1*mm, 1
local p = plate { width = 24*dx, height = 18*dx, material = parts.glass() }
p:initial { velocity = { v0, 0 } }
if o.rate ~= 0 or o.stiffness ~= 0 then p:damping { rate = o.rate, stiffness = o.stiffness } end
local s = simulate(p, { spacing = dx, precision = o.precision })
s:step(o.steps)
local sum = parts.sums(s, 24, 18)
parts.near("velocity", sum.px/(24*18), v0*math.exp(-o.rate*s.time), 1e3*parts.rounding[o.precision], "v0 exp(-rate t)", "m/s")
parts.near("largest velocity across", math.abs(sum.py), 0, 1e4*parts.rounding[o.precision], "nothing acts along y")
parts.near("broken bonds", s.damage.broken_bonds, 0, 0, "nothing is stretched")
