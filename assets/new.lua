-- A plate of glass with a crack at its left edge, pulled apart: change it as you like.
--
--   hackle check FILE            estimates its cost, and whether anything can break
--   hackle run FILE              makes a movie and a picture in out/<name of the file>
--   hackle run FILE --set load=24*MPa --set time=20*us
--   hackle run FILE --help       lists the options below

-- Options that --set may change, with their defaults.
local o = options {
  load = 12*MPa,       -- stress on the top and bottom edge
  crack = 50*mm,       -- length of the crack
  spacing = 0.5*mm,    -- of the lattice: half the spacing takes eight times as long
  time = 32*us,        -- simulated time
}

-- The plate, without any lattice. Its lower left corner is the origin. help(plate) lists everything
-- that can be added: holes, notches, inclusions, other loads ...
local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
p:crack { from = {0, 20*mm}, to = {o.crack, 20*mm} }
for edge, sign in pairs { top = 1, bottom = -1 } do
  p:traction { edge = edge, stress = {0, sign*o.load} }
  p:nofail { edge = edge, depth = 4*mm }   -- otherwise corners break off where the load begins
end

-- The lattice and the output.
local s = simulate(p, { spacing = o.spacing })
s:movie { "breaks.mp4", every = o.time/64 }

s:run(o.time)

s:frame { "broken.png" }
print(s:report())
