-- inclusion.lua: a crack meets a stiff, tough disc and goes around it.
--
-- Expected: the crack forks before the disc and goes around it; it never enters it.
--
--   hackle run scripts/benchmarks/inclusion.lua
--   hackle run scripts/benchmarks/inclusion.lua --set stiffness=0.2     (a soft disc attracts it)

local o = options { load = 10*MPa, stiffness = 5, spacing = 0.5*mm, horizon = 2*mm }

local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
p:crack     { from = {0, 20*mm}, to = {35*mm, 20*mm} }
p:inclusion { centre = {60*mm, 17*mm}, radius = 6*mm,
              material = material { like = "duran50", name = "disc", E = o.stiffness*65*GPa, G0 = 2000 } }
for edge, pull in pairs { top = o.load, bottom = -o.load } do
  p:traction { edge = edge, stress = {0, pull} }:nofail { edge = edge, depth = o.horizon }
end

local s = simulate(p, { spacing = o.spacing, horizon = o.horizon })
local seen = require "watch" (s, 0.5*us)
s:movie { "inclusion.mp4", every = 0.5*us }
s:run(50*us)
s:frame { "inclusion.png" }
print(s:report())

if o.stiffness == 5 then
  expect { "damaged nodes inside the disc", value = 0, source = "a disc ten times as tough", -- minus a horizon, which has bonds to outside
           got = s:cracks { from = {57.2*mm, 14.2*mm}, to = {62.8*mm, 19.8*mm} }.nodes }
  expect { "place of the fork: before the disc", unit = "m", got = seen.place, max = 54*mm, source = "earlier run of this scene" }
  expect { "right end of the crack: beyond the disc", unit = "m", got = s:cracks().right, min = 66*mm, source = "earlier run of this scene" }
end
