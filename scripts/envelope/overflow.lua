-- overflow.lua: numbers near the ends of single and double precision.
--
-- Each quantity in turn is far from that of any plate.
-- Expected: numbers everywhere, a refusal, or a stop that names cause, time and place.
--
--   hackle run scripts/envelope/overflow.lua --set precision=f32 --set E=1e30
local parts = require "envelope.parts"
local o = options { precision = "f32", E = 65e9, rho = 2235, G0 = 200, dx = 1*mm, stress = 1*MPa, v = 0, u = 0, alphaT = 0, change = 0, alpha = 0 }
local dx, nx, ny = o.dx, 24, 18
local p = plate { width = nx*dx, height = ny*dx, material = parts.glass { E = o.E, rho = o.rho, G0 = o.G0, alphaT = o.alphaT, alpha = o.alpha } }
p:crack { from = { 0, 9*dx }, to = { 8*dx, 9*dx } }
p:traction { edge = "top", stress = { 0, o.stress } }
p:traction { edge = "bottom", stress = { 0, -o.stress } }
if o.v ~= 0 then p:initial { velocity = function(x, y) return o.v*(x/(nx*dx) - 0.5), 0 end } end
if o.u ~= 0 then p:initial { displacement = function(x, y) return o.u*(x/(nx*dx) - 0.5), 0 end } end
if o.change ~= 0 then p:temperature { change = o.change } end
local s = simulate(p, { spacing = dx, precision = o.precision })
s:step(130)
local sum = parts.sums(s, nx, ny)
expect { "|v| of all nodes", got = sum.size, min = 0, max = 1e308, unit = "m/s", source = "a number" }
expect { "largest displacement", got = sum.far, min = 0, max = 1e308, unit = "m", source = "a number" }
