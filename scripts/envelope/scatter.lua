-- scatter.lua: scatter of the strength, to 100 %.
--
-- Nodes have a strength of their own, with mean 1; the standard deviation follows from the distribution.
-- Expected: the mean over 4800 nodes within five standard errors; no strength below 0.
--
--   hackle run scripts/envelope/scatter.lua --set modulus=1
local parts = require "envelope.parts"
local o = options { modulus = 10, deviation = 0, correlation = 0, spread = 0.12, precision = "f64", seed = 1 }
local dx = 1*mm
local p = plate { width = 80*dx, height = 60*dx, material = parts.glass() }
if o.deviation ~= 0 then p:strength { distribution = "normal", deviation = o.deviation, correlation = o.correlation, seed = o.seed }
else p:strength { modulus = o.modulus, correlation = o.correlation, seed = o.seed } end
p:traction { edge = "top", stress = { 0, 30*MPa } }
p:traction { edge = "bottom", stress = { 0, -30*MPa } }
local s = simulate(p, { spacing = dx, precision = o.precision })
local strength = s:values "strength"
if o.correlation == 0 then parts.near("mean strength", strength:mean(), 1, 5*o.spread/math.sqrt(4800), "five standard errors") end
expect { "least strength", got = strength:min().value, min = 0, source = "a strength" }
s:step(150)
local sum = parts.sums(s, 80, 60)
parts.near("momentum over the sum of |v|", sum.py/sum.size, 0, 1e4*parts.rounding[o.precision], "the forces cancel")
