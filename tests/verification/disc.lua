-- disc.lua: strains at the centre of a disc that is squeezed between two short arcs (Brazilian disc).
--
-- The load acts downwards on the cells of the highest row of the disc, upwards on those of the lowest; Hondros (1959)
-- gives the stresses at the centre for a pressure on arcs of half-angle a: across (2p/pi)(sin 2a - a), along
-- -(2p/pi)(sin 2a + a). Strains follow with E of the material and nu = 1/3, that of an ideal bond-based plate.
-- What is left is the anisotropy of the lattice and its nu: see src/lattice/README.md 3.6.
--
--   hackle run tests/verification/disc.lua --set quadrature=area

local o = options { quadrature = "full", m = 4, radius = 80, surface = "" }
local dx, R = 0.25*mm, o.radius*0.25*mm
local p = plate { width = 2*R, height = 2*R, material = "duran50" }
p:keep { centre = {R, R}, radius = R }
local chord = 0
for i = 1, o.radius do
  if ((i - 0.5)^2 + (o.radius - 0.5)^2)*dx^2 <= R^2 then chord = chord + 2*dx end
end
local a = math.asin(0.5*chord/R)
local pressure = 1*MPa
p:traction { edge = "top", stress = {0, -pressure} }
p:traction { edge = "bottom", stress = {0, pressure} }
local numerics = { spacing = dx, horizon = o.m*dx, quadrature = o.quadrature }
if o.surface ~= "" then numerics.surface = o.surface end
local s = simulate(p, numerics)
s:relax { tolerance = 1e-8 }

local E, nu, k = 65*GPa, 1/3, 2*pressure/math.pi
local across, along = k*(math.sin(2*a) - a), -k*(math.sin(2*a) + a)
local function strain(dx_, dy_, axis)
  local one, other = s:at({R - dx_, R - dy_}), s:at({R + dx_, R + dy_})
  if axis == "x" then return (other.ux - one.ux)/(other.x - one.x) end
  return (other.uy - one.uy)/(other.y - one.y)
end
local g = 4.5*dx
local ex, ey = strain(g, 0.5*dx, "x"), strain(0.5*dx, g, "y")
print(string.format("m = %g, %s: across %+.1f %%, along %+.1f %%", o.m, o.quadrature,
                    100*(ex/((across - nu*along)/E) - 1), 100*(ey/((along - nu*across)/E) - 1)))
