-- double_cantilever.lua: the double cantilever beam DCB (ASTM D3433).
--
-- Two arms of height h, opened at the load line; a is the length of the crack from there.
-- Handbook: K = F/sqrt(h) (3.46 a/h + 2.38), Srawley and Gross 1966; opening at the load line
-- 8 F/(E h^3) ((a + 0.6 h)^3 + a h^2), D3433.
-- Expected: opening 18 % and K 9.3 % above the handbook with a horizon of h/3; 9.5 % and 4.6 % with h/6.
-- With surface = "energy": 4.3 % and 2.1 %; 2.1 % and 0.6 %.
--
--   local p, at = require "specimens.double_cantilever" { h = 12*mm, a = 60*mm, load = 200 }
local parts = require "specimens.parts"

local defaults = {
  h = 12*mm,
  a = function(o) return 4*o.h end,
  length = function(o) return 1.5*o.h + o.a + 4*o.h end,
  load = 100,
  material = "pmma",
}

return function(given)
  local o = parts.dimensions("double_cantilever", given, defaults)
  local h, a, line, pin = o.h, o.a, 0.5*o.h, 0.5*o.h
  parts.check("double_cantilever", a >= 2*h and line + a + 2*h <= o.length,
              "a must be 2 h or more and end 2 h from the far edge")

  local p = plate { width = o.length, height = 2*h, material = o.material }
  p:crack { from = { 0, h }, to = { line + a, h } }
  for _, side in ipairs { 1, -1 } do
    parts.pin(p, o, { line, h + side*h/2 }, pin, { 0, side*o.load })
  end

  local E, F = o.material.E, o.load
  return p, parts.gauged(p, {
    E = E, load = F, a = o.a, tip = { line + a, h },
    gauges = { { line, h/2 }, { line, 1.5*h } },
    K = F/math.sqrt(h)*(3.46*a/h + 2.38),
    displacement = 8*F/(E*h^3)*((a + 0.6*h)^3 + a*h^2),
  }, "uy")
end
