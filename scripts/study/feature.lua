-- feature.lua: a plate with one feature, for hackle study features to measure what it costs.
--
-- A crack under a load that is too small for it to run, so that all features are measured on the same motion.
--
--   hackle run scripts/study/feature.lua --set feature=contact --set steps=200
local o = options { feature = "none", steps = 100, spacing = 0.5*mm, round = 1 }
local w, h = 100*mm, 40*mm
local glass = { like = "duran50" }
local numerics = { spacing = o.spacing }
local at_plate, at_run = function() end, function() end
local every = 10  -- steps between the frames and records of an output

local features = {
  none = function() end,
  -- What is there, but not used: it must cost nothing.
  alpha_0 = function() glass.alpha = 0 end,
  damping_0 = function() at_plate = function(p) p:damping { rate = 0 } end end,
  fidelity_0 = function() numerics.fidelity = 0 end,
  -- In the kernel.
  alpha = function() glass.alpha = 0.25 end,
  scatter = function() at_plate = function(p) p:strength { modulus = 10 } end end,
  no_fail = function() at_plate = function(p) p:nofail { edge = "top", depth = 2*mm } end end,
  inclusion = function() at_plate = function(p) p:inclusion { material = material { like = "duran50", E = 130e9 }, centre = { 70*mm, 20*mm }, radius = 5*mm } end end,
  graded = function() at_plate = function(p) p:grade { E = function(x) return (60 + 100*x)*GPa end, levels = 16 } end end,
  surface = function() numerics.surface = "energy" end,
  area = function() numerics.quadrature = "area" end,
  conical = function() numerics.micromodulus = "conical" end,
  f32 = function() numerics.precision = "f32" end,
  fused = function() numerics.fused = true end,
  fidelity = function() numerics.fidelity = 0.5 end,
  next_step = function() numerics.breaking = "next_step" end,
  -- Beside the kernel.
  damping = function() at_plate = function(p) p:damping { rate = 1e4 } end end,
  stiffness_damping = function() at_plate = function(p) p:damping { stiffness = 1e-9 } end end,
  heat = function() glass.alphaT = 3e-6 at_plate = function(p) p:temperature { change = 1 } end end,
  heating = function() glass.alphaT = 3e-6 at_plate = function(p) p:temperature { change = 1, time = ramp(1e-3) } end end,
  late_load = function() at_plate = function(p) p:traction { edge = "right", stress = { 1, 0 }, time = step_at(1e9) } end end,
  load_function = function() at_plate = function(p) p:traction { edge = "right", stress = { 1e5, 0 }, time = function(t) return t/us end } end end,
  clamp = function() at_plate = function(p) p:clamp { edge = "left", depth = 2*mm } end end,
  foundation = function() at_plate = function(p) p:foundation { stiffness = 1e10 } end end,
  absorb = function() at_plate = function(p) p:absorb { edge = "right" } end end,
  contact = function() at_plate = function(p) p:contact {} end end,
  impact = function() at_plate = function(p) p:impactor { centre = { 110*mm, 20*mm }, radius = 5*mm, velocity = { -10, 0 } } end end,
  platen = function() at_plate = function(p) p:platen { from = { 0, 40.1*mm }, to = { 100*mm, 50*mm }, velocity = { 0, -0.01 } } end end,
  -- What a run leaves behind.
  log_steps = function() at_run = function(s) s:log { "feature.csv", every = 1e-12, "tip.x", "bonds" } end end,
  log_energy = function() at_run = function(s) s:log { "feature.csv", every = every*s.dt, "kinetic", "strain" } end end,
  callback = function() at_run = function(s) s:on { "every", every = 1e-12, call = function() end } end end,
  record = function() at_run = function(s) s:record { "feature.h5", steps = every } end end,
  movie = function() at_run = function(s) s:movie { "feature.mp4", field = "damage", every = every*s.dt, width = 640 } end end,
  gif = function() at_run = function(s) s:movie { "feature.gif", field = "damage", every = every*s.dt, width = 640 } end end,
  picture = function() at_run = function(s) s:frame { "feature.png", field = "damage", width = 640 } end end,
  stress_picture = function() at_run = function(s) s:frame { "feature.png", field = "stress_1", width = 640 } end end,
}
if not features[o.feature] then error("there is no feature '" .. o.feature .. "'") end
features[o.feature]()

local p = plate { width = w, height = h, material = material(glass) }
p:crack { from = { 0, 20*mm }, to = { 50*mm, 20*mm } }
p:traction { edge = "top", stress = { 0, 1*MPa } }
p:traction { edge = "bottom", stress = { 0, -1*MPa } }
at_plate(p)
local s = simulate(p, numerics)
at_run(s)
if o.steps > 0 then s:step(o.steps) end
