-- pictures.lua: four views of one plate. It made assets/gallery/pictures.png:
--
--   hackle run scripts/pictures.lua && cp out/pictures/pictures.png assets/gallery/

local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
for edge, pull in pairs { top = 12*MPa, bottom = -12*MPa } do
  p:traction { edge = edge, stress = {0, pull} }:nofail { edge = edge, depth = 2*mm }
end

local s = simulate(p, { spacing = 0.25*mm, horizon = 1*mm })
s:run(12*us)
s:frame { "fringes.png", field = "fringes", width = 640 }
s:run(18*us)
s:frame { "opened.png", field = "stress_1", deformed = true, magnify = 20, width = 640 }
s:frame { "halves.png", field = "damage", second = "speed", second_range = {0, 10}, width = 640 }
s:frame { "lattice.png", field = "damage", bonds = true, zoom = {73*mm, 25*mm, 2.5*mm}, width = 640 }

contact_sheet {
  "pictures.png", columns = 2, width = 420,
  pictures = { "fringes.png", "opened.png", "halves.png", "lattice.png" },
  titles = { 'field = "fringes"', 'field = "stress_1", deformed = true', 'second = "speed"', "bonds = true, zoom = ..." },
}
