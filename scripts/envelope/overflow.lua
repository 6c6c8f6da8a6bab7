-- overflow.lua: numbers near the ends of single and double precision.
--
-- Each quantity in turn is far from that of any plate.
-- Expected: opposite loads leave no momentum, mirror images are alike to the last bit, and tiny loads move in proportion; else a
-- refusal, or a stop that names cause, time and place.
--
--   hackle run scripts/envelope/overflow.lua --set precision=f32 --set E=1e30
local parts = require "envelope.parts"
local o = options { precision = "f32", E = 65e9, rho = 2235, G0 = 200, dx = 1*mm, stress = 1*MPa, v = 0, u = 0, alphaT = 0, change = 0, alpha = 0 }
local dx, nx, ny = o.dx, 24, 18
local function solved(stress)
  local p = plate { width = nx*dx, height = ny*dx, material = parts.glass { E = o.E, rho = o.rho, G0 = o.G0, alphaT = o.alphaT, alpha = o.alpha } }
  p:crack { from = { 0, 9*dx }, to = { 8*dx, 9*dx } }
  p:traction { edge = "top", stress = { 0, stress } }
  p:traction { edge = "bottom", stress = { 0, -stress } }
  if o.v ~= 0 then p:initial { velocity = function(x, y) return o.v*(x/(nx*dx) - 0.5), 0 end } end
  if o.u ~= 0 then p:initial { displacement = function(x, y) return o.u*(x/(nx*dx) - 0.5), 0 end } end
  if o.change ~= 0 then p:temperature { change = o.change } end
  local s = simulate(p, { spacing = dx, precision = o.precision })
  s:step(130)
  return s
end
local s = solved(o.stress)
local sum = parts.sums(s, nx, ny)
local rounding = parts.rounding[o.precision]
expect { "|v| of all nodes", got = sum.size, min = 0, max = 1e308, unit = "m/s", source = "a number" }
expect { "largest displacement", got = sum.far, min = 0, max = 1e308, unit = "m", source = "a number" }
parts.near("momentum over the sum of |v|", math.sqrt(sum.px^2 + sum.py^2)/(sum.size + 1e-300), 0, 1e5*rounding, "opposite loads")
parts.near("difference of mirror images", parts.asymmetry(s, nx, ny), 0, 0, "a symmetric scene")
if o.stress < 1e-20 and o.v == 0 and o.u == 0 and o.change == 0 then
  -- In lattice units a displacement below the least normal number is rounded, or nothing.
  local twin = parts.sums(solved(1), nx, ny).far*o.stress
  local least = ({ f64 = 2.3e-308, f32 = 1.2e-38 })[o.precision]*dx
  parts.near("largest displacement over that of 1 Pa", sum.far, twin, 1e-3*twin + 1e3*least, "linear: strains of 1e-11")
end
