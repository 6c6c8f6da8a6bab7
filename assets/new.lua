-- A plate of glass with a crack at its left edge, pulled apart: change it into yours.
--
--   hackle check FILE            what it takes, and whether anything can break
--   hackle run FILE              a movie and a picture in out/<name of the file>
--   hackle run FILE --set load=24*MPa --set time=20*us
--   hackle run FILE --help       the options below

-- What --set may change, with its defaults.
local o = options {
  load = 12*MPa,       -- stress on the top and bottom edge
  crack = 50*mm,       -- length of the crack
  spacing = 0.5*mm,    -- of the lattice: half of it takes eight times as long
  time = 32*us,        -- how much is simulated
}

-- The plate, free of any lattice. The origin is its lower left corner. help(plate) lists what else
-- can be put on it: holes, notches, inclusions, other loads ...
local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
p:crack { from = {0, 20*mm}, to = {o.crack, 20*mm} }
for edge, sign in pairs { top = 1, bottom = -1 } do
  p:traction { edge = edge, stress = {0, sign*o.load} }
  p:nofail { edge = edge, depth = 4*mm }   -- or corners break off where the load begins
end

-- The lattice and what to leave behind.
local s = simulate(p, { spacing = o.spacing })
s:movie { "breaks.mp4", every = o.time/64 }

s:run(o.time)

s:frame { "broken.png" }
print(s:report())
