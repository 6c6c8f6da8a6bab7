-- shatter.lua: everything breaks in one step.
--
-- A plate of twice its size at the start has no bond left after a step; every node then flies by itself.
-- Expected: all bonds broken; u = u0 + v t for every node.
--
--   hackle run scripts/envelope/shatter.lua --set m=16
local parts = require "envelope.parts"
local o = options { m = 4, precision = "f64", growth = 1, alpha = 0, contact = false, steps = 100 }
local dx, nx, ny = 1*mm, 40, 30
local function v(x, y) return 100*math.sin(x/dx), 100*math.cos(y/dx) end
local p = plate { width = nx*dx, height = ny*dx, material = parts.glass { alpha = o.alpha } }
p:initial { displacement = function(x, y) return o.growth*x, o.growth*y end, velocity = v }
if o.contact then p:contact {} end
local s = simulate(p, { spacing = dx, horizon = o.m*dx, precision = o.precision })
s:step(o.steps)
local worst = 0
parts.each(s, nx, ny, function(node, x, y)
  local vx, vy = v(x, y)
  worst = math.max(worst, math.abs(node.ux - o.growth*x - vx*s.time), math.abs(node.uy - o.growth*y - vy*s.time))
end)
parts.near("broken bonds", s.damage.broken_bonds, s.bonds, 0, "all are stretched beyond s0")
if not o.contact then parts.near("largest error of u in spacings", worst/dx, 0, 100*o.steps*parts.rounding[o.precision]*(1 + o.growth), "u0 + v t") end
