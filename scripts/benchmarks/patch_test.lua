-- patch_test.lua: a uniform strain gives a uniform stress and the energy of the lattice's own moduli.
--
-- Plates of 20, 40 and 60 nodes per side are stretched by 1e-6 along x and held along y. The rim of a plate is
-- softer (its nodes lack bonds); the energy is a polynomial of the side, W = inner L^2 + rim L + corners,
-- so that the second difference of the three plates contains only the inside.
-- Source: C11 = E/(1 - nu^2) and C12 = nu C11 with the lattice's E and nu (src/lattice/calibration.hpp).
-- Expected: energy per area 1/2 C11 e^2 to a relative 1e-6; the inside stays at rest in the first step, because
-- stresses on both sides of every node are equal.
--
--   hackle run scripts/benchmarks/patch_test.lua
--   hackle validate --quick patch_test

local o = options { strain = 1e-6, spacing = 1*mm, m = 4 }
local E, dx = 65*GPa, o.spacing

-- nu of the family: C12/C11, from sums over its bonds.
local xx, xy = 0, 0
for a = -o.m, o.m do
  for b = -o.m, o.m do
    local r2 = a*a + b*b
    if r2 > 0 and r2 <= o.m^2 then xx, xy = xx + a^4/r2^1.5, xy + a*a*b*b/r2^1.5 end
  end
end
local nu = xy/xx
local C11 = E/(1 - nu^2)

local function strained(side)
  local p = plate { width = side*dx, height = side*dx, material = "duran50" }
  p:initial { displacement = function(x) return o.strain*(x - side*dx/2), 0 end }
  return simulate(p, { spacing = dx, horizon = o.m*dx })
end

local small, middle, large = strained(20), strained(40), strained(60)
local second = large.energy.strain - 2*middle.energy.strain + small.energy.strain
local inner = second/(2*(20*dx)^2)
print(string.format("energy per area %.8g J/m3, 1/2 C11 e^2 = %.8g J/m3", inner, 0.5*C11*o.strain^2))
print(string.format("stress %.8g Pa, C11 e = %.8g Pa", 2*inner/o.strain, C11*o.strain))

-- A node out of equilibrium moves by F dt^2/(2 m) in one step; no node inside may move.
local before = large:at({30*dx + dx/2, 30*dx + dx/2})
large:step(1)
local after = large:at({30*dx + dx/2, 30*dx + dx/2})
print(string.format("the middle moved by %.1g of its strain", math.abs(after.ux - before.ux)/(o.strain*dx)))

expect { "energy of a uniform strain", unit = "J/m3", got = inner, value = 0.5*C11*o.strain^2, relative = 1e-6, source = "1/2 C11 e^2" }
expect { "stress of a uniform strain", unit = "Pa", got = 2*inner/o.strain, value = C11*o.strain, relative = 1e-6, source = "C11 e" }
expect { "motion of the middle in a step, over its strain", got = math.abs(after.ux - before.ux)/(o.strain*dx), max = 1e-12,
         source = "a uniform strain leaves inner nodes at rest" }
