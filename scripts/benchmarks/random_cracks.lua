-- random_cracks.lua: a plate full of small cracks, from a seed, pulled apart.
--
-- Expected: cracks that lie across the load grow and join; the picture is the same on every machine.
--
--   hackle run scripts/benchmarks/random_cracks.lua --set seed=2

local o = options { seed = 1, load = 10*MPa, spacing = 0.5*mm, horizon = 2*mm }

local p = plate { width = 100*mm, height = 100*mm, material = "duran50" }
p:random_cracks { count = 40, length = {5*mm, 15*mm}, seed = math.tointeger(o.seed),
                  from = {5*mm, 10*mm}, to = {95*mm, 90*mm} }
for edge, pull in pairs { top = o.load, bottom = -o.load } do
  p:traction { edge = edge, stress = {0, pull} }:nofail { edge = edge, depth = o.horizon }
end

local s = simulate(p, { spacing = o.spacing, horizon = o.horizon })
s:movie { "random_cracks.mp4", every = 0.5*us, width = 800 }
s:run(60*us)
s:frame { "random_cracks.png", width = 800 }
print(s:report())

if o.seed == 1 then
  local free = 0
  for x = 0.25*mm, 99.8*mm, 0.5*mm do
    if s:cracks { from = {x - 0.1*mm, 0}, to = {x + 0.1*mm, 1} }.nodes == 0 then free = free + 1 end
  end
  expect { "columns of nodes without a crack", got = free, value = 0, source = "cracks across the load grow and join" }
end
