-- single_bond.lua: the smallest scene with a bond to break, two nodes that fly apart.
--
-- Two nodes on the smallest family (m = 2) move apart along x at 10 m/s each. The bond between them is a linear
-- spring, k = c V^2/dx between two nodes of mass rho V, whose stretch until it reaches s0 is
-- s(t) = 2 v/(w dx) sin(w t) with w^2 = 2 c V/(rho dx).
-- Source: that formula, and the calibration of src/lattice for c: E = C11 - C12^2/C11 over the offsets of the family.
-- Expected: the bond breaks within two steps of the closed form, and its energy agrees to six digits.
--
--   hackle run scripts/benchmarks/single_bond.lua
--   hackle validate --quick single_bond

local dx, v, E, rho, s0 = 1*mm, 10, 65*GPa, 2235, 2e-3

-- Micromodulus of the family: C11 = 1/2 c V sum x^4/r^3, C12 = 1/2 c V sum x^2 y^2/r^3.
local xx, xy = 0, 0
for a = -2, 2 do
  for b = -2, 2 do
    local r2 = a*a + b*b
    if r2 > 0 and r2 <= 4 then
      xx, xy = xx + a^4/r2^1.5, xy + a*a*b*b/r2^1.5
    end
  end
end
local c = E/(0.5*dx^3*(xx - xy*xy/xx))
local w = math.sqrt(2*c*dx/rho)

local p = plate { width = 2*dx, height = dx,
                  material = material { name = "bond", E = E, rho = rho, nu = 0.33, s0 = s0 } }
p:initial { velocity = function(x) return x > dx and v or -v, 0 end }
local s = simulate(p, { spacing = dx, horizon = 2*dx, step = 0.2*ns })
while s.damage.broken_bonds == 0 and s.time < 1*us do s:step(1) end

local closed = math.asin(s0*w*dx/(2*v))/w
print(string.format("breaks at %.2f ns, closed form %.2f ns, step %.2f ns", s.time/ns, closed/ns, s.dt/ns))
print(string.format("energy of the bond %.6g J/m, closed form 1/2 c s0^2 dx V^2 = %.6g J/m",
                    s.energy.broken, 0.5*c*s0^2*dx^5))

expect { "time of breaking", unit = "s", got = s.time, value = closed, tolerance = 2*s.dt, source = "oscillator of two nodes" }
expect { "energy of the broken bond", unit = "J/m", got = s.energy.broken, value = 0.5*c*s0^2*dx^5, relative = 1e-5, source = "1/2 c s0^2 dx V^2" }
