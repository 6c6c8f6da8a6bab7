-- scale.lua: the same dimensionless problem from nanometres to kilometres, for any stiffness and density.
--
-- A crack forks in a plate whose spacing, E and rho are scaled together with the load, and in the plate it is scaled from.
-- Expected: the same broken bonds, and displacements in spacings that differ by rounding, which grows by 1e4 before a fork.
--
--   hackle run scripts/envelope/scale.lua --set E=1e-3
local parts = require "envelope.parts"
local o = options { dx = 1*mm, E = 65e9, rho = 2235, precision = "f64", alpha = 0, m = 4 }
local usual = parts.cracked(o, {})
local other = parts.cracked(o, { dx = o.dx, E = o.E, rho = o.rho })
local largest, worst = 0, 0
parts.each(usual, 60, 40, function(a, x, y)
  local b = other:at { x/(1*mm)*o.dx, y/(1*mm)*o.dx }
  for _, k in ipairs { "ux", "uy" } do
    largest = math.max(largest, math.abs(a[k])/(1*mm))
    worst = math.max(worst, math.abs(a[k]/(1*mm) - b[k]/o.dx))
  end
end)
expect { "broken bonds of the usual plate", got = usual.damage.broken_bonds, min = 100, source = "the crack runs" }
parts.near("broken bonds", other.damage.broken_bonds, usual.damage.broken_bonds, 0, "the same dimensionless problem")
parts.near("largest difference of u/dx over the largest u/dx", worst/largest, 0, 1e4*parts.rounding[o.precision],
           "rounding, which grows by 1e4")
