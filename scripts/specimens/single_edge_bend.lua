-- single_edge_bend.lua: the single-edge bend specimen SE(B) of ASTM E399 and E1820.
--
-- A bar W deep on two rollers 4 W apart, loaded in the middle, with a crack of length a from below.
-- The spacing must divide W/10: the forces of the rollers then balance each other.
-- Handbook: K, E399 A3; opening of the crack's mouth, Tada, Paris and Irwin, both for a span of 4 W.
-- Expected: opening 8.2 % and K 7.5 % above the handbook with a horizon of W/10; 5.4 % and 3.9 % with W/20.
-- With surface = "energy": 4.2 % and 4.3 %; 3.3 % and 2.2 %. With supports = "rollers": 7.2 % and 6.6 %, 4.5 % and
-- 3.2 %; with both: 3.2 % and 3.4 %, 2.5 % and 1.5 %.
--
--   local p, at = require "specimens.single_edge_bend" { W = 20*mm, a = 10*mm, load = 1e3 }
local parts = require "specimens.parts"

local defaults = {
  W = 20*mm,
  a = function(o) return 0.5*o.W end,
  load = 1e3,
  material = "pmma",
  supports = "pins",
}

return function(given)
  local o = parts.dimensions("single_edge_bend", given, defaults)
  local W, a, span = o.W, o.a/o.W, 4*o.W
  parts.check("single_edge_bend", a >= 0.05 and a <= 0.95, "a/W must lie between 0.05 and 0.95")
  local length = 4.5*W
  local middle = length/2

  local p = plate { width = length, height = W, material = o.material }
  p:crack { from = { middle, 0 }, to = { middle, o.a } }
  parts.bend(parts.has_bodies("single_edge_bend", o, "rollers"), p, o, middle, W, span, 0.4*W)

  local E, F, aside = o.material.E, o.load, 1e-6*W
  local shape = 1.99 - a*(1 - a)*(2.15 - 3.93*a + 2.7*a^2)
  return p, parts.gauged(p, {
    E = E, load = F, a = o.a, tip = { middle, o.a },
    gauges = { { middle - aside, 0 }, { middle + aside, 0 } },
    K = F*span/W^1.5*3*math.sqrt(a)*shape/(2*(1 + 2*a)*(1 - a)^1.5),
    displacement = 6*F*span*o.a/(E*W^2)*(0.76 - 2.28*a + 3.87*a^2 - 2.04*a^3 + 0.66/(1 - a)^2),
  }, "ux")
end
