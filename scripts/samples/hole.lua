-- hole.lua: the paper's third plate. A hole without a crack: two cracks grow from its sides.
--
-- 10.5 MPa on the short edges (paper, Figs. 8 and 9; its frames are at 10, 40 and 90 us). The paper's dimensions
-- are lost; at this load only a narrow plate breaks, and 40 x 100 mm with a hole of 20 mm does.
-- Expected: cracks start at both sides of the hole at about 20 us, run straight to both edges and are
-- through by 40 us; no fork. A few bonds bridge them for long, so that the plate counts as one piece.
--
--   hackle run scripts/samples/hole.lua

local o = options { load = 10.5*MPa, radius = 10*mm, spacing = 0.5*mm, horizon = 2*mm }

-- 1. The scene.
local p = plate { width = 40*mm, height = 100*mm, material = "duran50" }
p:hole     { centre = {20*mm, 50*mm}, radius = o.radius }
p:traction { edge = "top",    stress = {0,  o.load} }
p:traction { edge = "bottom", stress = {0, -o.load} }
p:nofail   { edge = "top",    depth = o.horizon }
p:nofail   { edge = "bottom", depth = o.horizon }

-- 2. The lattice and the output.
local s = simulate(p, { spacing = o.spacing, horizon = o.horizon })
local seen = require "watch" (s, 0.5*us, 40*mm)
s:movie  { "hole.mp4", field = "damage", every = 0.5*us, width = 480 }

-- 3. Break it.
s:run(90*us)
s:frame  { "hole.png", field = "damage", width = 480 }
print(s:report())

-- 4. What it should give.
expect { "first broken bond", unit = "s", got = seen.first, min = 15*us, max = 22*us, source = "independent run of this geometry" }
expect { "through to both edges", unit = "s", got = seen.through, max = 40.5*us, source = "paper, Fig. 9: frame at 40 us" }
for side, from in pairs { left = 0, right = 30*mm } do
  local part = s:cracks { from = {from, 0}, to = {from + 10*mm, 100*mm} }
  expect { "cracks on the " .. side, got = part.bands, value = 1, source = "paper, Fig. 9: no branching" }
  expect { "their distance from mid-height on the " .. side, unit = "m", got = part.top and math.max(part.top - 50*mm, 50*mm - part.bottom),
           max = 2*mm, source = "paper, Fig. 9: across the load" }
end
