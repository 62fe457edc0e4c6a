#include "vtp_file.h"

#include "fmt/format.h"
#include "platform.h"

#include <algorithm>
#include <cstring>

namespace SPHTM_NS {

namespace {

constexpr int64_t HEADER = sizeof(uint64_t);    // how many bytes follow, before each block
constexpr int64_t PIECE = 65536;                // values that are converted at a time
const char *const TYPE_NAMES[] = {"Int32", "Int64", "Float32", "Float64"};
const char *const PLACE_NAMES[] = {"PointData", "CellData", "Points", "Verts"};

int64_t bytes_of(VtpFile::Type type) { return type == VtpFile::INT64 || type == VtpFile::FLOAT64 ? 8 : 4; }

template <class NUMBER> void store(char *to, int64_t k, double value)
{
  const NUMBER n = (NUMBER) value;
  std::memcpy(to + k * sizeof n, &n, sizeof n);
}

void store(VtpFile::Type type, char *to, int64_t k, double value)
{
  switch (type) {
    case VtpFile::INT32: return store<int32_t>(to, k, value);
    case VtpFile::INT64: return store<int64_t>(to, k, value);
    case VtpFile::FLOAT32: return store<float>(to, k, value);
    case VtpFile::FLOAT64: return store<double>(to, k, value);
  }
}

bool is_little_endian()
{
  const uint16_t one = 1;
  return *(const unsigned char *) &one == 1;
}

}    // namespace

std::string xml_text(const std::string &plain)
{
  std::string text;
  for (const char c : plain)
    text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
  return text;
}

void VtpFile::add(const Array &a, int64_t tuples)
{
  blocks.push_back({a, tuples, size + HEADER});
  size += HEADER + tuples * a.components * bytes_of(a.type);
}

void VtpFile::begin(const std::vector<Array> &arrays, double time)
{
  blocks.clear();
  size = 0;
  for (const Array &a : arrays) add(a, a.place == CELL_DATA && triangles ? triangles : points);
  corners = blocks.size();
  const Type index = std::max(points, 3 * triangles) > INT32_MAX ? INT64 : INT32;
  add({CELLS, "connectivity", index, triangles ? 3 : 1}, triangles ? triangles : points);
  add({CELLS, "offsets", index, 1}, triangles ? triangles : points);
  write_xml(time);
  data = LAMMPS_NS::platform::ftell(file);
  for (const Block &b : blocks) {
    const uint64_t bytes = b.tuples * b.array.components * bytes_of(b.array.type);
    LAMMPS_NS::platform::fseek(file, data + b.at - HEADER);
    fwrite(&bytes, sizeof bytes, 1, file);
  }
  if (!triangles) put_sequence(corners, 0, 1);
  put_sequence(corners + 1, triangles ? 3 : 1, triangles ? 3 : 1);
}

void VtpFile::write_xml(double time) const
{
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}Endian\" header_type=\"UInt64\">\n"
      "  <PolyData>\n    <FieldData>\n      <DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n    </FieldData>\n    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" "
      "NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
      is_little_endian() ? "Little" : "Big", time, points, triangles ? 0 : points, triangles);
  for (const Place place : {POINT_DATA, CELL_DATA, POINTS, CELLS}) {
    const std::string name = place == CELLS && triangles ? "Polys" : PLACE_NAMES[place];
    text += fmt::format("      <{}>\n", name);
    for (const Block &b : blocks) {
      if (b.array.place != place) continue;
      const int components = place == CELLS ? 1 : b.array.components;    // of cells: one list
      text += fmt::format("        <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" "
                          "offset=\"{}\"/>\n",
                          TYPE_NAMES[b.array.type], xml_text(b.array.name), components, b.at - HEADER);
    }
    text += fmt::format("      </{}>\n", name);
  }
  text += "    </Piece>\n  </PolyData>\n  <AppendedData encoding=\"raw\">\n   _";
  fwrite(text.data(), 1, text.size(), file);
}

// from room
void VtpFile::put_bytes(const Block &b, int64_t first_value, int64_t values)
{
  const int64_t each = bytes_of(b.array.type);
  LAMMPS_NS::platform::fseek(file, data + b.at + first_value * each);
  fwrite(room.data(), each, values, file);
}

void VtpFile::put(size_t array, int64_t first, int64_t count, const double *rows, int row_length,
                  const std::vector<int> &columns)
{
  const Block &b = blocks[array];
  const int64_t wide = b.array.components, piece = PIECE / wide;
  room.resize(PIECE * sizeof(double));
  for (int64_t done = 0; done < count; done += piece) {
    const int64_t n = std::min(piece, count - done);
    int64_t k = 0;
    for (int64_t i = done; i < done + n; i++)
      for (const int column : columns)
        store(b.array.type, room.data(), k++, column < 0 ? 0.0 : rows[i * row_length + column]);
    put_bytes(b, (first + done) * wide, n * wide);
  }
}

void VtpFile::put_sequence(size_t array, int64_t begin, int64_t step)
{
  const Block &b = blocks[array];
  room.resize(PIECE * sizeof(double));
  for (int64_t done = 0; done < b.tuples; done += PIECE) {
    const int64_t n = std::min(PIECE, b.tuples - done);
    for (int64_t k = 0; k < n; k++) store(b.array.type, room.data(), k, (double) (begin + step * (done + k)));
    put_bytes(b, done, n);
  }
}

void VtpFile::end()
{
  LAMMPS_NS::platform::fseek(file, data + size);
  fputs("\n  </AppendedData>\n</VTKFile>\n", file);
  fflush(file);
}

}    // namespace SPHTM_NS
