-- contact_sheet.lua: one picture of all ready-made scenes, from their output in out/. It made
-- assets/scenes.png:
--
--   for scene in scripts/samples/*.lua scripts/benchmarks/*.lua scripts/gallery/*.lua; do hackle run $scene; done
--   hackle run scripts/contact_sheet.lua --output out && cp out/scenes.png assets/
--
-- A scene that has not been run yet is left out; single_bond, patch_test and ring_pulse print only numbers.

local o = options { file = "scenes.png", columns = 4, width = 300 }

-- Name of the scene, and of its picture if that differs.
local scenes = {
  { "edge_crack" }, { "edge_crack_24mpa" }, { "centre_crack" }, { "hole" }, { "hole_and_crack" },
  { "soda_lime_ladder", "4.0_MPa" }, { "borden" }, { "kalthoff" }, { "homalite" }, { "inclusion" },
  { "random_cracks" }, { "mode_one" },
  { "quench" }, { "heterogeneous" }, { "ring" }, { "two_holes" }, { "own_picture" }, { "shatter" },
}

local pictures, titles = {}, {}
for _, scene in ipairs(scenes) do
  local name, picture = scene[1], scene[2] or scene[1]
  local path = string.format("%s/%s.png", name, picture)
  local file = io.open(path, "rb")
  if file then
    file:close()
    pictures[#pictures + 1], titles[#titles + 1] = path, name
  else
    print("left out: " .. name)
  end
end
contact_sheet { o.file, pictures = pictures, titles = titles, columns = o.columns, width = o.width }
