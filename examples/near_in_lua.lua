-- Four drones, positions in metres: which are closer than 100 m to another one, and how close? By the
-- foreign-function interface of LuaJIT. What is declared is copied from beespace.h, whose structures
-- say how large they are: a later library takes them as they are here.
local ffi = require("ffi")

ffi.cdef [[
typedef struct { size_t struct_size; int32_t code, reserved; int64_t record; char place[32];
                 char message[512]; } beespace_error;
typedef struct { size_t struct_size; int32_t type, reserved; int64_t count; const void *x, *y, *z;
                 ptrdiff_t x_stride, y_stride, z_stride; } beespace_points;
typedef struct { size_t struct_size; uint32_t flags, reserved; double threshold_m, vertical_m;
                 uint64_t max_results; } beespace_search;
typedef struct beespace_result beespace_result;
beespace_result* beespace_result_create(void);
void beespace_result_free(beespace_result* result);
int64_t beespace_result_size(const beespace_result* result);
const int64_t* beespace_result_first(const beespace_result* result);
const int64_t* beespace_result_second(const beespace_result* result);
const double* beespace_result_distances_m(const beespace_result* result);
int32_t beespace_pairs(void* engine, const beespace_points* points, const beespace_points* others,
                       const beespace_search* search, const void* run, beespace_result* result,
                       beespace_error* error);
]]
local beespace = ffi.load("libbeespace.so.1")
local DISTANCES = 8

-- Structures begin with their size; all that is not named is zero.
local function new(kind, fields)
  local made = ffi.new(kind)
  made.struct_size = ffi.sizeof(kind)
  for name, value in pairs(fields or {}) do made[name] = value end
  return made
end

-- Pairs of points that are closer than the threshold: a list of {first, second, metres}.
local function near(xyz, threshold_m)
  local coordinates = ffi.new("double[?]", #xyz, xyz) -- must live as long as the call
  local points = new("beespace_points", {
    count = #xyz / 3, x = coordinates, y = coordinates + 1, z = coordinates + 2,
    x_stride = 24, y_stride = 24, z_stride = 24,
  })
  local search = new("beespace_search", { flags = DISTANCES, threshold_m = threshold_m })
  local wrong = new("beespace_error")
  local result = ffi.gc(beespace.beespace_result_create(), beespace.beespace_result_free)
  if beespace.beespace_pairs(nil, points, nil, search, nil, result, wrong) ~= 0 then
    error(ffi.string(wrong.message), 0)
  end
  local first, second = beespace.beespace_result_first(result), beespace.beespace_result_second(result)
  local metres = beespace.beespace_result_distances_m(result)
  local found = {}
  for i = 0, tonumber(beespace.beespace_result_size(result)) - 1 do
    found[#found + 1] = { tonumber(first[i]), tonumber(second[i]), metres[i] }
  end
  beespace.beespace_result_free(ffi.gc(result, nil)) -- not before its columns are read
  return found
end

local drones = { 0, 0, 50,  80, 60, 50,  300, 0, 50,  300, 0, 149.9 }
for _, pair in ipairs(near(drones, 100)) do
  print(("%d and %d are %.1f m apart"):format(unpack(pair)))
end
print(select(2, pcall(near, { 0, 0, math.huge }, 100)))
