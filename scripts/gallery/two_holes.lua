-- two_holes.lua: two cracks, each deflected by a hole, turn towards each other.
--
-- A plate with two notches at different heights and two holes, pulled slowly at its ends. Each crack bends
-- towards the hole near its path.
-- Expected: the cracks run into the holes, and a bridge of cracks joins the two holes.
--
--   hackle run scripts/gallery/two_holes.lua

local p = plate { width = 60*mm, height = 120*mm, material = "pmma" }
p:notch { at = {0, 55*mm}, depth = 6*mm, width = 0.5*mm, shape = "v" }
p:notch { at = {60*mm, 65*mm}, depth = 6*mm, width = 0.5*mm, shape = "v" }
p:hole  { centre = {18*mm, 62*mm}, radius = 5*mm }
p:hole  { centre = {42*mm, 58*mm}, radius = 5*mm }
for edge, speed in pairs { top = 2, bottom = -2 } do
  p:move { edge = edge, depth = 2*mm, velocity = {0, speed}, time = ramp(20*us) }
end

local s = simulate(p, { spacing = 0.5*mm, horizon = 2*mm })
s:movie { "two_holes.mp4", every = 2*us, width = 480 }
s:run(260*us)
s:frame { "two_holes.png", width = 480 }
print(s:report())

local bridge = s:cracks { from = {24*mm, 0}, to = {36*mm, 120*mm} }
expect { "damaged nodes between the holes", min = 25, source = "a bridge of cracks joins them",
         got = s:cracks { from = {24*mm, 50*mm}, to = {36*mm, 70*mm} }.nodes }
expect { "top of the bridge", unit = "m", got = bridge.top, max = 65*mm, source = "holes draw cracks (Alshoaibi & Fageehi 2022)" }
expect { "bottom of the bridge", unit = "m", got = bridge.bottom, min = 55*mm, source = "holes draw cracks (Alshoaibi & Fageehi 2022)" }
