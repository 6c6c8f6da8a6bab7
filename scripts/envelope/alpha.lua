-- alpha.lua: toughening by compression, from none to its bound.
--
-- A bond breaks above s0 - alpha s_min: where all bonds have one stretch, s_min is that too, and they break above s0/(1 + alpha).
-- Expected: none breaks 2 % below that, most break 2 % above it; pressed across, never more break than without alpha.
--
--   hackle run scripts/envelope/alpha.lua --set alpha=0.99
local parts = require "envelope.parts"
local o = options { alpha = 0.25, precision = "f64" }
local dx = 1*mm
local function broken(alpha, ex, ey)
  local p = plate { width = 30*dx, height = 20*dx, material = parts.glass { alpha = alpha } }
  p:initial { displacement = function(x, y) return ex*x, ey*y end }
  local s = simulate(p, { spacing = dx, precision = o.precision })
  s:step(2)
  return s.damage.broken_bonds, s.bonds
end
local limit = 1e-3/(1 + o.alpha)
parts.near("broken bonds 2 % below the limit", broken(o.alpha, 0.98*limit, 0.98*limit), 0, 0, "s0/(1 + alpha)")
local above, bonds = broken(o.alpha, 1.02*limit, 1.02*limit)
expect { "share of broken bonds 2 % above it", got = above/bonds, min = 0.8, source = "the same; the rim springs back first" }
expect { "broken bonds when pressed across", got = (broken(o.alpha, 1.2e-3, -0.8e-3)),
         max = (broken(0, 1.2e-3, -0.8e-3)), source = "alpha only toughens" }
local s = parts.cracked(o, {})
parts.near("difference of mirror images", parts.asymmetry(s, 60, 40), 0, 0, "the scene is its mirror image", "m")
