-- fork_spread.lua: how far the fork of the paper's first plate moves when the horizon or the lattice changes.
--
-- Prints a row for each: the table "How far a fork can be trusted" of tests/README.md.
--
--   hackle run tests/verification/fork_spread.lua

local o = options { load = 12*MPa }

local function plate_with(horizon, m)
  local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
  p:crack    { from = {0, 20*mm}, to = {50*mm, 20*mm} }
  p:traction { edge = "top",    stress = {0,  o.load} }
  p:traction { edge = "bottom", stress = {0, -o.load} }
  p:nofail   { edge = "top",    depth = 2*mm }
  p:nofail   { edge = "bottom", depth = 2*mm }
  return simulate(p, { spacing = horizon/m, horizon = horizon })
end

print("| horizon | m | fork at | seen at | tips at 32 us |\n|---|---|---|---|---|")
for _, horizon in ipairs { 4*mm, 2*mm, 1*mm, 0.5*mm } do
  for _, m in ipairs { 3, 4, 6 } do
    local s, seen = plate_with(horizon, m)
    s:on { "every", every = 0.25*us, call = function(t) if not seen and s:cracks().fork then seen = t end end }
    s:run(32*us)
    local cracks = s:cracks()
    print(("| %g mm | %d | %.1f mm | %.2f us | %.1f mm |"):format(
      horizon/mm, m, (cracks.fork or 0)/mm, (seen or 0)/us, cracks.right/mm))
    s:close()
  end
end
