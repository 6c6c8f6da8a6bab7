-- hole_and_crack.lua: the paper's fourth plate. An edge crack and a hole grow together.
--
-- 25.5 MPa on the short edges (paper, Figs. 10 and 11; its frames are at 34, 42 and 60 us). The paper's dimensions
-- are lost. A plate of 300 mm fits its times: the waves from the loaded edges meet at mid-height
-- at 26 us.
-- Expected: the edge crack and both sides of the hole have started by 34 us, have joined by 42 us, and
-- cracks run from edge to edge by 60 us; no fork. At the right edge, where the crack is broad and rough, some
-- shreds still hold the halves together.
--
--   hackle run scripts/samples/hole_and_crack.lua

local o = options { load = 25.5*MPa, radius = 10*mm, spacing = 0.5*mm, horizon = 2*mm }

-- 1. The scene.
local p = plate { width = 100*mm, height = 300*mm, material = "duran50" }
p:crack    { from = {0, 150*mm}, to = {20*mm, 150*mm} }
p:hole     { centre = {60*mm, 150*mm}, radius = o.radius }
p:traction { edge = "top",    stress = {0,  o.load} }
p:traction { edge = "bottom", stress = {0, -o.load} }
p:nofail   { edge = "top",    depth = o.horizon }
p:nofail   { edge = "bottom", depth = o.horizon }

-- 2. The lattice and the output.
local s = simulate(p, { spacing = o.spacing, horizon = o.horizon })
local started, joined
local function cracked(x) return s:cracks { from = {x - 1.5*mm, 140*mm}, to = {x + 1.5*mm, 160*mm} }.nodes > 0 end
s:on { "every", every = 1*us, call = function(t)
  if not started and cracked(23*mm) and cracked(48.5*mm) and cracked(71.5*mm) then started = t end
  local whole = true
  for x = 23*mm, 47*mm, 3*mm do whole = whole and cracked(x) end
  if whole and not joined then joined = t end
end }
s:movie  { "hole_and_crack.mp4", field = "damage", every = 0.5*us, width = 640 }

-- 3. Break it.
s:run(60*us)
s:frame  { "hole_and_crack.png", field = "damage", width = 640 }
print(s:report())

-- 4. What it should give.
expect { "crack and both sides of the hole have started", unit = "s", got = started, max = 35*us, source = "paper, Fig. 11: frame at 34 us" }
expect { "crack and hole have joined", unit = "s", got = joined, max = 43*us, source = "paper, Fig. 11: frame at 42 us" }
local all = s:cracks()
expect { "right end of the cracks", unit = "m", got = all.right, min = 99*mm, source = "paper, Fig. 11: frame at 60 us" }
expect { "distance from mid-height: no fork", unit = "m", got = all.top and math.max(all.top - 150*mm, 150*mm - all.bottom), max = 6*mm,
         source = "paper, Fig. 11" }
