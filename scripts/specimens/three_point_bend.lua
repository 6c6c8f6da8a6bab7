-- three_point_bend.lua: a bar without a crack on two rollers, for the strength in bending (ASTM C1161, size B).
--
-- A bar of depth h on rollers `span` apart, loaded in the middle. The spacing must divide h/4: the
-- forces of the rollers then balance each other.
-- Handbook: sagging of the middle line against the rollers, F S^3/(4 E h^3) (1 + 2.85 (h/S)^2 - 0.84 (h/S)^3),
-- Timoshenko and Goodier; stress on the lower side, 3 F S/(2 h^2).
-- Expected: sagging 13.5 % above the handbook with a horizon of h/5; 6.5 % with h/10.
-- With surface = "energy": 1.8 %; 0.4 %. With supports = "rollers": 13.2 %, 6.0 %; 1.4 %, -0.1 %.
--
--   local p, at = require "specimens.three_point_bend" { h = 4*mm, span = 40*mm, load = 1e3 }
local parts = require "specimens.parts"

local defaults = {
  h = 4*mm,
  span = function(o) return 10*o.h end,
  load = 1e3,
  material = "alumina",
  supports = "pins",
}

return function(given)
  local o = parts.dimensions("three_point_bend", given, defaults)
  local h, span = o.h, o.span
  parts.check("three_point_bend", span >= 4*h, "the span must be at least 4 h")
  local length = span + 1.25*h
  local middle = length/2

  local p = plate { width = length, height = h, material = o.material }
  parts.bend(parts.has_bodies("three_point_bend", o, "rollers"), p, o, middle, h, span, h)

  local E, F, slender = o.material.E, o.load, h/span
  return p, parts.gauged(p, {
    E = E, load = F,
    gauges = { { middle, h/2 }, { middle - span/2, h/2 } },
    stress = 1.5*F*span/h^2,
    displacement = F*span^3/(4*E*h^3)*(1 + 2.85*slender^2 - 0.84*slender^3),
  }, "uy")
end
