-- load_displacement.lua: load against displacement of a bar with an edge crack, slowly and with speed.
--
-- A bar with an edge crack is pulled by two grips. First slowly: every increment is in equilibrium, and the bar
-- breaks at once when the crack starts. Then the same bar is pulled apart at 1 m/s. Two tables tell the force on
-- the upper grip, the opening of the crack at its mouth, the strain of a gauge ahead of it, and where its tip is;
-- a chart shows load against displacement of both.
-- Expected: the force rises with the displacement up to the same load and falls to nothing; the crack opens.
--
--   hackle run scripts/gallery/load_displacement.lua

local p = plate { width = 20*mm, height = 60*mm, material = "pmma" }
p:crack { from = {0, 30*mm}, to = {6*mm, 30*mm} }
p:clamp { edge = "bottom", depth = 4*mm }

local cmod = gauge { "opening", from = {0.5*mm, 29*mm}, to = {0.5*mm, 31*mm}, name = "cmod" }
local ahead = gauge { "strain", from = {12*mm, 28*mm}, to = {12*mm, 32*mm}, name = "ahead" }

local function bar()
  return simulate(p, { spacing = 1*mm, horizon = 4*mm, surface = "energy" })
end

local slow = bar()
slow:move { edge = "top", depth = 4*mm, displacement = {0, 0.4*mm}, time = {{0, 0}, {1, 1}}, name = "grip" }
slow:log { "slow.csv", "grip.fy", "grip.uy", cmod, ahead, "tip.x", "bonds" }
slow:quasistatic { duration = 1, increments = 20 }

local fast = bar()
fast:move { edge = "top", depth = 4*mm, velocity = {0, 1}, time = ramp(50*us), name = "grip" }
fast:log { "fast.csv", every = 2*us, "grip.fy", "grip.uy", cmod, ahead, "tip.x", "tip.speed", "bonds" }
fast:run(400*us)

chart { "load_displacement.png", "load", of = { slow, fast }, names = { "slow", "1 m/s" } }
print(slow:report())
print(fast:report())

expect { "force on the grip of the broken bar over E", unit = "m", got = math.abs(slow:reaction("grip").fy)/3.09e9, max = 1e-6,
         source = "nothing bears it" }
for name, s in pairs { slowly = slow, fast = fast } do
  expect { "broken bonds, " .. name, got = s.damage.broken_bonds, min = 200, source = "the bar is through" }
end
