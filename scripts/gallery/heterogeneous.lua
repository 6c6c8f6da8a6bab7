-- heterogeneous.lua: the paper's plate at 24 MPa in glass of scattered strength. The branches are not
-- mirror images, as in the experiments of the paper's Fig. 5.
-- Expected: four or more branches above each other, different above and below mid-height.
--
--   hackle run scripts/gallery/heterogeneous.lua --set seed=2

local o = options { seed = 1 }

local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
p:crack    { from = {0, 20*mm}, to = {50*mm, 20*mm} }
p:strength { modulus = 8, correlation = 1*mm, seed = math.tointeger(o.seed) }
for edge, pull in pairs { top = 24*MPa, bottom = -24*MPa } do
  p:traction { edge = edge, stress = {0, pull} }:nofail { edge = edge, depth = 1*mm }
end

local s = simulate(p, { spacing = 0.25*mm, horizon = 1*mm })
s:movie { "heterogeneous.mp4", every = 0.25*us }
s:run(36*us)
s:frame { "heterogeneous.png" }
print(s:report())

local upper, lower = s:cracks { from = {0, 20*mm}, to = {100*mm, 40*mm} }, s:cracks { from = {0, 0}, to = {100*mm, 20*mm} }
expect { "branches", got = s:cracks().bands, min = 4, source = "paper, Fig. 5" }
expect { "difference of damaged nodes above and below", got = math.abs(upper.nodes - lower.nodes), min = 1,
         source = "paper, Fig. 5: real glass is not symmetric" }
