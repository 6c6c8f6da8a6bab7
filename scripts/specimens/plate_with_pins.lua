-- plate_with_pins.lua: a plate with a crack in its middle, pulled by two pins: M(T) of ASTM E647.
--
-- W wide, a crack of length 2 a across its middle; pins of W/3, whose centres are 3 W apart and W from the ends. The
-- pins bear on the far sides of their holes.
-- Handbook: K = F/W sqrt(pi a/cos(pi a/W)), Feddersen; opening of the crack in its middle, Eftis and Liebowitz 1972:
-- 4 F/(pi E) arcosh(1/cos(pi a/W)) ((pi a/W)/sin(pi a/W))^(1/2).
-- Expected: opening 10.2 % and K 8.8 % above the handbook with a horizon of W/10; 5.9 % and 4.3 % with W/20.
-- With surface = "energy": 5.4 % and 4.3 %; 3.5 % and 2.1 %.
--
--   local p, at = require "specimens.plate_with_pins" { W = 40*mm, a = 10*mm, load = 1e4 }
local parts = require "specimens.parts"

local defaults = {
  W = 40*mm,
  a = function(o) return 0.25*o.W end,
  load = 1e3,
  material = "pmma",
}

local function arcosh(x) return math.log(x + math.sqrt(x^2 - 1)) end

return function(given)
  local o = parts.dimensions("plate_with_pins", given, defaults)
  local W, angle = o.W, math.pi*o.a/o.W
  parts.check("plate_with_pins", o.a <= 0.4*W, "a/W must lie between 0 and 0.4")
  local length, bore, pin = 5*W, W/6, 0.4*W
  local middle = length/2

  local p = plate { width = W, height = length, material = o.material }
  p:crack { from = { W/2 - o.a, middle }, to = { W/2 + o.a, middle } }
  for _, side in ipairs { 1, -1 } do
    p:hole { centre = { W/2, middle + side*1.5*W }, radius = bore }
    parts.pin(p, o, { W/2, middle + side*(1.5*W + bore + pin/2) }, pin, { 0, side*o.load })
  end

  local E, F, aside = o.material.E, o.load, 1e-6*W
  return p, parts.gauged(p, {
    E = E, load = F, a = o.a, tip = { W/2 + o.a, middle },
    gauges = { { W/2, middle - aside }, { W/2, middle + aside } },
    stress = F/W,
    K = F/W*math.sqrt(math.pi*o.a/math.cos(angle)),
    displacement = 4*F/(math.pi*E)*arcosh(1/math.cos(angle))*math.sqrt(angle/math.sin(angle)),
  }, "uy")
end
