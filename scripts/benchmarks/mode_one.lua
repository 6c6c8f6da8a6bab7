-- mode_one.lua: a crack opened from both sides runs straight, at a speed below c_R.
--
-- A square of 100 mm with a crack to its middle; its loaded edges move apart at 0.1 m/s each
-- (the mode I job of Peridynamics.jl: E 32 GPa, rho 2500 kg/m3, G0 100 J/m2, horizon 3.015 spacings, 300 us).
-- Acceptance: between 10 and 35 mm beyond the middle the tip moves at 0.4 to 1.0 c_R, at most 2 spacings off
-- the axis, at most one back; 60 nodes per side instead of 45 change the speed by less than 20 %.
-- The tip is the farthest node that has lost more than 0.35 of its bonds, found every microsecond.
-- Expected: the first three hold. The fourth does not: a speed fitted over 25 mm changes by 27 %, and by 20 to 27 %
-- at other steps; 45 nodes are 22 for the crack, with a horizon of three.
--
--   hackle run scripts/benchmarks/mode_one.lua

local o = options { nodes = 60, coarse = 45, speed = 0.1 }

local function solve(nodes, picture)
  local dx = 100*mm/nodes
  local p = plate { width = 100*mm, height = 100*mm,
                    material = material { name = "mode I", E = 32*GPa, rho = 2500, nu = 0.33, G0 = 100 } }
  p:crack { from = {0, 50*mm}, to = {50*mm, 50*mm} }
  for edge, speed in pairs { top = o.speed, bottom = -o.speed } do
    p:move { edge = edge, depth = dx, velocity = {0, speed}, axis = "y" }:nofail { edge = edge, depth = 4*dx }
  end
  local s = simulate(p, { spacing = dx, horizon = 3.015*dx })
  local run = { dx = dx, back = 0, tip = 0, off = 0, through = false }
  local n, t_sum, x_sum, tt_sum, tx_sum = 0, 0, 0, 0, 0 -- of the tip between 60 and 85 mm
  while s.time < 300*us do
    s:run(1*us)
    local c = s:cracks { from = {51*mm, 10*mm}, to = {100*mm, 90*mm} }
    local tip = c.nodes > 0 and c.right or 0
    run.back = math.max(run.back, run.tip - tip)
    run.tip = tip
    if tip >= 60*mm and tip <= 85*mm then
      n, t_sum, x_sum = n + 1, t_sum + s.time, x_sum + tip
      tt_sum, tx_sum = tt_sum + s.time^2, tx_sum + s.time*tip
    end
    if not run.through and tip >= 85*mm then
      run.through = true
      local near = s:cracks { from = {51*mm, 10*mm}, to = {85*mm, 90*mm} }
      run.off = math.max(near.top - 50*mm, 50*mm - near.bottom)
      if picture then s:frame { picture, width = 800 } end
    end
  end
  assert(run.through, "the crack does not run through")
  run.v = (n*tx_sum - t_sum*x_sum)/(n*tt_sum - t_sum^2) -- by least squares
  return run, s
end

local fine, s = solve(o.nodes, "mode_one.png")
local coarse = solve(o.coarse)
local c_R = math.sqrt(32*GPa/(2*(1 + 1/3))/2500)*(0.862 + 1.14/3)/(1 + 1/3)
local function say(what, value, holds)
  print(string.format("%-34s %-12s %s", what, value, holds and "holds" or "FAILS"))
end
say("0.4 < v/c_R < 1.0", string.format("%.2f", fine.v/c_R), fine.v > 0.4*c_R and fine.v < c_R)
say("off the axis, spacings (<= 2)", string.format("%.1f", fine.off/fine.dx), fine.off <= 2*fine.dx)
say("back, spacings (<= 1)", string.format("%.1f", fine.back/fine.dx), fine.back <= 1.001*fine.dx)
say("45 to 60 nodes, change of v (< 0.2)", string.format("%.3f", math.abs(1 - coarse.v/fine.v)),
    math.abs(1 - coarse.v/fine.v) < 0.2)
print(s:report())

local source = "acceptance of Peridynamics.jl's mode I job"
expect { "speed over c_R", got = fine.v/c_R, min = 0.4, max = 1, source = source }
expect { "off the axis, in spacings", got = fine.off/fine.dx, max = 2, source = source }
expect { "back, in spacings", got = fine.back/fine.dx, max = 1.001, source = source }
expect { "change of speed from 45 to 60 nodes", got = math.abs(1 - coarse.v/fine.v), max = 0.2, source = source,
         reason = "45 nodes are 22 for the crack, with a horizon of three" }
