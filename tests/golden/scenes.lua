-- scenes.lua: small plates that together use every kind of kernel, load and accuracy. Prints the hash of the
-- final state of each; hashes.txt keeps what every compiler and level of optimisation must print.
--
--   tests/golden/run.sh build/release/bin/hackle

local glass = material { like = material "duran50", alphaT = 3.3e-6 }
-- With a history: bonds become stronger where the plate is compressed.
local toughened = material { like = glass, alpha = 0.25 }

local function plate_with(more, of)
  local p = plate { width = 40*mm, height = 20*mm, material = of or glass }
  p:crack { from = {0, 10*mm}, to = {16*mm, 10*mm} }
  for edge, pull in pairs { top = 24*MPa, bottom = -24*MPa } do
    p:traction { edge = edge, stress = {0, pull} }
  end
  if more then more(p) end
  return p
end

local function guarded(p)
  for _, edge in ipairs { "top", "bottom" } do p:nofail { edge = edge, depth = 2*mm } end
end

local function inclusions(p)
  guarded(p)
  p:inclusion { material = "maraging_steel", centre = {28*mm, 12*mm}, radius = 3*mm }
  p:inclusion { material = "pmma", centre = {24*mm, 5*mm}, radii = {4*mm, 2*mm}, angle = 30*deg }
end

local function heated(p)
  p:temperature { change = function(x, y) return 80*(1 - x/(40*mm)) end, time = ramp(4*us) }
end

local function uneven(p)
  p:strength { modulus = 8, correlation = 1*mm, seed = 3 }
  p:random_cracks { count = 6, length = {1*mm, 3*mm}, seed = 2, from = {20*mm, 0}, to = {40*mm, 20*mm} }
end

local function shot(p)
  p:contact {}
  p:impactor { centre = {44.05*mm, 10*mm}, radius = 4*mm, velocity = {-60, 0} }
  p:damping { rate = 2e4 }
end

local function all(p)
  inclusions(p)
  heated(p)
  uneven(p)
end

local function tell(name, s) print(("%-28s %s"):format(name, s.hash)) end

for _, precision in ipairs { "f64", "f32" } do
  local function state(name, p, numerics)
    numerics = numerics or {}
    numerics.precision, numerics.spacing = precision, 0.5*mm
    local s = simulate(p, numerics)
    s:run(12*us)
    tell(name .. " " .. precision, s)
  end
  for _, of in ipairs { glass, toughened } do
    local history = of == toughened and ", history" or ""
    state("plain" .. history, plate_with(nil, of))
    state("guarded" .. history, plate_with(guarded, of))
    state("uneven" .. history, plate_with(uneven, of))
    state("inclusions" .. history, plate_with(inclusions, of))
    state("heated" .. history, plate_with(heated, of))
    state("all" .. history, plate_with(all, of))
  end
  state("shot", plate_with(shot))
  state("linearised", plate_with(), { fidelity = 0.5 })
  state("wide", plate_with(), { horizon = 3*mm, quadrature = "centroid", micromodulus = "conical" })
  state("area", plate_with(), { horizon = 1.6*mm, quadrature = "area", constants = "continuum" })
  state("ramp", plate_with(), { quadrature = "ramp", breaking = "next_step" })
end

local s = simulate(plate_with(heated), { spacing = 0.5*mm })
s:relax {}
s:run(4*us)
tell("relaxed f64", s)
