-- speed.lua: plates that fly, as fast as waves run and faster.
--
-- The whole plate has one velocity, given as a share of the speed of longitudinal waves.
-- Expected: every node goes u = v t, up to a rounding of each step; nothing breaks.
--
--   hackle run scripts/envelope/speed.lua --set share=2
local parts = require "envelope.parts"
local o = options { share = 1, precision = "f64", steps = 500, nx = 24, ny = 18, m = 4 }
local dx = 1*mm
local v = o.share*5686
local p = plate { width = o.nx*dx, height = o.ny*dx, material = parts.glass() }
p:initial { velocity = { v, 0.5*v } }
local s = simulate(p, { spacing = dx, precision = o.precision, horizon = o.m*dx })
s:step(o.steps)
local worst, way = 0, v*s.time
parts.each(s, o.nx, o.ny, function(node)
  worst = math.max(worst, math.abs(node.ux/way - 1), math.abs(node.uy/(0.5*way) - 1))
end)
parts.near("largest relative error of u", worst, 0, 4*o.steps*parts.rounding[o.precision], "u = v t")
parts.near("broken bonds", s.damage.broken_bonds, 0, 0, "nothing is stretched")
