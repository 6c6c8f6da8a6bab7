-- nodes.lua: plates of one node, chains, and millions of nodes.
--
-- A plate under a constant force for each volume falls, whatever its shape.
-- Expected: u = f t^2/(2 rho), exact for leapfrog, up to a rounding of each step.
--
--   hackle run scripts/envelope/nodes.lua --set nx=1 --set ny=1000
local parts = require "envelope.parts"
local o = options { nx = 1, ny = 1, m = 4, precision = "f64", steps = 200 }
local dx = 1*mm
local p = plate { width = o.nx*dx, height = o.ny*dx, material = parts.glass() }
p:body_force { force = { 3e9, 1e9 } }
local s = simulate(p, { spacing = dx, horizon = o.m*dx, precision = o.precision })
s:step(o.steps)
local way = 0.5*1e9/2235*s.time^2
local tolerance = 4*o.steps*parts.rounding[o.precision]
for name, place in pairs { first = { 0.5*dx, 0.5*dx }, last = { (o.nx - 0.5)*dx, (o.ny - 0.5)*dx } } do
  local node = s:at(place)
  parts.near("way along y of the " .. name .. " node", node.uy/way, 1, tolerance, "f t^2/(2 rho)")
  parts.near("way along x of the " .. name .. " node", node.ux/(3*way), 1, tolerance, "f t^2/(2 rho)")
end
parts.near("broken bonds", s.damage.broken_bonds, 0, 0, "nothing is stretched")
