-- fracture_table.lua: errors of J and K against closed forms and handbooks, as a table in Markdown.
--
-- A clamped strip (Rice 1967: J = C11 e^2 H/2, H between the nodes that are held), a crack in the middle of a plate in
-- tension (Tada: sec(pi a/W)^(1/2) (1 - 0.025 (2a/W)^2 + 0.06 (2a/W)^4)), the same askew by 45 degrees to the load, the
-- compact tension specimen (ASTM E399) and the double cantilever (Srawley and Gross 1966). `n` is the number of nodes
-- of the ligament: of the strip, its free height; of the askew crack, its half length. The table: tests/README.md.
--
--   hackle run tests/verification/fracture_table.lua -q

local o = options { m = 3, coarse = 20, halvings = 1, surface = "energy", quadrature = "full" }

local function solved(p, dx)
  local s = simulate(p, { spacing = dx, horizon = o.m*dx, surface = o.surface, quadrature = o.quadrature })
  s:relax { tolerance = 1e-8 }
  return s
end

local function error_of(value, wanted)
  return value and string.format("%+.1f", 100*(value/wanted - 1)) or "-"
end

local function row(name, n, f, K)
  print(string.format("| %s | %d | %s | %s | %s | %s | %.2f |", name, n, error_of(f.K_J, K), error_of(f.K_I, K),
                      error_of(f.williams_K_I, K), f.K_II and string.format("%+.1f", 100*f.K_II/K) or "-", 100*f.spread))
end

local function strip(n)
  local dx = 20*mm/n
  local grip, H = o.m*dx, 20*mm
  local p = plate { width = 5*H, height = H + 2*grip, material = "duran50" }
  p:crack { from = {0, H/2 + grip}, to = {2.5*H, H/2 + grip} }
  for edge, sign in pairs { top = 1, bottom = -1 } do
    p:move { edge = edge, depth = grip, displacement = {0, sign*0.1*um} }
  end
  local s = solved(p, dx)
  local E, nu = s.E, s.nu
  local J = E/(1 - nu^2)*(0.2*um)^2/(H + dx)/2
  local f = s:fracture()
  row("clamped strip", n, f, f.K_J*math.sqrt(J/f.J))
end

local function centre_crack(n)
  local a, dx = 10*mm, 10*mm/n
  local W = 4*a
  local p = plate { width = W, height = 1.5*W, material = "duran50" }
  p:crack { from = {W/2 - a, 0.75*W}, to = {W/2 + a, 0.75*W} }
  for edge, sign in pairs { top = 1, bottom = -1 } do p:traction { edge = edge, stress = {0, sign*1*MPa} } end
  local x = 2*a/W
  row("centre crack", n, solved(p, dx):fracture(),
      1*MPa*math.sqrt(math.pi*a/math.cos(math.pi*x/2))*(1 - 0.025*x^2 + 0.06*x^4))
end

local function specimen(name, dimensions, dx, n)
  local p, at = require("specimens." .. name)(dimensions)
  row(name, n, solved(p, dx):fracture { tip = at.tip, direction = {1, 0} }, at.K)
end

print("| body | n | K_J | K_I, interaction | K_I, Williams | K_II | spread of J |")
print("| --- | --- | --- | --- | --- | --- | --- |")
for k = 0, o.halvings do
  local n = math.floor(o.coarse*2^k)
  strip(n)
  centre_crack(n)
  specimen("compact_tension", { W = 40*mm }, 20*mm/n, n)
  specimen("double_cantilever", { h = 12*mm, a = 48*mm }, 12*mm/n, n)
end
