-- parts.lua: what the scripts of hackle study envelope share.
--
--   local parts = require "envelope.parts"
local parts = {}

-- The relative rounding of a number in each precision.
parts.rounding = { f64 = 2.3e-16, f32 = 1.2e-7 }

-- Returns a material of E 65 GPa and rho 2235 kg/m3 with a critical stretch of 1e-3; `change` overrides. A given G0 takes the
-- place of s0.
function parts.glass(change)
  local m = { name = "envelope", E = 65e9, rho = 2235, s0 = 1e-3 }
  for key, value in pairs(change or {}) do m[key] = value end
  if m.G0 then m.s0 = nil end
  return material(m)
end

-- Calls f(node, x, y) for every node of a lattice; x and y are its place before it moves.
function parts.each(s, nx, ny, f)
  local dx = s.spacing
  for j = 0, ny - 1 do
    for i = 0, nx - 1 do
      local x, y = (i + 0.5)*dx, (j + 0.5)*dx
      f(s:at { x, y }, x, y)
    end
  end
end

-- Returns sums over all nodes: px, py (of velocities, m/s), size (of their absolute values), L (of position from the middle
-- of the plate times velocity, m2/s), turning (of the absolute values), x, y (mean displacement, m), far (the largest, m).
function parts.sums(s, nx, ny)
  local sum = { px = 0, py = 0, size = 0, L = 0, turning = 0, x = 0, y = 0, far = 0 }
  local cx, cy = 0.5*nx*s.spacing, 0.5*ny*s.spacing
  parts.each(s, nx, ny, function(node, x, y)
    local rx, ry = x + node.ux - cx, y + node.uy - cy
    local speed = math.sqrt(node.vx^2 + node.vy^2)
    sum.px, sum.py, sum.size = sum.px + node.vx, sum.py + node.vy, sum.size + speed
    sum.L = sum.L + rx*node.vy - ry*node.vx
    sum.turning = sum.turning + math.sqrt(rx^2 + ry^2)*speed
    sum.x, sum.y = sum.x + node.ux/(nx*ny), sum.y + node.uy/(nx*ny)
    sum.far = math.max(sum.far, math.abs(node.ux), math.abs(node.uy))
  end)
  return sum
end

-- Returns the largest difference of mirror images about the horizontal midline, m: exactly 0 for a symmetric scene.
function parts.asymmetry(s, nx, ny)
  local worst, dx = 0, s.spacing
  for j = 0, (ny - 1)//2 do
    for i = 0, nx - 1 do
      local a, b = s:at { (i + 0.5)*dx, (j + 0.5)*dx }, s:at { (i + 0.5)*dx, (ny - j - 0.5)*dx }
      worst = math.max(worst, math.abs(a.ux - b.ux), math.abs(a.uy + b.uy), math.abs(a.damage - b.damage))
    end
  end
  return worst
end

-- Returns a number between -1 and 1 that looks random, the same for the same whole number.
function parts.noise(k)
  local h = (k*2654435761) % 4294967296
  h = ((h ~ (h >> 15))*2246822519) % 4294967296
  return 2*((h ~ (h >> 13)) % 4294967296)/4294967296 - 1
end

-- Expects got = value within tolerance.
function parts.near(quantity, got, value, tolerance, source, unit)
  expect { quantity, got = got, value = value, tolerance = tolerance, source = source, unit = unit }
end

-- An edge crack in 60 x 40 nodes under a traction on both long edges, scaled: the spacing, E, rho, and the stress over E s0.
-- Returns the simulation after 150 steps of 0.875 of the limit.
function parts.cracked(o, scale)
  local dx, E = scale.dx or 1*mm, scale.E or 65e9
  local p = plate { width = 60*dx, height = 40*dx, material = parts.glass { E = E, rho = scale.rho, alpha = o.alpha } }
  local stress = (scale.load or 0.25)*E*1e-3
  p:crack { from = { 0, 20*dx }, to = { 24*dx, 20*dx } }
  p:traction { edge = "top", stress = { 0, stress } }
  p:traction { edge = "bottom", stress = { 0, -stress } }
  p:nofail { edge = "top", depth = 4*dx }
  p:nofail { edge = "bottom", depth = 4*dx }
  local numerics = { spacing = dx, horizon = (o.m or 4)*dx, precision = o.precision }
  numerics.step = 0.875*simulate(p, numerics).dt_limit
  local s = simulate(p, numerics)
  s:step(150)
  return s
end

return parts
