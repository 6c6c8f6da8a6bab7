-- shatter.lua: a steel disc flies into the edge of a plate of glass, crushes it, and bounces off while cracks
-- run on through the plate.
--
-- Strength scatters, so that the two sides break differently. The faces of cracks repel each other where
-- they touch; without p:contact{} fragments would pass through one another.
-- Expected: a crushed half-disc at the impact, from which cracks reach the far edges by 40 us; the disc flies back.
--
--   hackle run scripts/gallery/shatter.lua
--   hackle run scripts/gallery/shatter.lua --set seed=5

local o = options { seed = 2, speed = 60, spacing = 0.25*mm }

local p = plate { width = 60*mm, height = 60*mm, material = "duran50" }
p:strength { modulus = 10, correlation = 1*mm, seed = o.seed }
p:contact  {}
p:impactor { centre = {-5.01*mm, 30*mm}, radius = 5*mm, velocity = {o.speed, 0} }

local s = simulate(p, { spacing = o.spacing })
s:movie { "shatter.mp4", every = 0.25*us, width = 800 }
s:run(40*us)
s:frame { "shatter.png", width = 800 }
print(s:report())

if o.speed == 60 and o.spacing == 0.25*mm then
  local cracks = s:cracks()
  expect { "crushed nodes of the 96 within 3 mm of the impact", value = 96, source = "earlier run of this scene",
           got = s:cracks { from = {0, 29*mm}, to = {3*mm, 31*mm} }.nodes }
  expect { "right end of the cracks", unit = "m", got = cracks.right, min = 59*mm, source = "earlier run of this scene" }
  expect { "top end of the cracks", unit = "m", got = cracks.top, min = 59*mm, source = "earlier run of this scene" }
  expect { "fragments", got = #s:fragments(), min = 6, source = "earlier run of this scene" }
end
