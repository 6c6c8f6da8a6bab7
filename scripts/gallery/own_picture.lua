-- own_picture.lua: your own PNG breaks. Its bright pixels are glass; a force pulls its left and right halves apart.
--
-- The heart was drawn for Hackle, from the curve (x^2 + y^2 - 1)^3 = x^2 y^3. The strength is scattered, so that
-- different seeds give different pictures.
-- Expected: it breaks from its cusp downwards; the crack forks several times, and two branches are through by 50 us.
--
--   hackle run scripts/gallery/own_picture.lua
--   hackle run scripts/gallery/own_picture.lua -- my.png
--   hackle run scripts/gallery/own_picture.lua --set glass=dark --set width=80*mm -- my.png

local o = options { picture = "../../assets/pictures/heart.png", glass = "light",
                    width = 60*mm, height = 60*mm, pull = 1.2e9, seed = 3, spacing = 0.25*mm, time = 50*us }
local given = ... -- a name on the command line is relative to the current folder, not to this script
local picture = given or o.picture

local p = plate { width = o.width, height = o.height, material = "duran50" }
p:mask       { picture, remove = o.glass == "light" and "dark" or "light" }
p:strength   { modulus = 15, correlation = 1.5*mm, seed = math.tointeger(o.seed) }
p:body_force { force = function(x) return x > o.width/2 and o.pull or -o.pull, 0 end }

local s = simulate(p, { spacing = o.spacing })
s:movie { "own_picture.mp4", every = 0.25*us, width = 800 }
s:run(o.time)
s:frame { "own_picture.png", width = 800 }
print(#s:fragments() .. " fragments")
print(s:report())

if o.picture == "../../assets/pictures/heart.png" and not given then
  expect { "lowest point of the left branch", unit = "m", max = 14*mm, source = "earlier run of this scene",
           got = s:cracks { from = {15*mm, 10*mm}, to = {25*mm, 40*mm} }.bottom }
  expect { "right end of the right branch", unit = "m", min = 42*mm, source = "earlier run of this scene",
           got = s:cracks { from = {35*mm, 12*mm}, to = {50*mm, 40*mm} }.right }
end
