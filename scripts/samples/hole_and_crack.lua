-- hole_and_crack.lua: the paper's fourth plate. An edge crack and a hole grow together.
--
-- 25.5 MPa on the short edges (paper, Fig. 8; its frames are at 34, 42 and 60 us). The paper's dimensions
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
s:movie  { "hole_and_crack.mp4", field = "damage", every = 0.5*us, width = 640 }

-- 3. Break it.
s:run(60*us)
s:frame  { "hole_and_crack.png", field = "damage", width = 640 }
print(s:report())
