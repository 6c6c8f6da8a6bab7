-- ring.lua: a ring that bursts from within. It breaks into fragments that fly off.
--
-- Mott's fragmenting ring: every part moves outwards at the same initial speed; the weakest parts break
-- first and relieve their neighbours.
-- Expected: ten large fragments or more.
--
--   hackle run scripts/gallery/ring.lua

local R, r = 28*mm, 22*mm

-- The outside of the ring, as a square with a round hole: a polygon whose inner part runs the other way.
local outside = {}
for k = 0, 360 do
  local a = math.rad(k)
  outside[#outside + 1] = {30*mm + R*math.cos(a), 30*mm + R*math.sin(a)}
end
for _, corner in ipairs { {70*mm, 30*mm}, {70*mm, -10*mm}, {-10*mm, -10*mm}, {-10*mm, 70*mm}, {70*mm, 70*mm}, {70*mm, 30*mm} } do
  outside[#outside + 1] = corner
end

local p = plate { width = 60*mm, height = 60*mm, material = "duran50" }
p:hole     { points = outside }
p:hole     { centre = {30*mm, 30*mm}, radius = r }
p:strength { modulus = 10, correlation = 2*mm, seed = 3 }
p:initial  { velocity = function(x, y)
  local dx, dy = x - 30*mm, y - 30*mm
  local d = math.sqrt(dx*dx + dy*dy) + 1e-9
  return 10*dx/d, 10*dy/d
end }

local s = simulate(p, { spacing = 0.25*mm })
s:movie { "ring.mp4", every = 0.25*us, width = 800 }
s:run(30*us)
s:frame { "ring.png", width = 800 }
print(s:report())

local large = 0
for _, one in ipairs(s:fragments()) do if one.nodes > 50 then large = large + 1 end end
expect { "fragments of more than 50 nodes", got = large, min = 10, source = "Mott: a ring breaks into many" }
