-- compact_tension.lua: the compact tension specimen C(T) of ASTM E399 and E1820.
--
-- W from the load line to the back edge, 1.25 W wide, 1.2 W high; pins of 0.25 W at 0.275 W above and below the
-- crack; a from the load line. The pins bear on the far sides of their holes.
-- Handbook: K = F/sqrt(W) f(a/W), E399 A4; opening at the load line, Saxena and Hudak 1978, both for 0.2 <= a/W.
-- Expected: opening 10.6 % and K 4.8 % above the handbook with a horizon of W/12.5; 4.8 % and 2.7 % with W/25.
-- With surface = "energy": 6.7 % and 2.7 %; 2.8 % and 1.6 %.
--
--   local p, at = require "specimens.compact_tension" { W = 50*mm, a = 25*mm, load = 1e4 }
local parts = require "specimens.parts"

local defaults = {
  W = 50*mm,
  a = function(o) return 0.5*o.W end,
  load = 1e3,
  material = "pmma",
}

return function(given)
  local o = parts.dimensions("compact_tension", given, defaults)
  local W, a = o.W, o.a/o.W
  parts.check("compact_tension", a >= 0.2 and a <= 0.95, "a/W must lie between 0.2 and 0.95")
  local line, middle, bore, pin = 0.25*W, 0.6*W, 0.125*W, 0.16*W

  local p = plate { width = 1.25*W, height = 1.2*W, material = o.material }
  p:crack { from = { 0, middle }, to = { line + o.a, middle } }
  for _, side in ipairs { 1, -1 } do
    p:hole { centre = { line, middle + side*0.275*W }, radius = bore }
    parts.pin(p, o, { line, middle + side*(0.275*W + bore + pin/2) }, pin, { 0, side*o.load })
  end

  local E, F, aside = o.material.E, o.load, 1e-6*W
  return p, parts.gauged(p, {
    E = E, load = F, a = o.a, tip = { line + o.a, middle },
    gauges = { { line, middle - aside }, { line, middle + aside } },
    K = F/math.sqrt(W)*(2 + a)/(1 - a)^1.5*(0.886 + 4.64*a - 13.32*a^2 + 14.72*a^3 - 5.6*a^4),
    displacement = F/E*((1 + a)/(1 - a))^2*
      (2.163 + 12.219*a - 20.065*a^2 - 0.9925*a^3 + 20.609*a^4 - 9.9314*a^5),
  }, "uy")
end
