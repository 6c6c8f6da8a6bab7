-- handbook.lua: the ready specimens against the handbooks: displacement of the gauges, and K.
--
-- K is that of the strain energies of two crack lengths. With corrected surfaces on a coarse lattice, and extrapolated to no
-- horizon from two lattices: the error is of the first order in the horizon, so twice the finer value less the coarser one.
-- Expected: bars and beams without a crack to 3 %; extrapolated, displacements to 3 % and K to 1.5 %.
--
--   hackle run scripts/validation/handbook.lua
--   hackle validate --quick handbook

local o = options { quick = false }
local solve = require("specimens.parts").solve

local specimens = {
  { "dog_bone", 0.5*mm, "ASTM D638", quick = true },
  { "three_point_bend", 0.2*mm, "Timoshenko; ASTM C1161", quick = true },
  { "compact_tension", 1*mm, "ASTM E399, E1820" },
  { "single_edge_bend", 0.5*mm, "ASTM E399, E1820" },
  { "double_cantilever", 1*mm, "ASTM D3433" },
  { "plate_with_pins", 1*mm, "ASTM E647; Tada", tips = 2 },
  { "brazilian_disc", 0.5*mm, "Hondros; ASTM D3967", quadrature = "area" },
}

local function solved(entry, refinement, surface)
  local numerics = { spacing = entry[2]/refinement, quadrature = entry.quadrature, surface = surface }
  local measured, K, at = solve(require("specimens." .. entry[1]), {}, numerics, entry.tips)
  return measured/at.displacement, at.K and K/at.K
end

for _, entry in ipairs(specimens) do
  local name, source = entry[1], entry[3]
  if entry.quick then
    expect { name .. ": displacement over the handbook's, surfaces corrected", got = solved(entry, 1, "energy"), value = 1, tolerance = 0.03,
             source = source }
  end
  if not o.quick then
    local coarse, coarse_K = solved(entry, 1)
    local fine, fine_K = solved(entry, 2)
    expect { name .. ": displacement over the handbook's, extrapolated", got = 2*fine - coarse, value = 1, tolerance = 0.03, source = source }
    if fine_K then
      expect { name .. ": K over the handbook's, extrapolated", got = 2*fine_K - coarse_K, value = 1, tolerance = 0.015, source = source }
    end
  end
end
