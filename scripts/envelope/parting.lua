-- parting.lua: halves that fly apart or into each other, up to and above the speed of waves.
--
-- The left half flies to the left and the right half to the right, or the other way about; share is over the wave speed.
-- Expected: no momentum arises; 150 roundings of every v.
--
--   hackle run scripts/envelope/parting.lua --set share=-1 --set contact=true
local parts = require "envelope.parts"
local o = options { share = 0.1, precision = "f64", contact = false, safety = 0.9 }
local dx, nx, ny = 1*mm, 60, 30
local p = plate { width = nx*dx, height = ny*dx, material = parts.glass() }
p:initial { velocity = function(x, y) return x > 30*mm and o.share*5686 or -o.share*5686, 0 end }
if o.contact then p:contact {} end
local s = simulate(p, { spacing = dx, precision = o.precision, safety = o.safety })
s:step(150)
local sum = parts.sums(s, nx, ny)
parts.near("momentum over the sum of |v|", math.sqrt(sum.px^2 + sum.py^2)/sum.size, 0, 600*parts.rounding[o.precision], "no force from outside")
if math.abs(o.share) >= 0.01 then expect { "broken bonds", got = s.damage.broken_bonds, min = 1, source = "ten times the strength" } end
