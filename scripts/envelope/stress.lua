-- stress.lua: loads from 1e-12 to 1e6 of the strength.
--
-- A traction on one edge for 150 steps; the plate bends, breaks or turns to dust.
-- Expected: momentum = force times time, whatever breaks. Far below the strength the answer is linear:
-- it differs from that to a trillionth by a few strains and rounding.
--
--   hackle run scripts/envelope/stress.lua --set load=1e-12
local parts = require "envelope.parts"
local o = options { load = 0.1, precision = "f64", alpha = 0 }
local dx, nx, ny, strength, steps = 1*mm, 40, 30, 65e9*1e-3, 150
local function pulled(load)
  local p = plate { width = nx*dx, height = ny*dx, material = parts.glass { alpha = o.alpha } }
  p:traction { edge = "top", stress = { 0.2*load*strength, load*strength } }
  local s = simulate(p, { spacing = dx, precision = o.precision })
  s:step(steps)
  return s
end
local s = pulled(o.load)
local sum = parts.sums(s, nx, ny)
local impulse = o.load*strength*nx*dx*steps*s.dt/(2235*dx*dx)
parts.near("momentum along y over force times time", sum.py/impulse, 1, 1e3*parts.rounding[o.precision], "Newton")
parts.near("momentum along x over that along y", sum.px/sum.py, 0.2, 1e4*parts.rounding[o.precision], "Newton")
if o.load <= 1e-3 then
  local least, worst, largest = pulled(1e-9), 0, 0
  parts.each(s, nx, ny, function(a, x, y)
    local b = least:at { x, y }
    largest = math.max(largest, math.abs(a.uy/o.load))
    worst = math.max(worst, math.abs(a.uy/o.load - b.uy/1e-9))
  end)
  parts.near("broken bonds", s.damage.broken_bonds, 0, 0, "far below the strength")
  parts.near("deviation from linearity", worst/largest, 0, 1e3*parts.rounding[o.precision] + 100*(o.load + 1e-9)*1e-3,
             "a few strains and rounding")
end
