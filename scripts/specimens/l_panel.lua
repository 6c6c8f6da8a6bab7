-- l_panel.lua: the L-shaped panel of Winkler 2001, concrete, which cracks from its inner corner.
--
-- Two legs of the same width, W in all; the foot of the upright leg is held, and the other leg is pushed up from below,
-- 0.06 W from its end (500 mm, 250 mm and 30 mm in the tests).
-- Handbook: none in closed form. The rise of the leg's middle line above the load is 39.05 F/E for nu = 1/3, by finite
-- elements: squares of W/50 to W/400 give 38.726, 38.905, 38.985, 39.021.
-- Expected: rise 8.4 % above the finite elements with a horizon of W/25; 4.7 % with W/50.
-- With surface = "energy": 3.7 %; 2.6 %.
--
--   local p, at = require "specimens.l_panel" { W = 500*mm, load = 1e4 }
local parts = require "specimens.parts"

local defaults = {
  W = 500*mm,
  load = 1e4,
  material = function()
    return material { name = "Winkler's concrete", E = 25.85*GPa, rho = 2400, nu = 0.18, G0 = 90 }
  end,
}

return function(given)
  local o = parts.dimensions("l_panel", given, defaults)
  local W = o.W
  local leg, pin, line = 0.5*W, 0.08*W, 0.94*W

  local p = plate { width = W, height = W, material = o.material,
                    outline = { points = { { 0, 0 }, { leg, 0 }, { leg, leg }, { W, leg }, { W, W }, { 0, W } } } }
  p:clamp { edge = "bottom", depth = 0.02*W }
  p:nofail { edge = "bottom", depth = 0.04*W }
  parts.pin(p, o, { line, leg + pin/2 }, pin, { 0, o.load }, 1)

  local E, F = o.material.E, o.load
  return p, parts.gauged(p, {
    E = E, load = F,
    gauges = { { leg/2, 0 }, { line, 0.75*W } },
    displacement = F/E*39.05,
  }, "uy")
end
