-- motion.lua: what no motion may change: momentum, energy, symmetry; the limit of the step; collisions.
--
-- Expected: momentum to rounding; the error of the energy falls with the square of the step; stable at 0.98 of the limit of the
-- step and not at 1.02; bars of one length exchange their speeds.
--
--   hackle run scripts/validation/motion.lua
--   hackle validate --quick motion

local dx, rho = 1*mm, 2235

-- A bulge that bounces about in a free plate.
local function bouncing(numerics)
  local p = plate { width = 40*mm, height = 20*mm, material = "duran50" }
  p:initial { displacement = function(x, y)
    local bulge = 1e-7*math.exp(-((x - 13*mm)^2 + (y - 8*mm)^2)/(4*mm)^2)
    return bulge, 0.5*bulge
  end }
  numerics.spacing, numerics.horizon = dx, 4*dx
  return simulate(p, numerics)
end

local function worst_residual(share)
  local limit = bouncing({}).dt_limit
  local s = bouncing { step = share*limit }
  local worst, all = 0, s.energy.external
  while s.time < 20*us do
    s:step(1)
    worst = math.max(worst, math.abs(s.energy.residual)/all)
  end
  return worst
end
expect { "error of the energy, twice the step over the step", got = worst_residual(0.5)/worst_residual(0.25), value = 4, tolerance = 0.5,
         source = "velocity Verlet is of the second order" }

do
  local s = bouncing { safety = 0.98 }
  local before = s.energy.external
  s:step(5000)
  expect { "energy after 5000 steps at 0.98 of the limit, over that before", got = (s.energy.kinetic + s.energy.strain)/before, value = 1,
           tolerance = 0.2, source = "2/omega of the lattice is the limit of leapfrog" }
  local steps = 0
  local broken = bouncing({}).dt_limit
  local bad = bouncing { step = 1.02*broken, force_step = true }
  pcall(function() while steps < 5000 do bad:step(50) steps = steps + 50 end end)
  local grown = steps < 5000 and math.huge or bad.energy.kinetic/before
  expect { "the same plate at 1.02 of the limit diverges (1) or not (0)", got = grown > 100 and 1 or 0, value = 1,
           source = "2/omega of the lattice is the limit of leapfrog" }
end

-- Momentum per thickness of the nodes in a rectangle.
local function momentum(s, from, to, nodes)
  local vx, vy = s:values("velocity_x"), s:values("velocity_y")
  return vx:mean { from = from, to = to }*nodes*rho*dx^2, vy:mean { from = from, to = to }*nodes*rho*dx^2
end

do
  local s = bouncing {}
  s:run(30*us)
  local px, py = momentum(s, {0, 0}, {40*mm, 20*mm}, 800)
  local scale = 800*rho*dx^2*s:values("speed"):max().value
  expect { "momentum of a free plate over the largest it could have", got = math.sqrt(px^2 + py^2)/scale, value = 0, tolerance = 1e-7,
           source = "bonds pull both ends alike; fields have single precision" }
end

-- One bar hits another of the same size: it stops, the other flies on. The gap of two spacings is closed at once.
do
  local length, height, v = 60*mm, 8*mm, 1
  local p = plate { width = 2*length + 4*dx, height = height, material = "duran50" }
  p:hole { points = { {length, -1*mm}, {length + 4*dx, -1*mm}, {length + 4*dx, height + 1*mm}, {length, height + 1*mm} } }
  p:contact {}
  p:initial { velocity = function(x) return x < length + 2*dx and v or 0, 0 end }
  local s = simulate(p, { spacing = dx, horizon = 3*dx })
  local c = math.sqrt(65*GPa/rho)
  s:run(4*dx/v + 4*length/c)
  local count = 60*8
  local left = momentum(s, {0, 0}, {length, height}, count)
  local right = momentum(s, {length + 4*dx, 0}, {2*length + 4*dx, height}, count)
  local whole = count*rho*dx^2*v
  expect { "colliding bars: momentum of both over that before", got = (left + right)/whole, value = 1, tolerance = 1e-7,
           source = "momentum; fields have single precision" }
  expect { "colliding bars: share that has gone over", got = right/whole, value = 1, tolerance = 0.05,
           source = "St Venant: equal bars exchange their speeds" }
end

-- A plate and its mirror image: the crack stays symmetric while it forks.
do
  local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
  p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
  for edge, pull in pairs { top = 12*MPa, bottom = -12*MPa } do
    p:traction { edge = edge, stress = {0, pull} }:nofail { edge = edge, depth = 4*mm }
  end
  local s = simulate(p, { spacing = 1*mm, horizon = 4*mm })
  s:run(40*us)
  local differences, damage = 0, s:values("damage")
  for x = 0, 99 do
    for y = 0, 19 do
      local at = (x + 0.5)*mm
      if damage:at({at, (y + 0.5)*mm}) ~= damage:at({at, (39.5 - y)*mm}) then differences = differences + 1 end
    end
  end
  expect { "nodes whose mirror image has another damage, after a fork", got = differences, value = 0, source = "symmetry of the scene" }
  expect { "largest damage", got = damage:max().value, max = 1, source = "a share" }
end

-- Compression breaks nothing, however strong.
do
  local p = plate { width = 40*mm, height = 20*mm, material = "duran50" }
  p:initial { displacement = function(x, y) return -0.02*x, -0.02*y end }
  local s = simulate(p, { spacing = dx, horizon = 4*dx })
  s:step(1) -- later the plate bounces
  expect { "bonds broken by a compression of 2 %", got = s.damage.broken_bonds, value = 0, source = "s > s0 alone breaks a bond" }
end
expect { "time reversal", value = 0, source = "leapfrog", unsupported = true,
         reason = "scripts cannot turn velocities round; solver/conservation_test.cpp does" }
