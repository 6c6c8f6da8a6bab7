-- lattice.lua: waves, motions and energies of the lattice against its closed forms.
--
-- A plane wave on the lattice has the frequency that the symbol of its bonds says, rho w^2 = sum c V (xi xi^T/|xi|^3)
-- (1 - cos k.xi), and velocity Verlet turns it by 2 asin(w dt/2) in a step; a rigid motion costs nothing; a straight cut costs
-- G0 times its length.
-- Expected: frequencies to 1e-6, energies to rounding.
--
--   hackle run scripts/validation/lattice.lua
--   hackle validate --quick lattice

local dx, m, side, E, rho = 1*mm, 4, 61, 65*GPa, 2235
local middle = {(side/2)*dx, (side/2)*dx}

-- All bonds of a node, in spacings.
local family = {}
for a = -m, m do
  for b = -m, m do
    local r2 = a*a + b*b
    if r2 > 0 and r2 <= m*m then family[#family + 1] = {a, b, math.sqrt(r2)} end
  end
end
local xx, xy = 0, 0
for _, bond in ipairs(family) do
  local a, b, r = table.unpack(bond)
  xx, xy = xx + a^4/r^3, xy + a*a*b*b/r^3
end
local c = E/(0.5*dx^3*(xx - xy*xy/xx)) -- micromodulus that gives E along an axis

local function simulated(displacement)
  local p = plate { width = side*dx, height = side*dx, material = "duran50" }
  p:initial { displacement = displacement }
  return simulate(p, { spacing = dx, horizon = m*dx })
end

-- Of waves along x: pressure waves (u along x) and shear waves (u along y).
local function frequency_of_symbol(k, axis)
  local sum = 0
  for _, bond in ipairs(family) do
    sum = sum + c*dx^2*bond[axis]^2/(bond[3]^3*dx)*(1 - math.cos(k*bond[1]*dx))
  end
  return math.sqrt(sum/rho)
end

-- The middle of the plate knows nothing of its edges for the first steps: u, then u cos(w dt), where
-- v of the first half step is zero on average, so that the second and third values say w.
local function frequency_of_plate(k, axis)
  local x0 = middle[1]
  local s = simulated(function(x)
    local u = 1e-6*dx*math.cos(k*(x - x0))
    if axis == 1 then return u, 0 end
    return 0, u
  end)
  local name = axis == 1 and "ux" or "uy"
  local u = {}
  for n = 1, 4 do u[n] = s:at(middle)[name] s:step(1) end
  return 2/s.dt*math.sin(0.5*math.acos((u[2] + u[4])/(2*u[3])))
end

local lengths = { 4, 6, 8, 10, 12, 16, 20, 30 }
for axis, name in ipairs { "pressure", "shear" } do
  expect { "frequency of " .. name .. " waves", unit = "1/s", at = lengths, along = "length of the wave in spacings",
           value = function(n) return frequency_of_symbol(2*math.pi/(n*dx), axis) end,
           got = function(n) return frequency_of_plate(2*math.pi/(n*dx), axis) end,
           relative = 1e-6, source = "symbol of the lattice, velocity Verlet" }
end

local moved = simulated(function() return 1e-6, -2e-6 end)
expect { "strain energy of a translation", unit = "J/m", got = moved.energy.strain, value = 0,
         source = "no force between nodes that move alike" }

-- A finite rotation by 30 degrees; 1e-12 of the energy of a strain of the same size.
local cos, sin = math.cos(math.pi/6), math.sin(math.pi/6)
local turned = simulated(function(x, y)
  x, y = x - middle[1], y - middle[2]
  return x*cos - y*sin - x, x*sin + y*cos - y
end)
expect { "strain energy of a rotation by 30 degrees", unit = "J/m", got = turned.energy.strain, value = 0,
         tolerance = 1e-12*E*(side*dx)^2, source = "a rotation stretches no bond" }

-- Halves that jump apart lose every bond between them, at the energy of its breaking; the difference of two
-- lengths has no ends.
local function broken_by_a_cut(length)
  local p = plate { width = length*dx, height = 20*dx, material = "duran50" }
  p:initial { displacement = function(_, y) return 0, y > 10*dx and 0.1*dx or 0 end }
  local s = simulate(p, { spacing = dx, horizon = m*dx })
  s:step(1)
  return s.damage.broken_bonds, s.G0
end
local short, G0 = broken_by_a_cut(20)
local long = broken_by_a_cut(40)
local crossing = 0
for _, bond in ipairs(family) do crossing = crossing + math.max(0, bond[2]) end
expect { "bonds that a straight cut breaks per spacing", got = (long - short)/20, value = crossing,
         source = "sum over the family" }
expect { "fracture energy of the lattice along an axis", unit = "J/m2", got = G0, value = 204, relative = 1e-12,
         source = "Duran 50; constants of the lattice" }
