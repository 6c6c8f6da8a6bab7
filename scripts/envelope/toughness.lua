-- toughness.lua: fracture energies from 1e-12 to 1e12 J/m2.
--
-- A plate is stretched by 1e-3 at the start: all bonds have this stretch.
-- Expected: all of them break at once if their critical stretch is smaller, none if it is larger.
--
--   hackle run scripts/envelope/toughness.lua --set G0=1e-12
local parts = require "envelope.parts"
local o = options { G0 = 200, precision = "f64", strain = 1e-3 }
local dx = 1*mm
local p = plate { width = 24*dx, height = 18*dx, material = parts.glass { G0 = o.G0 } }
p:initial { displacement = function(x, y) return o.strain*x, o.strain*y end }
local s = simulate(p, { spacing = dx, precision = o.precision })
s:step(1)
parts.near("broken bonds", s.damage.broken_bonds, s.s0 < o.strain and s.bonds or 0, 0, "stretch over critical stretch")
s:step(200)
local sum = parts.sums(s, 24, 18)
parts.near("momentum over the sum of |v|", math.sqrt(sum.px^2 + sum.py^2)/(sum.size + 1e-300), 0, 1e3*parts.rounding[o.precision],
           "no force from outside")
