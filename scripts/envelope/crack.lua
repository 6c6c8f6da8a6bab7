-- crack.lua: cracks of no length, through everything, and thousands of them.
--
-- What a plate begins with, before it is pulled for 150 steps.
-- Expected: momentum = force times time, whatever hangs together.
--
--   hackle run scripts/envelope/crack.lua --set kind=random --set count=10000
local parts = require "envelope.parts"
local o = options { kind = "none", count = 1, precision = "f64", born = "broken", m = 4 }
local dx, nx, ny = 1*mm, 40, 30
local p = plate { width = nx*dx, height = ny*dx, material = parts.glass() }
local w, h = nx*dx, ny*dx
local kinds = {
  none = function() end,
  through = function() p:crack { from = { 0, 0.5*h }, to = { w, 0.5*h }, born = o.born } end,
  diagonal = function() p:crack { from = { 0, 0 }, to = { w, h }, born = o.born } end,
  point = function() p:crack { from = { 5*dx, 5*dx }, to = { 5*dx, 5*dx } } end,
  short = function() p:crack { from = { 5*dx, 5*dx }, to = { 5*dx + 1e-12, 5*dx } } end,
  on_nodes = function() p:crack { from = { 0.5*dx, 5.5*dx }, to = { 20.5*dx, 5.5*dx }, born = o.born } end,
  grid = function()
    for k = 1, nx - 1 do p:crack { from = { k*dx, 0 }, to = { k*dx, h }, born = o.born } end
    for k = 1, ny - 1 do p:crack { from = { 0, k*dx }, to = { w, k*dx }, born = o.born } end
  end,
  random = function() p:random_cracks { count = o.count, length = { 1*dx, 10*dx }, born = o.born } end,
  outside = function() p:crack { from = { 2*w, 0 }, to = { 3*w, 0 } } end,
  around = function() p:crack { centre = { 0.5*w, 0.5*h }, radius = 10*dx, angles = { 0, 2*math.pi }, born = o.born } end,
}
kinds[o.kind]()
p:traction { edge = "top", stress = { 0, 20*MPa } }
local s = simulate(p, { spacing = dx, horizon = o.m*dx, precision = o.precision })
s:step(150)
local sum = parts.sums(s, nx, ny)
local impulse = 20*MPa*w*150*s.dt/(2235*dx*dx)
parts.near("momentum along y over force times time", sum.py/impulse, 1, 1e3*parts.rounding[o.precision], "Newton")
